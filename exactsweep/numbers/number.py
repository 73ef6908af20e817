"""Reading and writing of coordinates: every accepted number becomes the equal `Fraction`.

Module `limits` defines the limits on untrusted input, and proves that they suffice for answers.
"""

import operator
import re
import sys
from collections.abc import Iterable, Sequence
from decimal import Decimal
from fractions import Fraction
from math import gcd
from numbers import Rational, Real
from operator import attrgetter

from exactsweep.numbers.digits import read_int, write_int
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.limits import answer_digits, get_max_digits, limits

_ECHO = 40

_new = object.__new__

# The slots of a Fraction; its properties, written in Python, take four times as long.
_numerator, _denominator = attrgetter("_numerator"), attrgetter("_denominator")

# JSON's grammar of numbers, and fractions.
_NUMBER = re.compile(
    r"(?P<sign>-?)(?P<whole>0|[1-9][0-9]*)"
    r"(?:/(?P<denominator>0|[1-9][0-9]*)"
    r"|(?:\.(?P<decimals>[0-9]+))?(?:[eE](?P<subtract>-?)\+?0*(?P<exponent>[0-9]+))?)"
)


_SHOWN_DIGITS = 24

# The number of digits that int() reads under every limit of the interpreter.
_SHORT = sys.int_info.str_digits_check_threshold


class NumberError(ExactSweepError):
    """A value that is not an exact rational number, or one beyond the limits."""


# 2**-d has d digits as a decimal, and d/3.32 digits in the denominator of a fraction.
_DIGITS_BEFORE_REDUCTION = 5


