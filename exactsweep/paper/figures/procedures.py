"""Figure 11: which procedure calls which, as printed, and which of these calls are made here."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from types import CodeType, FrameType
from typing import TYPE_CHECKING

from exactsweep.canvas import style
from exactsweep.canvas.style import Look
from exactsweep.geometry.point import Vertex
from exactsweep.paper import literal
from exactsweep.paper.figures.figure import Facts, differ
from exactsweep.paper.figures.minkowski import DIRECTRIX, GENERATRIX
from exactsweep.paper.figures.sheet import PAGE, Box, Sheet
from exactsweep.paper.pairs import Pair

if TYPE_CHECKING:
    from matplotlib.figure import Figure

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
"""The calls in the paper's text; a test holds them against those that the package makes."""
SHARED = {
    ("Trajectory_CM", "Trajectory_CC"),
    ("SweepO_CM", "SweepO_CC"),
    ("Trajectory_MM", "Trajectory_CM"),
}
"""Of these the calls that the kernel does not make: both procedures use the same function there."""
# Middles of the boxes, in points.
PLACES = {
    "Sweep_MM": (70, 120),
    "Trajectory_MM": (70, 80),
    "LowerEnvelope_MM": (70, 0),
    "SweepI_CM": (190, 120),
    "Trajectory_CM": (190, 80),
    "LowerEnvelope_CM": (270, 40),
    "SweepO_CM": (350, 80),
    "Trajectory_CC": (190, 0),
    "SweepI_CC": (270, 0),
    "SweepO_CC": (350, 0),
}
PROCEDURE = Look(style.BLUE, 1.0, fill="#56b4e940", order=4)
OTHERWISE = Look(style.PURPLE, dash=(0, (4, 2)))
HIGH = 16


def list_facts() -> Facts:
    """What the figure states."""
    otherwise = ", ".join(f"{one} to {other}" for one, other in sorted(SHARED))
    return [
        ("procedures", str(len(PLACES))),
        ("calls of the paper", str(len(PRINTED))),
        ("calls that the kernel makes otherwise", otherwise),
    ]


def find_failures() -> Iterator[str]:
    """What is not borne out."""
    called = {name for call in PRINTED for name in call}
    expected = set(PRINTED) - {("SweepI_CM", "Trajectory_CM")}
    yield differ("calls to the letter", watch_literal(), expected)
    yield differ("procedures that neither call nor are called", set(PLACES) - called, {"SweepI_CC"})
    yield differ("calls that are made otherwise, and not printed", SHARED - set(PRINTED), set())


def watch_calls(words: Mapping[CodeType, str], run: Callable[[], object]) -> set[tuple[str, str]]:
    """Which of some functions runs inside which, others between them left out."""
    inside: list[str] = []
    found: set[tuple[str, str]] = set()

    def watch(frame: FrameType, event: str, argument: object) -> None:
        name = words.get(frame.f_code)
        if name and event == "call":
            found.update((outer, name) for outer in inside[-1:])
            inside.append(name)
        elif name and event == "return":
            inside.pop()

    before = sys.getprofile()
    sys.setprofile(watch)
    try:
        run()
    finally:
        sys.setprofile(before)
    return found


def watch_literal() -> set[tuple[str, str]]:
    """The calls that the procedures to the letter make, for a pair of which all are needed."""
    words = {
        literal.trajectory_cc.__code__: "Trajectory_CC",
        literal.sweep_outer_cc.__code__: "SweepO_CC",
        literal.trajectory_cm.__code__: "Trajectory_CM",
        literal.sweep_outer_cm.__code__: "SweepO_CM",
        literal.lower_envelope_cm.__code__: "LowerEnvelope_CM",
        literal.trajectory_mm.__code__: "Trajectory_MM",
        literal.lower_envelope_mm.__code__: "LowerEnvelope_MM",
        literal.sweep_mm.__code__: "Sweep_MM",
    }
    chains = Pair(GENERATRIX, DIRECTRIX).chains

    def run() -> None:
        literal.sweep_mm(*chains)
        literal.sweep_outer_cm(*chains)

    return {(one, other) for one, other in watch_calls(words, run) if one != other}


def draw() -> Figure:
    """The picture."""
    rims = {name: _rim(name) for name in PLACES}
    with Sheet([[Box.around(*rims.values())]], PAGE) as sheet:
        (panel,) = sheet.panels
        for one, other in PRINTED:
            start = _leave(PLACES[one], rims[one], PLACES[other])
            end = _leave(PLACES[other], rims[other], PLACES[one])
            look = OTHERWISE if (one, other) in SHARED else style.TRAJECTORY
            panel.arrow(start, end, look)
        for name, rim in rims.items():
            panel.area(rim, PROCEDURE)
            panel.label(PLACES[name], name, size=8)
    return sheet.figure


def _rim(name: str) -> list[Vertex]:
    """The box of a name."""
    (x, y), wide, high = PLACES[name], Fraction(52 * len(name) + 80, 20), Fraction(HIGH, 2)
    return [(x - wide, y - high), (x + wide, y - high), (x + wide, y + high), (x - wide, y + high)]


def _leave(middle: Vertex, rim: list[Vertex], towards: Vertex) -> Vertex:
    """Where the line to another middle leaves a box."""
    (x, y), (dx, dy) = middle, (towards[0] - middle[0], towards[1] - middle[1])
    wide, high = rim[2][0] - x, rim[2][1] - y
    share = min(abs(Fraction(size) / step) for size, step in ((wide, dx), (high, dy)) if step)
    return x + share * dx, y + share * dy
