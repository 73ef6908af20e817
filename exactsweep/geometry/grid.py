"""A grid over a shape, to find what is near a vertex or a segment."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from itertools import chain
from math import isqrt

from exactsweep.geometry.vectors import turn

IntVertex = tuple[int, int]
Wall = tuple[int, int, int, int, IntVertex, IntVertex]
"""Left, right, lower, upper end of a segment, and its ends."""

_Square = tuple[int, int]


class WallGrid:
    """Vertices, and walls between some of them, by the squares in which they are.

    Args:
        vertices: those of a shape.

    Attributes:
        columns: the most squares in a row or a column, each with some 16 vertices in the mean.
    """

    def __init__(self, vertices: Sequence[IntVertex]) -> None:
        xs, ys = zip(*vertices, strict=True)
        self._left, self._low = min(xs), min(ys)
        self.columns = isqrt(len(vertices)) // 4 + 1
        self._side = max(max(xs) - self._left, max(ys) - self._low) // self.columns + 1
        self._walls: defaultdict[_Square, list[Wall]] = defaultdict(list)
        self._vertices: defaultdict[_Square, list[IntVertex]] = defaultdict(list)
        for v in dict.fromkeys(vertices):
            self._vertices[self._square(v)].append(v)

    def _square(self, p: IntVertex) -> _Square:
        return (p[0] - self._left) // self._side, (p[1] - self._low) // self._side

    def _along(self, a: IntVertex, b: IntVertex) -> Iterator[_Square]:
        """List the squares that a segment meets."""
        if self.columns == 1:
            yield 0, 0
            return
        (px, py), (qx, qy) = low, high = sorted((a, b))
        (first, row), (last, last_row) = self._square(low), self._square(high)
        for column in range(first, last + 1):
            # The row at the right border of the column, rounded as a square is.
            border = self._left + (column + 1) * self._side
            rise = py - self._low + (border - px) * (qy - py) // (qx - px) if column < last else 0
            until = rise // self._side if column < last else last_row
            for k in range(min(row, until), max(row, until) + 1):
                yield column, k
            row = until

    def build(self, a: IntVertex, b: IntVertex) -> None:
        """Add a wall."""
        wall = box_wall(a, b)
        for square in self._along(a, b):
            self._walls[square].append(wall)

    def find_walls(self, a: IntVertex, b: IntVertex) -> Iterator[Wall]:
        """Find all walls that meet a segment, some of them repeatedly, and some others."""
        return chain.from_iterable(self._walls.get(square, ()) for square in self._along(a, b))

    def find_on(self, a: IntVertex, b: IntVertex) -> list[IntVertex]:
        """Find the vertices inside a segment."""
        low, high = sorted((a, b))
        near = chain.from_iterable(self._vertices.get(square, ()) for square in self._along(a, b))
        return [v for v in near if low < v < high and not turn(a, b, v)]

    def find_around(self, p: IntVertex, reach: int) -> Iterator[IntVertex]:
        """Find the vertices in the squares that are so many away, or less."""
        x, y = self._square(p)
        rows = range(y - reach, y + reach + 1)
        return chain.from_iterable(
            self._vertices.get((k, row), ())
            for k in range(x - reach, x + reach + 1)
            for row in rows
        )


def box_wall(a: IntVertex, b: IntVertex) -> Wall:
    """Return a wall with its box."""
    (left, right), (low, high) = (sorted(pair) for pair in zip(a, b, strict=True))
    return left, right, low, high, a, b
