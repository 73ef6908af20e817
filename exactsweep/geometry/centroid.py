"""The centroid of a ring."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.number import Point


def find_centroid(ring: Sequence[Point]) -> Point:
    """Find the center of mass of the area in a ring; the first point of a ring without area.

    Cost: O(n).

    Example:
        >>> from exactsweep import Polygon
        >>> print(*find_centroid(Polygon([(0, 0), (3, 0), (0, 6)]).vertices))
        1 2
    """
    double = Fraction(find_doubled_area(ring))
    if not double:
        return ring[0]
    edges = [*zip(ring, (*ring[1:], ring[0]), strict=True)]
    weights = [p.x * q.y - p.y * q.x for p, q in edges]
    x, y = (
        add_up((p[k] + q[k]) * weight for (p, q), weight in zip(edges, weights, strict=True))
        for k in (0, 1)
    )
    return Point(x / (3 * double), y / (3 * double))
