"""The checker proved in Coq, extracted to OCaml.

The build needs coqc, ocamlfind and zarith; `check/proof/README.md` lists the trusted parts.
"""

from __future__ import annotations

import shutil
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

import exactsweep.check
from exactsweep.check.standalone import Refused
from exactsweep.theorem.claims import to_claim, write_numbers

PROOF = Path(exactsweep.check.__file__).parent / "proof"
TOOLS = ("coqc", "coq_makefile", "make", "ocamlfind")


def missing_tools() -> list[str]:
    """Return the names of missing programs that the build needs."""
    return [tool for tool in TOOLS if shutil.which(tool) is None]


@cache
def build_checker(proof: Path = PROOF) -> Path:
    """Build the checker, if it is missing or older than the proofs, and return its path.

    Raises RuntimeError if a tool is missing or the build fails. Cost: one or two minutes for the
    first build.
    """
    if missing := missing_tools():
        raise RuntimeError(f"not installed: {', '.join(missing)}")
    command = ["make", "--silent", "checker"]
    done = subprocess.run(command, cwd=proof, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"the checker could not be built: {done.stderr.strip()[-500:]}")
    return proof / "extracted" / "checker"


def ask(certificate: Any, seconds: float = 600) -> str:
    """Run the extracted checker on a certificate; build it if necessary.

    Returns "accepted", "rejected", "out of time", or "malformed", which includes claims without a
    theorem. Raises RuntimeError if the checker cannot be built or fails.
    """
    try:
        line = write_numbers(to_claim(certificate))
    except (ArithmeticError, AttributeError, LookupError, Refused, TypeError, ValueError):
        return "malformed"
    command = [build_checker()]
    try:
        done = subprocess.run(
            command, input=f"{line}\n", capture_output=True, text=True, timeout=seconds, check=False
        )
    except subprocess.TimeoutExpired:
        return "out of time"
    answer = done.stdout.strip()
    if done.returncode or answer not in ("accepted", "rejected", "unreadable"):
        raise RuntimeError(f"the extracted checker failed: {done.stderr.strip()[-500:]}")
    return "malformed" if answer == "unreadable" else answer
