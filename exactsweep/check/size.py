"""Certificates too large to be checked.

The checker refuses work that is known to take too long before it begins. For polygons of any shape,
the known work is that of comparing every edge with every other one. The rest depends on the number
of pieces that meet; the checker counts it against the same budget as it goes.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import chain
from math import isqrt, lcm
from typing import Any

from exactsweep.check.certificate import CertificateError
from exactsweep.check.chain import Node
from exactsweep.numbers.point import Point, Vertex

_LEVELS = 8

# Bits of a common denominator that are worth while, and times that it may be as long as the longest
# denominator: of unrelated ones of 150 digits each point by itself is checked 35 times as fast.
_SHORT, _FEW = 256, 2

# Digits that are more than one step to read.
_LONG = 100

# These lists describe edges by words and indices; their strings are not read as numbers.
_WITHOUT_NUMBERS = ("contacts", "inner_drawn", "outer_drawn")


def find_common_scale(points: Collection[Point]) -> int:
    """The least common denominator; 1 if it is far longer than each of them, and so of no use."""
    longest = max(c.denominator for point in points for c in point).bit_length()
    most = max(_SHORT, _FEW * longest)
    scale = 1
    for x, y in points:
        scale = lcm(scale, x.denominator, y.denominator)
        if scale.bit_length() > most:
            return 1
    return scale


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
            CertificateError: that is more than is left.
        """
        if self.left is None:
            return
        self.left -= steps * _weight(bits)
        if self.left < 0:
            raise CertificateError(
                f"too large: to check it would take more than {self._most} steps"
            )


UNLIMITED = Budget()


def measure_bits(points: Iterable[Vertex]) -> int:
    """The bits of the longest coordinate, and 32 times as many for Fractions, which take longer."""
    ratios = [c.as_integer_ratio() for p in points for c in p]
    bits = max(max(n.bit_length(), d.bit_length()) for n, d in ratios)
    return bits if all(d == 1 for _, d in ratios) else 32 * bits


def check_size(loops: Collection[Sequence[Node]], steps: int, max_steps: int) -> None:
    """Raise CertificateError if so many steps, and the loops themselves, are more than allowed."""
    Budget(max_steps).take(measure_size(loops, steps))


def measure_size(loops: Collection[Sequence[Node]], steps: int) -> int:
    """Sum up so many steps on the numbers of loops, and on the loops themselves."""
    columns = [column for nodes in loops for column in zip(*nodes, strict=True)]
    bits = max(n.bit_length() for column in columns for n in (min(column), max(column)))
    work = (steps + sum(map(len, loops))) * _weight(bits)
    # The area comes over the product of all denominators.
    return work + max(_weight(2 * sum(w.bit_length() for _, _, w in nodes)) for nodes in loops)


def check_reading(certificate: Any, max_steps: int) -> None:
    """Raise CertificateError if to read its numbers takes more steps than are allowed."""
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
