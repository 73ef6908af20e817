"""The squared distance between two shapes, with two nearest points.

(1) Shapes meet if and only if their boundaries meet, or a vertex of one exterior lies in the other
    shape.
(2) Disjoint shapes are nearest on their boundaries, and disjoint segments at an end of one of them.
    So the squared distance is rational: a squared cross product divided by a squared length.
(3) The edges of each boundary are the leaves of a binary tree of boxes. The search opens pairs of
    boxes in order of distance, and ends at the first pair that is no nearer than the nearest
    edges so far.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from heapq import heappop, heappush
from itertools import product
from typing import NamedTuple

from exactsweep.geometry.edges import Rings, is_inside
from exactsweep.geometry.region import Region, Vertices, share_lattice, to_region
from exactsweep.geometry.vectors import intersect
from exactsweep.numbers.error import explain_type_errors
from exactsweep.numbers.number import Edge, Point, Rational, Vertex

_EdgeBox = tuple[Rational, Rational, Rational, Rational]
_NearestRatio = tuple[Rational, Rational]


class SquaredDistance(NamedTuple):
    """The squared distance between two shapes, 0 if they meet, and a nearest point of each."""

    value: Fraction
    points: tuple[Point, Point]


@explain_type_errors
def distance_squared(a: Region | Vertices, b: Region | Vertices) -> SquaredDistance:
    """Find the squared distance between two shapes as closed sets, and two nearest points.

    Args:
        a: a Polygon, a Region or the vertices of a polygon.
        b: the other shape, in any of these forms.

    Returns:
        The square, 0 if the shapes meet, and two nearest points, one of each shape.

    Raises:
        PolygonError: a polygon is not simple.
        NumberError: a coordinate is not an exact number. Messages begin with "a" or "b".

    Cost: O((m + n) log(m + n)) if few pairs of edges are nearly closest; O(m n log(m n)) at worst.

    Example:
        >>> square, triangle = [(0, 0), (1, 0), (1, 1), (0, 1)], [(3, 0), (3, 3), (0, 3)]
        >>> distance = distance_squared(square, triangle)
        >>> distance.value, distance.points[1]
        (Fraction(1, 2), Point(x=Fraction(3, 2), y=Fraction(3, 2)))
    """
    scale, (first, second) = share_lattice([to_region(a, "a"), to_region(b, "b")])
    value, (p, q) = _find_nearest(_EdgeTree(first), _EdgeTree(second))
    return SquaredDistance(value / scale**2, (_leave(p, scale), _leave(q, scale)))


class _EdgeTree:
    """A binary tree of boxes (left, right, low, high); `levels[0]` has one for each edge."""

    def __init__(self, rings: Rings) -> None:
        self.rings = rings
        self.edges: list[Edge] = [
            edge for ring in rings for edge in zip((ring[-1], *ring[:-1]), ring, strict=True)
        ]
        boxes = [
            (min(px, qx), max(px, qx), min(py, qy), max(py, qy))
            for (px, py), (qx, qy) in self.edges
        ]
        self.levels: list[list[_EdgeBox]] = [boxes]
        while len(boxes) > 1:
            boxes = [_unite(boxes[k : k + 2]) for k in range(0, len(boxes), 2)]
            self.levels.append(boxes)


def _find_nearest(first: _EdgeTree, second: _EdgeTree) -> SquaredDistance:
    common = _find_vertex_inside(first, second)
    if common is not None:
        return SquaredDistance(Fraction(0), (common, common))
    best: _NearestRatio | None = None
    up, over = len(first.levels) - 1, len(second.levels) - 1
    heap = [(_measure_boxes(first.levels[up][0], second.levels[over][0]), up, 0, over, 0)]
    while heap and (best is None or heap[0][0] * best[1] < best[0]):
        apart, up, i, over, j = heappop(heap)
        if up == over == 0:
            edges = first.edges[i], second.edges[j]
            if apart == 0 and (shared := intersect(*edges)):
                x, y = shared[0]
                point = Point(Fraction(x), Fraction(y))
                return SquaredDistance(Fraction(0), (point, point))
            n, d = measure_ends(*edges)[:2]
            if best is None or n * best[1] < best[0] * d:
                best, nearest = (n, d), edges
            continue
        # Descend in the tree with more levels left, to keep the boxes about equally large.
        lower, across = (up - 1, over) if up >= over else (up, over - 1)
        mine = range(2 * i, min(2 * i + 2, len(first.levels[lower]))) if lower < up else (i,)
        theirs = range(2 * j, min(2 * j + 2, len(second.levels[across]))) if lower == up else (j,)
        for k, h in product(mine, theirs):
            apart = _measure_boxes(first.levels[lower][k], second.levels[across][h])
            heappush(heap, (apart, lower, k, across, h))
    assert best is not None
    return SquaredDistance(Fraction(*best), find_nearest_ends(*nearest))


def _find_vertex_inside(first: _EdgeTree, second: _EdgeTree) -> Point | None:
    """Find a vertex of one exterior in the interior of the other shape."""
    for one, other in ((first, second), (second, first)):
        x, y = one.rings[0][0]
        left, right, low, high = other.levels[-1][0]
        if left < x < right and low < y < high and is_inside((x, y), other.rings):
            return Point(Fraction(x), Fraction(y))
    return None


def _unite(boxes: Sequence[_EdgeBox]) -> _EdgeBox:
    if len(boxes) == 1:
        return boxes[0]
    (left, right, low, high), (west, east, south, north) = boxes
    return min(left, west), max(right, east), min(low, south), max(high, north)


def _measure_boxes(a: _EdgeBox, b: _EdgeBox) -> Rational:
    left, right, low, high = a
    west, east, south, north = b
    dx = max(0, left - east, west - right)
    dy = max(0, low - north, south - high)
    return dx * dx + dy * dy


_NearestEnd = tuple[Rational, Rational, Vertex, Edge, bool]


def measure_ends(edge: Edge, other: Edge) -> _NearestEnd:
    """Find which end of two disjoint segments is nearest to the other segment.

    Returns (n, d, end, segment, is_first): the squared distance n / d, the nearest end, the segment
    that it is nearest to, and whether the end belongs to the first argument.
    """
    best: _NearestEnd | None = None
    for one, side, is_first in ((edge, other, True), (other, edge, False)):
        for end in one:
            n, d = measure_to_edge(end, side)
            if best is None or n * best[1] < best[0] * d:
                best = n, d, end, side, is_first
    assert best is not None
    return best


def find_nearest_ends(edge: Edge, other: Edge) -> tuple[Point, Point]:
    """Return two nearest points of two disjoint segments."""
    _, _, (x, y), side, is_first = measure_ends(edge, other)
    at, foot = Point(Fraction(x), Fraction(y)), find_foot((x, y), side)
    return (at, foot) if is_first else (foot, at)


def measure_to_edge(point: Vertex, edge: Edge) -> _NearestRatio:
    """Return the squared distance n / d of a point from a segment, as (n, d)."""
    (px, py), ((ax, ay), (bx, by)) = point, edge
    dx, dy, x, y = bx - ax, by - ay, px - ax, py - ay
    along, length = x * dx + y * dy, dx * dx + dy * dy
    if along <= 0:
        return x * x + y * y, 1
    if along >= length:
        return (x - dx) ** 2 + (y - dy) ** 2, 1
    return (dx * y - dy * x) ** 2, length


def find_foot(point: Vertex, edge: Edge) -> Point:
    """Return the nearest point on a segment, which may have length 0."""
    (px, py), ((ax, ay), (bx, by)) = point, edge
    dx, dy = bx - ax, by - ay
    length = dx * dx + dy * dy
    along = Fraction((px - ax) * dx + (py - ay) * dy, length) if length else Fraction(0)
    along = min(max(along, Fraction(0)), Fraction(1))
    return Point(ax + along * dx, ay + along * dy)


def _leave(point: Point, scale: int) -> Point:
    return Point(point.x / scale, point.y / scale)
