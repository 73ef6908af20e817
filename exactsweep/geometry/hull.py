"""The convex hull of points (Andrew's monotone chain)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeVar

from exactsweep.geometry.vectors import turn
from exactsweep.numbers.number import Vertex

P = TypeVar("P", bound=Vertex)


def find_hull(points: Iterable[P]) -> list[P]:
    """Find the convex hull of points.

    Args:
        points: pairs of numbers; some may be equal.

    Returns:
        The corners, counter-clockwise from the least one; two if the points are collinear, and none
        if they are equal.

    Cost: O(n log n).

    Example:
        >>> find_hull([(0, 0), (4, 0), (1, 1), (2, 0), (0, 4)])
        [(0, 0), (4, 0), (0, 4)]
    """
    ordered = sorted(set(points))
    found: list[P] = []
    for run in ordered, ordered[::-1]:
        half: list[P] = []
        for point in run:
            while len(half) > 1 and turn(half[-2], half[-1], point) <= 0:
                half.pop()
            half.append(point)
        found += half[:-1]
    return found
