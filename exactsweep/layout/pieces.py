"""Boxes and intersections of convex pieces."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise

from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.convex import IntRing
from exactsweep.geometry.vectors import orientation
from exactsweep.numbers.number import Point, Rational, Vertex


def bound_piece(piece: IntRing, radius: int = 0) -> tuple[int, int, int, int]:
    """Return the left, right, low and high ends of a convex piece, enlarged by a radius."""
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
    """Yield the part of a ring on one side of a line (Sutherland and Hodgman).

    `sides` are the distances of the vertices from the line in any unit, negative if clipped.
    """
    for k, (p, side) in enumerate(zip(ring, sides, strict=True)):
        q, before = ring[k - 1], sides[k - 1]
        if (side > 0 > before) or (side < 0 < before):
            share = Fraction(before) / (before - side)
            yield q[0] + share * (p[0] - q[0]), q[1] + share * (p[1] - q[1])
        if side >= 0:
            yield p
