"""Programs to be judged by tests, and cases for them."""

import json
import sys
from collections.abc import Iterable
from pathlib import Path

from command import ROOT

from exactsweep.corpus import Case, case_to_json

EXAMPLES = ROOT / "exactsweep" / "conform" / "examples"
IMPLEMENTATIONS = Path(__file__).parent / "implementations"
CONVEX = [sys.executable, str(EXAMPLES / "convex.py")]
CORRECT = [sys.executable, str(IMPLEMENTATIONS / "correct.py")]
FAULTY = [sys.executable, str(IMPLEMENTATIONS / "faulty.py")]
HOSTILE = [sys.executable, str(IMPLEMENTATIONS / "hostile.py")]
WATCHED = [sys.executable, str(IMPLEMENTATIONS / "watched.py")]

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
SLOT = [(0, 0), (3, 0), (3, 5), (2, 5), (2, 1), (1, 1), (1, 3), (0, 3)]
TWO = [Case.of("mine-slot", "", SLOT, SQUARE), Case.of("mine-square", "", SQUARE, SQUARE, (1, 0))]


def write_cases(path: Path, cases: Iterable[Case]) -> str:
    """Write cases as JSON lines; return the path."""
    path.write_text("".join(f"{json.dumps(case_to_json(case))}\n" for case in cases))
    return str(path)
