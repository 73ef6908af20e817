"""Exact reading and writing of decimal numbers."""

import re
from contextlib import suppress
from fractions import Fraction
from math import ceil, log2

from exactsweep.formats.error import FormatError
from exactsweep.numbers.digits import abridge, format_fraction, write_int
from exactsweep.numbers.error import NumberError, quote
from exactsweep.numbers.number import Point, to_fraction

# The pattern of `read_decimal`; possessive, to reject long numbers in linear time.
DECIMAL = r"[+-]?(?:[0-9]++\.?+[0-9]*+|\.[0-9]++)(?:[eE][+-]?[0-9]++)?+"
_DECIMAL = re.compile(DECIMAL)
_DECIMALS = re.compile(rf"(?:[\s,]*+{DECIMAL})*+[\s,]*+")
_SHOWN = 10
_PARTS = re.compile(r"(-?)\+?([0-9.]*)(.*)")


def read_decimal(text: str) -> Fraction:
    """Read a decimal of WKT, SVG or DXF; raises FormatError for anything else.

    >>> read_decimal("+.5"), read_decimal("007.e-2")
    (Fraction(1, 2), Fraction(7, 100))
    """
    try:
        if "/" not in text:
            return to_fraction(text)
    except NumberError:
        # Not JSON syntax, or too long; the second attempt reports that.
        pass
    if not _DECIMAL.fullmatch(text):
        raise FormatError(f"{quote(text)} is not a decimal number")
    sign, digits, exponent = _PARTS.fullmatch(text).groups()  # type: ignore[union-attr]
    whole, point, decimals = digits.lstrip("0").partition(".")
    return to_fraction(f"{sign}{whole or '0'}{point if decimals else ''}{decimals}{exponent}")


def read_decimals(text: str) -> list[Fraction]:
    """Read a list of decimals; blanks or commas are optional before a sign or a point."""
    if not _DECIMALS.fullmatch(text):
        raise FormatError(f"{quote(text)} is not a list of decimal numbers")
    return [*map(read_decimal, _DECIMAL.findall(text))]


def read_points(text: str) -> list[Point]:
    numbers = read_decimals(text)
    if len(numbers) % 2:
        raise FormatError("points: an odd number of coordinates")
    return [*map(Point, numbers[::2], numbers[1::2])]


def count_decimals(text: str) -> int:
    return sum(1 for _ in _DECIMAL.finditer(text))


def format_decimal(value: Fraction) -> str:
    """Format a number as an exact decimal; raises FormatError for numbers such as 1/3."""
    if value.denominator == 1:
        return format_fraction(value)
    twos = (value.denominator & -value.denominator).bit_length() - 1
    rest = value.denominator >> twos
    # At most one power of five has this many bits.
    fives = ceil((rest.bit_length() - 1) / log2(5))
    if 5**fives != rest:
        raise FormatError(f"{abridge(value)} is not a finite decimal")
    places = max(twos, fives)
    scaled = abs(value.numerator) * 2 ** (places - twos) * 5 ** (places - fives)
    digits = write_int(scaled).zfill(places + 1)
    sign = "-" if value < 0 else ""
    return f"{sign}{digits[:-places]}.{digits[-places:]}"


def show_point(point: Point) -> str:
    """Format a point for a message: short decimals exactly, others rounded."""
    return f"({','.join(map(show_number, point))})"


def show_number(value: Fraction) -> str:
    if value.denominator == 1 and abs(value) < 10**_SHOWN:
        return str(value)
    with suppress(FormatError):
        text = format_decimal(value)
        if len(text) <= _SHOWN + 6:
            return text
    try:
        return f"{float(value):.{_SHOWN}g}"
    except OverflowError:
        return abridge(value)
