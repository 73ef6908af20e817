"""The intersection of two shapes: its boundary, its area, and a point inside.

(1) Cut the edges of both shapes where they meet. Each piece lies entirely inside the other
    shape, entirely outside it, or along one of its edges.
(2) The boundary of the intersection consists of the pieces of each shape inside the other, and
    one copy of each piece shared by edges of the same direction.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain, pairwise

from exactsweep.geometry.edges import EdgeIndex, Rings
from exactsweep.geometry.vectors import cross, intersect, minus
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.number import Edge, Point, Rational, Vertex


def find_common_boundary(first: Rings, second: Rings) -> list[Edge]:
    """Return the boundary of the intersection as pieces of edges, interior on the left, by (2).

    Cost: O((m + n + c) log(m + n)) for c common points, if few edges are near each other.

    >>> square, other = ([[(k, k), (k + 2, k), (k + 2, k + 2), (k, k + 2)]] for k in (0, 1))
    >>> sorted((*map(int, p), *map(int, q)) for p, q in find_common_boundary(square, other))
    [(1, 1, 2, 1), (1, 2, 1, 1), (2, 1, 2, 2), (2, 2, 1, 2)]
    """
    shapes = EdgeIndex(first), EdgeIndex(second)
    return [
        *_find_pieces(*shapes, keeps_shared=True),
        *_find_pieces(*shapes[::-1], keeps_shared=False),
    ]


def measure_common_area(boundary: Sequence[Edge]) -> Fraction:
    """Return the area of the intersection. Cost: O(n)."""
    return add_up(Fraction(cross(p, q)) for p, q in boundary) / 2


def find_common_point(boundary: Sequence[Edge], first: Rings, second: Rings) -> Point:
    """Return a point inside both shapes, next to the longest piece of the common boundary.

    A ray to the left from a point of the piece enters the intersection; the result is halfway to
    the first edge that the ray meets.
    """
    vertices = {*chain.from_iterable((*first, *second))}
    p, q = max(boundary, key=lambda edge: measure_square(minus(*edge)))
    share = Fraction(1, 2)
    while (start := _find_point(p, q, share)) in vertices:
        # A ring may touch the piece there.
        share /= 2
    dx, dy = minus(q, p)
    ray: Vertex = (-dy, dx)
    nearest: Fraction | None = None
    for ring in (*first, *second):
        for a, b in pairwise((ring[-1], *ring)):
            u, v = minus(a, start), minus(b, start)
            of_a, of_b = cross(ray, u), cross(ray, v)
            if of_a == of_b or min(of_a, of_b) > 0 or max(of_a, of_b) < 0:
                continue
            distance = Fraction(cross(u, v)) / (of_b - of_a)
            if distance > 0 and (nearest is None or distance < nearest):
                nearest = distance
    assert nearest is not None
    return Point(start[0] - dy * nearest / 2, start[1] + dx * nearest / 2)


def measure_square(vector: Vertex) -> Rational:
    """Return the squared length of a vector."""
    return vector[0] * vector[0] + vector[1] * vector[1]


def _find_point(p: Vertex, q: Vertex, at: Rational) -> Vertex:
    return p[0] + at * (q[0] - p[0]), p[1] + at * (q[1] - p[1])


def _find_pieces(shape: EdgeIndex, other: EdgeIndex, *, keeps_shared: bool) -> Iterator[Edge]:
    """Yield the pieces of a boundary that bound the intersection, by (2)."""
    for left, right, low, high, p, q, _, _ in shape.near(other.box):
        cuts = {p, q}
        # Pieces shared with another edge, and whether the directions agree.
        along: list[tuple[Vertex, Vertex, bool]] = []
        for _, _, _, _, a, b, _, _ in other.near((left, right, low, high)):
            common = intersect((p, q), (a, b))
            cuts.update(common)
            if len(common) == 2:
                along.append((common[0], common[1], (a < b) == (p < q)))
        for start, end in pairwise(sorted(cuts, reverse=q < p)):
            middle = _find_point(start, end, Fraction(1, 2))
            shared = [same for first, last, same in along if first <= middle <= last]
            if (keeps_shared and shared[0]) if shared else other.contains(*middle, 1):
                yield start, end
