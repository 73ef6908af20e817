"""The test for closed polygonal lines that touch or cross themselves: a Shamos-Hoey sweep on ints.

M. I. Shamos and D. Hoey, "Geometric intersection problems", 17th FOCS (1976).
"""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Literal, NamedTuple

from exactsweep.numbers.number import Vertex

# A line as (dx, dy, c): a point (x, y) lies left of it if dx * y - dy * x > c.
_DirectedLine = tuple[int | Fraction, int | Fraction, int | Fraction]


class Conflict(NamedTuple):
    """Two features of a ring that meet, each by the index of a vertex or an edge."""

    kind: Literal["vertices coincide", "vertex touches edge", "edges cross"]
    first: int
    second: int


def find_conflict(ring: Sequence[Vertex]) -> Conflict | None:
    """Find two features of a ring that meet and should not; None if the ring is simple.

    The ring has at least three integer points, not all collinear, no two neighbours equal, no edge
    that turns back onto the edge before it; collinear vertices are allowed. Edge i runs from vertex
    i to the next. Cost: O(n log n) comparisons, and moves in the status list.
    """
    order = sorted(range(len(ring)), key=ring.__getitem__)
    for i, j in pairwise(order):
        if ring[i] == ring[j]:
            return Conflict("vertices coincide", min(i, j), max(i, j))
    return _sweep(ring, order)


def _sweep(ring: Sequence[Vertex], order: Sequence[int]) -> Conflict | None:
    """Sweep distinct vertices in lexicographic order, as by a slightly tilted vertical line.

    The status holds the edges that cross the line, bottom to top. Invariant: no two edges that were
    ever neighbours in it meet. So features that meet at the next vertex are found there or earlier.
    """
    n = len(ring)
    lines = [_line(ring[i], ring[(i + 1) % n]) for i in range(n)]
    status: list[int] = []
    for v in order:
        point = x, y = ring[v]
        before, after = (v - 1) % n, v
        low, high = 0, len(status)
        while low < high:
            middle = (low + high) // 2
            edge = status[middle]
            if edge in (before, after):
                # v is the end of the edge.
                low = middle
                break
            dx, dy, c = lines[edge]
            side = dx * y - dy * x - c
            if side == 0:
                return Conflict("vertex touches edge", v, edge)
            if side > 0:
                low = middle + 1
            else:
                high = middle
        previous_ends = ring[before] < point
        next_ends = ring[(v + 1) % n] < point
        if previous_ends and next_ends:
            # Both edges end here and are neighbours: an edge between them would meet them here.
            if low and status[low - 1] in (before, after):
                low -= 1
            del status[low : low + 2]
            fresh = [(low - 1, low)]
        elif previous_ends or next_ends:
            status[low] = after if previous_ends else before
            fresh = [(low - 1, low), (low, low + 1)]
        else:
            (ax, ay, _), (bx, by, _) = lines[before], lines[after]
            lower_first = ax * by - ay * bx > 0
            status[low:low] = (before, after) if lower_first else (after, before)
            fresh = [(low - 1, low), (low + 1, low + 2)]
        for i, j in fresh:
            if i >= 0 and j < len(status):
                conflict = _meet(ring, lines, status[i], status[j])
                if conflict is not None:
                    return conflict
    return None


def _line(a: Vertex, b: Vertex) -> _DirectedLine:
    if b < a:
        a, b = b, a
    dx, dy = b[0] - a[0], b[1] - a[1]
    return dx, dy, dx * a[1] - dy * a[0]


def _meet(
    ring: Sequence[Vertex], lines: Sequence[_DirectedLine], i: int, j: int
) -> Conflict | None:
    """Test two edges of a ring with distinct vertices and without edges that turn back."""
    n = len(ring)
    if (i + 1) % n == j or (j + 1) % n == i:
        return None
    i, j = min(i, j), max(i, j)
    i_ends, j_ends = (i, (i + 1) % n), (j, (j + 1) % n)
    i_sides = [_side(lines[j], ring[v]) for v in i_ends]
    if min(i_sides) > 0 or max(i_sides) < 0:
        return None
    j_sides = [_side(lines[i], ring[v]) for v in j_ends]
    if _both_sides(i_sides) and _both_sides(j_sides):
        return Conflict("edges cross", i, j)
    for ends, sides, edge, other in (
        (i_ends, i_sides, j, j_ends),
        (j_ends, j_sides, i, i_ends),
    ):
        low, high = sorted(ring[v] for v in other)
        for v, side in zip(ends, sides, strict=True):
            if side == 0 and low < ring[v] < high:
                return Conflict("vertex touches edge", v, edge)
    return None


def _side(line: _DirectedLine, point: Vertex) -> int | Fraction:
    return line[0] * point[1] - line[1] * point[0] - line[2]


def _both_sides(sides: Sequence[int | Fraction]) -> bool:
    return min(sides) < 0 < max(sides)
