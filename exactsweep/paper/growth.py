"""Counted operations or vertices over doubling sizes, beside a claimed bound.

A bound is confirmed where the count divided by it stays flat or falls, and refuted as a bound
where it keeps rising.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class Point:
    """One size: m, n, what was counted, and the bound."""

    m: int
    n: int
    count: int
    bound: float

    @property
    def ratio(self) -> float:
        """The count in units of the bound."""
        return self.count / self.bound


@dataclass(frozen=True)
class Growth:
    """A count over doubling sizes.

    Attributes:
        what: what is counted, of which procedure.
        family: the pairs.
        bound: the bound as text.
        points: one for each size.
    """

    what: str
    family: str
    bound: str
    points: tuple[Point, ...]

    @property
    def last_rise(self) -> float:
        """By what factor the ratio rose over the last doubling."""
        return self.points[-1].ratio / self.points[-2].ratio

    def is_flat(self, limit: float = 1.08) -> bool:
        """Whether the ratio at the largest size is about the greatest before, or less.

        Over these doublings a factor log n too little in the bound shows as 1.1 or more.
        """
        return self.points[-1].ratio <= limit * max(point.ratio for point in self.points[:-1])

    @property
    def is_attained(self) -> bool:
        """Whether the ratio at the largest size has not fallen, so that the order is attained."""
        return self.points[-1].ratio >= 0.75 * min(point.ratio for point in self.points[:-1])

    def failure(self, limit: float = 1.08) -> str:
        """Say that the ratio still rises; empty if it is flat."""
        if self.is_flat(limit):
            return ""
        return (
            f"{self.what} on {self.family}: the count divided by {self.bound} rose by a factor "
            f"{self.last_rise:.2f} over the last doubling"
        )


def grow(
    what: str,
    family: str,
    bound: str,
    sizes: Iterable[tuple[int, int]],
    count: Callable[[int, int], tuple[int, float]],
) -> Growth:
    """Count at each size.

    Args:
        what: what is counted.
        family: the pairs.
        bound: the bound as text.
        sizes: pairs (m, n), each about twice the one before.
        count: of m and n; returns what was counted, and the value of the bound.

    Example:
        >>> squares = grow("squares", "ints", "m", [(2, 0), (4, 0)], lambda m, n: (m * m, m))
        >>> squares.last_rise, squares.is_flat()
        (2.0, False)
    """
    points = (Point(m, n, *count(m, n)) for m, n in sizes)
    return Growth(what, family, bound, tuple(points))


def double(first: int, doublings: int) -> list[tuple[int, int]]:
    """Sizes m = n from a first one on.

    >>> double(8, 2)
    [(8, 8), (16, 16), (32, 32)]
    """
    return [(first << k, first << k) for k in range(doublings + 1)]
