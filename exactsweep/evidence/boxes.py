"""Boxes on a grid, and trees of boxes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from exactsweep.evidence.homogeneous import Node

CellBox = tuple[int, int, int, int]
"""The left, right, low and high end of a box."""

_CELLS = 1 << 30


class BoxGrid:
    """A grid of cells over the given points, in which boxes have int coordinates."""

    def __init__(self, points: Sequence[Node]) -> None:
        xs, ys = [x // w for x, _, w in points], [y // w for _, y, w in points]
        self._size = max(max(xs) - min(xs), max(ys) - min(ys)) + 1

    def find_cell(self, p: Node) -> tuple[int, int]:
        """Return the column and the row of a point."""
        x, y, w = p
        return x * _CELLS // (w * self._size), y * _CELLS // (w * self._size)

    def bound(self, points: Sequence[Node]) -> CellBox:
        """Return the box of points, rounded outwards."""
        xs, ys = zip(*map(self.find_cell, points), strict=True)
        return min(xs), max(xs) + 1, min(ys), max(ys) + 1


def are_touching(one: CellBox, other: CellBox) -> bool:
    """Decide whether two closed boxes intersect."""
    left, right, low, high = one
    west, east, south, north = other
    return west <= right and left <= east and south <= high and low <= north


class Tree(NamedTuple):
    """A bounding box, its half perimeter (-1 for a leaf), and two subtrees or the leaf's index."""

    box: CellBox
    size: int
    content: Any


def grow(boxes: Sequence[tuple[CellBox, int]]) -> Tree:
    """Build a tree of numbered boxes by halving along the longer axis. Cost: O(n log^2 n)."""
    if len(boxes) == 1:
        return Tree(boxes[0][0], -1, boxes[0][1])
    lefts, rights, lows, highs = zip(*(box for box, _ in boxes), strict=True)
    left, right, low, high = box = min(lefts), max(rights), min(lows), max(highs)
    axis = 0 if right - left > high - low else 2
    ordered = sorted(boxes, key=lambda entry: entry[0][axis] + entry[0][axis + 1])
    half = len(boxes) // 2
    return Tree(box, right - left + high - low, (grow(ordered[:half]), grow(ordered[half:])))


def find_touching(one: Tree, other: Tree, third: Tree) -> Iterator[tuple[int, int, int]]:
    """Yield the indices of boxes of three trees such that the first touches the sum of the others.

    Cost: O(log n) per result, if boxes are not much longer than the gaps between them.

    >>> first = grow([((0, 1, 0, 1), 0), ((8, 9, 8, 9), 1)])
    >>> [*find_touching(first, Tree((1, 2, 1, 2), -1, 0), Tree((6, 7, 6, 7), -1, 0))]
    [(1, 0, 0)]
    """
    stack = [(one, other, third)]
    while stack:
        one, other, third = stack.pop()
        (left, right, low, high), k, _ = one
        ((a, b, c, d), m, _), ((e, f, g, h), n, _) = other, third
        if left > b + f or right < a + e or low > d + h or high < c + g:
            continue
        if k >= m and k >= n:
            if k < 0:
                yield one.content, other.content, third.content
            else:
                stack += [(half, other, third) for half in one.content]
        elif m >= n:
            stack += [(one, half, third) for half in other.content]
        else:
            stack += [(one, other, half) for half in third.content]
