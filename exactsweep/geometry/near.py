"""The search for intersecting boxes, in rows sorted by left ends.

(1) A row is at least as high as the mean box, so n boxes have at most 2 n entries in all rows.
(2) The lower side of the intersection of two boxes lies in one row, so each pair is found once.
"""

from __future__ import annotations

from bisect import insort
from collections.abc import Iterable, Iterator, Sequence

from exactsweep.numbers.number import Rational, Vertex

Bounds = tuple[Rational, Rational, Rational, Rational]
"""The left, right, low and high end of a closed box."""

_PER_ROW = 16
"""The mean number of boxes in a row. Values from 8 to 64 are equally fast."""

_Entry = tuple[Rational, Rational, Rational, Rational, int]


def bound_points(points: Iterable[Vertex]) -> Bounds:
    """Return the bounds of one or more points."""
    xs, ys = zip(*points, strict=True)
    return min(xs), max(xs), min(ys), max(ys)


class BoxRows:
    """A search structure for boxes on one lattice, extended by `reach` to the right and upwards."""

    def __init__(self, boxes: Sequence[Bounds], reach: int = 0) -> None:
        self._rows: list[list[_Entry]] = []
        self._south: Rational = 0
        self._height = 1
        if not boxes:
            return
        self._south = south = min(box[2] for box in boxes)
        north = max(box[3] for box in boxes) + reach
        mean = sum(box[3] - box[2] for box in boxes) // len(boxes)
        by_count = (north - south) * _PER_ROW // len(boxes)
        self._height = height = int(max(mean, by_count)) + 1
        rows: list[list[_Entry]] = [[] for _ in range(int((north - south) // height) + 1)]
        for k, (left, right, low, high) in enumerate(boxes):
            entry = left, right + reach, low, high + reach, k
            for row in rows[(low - south) // height : (entry[3] - south) // height + 1]:
                row.append(entry)
        for row in rows:
            row.sort()
        self._rows = rows

    def add(self, box: Bounds, number: int) -> None:
        """Add a box inside the bounds of the others. Cost: O(boxes in its rows)."""
        first, last = ((y - self._south) // self._height for y in box[2:])
        for row in self._rows[first : last + 1]:
            insort(row, (*box, number))

    def find(self, box: Bounds) -> Iterator[int]:
        """Yield the index of each box that meets a box.

        Cost: O(1) for each box in the same rows whose left end is not beyond the box.
        """
        left, right, low, high = box
        if not self._rows:
            return
        first = max((low - self._south) // self._height, 0)
        last = max((high - self._south) // self._height, -1)
        border = low
        for number, row in enumerate(self._rows[first : last + 1], first + 1):
            for west, east, south, north, k in row:
                if west > right:
                    break
                if (
                    east >= left
                    and south <= high
                    and north >= low
                    and (south >= border or number == first + 1)
                ):
                    yield k
            border = self._south + number * self._height

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
