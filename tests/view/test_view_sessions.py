"""The texts of the page in a browser after keys, slides and choices; see sessions.txt."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest
from command import EXAMPLE
from shown import Open, Shown

from exactsweep import Point, Region, sweep

FILE = Path(__file__).with_name("sessions.txt")
PARTS = 1_000_000
SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]
SLOT = [(0, 0), (3, 0), (3, 5), (2, 5), (2, 1), (1, 1), (1, 3), (0, 3)]
WEDGE = [(0, 0), (3, 0), (5, 4), (6, 4), (6, -1), (-3, -1), (-3, 4), (-2, 4)]
# Holes in which the square moves freely, slides, and fits exactly.
PLATE = Region(
    [(0, 0), (20, 0), (20, 12), (0, 12)],
    [
        [(2, 2), (7, 2), (7, 6), (2, 6)],
        [(9, 2), (11, 2), (11, 10), (9, 10)],
        [(13, 3), (15, 3), (15, 5), (13, 5)],
    ],
)
# A peak in the notch of the example, which G just touches.
BLOCK = list(EXAMPLE.directrix.vertices)
NOTCH = BLOCK.index(Point(Fraction(3), Fraction(1)))
SWEEPS = {
    "example": EXAMPLE,
    "slot": sweep([(0, 0), (1, 0), (1, 1), (0, 1)], SLOT),
    "wedge": sweep([(0, 0), (3, 0), (3, 1), (0, 1)], WEDGE),
    "several": sweep(
        EXAMPLE.generatrix, [*BLOCK[:NOTCH], (4, 2), ("18/5", "13/5"), *BLOCK[NOTCH:]]
    ),
    "plate": sweep(SQUARE, PLATE),
    "square": sweep(SQUARE, SQUARE),
}


def follow(shown: Shown, step: str) -> str:
    """Follow the instruction in a line, and describe the page afterwards."""
    word, *arguments = step.split()
    if word == "press":
        shown.press(*arguments)
    elif word == "slide":
        shown.slide(int(float(arguments[0]) * PARTS))
    else:
        shown.tab.select_option("#track", *arguments)
        shown.settle()
    elements = ("position", "where", "contacts", "pointed")
    return "\n    ".join((step, *("; ".join(shown.text(name).splitlines()) for name in elements)))


def replay(session: str, show: Open) -> str:
    shown, lines = None, []
    for line in session.splitlines():
        if line.startswith("# "):
            shown = show(SWEEPS[line[2:]])
            lines.append(line)
        elif shown and not line.startswith("    "):
            lines.append(follow(shown, line))
    return "".join(f"{line}\n" for line in lines)


@pytest.mark.long
def test_sessions_of_the_page_are_golden(show: Open) -> None:
    session = FILE.read_text(encoding="utf-8")
    assert replay(session, show) == session
