"""Figure 9: how far the two loops are apart along an edge of the trajectory."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from math import isqrt
from typing import TYPE_CHECKING, NamedTuple

from exactsweep.canvas import style
from exactsweep.check import point_in_polygon
from exactsweep.numbers.number import format_fraction
from exactsweep.numbers.point import Point, Vertex
from exactsweep.paper.checks.section5 import NARROW
from exactsweep.paper.figures.figure import Facts, differ, loops_differ
from exactsweep.paper.figures.inverses import INVERSE
from exactsweep.paper.figures.minkowski import invert_generatrix, sweep_example
from exactsweep.paper.figures.sheet import (
    INNER,
    OUTER,
    PAGE,
    TRAJECTORY,
    BarePicture,
    Extent,
    Sheet,
    find_middle,
    shift,
)
from exactsweep.paper.functions import evaluate, take_bottom
from exactsweep.sweep import Sweep, sweep

if TYPE_CHECKING:
    from matplotlib.figure import Figure

THIRD = Fraction(1, 3)


class Widths(NamedTuple):
    """The edge e of the trajectory, a point of it, and the distances of Figure 9.

    Attributes:
        sweep: whose trajectory it is.
        edge: the ends of e.
        at: where I(G) touches e from both sides.
        inside: I(g) when I(G) is on the inner side of e.
        outside: I(g) on the outer side.
        inner, outer: their distances from e, d' and d''.
        width: of G, orthogonally to e.
    """

    sweep: Sweep
    edge: tuple[Point, Point]
    at: Vertex
    inside: Vertex
    outside: Vertex
    inner: Fraction
    outer: Fraction
    width: Fraction


def measure(s: Sweep, p: Point, q: Point) -> Widths | None:
    """Measure at the middle of an edge; None if no vertex of I(G) is there from both sides."""
    dx, dy = _direction((p, q))
    at = find_middle(p, q)
    found: list[tuple[Vertex, Fraction]] = []
    for loop in (s.inner, s.outer):
        for w in invert_generatrix(s).vertices:
            place = at[0] - w.x, at[1] - w.y
            if point_in_polygon(place, loop) == 0:
                found.append((place, dx * w.y - dy * w.x))
                break
        else:
            return None
    own = [dx * w.y - dy * w.x for w in s.generatrix.vertices]
    (inside, below), (outside, above) = found
    return Widths(s, (p, q), at, inside, outside, -below, above, max(own) - min(own))


def _measure_all(s: Sweep) -> list[Widths]:
    """At all edges of the lower half that have a rational length."""
    edges = [(p, q) for p, q in pairwise(s.trajectory.vertices) if p.x < q.x and _length(p, q)]
    return [found for p, q in edges if (found := measure(s, p, q))]


def measure_widths() -> Widths:
    """At the longest such edge of Figure 1's pair."""
    return max(_measure_all(sweep_example()), key=lambda found: _length(*found.edge) or 0)


def narrow_widths() -> Widths:
    """At an edge of a pair that refutes the statement, a third as large."""
    g, d = ([(Fraction(x, 3), Fraction(y, 3)) for x, y in ring] for ring in NARROW)
    return next(one for one in _measure_all(sweep(g, d)) if one.inner + one.outer < one.width)


def _length(p: Point, q: Point) -> Fraction | None:
    """The distance of two points if it is rational."""
    square = (q.x - p.x) ** 2 + (q.y - p.y) ** 2
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return root if root**2 == square else None


def list_facts() -> Facts:
    """List the figure's statements."""
    return [
        (f"({letter}) {name}", str(value))
        for letter, found in (("a", measure_widths()), ("b", narrow_widths()))
        for name, value in (("d'", found.inner), ("d''", found.outer), ("d", found.width))
    ]


def find_failures() -> Iterator[str]:
    """List the statements that fail."""
    yield differ(
        "(a) d' + d''", measure_widths().inner + measure_widths().outer, measure_widths().width
    )
    near = narrow_widths()
    yield differ("(b) d' + d'', d", (near.inner + near.outer, near.width), (11 * THIRD, 16 * THIRD))
    for found in (measure_widths(), near):
        s, (p, q) = found.sweep, found.edge
        yield from loops_differ(s)
        for loop, point in ((s.inner, found.inside), (s.outer, found.outside)):
            chain = take_bottom(loop.vertices)
            for by in (Fraction(-1, 9), Fraction(0), Fraction(1, 9)):
                x = point[0] + by * (q.x - p.x)
                yield differ(f"height over {x}", evaluate(chain, x), point[1] + by * (q.y - p.y))


