"""Points that prove that the rings of a part do not bound a shape.

Rings with the interior on the left bound a shape if their winding number is 0 or 1 everywhere. The
winding number of a point is the number of upward edges to its right, minus that of downward edges;
an edge includes its lower end, but not its upper one. At a point on an edge, this is the winding
number to the right of the edge. Each face is to the right of some edge.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise

from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.near import find_near
from exactsweep.geometry.vectors import intersect, orientation
from exactsweep.layout.layout import LayoutPart
from exactsweep.numbers.number import Point

_PartEdge = tuple[Point, Point]


def find_misfit(part: LayoutPart) -> Point | None:
    """Find a point with a winding number other than 0 or 1; None if rings only touch.

    >>> bow = [Point(Fraction(x), Fraction(y)) for x, y in ((0, 0), (2, 2), (2, 0), (0, 1))]
    >>> find_misfit(LayoutPart("bow", tuple(bow))) is None
    False
    """
    edges: list[_PartEdge] = []
    for k, ring in enumerate((part.exterior, *part.holes)):
        points = drop_repeated(ring)
        if (find_doubled_area(points) > 0) != (k == 0):
            points.reverse()
        edges += pairwise((*points, points[0]))
    tried = (p for p in _list_inner(edges) if _wind(edges, p) not in (0, 1))
    return next(tried, None)


def drop_repeated(ring: Sequence[Point]) -> list[Point]:
    """Drop vertices that equal their predecessor."""
    return [p for k, p in enumerate(ring) if p != ring[k - 1]]


def _list_inner(edges: Sequence[_PartEdge]) -> Iterator[Point]:
    """Yield the midpoint of each piece of a nonhorizontal edge between intersections."""
    meetings = [{*edge} for edge in edges]
    boxes = [(min(a.x, b.x), max(a.x, b.x), min(a.y, b.y), max(a.y, b.y)) for a, b in edges]
    for k, j in find_near(boxes):
        common = [Point(Fraction(x), Fraction(y)) for x, y in intersect(edges[k], edges[j])]
        meetings[k].update(common)
        meetings[j].update(common)
    for (a, b), points in zip(edges, meetings, strict=True):
        if a.y != b.y:
            for p, q in pairwise(sorted(points)):
                yield Point((p.x + q.x) / 2, (p.y + q.y) / 2)


def _wind(edges: Sequence[_PartEdge], z: Point) -> int:
    up = sum(a.y <= z.y < b.y and orientation(a, b, z) > 0 for a, b in edges)
    return up - sum(b.y <= z.y < a.y and orientation(a, b, z) < 0 for a, b in edges)
