"""The checker in Coq, extracted to OCaml, on certificates.

Needs coqc, ocamlfind and zarith, once, to build it; `proof/README.md` lists what has to be trusted.
"""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from exactsweep.check.terms import to_claim, write_numbers

PROOF = Path(__file__).parent / "proof"
TOOLS = ("coqc", "coq_makefile", "make", "ocamlfind")


def missing_tools() -> list[str]:
    """Return the programs that are needed to build the checker and not installed."""
    return [tool for tool in TOOLS if shutil.which(tool) is None]


def build_checker(proof: Path = PROOF) -> Path:
    """Check the proofs, extract the checker and compile it, unless that is done; return its path.

    Args:
        proof: the folder of the proofs.

    Raises:
        RuntimeError: a tool is missing, or the build fails.

    Cost: two to five minutes the first time.
    """
    found = proof / "extracted" / "checker"
    if not found.exists():
        if missing := missing_tools():
            raise RuntimeError(f"not installed: {', '.join(missing)}")
        command = ["make", "--silent", "checker"]
        done = subprocess.run(command, cwd=proof, capture_output=True, text=True, check=False)
        if done.returncode:
            raise RuntimeError(f"the checker could not be built: {done.stderr.strip()[-500:]}")
    return found


def accept(certificates: Iterable[Any], checker: Path | None = None) -> list[bool]:
    """Return whether the extracted checker accepts each of some certificates.

    Args:
        certificates: certificates of version 3. Malformed ones and layouts with faults are not
            accepted.
        checker: the program; by default it is built if necessary.
    """
    lines = [_line(certificate) for certificate in certificates]
    done = subprocess.run(
        [checker or build_checker()],
        input="".join(f"{line}\n" for line in lines),
        capture_output=True,
        text=True,
        check=True,
    )
    answers = done.stdout.split()
    if len(answers) != len(lines):
        raise RuntimeError(f"{len(lines)} certificates, {len(answers)} answers")
    return [answer == "accepted" for answer in answers]


def _line(certificate: Any) -> str:
    try:
        return write_numbers(to_claim(certificate))
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError):
        return "malformed"
