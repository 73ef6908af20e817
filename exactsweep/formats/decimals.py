"""Decimal numbers in files, read and written exactly."""

import re
from fractions import Fraction
from math import ceil, log2

from exactsweep.formats.error import FormatError
from exactsweep.numbers.digits import write_int
from exactsweep.numbers.number import NumberError, abridge, format_fraction, quote, to_fraction

# Possessive, so that a long number with a letter at its end is not tried again for each digit.
DECIMAL = r"[+-]?(?:[0-9]++\.?+[0-9]*+|\.[0-9]++)(?:[eE][+-]?[0-9]++)?+"
"""A pattern of the numbers that `read_decimal` reads."""

_PARTS = re.compile(r"(-?)\+?0*([0-9]*)(?:\.([0-9]*))?(.*)")


def read_decimal(text: str) -> Fraction:
    """Read a decimal as WKT, SVG and DXF have them.

    Args:
        text: `-1.5e3`, and `+1`, `.5`, `5.` and `007` as well.

    Returns:
        The number, exactly.

    Raises:
        FormatError: anything else.
        NumberError: beyond `limits`.

    Example:
        >>> read_decimal("+.5"), read_decimal("007.e-2")
        (Fraction(1, 2), Fraction(7, 100))
    """
    # A text that begins like a JSON number nearly always is one.
    if text.removeprefix("-")[:1].isdigit() and "/" not in text:  # pragma: no mutate: time alone
        try:
            return to_fraction(text)  # pragma: no mutate: time alone
        except NumberError:
            pass
    if not re.fullmatch(DECIMAL, text):
        raise FormatError(f"{quote(text)} is not a decimal number")
    match = _PARTS.fullmatch(text)
    assert match is not None
    sign, whole, decimals, exponent = match.groups()
    return to_fraction(f"{sign}{whole or '0'}{'.' if decimals else ''}{decimals or ''}{exponent}")


def read_decimals(text: str) -> list[Fraction]:
    """Read decimals between blanks and commas; separators may be missing before a sign or point.

    >>> read_decimals("1,2-3 .5.25")
    [Fraction(1, 1), Fraction(2, 1), Fraction(-3, 1), Fraction(1, 2), Fraction(1, 4)]
    """
    found = re.findall(DECIMAL, text)
    if re.sub(r"[\s,]+", "", text) != "".join(found):
        raise FormatError(f"{quote(text)} is not a list of decimal numbers")
    return [read_decimal(number) for number in found]


def count_decimals(text: str) -> int:
    """Count the numbers that `read_decimals` would read, without keeping them."""
    return sum(1 for _ in re.finditer(DECIMAL, text))


def format_decimal(value: Fraction) -> str:
    """Write a number as a decimal, exactly.

    Args:
        value: a finite decimal, of any number of digits.

    Returns:
        Digits, with a point and decimals if there are any.

    Raises:
        FormatError: not a finite decimal, such as 1/3.

    Cost: that of a product of its length.

    Example:
        >>> format_decimal(Fraction(-7, 2)), format_decimal(Fraction(1, 1024))
        ('-3.5', '0.0009765625')
    """
    if value.denominator == 1:
        return format_fraction(value)
    twos = (value.denominator & -value.denominator).bit_length() - 1
    rest = value.denominator >> twos
    # Of as many bits there is one power of five at most.
    fives = ceil((rest.bit_length() - 1) / log2(5))
    if 5**fives != rest:
        raise FormatError(f"{abridge(value)} is not a finite decimal")
    places = max(twos, fives)
    scaled = abs(value.numerator) * 2 ** (places - twos) * 5 ** (places - fives)
    digits = write_int(scaled).zfill(places + 1)
    sign = "-" if value < 0 else ""
    return f"{sign}{digits[:-places]}.{digits[-places:]}"
