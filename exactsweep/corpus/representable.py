"""Number types that represent given numbers exactly."""

from collections.abc import Collection
from fractions import Fraction

INTEGER_BITS = {"int32": 32, "int64": 64}
NUMBER_TYPES = (*INTEGER_BITS, "binary64")


def find_types(values: Collection[Fraction], scale: int) -> frozenset[str]:
    """List the number types that represent numbers exactly, integers after scaling.

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
    """Decide whether a number is in the range of signed integers of some bits.

    >>> is_in_range(-(2**31), 32), is_in_range(2**31 - 1, 32), is_in_range(2**31, 32)
    (True, True, False)
    """
    return -(1 << bits - 1) <= value <= (1 << bits - 1) - 1


def _is_binary64(value: Fraction) -> bool:
    if value.denominator == 1 and abs(value.numerator) <= 2**53:
        return True
    # Division of ints rounds correctly.
    try:
        return Fraction(value.numerator / value.denominator) == value
    except OverflowError:
        return False