def draw() -> Figure:
    """The picture."""
    first, second = measure_widths(), narrow_widths()
    boxes = []
    for found, beside, title in ((first, (4, 5), "(a)"), (second, (7, Fraction(5, 2)), "(b)")):
        x, y = found.at
        half = Fraction(1, 2)
        corners = [(x - beside[0], y - 4 - half), (x + beside[1], y + 3 + half)]
        box = Extent.around(*_place(found), corners, title=title)
        boxes.append(box._replace(is_cut=True))
    with Sheet([boxes], PAGE) as sheet:
        left, right = sheet.panels
        for panel, found in ((left, first), (right, second)):
            _draw_widths(panel, found)
        _name_parts(left, first, ((Fraction(-7, 2), 1), (2, -2), (Fraction(7, 2), 8), (-1, 3)))
        _name_parts(right, second, ((-1, 3), (-2, -3), (Fraction(-2, 3), -7), (-4, Fraction(3, 2))))
        foot = _along(first, Fraction(-14, 5))
        ends = _across(first, foot, first.inner), _across(first, foot, -first.outer)
        left.arrow(*ends, both=True)
        left.label(
            find_middle(*ends, share=Fraction(3, 4)), _equal("d", first.width), 5, 2, ha="left"
        )
        high, side = max(y for _, y in _place(second)[1]), second.at[0] - 4
        low = high - second.width
        right.arrow((side, high), (side, low), both=True)
        right.label((side, (high + 2 * low) / 3), _equal("d", second.width), -4, 0, ha="right")
    return sheet.figure


def _place(found: Widths) -> tuple[list[Vertex], list[Vertex]]:
    """I(G) inside and outside."""
    turned = invert_generatrix(found.sweep).vertices
    return shift(turned, found.inside), shift(turned, found.outside)


def _equal(letters: str, value: Fraction) -> str:
    return f"${letters} = {format_fraction(value)}$"


def _draw_widths(panel: BarePicture, found: Widths) -> None:
    """The swept area, I(G) on both sides of e, and their distances from it."""
    s = found.sweep
    panel.ring(s.outer.vertices, s.inner.vertices, style.SWEPT)
    panel.area(s.directrix.vertices, style.DIRECTRIX)
    panel.line(s.inner.vertices, INNER, closed=True)
    panel.line(s.outer.vertices, OUTER, closed=True)
    panel.line(s.trajectory.vertices, TRAJECTORY, closed=True)
    for ring in _place(found):
        panel.area(ring, INVERSE)
    for end, letters, distance, side in (
        (found.inside, "d'", found.inner, "right"),
        (found.outside, "d''", found.outer, "left"),
    ):
        foot = _along(found, _ahead(found, end))
        panel.arrow(end, foot, both=True)
        panel.label(
            find_middle(end, foot),
            _equal(letters, distance),
            -4 if side == "right" else 4,
            0,
            ha=side,
        )
    panel.dots([found.at, found.inside, found.outside])


def _name_parts(
    panel: BarePicture, found: Widths, places: tuple[Vertex, Vertex, tuple[Fraction, int], Vertex]
) -> None:
    """Write the names of I(g), and of I(G)', I(G)'', e and D, whose places are given."""
    (x, y), (inside, outside, (ahead, up), directrix) = found.at, places
    panel.label(found.inside, "$I(g)'$", 0, 11)
    panel.label(found.outside, "$I(g)''$", 2, -10)
    panel.label((x + inside[0], y + inside[1]), "$I(G)'$", 0, 4)
    panel.label((x + outside[0], y + outside[1]), "$I(G)''$", 0, -6)
    panel.label(_along(found, ahead), "$e$", 0, up)
    panel.label((x + directrix[0], y + directrix[1]), "$D$", 0, 5)


def _direction(edge: tuple[Point, Point]) -> tuple[Fraction, Fraction]:
    """The unit vector of an edge of rational length."""
    p, q = edge
    length = _length(p, q)
    assert length is not None
    return (q.x - p.x) / length, (q.y - p.y) / length


def _along(found: Widths, distance: Fraction) -> Vertex:
    """A point of e by its distance from where I(G) touches."""
    (x, y), (dx, dy) = found.at, _direction(found.edge)
    return x + distance * dx, y + distance * dy


def _across(found: Widths, point: Vertex, distance: Fraction) -> Vertex:
    """A point by its distance from a point of e, to the left of e."""
    (x, y), (dx, dy) = point, _direction(found.edge)
    return x - distance * dy, y + distance * dx


def _ahead(found: Widths, point: Vertex) -> Fraction:
    """Measure how far along e a point is, from where I(G) touches."""
    (x, y), (dx, dy) = found.at, _direction(found.edge)
    return Fraction((point[0] - x) * dx + (point[1] - y) * dy)
