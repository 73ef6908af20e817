"""The CC sweep: convex generatrix, convex directrix (Section 3).

Lemma 3.1: the trajectory T(G_t, D_b) consists of the edges of reversed G_t and of D_b, sorted by
slope. Lemma 3.2: the inner boundary is D_b; the outer boundary consists of the edges of reversed
G_t, of G_b and of D_b, sorted by slope. Time and space are O(m + n) (Corollary 3.4).

The edges of reversed G_t (Definition 3.1), laid end to end, are the inverse of G_t, from left to
right. Parallel edges, which the paper excludes, become one edge (EE, Table 1).
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from itertools import pairwise
from math import lcm

from exactsweep.procedures.chain import Break, Chain, ConvexPart
from exactsweep.procedures.graph import Graph, Piece, VertexContact


def trajectory_cc(generatrix: Chain, directrix: Chain) -> Chain:
    """Compute the trajectory T(G_t, D_b) of a convex top chain along a convex bottom chain.

    Procedure Trajectory_CC, for reversed G_t and D_b without vertical edges. Cost: O(m + n).

    >>> lid, valley = Chain.of([(-1, -1), (0, -1)]), Chain.of([(0, 0), (1, -1), (2, 0)])
    >>> trajectory_cc(lid, valley).points
    [(-1, -1), (0, -2), (1, -2), (2, -1)]
    """
    return merge_by_slope(generatrix, directrix)


def sweep_inner_cc(generatrix: Chain, directrix: Chain) -> Chain:
    """Return the inner boundary of the sweep of a convex G_t along a convex D_b: D_b (Lemma 3.2).

    Procedure SweepI_CC, with the arguments of `trajectory_cc`.

    >>> lid, valley = Chain.of([(-1, -1), (0, -1)]), Chain.of([(0, 0), (1, -1), (2, 0)])
    >>> sweep_inner_cc(lid, valley).points
    [(0, 0), (1, -1), (2, 0)]
    """
    return directrix


def sweep_outer_cc(generatrix: Chain, bottom: Chain, directrix: Chain) -> Chain:
    """Compute the outer boundary of the sweep of a convex G along a convex D_b (Lemma 3.2).

    Procedure SweepO_CC: merge the edges of reversed G_t, of `bottom` (G_b) and of D_b by slope,
    starting at v_l of D + (v_l - v_r of G). Cost: O(m + n).

    >>> lid, valley = Chain.of([(-1, -1), (0, -1)]), Chain.of([(0, 0), (1, -1), (2, 0)])
    >>> sweep_outer_cc(lid, Chain.of([(0, 0), (1, 0)]), valley).points
    [(-1, -1), (0, -2), (2, -2), (3, -1)]
    """
    return merge_by_slope(generatrix, bottom, directrix)


def merge_by_slope(*chains: Chain) -> Chain:
    """Merge the edges of convex chains by slope, starting at the sum of their left ends.

    Cost: O(n) for n edges: the sort merges ascending runs in linear time.
    """
    scale = lcm(*(w for chain in chains for _, _, w in chain.vertices))
    listed = [[(x * scale // w, y * scale // w) for x, y, w in c.vertices] for c in chains]
    moves = [(u - x, v - y) for points in listed for (x, y), (u, v) in pairwise(points)]
    # Slopes rounded down to multiples of 1/unit keep their order (see `Chain.unit`).
    unit = 1 << 2 * max(dx for dx, _ in moves).bit_length()
    x, y = map(sum, zip(*(points[0] for points in listed), strict=True))
    merged = [(x, y, scale)]
    last = None
    for slope, dx, dy in sorted((dy * unit // dx, dx, dy) for dx, dy in moves):
        x, y = x + dx, y + dy
        if slope == last:
            merged.pop()
        merged.append((x, y, scale))
        last = slope
    return Chain(merged)


def subtrajectory(generatrix: ConvexPart, directrix: ConvexPart) -> Graph:
    """Compute T(G_i, D_j) of two facing convex parts, with its events (Table 1).

    It is Trajectory_CC for the relevant edges of both (see `ConvexPart`): each is translated by the
    vertex of the other chain that it meets, an edge of D_b by vertex j of reversed G_t (VE), an
    edge of reversed G_t by vertex i of D_b (EV). Cost: O(m + n).
    """
    gs, ds = generatrix.edges, directrix.edges
    i, i_end = bisect_left(ds, generatrix.least_slope), bisect_left(ds, generatrix.greatest_slope)
    j, j_end = bisect_left(gs, directrix.least_slope), bisect_left(gs, directrix.greatest_slope)
    edges = sorted(ds[i:i_end] + gs[j:j_end])
    i, j = i + directrix.first, j + generatrix.first
    # Before each round, the position is the sum of vertices i and j.
    (x, y, w), (u, v, z) = directrix.vertices[i], generatrix.vertices[j]
    at = x * z + u * w, w * z
    start: VertexContact = (at[0], y * z + v * w, at[1]), i, j
    breaks: list[Break] = [at]
    pieces: list[Piece] = []
    last: int | float | None = None
    for slope, of_generatrix, dx, dy, c in edges:
        if of_generatrix:
            dx, dy, c = dx * w, dy * w, c * w + y * dx - x * dy
            j += 1
            u, v, z = generatrix.vertices[j]
        else:
            dx, dy, c = dx * z, dy * z, c * z + v * dx - u * dy
            i += 1
            x, y, w = directrix.vertices[i]
        if slope == last:
            # Parallel edges become one (EE).
            _, _, _, start, _ = pieces.pop()
            breaks.pop()
        at = x * z + u * w, w * z
        end: VertexContact = (at[0], y * z + v * w, at[1]), i, j
        pieces.append((dx, dy, c, start, end))
        breaks.append(at)
        start, last = end, slope
    return Graph(breaks, pieces)


def subtrajectories(
    generatrix_parts: Sequence[ConvexPart], directrix_parts: Sequence[ConvexPart]
) -> list[list[Graph]]:
    """Compute T(G_i, D_j) of all pairs of facing parts, in row i by j."""
    return [[subtrajectory(g, d) for d in directrix_parts if g.faces(d)] for g in generatrix_parts]
