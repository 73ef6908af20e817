"""The CC sweep: convex generatrix, convex directrix (Section 3).

Lemma 3.1: the trajectory T(G_t, D_b) consists of the edges of reversed G_t and of D_b, in order
of slope. Lemma 3.2: the inner boundary is D_b, the outer one the edges of reversed G_t, of G_b
and of D_b in order of slope. Time and space O(m + n) (Corollary 3.4).

Parallel edges, which the paper leaves out, become one edge: the EE events of Table 1.
"""

from __future__ import annotations

from collections.abc import Sequence

from exactsweep.numbers.number import Vertex
from exactsweep.procedures.chain import inverse


def merge_by_slope(first: Sequence[Vertex], second: Sequence[Vertex]) -> list[Vertex]:
    """Merge the edges of two convex chains in order of slope, from the sum of their left ends.

    The result is the infimal convolution of the two chains as functions of x. Parallel edges add up
    to one edge, so that the result is strictly convex. A single point only moves the other chain.

    Args:
        first: points from left to right, strictly convex, no vertical edge.
        second: the same.

    Returns the vertices from left to right.
    Cost: O(m + n), one cross product an edge.

    >>> merge_by_slope([(0, 0), (1, -1), (2, 0)], [(0, 0), (2, 0)])
    [(0, 0), (1, -1), (3, -1), (4, 0)]
    """
    px, py = first[0]
    qx, qy = second[0]
    i, j = 1, 1
    last_i, last_j = len(first), len(second)
    if i < last_i and j < last_j:
        (ax, ay), (bx, by) = first[1], second[1]
        adx, ady, bdx, bdy = ax - px, ay - py, bx - qx, by - qy
    merged: list[Vertex] = [(px + qx, py + qy)]
    while i < last_i and j < last_j:
        turn = adx * bdy - ady * bdx
        if turn >= 0:
            px, py = ax, ay
            i += 1
            if i < last_i:
                ax, ay = first[i]
                adx, ady = ax - px, ay - py
        if turn <= 0:
            qx, qy = bx, by
            j += 1
            if j < last_j:
                bx, by = second[j]
                bdx, bdy = bx - qx, by - qy
        merged.append((px + qx, py + qy))
    merged += [(px + x, py + y) for x, y in second[j:]]
    merged += [(x + qx, y + qy) for x, y in first[i:]]
    return merged


def trajectory_cc(generatrix: Sequence[Vertex], directrix: Sequence[Vertex]) -> list[Vertex]:
    """Trajectory T(G_t, D_b) of a convex top chain along a convex bottom chain.

    Procedure Trajectory_CC: merge the edges of reversed G_t and of D_b by slope. The reversed
    edges, laid end to end from the point at which the sweep starts, are the inverse of G_t.

    Args:
        generatrix: G_t: points from right to left, strictly convex, no vertical edge.
        directrix: D_b: points from left to right, strictly convex, no vertical edge.

    Returns:
        the path of G's origin, points from left to right.

    Cost: O(m + n).

    >>> trajectory_cc([(1, 1), (0, 1)], [(0, 0), (1, -1), (2, 0)])
    [(-1, -1), (0, -2), (1, -2), (2, -1)]
    """
    return merge_by_slope(inverse(generatrix), directrix)


def sweep_inner_cc(generatrix: Sequence[Vertex], directrix: Sequence[Vertex]) -> list[Vertex]:
    """Inner boundary of the sweep of a convex G_t along a convex D_b: D_b itself (Lemma 3.2).

    Procedure SweepI_CC. Arguments as for `trajectory_cc`. Cost: O(m).

    >>> sweep_inner_cc([(1, 1), (0, 1)], [(0, 0), (1, -1), (2, 0)])
    [(0, 0), (1, -1), (2, 0)]
    """
    return list(directrix)


def sweep_outer_cc(
    generatrix_top: Sequence[Vertex],
    generatrix_bottom: Sequence[Vertex],
    directrix: Sequence[Vertex],
) -> list[Vertex]:
    """Outer boundary of the sweep of a convex G along a convex D_b (Lemma 3.2).

    Procedure SweepO_CC: merge the edges of reversed G_t, G_b and D_b by slope, starting from the
    left end of D_b plus the left end of G_b minus the right end of G_t.

    Args:
        generatrix_top: G_t, points from right to left.
        generatrix_bottom: G_b, points from left to right.
        directrix: D_b, points from left to right.

    Returns:
        points from left to right.

    Cost: O(m + n).

    >>> sweep_outer_cc([(1, 1), (0, 1)], [(0, 0), (1, 0)], [(0, 0), (1, -1), (2, 0)])
    [(-1, -1), (0, -2), (2, -2), (3, -1)]
    """
    return merge_by_slope(trajectory_cc(generatrix_top, directrix), generatrix_bottom)
