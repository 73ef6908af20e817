"""The sums of two convex parts: Trajectory_CC with the events of Table 1 (Lemma 3.1)."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence

from exactsweep.numbers.number import Rational
from exactsweep.procedures.chain import Break, ConvexPart, Homogeneous
from exactsweep.procedures.graph import Graph, Piece, VertexContact

Ranges = Sequence[tuple[Break, Break]]
"""Disjoint x-ranges, from left to right."""


def subtrajectory(generatrix: ConvexPart, directrix: ConvexPart) -> Graph | None:
    """Merge the relevant edges of two convex parts by slope; None if there are none.

    The edges lie end to end from the first contact on, as `merge_by_slope` lays those of convex
    chains. Parallel edges become one edge (EE).

    Args:
        generatrix: a part of reversed G_t, its vertices with w = 1.
        directrix: a part of D_b.

    Cost: O(m + n).
    """
    gs, ds = generatrix.edges, directrix.edges
    i, i_end = bisect_left(ds, generatrix.flattest), bisect_left(ds, generatrix.steepest)
    j, j_end = bisect_left(gs, directrix.flattest), bisect_left(gs, directrix.steepest)
    if i == i_end and j == j_end:
        return None
    edges = sorted(ds[i:i_end] + gs[j:j_end])
    i, j = i + directrix.first, j + generatrix.first
    (x, y, w), (gx, gy, _) = directrix.vertices[i], generatrix.vertices[j]
    start: VertexContact = (x + gx * w, y + gy * w, w), i, j
    breaks: list[Break] = [(x + gx * w, w)]
    pieces: list[Piece] = []
    last: Rational | None = None
    for slope, of_generatrix, dx, dy, c in edges:
        if of_generatrix:
            # EV: the edge of G moves by vertex i of D_b, which may be a crossing, w > 1.
            c = c * w + y * dx - x * dy
            if w > 1:
                dx, dy = dx * w, dy * w
            j += 1
            gx, gy, _ = generatrix.vertices[j]
        else:
            # VE: the edge of D_b moves by vertex j of G.
            c += gy * dx - gx * dy
            i += 1
            x, y, w = directrix.vertices[i]
        if slope == last:
            _, _, _, start, _ = pieces.pop()
            breaks.pop()
        position: Homogeneous = x + gx * w, y + gy * w, w
        end: VertexContact = position, i, j
        pieces.append((dx, dy, c, start, end))
        breaks.append((position[0], w))
        start, last = end, slope
    return Graph(breaks, pieces)


def subtrajectories(
    generatrix_parts: Sequence[ConvexPart],
    directrix_parts: Sequence[ConvexPart],
    ranges: Ranges | None = None,
) -> list[tuple[int, int, Graph]]:
    """Return (i, j, T(G_i, D_j)) for all pairs of parts with relevant edges, by i and j.

    Args:
        generatrix_parts: the convex parts of reversed G_t.
        directrix_parts: those of D_b.
        ranges: the x-ranges in which the envelope is needed; all are computed here.
    """
    return [
        (i, j, graph)
        for i, g in enumerate(generatrix_parts)
        for j, d in enumerate(directrix_parts)
        if g.flattest < d.steepest and d.flattest < g.steepest and (graph := subtrajectory(g, d))
    ]
