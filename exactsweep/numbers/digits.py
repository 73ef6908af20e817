"""Numbers as texts: the grammar of numbers, and ints of any length in less than quadratic time.

Module `limits` defines the limits on untrusted input. Python's own conversions of ints take
quadratic time, and reject more than 4300 digits. This module splits a long number n = h b + l and
converts each half separately, where b is the square of the base of the halves: powers of two as
decimals, which multiply in nearly linear time, or powers of ten as ints (Karatsuba).
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
from typing import Any, TypeVar

from exactsweep.numbers.error import NumberError, quote
from exactsweep.numbers.limits import answer_digits, get_max_digits

_IntOrDecimal = TypeVar("_IntOrDecimal", int, Decimal)

# The length up to which a split is no faster.
_BITS, _DIGITS = 2**13, 2**11

_EXACT = Context(prec=MAX_PREC, Emax=MAX_EMAX, Emin=MIN_EMIN, traps=[Inexact])

# The JSON number grammar, extended with fractions.
_NUMBER = re.compile(
    r"(?P<sign>-?)(?P<whole>0|[1-9][0-9]*)"
    r"(?:/(?P<denominator>0|[1-9][0-9]*)"
    r"|(?:\.(?P<decimals>[0-9]+))?(?:[eE](?P<subtract>-?)\+?0*(?P<exponent>[0-9]+))?)"
)

# The number of digits that int() reads under every limit of the interpreter.
_SHORT = sys.int_info.str_digits_check_threshold

# 2**-d has d digits as a decimal, and d/3.32 digits in the denominator of a fraction.
_DIGITS_BEFORE_REDUCTION = 5

# The length of a number that people are shown exactly, and the digits of any other.
_SHOWN_DIGITS, _ROUNDED_DIGITS = 24, 12


def write_int(value: int) -> str:
    """Write an int of any length in decimal digits. Cost: O(n^1.6) for n digits."""
    if value.bit_length() <= _BITS:
        # The interpreter writes up to 640 digits under any limit, in a third of the time.
        return str(value) if value.bit_length() <= _DIGITS else str(Decimal(value))
    if value < 0:
        return f"-{write_int(-value)}"
    with localcontext(_EXACT):
        bases = _square(Decimal(2) ** _BITS, value.bit_length() // _BITS)
        return f"{_to_decimal(value, bases, len(bases)):f}"


def read_int(text: str) -> int:
    """Read any number of decimal digits, after an optional minus sign. Cost: O(n^1.6)."""
    if len(text) <= _DIGITS:
        return int(Decimal(text))
    if text[0] == "-":
        return -read_int(text[1:])
    bases = _square(10**_DIGITS, len(text) // _DIGITS)
    return _to_int(text, bases, len(bases))


def read_ratio(text: str) -> tuple[int, int]:
    """Read the numerator and the denominator, in lowest terms, of a number in a text.

    `to_fraction` documents the grammar, the errors and the cost.

    >>> read_ratio("-1.5e-2")
    (-3, 200)
    """
    if len(text) <= _SHORT and text.isascii() and len(text) <= get_max_digits():
        digits = text.removeprefix("-")
        # Most numbers are integers, decimals without an exponent, or fractions.
        whole, point, decimals = digits.partition(".")
        whole, slash, below = whole.partition("/")
        if whole.isdecimal() and (whole[0] != "0" or whole == "0"):
            if whole == digits:
                return int(text), 1
            n = d = 0
            if decimals.isdecimal() and not slash:
                n, d = int(whole + decimals), 10 ** len(decimals)
            elif below.isdecimal() and below[0] != "0" and not point:
                n, d = int(whole), int(below)
            if d:
                common = gcd(n, d)
                n //= common
                return -n if text.startswith("-") else n, d // common
    match = _NUMBER.fullmatch(text)
    if match is None:
        raise NumberError(f"{quote(text)} is not a number such as 3, -7/2, 0.125 or 1e-3")
    whole, denominator = match["whole"], match["denominator"]
    if denominator is None:
        return _from_decimal(text, match)
    if denominator == "0":
        raise NumberError(f"{quote(text)} has a zero denominator")
    if max(len(whole), len(denominator)) > answer_digits():
        raise _too_long(text)
    return _check(text, Fraction(read_int(match["sign"] + whole), read_int(denominator)))


def format_fraction(value: Fraction) -> str:
    """Write a number of any length exactly, as `to_fraction` reads it.

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
    # log10(2) is a little more than 3/10; the loops correct the rest.
    exponent = bits * 30103 // 100000
    while Fraction(10) ** exponent > value:
        exponent -= 1
    while Fraction(10) ** (exponent + 1) <= value:
        exponent += 1
    return exponent


