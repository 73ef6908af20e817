"""Squares of a grid that lie in a shape, grid points inside a shape, and sums of both.

A set of squares or points is a list of ints, one for each column of the grid. Their bits are rows.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain

from exactsweep.geometry.overlap import Rings
from exactsweep.numbers.number import Rational


def find_squares_of_sum(stationary: Rings, moving: Rings, side: int) -> tuple[int, int, list[int]]:
    """Find the squares of one shape, moved by the grid points inside another shape.

    Returns:
        The first column, the first row, and the rows of each column.
    """
    cells_left, cells_low, cells = find_squares_in(stationary, side)
    points_left, points_low, points = find_points_in(moving, side)
    rows = max(map(int.bit_length, cells)) + max(map(int.bit_length, points))
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
    columns = [total >> (k * stride) & mask for k in range(len(cells) + len(points) - 1)]
    return cells_left + points_left, cells_low + points_low, columns


def _stack(stacked: dict[int, int], length: int) -> int:
    """Return the union of the bits moved by 0, 1, ..., length - 1 places."""
    found = stacked.get(length)
    if found is None:
        half = (length + 1) // 2
        part = _stack(stacked, half)
        found = stacked[length] = part | part << (length - half)
    return found


def _find_runs(bits: int) -> Iterator[tuple[int, int]]:
    """Find the runs of ones in an int: the start and the length of each."""
    start = 0
    while bits:
        zeros = (bits & -bits).bit_length() - 1
        bits >>= zeros
        ones = (bits + 1 & ~bits).bit_length() - 1
        yield start + zeros, ones
        start += zeros + ones
        bits >>= ones


def _lay_grid(rings: Rings, side: int) -> tuple[int, int, int]:
    """Find the first column and row of squares that a shape can meet, and the column count."""
    points = list(chain.from_iterable(rings))
    left, low = (int(min(p[k] for p in points) // side) - 1 for k in (0, 1))
    right = int(max(x for x, _ in points) // side) + 1
    return left, low, right - left + 1


def find_squares_in(rings: Rings, side: int) -> tuple[int, int, list[int]]:
    """Find the closed squares in a shape: first column, first row, and the rows of each column.

    A square lies in the shape if no edge comes near it and the number of edges below it, on the
    left border of the column, is odd. Each edge flips all bits above it. The number of edges is
    even, so no bit is set above all edges.
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
            bottom, top = (row, next_row) if row <= next_row else (next_row, row)
            near[k - left] |= _set_bits(bottom - low, top - low)
            if px <= k * side < qx:
                odd[k - left] ^= -1 << (row + 1 - low)
            if dx:
                row = next_row
    return left, low, [o & ~n for o, n in zip(odd, near, strict=True)]


def find_points_in(rings: Rings, side: int) -> tuple[int, int, list[int]]:
    """Find the grid points in the interior of a shape, as `find_squares_in`, by grid lines."""
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
    """Set the bits from one place to another, none if that is the one before."""
    return (1 << (last - first + 1)) - 1 << first


def _list_rising(rings: Rings) -> Iterator[tuple[Rational, Rational, Rational, Rational]]:
    """List the edges, each from its lesser to its greater end."""
    for ring in rings:
        p = ring[-1]
        for q in ring:
            yield (*p, *q) if p < q else (*q, *p)
            p = q
