"""Exact numbers and points: every accepted number becomes the equal `Fraction`."""

from __future__ import annotations

import numbers
import operator
from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction
from math import gcd, isfinite, isqrt
from typing import NamedTuple

from exactsweep.numbers.digits import abridge, format_rounded, read_ratio, write_int
from exactsweep.numbers.error import NumberError, quote

_new = object.__new__


class Point(NamedTuple):
    """A point or translation of the plane."""

    x: Fraction
    y: Fraction

    def __repr__(self) -> str:
        """Return the standard repr, even for ints of more than 4300 digits."""
        return f"Point(x={_spell(self.x)}, y={_spell(self.y)})"

    def __str__(self) -> str:
        """Format the point for display, with long coordinates rounded."""
        return f"({abridge(Fraction(self.x))}, {abridge(Fraction(self.y))})"

    def __format__(self, spec: str) -> str:
        """Format both coordinates by a float format specifier, as in `f"{point:.3f}"`.

        >>> format(Point(Fraction(1, 3), Fraction(-2)), ".3f")
        '(0.333, -2.000)'
        """
        if not spec:
            return str(self)
        return f"({format_rounded(self.x, spec)}, {format_rounded(self.y, spec)})"


class Area(Fraction):
    """An area: a Fraction that formats like a float, as Fractions do from Python 3.12 on.

    >>> area = Area(Fraction(2, 3))
    >>> area, f"{area:.3f}", area * 2
    (Fraction(2, 3), '0.667', Fraction(4, 3))
    """

    __slots__ = ()

    def __repr__(self) -> str:
        return _spell(self)

    def __format__(self, spec: str) -> str:
        return format_rounded(self, spec) if spec else str(self)

    def __reduce__(self) -> tuple[type, tuple[int, int]]:
        return Fraction, (self.numerator, self.denominator)


def _spell(value: Fraction) -> str:
    return f"Fraction({write_int(value.numerator)}, {write_int(value.denominator)})"


ORIGIN = Point(Fraction(0), Fraction(0))


Rational = int | Fraction
Vertex = tuple[Rational, Rational]
Edge = tuple[Vertex, Vertex]
Loop = tuple[Point, ...]
"""The vertices of a closed polygonal line; the last vertex does not repeat the first."""
Fit = tuple[Point, Point]
"""The ends of an exact fit, which are equal for a single position."""
PointRings = Sequence[Sequence[Point]]
"""Rings; the last vertex of a ring does not repeat the first."""


def to_fraction(value: object) -> Fraction:
    """Read a number exactly.

    Args:
        value: an int or anything with `__index__`; a `Fraction` or other `numbers.Rational`, such
            as those of sympy and gmpy2; a `Decimal`; a float, read as its binary value; or a
            string: `-?(0|[1-9][0-9]*)`, followed by `/` and a denominator, or by an optional `.`
            with digits and an optional `e` or `E` with a signed exponent, as in JSON.

    Raises:
        NumberError: bool, nan, infinities, complex, irrational or symbolic values, other types,
            strings outside the grammar, and strings and Decimals beyond `limits`. Input
            beyond the limits is rejected before intermediate numbers exceed five times the limit.

    Cost: linear in the length of the input, times the cost of a multiplication of that length.

    Example:
        >>> to_fraction("-7/2"), to_fraction("1e-3"), to_fraction(0.1) == to_fraction("0.1")
        (Fraction(-7, 2), Fraction(1, 1000), False)
    """
    if type(value) is Fraction:
        return value
    if type(value) is int:
        return _make_reduced(value, 1)
    if isinstance(value, str):
        return _make_reduced(*read_ratio(value))
    if isinstance(value, Decimal) and value.is_finite():
        return _make_reduced(*read_ratio(str(value)))
    if isinstance(value, float) and isfinite(value):
        return _make_reduced(*value.as_integer_ratio())
    if isinstance(value, bool):
        raise NumberError(f"{value} is a bool, not a number")
    kind, exact = "rational", None
    try:
        # In numpy before version 2, bools have `__index__`.
        if hasattr(value, "__index__") and type(value).__name__ != "bool_":
            return Fraction(operator.index(value))
        if isinstance(value, numbers.Rational):
            return Fraction(int(value.numerator), int(value.denominator))
        if isinstance(value, float | Decimal | numbers.Real):
            kind = "finite"
            exact = Fraction(float(value))
    except (ArithmeticError, TypeError, ValueError):
        pass
    if exact is None:
        raise NumberError(f"{quote(value)} is not a {kind} number")
    if float(exact) != value:
        raise NumberError(f"{quote(value)} has no exact value as a float; give it as a fraction")
    return exact


def _make_reduced(numerator: int, denominator: int) -> Fraction:
    """Create a Fraction of coprime ints, the second one positive, in a tenth of the usual time."""
    fraction = _new(Fraction)
    fraction._numerator = numerator  # type: ignore[attr-defined]
    fraction._denominator = denominator  # type: ignore[attr-defined]
    return fraction


def divide(value: int, divisor: int) -> Fraction:
    """Divide by a positive int, twice as fast as `Fraction`."""
    if divisor == 1:
        return _make_reduced(value, 1)
    common = gcd(value, divisor)
    return _make_reduced(value // common, divisor // common)


def ratio(value: int | Fraction, divisor: int | Fraction) -> int | Fraction:
    """Divide by a positive number; the result is an int if it is whole.

    >>> ratio(6, 3), ratio(6, 4)
    (2, Fraction(3, 2))
    """
    whole = value // divisor
    return whole if whole * divisor == value else Fraction(value, divisor)


def find_root(square: Fraction) -> Fraction | None:
    """Find the square root of a nonnegative number; None if it is irrational.

    >>> find_root(Fraction(9, 4)), find_root(Fraction(2))
    (Fraction(3, 2), None)
    """
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return root if root * root == square else None


def find_simplest_fraction(a: int, b: int, c: int, d: int) -> tuple[int, int]:
    """Find the simplest fraction q/p strictly between a/b >= 0 and c/d, as (p, q).

    d = 0 means no upper bound. Cost: O(k) divisions for bounds of k bits.

    >>> find_simplest_fraction(314, 100, 315, 100)
    (7, 22)
    """
    whole = a // b
    if (whole + 1) * d < c:
        return 1, whole + 1
    q, p = find_simplest_fraction(d, c - whole * d, b, a - whole * b)
    return p, q + whole * p