def abridge(value: Fraction) -> str:
    """Write a number for people: exactly if that is short, else rounded, with the mark "~".

    A float is rounded to the decimal that Python writes for it, any other number to twelve digits.

    >>> abridge(Fraction(-7, 2)), abridge(Fraction(-(10**99))), abridge(Fraction(10**30 + 1, 10**9))
    ('-7/2', '-1e+99', '1000000000000000000000.000000001')
    >>> abridge(Fraction(0.1)), abridge(Fraction(10**30, 10**30 - 3)), abridge(Fraction(1, 7**99))
    ('0.1~', '1~', '2.16418328566e-84~')
    """
    text = format_fraction(value)
    if len(text) <= _SHOWN_DIGITS:
        return text
    if max(value.numerator.bit_length(), value.denominator.bit_length()) <= _BITS:
        rounded = _round(value, _SHOWN_DIGITS + 10)
        text = _write_decimal(rounded)
        if len(text) <= _SHOWN_DIGITS + 10 and rounded == value:
            return text
    if is_float(value):
        return f"{float(value)!r}~"
    return f"{_write_decimal(_round(value, _ROUNDED_DIGITS))}~"


def write_literals(values: Iterable[Fraction]) -> str | None:
    """Write numbers as a tuple that Python reads back to the same values; None if one is long.

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
    """Write a number in a format of floats, rounded once; raise ValueError for other formats.

    >>> format_rounded(Fraction(2, 3), ".3f"), format_rounded(Fraction(10**40, 3), ".2e")
    ('0.667', '3.33e+39')
    """
    places = re.search(r"\.([0-9]+)", spec)
    whole = max(0, value.numerator.bit_length() - value.denominator.bit_length()) // 3
    return format(_divide(value, whole + int(places[1] if places else 6) + 10), spec)


def _divide(value: Fraction | int, digits: int) -> Decimal:
    """Return a quotient with some digits, so that rounding to fewer digits is correct."""
    with localcontext(_EXACT) as context:
        context.prec, context.rounding, context.traps[Inexact] = digits, ROUND_05UP, False
        return Decimal(value.numerator) / Decimal(value.denominator)


def _round(value: Fraction, digits: int) -> Decimal:
    """Round a number to some digits; exact if it has no more and is not very long."""
    # The conversion of an int to a Decimal takes quadratic time.
    n, d = value.as_integer_ratio()
    cut, below = (max(0, number.bit_length() - _BITS) for number in (n, d))
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
    """Turn Fractions into strings and tuples into lists, at any depth of lists and dicts.

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


def _square(base: _IntOrDecimal, times: int) -> list[_IntOrDecimal]:
    """List the base and its repeated squares, as far as a length needs them."""
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


def _from_decimal(text: str, match: re.Match[str]) -> tuple[int, int]:
    sign, whole, decimals, exponent = match.group("sign", "whole", "decimals", "exponent")
    # Up to 15 digits, so that reading the exponent takes no time.
    if exponent is not None and len(exponent) > 15:
        raise _too_long(text)
    places = len(decimals or "") - int(f"{match['subtract'] or ''}{exponent or 0}")
    digits = f"{whole}{decimals or ''}".lstrip("0") or "0"
    # Reject the number before computing it, even if the reduced number would be short.
    length = max(len(digits) - min(places, 0), places)
    if length > _DIGITS_BEFORE_REDUCTION * _allowed_digits(text):
        raise _too_long(text)
    number = read_int(sign + digits)
    return _check(text, Fraction(number * 10 ** max(-places, 0), 10 ** max(places, 0)))


def _check(text: str, value: Fraction) -> tuple[int, int]:
    most = _allowed_digits(text)
    longest = max(abs(value.numerator), value.denominator)
    # A bit is 0.30102999... digits.
    if longest.bit_length() * 30_103 > most * 100_000 and longest >= 10**most:
        raise _too_long(text)
    return value.numerator, value.denominator


def _allowed_digits(text: str) -> int:
    """Return the largest number of digits of a number, by 1 and 2 of `limits`."""
    return max(get_max_digits(), min(len(text), answer_digits()))


def _too_long(text: str) -> NumberError:
    return NumberError(f"{quote(text)} has more than {_allowed_digits(text)} digits (max_digits)")
