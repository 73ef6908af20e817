"""Figure 11: which procedure calls which, as printed, and which function which in the kernel."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from importlib.resources import files
from itertools import combinations
from pkgutil import resolve_name
from types import CodeType, FrameType
from typing import TYPE_CHECKING, Any

from exactsweep.canvas import style
from exactsweep.canvas.style import Look
from exactsweep.corpus.generator import growing
from exactsweep.numbers.point import Vertex
from exactsweep.paper import literal
from exactsweep.paper.figures.figure import Facts, differ
from exactsweep.paper.figures.minkowski import DIRECTRIX, GENERATRIX
from exactsweep.paper.figures.sheet import PAGE, Extent, Sheet
from exactsweep.paper.pairs import SweepPair
from exactsweep.procedures import cc, cm, mm

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_DATA = json.loads(
    files("exactsweep.paper.figures").joinpath("procedures.json").read_text(encoding="utf-8")
)
PRINTED: list[tuple[str, str]] = [(one, other) for one, other in _DATA["printed"]]
"""The calls in the paper's text."""
PLACES: dict[str, Vertex] = {name: (x, y) for name, (x, y) in _DATA["places"].items()}
"""Middles of the boxes of the procedures, in points."""
KERNEL: dict[str, tuple[Callable[..., Any], Vertex]] = {
    name: (resolve_name(code), (x, y)) for name, (code, x, y) in _DATA["kernel"].items()
}
"""Functions of the kernel by their names, and the middles of their boxes."""
MADE: list[tuple[str, str]] = [(one, other) for one, other in _DATA["made"]]
"""The calls among these."""
PROCEDURE = Look(style.BLUE, 1.0, fill="#56b4e940", order=4)
HIGH = 16
ROOM = 6
"""The height of a box, and the least distance of two, in points."""


def list_facts() -> Facts:
    """List the figure's statements."""
    return [
        ("(a) procedures, calls", f"{len(PLACES)}, {len(PRINTED)}"),
        ("(b) functions, calls", f"{len(KERNEL)}, {len(MADE)}"),
    ]


def find_failures() -> Iterator[str]:
    """List the statements that fail."""
    called = {name for call in PRINTED for name in call}
    expected = set(PRINTED) - {("SweepI_CM", "Trajectory_CM")}
    yield differ("calls to the letter", watch_literal(), expected)
    yield differ("procedures that neither call nor are called", set(PLACES) - called, {"SweepI_CC"})
    yield differ("calls of the kernel", watch_kernel(), set(MADE))
    for title, places, calls in _graphs():
        yield from _drawn_wrong(title, places, calls)


def _graphs() -> tuple[tuple[str, Mapping[str, Vertex], Sequence[tuple[str, str]]], ...]:
    """Title, middles of boxes, and calls, of both parts."""
    ours = {name: place for name, (_, place) in KERNEL.items()}
    return ("(a) as printed", PLACES, PRINTED), ("(b) in the kernel", ours, MADE)


def _drawn_wrong(
    title: str, places: Mapping[str, Vertex], calls: Sequence[tuple[str, str]]
) -> Iterator[str]:
    """Say which boxes are nearer than an arrow needs, and which arrows do not run as the call."""
    rims = {name: _rim(name, place) for name, place in places.items()}
    for one, other in combinations(rims, 2):
        (left, low), (right, high) = rims[one][0], rims[one][2]
        (start, bottom), (end, top) = rims[other][0], rims[other][2]
        gap = max(start - right, left - end, bottom - high, low - top)
        yield "" if gap >= ROOM else f"{title}: {one} and {other} are {gap} points apart"
    for one, other in calls:
        (x, y), (tail_x, tail_y), (head_x, head_y) = places[one], *_draw_call(places, one, other)
        tail, head = ((a - x) ** 2 + (b - y) ** 2 for a, b in ((tail_x, tail_y), (head_x, head_y)))
        yield "" if tail < head else f"{title}: the arrow from {one} to {other} runs backwards"


def _draw_call(places: Mapping[str, Vertex], one: str, other: str) -> tuple[Vertex, Vertex]:
    """Tail and head of the arrow of a call."""
    start, end = places[one], places[other]
    return _leave(start, _rim(one, start), end), _leave(end, _rim(other, end), start)


def watch_calls(words: Mapping[CodeType, str], run: Callable[[], object]) -> set[tuple[str, str]]:
    """Record which of some functions runs inside which, others between them left out."""
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
    chains = SweepPair(GENERATRIX, DIRECTRIX).chains

    def run() -> None:
        literal.sweep_mm(*chains)
        literal.sweep_outer_cm(*chains)

    return {(one, other) for one, other in watch_calls(words, run) if one != other}


def watch_kernel() -> set[tuple[str, str]]:
    """The calls that the kernel makes, for a pair of each class."""
    words = {function.__code__: name for name, (function, _) in KERNEL.items()}
    convex, toothed = (
        SweepPair(*growing.cc(8, 8)).chains,
        SweepPair(*growing.cm_undercut(16, 8)).chains,
    )

    def run() -> None:
        mm.sweep_mm(*SweepPair(GENERATRIX, DIRECTRIX).chains)
        cm.sweep_inner_cm(toothed.top, toothed.directrix)
        cm.sweep_outer_cm(*toothed)
        cc.sweep_inner_cc(convex.top, convex.directrix)
        cc.sweep_outer_cc(*convex)

    return {(one, other) for one, other in watch_calls(words, run) if one != other}


def draw() -> Figure:
    """The picture."""
    boxes = [
        [Extent.around(*(_rim(*box) for box in places.items()), title=title)]
        for title, places, _ in _graphs()
    ]
    with Sheet(boxes, PAGE) as sheet:
        for panel, (_, places, calls) in zip(sheet.panels, _graphs(), strict=True):
            for call in calls:
                panel.arrow(*_draw_call(places, *call))
            for name, place in places.items():
                panel.area(_rim(name, place), PROCEDURE)
                panel.label(place, name, size=8)
    return sheet.figure


def _rim(name: str, place: Vertex) -> list[Vertex]:
    """The box of a name."""
    (x, y), wide, high = place, Fraction(52 * len(name) + 80, 20), Fraction(HIGH, 2)
    return [(x - wide, y - high), (x + wide, y - high), (x + wide, y + high), (x - wide, y + high)]


def _leave(middle: Vertex, rim: list[Vertex], towards: Vertex) -> Vertex:
    """Find where the line to another middle leaves a box."""
    (x, y), (dx, dy) = middle, (towards[0] - middle[0], towards[1] - middle[1])
    wide, high = rim[2][0] - x, rim[2][1] - y
    share = min(abs(Fraction(size) / step) for size, step in ((wide, dx), (high, dy)) if step)
    return x + share * dx, y + share * dy
