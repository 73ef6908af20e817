"""The inside of a trajectory as a directrix for the inverse generatrix (Lemma 5.3).

The complement of the lower trajectory's upper side, turned by half a turn, is a bottom chain whose
convex parts are the concave runs of T.  Their vertices are mostly crossings, not on the lattice;
but a part is swept by moving its edges, which are pieces of lattice edges, by vertices of G, and
G's edges by its vertices, so that integer lines and breaks n/d are all that is needed.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import inf
from typing import NamedTuple, cast

from exactsweep.ceiling import Box
from exactsweep.chain import Edge, Vertex
from exactsweep.envelope import Envelope
from exactsweep.parts import ConvexPart
from exactsweep.piece import Break, Line, Piece, gap, joined, line_of, lower_bound, slope_bound


class Run(NamedTuple):
    """A convex part of the complement: edges, each whole, and the breaks between which they hold.

    `lines` are those of the edges, `sources` those of the trajectory's edges.
    `turns_left` and `turns_right` say whether the generatrix has to turn about that end; where it
    need not, the neighbouring part is at least as low (see `exactsweep.parts`).
    """

    edges: list[Edge]
    lines: list[Line]
    breaks: list[Break]
    sources: list[int]
    turns_left: bool
    turns_right: bool

    @property
    def box(self) -> Box:
        """Its box, x and y rounded outwards to ints.

        A convex part is lowest at an end or at a vertex, all of which are breaks.
        """
        lines, breaks = self.lines, self.breaks
        low = min(lower_bound(lines[0], breaks[0]), *map(lower_bound, lines, breaks[1:]))
        (left, left_d), (right, right_d) = breaks[0], breaks[-1]
        return Box(
            left // left_d,
            -(-right // right_d),
            low,
            -inf if self.turns_left else slope_bound(self.edges[0]),
            inf if self.turns_right else slope_bound(self.edges[-1]),
        )

    def swept(self, chain: ConvexPart, source: int) -> Envelope:
        """The CC sweep of a part of reversed G_t along this part, as far as it matters.

        Arguments and result as for `ConvexPart.swept`.  Cost: O(m_i + n_t).
        """
        points, others_left, others_right = chain
        lines, all_breaks = self.lines, self.breaks
        steps = [(qx - px, qy - py) for (px, py), (qx, qy) in pairwise(points)]
        at, last = 0, len(steps)
        first, end = 0, len(lines)
        if not self.turns_left:
            dx, dy, _ = lines[0]
            while at < last and steps[at][1] * dx < steps[at][0] * dy:
                at += 1
        if not self.turns_right:
            dx, dy, _ = lines[-1]
            while at < last and steps[last - 1][1] * dx > steps[last - 1][0] * dy:
                last -= 1
        if others_left is not None:
            x, y = steps[0]
            while first < end and lines[first][1] * x < lines[first][0] * y:
                first += 1
        if others_right is not None:
            x, y = steps[-1]
            while first < end and lines[end - 1][1] * x > lines[end - 1][0] * y:
                end -= 1
        n, d = all_breaks[first]
        edges: list[Piece] = []
        breaks: list[Break] = [(n + points[at][0] * d, d)]
        for k in range(first, end):
            dx, dy, _ = lines[k]
            start = at
            while at < last and steps[at][1] * dx < steps[at][0] * dy:
                at += 1
            if at > start:
                self._turn(points[start : at + 1], lines[k], all_breaks[k], edges, breaks)
            (px, py), (qx, qy) = self.edges[k]
            sx, sy = points[at]
            if at < last and steps[at][1] * dx == steps[at][0] * dy:
                at += 1
            ex, ey = points[at]
            edges.append(((px + sx, py + sy), (qx + ex, qy + ey)))
            n, d = all_breaks[k + 1]
            breaks.append((n + ex * d, d))
        if at < last:
            line = lines[min(end, len(lines) - 1)]
            self._turn(points[at : last + 1], line, all_breaks[end], edges, breaks)
        return Envelope(breaks, edges, [source] * len(edges))

    @staticmethod
    def _turn(
        chain: Sequence[Vertex], line: Line, at: Break, edges: list[Piece], breaks: list[Break]
    ) -> None:
        """Append the edges of the generatrix while it turns about the point of a line."""
        n, d = at
        dx, dy, c = line
        # The point is (x / w, y / w).
        x, y, w = n * dx, dy * n + c * d, dx * d
        px, py = chain[0]
        for qx, qy in chain[1:]:
            edge_x, edge_y = qx - px, qy - py
            offset = (py * w + y) * edge_x - (px * w + x) * edge_y
            edges.append((edge_x * w, edge_y * w, offset))
            breaks.append((n + qx * d, d))
            px, py = qx, qy


def inside_runs(trajectory: Envelope) -> list[Run]:
    """The convex parts of the inverse of the complement of a lower trajectory, left to right.

    Cost: O(t).
    """
    trajectory_edges = cast(list[Edge], trajectory.edges)
    edges = [((-qx, -qy), (-px, -py)) for (px, py), (qx, qy) in reversed(trajectory_edges)]
    lines = [line_of(edge) for edge in edges]
    breaks = [(-n, d) for n, d in reversed(trajectory.breaks)]
    sources = trajectory.sources[::-1]
    size = len(edges)
    runs: list[Run] = []
    start, turns_left = 0, True
    for k in range(1, size + 1):
        turns_right = turns_next = True
        if k < size:
            if joined(trajectory_edges[size - k - 1], trajectory_edges[size - k]):
                # A convex vertex of T, reflex here.
                turns_right = turns_next = False
            else:
                n, d = breaks[k]
                u, v = gap(lines[k - 1], lines[k])
                above = u * n + v * d
                if above == 0 and u < 0:
                    continue
                turns_right, turns_next = above < 0, above > 0
        runs.append(
            Run(
                edges[start:k],
                lines[start:k],
                breaks[start : k + 1],
                sources[start:k],
                turns_left,
                turns_right,
            )
        )
        start, turns_left = k, turns_next
    return runs
