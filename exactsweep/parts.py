"""Convex parts, and what of their sub-trajectories matters (Sections 4 and 5, step 1).

Where two parts of D_b meet in a reflex vertex p, G standing on p with an edge steeper than the left
part's last edge would overlap the right part, and with one flatter than the right part's first
edge the left part.  So of each sub-trajectory T(G_t, D_i) only the edges from D_i's own first to
its own last one can belong to the lower envelope, and the others need not be made: but for single
points they are above it.  At a step of D_b that holds for the higher part only.

A sum does not know which of its two chains moves: the same holds for the convex parts of reversed
G_t and the edges of D_b.  In an MM sweep what matters of a pair is the edges whose slopes lie
between the ends of both parts, which for most pairs of real outlines is nothing.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import inf
from operator import itemgetter
from typing import NamedTuple

from exactsweep.cc import merge_by_slope
from exactsweep.ceiling import Box
from exactsweep.chain import Edge, Vertex, convex_parts
from exactsweep.envelope import Envelope, Part
from exactsweep.piece import Break, cross, gap, line_of, slope_bound


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

        Returns an envelope, which has no edges if nothing matters.  Cost: O(m_i + n_t).
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
    """How many edges of a convex chain are flatter than an edge.  Cost: O(log n)."""
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
    """Step 1: the convex parts of a bottom chain or of an envelope.  Cost: O(m)."""
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
