"""Open Minkowski sums of convex pieces of two shapes, numbered as in `check/CERTIFICATES.md`."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, pairwise

from exactsweep.evidence.boxes import BoxGrid, CellBox, find_touching, grow
from exactsweep.evidence.homogeneous import DirectedSegment, Node, direct_side, list_sides, place


class Sums:
    """The open sums of convex pieces of two shapes.

    Sum i n + j adds piece i of the first shape, a convex counter-clockwise ring or a segment, and
    piece j of the n pieces of the second shape, a ring of points with w = 1.
    """

    def __init__(self, first: Sequence[Sequence[Node]], second: Sequence[Sequence[Node]]) -> None:
        self.grid = BoxGrid([*chain(*first, *second)])
        self.count, self._columns = len(first) * len(second), len(second)
        self._pieces = [[_from_lowest(ring) for ring in shape] for shape in (first, second)]
        self._trees = [
            grow([(self.grid.bound(ring), k) for k, ring in enumerate(shape)])
            for shape in (first, second)
        ]
        self._parallel = [_by_direction(pieces) for pieces in self._pieces]
        left, right, low, high = zip(*(tree.box for tree in self._trees), strict=True)
        self.box: CellBox = sum(left), sum(right), sum(low), sum(high)
        self._sides: dict[int, list[DirectedSegment]] = {}
        self._areas: dict[int, int] = {}

    def sides(self, k: int) -> list[DirectedSegment]:
        """Return the edges of a sum, counter-clockwise from its leftmost lowest vertex."""
        found = self._sides.get(k)
        if found is None:
            i, j = divmod(k, self._columns)
            found = self._sides[k] = _add(self._pieces[0][i], self._pieces[1][j])
        return found

    def find_parallel(self, near: Iterable[int], side: DirectedSegment) -> list[int]:
        """Return those of the numbered sums that have a side parallel to a segment."""
        direction, columns = _undirected(side), self._columns
        rows, others = (of.get(direction, set()) for of in self._parallel)
        numbers = (k for k in near if k < self.count)
        return [k for k in numbers if k % columns in others or k // columns in rows]

    def measure(self, k: int) -> int:
        """Return twice the area of a sum with corners rounded to the grid."""
        area = self._areas.get(k)
        if area is None:
            cells = [self.grid.find_cell(side.start) for side in self.sides(k)]
            around = pairwise((*cells, cells[0]))
            area = self._areas[k] = sum(x * v - u * y for (x, y), (u, v) in around)
        return area

    def find_near(self, boxes: Sequence[tuple[CellBox, int]]) -> Iterator[tuple[int, int]]:
        """Yield pairs of the number of a box and the number of a sum whose box touches it."""
        if boxes:
            for n, i, j in find_touching(grow(boxes), *self._trees):
                yield n, i * self._columns + j


def _undirected(side: DirectedSegment) -> tuple[int, int]:
    dx, dy = side.direction
    return max((dx, dy), (-dx, -dy))


def _by_direction(pieces: list[list[DirectedSegment]]) -> dict[tuple[int, int], set[int]]:
    """Group the numbers of pieces by the directions of their sides."""
    found: dict[tuple[int, int], set[int]] = defaultdict(set)
    for k, sides in enumerate(pieces):
        for side in sides:
            found[_undirected(side)].add(k)
    return found


def _from_lowest(ring: Sequence[Node]) -> list[DirectedSegment]:
    """Return the edges of a piece, starting at its leftmost lowest vertex."""
    k = min(range(len(ring)), key=lambda k: place(ring[k])[::-1])
    return list_sides([*ring[k:], *ring[:k]])


def _add(one: Sequence[DirectedSegment], other: Sequence[DirectedSegment]) -> list[DirectedSegment]:
    """Merge the edges of two convex pieces by direction."""
    i = j = 0
    corners: list[Node] = []
    directions = []
    while i < len(one) or j < len(other):
        (x, y, w), _, (dx, dy), _ = one[i % len(one)]
        (u, v, _), _, (ex, ey), _ = other[j % len(other)]
        corners.append((x + u * w, y + v * w, w))
        turn = 1 if j == len(other) else -1 if i == len(one) else dx * ey - dy * ex
        directions.append((dx, dy) if turn >= 0 else (ex, ey))
        i, j = i + (turn >= 0), j + (turn <= 0)
    ends: Iterable[tuple[Node, Node]] = pairwise((*corners, corners[0]))
    return [direct_side(p, q, to) for (p, q), to in zip(ends, directions, strict=True)]
