"""Lines of files of pairs with their records, in `golden.json`."""

import json
from pathlib import Path
from typing import Any

import pytest

from exactsweep.batch import Part, Rounding, take_all_pairs
from exactsweep.batch.work import Work
from exactsweep.formats import parse_region

FILE = Path(__file__).parent / "golden.json"
CASES: list[dict[str, Any]] = json.loads(FILE.read_text(encoding="utf-8"))
SHAPES = {
    "square": "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))",
    "notch": "POLYGON ((0 0, 8 0, 8 5, 7 5, 3 1, 2 5, 0 5, 0 0))",
    # Holes of 2 x 1, exactly as high as the square, and of 2 x 2.
    "plate": "POLYGON ((0 0, 9 0, 9 5, 0 5, 0 0), (1 1, 3 1, 3 2, 1 2, 1 1), "
    "(5 1, 7 1, 7 3, 5 3, 5 1))",
    # A square that slides along the walls of the undercut leaves its middle unswept.
    "cave": "POLYGON ((0 0, 10 0, 10 10, 5 10, 5 8, 8 8, 8 2, 2 2, 2 8, 3 8, 3 10, 0 10, 0 0))",
}
PARTS = [
    *(Part(name, parse_region(text)) for name, text in SHAPES.items()),
    Part("bad", "no polygon"),
]


def find_record(case: dict[str, Any]) -> str:
    """Return the record of an input line, or of the pair of PARTS with a given number."""
    rounding = Rounding(*case["rounding"]) if "rounding" in case else None
    work: Work = take_all_pairs(PARTS, PARTS, case["what"], rounding).work
    pair = case["pair"]
    return work.line(3, pair if isinstance(pair, int) else pair.encode()).decode()


@pytest.mark.parametrize("case", CASES, ids=range(len(CASES)))
def test_records_match_the_golden_file(case: dict[str, Any]) -> None:
    assert find_record(case) == case["record"]
