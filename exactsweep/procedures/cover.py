"""Positions that are known to be overlapped, in squares of a grid: what lies there need not be cut.

Most of a contact segment runs through the inside of the positions of overlap O = int D + int H. The
plane is cut into squares of side h, and with

(1) A, the closed squares that lie in D, and B, the grid points in the interior of H,

each square of A moved by a point of B lies in O: a point p of the square is the limit of inner
points of D, so that p + b = p' + b' for an inner point p' near p and a b' near b, inner to H. Both
sets are kept as bits of ints, a column of squares after the other, and so A + B is a union of
shifted ints. Bounds are rounded so that a square or a point is left out rather than wrong.

(2) Of a stretch, only what lies in columns where it leaves the squares of A + B matters. It is cut
    at borders of columns; just inside of a cut there is overlap.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain

from exactsweep.geometry.overlap import Rings
from exactsweep.numbers.point import Rational
from exactsweep.procedures.contact_lines import Stretch

_FEW = 400
"""As many stretches are cut faster as they are."""
_SQUARES_PER_STRETCH = 2


def leave_out_covered(stretches: list[Stretch], stationary: Rings, moving: Rings) -> list[Stretch]:
    """What matters of stretches, by (2).

    Args:
        stretches: of the contact segments of D and H.
        stationary: the rings of D, which is bounded.
        moving: the rings of H.

    Returns:
        Stretches between the same lines, with ends that are covered marked.

    Cost: O(s) for s squares, about twice as many as stretches, in words of their columns, and
    O(k + x) for k stretches and x columns that they cross.
    """
    if len(stretches) < _FEW:
        return stretches
    cover = Cover(stationary, moving, round((_SQUARES_PER_STRETCH * len(stretches)) ** 0.5))
    return list(chain.from_iterable(map(cover.uncovered, stretches)))


class Cover:
    """The squares of A + B, for a grid with about so many columns over each shape."""

    def __init__(self, stationary: Rings, moving: Rings, columns: int) -> None:
        spans = [
            int(max(p[k] for p in ring) - min(p[k] for p in ring))
            for ring in (stationary[0], moving[0])
            for k in (0, 1)
        ]
        self.side = max(1, max(spans) // columns)
        cells_left, cells_low, cells = find_squares_in(stationary, self.side)
        points_left, points_low, points = find_points_in(moving, self.side)
        rows = max(map(int.bit_length, cells), default=0)
        rows += max(map(int.bit_length, points), default=0)
        stride = rows + 1
        packed = 0
        for cell_column in reversed(cells):
            packed = packed << stride | cell_column
        stacked = {1: packed}
        total = 0
        for k, point_column in enumerate(points):
            for start, length in _find_runs(point_column):
                total |= _stack(stacked, length) << (k * stride + start)
        mask = (1 << stride) - 1
        self.left, self.low = cells_left + points_left, cells_low + points_low
        self.columns = [total >> (k * stride) & mask for k in range(len(cells) + len(points) - 1)]

    def uncovered(self, stretch: Stretch) -> Iterator[Stretch]:
        """The pieces of a stretch that leave the squares, cut at borders of columns."""
        side, dx, dy, c = self.side, stretch.dx, stretch.dy, stretch.c
        (low, _), (high, _) = stretch.low, stretch.high
        if dx == 0:
            first = int(low // side) - self.low
            last = int(high // side) - self.low
            if not self._covers(int(-c // side) - self.left, first, last):
                yield stretch
            return
        column = int(low // side)
        end = int(-(-high // side))
        unit = dx * side
        row = int((low * dy + c) // unit)
        since: Rational | None = None
        reach: Rational = low
        for k in range(column, end):
            until = min(high, (k + 1) * side)
            next_row = int((until * dy + c) // unit)
            first, last = (row, next_row) if dy >= 0 else (next_row, row)
            if self._covers(k - self.left, first - self.low, last - self.low):
                if since is not None:
                    yield stretch.between(since, reach)
                    since = None
            elif since is None:
                since = reach
            row, reach = next_row, until
        if since is not None:
            yield stretch.between(since, high)

    def _covers(self, column: int, first: int, last: int) -> bool:
        if not 0 <= column < len(self.columns) or first < 0:
            return False
        rows = (1 << (last - first + 1)) - 1
        return self.columns[column] >> first & rows == rows


def _stack(stacked: dict[int, int], length: int) -> int:
    """Bits moved by 0, 1, ..., length - 1 places, all together."""
    found = stacked.get(length)
    if found is None:
        half = (length + 1) // 2
        part = _stack(stacked, half)
        found = stacked[length] = part | part << (length - half)
    return found


def _find_runs(bits: int) -> Iterator[tuple[int, int]]:
    """The runs of ones in an int: where they start and how long they are."""
    start = 0
    while bits:
        zeros = (bits & -bits).bit_length() - 1
        bits >>= zeros
        ones = (bits + 1 & ~bits).bit_length() - 1
        yield start + zeros, ones
        start += zeros + ones
        bits >>= ones


def _lay_grid(rings: Rings, side: int) -> tuple[int, int, int]:
    """The first column and row of squares that a shape can meet, and how many columns there are."""
    points = list(chain.from_iterable(rings))
    left, low = (int(min(p[k] for p in points) // side) - 1 for k in (0, 1))
    right = int(max(x for x, _ in points) // side) + 1
    return left, low, right - left + 1


def find_squares_in(rings: Rings, side: int) -> tuple[int, int, list[int]]:
    """The closed squares that lie in a shape: first column, first row, and the rows of each column.

    A square lies in the shape if no edge comes near it and the number of edges below it, on the
    left border of the column, is odd. Each edge turns all bits above it: above all edges, which are
    an even number, none is left.
    """
    left, low, width = _lay_grid(rings, side)
    near, odd = [0] * width, [0] * width
    for px, py, qx, qy in _list_rising(rings):
        dx, dy = qx - px, qy - py
        first, last = int(-(-px // side)) - 1, int(qx // side)
        row = int(py // side)
        for k in range(first, last + 1):
            right = (k + 1) * side
            if right <= px and dx:
                next_row = row
            elif right >= qx:
                next_row = int(qy // side)
            else:
                next_row = int((py * dx + (right - px) * dy) // (dx * side))
            near[k - left] |= _set_bits(row - low, next_row - low)
            if px <= k * side < qx:
                odd[k - left] ^= -1 << (row + 1 - low)
            if dx:
                row = next_row
    return left, low, [o & ~n for o, n in zip(odd, near, strict=True)]


def find_points_in(rings: Rings, side: int) -> tuple[int, int, list[int]]:
    """The grid points in the interior of a shape, as for `find_squares_in`, by grid lines."""
    left, low, width = _lay_grid(rings, side)
    on, odd = [0] * width, [0] * width
    for px, py, qx, qy in _list_rising(rings):
        dx, dy = qx - px, qy - py
        first, last = int(-(-px // side)), int(qx // side)
        if dx == 0:
            if first == last:
                on[first - left] |= _set_bits(int(-(-py // side)) - low, int(qy // side) - low)
            continue
        for k in range(first, last + 1):
            rise = py * dx + (k * side - px) * dy
            row = int(rise // (dx * side))
            if rise == row * dx * side:
                on[k - left] |= 1 << (row - low)
            if k * side < qx:
                odd[k - left] ^= -1 << (row + 1 - low)
    return left, low, [o & ~n for o, n in zip(odd, on, strict=True)]


def _set_bits(first: int, last: int) -> int:
    """The bits from one place to another, either way round."""
    if first > last:
        first, last = last, first
    return (1 << (last - first + 1)) - 1 << first


def _list_rising(rings: Rings) -> Iterator[tuple[Rational, Rational, Rational, Rational]]:
    """The edges, each from its lesser to its greater end."""
    for ring in rings:
        p = ring[-1]
        for q in ring:
            yield (*p, *q) if p < q else (*q, *p)
            p = q
