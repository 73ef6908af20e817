"""The test for closed polygonal lines that touch or cross themselves.

Source: M. I. Shamos and D. Hoey, "Geometric intersection problems", 17th FOCS (1976).
"""

from bisect import bisect_left
from collections.abc import Sequence
from itertools import pairwise
from typing import Literal, NamedTuple

from exactsweep.geometry.vectors import is_on_segment, orientation, touch
from exactsweep.numbers.number import Edge, Vertex


class Conflict(NamedTuple):
    """Two features of a ring that meet, as indices of vertices or edges."""

    kind: Literal["vertices coincide", "vertex touches edge", "edges cross"]
    first: int
    second: int


def find_conflict(ring: Sequence[Vertex]) -> Conflict | None:
    """Find two features of a ring that meet and should not; None if the ring is simple.

    The ring has at least three integer points, not all collinear, no equal neighbors and no spike;
    collinear vertices are allowed. Edge i runs from vertex i to the next. Cost: O(n log n)
    comparisons, plus moves in the status list.
    """
    order = sorted(range(len(ring)), key=ring.__getitem__)
    for i, j in pairwise(order):
        if ring[i] == ring[j]:
            return Conflict("vertices coincide", min(i, j), max(i, j))
    return _sweep(ring, order)


def _sweep(ring: Sequence[Vertex], order: Sequence[int]) -> Conflict | None:
    """Sweep a slightly tilted vertical line across distinct vertices, in the given order.

    The status lists the edges that cross the line, from bottom to top. Invariant: no two edges that
    were ever neighbors in it meet. So a conflict at the next vertex is found there or earlier.
    """
    n = len(ring)
    edges = [(min(p, q), max(p, q)) for p, q in pairwise((*ring, ring[0]))]
    status: list[int] = []
    for v in order:
        point, before, after = ring[v], (v - 1) % n, v
        own = before, after
        low = bisect_left(
            status, True, key=lambda e: e in own or orientation(*edges[e], point) <= 0
        )
        edge = status[low] if low < len(status) else before
        if edge not in own and orientation(*edges[edge], point) == 0:
            return Conflict("vertex touches edge", v, edge)
        previous_ends, next_ends = edges[before][1] == point, edges[after][1] == point
        if previous_ends and next_ends:
            # Both edges are adjacent in the status: an edge between them would meet them here.
            status[low : low + 2] = []
            fresh = [(low - 1, low)]
        elif previous_ends or next_ends:
            status[low] = after if previous_ends else before
            fresh = [(low - 1, low), (low, low + 1)]
        else:
            lower_first = orientation(point, ring[before], edges[after][1]) > 0
            status[low:low] = (before, after) if lower_first else (after, before)
            fresh = [(low - 1, low), (low + 1, low + 2)]
        for i, j in fresh:
            if i >= 0 and j < len(status):
                conflict = _meet(ring, edges, *sorted((status[i], status[j])))
                if conflict is not None:
                    return conflict
    return None


def _meet(ring: Sequence[Vertex], edges: Sequence[Edge], i: int, j: int) -> Conflict | None:
    """Test two edges of a ring with distinct vertices and no spikes."""
    n = len(ring)
    if j - i in (1, n - 1) or touch(*edges[i], *edges[j]) == []:
        return None
    for v, edge in ((i, j), (i + 1, j), (j, i), ((j + 1) % n, i)):
        if is_on_segment(ring[v], *edges[edge]):
            return Conflict("vertex touches edge", v, edge)
    return Conflict("edges cross", i, j)
