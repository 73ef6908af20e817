"""The search for intersecting boxes, in rows sorted by left ends.

It serves edges (`edges`), contact segments (`procedures.crossings`) and placed parts (`layout`).

(1) A row is at least as high as the mean box, so n boxes have at most 2 n entries in all rows.
(2) The lower side of the intersection of two boxes lies in one row, so each pair is found once.
"""

from __future__ import annotations

from bisect import insort
from collections.abc import Iterable, Iterator, Sequence

from exactsweep.numbers.number import Rational, Vertex

Bounds = tuple[Rational, Rational, Rational, Rational]
"""The left, right, low and high end of a closed box."""

PER_ROW = 16
"""The mean number of boxes per row. Values from 8 to 64 are equally fast."""

_Entry = tuple[Rational, Rational, Rational, Rational, int]


def bound_points(points: Iterable[Vertex]) -> Bounds:
    """Return the bounds of one or more points."""
    xs, ys = zip(*points, strict=True)
    return min(xs), max(xs), min(ys), max(ys)


def boxes_meet(one: Bounds, other: Bounds) -> bool:
    """Decide whether two boxes intersect."""
    left, right, low, high = one
    west, east, south, north = other
    return west <= right and left <= east and south <= high and low <= north


class BoxRows:
    """A search structure for boxes on one lattice, extended by `reach` to the right and upwards."""

    def __init__(self, boxes: Sequence[Bounds], reach: int = 0) -> None:
        count = max(len(boxes), 1)
        self._south = min((box[2] for box in boxes), default=0)
        north = max((box[3] for box in boxes), default=0) + reach
        mean = sum(box[3] - box[2] for box in boxes) // count
        self._height = int(max(mean, (north - self._south) * PER_ROW // count)) + 1
        number = (north - self._south) // self._height + 1
        self._rows: list[list[_Entry]] = [[] for _ in range(number)]
        for k, (left, right, low, high) in enumerate(boxes):
            entry = left, right + reach, low, high + reach, k
            for row in self._find_rows(low, high + reach):
                self._rows[row].append(entry)
        for entries in self._rows:
            entries.sort()

    def _find_rows(self, low: Rational, high: Rational) -> range:
        """Return the indices of the rows that meet an interval of y."""
        south, height = self._south, self._height
        first, last = (low - south) // height, (high - south) // height
        return range(max(first, 0), min(last + 1, len(self._rows)))

    def add(self, box: Bounds, number: int) -> None:
        """Add a box inside the bounds of the existing boxes. Cost: O(boxes in its rows)."""
        for row in self._find_rows(*box[2:]):
            insort(self._rows[row], (*box, number))

    def find(self, box: Bounds) -> Iterator[int]:
        """Yield the index of each box that meets a box.

        Cost: O(1) for each box in the same rows whose left end is not beyond the box.
        """
        left, right, low, high = box
        for row in self._find_rows(low, high):
            border = self._south + row * self._height
            for west, east, south, north, k in self._rows[row]:
                if west > right:
                    break
                if (
                    east >= left
                    and south <= high
                    and north >= low
                    and (low >= border or south >= border)
                ):
                    yield k

    def find_pairs(self) -> Iterator[tuple[int, int]]:
        """Yield each pair of intersecting boxes once, the smaller index first.

        Cost: O(1) for each pair of boxes in a row whose x-ranges meet.
        """
        for number, row in enumerate(self._rows):
            border = self._south + number * self._height
            for i, (_, right, low, high, k) in enumerate(row, 1):
                for left, _, other_low, other_high, j in row[i:]:
                    if left > right:
                        break
                    if (
                        low <= other_high
                        and other_low <= high
                        and (low >= border or other_low >= border)
                    ):
                        yield (k, j) if k < j else (j, k)


def find_near(boxes: Sequence[Bounds], reach: int = 0) -> Iterator[tuple[int, int]]:
    """Yield once each pair of boxes within reach in both coordinates, the smaller index first.

    Cost: O(n log n + k) for n boxes and k pairs, if the boxes are not much longer than the
    gaps between them.
    """
    return BoxRows(boxes, reach).find_pairs()
