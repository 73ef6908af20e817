"""Boxes near a place, found in a tree of boxes around boxes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from heapq import heappop, heappush
from typing import NamedTuple

from exactsweep.check.size import Budget
from exactsweep.geometry.point import Rational, Vertex

Rectangle = tuple[Rational, Rational, Rational, Rational]
"""The least and the greatest x, the least and the greatest y."""

_FEW = 8  # boxes that are not worth being told apart


def find_box(points: Iterable[Vertex]) -> Rectangle:
    """The box around points."""
    xs, ys = zip(*points, strict=True)
    return min(xs), max(xs), min(ys), max(ys)


def meet(one: Rectangle, other: Rectangle) -> bool:
    """Whether two boxes, with their borders, have a point in common."""
    return one[0] <= other[1] and other[0] <= one[1] and one[2] <= other[3] and other[2] <= one[3]


class _Branch(NamedTuple):
    """A box around others, the least of their numbers, and the branches or numbers in it."""

    box: Rectangle
    least: int
    branches: Sequence[_Branch]
    numbers: Sequence[int]


class BoxTree:
    """Boxes, for finding those that meet another one.

    Args:
        boxes: each with its least and greatest x, its least and greatest y.
        budget: what to build it and to look in it may take.

    Cost: O(k log(k)**2) for k boxes.
    """

    def __init__(self, boxes: Sequence[Rectangle], budget: Budget) -> None:
        self._boxes, self._budget = boxes, budget
        budget.take(len(boxes) * len(boxes).bit_length())
        self._root = self._grow(range(len(boxes))) if boxes else None

    def _grow(self, numbers: Sequence[int]) -> _Branch:
        """A branch of boxes: those of either half of them, along the axis that parts them more."""
        xs, more_xs, ys, more_ys = zip(*(self._boxes[k] for k in numbers), strict=True)
        box = min(xs), max(more_xs), min(ys), max(more_ys)
        if len(numbers) <= _FEW:
            return _Branch(box, min(numbers), (), numbers)
        spreads = max(xs) - min(xs), max(ys) - min(ys)
        axis = 0 if spreads[0] > spreads[1] else 2
        ordered = sorted(numbers, key=lambda k: self._boxes[k][axis])
        half = len(ordered) // 2
        halves = self._grow(ordered[:half]), self._grow(ordered[half:])
        return _Branch(box, min(numbers), halves, ())

    def near(self, box: Rectangle) -> Iterator[int]:
        """The numbers of the boxes that meet another one, in ascending order.

        Cost: O(log k) for each, where few are beside each other; O(k) at worst for all.
        """
        found: list[tuple[int, _Branch | None]] = []
        if self._root and meet(self._root.box, box):
            found.append((self._root.least, self._root))
        while found:
            k, branch = heappop(found)
            if branch is None:
                yield k
                continue
            self._budget.take(2)
            for inner in branch.branches:
                if meet(inner.box, box):
                    heappush(found, (inner.least, inner))
            for k in branch.numbers:
                if meet(self._boxes[k], box):
                    heappush(found, (k, None))
