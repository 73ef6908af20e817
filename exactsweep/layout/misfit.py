"""Points that show that the rings of a part are not the boundary of a shape.

The winding number of rings at a point, their interior on the left, counts the edges to the right of
the point: one for an edge upwards, less one for an edge downwards. An edge owns its lower end, but
not its upper one. Rings bound a shape if the number is 0 or 1 everywhere. At a point inside an edge
it is the number to the right of the edge. Each face has such an edge on its left.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.near import find_near
from exactsweep.geometry.vectors import is_on_segment, turn
from exactsweep.layout.layout import LayoutPart
from exactsweep.numbers.number import Edge, Point


def find_misfit(part: LayoutPart) -> Point | None:
    """Find a point around which the rings of a part go neither 0 times nor once.

    Args:
        part: a part.

    Returns:
        The point; None if there is none, because rings only touch, or if a ring has fewer than
        three vertices.

    Cost: O(n) for each tried point, at most one for each edge and each two edges that meet.

    >>> from fractions import Fraction
    >>> bow = [Point(Fraction(x), Fraction(y)) for x, y in ((0, 0), (2, 2), (2, 0), (0, 1))]
    >>> find_misfit(LayoutPart("bow", tuple(bow))) is None
    False
    """
    edges: list[Edge] = []
    for k, ring in enumerate((part.exterior, *part.holes)):
        points = [p for i, p in enumerate(ring) if p != ring[i - 1]]
        if len(points) < 3:
            return None
        if (find_doubled_area(points) > 0) != (k == 0):
            points.reverse()
        edges += pairwise((*points, points[0]))
    tried = (p for p in _list_inner(edges) if _wind(edges, p) not in (0, 1))
    return next(tried, None)


def _list_inner(edges: Sequence[Edge]) -> Iterator[Point]:
    """List a point in each piece of an edge between others, unless it is horizontal."""
    meetings: list[set[Point]] = [{*edge} for edge in edges]
    boxes = [(min(a[0], b[0]), max(a[0], b[0]), min(a[1], b[1]), max(a[1], b[1])) for a, b in edges]
    for k, j in find_near(boxes):
        common = _meet(edges[k], edges[j])
        meetings[k].update(common)
        meetings[j].update(common)
    for (a, b), points in zip(edges, meetings, strict=True):
        if a[1] != b[1]:
            for p, q in pairwise(sorted(points)):
                yield Point((p[0] + q[0]) / 2, (p[1] + q[1]) / 2)


def _meet(one: Edge, other: Edge) -> list[Point]:
    """Return the point in which two edges cross, or the ends of each that are on the other."""
    (a, b), (p, q) = one, other
    of_p, of_q, of_a, of_b = turn(a, b, p), turn(a, b, q), turn(p, q, a), turn(p, q, b)
    if of_p * of_q < 0 and of_a * of_b < 0:
        share = of_p / (of_p - of_q)
        return [Point(p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1]))]
    ends = [z for z in one if is_on_segment(z, *other)]
    return ends + [z for z in other if is_on_segment(z, *one)]


def _wind(edges: Sequence[Edge], z: Point) -> int:
    """Return the winding number at a point."""
    up = sum(a[1] <= z[1] < b[1] and turn(a, b, z) > 0 for a, b in edges)
    return up - sum(b[1] <= z[1] < a[1] and turn(a, b, z) < 0 for a, b in edges)
