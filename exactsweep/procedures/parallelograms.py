"""Squares of a grid inside parallelograms, which an edge of each of two shapes spans.

Floats choose the parallelograms, the greatest first, and find the rows of their squares. Their
error has a proved bound. In units of squares all coordinates are below 2**14, so rounding one
coordinate changes it by less than 2**-39. A side gives ordinates at borders of columns only if it
spans more than `_MARGIN` columns. So the error of a quotient along a side is less than 2**-32, and
that of an ordinate less than 2**-17. Only rows and columns that lie inside by more than `_MARGIN`
count.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import ceil, floor, frexp, hypot

from exactsweep.geometry.overlap import Rings
from exactsweep.numbers.number import Rational, Vertex

_MARGIN = 1 / 64
_NARROW = 3
"""The width in squares below which a parallelogram contains few squares."""
_PATIENCE = 3
"""The number of covered parallelograms of one size that are tolerated for each uncovered one."""
_OF_COVERED = 2
"""The cost of a covered parallelogram, in borders of columns."""

_SpannedCorner = tuple[float, float]
_SpanningEdge = tuple[Vertex, Vertex, float, float]


def fill_parallelograms(
    columns: list[int], corner: Vertex, side: Rational, shapes: tuple[Rings, Rings], work: int
) -> None:
    """Add the squares inside parallelograms, size by size, up to a limit of work for each size.

    Args:
        columns: an int for each column, whose bits are the covered squares; changed in place.
        corner: the lower left corner of the first row of the first column.
        side: the side of a square.
        shapes: the rings of D and of H.
        work: about the greatest number of column borders to cross for each size; the next size is
            half as large.

    Cost: O(work) for each size.
    """
    sides = [_list_longest(rings, side, work) for rings in shapes]
    found = []
    for i, (_, _, ax, ay) in enumerate(sides[0]):
        length = hypot(ax, ay)
        for j, (_, _, bx, by) in enumerate(sides[1]):
            area = ax * by - ay * bx
            if abs(area) > _NARROW * max(length, abs(bx), abs(by)):
                # Within one size, the order takes them from all over the shapes.
                found.append((-frexp(area)[1], (7919 * i + 104729 * j) % 10007, i, j))
    found.sort()
    x, y = corner
    spent = filled = passed = 0
    of_size = 0
    for size, _, i, j in found:
        if size != of_size:
            of_size, spent, filled, passed = size, 0, 0, 0
        elif spent > work or passed > _PATIENCE * (filled + _PATIENCE):
            continue
        (p, q, *_), (r, s, *_) = sides[0][i], sides[1][j]
        corners = [
            (float((a[0] + b[0] - x) / side), float((a[1] + b[1] - y) / side))
            for a, b in ((p, r), (q, r), (q, s), (p, s))
        ]
        if _is_covered(columns, corners):
            spent += _OF_COVERED
            passed += 1
        else:
            filled += 1
            spent += _fill(columns, corners)


def _list_longest(rings: Rings, side: Rational, work: int) -> list[_SpanningEdge]:
    """List the longest edges, with their vectors in squares."""
    edges = [
        (p, q, float((q[0] - p[0]) / side), float((q[1] - p[1]) / side))
        for ring in rings
        for p, q in zip((ring[-1], *ring[:-1]), ring, strict=True)
    ]
    # Edges that can span a wide enough parallelogram, and not more pairs than the work allows.
    edges = [edge for edge in edges if hypot(*edge[2:]) > _NARROW]
    edges.sort(key=lambda edge: -hypot(*edge[2:]))
    return edges[: max(1, round((2 * work) ** 0.5))]


def _is_covered(columns: list[int], corners: list[_SpannedCorner]) -> bool:
    """Decide whether the middle of a parallelogram and places near its corners are covered."""
    (ax, ay), _, (bx, by), _ = corners
    x, y = (ax + bx) / 2, (ay + by) / 2
    near = [(x + 0.9 * (u - x), y + 0.9 * (v - y)) for u, v in corners]
    return all(columns[int(u)] >> int(v) & 1 for u, v in [(x, y), *near])


def _fill(columns: list[int], corners: list[_SpannedCorner]) -> int:
    """Add the squares inside one parallelogram, and return the number of its column borders."""
    k = min(range(4), key=lambda i: corners[i])
    start, one, end, other = corners[k:] + corners[:k]
    turn = (one[0] - start[0]) * (end[1] - start[1]) - (one[1] - start[1]) * (end[0] - start[0])
    lower, upper = (one, other) if turn > 0 else (other, one)
    first, last = floor(start[0] + _MARGIN) + 1, ceil(end[0] - _MARGIN)
    floors = pairwise(_read_off(start, lower, end, first, last, max))
    ceilings = pairwise(_read_off(start, upper, end, first, last, min))
    for k, (below, above) in enumerate(zip(floors, ceilings, strict=True), first):
        low, high = floor(max(below) + _MARGIN) + 1, ceil(min(above) - _MARGIN) - 1
        if 0 <= low < high:
            columns[k] |= (1 << (high - low)) - 1 << low
    return max(1, last - first)


def _read_off(
    start: _SpannedCorner,
    middle: _SpannedCorner,
    end: _SpannedCorner,
    first: int,
    last: int,
    inner: Callable[[float, float], float],
) -> list[float]:
    """Return ordinates of two sides at borders of columns; of a steep side, the inner end."""
    found: list[float] = []
    for (ax, ay), (bx, by), stop in ((start, middle, floor(middle[0]) + 1), (middle, end, last)):
        borders = range(first + len(found), min(stop, last))
        if bx - ax > _MARGIN:
            slope = (by - ay) / (bx - ax)
            found += [ay + (x - ax) * slope for x in borders]
        else:
            found += [inner(ay, by)] * len(borders)
    return found
