"""Certificates too large to be checked.

The checker refuses work that is known to take too long before it begins: to read all numbers and,
for polygons of any shape, to compare every edge with every other one. The rest depends on what
meets; the checker counts it against the same budget as it goes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import chain
from math import isqrt
from typing import Any

from exactsweep.check.standalone import Refused
from exactsweep.numbers.point import Vertex

_LEVELS = 8

# Digits that are more than one step to read.
_LONG = 100

# These lists describe edges by words and indices; their strings are not read as numbers.
_WITHOUT_NUMBERS = ("contacts", "inner_drawn", "outer_drawn")


class Budget:
    """The work that may still be done, in steps of about a microsecond.

    Args:
        most: how many steps, or None for any number.

    Attributes:
        left: how many of them are left.
    """

    def __init__(self, most: int | None = None) -> None:
        self._most = self.left = most

    def take(self, steps: int, bits: int = 0) -> None:
        """Take steps on numbers of so many bits.

        Raises:
            Refused: that is more than is left.
        """
        if self.left is None:
            return
        self.left -= steps * _weight(bits)
        if self.left < 0:
            raise Refused(f"too large: to check it would take more than {self._most} steps")


UNLIMITED = Budget()


def measure_bits(points: Iterable[Vertex]) -> int:
    """The bits of the longest coordinate, and 32 times as many for Fractions, which take longer."""
    ratios = [c.as_integer_ratio() for p in points for c in p]
    bits = max(max(n.bit_length(), d.bit_length()) for n, d in ratios)
    return bits if all(d == 1 for _, d in ratios) else 32 * bits


def check_reading(certificate: Any, max_steps: int) -> None:
    """Raise Refused if to read its numbers takes more steps than are allowed."""
    Budget(max_steps).take(reading_steps(certificate))


def reading_steps(certificate: Any) -> int:
    """Estimate the work of reading all numbers, in steps of about a microsecond.

    Most of it is to see that long numbers are in lowest terms.
    """
    if isinstance(certificate, dict):
        certificate = [item for key, item in certificate.items() if key not in _WITHOUT_NUMBERS]
    lengths = [*map(len, _strings(certificate))]
    return len(lengths) + sum(
        n * isqrt(n) // 1000 + n * n // 400_000 for n in lengths if n >= _LONG
    )


def _strings(item: Any) -> Iterator[str]:
    """All strings of data as JSON has it, level by level; numbers are not nested more deeply."""
    level = [item]
    for _ in range(_LEVELS):
        yield from (entry for entry in level if isinstance(entry, str))
        lists = [entry for entry in level if isinstance(entry, (list, tuple, dict))]
        level = [*chain.from_iterable(e.values() if isinstance(e, dict) else e for e in lists)]


def _weight(bits: int) -> int:
    """The cost of a step on numbers of so many bits, in steps on small ones."""
    words = 1 + bits // 64
    return words + words * words // 1000
