"""Squares of a grid that lie in the overlap; pieces of contact segments in them are dropped.

Most of a contact segment runs inside O = int D + int H, the positions of overlap. A grid cuts the
plane into squares of side h.

(1) A closed square lies in O if it lies in A + B, for the closed squares A in D and the grid points
    B inside H. A point p of a square in A is a limit of inner points of D. So p + b = p' + b' for
    an inner point p' of D near p, and an inner point b' of H near b.
(2) Only the columns in which a stretch leaves the squares are relevant. The stretch is cut at
    borders of columns, and just inside each cut there is overlap.

Such squares fill wide shapes. In thin ones, `neighbours` has left out most before.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain

from exactsweep.geometry.overlap import Rings
from exactsweep.numbers.number import Rational, ratio
from exactsweep.procedures.contact_lines import Stretch
from exactsweep.procedures.squares import find_squares_of_sum

_FEW = 250
_FEW_CROSSINGS = 2000
"""The numbers of stretches and of their likely crossings below which a cover gains nothing. It
gains nothing either if there are fewer likely crossings than stretches."""
_SQUARES_PER_STRETCH = 2
_MOST_COLUMNS = 384
"""A sum of (1) takes time by the third power of their number."""
_ONE_OF = 16
"""One of this many stretches is in the sample for estimates."""


def leave_out_covered(stretches: list[Stretch], stationary: Rings, moving: Rings) -> list[Stretch]:
    """Drop the parts of stretches that lie in covered squares, by (2).

    Args:
        stretches: of the contact segments of D and H.
        stationary: the rings of D, which is bounded.
        moving: the rings of H.

    Returns:
        Stretches on the same lines, with marks at covered ends.

    Cost: O(s) word operations for s squares, a fixed number of squares per stretch, and
    O(k log s + x) for k stretches and x columns in which they are not covered.
    """
    if len(stretches) < _FEW:
        return stretches
    some = stretches[::_ONE_OF]
    lefts, rights, lows, highs = zip(*(stretch.bound() for stretch in some), strict=True)
    length = _ONE_OF * (sum(rights) - sum(lefts) + sum(highs) - sum(lows))
    # Stretches in all directions and places cross about as often as the square of their length
    # exceeds the area that they share.
    few = max(_FEW_CROSSINGS, len(stretches))
    if length**2 < few * (max(rights) - min(lefts)) * (max(highs) - min(lows)):
        return stretches
    columns = round((_SQUARES_PER_STRETCH * len(stretches)) ** 0.5)
    cover = Cover(stationary, moving, min(columns, _MOST_COLUMNS))
    return list(chain.from_iterable(map(cover.uncovered, stretches)))


class Cover:
    """The covered squares of a grid, by (1), for a given number of columns over each shape.

    Attributes:
        side: the side of a square.
        left, low: the first column and the first row.
        columns: an int for each column, whose bits are the covered rows.
    """

    def __init__(self, stationary: Rings, moving: Rings, columns: int) -> None:
        spans = [
            int(max(p[k] for p in ring) - min(p[k] for p in ring))
            for ring in (stationary[0], moving[0])
            for k in (0, 1)
        ]
        self.side = max(1, max(spans) // columns)
        self.left, self.low, self.columns = find_squares_of_sum(stationary, moving, self.side)
        self._blocks = _list_blocks(self.columns)

    def uncovered(self, stretch: Stretch) -> Iterator[Stretch]:
        """Find the pieces of a stretch that leave the squares, cut at borders of columns."""
        side, dx, dy, c, e = self.side, stretch.dx, stretch.dy, stretch.c, stretch.e
        (low, below), (high, above) = stretch.low, stretch.high
        start, end = low // (below * side), -(-high // (above * side))
        if dx == 0:
            row, last_row = start - self.low, high // (above * side) - self.low
            if not self._covers(0, -c // (e * side) - self.left, row, last_row):
                yield stretch
            return
        unit = dx * side * e
        row = (low * dy * e + c * below) // (unit * below)
        last_row = (high * dy * e + c * above) // (unit * above)
        k, level, since = start, 0, end
        while k < end:
            # Blocks of columns begin at multiples of their width.
            while level and ((k - self.left) & ((1 << level) - 1) or k + (1 << level) > end):
                level -= 1
            until = k + (1 << level)
            next_row = last_row if until == end else (until * dy * side * e + c) // unit
            first, last = (row, next_row) if dy >= 0 else (next_row, row)
            block = (k - self.left) >> level
            if self._covers(level, block, first - self.low, last - self.low):
                if since < k:
                    yield self._cut(stretch, since, k, start, end)
                since, level = end, min(level + 1, len(self._blocks) - 1)
            elif level:
                level -= 1
                continue
            else:
                since = min(since, k)
            row, k = next_row, until
        if since < end:
            yield self._cut(stretch, since, end, start, end)

    def _cut(self, stretch: Stretch, first: int, last: int, start: int, end: int) -> Stretch:
        """Return the piece of a stretch in some of its columns."""
        if (first, last) == (start, end):
            return stretch
        low: Rational = first * self.side if first > start else ratio(*stretch.low)
        high: Rational = last * self.side if last < end else ratio(*stretch.high)
        return stretch.between(low, high)

    def _covers(self, level: int, block: int, first: int, last: int) -> bool:
        blocks = self._blocks[level]
        if not 0 <= block < len(blocks) or first < 0:
            return False
        rows = (1 << (last - first + 1)) - 1
        return blocks[block] >> first & rows == rows


def _list_blocks(columns: list[int]) -> list[list[int]]:
    """List the rows common to each 1, 2, 4, ... neighbouring columns."""
    blocks = [columns]
    while len(blocks[-1]) > 1:
        below = blocks[-1]
        blocks.append([a & b for a, b in zip(below[::2], below[1::2], strict=False)])
    return blocks
