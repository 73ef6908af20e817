"""Boxes near a place, found in a tree of boxes around boxes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from heapq import heappop, heappush
from math import isqrt
from operator import attrgetter
from typing import NamedTuple, TypeVar

from exactsweep.check.standalone import Work
from exactsweep.numbers.number import Rational, Vertex

Rectangle = tuple[Rational, Rational, Rational, Rational]
"""The least and the greatest x, the least and the greatest y."""

_FEW = 8  # boxes in one

_Item = TypeVar("_Item")


def find_box(points: Iterable[Vertex]) -> Rectangle:
    """The box around points."""
    xs, ys = zip(*points, strict=True)
    return min(xs), max(xs), min(ys), max(ys)


def meet(one: Sequence[Rational], other: Sequence[Rational]) -> bool:
    """Decide whether two boxes, with their borders, have a point in common."""
    return one[0] <= other[1] and other[0] <= one[1] and one[2] <= other[3] and other[2] <= one[3]


class _Branch(NamedTuple):
    """A box around others, the least of their numbers, and the branches or numbers in it."""

    box: Rectangle
    least: int
    branches: Sequence[_Branch]
    numbers: Sequence[int]


class BoxTree:
    """Boxes, for finding those that meet another one.

    They are packed by place: in strips one beside the other, in each of them one above the other,
    and so are the boxes around those, until one is around all.

    Args:
        boxes: each with its least and greatest x, its least and greatest y.
        budget: what to build it and to look in it may take.

    Cost: O(k log k) for k boxes.
    Source: Leutenegger, Lopez and Edgington, "STR: a simple and efficient algorithm for R-tree
        packing", Data Engineering 1997.
    """

    def __init__(self, boxes: Sequence[Rectangle], budget: Work) -> None:
        self._boxes, self._budget = boxes, budget
        budget.take(6 * len(boxes))
        branches = [
            _Branch(_surround([boxes[k] for k in numbers]), min(numbers), (), numbers)
            for numbers in _pack(range(len(boxes)), boxes.__getitem__)
        ]
        while len(branches) > 1:
            branches = [
                _Branch(_surround([b.box for b in inner]), min(b.least for b in inner), inner, ())
                for inner in _pack(branches, attrgetter("box"))
            ]
        self._roots = branches

    def near(self, box: Sequence[Rational]) -> Iterator[int]:
        """The numbers of the boxes that meet another one, in ascending order.

        Cost: O(log k) for each, where few are beside each other; O(k) at worst for all.
        """
        found: list[tuple[int, _Branch | None]] = [
            (root.least, root) for root in self._roots if meet(root.box, box)
        ]
        while found:
            k, branch = heappop(found)
            if not meet(branch.box if branch else self._boxes[k], box):
                continue
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


def _surround(boxes: Iterable[Rectangle]) -> Rectangle:
    lefts, rights, lows, highs = zip(*boxes, strict=True)
    return min(lefts), max(rights), min(lows), max(highs)


def _pack(items: Sequence[_Item], find: Callable[[_Item], Rectangle]) -> list[list[_Item]]:
    """Part items into groups by the places of their boxes."""
    strips = isqrt(len(items) // _FEW) + 1
    size = len(items) // strips + 1
    beside = sorted(items, key=lambda item: find(item)[0])
    groups = []
    for k in range(0, len(items), size):
        strip = sorted(beside[k : k + size], key=lambda item: find(item)[2])
        groups += [strip[i : i + _FEW] for i in range(0, len(strip), _FEW)]
    return groups
