"""Conversion of numbers to and from text, with ints of any length.

Python's conversions between int and str reject more than 4300 digits; those of Decimal do not.
"""

import re
import sys
from collections.abc import Iterable
from decimal import (
    MAX_EMAX,
    MAX_PREC,
    MIN_EMIN,
    ROUND_05UP,
    Context,
    Decimal,
    Inexact,
    localcontext,
)
from fractions import Fraction
from math import gcd
from typing import Any

from exactsweep.numbers.error import NumberError, quote
from exactsweep.numbers.limits import answer_digits, get_max_digits

_EXACT = Context(prec=MAX_PREC, Emax=MAX_EMAX, Emin=MIN_EMIN, traps=[Inexact])

# The JSON number grammar, extended with fractions. Groups: whole part, denominator, decimals, sign
# of the exponent, digits of the exponent.
_NUMBER = re.compile(
    r"(-?(?:0|[1-9][0-9]*))"
    r"(?:/(0|[1-9][0-9]*)|(?:\.([0-9]+))?(?:[eE]([+-]?)0*([0-9]+))?)"
)

# Below this length, splitting does not help.
_READ_DIGITS = 2**11

# int() accepts this many digits under every setting of the interpreter.
_SHORT = sys.int_info.str_digits_check_threshold

# 2**-d has d digits as a decimal, and d/3.32 digits in the denominator of a fraction.
_DIGITS_BEFORE_REDUCTION = 5

# Maximum length of a number displayed exactly, and the digits of a rounded one.
_SHOWN_DIGITS, _ROUNDED_DIGITS = 24, 12

# Numbers up to this length may be displayed exactly as decimals, such as powers of ten.
_LONG_BITS = 2**13


def write_int(value: int) -> str:
    """Write an int of any length in decimal digits."""
    return str(Decimal(value))


def read_int(text: str) -> int:
    """Read any number of decimal digits, after an optional minus sign. Cost: O(n^1.6)."""
    if len(text) <= _READ_DIGITS:
        return int(Decimal(text))
    half = len(text) // 2
    high, low, base = read_int(text[:-half]), read_int(text[-half:]), int(10**half)
    return high * base + (-low if text.startswith("-") else low)


def read_ratio(text: str) -> tuple[int, int]:
    """Read a number as a numerator and a denominator in lowest terms; see `to_fraction`.

    >>> read_ratio("-1.5e-2")
    (-3, 200)
    """
    match = _NUMBER.fullmatch(text)
    if match is None:
        raise NumberError(f"{quote(text)} is not a number such as 3, -7/2, 0.125 or 1e-3")
    whole, denominator, decimals, sign, exponent = match.groups()
    if denominator == "0":
        raise NumberError(f"{quote(text)} has a zero denominator")
    if exponent is None and len(text) <= min(_SHORT, get_max_digits()):
        if decimals is None and denominator is None:
            return int(whole), 1
        n, d = int(whole + (decimals or "")), int(denominator or 10 ** len(decimals))
        common = gcd(n, d)
        return n // common, d // common
    if denominator is None:
        return _read_decimal(text, whole, decimals or "", sign or "", exponent or "0")
    if max(len(whole.removeprefix("-")), len(denominator)) > answer_digits():
        raise _too_long(text)
    return _check(text, Fraction(read_int(whole), read_int(denominator)))


def format_fraction(value: Fraction) -> str:
    """Write a number of any length exactly, in the grammar of `to_fraction`.

    >>> format_fraction(Fraction(-7, 2))
    '-7/2'
    """
    numerator = write_int(value.numerator)
    return numerator if value.denominator == 1 else f"{numerator}/{write_int(value.denominator)}"


def find_magnitude(value: Fraction) -> int:
    """Find the exponent of the greatest power of ten up to a positive number.

    >>> find_magnitude(Fraction(1000)), find_magnitude(Fraction(1, 3))
    (3, -1)
    """
    bits = value.numerator.bit_length() - value.denominator.bit_length()
    # log10(2) is about 0.30103; the loops correct the error.
    exponent = bits * 30103 // 100000
    while Fraction(10) ** exponent > value:
        exponent -= 1
    while Fraction(10) ** (exponent + 1) <= value:
        exponent += 1
    return exponent


def abridge(value: Fraction) -> str:
    """Format a number for display: exactly if that is short, else rounded, with a final "~".

    Values of floats become the decimal that Python writes for them, others have twelve digits.

    >>> abridge(Fraction(-7, 2)), abridge(Fraction(-(10**99))), abridge(Fraction(10**30 + 1, 10**9))
    ('-7/2', '-1e+99', '1000000000000000000000.000000001')
    >>> abridge(Fraction(0.1)), abridge(Fraction(10**30, 10**30 - 3)), abridge(Fraction(1, 7**99))
    ('0.1~', '1~', '2.16418328566e-84~')
    """
    text = format_fraction(value)
    if len(text) <= _SHOWN_DIGITS:
        return text
    if max(value.numerator.bit_length(), value.denominator.bit_length()) <= _LONG_BITS:
        rounded = _round(value, _SHOWN_DIGITS + 10)
        text = _write_decimal(rounded)
        if len(text) <= _SHOWN_DIGITS + 10 and rounded == value:
            return text
    if is_float(value):
        return f"{float(value)!r}~"
    return f"{_write_decimal(_round(value, _ROUNDED_DIGITS))}~"


