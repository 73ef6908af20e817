"""The inside of a trajectory as a directrix for the inverse generatrix (Lemma 5.3).

The complement of the lower trajectory's upper side, turned by half a turn, is a bottom chain whose
convex parts are the concave runs of T.  Their vertices are mostly crossings, not on the lattice;
but a part is swept by moving its edges, which are pieces of lattice edges, by vertices of G, and
G's edges by its vertices, so that integer lines and breaks n/d are all that is needed.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, cast

from exactsweep.ceiling import Box
from exactsweep.chain import Edge, Vertex
from exactsweep.envelope import Envelope
from exactsweep.piece import Break, Piece, cross, gap, joined, line_of, lower_bound


class Run(NamedTuple):
    """A convex part of the complement: edges, each whole, and the breaks between which they hold.

    `sources` are those of the trajectory's edges.
    `turns_left` and `turns_right` say whether the generatrix has to turn about that end; where it
    need not, the neighbouring part is at least as low (see `exactsweep.parts`).
    """

    edges: list[Edge]
    breaks: list[Break]
    sources: list[int]
    turns_left: bool
    turns_right: bool

    @property
    def box(self) -> Box:
        """Bounds, rounded outwards to ints, of least x, greatest x and least y.

        A convex part is lowest at an end or at a vertex, all of which are breaks.
        """
        low = min(
            min(lower_bound(line, left), lower_bound(line, right))
            for line, left, right in zip(
                map(line_of, self.edges), self.breaks, self.breaks[1:], strict=False
            )
        )
        (left, left_d), (right, right_d) = self.breaks[0], self.breaks[-1]
        return left // left_d, -(-right // right_d), low

    def swept(self, chain: Sequence[Vertex], source: int, *, turns_left: bool = False) -> Envelope:
        """The CC sweep of a convex chain of reversed edges along this part, as far as it matters.

        Arguments as for `ConvexPart.swept`.  Cost: O(m_i + n_t).
        """
        edges: list[Piece] = []
        breaks: list[Break] = []
        last = len(chain) - 1
        at = 0
        if not (turns_left or self.turns_left):
            while at < last and cross(chain[at], chain[at + 1], self.edges[0]) < 0:
                at += 1
        n, d = self.breaks[0]
        breaks.append((n + chain[at][0] * d, d))
        for k, edge in enumerate(self.edges):
            start = at
            while at < last and cross(chain[at], chain[at + 1], edge) < 0:
                at += 1
            if at > start:
                self._turn(chain[start : at + 1], edge, self.breaks[k], edges, breaks)
            (px, py), (qx, qy) = edge
            sx, sy = chain[at]
            if at < last and cross(chain[at], chain[at + 1], edge) == 0:
                at += 1
            ex, ey = chain[at]
            edges.append(((px + sx, py + sy), (qx + ex, qy + ey)))
            n, d = self.breaks[k + 1]
            breaks.append((n + ex * d, d))
        if self.turns_right and at < last:
            self._turn(chain[at:], self.edges[-1], self.breaks[-1], edges, breaks)
        return Envelope(breaks, edges, [source] * len(edges))

    @staticmethod
    def _turn(
        chain: Sequence[Vertex], edge: Edge, at: Break, edges: list[Piece], breaks: list[Break]
    ) -> None:
        """Append the edges of the generatrix while it turns about the point of an edge."""
        n, d = at
        dx, dy, c = line_of(edge)
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
                u, v = gap(line_of(edges[k - 1]), line_of(edges[k]))
                above = u * n + v * d
                if above == 0 and u < 0:
                    continue
                turns_right, turns_next = above < 0, above > 0
        runs.append(
            Run(
                edges[start:k],
                breaks[start : k + 1],
                sources[start:k],
                turns_left,
                turns_right,
            )
        )
        start, turns_left = k, turns_next
    return runs
