"""Recognition of discs, slots and rounded convex polygons.

A closed path of arcs and lines bounds the points at distance at most r from a convex hull if (1)
its arcs have radius r and the same orientation, and turn by 360 degrees in total; (2) their
centers, in order, are the corners of a convex polygon, the ends of a segment, or one point; and (3)
each line between two arcs is the segment between their centers, offset outward by r.
"""

from collections.abc import Sequence
from fractions import Fraction
from math import tau
from typing import NamedTuple, Self

from exactsweep.formats.curved.curves import Arc
from exactsweep.formats.curved.path import Path
from exactsweep.geometry.vectors import cross, minus, orientation
from exactsweep.numbers.number import Point, find_root

_TURN = 0.5


class RoundedOutline(NamedTuple):
    """The points at distance at most `radius` from the convex hull of a set of points."""

    points: tuple[Point, ...]  # corners, counter-clockwise; one for a disc, two for a slot
    radius: Fraction
    error: Fraction = Fraction(0)  # bounds the distance from the true outline; 0 if rational

    def flipped(self) -> Self:
        return self._replace(points=tuple(Point(x, -y) for x, y in self.points[::-1]))


class _Round(NamedTuple):
    start: Point
    end: Point
    center: Point


def find_rounded(path: Path) -> RoundedOutline | None:
    """Return the hull and radius of a rounded path; None for other paths and irrational radii."""
    if not path.curves or path.gap or path.soft or not path.is_closed:
        return None
    found = [_find_circle(*drawn) for drawn in path.curves.values()]
    squares = {circle[1] for circle in found if circle}
    directions = {circle[2] for circle in found if circle}
    spans = sum(curve.span for curve, _ in path.curves.values() if isinstance(curve, Arc))
    if None in found or len(squares) != 1 or len(directions) != 1 or abs(spans - tau) > _TURN:
        return None
    square, left = squares.pop(), directions.pop()
    radius = find_root(square)
    if radius is None:
        return None
    arcs = [
        _Round(path.points[k], path.points[k + 1], circle[0])
        for k, circle in sorted(zip(path.curves, found, strict=True))
        if circle is not None
    ]
    lines = sum(p != q for p, q in zip(path.points, path.points[1:], strict=False))
    joins = [*zip(arcs, (*arcs[1:], arcs[0]), strict=True)]
    straight = sum(one.end != other.start for one, other in joins)
    is_round = len(path.points) == 2 or lines == len(arcs) + straight
    if not is_round or not all(_fits(*join, square, left=left) for join in joins):
        return None
    points = _list_corners([arc.center for arc in arcs], left=left)
    return None if points is None else RoundedOutline(points, radius, path.error)


def _find_circle(curve: object, forward: bool) -> tuple[Point, Fraction, bool] | None:
    """Return center, squared radius and orientation of a circular arc; None for other curves."""
    if not isinstance(curve, Arc):
        return None
    a, b, c, d, e, f, _ = curve.image
    if a * c + b * d or a * a + b * b != c * c + d * d:
        return None
    return Point(e, f), a * a + b * b, (a * d > b * c) == forward


def _fits(one: _Round, other: _Round, square: Fraction, *, left: bool) -> bool:
    """Return whether an arc leads to the next one, directly or by a tangent segment."""
    ends = minus(one.start, one.center), minus(one.end, one.center)
    if any(x * x + y * y != square for x, y in ends):
        return False
    line, side = minus(other.start, one.end), minus(other.center, one.center)
    if line == (0, 0):
        return side == (0, 0)
    (x, y), (u, v) = line, ends[1]
    return line == side and x * u + y * v == 0 and (cross(line, ends[1]) < 0) == left


def _list_corners(centers: Sequence[Point], *, left: bool) -> tuple[Point, ...] | None:
    """Return the corners counter-clockwise; None if they are not convex."""
    ring = [p for k, p in enumerate(centers) if p != centers[k - 1]] or [centers[0]]
    if not left:
        ring.reverse()
    corners = zip((ring[-1], *ring[:-1]), ring, (*ring[1:], ring[0]), strict=True)
    if len(ring) > 2 and not all(orientation(p, q, r) > 0 for p, q, r in corners):
        return None
    return tuple(ring)
