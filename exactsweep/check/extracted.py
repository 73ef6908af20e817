"""The checker proved in Coq, extracted to OCaml.

The build needs coqc, ocamlfind and zarith; `proof/README.md` lists the trusted parts.
"""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from exactsweep.check.claims import to_claim
from exactsweep.check.terms import write_numbers

PROOF = Path(__file__).parent / "proof"
TOOLS = ("coqc", "coq_makefile", "make", "ocamlfind")


def missing_tools() -> list[str]:
    """Return the names of missing programs that the build needs."""
    return [tool for tool in TOOLS if shutil.which(tool) is None]


def build_checker(proof: Path = PROOF) -> Path:
    """Build the checker if it is missing or older than the proofs; return its path.

    Raises RuntimeError if a tool is missing or the build fails. Cost: two to five minutes for the
    first build.
    """
    found = proof / "extracted" / "checker"
    sources = [*proof.glob("*.v"), *proof.glob("driver.ml")]
    newest = max((path.stat().st_mtime for path in sources), default=0.0)
    if not found.exists() or found.stat().st_mtime < newest:
        if missing := missing_tools():
            raise RuntimeError(f"not installed: {', '.join(missing)}")
        command = ["make", "--silent", "checker"]
        done = subprocess.run(command, cwd=proof, capture_output=True, text=True, check=False)
        if done.returncode:
            raise RuntimeError(f"the checker could not be built: {done.stderr.strip()[-500:]}")
    return found


def ask(certificate: Any, checker: Path | None = None, seconds: float = 600) -> str:
    """Run the extracted checker on a certificate; by default, build the checker if necessary.

    Returns "accepted", "rejected", "out of time", or "malformed", also for claims without a
    theorem. Raises RuntimeError if the checker cannot be built or fails.
    """
    try:
        line = write_numbers(to_claim(certificate))
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError):
        return "malformed"
    try:
        done = subprocess.run(
            [checker or build_checker()],
            input=f"{line}\n",
            capture_output=True,
            text=True,
            timeout=seconds,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return "out of time"
    answer = done.stdout.strip()
    if done.returncode or answer not in ("accepted", "rejected", "unreadable"):
        raise RuntimeError(f"the extracted checker failed: {done.stderr.strip()[-500:]}")
    return "malformed" if answer == "unreadable" else answer


def accept(certificates: Iterable[Any], checker: Path | None = None) -> list[bool]:
    """Return for each certificate whether the extracted checker accepts it; see `ask`."""
    return [ask(certificate, checker) == "accepted" for certificate in certificates]
