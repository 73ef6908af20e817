"""Convex parts, and what of their sub-trajectories matters (Sections 4 and 5, step 1).

Where two parts of D_b meet in a reflex vertex p, G standing on p with an edge steeper than the left
part's last edge would overlap the right part, and with one flatter than the right part's first
edge the left part. So of each sub-trajectory T(G_t, D_i) only the edges from D_i's own first to
its own last one can belong to the lower envelope, and the others need not be made: but for single
points they are above it. At a step of D_b that holds for the higher part only.

A sum does not know which of its two chains moves: the same holds for the convex parts of reversed
G_t and the edges of D_b. In an MM sweep what matters of a pair is the edges whose slopes lie
between the ends of both parts, which for most pairs of real outlines is nothing.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import inf
from operator import itemgetter
from typing import NamedTuple

from exactsweep.geometry.point import Edge, Rational, Vertex
from exactsweep.procedures.cc import merge_by_slope
from exactsweep.procedures.chain import convex_parts
from exactsweep.procedures.envelope import (
    Break,
    Envelope,
    Line,
    Part,
    Piece,
    cross,
    gap,
    line_of,
    lower_bound,
    slope_bound,
)


class ConvexPart(NamedTuple):
    """A convex part of D_b, or of reversed G_t.

    `left` and `right` are breaks on its first and last edge: the other polygon need not turn about
    that end, since the neighbouring part is at least as low there; None where it must.
    """

    points: list[Vertex]
    left: Break | None
    right: Break | None

    def swept(self, chain: ConvexPart, source: int) -> Envelope:
        """The CC sweep of a part of reversed G_t along this part of D_b, as far as it matters.

        Args:
            chain: the part of G_t, its edges whole; of its breaks only whether there are any
                counts.
            source: the number of what is swept.

        Returns an envelope, which has no edges if nothing matters. Cost: O(m_i + n_t).
        """
        points, left, right = self
        others, others_left, others_right = chain
        merged = merge_by_slope(
            others,
            points,
            (others_left is not None, others_right is not None),
            (left is not None, right is not None),
        )
        piece = Envelope.of_own(merged, source)
        if len(merged) == 1:
            return piece
        # Whole, an end edge goes beyond the cut; it may have been left out for its slope.
        if left is not None and (
            others_left is None or cross(points[0], points[1], (others[0], others[1])) >= 0
        ):
            piece.breaks[0] = left[0] + (merged[0][0] - points[0][0]) * left[1], left[1]
        if right is not None and (
            others_right is None or cross(points[-2], points[-1], (others[-2], others[-1])) <= 0
        ):
            piece.breaks[-1] = right[0] + (merged[-1][0] - points[-1][0]) * right[1], right[1]
        return piece

    @property
    def box(self) -> Box:
        """Its box; what its ends are joined to ends at a corner, of any slope."""
        points, left, right = self
        return Box(
            points[0][0],
            points[-1][0],
            min(points, key=itemgetter(1))[1],
            -inf if left is None else slope_bound((points[0], points[1])),
            inf if right is None else slope_bound((points[-2], points[-1])),
        )


def flatter(chain: Sequence[Vertex], edge: Edge) -> int:
    """How many edges of a convex chain are flatter than an edge. Cost: O(log n)."""
    (px, py), (qx, qy) = edge
    dx, dy = qx - px, qy - py
    low, high = 0, len(chain) - 1
    while low < high:
        middle = (low + high) // 2
        (ax, ay), (bx, by) = chain[middle], chain[middle + 1]
        if (by - ay) * dx < (bx - ax) * dy:
            low = middle + 1
        else:
            high = middle
    return low


def joined_parts(directrix: Sequence[Vertex] | Envelope) -> list[ConvexPart]:
    """Step 1: the convex parts of a bottom chain or of an envelope. Cost: O(m)."""
    if isinstance(directrix, Envelope):
        parts = directrix.parts()
    else:
        parts = [Part(p, (p[0][0], 1), (p[-1][0], 1)) for p in convex_parts(directrix)]
    free: list[list[bool]] = [[False, False] for _ in parts]
    free[0][0] = free[-1][1] = True
    for k in range(1, len(parts)):
        before, after = parts[k - 1].points, parts[k].points
        if before[-1] is after[0]:
            continue
        n, d = parts[k].left
        u, v = gap(line_of((before[-2], before[-1])), line_of((after[0], after[1])))
        above = u * n + v * d
        free[k - 1][1] = above < 0 or (above == 0 and u < 0)
        free[k][0] = above > 0 or (above == 0 and u < 0)
    return [
        ConvexPart(part.points, None if turns[0] else part.left, None if turns[1] else part.right)
        for part, turns in zip(parts, free, strict=True)
    ]


class Box(NamedTuple):
    """Bounds of a convex part: of its x-range, its least y, and the slopes in which it matters.

    Slopes are ints as `slope_bound` gives them, or infinite where the other polygon turns about
    an end of the part.
    """

    left: Rational
    right: Rational
    low: Rational
    flattest: Rational | float
    steepest: Rational | float


class Run(NamedTuple):
    """A convex part of the complement: edges, each whole, and the breaks between which they hold.

    `lines` are those of the edges, `sources` those of the trajectory's edges.
    `turns_left` and `turns_right` say whether the generatrix has to turn about that end; where it
    need not, the neighbouring part is at least as low (see `exactsweep.procedures.convex_part`).
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

        Arguments and result as for `ConvexPart.swept`. Cost: O(m_i + n_t).
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
