"""The CM sweep: convex generatrix, monotone directrix (Section 4, Appendix).

The reflex vertices split D_b into convex chains D_1, ..., D_k. Each gives a CC sweep. The
trajectory and the outer boundary are the lower envelopes of the results (Lemma 4.1). The inner
boundary is D_b with its undercuts closed (Figure 7). Time and space are O(m n), which is optimal
(Corollaries 4.5 and 4.6).

Lemma A.3, at most one crossing, also holds for degenerate input. T(G_t, D_i) is the minimum over a
in D_i of D_b(a) + h(x - a) for one convex h. So the difference of two subtrajectories, the left one
minus the right one, never decreases along x, for every D_b, with jumps and parallel edges. It is
zero in one point, on one segment, or nowhere.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import reduce
from itertools import pairwise
from typing import NamedTuple

from exactsweep.procedures.cc import merge_by_slope
from exactsweep.procedures.chain import (
    Break,
    Chain,
    Homogeneous,
    find_point,
    partition,
    precedes,
    take_corners,
)
from exactsweep.procedures.graph import Graph, Piece, lower_envelope_cm, subtract, subtrajectory


def trajectory_cm(generatrix: Chain, directrix: Chain) -> Graph:
    """Trajectory T(G_t, D_b) of a convex top chain along a monotone bottom chain.

    Procedure Trajectory_CM, for convex reversed G_t and D_b. Each piece of the result, the path of
    G's origin, has its event. Cost: O(m n).

    >>> list(trajectory_cm(Chain.of([(-1, 0), (0, 0)]), Chain.of([(0, 0), (2, 2), (4, 0)])))
    [(-1, 0), (0, 0), (Fraction(3, 2), Fraction(3, 2)), (3, 0), (4, 0)]
    """
    # Step 1: partition D_b into convex chains D_1, ..., D_k.
    (convex,), parts = partition(generatrix, directrix)
    # Step 2: compute the subtrajectories T(G_t, D_i) and their lower envelope.
    subtrajectories = (subtrajectory(convex, part) for part in parts)
    # Step 3: return the lower envelope.
    return reduce(lower_envelope_cm, filter(None, subtrajectories))


def sweep_outer_cm(generatrix: Chain, bottom: Chain, directrix: Chain) -> Graph:
    """Outer boundary of the sweep of a convex G along a monotone D_b.

    Procedure SweepO_CM: as Trajectory_CM, with SweepO_CC in the place of Trajectory_CC. A sub-outer
    chain is a subtrajectory of the merged edges of reversed G_t and G_b. Arguments as for
    `trajectory_cm`; `bottom` is G_b, convex. Cost: O(m n).

    >>> bar, lid = Chain.of([(0, 0), (1, 0)]), Chain.of([(-1, 0), (0, 0)])
    >>> list(sweep_outer_cm(lid, bar, Chain.of([(0, 0), (2, 2), (4, 0)])))
    [(-1, 0), (1, 0), (2, 1), (3, 0), (5, 0)]
    """
    return trajectory_cm(merge_by_slope(generatrix, bottom), directrix)


def sweep_inner_cm(generatrix: Chain, directrix: Chain, trajectory: Graph | None = None) -> Chain:
    """Inner boundary of the sweep of a convex G_t along a monotone D_b.

    Procedure SweepI_CM. Where two subtrajectories meet, G touches D_b in two places. The part of
    G_t between them is the bottom chain of an undercut (Figure 7a). Where the subtrajectories share
    a segment, both places are on one edge of G_t (Figure 7b), and all points of the segment give
    the same bottom chain. At a jump of the trajectory the higher position closes the undercut. A
    known trajectory may be passed. Cost: O(m n).

    >>> sweep_inner_cm(Chain.of([(-1, -1), (0, -1)]), Chain.of([(0, 0), (1, 1), (2, 0)])).points
    [(0, 0), (Fraction(1, 2), Fraction(1, 2)), (Fraction(3, 2), Fraction(1, 2)), (2, 0)]
    """
    # Step 2: compute T(G_t, D_b).
    if trajectory is None:
        trajectory = trajectory_cm(generatrix, directrix)
    # Step 3: for each intersection of subtrajectories, find the undercut.
    gs = generatrix.vertices
    closings: list[Closing] = []
    joints = zip(pairwise(trajectory.pieces), trajectory.breaks[1:-1], strict=True)
    for (before, after), at in joints:
        if before[4] == after[3]:
            continue
        _, left = find_touched(generatrix, directrix, before, at, at)
        right, _ = find_touched(generatrix, directrix, after, at, at)
        (x, w), (a, b) = at, subtract(before, after)
        px, py, pw = find_point(after if a * x + b * w < 0 else before, at)
        # The vertices of G_t between both contacts, and those in them.
        (_, _, j), (_, _, j_end), (_, _, k), (_, _, k_end) = *before[3:], *after[3:]
        last = j if precedes((x - gs[j_end][0] * w, w), left) else j_end
        first = k_end if precedes(right, (x - gs[k][0] * w, w)) else k
        bottom = [(px - gx * pw, py - gy * pw, pw) for gx, gy, _ in reversed(gs[first : last + 1])]
        closings.append(Closing(before, left, after, right, bottom))
    # Step 4: return D_b with the undercuts closed.
    return close(directrix, closings)


class Closing(NamedTuple):
    """An x-range of D_b that G does not touch, and the boundary there.

    Attributes:
        before: a piece of the trajectory along which G touches D_b at `left`.
        left: the left end of the range.
        after: a piece along which G touches D_b at `right`.
        right: the right end.
        bottom: the vertices of the bottom chain between both ends.
    """

    before: Piece
    left: Break
    after: Piece
    right: Break
    bottom: list[Homogeneous]


def find_touched(
    generatrix: Chain, directrix: Chain, piece: Piece, start: Break, end: Break
) -> tuple[Break, Break]:
    """Find both ends of the x-range of D_b that G touches between two breaks of a piece (Table 1).

    Between vertices i and i_end of D_b, vertices j to j_end of reversed G_t are in contact.
    """
    (x, w), (u, v), (_, i, j), (_, i_end, j_end) = start, end, *piece[3:]
    gs, ds = generatrix.vertices, directrix.vertices
    if i == i_end:
        # EV.
        return (ds[i][0], 1), (ds[i][0], 1)
    first, last = x - gs[j_end][0] * w, u - gs[j][0] * v
    return (max(first, ds[i][0] * w), w), (min(last, ds[i_end][0] * v), v)


def close(directrix: Chain, closings: Iterable[Closing]) -> Chain:
    """Replace the top chains of undercuts, pieces of D_b, by their bottom chains (Figure 7).

    Cost: O(m + size of the result).
    """
    inner: list[Homogeneous] = []
    done = 0
    for before, left, after, right, bottom in closings:
        (_, i, _), (_, i_end, _), (_, k, _), (_, k_end, _) = *before[3:], *after[3:]
        inner += directrix.vertices[done : i + 1]
        leaving, arriving = directrix.lines[i:i_end], directrix.lines[k:k_end]
        inner += [find_point(line, left) for line in leaving if line]
        inner += bottom
        inner += [find_point(line, right) for line in arriving if line] or [directrix.vertices[k]]
        done = k_end
    return Chain(take_corners(inner + directrix.vertices[done:]))
