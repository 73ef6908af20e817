"""Conversion between long ints and decimal digits in less than quadratic time.

Python's own conversions take quadratic time, and refuse more than 4300 digits. This module splits a
long number n = h b + l and converts each half by itself, where b is the square of the base of the
halves. To write, it uses powers of two as decimals, which multiply in nearly linear time. To read,
it uses powers of ten as ints, which multiply by Karatsuba's method.
"""

from decimal import MAX_EMAX, MAX_PREC, MIN_EMIN, Context, Decimal, Inexact, localcontext
from typing import TypeVar

_IntOrDecimal = TypeVar("_IntOrDecimal", int, Decimal)

# The length up to which a split is no faster.
_BITS, _DIGITS = 2**13, 2**11

_EXACT = Context(prec=MAX_PREC, Emax=MAX_EMAX, Emin=MIN_EMIN, traps=[Inexact])


def write_int(value: int) -> str:
    """Write an int of any length in decimal digits.

    Cost: O(n^1.6) for n digits.

    Example:
        >>> write_int(-(10**5000)) == "-1" + "0" * 5000
        True
    """
    if value.bit_length() <= _BITS:
        # The interpreter writes up to 640 digits under any limit, in a third of the time.
        return str(value) if value.bit_length() <= _DIGITS else str(Decimal(value))
    if value < 0:
        return f"-{write_int(-value)}"
    with localcontext(_EXACT):
        bases = _square(Decimal(2) ** _BITS, value.bit_length() // _BITS)
        return f"{_to_decimal(value, bases, len(bases)):f}"


def read_int(text: str) -> int:
    """Read any number of decimal digits, perhaps after a minus sign.

    Cost: O(n^1.6) for n digits.

    Example:
        >>> read_int("-1" + "0" * 5000) == -(10**5000)
        True
    """
    if len(text) <= _DIGITS:
        return int(Decimal(text))
    if text[0] == "-":
        return -read_int(text[1:])
    bases = _square(10**_DIGITS, len(text) // _DIGITS)
    return _to_int(text, bases, len(bases))


def _square(base: _IntOrDecimal, times: int) -> list[_IntOrDecimal]:
    """List the base, its square, the square of that and so on, as far as a length needs them."""
    bases = [base]
    while 2 ** len(bases) <= times:
        bases.append(bases[-1] * bases[-1])
    return bases


def _to_decimal(value: int, bases: list[Decimal], depth: int) -> Decimal:
    if depth == 0:
        return Decimal(value)
    bits = _BITS << depth - 1
    high = value >> bits
    low = _to_decimal(value - (high << bits), bases, depth - 1)
    return _to_decimal(high, bases, depth - 1) * bases[depth - 1] + low if high else low


def _to_int(text: str, bases: list[int], depth: int) -> int:
    if depth == 0:
        return int(Decimal(text))
    digits = _DIGITS << depth - 1
    low = _to_int(text[-digits:], bases, depth - 1)
    high = text[:-digits]
    return _to_int(high, bases, depth - 1) * bases[depth - 1] + low if high else low