def write_literals(values: Iterable[Fraction]) -> str | None:
    """Write numbers as the source of a Python tuple of the same values; None if one is long.

    >>> write_literals([Fraction(3), Fraction(1, 2), Fraction(0.1)])
    "(3, '1/2', 0.1)"
    """
    literals = []
    for value in values:
        text = format_fraction(value)
        if len(text) <= _SHOWN_DIGITS:
            literals.append(text if value.denominator == 1 else repr(text))
        elif is_float(value):
            literals.append(repr(float(value)))
        else:
            return None
    return f"({', '.join(literals)})"


def is_float(value: Fraction) -> bool:
    """Decide whether a number is the value of a float.

    >>> is_float(Fraction(0.1)), is_float(Fraction(1, 10)), is_float(Fraction(2**5000))
    (True, False, False)
    """
    try:
        return float(value) == value
    except OverflowError:
        return False


def format_rounded(value: Fraction | int, spec: str) -> str:
    """Format a number by a float format specifier, rounding once; raise ValueError for others.

    >>> format_rounded(Fraction(2, 3), ".3f"), format_rounded(Fraction(10**40, 3), ".2e")
    ('0.667', '3.33e+39')
    """
    places = re.search(r"\.([0-9]+)", spec)
    whole = max(0, value.numerator.bit_length() - value.denominator.bit_length()) // 3
    return format(_divide(value, whole + int(places[1] if places else 6) + 10), spec)


def _divide(value: Fraction | int, digits: int) -> Decimal:
    """Divide with the given number of digits, so that rounding to fewer digits is correct."""
    with localcontext(_EXACT) as context:
        context.prec, context.rounding, context.traps[Inexact] = digits, ROUND_05UP, False
        return Decimal(value.numerator) / Decimal(value.denominator)


def _round(value: Fraction, digits: int) -> Decimal:
    """Round a number to a number of digits; exact if it has no more and is not very long."""
    # The conversion of an int to a Decimal takes quadratic time.
    n, d = value.as_integer_ratio()
    cut, below = (max(0, number.bit_length() - _LONG_BITS) for number in (n, d))
    with localcontext(_EXACT) as context:
        context.prec, context.traps[Inexact] = 3 * digits, False
        quotient = _divide(Fraction(n >> cut, d >> below), 3 * digits)
        if cut or below:
            quotient *= Decimal(2) ** (cut - below)
        context.prec = digits
        return +quotient


def _write_decimal(value: Decimal) -> str:
    with localcontext(_EXACT):
        value = value.normalize()
    return f"{value:f}" if -7 <= value.adjusted() <= 20 else str(value).lower()


def to_plain(data: dict[str, Any]) -> dict[str, Any]:
    """Convert Fractions to strings and tuples to lists, at any depth.

    >>> to_plain({"at": (Fraction(1, 3), Fraction(2)), "number": 2})
    {'at': ['1/3', '2'], 'number': 2}
    """
    return {name: _write(value) for name, value in data.items()}


def _write(value: Any) -> Any:
    if isinstance(value, Fraction):
        return format_fraction(value)
    if isinstance(value, dict):
        return to_plain(value)
    return [*map(_write, value)] if isinstance(value, list | tuple) else value


def _read_decimal(
    text: str, whole: str, decimals: str, sign: str, exponent: str
) -> tuple[int, int]:
    # Reading an exponent of up to 15 digits takes no time.
    if len(exponent) > 15:
        raise _too_long(text)
    places = len(decimals) - int(sign + exponent)
    digits = f"{whole}{decimals}".removeprefix("-").lstrip("0")
    # Reject the number before computing it, even if the reduced number would be short.
    length = max(len(digits or "0") - min(places, 0), places)
    if length > _DIGITS_BEFORE_REDUCTION * _allowed_digits(text):
        raise _too_long(text)
    number = read_int(whole + decimals)
    return _check(text, Fraction(number * 10 ** max(-places, 0), 10 ** max(places, 0)))


def _check(text: str, value: Fraction) -> tuple[int, int]:
    most = _allowed_digits(text)
    longest = max(abs(value.numerator), value.denominator)
    # A bit is 0.30102999... digits.
    if longest.bit_length() * 30_103 > most * 100_000 and longest >= 10**most:
        raise _too_long(text)
    return value.numerator, value.denominator


def _allowed_digits(text: str) -> int:
    """Return the maximum number of digits of a number, by (1) and (2) of `limits`."""
    return max(get_max_digits(), min(len(text), answer_digits()))


def _too_long(text: str) -> NumberError:
    return NumberError(f"{quote(text)} has more than {_allowed_digits(text)} digits (max_digits)")
