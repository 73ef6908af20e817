"""Open Minkowski sums of convex pieces of two shapes, numbered as in `check/CERTIFICATES.md`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, pairwise

from exactsweep.evidence.homogeneous import DirectedSegment, direct_side, list_sides, place
from exactsweep.geometry.frame import HomogeneousPoint
from exactsweep.geometry.near import BoxRows

CellBox = tuple[int, int, int, int]
"""The left, right, low and high end of a box on the grid."""

_PieceList = Sequence[Sequence[HomogeneousPoint]]

# The number of columns and of rows of the grid.
_CELLS = 1 << 30


class Sums:
    """The open sums of convex pieces of two shapes, with their boxes on a grid.

    Sum i n + j adds piece i of the first shape, a convex counter-clockwise ring or a segment, and
    piece j of the n pieces of the second shape, a ring of points with w = 1. The open half-planes
    left of the segments in `beyond` are numbered after these, as sums with one side.
    """

    def __init__(
        self, first: _PieceList, second: _PieceList, beyond: Sequence[DirectedSegment] = ()
    ) -> None:
        points = [*chain(*first, *second)]
        xs, ys = [x // w for x, _, w in points], [y // w for _, y, w in points]
        self._size = max(max(xs) - min(xs), max(ys) - min(ys)) + 1
        self._columns = len(second)
        self._pieces = [[_from_lowest(ring) for ring in shape] for shape in (first, second)]
        boxes, others = (list(map(self.bound, shape)) for shape in (first, second))
        self.boxes = [
            (left + west, right + east, low + south, high + north)
            for left, right, low, high in boxes
            for west, east, south, north in others
        ]
        self.count = len(self.boxes)
        lefts, rights, lows, highs = zip(*self.boxes, strict=True)
        self.box = left, right, low, high = min(lefts), max(rights), min(lows), max(highs)
        self.boxes += [self.box] * len(beyond)
        # The rows of the search run along the shorter axis.
        self._is_wide = right - left > high - low
        self._rows = BoxRows([self._orient(box) for box in self.boxes])
        self._sides = {self.count + k: [side] for k, side in enumerate(beyond)}

    def _orient(self, box: CellBox) -> CellBox:
        left, right, low, high = box
        return (low, high, left, right) if self._is_wide else box

    def bound(self, points: Iterable[HomogeneousPoint]) -> CellBox:
        """Return the box of points on the grid, rounded outwards."""
        size = self._size
        cells = [(x * _CELLS // (w * size), y * _CELLS // (w * size)) for x, y, w in points]
        xs, ys = zip(*cells, strict=True)
        return min(xs), max(xs) + 1, min(ys), max(ys) + 1

    def sides(self, k: int) -> list[DirectedSegment]:
        """Return the edges of a sum, counter-clockwise from its leftmost lowest vertex."""
        found = self._sides.get(k)
        if found is None:
            i, j = divmod(k, self._columns)
            found = self._sides[k] = _add(self._pieces[0][i], self._pieces[1][j])
        return found

    def measure(self, k: int) -> int:
        """Return the area of the box of a sum."""
        left, right, low, high = self.boxes[k]
        return (right - left) * (high - low)

    def find_near(self, box: CellBox) -> Iterator[int]:
        """Yield the numbers of the sums whose boxes touch a box."""
        return self._rows.find(self._orient(box))


def _from_lowest(ring: Sequence[HomogeneousPoint]) -> list[DirectedSegment]:
    """Return the edges of a piece, starting at its leftmost lowest vertex."""
    k = min(range(len(ring)), key=lambda k: place(ring[k])[::-1])
    return list_sides([*ring[k:], *ring[:k]])


def _add(one: Sequence[DirectedSegment], other: Sequence[DirectedSegment]) -> list[DirectedSegment]:
    """Merge the edges of two convex pieces by direction."""
    i = j = 0
    corners: list[HomogeneousPoint] = []
    directions = []
    while i < len(one) or j < len(other):
        (x, y, w), _, (dx, dy), _ = one[i % len(one)]
        (u, v, _), _, (ex, ey), _ = other[j % len(other)]
        corners.append((x + u * w, y + v * w, w))
        turn = 1 if j == len(other) else -1 if i == len(one) else dx * ey - dy * ex
        directions.append((dx, dy) if turn >= 0 else (ex, ey))
        i, j = i + (turn >= 0), j + (turn <= 0)
    ends: Iterable[tuple[HomogeneousPoint, HomogeneousPoint]] = pairwise((*corners, corners[0]))
    return [direct_side(p, q, to) for (p, q), to in zip(ends, directions, strict=True)]
