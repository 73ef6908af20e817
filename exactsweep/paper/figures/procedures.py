"""Figure 11: which procedure uses which, read from the source."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING

from exactsweep.canvas import style
from exactsweep.canvas.style import Look
from exactsweep.geometry.point import Vertex
from exactsweep.paper.figures.calls import between, reached, uses
from exactsweep.paper.figures.figure import Facts, PaperFigure, differ
from exactsweep.paper.figures.sheet import PAGE, Box, Sheet

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MODULES = (
    "chain",
    "cc",
    "convex_part",
    "cm",
    "envelope",
    "lower_envelope",
    "part_pairs",
    "mm_inner",
    "mm",
)
PROCEDURES = {
    "Trajectory_CC": "trajectory_cc",
    "SweepI_CC": "sweep_inner_cc",
    "SweepO_CC": "sweep_outer_cc",
    "Trajectory_CM": "trajectory_cm",
    "SweepI_CM": "sweep_inner_cm",
    "SweepO_CM": "sweep_outer_cm",
    "LowerEnvelope_CM": "lower_envelope_cm",
    "Trajectory_MM": "trajectory_mm",
    "Sweep_MM": "sweep_mm",
    "LowerEnvelope_MM": "lower_envelope_mm",
}
CORE = "merge_by_slope"
"""What the procedures of the CC sweep have in common."""
PRINTED = (
    ("Trajectory_CM", "Trajectory_CC"),
    ("Trajectory_CM", "LowerEnvelope_CM"),
    ("SweepI_CM", "Trajectory_CM"),
    ("SweepO_CM", "SweepO_CC"),
    ("SweepO_CM", "LowerEnvelope_CM"),
    ("Trajectory_MM", "Trajectory_CM"),
    ("Trajectory_MM", "LowerEnvelope_MM"),
    ("Sweep_MM", "Trajectory_MM"),
)
"""Which procedure calls which in the paper's text."""
# Middles of the boxes, in points.
PLACES = {
    "sweep_mm": (100, 210),
    "inner_mm": (32, 175),
    "outer_mm": (180, 175),
    "trajectory_mm": (100, 140),
    "sweep_pairs": (62, 95),
    "lower_envelope_mm": (62, 35),
    "lower_envelope_cm": (176, 95),
    "sweep": (190, 35),
    "sweep_inner_cm": (290, 140),
    "trajectory_cm": (290, 105),
    "sweep_parts": (326, 68),
    "sweep_outer_cm": (430, 105),
    "trajectory_cc": (270, 32),
    "sweep_outer_cc": (430, 32),
    "merge_by_slope": (270, -5),
    "sweep_inner_cc": (430, -5),
}
PROCEDURE = Look(style.BLUE, 1.0, fill="#56b4e940", order=4)
HELPER = Look(style.GREY, 0.8, fill="#ffffff", order=4)
PRINTED_ONLY = Look(style.PURPLE, dash=(0, (4, 2)))
HIGH = 16


@cache
def graph() -> dict[str, frozenset[str]]:
    """The uses among the procedures, what the CC ones share, and what lies between."""
    return between(uses(MODULES), {*PROCEDURES.values(), CORE})


def missing() -> list[tuple[str, str]]:
    """The calls of the paper that have no path here, as names of the paper."""
    found = graph()
    return [
        (one, other)
        for one, other in PRINTED
        if PROCEDURES[other] not in reached(found, PROCEDURES[one])
    ]


def _facts() -> Facts:
    found = graph()
    helpers = sorted(set(found) - set(PROCEDURES.values()))
    return [
        ("procedures", str(len(PROCEDURES))),
        ("other functions between them", ", ".join(helpers)),
        ("arrows", str(sum(map(len, found.values())))),
        ("calls of the paper that are here", f"{len(PRINTED) - len(missing())} of {len(PRINTED)}"),
        ("the others", ", ".join(f"{one} to {other}" for one, other in missing())),
    ]


def _failures() -> Iterator[str]:
    found = graph()
    yield differ("functions", sorted(found), sorted(PLACES))
    for one, other in missing():
        both = reached(found, PROCEDURES[one]) & reached(found, PROCEDURES[other])
        yield "" if CORE in both else f"{one} and {other} have nothing in common"


def _draw() -> Figure:
    found = graph()
    words = {code: name for name, code in PROCEDURES.items()}
    rims = {name: _rim(name, words.get(name, name)) for name in found}
    with Sheet([[Box.around(*rims.values())]], PAGE) as sheet:
        (panel,) = sheet.panels
        for one, others in sorted(found.items()):
            for other in sorted(others):
                panel.arrow(*_ends(rims, one, other))
        for one, other in missing():
            panel.arrow(*_ends(rims, PROCEDURES[one], PROCEDURES[other]), PRINTED_ONLY)
        for name, rim in sorted(rims.items()):
            panel.area(rim, PROCEDURE if name in words else HELPER)
            panel.label(PLACES[name], words.get(name, name), size=8)
    return sheet.figure


def _rim(name: str, words: str) -> list[Vertex]:
    """The box of a name."""
    (x, y), wide = PLACES[name], Fraction(52 * len(words) + 80, 20)
    high = Fraction(HIGH, 2)
    return [(x - wide, y - high), (x + wide, y - high), (x + wide, y + high), (x - wide, y + high)]


def _ends(rims: dict[str, list[Vertex]], one: str, other: str) -> tuple[Vertex, Vertex]:
    """Where the line of two middles leaves one box and enters the other."""
    return _leaving(PLACES[one], rims[one], PLACES[other]), _leaving(
        PLACES[other], rims[other], PLACES[one]
    )


def _leaving(middle: Vertex, rim: list[Vertex], towards: Vertex) -> Vertex:
    (x, y), (dx, dy) = middle, (towards[0] - middle[0], towards[1] - middle[1])
    wide, high = rim[2][0] - x, rim[2][1] - y
    share = min(abs(Fraction(size) / step) for size, step in ((wide, dx), (high, dy)) if step)
    return x + share * dx, y + share * dy


FIGURE = PaperFigure(
    11,
    "Conclusion",
    "Which procedure uses which, as the source of this package has it; an arrow leads from a "
    "function to one that it uses. Filled boxes are the paper's procedures, the others what "
    "lies between them here. Dashed are the calls of the paper that this package does not make: "
    "the two procedures use the same functions instead.",
    ("exactsweep.paper.figures.calls.uses",),
    _facts,
    _failures,
    "Read from the syntax tree of the modules; where a call of the paper is not made, both "
    "procedures end in the same merge by slope.",
    _draw,
)
