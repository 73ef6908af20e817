"""The pruning step for wide shapes, in which grid squares prove that contact segments are in O.

(1) Let A be a block of two by two squares inside D, off its boundary, and let H have a point b in
    a square B. Then A + b is in O = int D + int H, because b is a limit of interior points of H.
    For any b in B, A + b contains the square in the middle of A + B.

A set of squares is a list of bitmasks, one int per column and one bit per row.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from fractions import Fraction
from functools import reduce
from itertools import chain, pairwise, product
from math import isqrt
from operator import or_

from exactsweep.geometry.edges import Rings
from exactsweep.geometry.near import bound_points
from exactsweep.procedures.segments import ContactSegment

_FEW, _CROSSINGS = 250, Fraction(4, 5)
"""Minimum numbers of segments, and of expected crossings per segment, at which pruning pays off."""
_MOST_COLUMNS = 400
"""Maximum number of columns; adding two sets takes time proportional to its fourth power."""


def leave_out_covered(
    segments: Sequence[ContactSegment], obstacles: Sequence[Rings], moving: Sequence[Rings]
) -> Sequence[ContactSegment]:
    """Return the contact segments whose boxes are not covered by squares.

    Cost: as for `add_squares`, plus O(1) for each column that a box meets.
    """
    if len(segments) < _FEW:
        return segments
    boxes = [segment.box for segment in segments]
    lefts, rights, lows, highs = zip(*boxes, strict=True)
    width, height = max(rights) - min(lefts), max(highs) - min(lows)
    area = (sum(rights) - sum(lefts)) * (sum(highs) - sum(lows))
    if 2 * area < _CROSSINGS * len(segments) * width * height:
        return segments
    extent = max(map(_find_extent, obstacles)) + max(map(_find_extent, moving))
    side = max(1, extent // min(isqrt(8 * len(segments)), _MOST_COLUMNS))
    sums = [add_squares(*pair, side) for pair in product(obstacles, moving)]
    lowest = min(low for _, low, _ in sums)
    columns: defaultdict[int, int] = defaultdict(int)
    for left, low, squares in sums:
        for k, rows in enumerate(squares, left):
            columns[k] |= rows << low - lowest

    def is_covered(left: int, right: int, low: int, high: int) -> bool:
        rows = (2 << high // side - lowest) - (1 << low // side - lowest)
        return all(columns[k] & rows == rows for k in range(left // side, right // side + 1))

    return [segment for segment, box in zip(segments, boxes, strict=True) if not is_covered(*box)]


def _find_extent(rings: Rings) -> int:
    """Return the greater of the width and the height of a shape, rounded down."""
    left, right, low, high = bound_points(chain.from_iterable(rings))
    return max(right - left, high - low) // 1


def add_squares(stationary: Rings, moving: Rings, side: int) -> tuple[int, int, list[int]]:
    """Return the squares in O by (1): first column, first row, columns."""
    left, low, near, inside = find_squares(stationary, side)
    squares = [a & ~b for a, b in zip(inside, near, strict=True)]
    # Each block A, by its lower left square.
    squares = [a & a >> 1 & b & b >> 1 for a, b in pairwise(squares)]
    other_left, other_low, near, inside = find_squares(moving, side)
    # All squares B.
    others = [a | b for a, b in zip(near, inside, strict=True)]
    # All columns of a set are packed into one int, at a fixed stride.
    stride = max(map(int.bit_length, squares)) + max(map(int.bit_length, others))
    packed = sum(rows << k * stride for k, rows in enumerate(squares))
    total = 0
    for k, rows in enumerate(others):
        bits = [r for r, bit in enumerate(reversed(f"{rows:b}")) if bit == "1"]
        total |= reduce(or_, (packed << r for r in bits), 0) << k * stride
    mask = (1 << stride) - 1
    # The middle of A + B is one column and one row beyond the sum of their lower left corners.
    found = [total >> k * stride & mask for k in range(len(squares) + len(others))]
    return left + other_left + 1, low + other_low + 1, found


def find_squares(rings: Rings, side: int) -> tuple[int, int, list[int], list[int]]:
    """Return the first column and row, the closed squares that edges meet, and those inside.

    A square that meets an edge may also be among those inside.
    """
    left, right, low, _ = (c // side for c in bound_points(chain.from_iterable(rings)))
    left, low = left - 1, low - 1
    near = [0] * (right - left + 1)
    odd = near[:]
    for (px, py), (qx, qy) in (
        sorted(edge) for ring in rings for edge in pairwise([ring[-1], *ring])
    ):
        dx, dy, first, last = qx - px, qy - py, -(-px // side) - 1, qx // side
        # The heights of the edge at the left and right borders of its columns, times dx.
        xs = [px, *range((first + 1) * side, last * side + 1, side), qx]
        heights = pairwise([py * dx + (x - px) * dy for x in xs]) if dx else [(py, qy)] * len(xs)
        unit = side * (dx or 1)
        for k, (start, end) in zip(range(first, last + 1), heights, strict=False):
            top, bottom = max(start, end) // unit - low, -(-min(start, end) // unit) - 1 - low
            near[k - left] |= (2 << top) - (1 << bottom)
            if px <= k * side < qx:
                # The parity of the edges below each square, along the left border of the column.
                odd[k - left] ^= -1 << start // unit + 1 - low
    return left, low, near, odd
