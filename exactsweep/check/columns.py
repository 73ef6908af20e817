"""Boxes near a place: those in the same columns of a grid."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence

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
        self._first = [self._find(box[0]) for box in boxes]
        for k, box in enumerate(boxes):
            first, last = self._first[k], self._find(box[1])
            if last - first > _MANY:
                self._wide.append(k)
            else:
                for column in range(first, last + 1):
                    self._found[column].append(k)

    def _find(self, x: Rational) -> int:
        return int((x - self._left) // self._width)

    def near(self, left: Rational, right: Rational) -> Iterator[int]:
        """The numbers of all boxes that meet a range of x, and of others: first the wide ones."""
        first, last = self._find(left), self._find(right)
        if last - first > _MANY:
            yield from range(len(self._first))
            return
        yield from self._wide
        for column in range(first, last + 1):
            for k in self._found.get(column, ()):
                if column == first or column == self._first[k]:
                    yield k
