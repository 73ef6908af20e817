"""Convex parts of a directrix, and what of their sub-trajectories matters (Section 4, step 1).

Where two parts meet in a reflex vertex p, G standing on p with an edge steeper than the left
part's last edge would overlap the right part, and with one flatter than the right part's first
edge the left part.  So of each sub-trajectory T(G_t, D_i) only the edges from D_i's own first to
its own last one can belong to the lower envelope, and the others need not be made.  At a step of
D_b that holds for the higher part only.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from typing import NamedTuple

from exactsweep.cc import merge_by_slope
from exactsweep.ceiling import Box
from exactsweep.chain import Edge, Vertex, convex_parts
from exactsweep.envelope import Envelope, Part
from exactsweep.piece import Break, cross, gap, line_of


class ConvexPart(NamedTuple):
    """A convex part of D_b.

    `left` and `right` are breaks on its first and last edge: G need not turn about that end, since
    the neighbouring part is at least as low there; None where it must.
    """

    points: list[Vertex]
    left: Break | None
    right: Break | None

    def swept(self, chain: Sequence[Vertex], source: int, *, turns_left: bool = False) -> Envelope:
        """The CC sweep of a convex chain of reversed edges along this part, as far as it matters.

        Args:
            chain: points from left to right.
            source: the number of what is swept.
            turns_left: whether G turns about the left end in any case.  Where the part is cut
                there, the result then begins where its edge does: above the chain, as ever.

        Cost: O(m_i + n_t).
        """
        points, left, right = self
        if turns_left:
            left = None
        first, last = 0, len(chain) - 1
        if left is not None:
            edge = points[0], points[1]
            while first < last and cross(chain[first], chain[first + 1], edge) < 0:
                first += 1
        if right is not None:
            edge = points[-2], points[-1]
            while first < last and cross(chain[last - 1], chain[last], edge) > 0:
                last -= 1
        piece = Envelope.of_own(merge_by_slope(chain[first : last + 1], points), source)
        if left is not None:
            piece.breaks[0] = left[0] + chain[first][0] * left[1], left[1]
        if right is not None:
            piece.breaks[-1] = right[0] + chain[last][0] * right[1], right[1]
        return piece

    @property
    def box(self) -> Box:
        """Least x, greatest x and least y."""
        points = self.points
        return points[0][0], points[-1][0], min(y for _, y in points)


def flatter(chain: Sequence[Vertex], edge: Edge) -> int:
    """How many edges of a convex chain are flatter than an edge.  Cost: O(log n)."""
    return bisect_left(
        range(len(chain) - 1), True, key=lambda k: cross(chain[k], chain[k + 1], edge) >= 0
    )


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
