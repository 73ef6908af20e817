"""Convex pieces: boxes, intersections, separating normals, and pieces of the complement.

(1) If the interiors of two convex pieces are disjoint, the line of some edge separates them.
(2) If the nearest points p and q of two convex pieces are d > 0 apart, the strip of width d between
    them with normal q - p is empty; q - p is the normal of an edge, or joins two vertices.
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise, product
from math import gcd

from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.convex import ConvexRing, IntRing, IntVertex, cut_to_convex
from exactsweep.geometry.vectors import minus, orientation
from exactsweep.numbers.number import Point, Rational, Vertex


def bound_piece(piece: IntRing, radius: int = 0) -> tuple[int, int, int, int]:
    xs, ys = zip(*piece, strict=True)
    return min(xs) - radius, max(xs) + radius, min(ys) - radius, max(ys) + radius


def find_common_point(one: Sequence[Vertex], other: Sequence[Vertex]) -> Point | None:
    """Find a point inside two convex pieces, in O(m n); None if their interiors are disjoint.

    >>> find_common_point([(0, 0), (2, 0), (2, 2), (0, 2)], [(1, 1), (3, 1), (3, 3), (1, 3)])
    Point(x=Fraction(3, 2), y=Fraction(3, 2))
    """
    common: list[Vertex] = [*one]
    if not (one and other):
        return None
    for a, b in pairwise((*other, other[0])):
        sides = [orientation(a, b, p) for p in common]
        common = [*clip(common, sides)]
        if not common:
            return None
    if len(common) < 3 or not find_doubled_area(common):
        return None
    xs, ys = zip(*common, strict=True)
    return Point(Fraction(sum(xs)) / len(xs), Fraction(sum(ys)) / len(ys))


def clip(ring: Sequence[Vertex], sides: Sequence[Rational]) -> Iterator[Vertex]:
    """Clip a ring to a half-plane; `sides` are values of its linear function at the vertices."""
    for k, (p, side) in enumerate(zip(ring, sides, strict=True)):
        q, before = ring[k - 1], sides[k - 1]
        if (side > 0 > before) or (side < 0 < before):
            share = Fraction(before) / (before - side)
            yield q[0] + share * (p[0] - q[0]), q[1] + share * (p[1] - q[1])
        if side >= 0:
            yield p


def find_normal(
    one: Sequence[IntVertex], other: Sequence[IntVertex], distance: Fraction
) -> IntVertex | None:
    """Find a normal that proves a distance between two convex pieces; None if they are closer.

    Pieces are counter-clockwise rings, segments or points; the distance is in lattice units.

    >>> find_normal([(0, 0), (2, 0), (0, 2)], [(2, 2), (0, 2), (2, 0)], Fraction(0))
    (1, 1)
    """
    square = distance * distance
    for x, y in _list_normals(one, other, distance):
        if not (x or y):
            # A single point has no edge.
            continue
        gap = min(x * px + y * py for px, py in other) - max(x * px + y * py for px, py in one)
        if gap >= 0 and gap * gap >= square * (x * x + y * y):
            common = gcd(x, y)
            return x // common, y // common
    return None


def _list_normals(
    one: Sequence[IntVertex], other: Sequence[IntVertex], distance: Fraction
) -> Iterator[IntVertex]:
    for (ax, ay), (bx, by) in pairwise((*one, one[0])):
        yield by - ay, ax - bx
    for (ax, ay), (bx, by) in pairwise((*other, other[0])):
        yield ay - by, bx - ax
    if distance:
        joins = [minus(q, p) for p, q in product(one, other)]
        yield from sorted(joins, key=lambda v: v[0] * v[0] + v[1] * v[1])[:1]


def cut_outside(exterior: IntRing, frame: tuple[int, int, int, int]) -> list[ConvexRing]:
    """Cut the space between a counter-clockwise container and a larger frame into convex pieces.

    >>> len(cut_outside([(0, 0), (2, 0), (2, 2), (1, 2), (0, 1)], (-1, -1, 3, 3)))
    5
    """
    west, south, east, north = frame
    left, right, low, high = bound_piece(exterior)
    pieces = [
        _rectangle(west, south, left, north),
        _rectangle(right, south, east, north),
        _rectangle(left, south, right, low),
        _rectangle(left, high, right, north),
    ]
    corners = _rectangle(left, low, right, high)

    def find_side(p: IntVertex) -> int | None:
        """Return the index of the box side through p; at a corner, the side that ends there."""
        x, y = p
        sides = [y == low and x > left, x == right and y > low, y == high and x < right, x == left]
        return sides.index(True) if any(sides) else None

    on_border = [k for k, p in enumerate(exterior) if find_side(p) is not None]
    for first, last in pairwise([*on_border, on_border[0] + len(exterior)]):
        chain = [exterior[k % len(exterior)] for k in range(first, last + 1)]
        start, end = find_side(chain[0]), find_side(chain[-1])
        assert start is not None
        assert end is not None
        passed = range(start, start + (end - start) % 4)
        # A corner belongs to the side that ends there, so the chain may start at the first one.
        border = [c for c in (corners[(k + 1) % 4] for k in passed) if c != chain[0]]
        ring = [chain[0], *border, *chain[:0:-1]]
        if len(chain) > 2 or border:
            pieces += cut_to_convex([ring])
    return pieces


def _rectangle(left: int, low: int, right: int, high: int) -> ConvexRing:
    return [(left, low), (right, low), (right, high), (left, high)]
