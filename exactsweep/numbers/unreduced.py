"""Fractions that are never reduced.

Validating a ring needs the signs of thousands of differences and products. A greatest common
divisor of n digits takes n^2 steps, a product n^1.6.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import total_ordering

from exactsweep.numbers.number import Vertex


@total_ordering
class Unreduced:
    """A quotient n / d of ints, d > 0; it compares with others and with 0."""

    __slots__ = ("d", "n")

    def __init__(self, n: int, d: int) -> None:
        self.n, self.d = n, d

    def __sub__(self, other: Unreduced) -> Unreduced:
        if self.d == other.d:
            return Unreduced(self.n - other.n, self.d)
        return Unreduced(self.n * other.d - other.n * self.d, self.d * other.d)

    def __mul__(self, other: Unreduced) -> Unreduced:
        return Unreduced(self.n * other.n, self.d * other.d)

    def __bool__(self) -> bool:
        return self.n != 0

    def _sign(self, other: Unreduced | int) -> int:
        """Return a number with the sign of the difference; an int operand must be 0."""
        return self.n if isinstance(other, int) else (self - other).n

    def __lt__(self, other: Unreduced | int) -> bool:
        return self._sign(other) < 0

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Unreduced | int) and self._sign(other) == 0

    def __hash__(self) -> int:
        return hash(Fraction(self.n, self.d))


def unreduced_points(points: Iterable[Vertex]) -> list[tuple[Unreduced, Unreduced]]:
    """Convert the coordinates of points."""
    return [(Unreduced(*x.as_integer_ratio()), Unreduced(*y.as_integer_ratio())) for x, y in points]
