"""Conversion of numbers to and from text, with ints of any length.

Python's conversions between int and str reject more than 4300 digits; Decimal has no limit.
"""

import re
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
from sys import int_info
from typing import Any

from exactsweep.numbers.error import NumberError, quote
from exactsweep.numbers.limits import get_limits

_EXACT = Context(prec=MAX_PREC, Emax=MAX_EMAX, Emin=MIN_EMIN, traps=[Inexact])

# The JSON number grammar, extended with fractions. Groups: whole part, denominator, decimals, sign
# of the exponent, digits of the exponent.
_NUMBER = re.compile(
    r"(-?(?:0|[1-9][0-9]*))"
    r"(?:/(0|[1-9][0-9]*)|(?:\.([0-9]+))?(?:[eE]([+-]?)0*([0-9]+))?)"
)

# 2**-d has d digits as a decimal, and d/3.32 digits in the denominator of a fraction.
_DIGITS_BEFORE_REDUCTION = 5

# Maximum length of a number displayed exactly, and the digits of a rounded one.
_SHOWN_DIGITS, _ROUNDED_DIGITS = 24, 12


def write_int(value: int) -> str:
    """Write an int of any length in decimal digits."""
    return str(Decimal(value))


def _read_int(text: str) -> int:
    """Read any number of decimal digits, after an optional minus sign. Cost: O(n^1.6)."""
    # int() accepts this many digits under every setting of the interpreter.
    if len(text) <= int_info.str_digits_check_threshold:
        return int(text)
    half = len(text) // 2
    high, low, base = _read_int(text[:-half]), _read_int(text[-half:]), int(10**half)
    return high * base + (-low if text.startswith("-") else low)


def read_ratio(text: str) -> tuple[int, int]:
    """Read a number as a numerator and a denominator in lowest terms; see `to_fraction`.

    >>> read_ratio("-1.5e-2")
    (-3, 200)
    """
    match = _NUMBER.fullmatch(text)
    if match is None:
        raise NumberError(f"{quote(text)} is not a number such as 3, -7/2, 0.125 or 1e-3")
    whole, denominator, decimals, sign, exponent = match.groups("")
    if denominator == "0":
        raise NumberError(f"{quote(text)} has a zero denominator")
    # An exponent of 16 digits or more exceeds every limit.
    places = len(decimals) - (int(sign + exponent[:16]) if exponent else 0)
    most, longest = get_limits().max_digits, 0
    if exponent or len(text) > most:
        # By (1) and (2) of `limits`.
        most = max(most, min(len(text), get_limits().answer_digits))
        digits = len((whole + decimals).removeprefix("-").lstrip("0") or "0")
        longest = max(digits - min(places, 0), places, len(denominator))
    # Reject the number before computing it, even if the reduced number would be short.
    if longest <= _DIGITS_BEFORE_REDUCTION * most:
        n, d = _read_int(whole + decimals), 1
        if denominator:
            d = _read_int(denominator)
        elif places:
            n, d = n * 10 ** max(-places, 0), 10 ** max(places, 0)
        if d > 1:
            common = gcd(n, d)
            n, d = n // common, d // common
        # The number has at most `longest` + 1 digits.
        if longest < most or max(abs(n), d) < 10**most:
            return n, d
    raise NumberError(f"{quote(text)} has more than {most} digits (max_digits)")


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
    # A lower bound; log10(2) is about 0.30103.
    exponent = bits * 30103 // 100000 - 1
    while Fraction(10) ** (exponent + 1) <= value:
        exponent += 1
    return exponent


def abridge(value: Fraction) -> str:
    """Format a number for display: exactly if that is short, else rounded, with a final "~".

    Float values are rounded to the decimal that Python writes, others to twelve digits.

    >>> abridge(Fraction(-7, 2)), abridge(Fraction(-(10**99))), abridge(Fraction(10**30 + 1, 10**9))
    ('-7/2', '-1e+99', '1000000000000000000000.000000001')
    >>> abridge(Fraction(0.1)), abridge(Fraction(10**30, 10**30 - 3)), abridge(Fraction(1, 7**99))
    ('0.1~', '1~', '2.16418328566e-84~')
    """
    text = format_fraction(value)
    if len(text) <= _SHOWN_DIGITS:
        return text
    with localcontext(_EXACT) as context:
        n, d = map(Decimal, value.as_integer_ratio())
        context.prec, context.traps[Inexact] = _SHOWN_DIGITS + 10, False
        text = _write_decimal(n / d)
        if len(text) <= context.prec and not context.flags[Inexact]:
            return text
        context.prec = _ROUNDED_DIGITS
        return f"{float(value)!r}~" if is_float(value) else f"{_write_decimal(n / d)}~"


def write_literal(value: Fraction) -> str:
    """Write a number as the Python source of an int, a float or a string of the same value.

    >>> [*map(write_literal, (Fraction(3), Fraction(1, 2), Fraction(0.1)))]
    ['3', "'1/2'", '0.1']
    """
    text = format_fraction(value)
    if len(text) > _SHOWN_DIGITS and is_float(value):
        return repr(float(value))
    return text if value.denominator == 1 else repr(text)


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
    """Round once to a float format specifier; raise ValueError for other specifiers.

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


def _write_decimal(value: Decimal) -> str:
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
