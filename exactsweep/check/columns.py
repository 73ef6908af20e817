"""Boxes near a place: those in the same columns of a grid."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence

from exactsweep.geometry.point import Rational, Vertex

Rectangle = tuple[Rational, Rational, Rational, Rational]
"""The least and the greatest x, the least and the greatest y."""


def find_box(points: Iterable[Vertex]) -> Rectangle:
    """The box around points."""
    xs, ys = zip(*points, strict=True)
    return min(xs), max(xs), min(ys), max(ys)


def meet(one: Rectangle, other: Rectangle) -> bool:
    """Whether two boxes, with their borders, have a point in common."""
    return one[0] <= other[1] and other[0] <= one[1] and one[2] <= other[3] and other[2] <= one[3]


# What meets so many columns is not worth being told apart by them.
_MANY = 30


class BoxColumns:
    """Boxes by the columns of a grid, for finding those that meet a range of x.

    Args:
        boxes: each with its least and greatest x, its least and greatest y.
    """

    def __init__(self, boxes: Sequence[Rectangle]) -> None:
        self._left = min((box[0] for box in boxes), default=0)
        width = max((box[1] for box in boxes), default=0) - self._left
        self._width = width // (len(boxes) + 1) + 1
        self._wide: list[int] = []  # found by whatever range
        self._found: dict[int, list[int]] = defaultdict(list)
        for k, (left, right, _, _) in enumerate(boxes):
            first, last = self._find(left), self._find(right)
            if last - first > _MANY:
                self._wide.append(k)
            else:
                for column in range(first, last + 1):
                    self._found[column].append(k)
        self._all = range(len(boxes))

    def _find(self, x: Rational) -> int:
        return int((x - self._left) // self._width)

    def count_near(self, left: Rational, right: Rational) -> int:
        """How many numbers `near` has, or more, without listing them."""
        first, last = self._find(left), self._find(right)
        if last - first > _MANY:
            return len(self._all)
        columns = range(first, last + 1)
        return len(self._wide) + sum(len(self._found.get(column, ())) for column in columns)

    def near(self, left: Rational, right: Rational) -> Sequence[int]:
        """The numbers of all boxes that meet a range of x, and of others, in ascending order."""
        first, last = self._find(left), self._find(right)
        if last - first > _MANY:
            return self._all
        near: Iterable[int] = self._found.get(first, ())
        if first != last:
            near = {k for column in range(first, last + 1) for k in self._found.get(column, ())}
        return sorted([*self._wide, *near])
