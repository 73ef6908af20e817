"""Figure 9: how far the two loops are apart along an edge of the trajectory."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from math import isqrt
from typing import TYPE_CHECKING, NamedTuple

from exactsweep.canvas import style
from exactsweep.geometry.number import format_fraction
from exactsweep.geometry.point import Point, Vertex
from exactsweep.paper.figures.figure import Facts, differ, loops_differ
from exactsweep.paper.figures.inverses import INVERSE, inverse_at
from exactsweep.paper.figures.minkowski import example, inverse_generatrix
from exactsweep.paper.figures.sheet import (
    COLUMN,
    INNER,
    OUTER,
    TRAJECTORY,
    Box,
    Sheet,
    middle,
)
from exactsweep.paper.functions import bottom_of, value

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Widths(NamedTuple):
    """The edge e of the trajectory, a point of it, and the distances of Figure 9.

    Attributes:
        edge: the ends of e.
        at: where I(G) touches e from both sides.
        inside: I(g) when I(G) is on the inner side of e.
        outside: I(g) on the outer side.
        inner, outer: their distances from e, d' and d''.
        width: of G, orthogonally to e.
    """

    edge: tuple[Point, Point]
    at: Vertex
    inside: Vertex
    outside: Vertex
    inner: Fraction
    outer: Fraction
    width: Fraction


def widths() -> Widths:
    """Measure at the longest edge of the lower half that has a rational length."""
    s = example()
    corners = s.trajectory.vertices
    edges = [(p, q) for p, q in pairwise(corners) if p.x < q.x and _length(p, q)]
    p, q = max(edges, key=lambda edge: _length(*edge) or 0)
    length = _length(p, q)
    assert length is not None
    dx, dy = (q.x - p.x) / length, (q.y - p.y) / length
    heights = {w: dx * w.y - dy * w.x for w in inverse_generatrix(s).vertices}
    low, high = (min(heights, key=heights.__getitem__), max(heights, key=heights.__getitem__))
    at = middle(p, q)
    inside = at[0] - low.x, at[1] - low.y
    outside = at[0] - high.x, at[1] - high.y
    own = [dx * w.y - dy * w.x for w in s.generatrix.vertices]
    return Widths((p, q), at, inside, outside, -heights[low], heights[high], max(own) - min(own))


def _length(p: Point, q: Point) -> Fraction | None:
    """The distance of two points if it is rational."""
    square = (q.x - p.x) ** 2 + (q.y - p.y) ** 2
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return root if root**2 == square else None


def list_facts() -> Facts:
    """What the figure states."""
    found = widths()
    return [
        ("d'", str(found.inner)),
        ("d''", str(found.outer)),
        ("d", str(found.width)),
    ]


def find_failures() -> Iterator[str]:
    """What is not borne out."""
    s, found = example(), widths()
    yield from loops_differ(s)
    yield differ("d' + d''", found.inner + found.outer, found.width)
    p, q = found.edge
    for loop, point in ((s.inner, found.inside), (s.outer, found.outside)):
        chain = bottom_of(loop.vertices)
        for by in (Fraction(-1, 9), Fraction(0), Fraction(1, 9)):
            x = point[0] + by * (q.x - p.x)
            yield differ(f"height over {x}", value(chain, x), point[1] + by * (q.y - p.y))


def draw() -> Figure:
    """The picture."""
    s, found = example(), widths()
    (x, y), half = found.at, Fraction(1, 2)
    placed = inverse_at(found.inside), inverse_at(found.outside)
    box = Box.around(*placed, [(x - 4, y - 4 - half), (x + 5, y + 3 + half)])
    foot = _along(found, Fraction(-14, 5))
    with Sheet([[box._replace(is_cut=True)]], COLUMN) as sheet:
        (panel,) = sheet.panels
        panel.ring(s.outer.vertices, s.inner.vertices, style.SWEPT)
        panel.area(s.directrix.vertices, style.DIRECTRIX)
        panel.line(s.inner.vertices, INNER, closed=True)
        panel.line(s.outer.vertices, OUTER, closed=True)
        panel.line(s.trajectory.vertices, TRAJECTORY, closed=True)
        for ring in placed:
            panel.area(ring, INVERSE)
        inner_end, outer_end = _across(found, foot, found.inner), _across(found, foot, -found.outer)
        panel.arrow(inner_end, outer_end, both=True)
        name = f"$d = {format_fraction(found.width)}$"
        panel.label(middle(outer_end, inner_end, share=Fraction(1, 4)), name, 5, 2, ha="left")
        for end, letters, distance, side in (
            (found.inside, "d'", found.inner, "right"),
            (found.outside, "d''", found.outer, "left"),
        ):
            foot = _along(found, _ahead(found, end))
            panel.arrow(end, foot, both=True)
            name = f"${letters} = {format_fraction(distance)}$"
            panel.label(middle(end, foot), name, -4 if side == "right" else 4, 0, ha=side)
        panel.dots([found.at, found.inside, found.outside])
        panel.label(found.inside, "$I(g)'$", 0, 11)
        panel.label(found.outside, "$I(g)''$", 2, -10)
        panel.label(min(placed[0]), "$I(G)'$", -11, -12)
        panel.label((x + 2, y - 2), "$I(G)''$", 0, -6)
        panel.label(_along(found, Fraction(7, 2)), "$e$", 0, 8)
        panel.label((x - 1, y + 3), "$D$", 0, 5)
    return sheet.figure


def _direction(found: Widths) -> Vertex:
    """The unit vector of e."""
    p, q = found.edge
    length = _length(p, q)
    assert length is not None
    return (q.x - p.x) / length, (q.y - p.y) / length


def _along(found: Widths, distance: Fraction) -> Vertex:
    """A point of e by its distance from where I(G) touches."""
    (x, y), (dx, dy) = found.at, _direction(found)
    return x + distance * dx, y + distance * dy


def _across(found: Widths, point: Vertex, distance: Fraction) -> Vertex:
    """A point by its distance from a point of e, to the left of e."""
    (x, y), (dx, dy) = point, _direction(found)
    return x - distance * dy, y + distance * dx


def _ahead(found: Widths, point: Vertex) -> Fraction:
    """How far along e a point is, from where I(G) touches."""
    (x, y), (dx, dy) = found.at, _direction(found)
    return Fraction((point[0] - x) * dx + (point[1] - y) * dy)
