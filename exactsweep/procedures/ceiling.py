"""The pruning step of the MM sweep, which skips subtrajectories above the envelope.

The x-range is cut into strips. The ceiling is an upper bound of the envelope over each strip,
initially infinity. The parts of both chains are tried in order of their lowest points.

    (1)  A pair is dropped if its lowest point is not below the ceiling over its x-range.
    (2)  A subtrajectory lowers the ceiling over each strip that it crosses: it is convex, so its
         heights at both borders bound it.
    (3)  A subtrajectory that is nowhere below the ceiling is also dropped.

Heights are ints, rounded conservatively, so a dropped subtrajectory is above the envelope. Without
this step, trajectories of two zigzags take twice (64 vertices) or five times (256) as long.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from itertools import product
from math import inf
from operator import itemgetter

from exactsweep.procedures import cc
from exactsweep.procedures.chain import ConvexPart
from exactsweep.procedures.graph import Graph, Ranges

STRIPS = 8
"""Strips per part of the shorter list; a subtrajectory crosses O(1) of them on average.

With 4 and 16, all loops of zigzags of 256 vertices took 1.6 and 0.9 times as long; those of
staircases of 256 vertices, which have less to prune, took 1.0 and 1.15 times as long.
"""


def subtrajectories(
    generatrix_parts: Sequence[ConvexPart],
    directrix_parts: Sequence[ConvexPart],
    ranges: Ranges | None = None,
) -> list[list[Graph]]:
    """Return the subtrajectories that may be on the envelope.

    Cost: O(strips crossed) for each pair of parts, O(1) on average; memory O(parts + result).
    """
    count = STRIPS * min(len(generatrix_parts), len(directrix_parts))
    if ranges is None and count <= STRIPS**2:
        # Bounding so few subtrajectories costs more than computing them.
        return cc.subtrajectories(generatrix_parts, directrix_parts)
    rows, columns = bound_all(generatrix_parts), bound_all(directrix_parts)
    left, right = min(row[1] for row in rows), max(row[2] for row in rows)
    start, end = min(column[1] for column in columns), max(column[2] for column in columns)
    ceiling = Ceiling(left + start, right + end, count, ranges)
    # Parts of D_b that no range needs would cost O(n) tests each.
    columns = [c for c in columns if ceiling.is_above(-inf, left + c[1], right + c[2])]
    found: list[list[tuple[int, Graph]]] = [[] for _ in generatrix_parts]
    for (g_low, g_left, g_right, i, g), (d_low, d_left, d_right, j, d) in product(rows, columns):
        if (
            g.faces(d)
            and ceiling.is_above(g_low + d_low, g_left + d_left, g_right + d_right)  # (1)
            and ceiling.lower(graph := cc.subtrajectory(g, d))  # (3)
        ):
            found[i].append((j, graph))
    return [[graph for _, graph in sorted(row, key=itemgetter(0))] for row in found]


def bound_all(
    parts: Sequence[ConvexPart],
) -> list[tuple[int, int, int, int, ConvexPart]]:
    """Return (least y, left, right, number, part) of each part, rounded outwards, lowest first."""
    bounds = []
    for k, part in enumerate(parts):
        left, _, w = part.vertices[part.first]
        right, _, v = part.vertices[part.first + len(part.edges)]
        # The first edge that does not descend starts at the lowest vertex.
        _, low, u = part.vertices[part.first + bisect_left(part.edges, (0,))]
        bounds.append((low // u, left // w, -(-right // v), k, part))
    return sorted(bounds, key=itemgetter(0))


class Ceiling:
    """An upper bound of the envelope over each strip; -infinity outside the ranges."""

    def __init__(self, left: int, right: int, count: int, ranges: Ranges | None) -> None:
        self.left = left
        self.width = (right - left) // count + 1
        self.heights: list[int | float] = [inf if ranges is None else -inf] * count
        for (x, w), (u, v) in ranges or ():
            first, last = self._find_strip(x // w), self._find_strip(u // v) + 1
            self.heights[first:last] = [inf] * (last - first)

    def _find_strip(self, x: int) -> int:
        return (x - self.left) // self.width

    def is_above(self, low: int | float, left: int, right: int) -> bool:
        """Decide whether the ceiling is above a height in any strip of an x-range."""
        return low < max(self.heights[self._find_strip(left) : self._find_strip(right) + 1])

    def lower(self, graph: Graph) -> bool:
        """Lower the ceiling by a convex graph; return whether the graph is below it anywhere."""
        (x, y, w), _, _ = graph.pieces[0][3]
        heights, width = self.heights, self.width
        strip = self._find_strip(x // w)
        border = self.left + (strip + 1) * width
        # The height at the last border, or at the left end of the graph before the first border
        # (not `begun`), and the least height since.
        height = lowest = y // w
        begun = below = False
        for dx, dy, c, _, ((x, y, w), _, _) in graph.pieces:
            while border * w <= x:
                before, height, top = height, (dy * border + c) // dx, heights[strip]
                if lowest < top or height < top:
                    below = True
                    if begun and before < top and height < top:  # (2)
                        heights[strip] = max(before, height) + 1
                begun, lowest = True, height
                strip += 1
                border += width
            if dy < 0:
                lowest = y // w
        return below or lowest < heights[strip]
