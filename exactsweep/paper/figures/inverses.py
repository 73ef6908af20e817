"""Figure 8: the inverse generatrix retraces both loops from the two sides of the trajectory."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from exactsweep.canvas import style
from exactsweep.canvas.style import Look
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.point import Point, Rational, Vertex
from exactsweep.paper.figures.figure import Facts, differ, loops_differ
from exactsweep.paper.figures.minkowski import invert_generatrix, sweep_example
from exactsweep.paper.figures.sheet import (
    INNER,
    OUTER,
    PAGE,
    SMALL,
    SMALL_DOT,
    TRAJECTORY,
    Extent,
    Margins,
    Sheet,
    shift,
)
from exactsweep.paper.functions import evaluate
from exactsweep.procedures.chain import complement, split
from exactsweep.sweep import no_fit_polygon

if TYPE_CHECKING:
    from matplotlib.figure import Figure

INVERSE = Look(style.PURPLE, 1.0, fill="#cc79a740", order=4)


def place_inverse(place: Vertex) -> list[Vertex]:
    """I(G), its reference point at a place."""
    return shift(invert_generatrix(sweep_example()).vertices, place)


def _inside() -> list[Point]:
    """Choose where I(G) is drawn inside the trajectory: vertices of the inner loop."""
    corners = sweep_example().inner.vertices
    return [corners[0], corners[2], corners[4], corners[7]]


def _outside() -> list[Point]:
    """Choose where it is drawn outside: vertices of the outer loop."""
    corners = sweep_example().outer.vertices
    return [corners[0], corners[4], corners[12], corners[20]]


def list_facts() -> Facts:
    """List the figure's statements."""
    s = sweep_example()
    return [
        ("edges of the trajectory", str(len(s.trajectory))),
        ("edges of the inner loop, retraced inside", str(len(s.inner))),
        ("edges of the outer loop, retraced outside", str(len(s.outer))),
    ]


def find_failures() -> Iterator[str]:
    """List the statements that fail."""
    s = sweep_example()
    yield from loops_differ(s)
    outside = no_fit_polygon(s.trajectory, invert_generatrix(s)).exterior
    yield differ("the loop outside is the outer one", outside == s.outer, True)
    for place in s.inner.vertices:
        yield _sticks_out(place_inverse(place), s.trajectory)


def _sticks_out(ring: Sequence[Vertex], around: Polygon) -> str:
    """Say that a polygon is not inside another one, or does not touch it; both are X-monotone."""
    chains = [split(ring), split(around.vertices)]
    (low, high), (floor, ceiling) = [(bottom, complement(top)) for bottom, top in chains]
    xs = {x for chain in (low, high, floor, ceiling) for x, _ in chain if not _beside(x, low)}
    if any(_beside(x, floor) for x in xs):
        return f"I(G) at {ring[0]} sticks out sideways"
    gaps = [evaluate(low, x) - evaluate(floor, x) for x in map(Fraction, xs)]
    gaps += [evaluate(ceiling, x) - evaluate(high, x) for x in map(Fraction, xs)]
    return differ(f"least gap above and below I(G) at {ring[0]}", min(gaps), 0)


def _beside(x: Rational, chain: Sequence[Vertex]) -> bool:
    return not chain[0][0] <= x <= chain[-1][0]


def draw() -> Figure:
    """The picture."""
    s = sweep_example()
    boxes = [
        Extent.around(
            s.outer.vertices,
            *map(place_inverse, _outside()),
            title=title,
            margins=Margins(4, 6, 4, 12),
        )
        for title in ("(a) inside", "(b) outside")
    ]
    with Sheet([boxes], PAGE) as sheet:
        left, right = sheet.panels
        for panel, places, dx, dy in ((left, _inside(), -14, 26), (right, _outside(), 46, -16)):
            panel.line(s.trajectory.vertices, TRAJECTORY, closed=True)
            for place in places:
                panel.area(place_inverse(place), INVERSE)
                panel.label(place, "$I(G)$", 0, -10, size=SMALL)
            panel.dots(places, SMALL_DOT)
            panel.label((1, 10), "trajectory", dx, dy, leader=True)
        left.line(s.inner.vertices, INNER, closed=True)
        left.label((Fraction(11, 2), 10), "inner loop", 4, -28, leader=True)
        right.line(s.outer.vertices, OUTER, closed=True)
        right.label((19, 13), "outer loop", 16, 12, leader=True)
    return sheet.figure
