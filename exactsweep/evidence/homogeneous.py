"""Points and segments in homogeneous coordinates, without a common denominator.

The point (x, y, w) is (x/w, y/w), w > 0. It lies left of the line (a, b, c) if a x + b y + c w > 0.
Parameters along a segment run from 0 to 1.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import pairwise
from math import gcd
from typing import NamedTuple

from exactsweep.geometry.frame import HomogeneousPoint

Interval = tuple[Fraction, Fraction]
"""The first and the last parameter."""


class DirectedSegment(NamedTuple):
    """A directed segment, possibly a point, with its primitive direction and its line."""

    start: HomogeneousPoint
    end: HomogeneousPoint
    direction: tuple[int, int]
    line: tuple[int, int, int]


def place(p: HomogeneousPoint) -> tuple[Fraction, Fraction]:
    """Return the coordinates of a point."""
    return Fraction(p[0], p[2]), Fraction(p[1], p[2])


def make_side(p: HomogeneousPoint, q: HomogeneousPoint) -> DirectedSegment:
    """Return the segment from one point to another."""
    (x, y, w), (u, v, z) = p, q
    dx, dy = u * w - x * z, v * w - y * z
    common = gcd(dx, dy) or 1
    return direct_side(p, q, (dx // common, dy // common))


def direct_side(
    p: HomogeneousPoint, q: HomogeneousPoint, direction: tuple[int, int]
) -> DirectedSegment:
    """Return the segment from one point to another, given its direction."""
    (x, y, w), (dx, dy) = p, direction
    level = dy * x - dx * y
    common = gcd(level, w)
    w //= common
    return DirectedSegment(p, q, direction, (-dy * w, dx * w, level // common))


def list_sides(ring: Sequence[HomogeneousPoint]) -> list[DirectedSegment]:
    """Return the edges of a ring."""
    return [make_side(p, q) for p, q in pairwise((*ring, ring[0]))]


def find_between(p: HomogeneousPoint, q: HomogeneousPoint, parameter: Fraction) -> HomogeneousPoint:
    """Return the point of a segment at a parameter."""
    (x, y, w), (u, v, z), (n, d) = p, q, parameter.as_integer_ratio()
    from_p, from_q = (d - n) * z, n * w
    a, b, c = x * from_p + u * from_q, y * from_p + v * from_q, d * w * z
    common = gcd(a, b, c)
    return a // common, b // common, c // common


def is_right(side: DirectedSegment, other: DirectedSegment) -> bool:
    """Decide whether a segment lies entirely right of the line of another."""
    (a, b, c), (x, y, w), (u, v, z) = side.line, other.start, other.end
    return a * x + b * y + c * w < 0 and a * u + b * v + c * z < 0


def is_along(side: DirectedSegment, other: DirectedSegment) -> bool:
    """Decide whether two segments are collinear."""
    (dx, dy), (ex, ey), (a, b, c) = side.direction, other.direction, side.line
    return dx * ey == dy * ex and a * other.start[0] + b * other.start[1] + c * other.start[2] == 0


def is_on_border(sides: Iterable[DirectedSegment], p: HomogeneousPoint) -> bool:
    """Decide whether a point is on the boundary of a convex polygon."""
    x, y, w = p
    return min(a * x + b * y + c * w for *_, (a, b, c) in sides) == 0


def clip(
    sides: Iterable[DirectedSegment], a: HomogeneousPoint, b: HomogeneousPoint
) -> Interval | None:
    """Find the open interval of a segment inside an open convex polygon, or None.

    An interval that contains an end of the segment extends to -1 or 2.

    >>> square = list_sides([(0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)])
    >>> clip(square, (1, 1, 1), (5, 1, 1))
    (Fraction(-1, 1), Fraction(1, 4))
    """
    (x, y, w), (u, v, z) = a, b
    low, low_unit, high, high_unit = -1, 1, 2, 1
    for *_, (k, m, n) in sides:
        at_a, at_b = (k * x + m * y + n * w) * z, (k * u + m * v + n * z) * w
        if at_a <= 0:
            if at_b <= 0:
                return None
            if -at_a * low_unit > low * (at_b - at_a):
                low, low_unit = -at_a, at_b - at_a
        elif at_b <= 0 and at_a * high_unit < high * (at_a - at_b):
            high, high_unit = at_a, at_a - at_b
    if low * high_unit < high * low_unit:
        return Fraction(low, low_unit), Fraction(high, high_unit)
    return None


def intersect(side: DirectedSegment, other: DirectedSegment) -> Interval | None:
    """Find the closed interval of a segment that another segment or a point covers, or None.

    It may extend beyond the segment.

    >>> side = make_side((0, 0, 1), (4, 0, 1))
    >>> intersect(side, make_side((6, 0, 1), (3, 0, 1)))
    (Fraction(3, 4), Fraction(3, 2))
    """
    (a, b, (dx, dy), (k, m, n)), (p, q, *_, (e, f, g)) = side, other
    of_p, of_q = k * p[0] + m * p[1] + n * p[2], k * q[0] + m * q[1] + n * q[2]
    if (of_p > 0 and of_q > 0) or (of_p < 0 and of_q < 0):
        return None
    if of_p == of_q == 0:
        start, end, *ends = (Fraction(dx * x + dy * y, w) for x, y, w in (a, b, p, q))
        low, high = min(ends), max(ends)
        if low > end or high < start:
            return None
        return (low - start) / (end - start), (high - start) / (end - start)
    of_a = (e * a[0] + f * a[1] + g * a[2]) * b[2]
    of_b = (e * b[0] + f * b[1] + g * b[2]) * a[2]
    if of_a == of_b or (of_a > 0 and of_b > 0) or (of_a < 0 and of_b < 0):
        return None
    at = Fraction(of_a, of_a - of_b)
    return at, at
