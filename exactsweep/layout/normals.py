"""Normals that prove a distance between convex pieces.

(1) If the interiors of two convex pieces are disjoint, the line of some edge separates them.
(2) If the nearest points p and q of two convex pieces are d > 0 apart, the strip of width d between
    them with normal q - p is empty; q - p is the normal of an edge, or joins two vertices.
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
