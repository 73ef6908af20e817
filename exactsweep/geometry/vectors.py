"""Vectors and segments: cross products, angles, the contact of two edges, and convex hulls."""

from collections.abc import Iterable
from fractions import Fraction
from functools import cmp_to_key
from typing import TypeVar, overload

from exactsweep.numbers.number import Edge, Rational, Vertex

P = TypeVar("P", bound=Vertex)


@overload
def minus(p: tuple[int, int], q: tuple[int, int]) -> tuple[int, int]: ...
@overload
def minus(p: Vertex, q: Vertex) -> Vertex: ...
def minus(p: Vertex, q: Vertex) -> Vertex:
    """Return the vector from q to p."""
    return p[0] - q[0], p[1] - q[1]


def cross(u: Vertex, v: Vertex) -> Rational:
    """Return the cross product, positive if v is to the left of u."""
    return u[0] * v[1] - u[1] * v[0]


def orientation(p: Vertex, q: Vertex, r: Vertex) -> Rational:
    """Return twice the signed area of a triangle, positive if r is left of the line from p to q."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def compare_angles(u: Vertex, v: Vertex) -> int:
    """Compare two directions by counter-clockwise angle from the X axis: -1, 0 or 1."""
    halves = ((u[1], u[0]) < (0, 0)) - ((v[1], v[0]) < (0, 0))
    return halves or (cross(v, u) > 0) - (cross(v, u) < 0)


angle_key = cmp_to_key(compare_angles)
"""A sort key in the order of `compare_angles`."""


def is_on_segment(point: Vertex, p: Vertex, q: Vertex) -> bool:
    """Decide whether a point is on a closed segment."""
    (tx, ty), (px, py), (qx, qy) = point, p, q
    return (qx - px) * (ty - py) == (qy - py) * (tx - px) and min(p, q) <= point <= max(p, q)


def is_between(point: Vertex, p: Vertex, q: Vertex) -> bool:
    """Decide whether a point is on an open segment."""
    return is_on_segment(point, p, q) and p != point != q


def touch(a: Vertex, b: Vertex, p: Vertex, q: Vertex) -> list[Vertex] | None:
    """Return the ends of the intersection of edges a b and p q, or None if their left sides meet.

    Left sides meet if the edges cross properly, or overlap in the same direction.

    >>> touch((0, 0), (2, 0), (1, 0), (1, 2)), touch((0, 0), (2, 0), (3, 0), (1, 0))
    ([(1, 0)], [(1, 0), (2, 0)])
    >>> touch((0, 0), (2, 0), (1, 0), (3, 0)) is None
    True
    """
    (ax, ay), (bx, by), (px, py), (qx, qy) = a, b, p, q
    dx, dy, ex, ey = bx - ax, by - ay, qx - px, qy - py
    of_a = ex * (ay - py) - ey * (ax - px)
    of_b = ex * (by - py) - ey * (bx - px)
    if (of_a > 0 and of_b > 0) or (of_a < 0 and of_b < 0):
        return []
    of_p = dx * (py - ay) - dy * (px - ax)
    of_q = dx * (qy - ay) - dy * (qx - ax)
    if (of_p > 0 and of_q > 0) or (of_p < 0 and of_q < 0):
        return []
    if of_a == 0 == of_b:
        low, high = max(min(a, b), min(p, q)), min(max(a, b), max(p, q))
        if low > high:
            return []
        if low < high and (a < b) == (p < q):
            return None
        return [low, high]
    if of_a and of_b and of_p and of_q:
        return None
    # The edges are not parallel and meet at one point, an end of one of them.
    return [a if of_a == 0 else b if of_b == 0 else p if of_p == 0 else q]


def intersect(edge: Edge, other: Edge) -> list[Vertex]:
    """Return the ends of the intersection of two edges: no point, one, or two.

    >>> [(str(x), str(y)) for x, y in intersect(((0, 0), (2, 1)), ((1, 0), (1, 2)))]
    [('1', '1/2')]
    >>> intersect(((0, 0), (2, 0)), ((1, 0), (3, 0)))
    [(1, 0), (2, 0)]
    """
    (a, b), (p, q) = edge, other
    common = touch(a, b, p, q)
    if common is not None:
        return common
    of_a, of_b = orientation(p, q, a), orientation(p, q, b)
    if of_a == of_b:
        # The edges are collinear and overlap.
        return [max(min(a, b), min(p, q)), min(max(a, b), max(p, q))]
    (ax, ay), (dx, dy), along = a, minus(b, a), Fraction(of_a) / (of_a - of_b)
    return [(ax + along * dx, ay + along * dy)]


def find_hull(points: Iterable[P]) -> list[P]:
    """Find the convex hull of points (Andrew's monotone chain). Cost: O(n log n).

    Returns the corners, counter-clockwise from the smallest: two if the points are collinear, none
    if they are equal.

    >>> find_hull([(0, 0), (4, 0), (1, 1), (2, 0), (0, 4)])
    [(0, 0), (4, 0), (0, 4)]
    """
    ordered = sorted(set(points))
    found: list[P] = []
    for run in ordered, ordered[::-1]:
        half: list[P] = []
        for point in run:
            while len(half) > 1 and orientation(half[-2], half[-1], point) <= 0:
                half.pop()
            half.append(point)
        found += half[:-1]
    return found
