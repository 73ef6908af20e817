"""The least distance of two solids that do not overlap, among the edges that are near enough.

The least squared distance of two segments that do not meet is that of an end of one from the other
one: the quotient of two ints.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import isqrt
from typing import NamedTuple

from exactsweep.geometry.overlap import touch
from exactsweep.layout.solid import BoxedEdge, Solid
from exactsweep.numbers.point import Point


class NearestPoints(NamedTuple):
    """The squared distance of two solids, and where they are so near.

    Attributes:
        square: the squared distance.
        points: a point of the boundary of each.
    """

    square: Fraction
    points: tuple[Point, Point]


def find_gap(a: Solid, b: Solid, below: Fraction) -> NearestPoints | None:
    """Find the least distance of the boundaries of two solids, if its square is below a bound.

    Args:
        a: a solid.
        b: another one, on the same lattice, that does not overlap it.
        below: the bound on the squared distance, more than 0.

    Returns:
        A NearestPoints, or None.

    Cost: O(k h) for k edges of one and h edges of the other that are within the bound of the box of
    the other solid.
    """
    scale = a.scale
    n, d = (below * scale * scale).as_integer_ratio()
    reach = isqrt(n // d) + 1
    x, y = b.x - a.x, b.y - a.y
    left, right, low, high = a.form.box
    west, east, south, north = b.form.box
    ours = a.form.near((west + x - reach, east + x + reach, south + y - reach, north + y + reach))
    around = (left - x - reach, right - x + reach, low - y - reach, high - y + reach)
    theirs = b.form.near(around) if ours else []
    best: tuple[BoxedEdge, BoxedEdge] | None = None
    for e in theirs:
        left, right, low, high = e[0] + x, e[1] + x, e[2] + y, e[3] + y
        farthest, nearest = right + reach, left - reach
        for f in ours:
            if f[0] > farthest:
                break
            if f[1] < nearest:
                continue
            across = left - f[1] if left > f[1] else f[0] - right if f[0] > right else 0
            up = low - f[3] if low > f[3] else f[2] - high if f[2] > high else 0
            if (across * across + up * up) * d >= n:
                continue
            square, length = _measure_edges(f, e, x, y)
            if square * d < n * length:
                n, d, best = square, length, (f, e)
                reach = isqrt(n // d) + 1
                farthest, nearest = right + reach, left - reach
    if best is None:
        return None
    p, q = _find_points(*best, x, y)
    return NearestPoints(
        Fraction(n, d * scale * scale) if type(n) is int else Fraction(n) / d / scale**2,
        (a.leave(p[0] + a.x, p[1] + a.y), a.leave(q[0] + a.x, q[1] + a.y)),
    )


def _ends(edge: BoxedEdge, x: int, y: int) -> tuple[tuple[int, int], tuple[int, int]]:
    return (edge[4] + x, edge[5] + y), (edge[6] + x, edge[7] + y)


def _measure_edges(f: BoxedEdge, e: BoxedEdge, x: int, y: int) -> tuple[int, int]:
    """The squared distance of two edges, the second one moved, as a quotient."""
    (a, b), (p, q) = _ends(f, 0, 0), _ends(e, x, y)
    if touch(a, b, p, q) != []:
        return 0, 1
    n, d = measure_point(a, p, q)
    for found, length in (
        measure_point(b, p, q),
        measure_point(p, a, b),
        measure_point(q, a, b),
    ):
        if found * d < n * length:
            n, d = found, length
    return n, d


def measure_point(p: tuple[int, int], a: tuple[int, int], b: tuple[int, int]) -> tuple[int, int]:
    """Return the squared distance of a point from a segment as a quotient.

    >>> measure_point((0, 2), (1, 1), (2, 0)), measure_point((0, 0), (2, 0), (0, 2))
    ((2, 1), (16, 8))
    """
    dx, dy, x, y = b[0] - a[0], b[1] - a[1], p[0] - a[0], p[1] - a[1]
    along, length = x * dx + y * dy, dx * dx + dy * dy
    if along <= 0:
        return x * x + y * y, 1
    if along >= length:
        x, y = x - dx, y - dy
        return x * x + y * y, 1
    return (dx * y - dy * x) ** 2, length


def find_foot(
    p: Iterable[int | Fraction], a: Iterable[int | Fraction], b: Iterable[int | Fraction]
) -> Point:
    """Return the point of a segment that is nearest to a point.

    >>> find_foot((0, 0), (2, 0), (0, 2))
    Point(x=Fraction(1, 1), y=Fraction(1, 1))
    """
    (px, py), (ax, ay), (bx, by) = p, a, b
    dx, dy = bx - ax, by - ay
    length = dx * dx + dy * dy
    along = Fraction((px - ax) * dx + (py - ay) * dy) / length if length else Fraction(0)
    along = min(max(along, Fraction(0)), Fraction(1))
    return Point(ax + along * dx, ay + along * dy)


def _find_points(f: BoxedEdge, e: BoxedEdge, x: int, y: int) -> tuple[Point, Point]:
    """The two nearest points of two edges, of which the second one is moved."""
    (a, b), (p, q) = _ends(f, 0, 0), _ends(e, x, y)
    shared = touch(a, b, p, q)
    if shared:
        both = Point(Fraction(shared[0][0]), Fraction(shared[0][1]))
        return both, both
    pairs = [
        *((Point(Fraction(v[0]), Fraction(v[1])), find_foot(v, p, q)) for v in (a, b)),
        *((find_foot(v, a, b), Point(Fraction(v[0]), Fraction(v[1]))) for v in (p, q)),
    ]
    return min(pairs, key=lambda pair: (pair[0].x - pair[1].x) ** 2 + (pair[0].y - pair[1].y) ** 2)
