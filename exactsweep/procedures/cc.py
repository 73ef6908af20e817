"""The CC sweep: convex generatrix, convex directrix (Section 3).

Lemma 3.1: the trajectory T(G_t, D_b) consists of the edges of reversed G_t and of D_b, in order of
slope. Lemma 3.2: the inner boundary is D_b, the outer one the edges of reversed G_t, of G_b and of
D_b in order of slope. Time and space O(m + n) (Corollary 3.4).

Reversed G_t (Definition 3.1) is passed with its edges laid end to end: the inverse of G_t, from
left to right. Parallel edges, which the paper excludes, become one edge (EE, Table 1).
"""

from __future__ import annotations

from exactsweep.numbers.number import Rational, divide_exactly
from exactsweep.procedures.chain import Chain, Homogeneous, measure_unit


def trajectory_cc(generatrix: Chain, directrix: Chain) -> Chain:
    """Trajectory T(G_t, D_b) of a convex top chain along a convex bottom chain.

    Procedure Trajectory_CC: merge the lists of edges of reversed G_t (`generatrix`) and D_b
    (`directrix`) by slope. Neither has vertical edges. Cost: O(m + n).

    >>> lid, valley = Chain.of([(-1, -1), (0, -1)]), Chain.of([(0, 0), (1, -1), (2, 0)])
    >>> trajectory_cc(lid, valley).points
    [(-1, -1), (0, -2), (1, -2), (2, -1)]
    """
    return merge_by_slope(generatrix, directrix)


def sweep_inner_cc(generatrix: Chain, directrix: Chain) -> Chain:
    """Inner boundary of the sweep of a convex G_t along a convex D_b: D_b (Lemma 3.2).

    Procedure SweepI_CC: return the edges of D_b. Arguments as for `trajectory_cc`.

    >>> lid, valley = Chain.of([(-1, -1), (0, -1)]), Chain.of([(0, 0), (1, -1), (2, 0)])
    >>> sweep_inner_cc(lid, valley).points
    [(0, 0), (1, -1), (2, 0)]
    """
    return directrix


def sweep_outer_cc(generatrix: Chain, bottom: Chain, directrix: Chain) -> Chain:
    """Outer boundary of the sweep of a convex G along a convex D_b (Lemma 3.2).

    Procedure SweepO_CC: merge the lists of edges of reversed G_t, G_b and D_b by slope, from v_l of
    D + (v_l - v_r of G). Arguments as for `trajectory_cc`; `bottom` is G_b. Cost: O(m + n).

    >>> lid, valley = Chain.of([(-1, -1), (0, -1)]), Chain.of([(0, 0), (1, -1), (2, 0)])
    >>> sweep_outer_cc(lid, Chain.of([(0, 0), (1, 0)]), valley).points
    [(-1, -1), (0, -2), (2, -2), (3, -1)]
    """
    return merge_by_slope(generatrix, bottom, directrix)


def merge_by_slope(*chains: Chain) -> Chain:
    """Lay the edges of convex chains end to end by slope, from the sum of their left ends.

    Cost: O(n) for n edges, which `sorted` merges as sorted lists.
    """
    unit = measure_unit(*chains)
    edges = [
        (dy * unit // dx if unit else divide_exactly(dy, dx), dx, dy)
        for chain in chains
        for dx, dy, *_ in filter(None, chain.lines)
    ]
    x: Rational = sum(chain.vertices[0][0] for chain in chains)
    y: Rational = sum(chain.vertices[0][1] for chain in chains)
    vertices: list[Homogeneous] = [(x, y, 1)]
    last: Rational | None = None
    for slope, dx, dy in sorted(edges):
        x, y = x + dx, y + dy
        if slope == last:
            vertices.pop()
        vertices.append((x, y, 1))
        last = slope
    return Chain(vertices)
