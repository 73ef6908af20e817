"""Long numbers with intervals of ints, which decide most comparisons.

A cross product of coordinates with thousands of digits takes milliseconds, and the test of a ring
needs thousands of signs. So each number has an interval of ints that contains the number times a
scale, the same for all coordinates of a ring. Interval arithmetic encloses differences and
products.
(1) Disjoint intervals decide the comparison. (2) Otherwise the numbers are computed as unreduced
quotients of ints: a greatest common divisor of n digits takes n^2 steps, a product n^1.6. Numbers
are comparable only if they have the same degree in the coordinates, and so the same scale;
geometric predicates never compare others.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import total_ordering

from exactsweep.numbers.number import Vertex

# Bits of the interval ends of the largest coordinate.
_BITS = 256

_Ratio = tuple[int, int]


@total_ordering
class LazyNumber:
    """A number that is computed only if its interval does not decide a comparison."""

    __slots__ = ("_compute", "_high", "_low", "_ratio")

    def __init__(self, low: int, high: int, compute: Callable[[], _Ratio]) -> None:
        self._low, self._high, self._compute = low, high, compute
        self._ratio: _Ratio | None = None

    def _exact(self) -> _Ratio:
        if self._ratio is None:
            self._ratio = self._compute()
        return self._ratio

    def __sub__(self, other: LazyNumber) -> LazyNumber:
        def difference() -> _Ratio:
            (n, d), (m, e) = self._exact(), other._exact()
            return (n - m, d) if d == e else (n * e - m * d, d * e)

        return LazyNumber(self._low - other._high, self._high - other._low, difference)

    def __mul__(self, other: LazyNumber) -> LazyNumber:
        def product() -> _Ratio:
            (n, d), (m, e) = self._exact(), other._exact()
            return n * m, d * e

        a, b, c, d = self._low, self._high, other._low, other._high
        ends = a * c, a * d, b * c, b * d
        return LazyNumber(min(ends), max(ends), product)

    def _sign(self, other: LazyNumber | int) -> int:
        """Return the difference times a positive number; an int operand must be 0."""
        low, high = (0, 0) if isinstance(other, int) else (other._low, other._high)
        if self._low > high:
            return 1
        if self._high < low:
            return -1
        n, d = self._exact()
        if isinstance(other, int):
            return n
        m, e = other._exact()
        return n - m if d == e else n * e - m * d

    def __lt__(self, other: LazyNumber | int) -> bool:
        return self._sign(other) < 0

    def __eq__(self, other: object) -> bool:
        return isinstance(other, LazyNumber | int) and self._sign(other) == 0

    def __hash__(self) -> int:
        return hash(Fraction(*self._exact()))


def lazy_points(points: Sequence[Vertex]) -> list[tuple[LazyNumber, LazyNumber]]:
    """Convert points to lazy numbers, all with the same scale."""
    # The approximate number of bits of the integral part, negative for small numbers.
    sizes = (c.numerator.bit_length() - c.denominator.bit_length() for p in points for c in p if c)
    shift = _BITS - max(sizes, default=0)

    def lazy(value: int | Fraction) -> LazyNumber:
        n, d = value.as_integer_ratio()
        scaled = n << shift if shift > 0 else n
        low = scaled // (d if shift > 0 else d << -shift)
        return LazyNumber(low, low + 1, lambda: (n, d))

    return [(lazy(x), lazy(y)) for x, y in points]
