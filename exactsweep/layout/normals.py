"""Normals that prove that convex pieces are far enough apart.

(1) If the interiors of two convex pieces are disjoint, the line of some edge separates them.
(2) If the nearest points of two convex pieces p and q are d > 0 apart, the strip between them with
    the normal q - p is d wide and empty; that is the normal of an edge, or joins two vertices.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise, product
from math import gcd

from exactsweep.geometry.convex import IntVertex
from exactsweep.geometry.vectors import minus


def find_normal(
    one: Sequence[IntVertex], other: Sequence[IntVertex], distance: Fraction
) -> IntVertex | None:
    """Find a normal that proves that two convex pieces are at least a distance apart.

    Pieces are convex rings, counter-clockwise, points or segments; the distance is in units of the
    lattice. None if they are nearer.

    Cost: O((m + n)^2); for vertices that are nearest O(m n (m + n)).

    >>> find_normal([(0, 0), (2, 0), (0, 2)], [(2, 2), (0, 2), (2, 0)], Fraction(0))
    (1, 1)
    """
    square = distance * distance
    for x, y in _list_normals(one, other, distance):
        if not (x or y):
            # The side of a point.
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
