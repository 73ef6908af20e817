"""A search for boxes that meet, without a test of all pairs.

The search halves the plane recursively, along the axis that cuts fewer boxes. Each half gets the
boxes that meet it. (1) The least common corner of two boxes is the greater of their left ends and
of their low ends. It lies in one half only. So the search finds each pair once.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import inf

from exactsweep.numbers.number import Rational

_FEW = 400
"""The number of boxes up to which all pairs are compared."""

_Numbered = tuple[Rational, Rational, Rational, Rational, int]
_Border = Rational | float


def find_near(
    boxes: Sequence[tuple[Rational, Rational, Rational, Rational]], reach: int = 0
) -> Iterator[tuple[int, int]]:
    """Find the pairs of boxes that meet, or are within reach in both coordinates.

    Args:
        boxes: the boxes, on one lattice.
        reach: the greatest distance between the x-ranges, and between the y-ranges, of a pair.

    Yields:
        Pairs of numbers, the lesser one first; each pair once.

    Cost: O(n log n + k) for n boxes and k pairs, if the boxes are not much longer than their
    distances.

    >>> sorted(find_near([(0, 1, 0, 1), (1, 2, 1, 2), (3, 4, 0, 9), (3, 9, 2, 3)], 1))
    [(0, 1), (1, 2), (1, 3), (2, 3)]
    """
    numbered = [
        (left, right + reach, low, high + reach, k)
        for k, (left, right, low, high) in enumerate(boxes)
    ]
    # Each pile has the west and the south border of its cell.
    piles: list[tuple[list[_Numbered], _Border, _Border]] = [(numbered, -inf, -inf)]
    while piles:
        pile, west, south = piles.pop()
        halves = _halve(pile) if len(pile) > _FEW else None
        if halves is None:
            yield from _compare(pile, west, south)
            continue
        axis, middle, lesser, greater = halves
        piles.append((lesser, west, south))
        piles.append((greater, middle, south) if axis == 0 else (greater, west, middle))


def _halve(
    pile: list[_Numbered],
) -> tuple[int, Rational, list[_Numbered], list[_Numbered]] | None:
    """Halve a pile in the better of two ways; None if neither makes it much smaller."""
    best = None
    least = 7 * len(pile) // 4
    for axis in (0, 2):
        middle = sorted(box[axis] for box in pile)[len(pile) // 2]
        lesser = [box for box in pile if box[axis] < middle]
        greater = [box for box in pile if box[axis + 1] >= middle]
        size = len(lesser) + len(greater)
        if size < least and len(lesser) < len(pile) > len(greater):
            best, least = (axis, middle, lesser, greater), size
    return best


def _compare(pile: list[_Numbered], west: _Border, south: _Border) -> Iterator[tuple[int, int]]:
    """Find the pairs of a pile that meet, with the least common corner in its cell."""
    pile.sort()
    for k, (_, right, low, high, number) in enumerate(pile, 1):
        for left, _, other_low, other_high, other in pile[k:]:
            if left > right:
                break
            if (
                low <= other_high
                and other_low <= high
                and left >= west
                and (low >= south or other_low >= south)
            ):
                yield (number, other) if number < other else (other, number)
