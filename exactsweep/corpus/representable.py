"""The number types that represent given numbers without rounding."""

from collections.abc import Collection
from fractions import Fraction

INTEGER_BITS = {"int32": 32, "int64": 64}
NUMBER_TYPES = (*INTEGER_BITS, "binary64")


def find_types(values: Collection[Fraction], scale: int) -> frozenset[str]:
    """Name the number types that represent numbers exactly.

    Args:
        values: the numbers.
        scale: a positive int by which they are multiplied for the integer types.

    Returns:
        Some of "int32" and "int64" (two's complement), for the numbers times the scale, and
        "binary64", subnormal numbers included.

    Example:
        >>> sorted(find_types([Fraction(1, 3)], 3)), sorted(find_types([Fraction(1, 3)], 2))
        (['int32', 'int64'], [])
        >>> sorted(find_types([Fraction(2**31)], 1))
        ['binary64', 'int64']
    """
    held = set()
    if all(scale % value.denominator == 0 for value in values):
        scaled = [value.numerator * (scale // value.denominator) for value in values]
        low, high = min(scaled, default=0), max(scaled, default=0)
        held = {
            name
            for name, bits in INTEGER_BITS.items()
            if is_in_range(low, bits) and is_in_range(high, bits)
        }
    if all(map(_is_binary64, values)):
        held.add("binary64")
    return frozenset(held)


def is_in_range(value: Fraction | int, bits: int) -> bool:
    """Decide whether a signed integer type of some bits has the range of a number.

    >>> is_in_range(-(2**31), 32), is_in_range(2**31 - 1, 32), is_in_range(2**31, 32)
    (True, True, False)
    """
    return -(1 << bits - 1) <= value <= (1 << bits - 1) - 1


def _is_binary64(value: Fraction) -> bool:
    if value.denominator == 1 and abs(value.numerator) <= 2**53:
        return True
    # Division of ints rounds correctly; a value that is unchanged was not rounded.
    try:
        return Fraction(value.numerator / value.denominator) == value
    except OverflowError:
        return False
