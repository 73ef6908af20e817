"""Figure 11: calls between the printed procedures, and between functions of the kernel."""

import json
import sys
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import partial
from importlib.resources import files
from pkgutil import resolve_name
from types import CodeType, FrameType
from typing import Any

from exactsweep.corpus.generator import growing
from exactsweep.numbers.number import Vertex
from exactsweep.paper.costs import RUNS
from exactsweep.paper.figures.figure import PaperFigure, join_panels
from exactsweep.paper.figures.minkowski import DIRECTRIX, GENERATRIX
from exactsweep.paper.pairs import SweepPair

_DATA = json.loads(
    files("exactsweep.paper.figures").joinpath("procedures.json").read_text(encoding="utf-8")
)
# Pairs of a caller and a procedure in the paper's text, and the centers of the boxes, in points.
PRINTED: list[tuple[str, str]] = [(one, other) for one, other in _DATA["printed"]]
PLACES: dict[str, Vertex] = {name: (x, y) for name, (x, y) in _DATA["places"].items()}
# The functions of the kernel with the centers of their boxes, and the calls between them.
KERNEL: dict[str, tuple[Callable[..., Any], Vertex]] = {
    name: (resolve_name(code), (x, y)) for name, (code, x, y) in _DATA["kernel"].items()
}
MADE: list[tuple[str, str]] = [(one, other) for one, other in _DATA["made"]]
HIGH = 16


def _draw_call(places: Mapping[str, Vertex], one: str, other: str) -> tuple[Vertex, Vertex]:
    start, end = places[one], places[other]
    return _find_exit(start, _box(one, start), end), _find_exit(end, _box(other, end), start)


def watch_calls(words: Mapping[CodeType, str], *runs: Callable[[], object]) -> set[tuple[str, str]]:
    """Record the calls between the named functions, skipping other functions in between."""
    inside: list[str] = []
    found: set[tuple[str, str]] = set()

    def watch(frame: FrameType, event: str, argument: object) -> None:
        name = words.get(frame.f_code)
        if name and event == "call":
            found.update((outer, name) for outer in inside[-1:] if outer != name)
            inside.append(name)
        elif name and event == "return":
            inside.pop()

    before = sys.getprofile()
    sys.setprofile(watch)
    try:
        for run in runs:
            run()
    finally:
        sys.setprofile(before)
    return found


def watch_kernel() -> set[tuple[str, str]]:
    words = {function.__code__: name for name, (function, _) in KERNEL.items()}
    example = SweepPair(GENERATRIX, DIRECTRIX)
    convex, toothed = SweepPair(*growing.cc(8, 8)), SweepPair(*growing.cm_undercut(16, 8))
    runs = {"Sweep_MM, outer loop": example, "SweepI_CM": toothed, "SweepO_CM": toothed}
    runs |= {"Trajectory_CC": convex, "SweepI_CC": convex, "SweepO_CC": convex}
    return watch_calls(words, *(partial(RUNS[name], pair.chains) for name, pair in runs.items()))


def _show(
    letter: str, thing: str, places: Mapping[str, Vertex], calls: Sequence[tuple[str, str]]
) -> PaperFigure:
    return PaperFigure(
        facts=[(f"({letter}) {thing}, calls", f"{len(places)}, {len(calls)}")],
        shapes={"calls": [_draw_call(places, *call) for call in calls]}
        | {"boxes": [_box(*box) for box in places.items()], "middles": list(places.values())},
        words={"names": list(places)},
    )


def compute() -> PaperFigure:
    called = {name for call in PRINTED for name in call}
    whole = PaperFigure(
        laws=[
            ("procedures that neither call nor are called", {*PLACES} - called, {"SweepI_CC"}),
            ("calls of the kernel", watch_kernel(), set(MADE)),
        ]
    )
    ours = {name: place for name, (_, place) in KERNEL.items()}
    panels = {
        "a": _show("a", "procedures", PLACES, PRINTED),
        "b": _show("b", "functions", ours, MADE),
    }
    return join_panels({"": whole} | panels)


def _box(name: str, place: Vertex) -> list[Vertex]:
    (x, y), wide, high = place, Fraction(52 * len(name) + 80, 20), Fraction(HIGH, 2)
    return [(x - wide, y - high), (x + wide, y - high), (x + wide, y + high), (x - wide, y + high)]


def _find_exit(middle: Vertex, rim: list[Vertex], towards: Vertex) -> Vertex:
    """Return the point where the line from the center of a box to another point leaves the box."""
    (x, y), (dx, dy) = middle, (towards[0] - middle[0], towards[1] - middle[1])
    wide, high = rim[2][0] - x, rim[2][1] - y
    share = min(abs(Fraction(size) / step) for size, step in ((wide, dx), (high, dy)) if step)
    return x + share * dx, y + share * dy
