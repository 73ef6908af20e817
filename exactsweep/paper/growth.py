"""Counts and measurements over doubling sizes, compared with a claimed bound.

A bound on a count is confirmed if the ratio of count and bound stays flat or falls, and refuted if
it keeps rising. Times and bytes vary between runs, so their bounds are compared by exponents.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import log, log2
from operator import attrgetter
from statistics import linear_regression
from typing import Self

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
M_PLUS_N, MN, MN_LOG = (BOUNDS[name] for name in ("m + n", "mn", "mn log n"))

LIMITS = {"seconds": 0.6, "bytes": 0.5}
"""Maximum excess of a measured exponent over the exponent of the bound.

A missing factor m or n shows as 1. The exponent of seconds uses the three largest sizes, which
exceed the caches; the exponent of bytes uses all sizes, since ints grow with the coordinates.
"""

FALL = 0.1
"""How far the exponent of a count that attains its bound may be below the exponent of the bound.

Over the three largest sizes, a superfluous factor log n in the bound exceeds it.
"""


@dataclass(frozen=True)
class Size:
    m: int
    n: int
    count: float
    bound: float

    @property
    def ratio(self) -> float:
        return self.count / self.bound


@dataclass(frozen=True)
class Growth:
    """A count over doubling sizes.

    Attributes:
        what: the counted quantity and its procedure, as in "seconds of SweepO_CM".
        limit: if at least 1, the factor by which the ratio may rise in the last doubling; if less,
            the maximum excess over the exponent of the bound. Measured quantities use `LIMITS` by
            default.
        side: the kind of bound, "upper", "lower" or "both".
    """

    what: str
    family: str
    bound: str
    points: tuple[Size, ...]
    limit: float = 1.08
    side: str = "upper"

    @property
    def varied(self) -> str:
        first, last = self.points[0], self.points[-1]
        return " and ".join(x for x in "mn" if getattr(first, x) != getattr(last, x))

    @property
    def unit(self) -> str:
        return self.what.partition(" ")[0]

    @property
    def fitted_sizes(self) -> int:
        """How many of the largest sizes the exponent is fitted to; 0 means all."""
        return 3 if self.unit == "seconds" else 0

    @property
    def last_rise(self) -> float:
        return self._ratios[-1] / self._ratios[-2]

    def exponent(self, last: int = 0) -> float:
        """Return the exponent of the count over all sizes, or over the last few."""
        return self._exponent([point.count for point in self.points], last)

    def claimed(self, last: int = 0) -> float:
        """Return the exponent of the bound, which logarithmic factors raise."""
        return self._exponent([point.bound for point in self.points], last)

    @property
    def sizes(self) -> list[int]:
        return [point.n if self.varied == "n" else point.m for point in self.points]

    @property
    def _ratios(self) -> list[float]:
        return [point.ratio for point in self.points]

    def _exponent(self, values: Sequence[float], last: int) -> float:
        return fit_exponent(self.sizes[-last:], values[-last:])

    def take_minima(self, other: Self) -> Self:
        points = (
            min(p, q, key=attrgetter("count"))
            for p, q in zip(self.points, other.points, strict=True)
        )
        return replace(self, points=tuple(points))

    @property
    def is_flat(self) -> bool:
        if self.limit < 1 or self.unit in LIMITS:
            margin = self.limit if self.limit < 1 else LIMITS[self.unit]
            return self._exponent(self._ratios, self.fitted_sizes) <= margin
        # A missing factor log n in the bound shows as 1.1 or more in one doubling.
        *before, last = self._ratios
        return last <= self.limit * max(before)

    @property
    def is_attained(self) -> bool:
        return self._exponent(self._ratios, 3) >= -FALL

    @property
    def verdict(self) -> str:
        if not self.is_flat:
            return "rising"
        return "in proportion" if self.is_attained else "below"

    @property
    def failure(self) -> str:
        if self.side != "upper" and not self.is_attained:
            return f"{self.what} on {self.family} fall below {self.bound}"
        if self.side == "lower" or self.is_flat:
            return ""
        return (
            f"{self.what} on {self.family}, {self.varied} doubled: the ratio to {self.bound} rose "
            f"by a factor {self.last_rise:.2f} in the last doubling, with exponent "
            f"{self.exponent(3):.2f} instead of {self.claimed(3):.2f}"
        )


def write_power(exponent: float) -> str:
    """Format an exponent with two decimals, without a negative zero."""
    return f"{exponent:z.2f}"


def fit_exponent(sizes: Sequence[int], values: Sequence[float]) -> float:
    xs, ys = [log(size) for size in sizes], [log(max(value, 1e-9)) for value in values]
    return linear_regression(xs, ys).slope


def double(first: int, doublings: int) -> list[tuple[int, int]]:
    return [(first << k, first << k) for k in range(doublings + 1)]
