"""Values as plain JSON data."""

from fractions import Fraction
from typing import Any

from exactsweep.numbers.number import format_fraction


def to_plain(data: dict[str, Any]) -> dict[str, Any]:
    """Turn Fractions into strings and tuples into lists, at any depth of lists and dicts.

    Cost: linear.

    >>> to_plain({"at": (Fraction(1, 3), Fraction(2)), "number": 2})
    {'at': ['1/3', '2'], 'number': 2}
    """
    return {name: _write(value) for name, value in data.items()}


def _write(value: Any) -> Any:
    if type(value) is Fraction:
        return format_fraction(value)
    if isinstance(value, dict):
        return to_plain(value)
    return [*map(_write, value)] if isinstance(value, list | tuple) else value