def to_fraction(value: object) -> Fraction:
    """Read a number exactly.

    Args:
        value: an int or anything with `__index__`; a `Fraction` or other `numbers.Rational` (of
            sympy and gmpy2, too); a `Decimal`; a float, taken as the binary value that it is; or a
            string: `-?(0|[1-9][0-9]*)`, and after it either `/` and a denominator, or, both
            optional, `.` with digits and `e` or `E` with a signed exponent, as in JSON.

    Returns:
        The same number as a Fraction.

    Raises:
        NumberError: bool, nan, infinities, complex, irrational or symbolic values, other types,
            strings outside the grammar, and strings and Decimals beyond `limits`. The function
            refuses them before it computes a number five times as long.

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
        return _from_string(value)
    if isinstance(value, float):
        return _from_real(value)
    if isinstance(value, Decimal):
        if not value.is_finite():
            raise NumberError(f"{quote(value)} is not a finite number")
        return _from_string(str(value))
    if isinstance(value, bool):
        raise NumberError(f"{value} is a truth value, not a number")
    # Before version 2, numpy lets its truth values be indices.
    if hasattr(value, "__index__") and type(value).__name__ != "bool_":
        try:
            return Fraction(operator.index(value))
        except TypeError:
            raise NumberError(f"{quote(value)} is not a number") from None
    if isinstance(value, Rational):
        numerator, denominator = int(value.numerator), int(value.denominator)
        if denominator == 0:
            raise NumberError(f"{quote(value)} has the denominator 0")
        return Fraction(numerator, denominator)
    if isinstance(value, Real):
        return _from_real(value)
    raise NumberError(f"{quote(value)} is not a rational number")


def _make_reduced(numerator: int, denominator: int) -> Fraction:
    """Make a Fraction of coprime ints, the second one positive.

    Fraction(n, d) spends 90% of its time on type checks and the greatest common divisor.
    """
    fraction = _new(Fraction)
    fraction._numerator = numerator  # type: ignore[attr-defined]
    fraction._denominator = denominator  # type: ignore[attr-defined]
    return fraction


def split_ratios(values: Sequence[Fraction]) -> tuple[list[int], list[int]]:
    """Return the numerators and the denominators of many numbers.

    Example:
        >>> split_ratios([Fraction(1, 2), Fraction(3)])
        ([1, 3], [2, 1])
    """
    return [*map(_numerator, values)], [*map(_denominator, values)]


def divide_exactly(value: int | Fraction, divisor: int | Fraction) -> Fraction:
    """Divide by a positive number; faster than `/` for two ints.

    Example:
        >>> divide_exactly(6, 4), divide_exactly(Fraction(1, 2), 3)
        (Fraction(3, 2), Fraction(1, 6))
    """
    if type(divisor) is int:
        if type(value) is int:
            common = gcd(value, divisor)
            return _make_reduced(value // common, divisor // common)
        if type(value) is Fraction:
            n, d = value.as_integer_ratio()
            common = gcd(n, divisor)
            return _make_reduced(n // common, d * (divisor // common))
    return Fraction(value, divisor)


def ratio(value: int | Fraction, divisor: int | Fraction) -> int | Fraction:
    """Divide by a positive number; the result is an int if it is whole.

    Example:
        >>> ratio(6, 3), ratio(6, 4)
        (2, Fraction(3, 2))
    """
    if type(value) is int and type(divisor) is int:
        common = gcd(value, divisor)
        if common == divisor:
            return value // common
        return _make_reduced(value // common, divisor // common)
    whole = value // divisor
    return whole if whole * divisor == value else divide_exactly(value, divisor)


def to_int(value: int | Fraction) -> int | Fraction:
    """Convert a whole number to an int, and return other numbers unchanged.

    Example:
        >>> to_int(Fraction(4, 2)), to_int(Fraction(1, 2))
        (2, Fraction(1, 2))
    """
    return value.numerator if value.denominator == 1 else value


def divide_all(values: Iterable[int | Fraction], divisor: int) -> list[Fraction]:
    """Divide numbers by a positive int; faster for ints.

    Example:
        >>> divide_all([3, Fraction(1, 2)], 1)
        [Fraction(3, 1), Fraction(1, 2)]
    """
    if divisor != 1:
        return [divide_exactly(v, divisor) for v in values]
    found: list[Fraction] = []
    for v in values:
        if type(v) is int:
            # As `_make_reduced` does, without the call.
            fraction = _new(Fraction)
            fraction._numerator = v  # type: ignore[attr-defined]
            fraction._denominator = 1  # type: ignore[attr-defined]
            found.append(fraction)
        else:
            found.append(v)  # type: ignore[arg-type]
    return found


def negate(value: int | Fraction) -> int | Fraction:
    """Change the sign; faster than `-` for Fractions.

    Example:
        >>> negate(Fraction(1, 2))
        Fraction(-1, 2)
    """
    if type(value) is Fraction:
        n, d = value.as_integer_ratio()
        return _make_reduced(-n, d)
    return -value


def add_to_all(value: int | Fraction, ints: Sequence[int | Fraction]) -> list[int | Fraction]:
    """Add a number to each of several others; faster for ints.

    Example:
        >>> add_to_all(Fraction(1, 2), [1, 2])
        [Fraction(3, 2), Fraction(5, 2)]
    """
    if isinstance(value, Fraction) and all(type(k) is int for k in ints):
        # n/d + k is in lowest terms if n/d is.
        n, d = value.as_integer_ratio()
        return [_make_reduced(n + k * d, d) for k in ints]  # type: ignore[arg-type]
    return [value + k for k in ints]


def find_simplest_fraction(a: int, b: int, c: int, d: int) -> tuple[int, int]:
    """Find the fraction of least numerator and denominator strictly between two fractions.

    Args:
        a: numerator of the lower bound, at least 0.
        b: its denominator, positive.
        c: numerator of the upper bound.
        d: its denominator; 0 for no upper bound.

    Returns:
        (p, q), where q/p is the fraction.

    Cost: O(k) divisions for bounds of k bits.

    >>> find_simplest_fraction(314, 100, 315, 100)
    (7, 22)
    """
    whole = a // b
    if (whole + 1) * d < c:
        return 1, whole + 1
    q, p = find_simplest_fraction(d, c - whole * d, b, a - whole * b)
    return p, q + whole * p


def read_any_length(text: str) -> Fraction:
    """Read a number of any length that is written out, as `to_fraction` does.

    Args:
        text: the output of `format_fraction`; the caller has checked its length.

    Example:
        >>> read_any_length("1" + "0" * 200_000) == 10**200_000
        True
    """
    if len(text) <= get_max_digits():
        return to_fraction(text)
    with limits(max_digits=len(text)):
        return to_fraction(text)


def format_fraction(value: Fraction) -> str:
    """Write a number exactly, as `to_fraction` reads it.

    Args:
        value: any Fraction, of any number of digits.

    Returns:
        `"-7/2"`, or `"3"` when the denominator is one.

    Example:
        >>> format_fraction(Fraction(-7, 2))
        '-7/2'
    """
    numerator = write_int(value.numerator)
    return numerator if value.denominator == 1 else f"{numerator}/{write_int(value.denominator)}"


def _from_string(text: str) -> Fraction:
    if len(text) <= _SHORT and text.isascii() and len(text) <= get_max_digits():
        digits = text.removeprefix("-")
        # Most numbers are integers, decimals without an exponent, or fractions.
        whole, point, decimals = digits.partition(".")
        whole, slash, below = whole.partition("/")
        if whole.isdecimal() and (whole[0] != "0" or whole == "0"):
            if whole == digits:
                return _make_reduced(int(text), 1)
            n = d = 0
            if decimals.isdecimal() and not slash:
                n, d = int(whole + decimals), 10 ** len(decimals)
            elif below.isdecimal() and below[0] != "0" and not point:
                n, d = int(whole), int(below)
            if d:
                common = gcd(n, d)
                n //= common
                return _make_reduced(-n if text.startswith("-") else n, d // common)
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


def _from_decimal(text: str, match: re.Match[str]) -> Fraction:
    sign, whole, decimals, exponent = match.group("sign", "whole", "decimals", "exponent")
    # Up to 15 digits, so that reading the exponent takes no time.
    if exponent is not None and len(exponent) > 15:
        raise _too_long(text)
    places = len(decimals or "") - int(f"{match['subtract'] or ''}{exponent or 0}")
    digits = f"{whole}{decimals or ''}".lstrip("0") or "0"
    # Refuse the number before computing it, even if the reduced number would be short.
    length = max(len(digits) - min(places, 0), places)
    if length > _DIGITS_BEFORE_REDUCTION * _allowed_digits(text):
        raise _too_long(text)
    number = read_int(sign + digits)
    return _check(text, Fraction(number * 10 ** max(-places, 0), 10 ** max(places, 0)))


def _from_real(value: float | Real) -> Fraction:
    try:
        binary = float(value)
        exact = _make_reduced(*binary.as_integer_ratio())
    except (OverflowError, ValueError):
        raise NumberError(f"{quote(value)} is not a finite number") from None
    if binary != value:
        raise NumberError(f"{quote(value)} has no exact value as a float; give it as a fraction")
    return exact


def _check(text: str, value: Fraction) -> Fraction:
    """Refuse a number that is too long in lowest terms."""
    most = _allowed_digits(text)
    longest = max(abs(value.numerator), value.denominator)
    # A bit is 0.30102999... digits.
    if longest.bit_length() * 30_103 > most * 100_000 and longest >= 10**most:
        raise _too_long(text)
    return value


def _allowed_digits(text: str) -> int:
    """Return the largest number of digits of a number, by 1 and 2 of `limits`."""
    return max(get_max_digits(), min(len(text), answer_digits()))


def _too_long(text: str) -> NumberError:
    return NumberError(f"{quote(text)} has more than {_allowed_digits(text)} digits (max_digits)")


def quote(value: object) -> str:
    """Write any value for a message: its repr, shortened if it is long.

    >>> quote("7" * 99)
    "'777777777777777777777777777777777777..."
    """
    try:
        text = repr(value)
    except Exception:  # a foreign repr may fail in any way; the refusal must still be readable
        text = f"<{type(value).__name__}>"
    if not text.isprintable():  # a foreign repr may hold anything
        text = "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text[:_ECHO])
    return text if len(text) <= _ECHO else f"{text[: _ECHO - 3]}..."


def abridge(value: Fraction) -> str:
    """Write a number for people: exactly, or its first digits if it is long.

    >>> abridge(Fraction(-7, 2)), abridge(Fraction(10**99))
    ('-7/2', '100000000000000000000...')
    """
    text = format_fraction(value)
    return text if len(text) <= _SHOWN_DIGITS else f"{text[: _SHOWN_DIGITS - 3]}..."
