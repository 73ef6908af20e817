"""Counts or measurements over doubling sizes, compared with a claimed bound.

A bound on a count is confirmed if the count divided by it stays flat or falls, and refuted if it
keeps rising. Times and bytes vary between runs: a bound on them is confirmed if their exponent over
the last sizes is not above that of the bound.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import log, log2
from operator import attrgetter
from statistics import linear_regression

Bound = tuple[str, Callable[[int, int], float]]
BOUNDS: dict[str, Bound] = {
    name: (name, bound)
    for name, bound in (
        ("m + n", lambda m, n: float(m + n)),
        ("(m + n) log m", lambda m, n: (m + n) * log2(m)),
        ("mn", lambda m, n: float(m * n)),
        ("2mn", lambda m, n: 2.0 * m * n),
        ("mn log m", lambda m, n: m * n * log2(m)),
        ("mn log n", lambda m, n: m * n * log2(n)),
        ("mn²", lambda m, n: float(m * n * n)),
        ("mn² log n", lambda m, n: m * n * n * log2(n)),
        ("m²n log mn", lambda m, n: m * m * n * log2(m * n)),
        ("(m - 6)²(n - 6)²", lambda m, n: float((m - 6) ** 2 * (n - 6) ** 2)),
    )
}
"""Bounds with their names."""
M_PLUS_N, MN, MN_LOG = (BOUNDS[name] for name in ("m + n", "mn", "mn log n"))

LIMITS = {"seconds": 0.6, "bytes": 0.5}
"""The most that the exponent of a measured quantity may exceed that of the bound.

A factor m or n too many shows as 1. Seconds are judged by the three largest sizes, which outgrow
caches; bytes by all, since ints take more of them as coordinates grow."""


FALL = 0.1
"""The most that the exponent of a count may fall below that of a bound that it attains.

Over the three largest sizes a factor log n too many in the bound shows as more.
"""


@dataclass(frozen=True)
class Size:
    """One size: m, n, what was counted or measured, and the bound."""

    m: int
    n: int
    count: float
    bound: float

    @property
    def ratio(self) -> float:
        """The count in units of the bound."""
        return self.count / self.bound


@dataclass(frozen=True)
class Growth:
    """A count over doubling sizes.

    Attributes:
        what: the counted quantity and its procedure; or "seconds" or "bytes" of one.
        family: the pairs.
        bound: the bound as text.
        points: one for each size.
        limit: the greatest factor by which the ratio may rise at the last doubling; or, if below 1,
            the most that the exponent over all sizes may exceed that of the bound. `LIMITS` has the
            limits for measured growths without their own.
        side: "upper", "lower" or "both", the kind of the bound.
    """

    what: str
    family: str
    bound: str
    points: tuple[Size, ...]
    limit: float = 1.08
    side: str = "upper"

    @property
    def varied(self) -> str:
        """The size that is doubled: "m", "n" or "m and n"."""
        first, last = self.points[0], self.points[-1]
        return " and ".join(x for x in "mn" if getattr(first, x) != getattr(last, x))

    @property
    def unit(self) -> str:
        """The unit of the count, without the procedure."""
        return self.what.partition(" ")[0]

    @property
    def judged(self) -> int:
        """The number of largest sizes over which the exponent is judged; 0 for all."""
        return 3 if self.unit == "seconds" else 0

    @property
    def last_rise(self) -> float:
        """The factor by which the ratio rose over the last doubling."""
        return self._ratios[-1] / self._ratios[-2]

    def exponent(self, last: int = 0) -> float:
        """Return the exponent of the count over all sizes, or over the last few."""
        return self._exponent([point.count for point in self.points], last)

    def claimed(self, last: int = 0) -> float:
        """The exponent of the bound, its logarithms included."""
        return self._exponent([point.bound for point in self.points], last)

    @property
    def sizes(self) -> list[int]:
        """The size that is doubled."""
        return [point.n if self.varied == "n" else point.m for point in self.points]

    @property
    def _ratios(self) -> list[float]:
        return [point.ratio for point in self.points]

    def _exponent(self, values: Sequence[float], last: int) -> float:
        return fit_exponent(self.sizes[-last:], values[-last:])

    def least(self, other: Growth) -> Growth:
        """Return the lesser count of two series at each size."""
        points = (
            min(p, q, key=attrgetter("count"))
            for p, q in zip(self.points, other.points, strict=True)
        )
        return replace(self, points=tuple(points))

    @property
    def is_flat(self) -> bool:
        """Decide whether the count is proportional to the bound, or below.

        A missing factor log n in the bound shows as 1.1 or more over a doubling.
        """
        if self.limit < 1 or self.unit in LIMITS:
            margin = self.limit if self.limit < 1 else LIMITS[self.unit]
            return self._exponent(self._ratios, self.judged) <= margin
        *before, last = self._ratios
        return last <= self.limit * max(before)

    @property
    def is_attained(self) -> bool:
        """Decide whether the count keeps up with the bound over the three largest sizes."""
        return self._exponent(self._ratios, 3) >= -FALL

    @property
    def verdict(self) -> str:
        """The finding: "rising", "in proportion" or "below"."""
        if not self.is_flat:
            return "rising"
        return "in proportion" if self.is_attained else "below"

    @property
    def failure(self) -> str:
        """Report that the ratio still rises, or falls below a lower bound; empty if neither."""
        if self.side != "upper" and not self.is_attained:
            return f"{self.what} on {self.family} fall below {self.bound}"
        if self.side == "lower" or self.is_flat:
            return ""
        return (
            f"{self.what} on {self.family}, {self.varied} doubled: divided by {self.bound} they "
            f"rose by a factor {self.last_rise:.2f} over the last doubling, with exponent "
            f"{self.exponent(3):.2f}, not {self.claimed(3):.2f}"
        )


def write_power(exponent: float) -> str:
    """Write an exponent with two decimals, 0 without a sign."""
    return f"{exponent:z.2f}"


def fit_exponent(sizes: Sequence[int], values: Sequence[float]) -> float:
    """Return the slope of the least squares line through the logarithms."""
    xs, ys = [log(size) for size in sizes], [log(max(value, 1e-9)) for value in values]
    return linear_regression(xs, ys).slope


def double(first: int, doublings: int) -> list[tuple[int, int]]:
    """List sizes m = n from a first one on, each twice the one before."""
    return [(first << k, first << k) for k in range(doublings + 1)]
