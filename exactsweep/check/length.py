"""How long numbers of a certificate may be: as long as its input makes them, and no longer.

Let the numbers of the input have D digits in all. Then

1. The common denominator has at most D digits, and so have the coordinates over it, as ints.
2. A line through two such points, a x + b y = c, has a and b of D + 1 digits and c of 2 D + 2. Two
   such lines cross over a b' - a' b, of 2 D + 3 digits, at numerators of 3 D + 4; back from the
   lattice, numerator and denominator have at most 3 D + 4. So much for the trajectory.
3. The loops of the area swept have edges of the trajectory moved by vertices of G, which is 2, and
   edges of G moved by its vertices: times the denominator there, a and b have 3 D + 4 digits and c
   has 4 D + 6. Two such lines cross over 6 D + 9 digits, at 7 D + 11. D more are for the lattice.
4. Twice the area is a sum of products x y' - x' y, over the product of all denominators.

What a number of the answer has beyond that cannot be true, and is refused before it is read.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain
from typing import Any

_LEVELS = 8

# What loops are made of is told by words and indices: no string of it is read as a number.
_WITHOUT_NUMBERS = ("contacts", "inner_drawn", "outer_drawn")


def answer_digits(*inputs: Any) -> int:
    """The most digits of a coordinate of the answer, by 1 to 3.

    Args:
        inputs: what a certificate has of shapes and of the reference point, not read yet.
    """
    return 8 * _total(inputs) + 16


def area_digits(*loops: Any) -> int:
    """The most digits of the area between loops, by 4; the loops are not read yet."""
    return 4 * _total(loops) + 16


def reading_steps(certificate: Any) -> int:
    """What it takes to read all numbers, in steps of about a microsecond.

    Cost: linear in the number of strings.
    """
    if isinstance(certificate, dict):
        certificate = [item for key, item in certificate.items() if key not in _WITHOUT_NUMBERS]
    return sum(1 + len(text) ** 2 // 20_000 for text in _strings(certificate))


def _total(item: Any) -> int:
    return sum(map(len, _strings(item)))


def _strings(item: Any) -> Iterator[str]:
    """All strings of data as JSON has it, level by level; numbers are not nested more deeply."""
    level = [item]
    for _ in range(_LEVELS):
        yield from (entry for entry in level if isinstance(entry, str))
        lists = [entry for entry in level if isinstance(entry, (list, tuple, dict))]
        level = [*chain.from_iterable(e.values() if isinstance(e, dict) else e for e in lists)]
