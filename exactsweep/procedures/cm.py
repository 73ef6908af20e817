"""The CM sweep: convex generatrix, monotone directrix (Section 4, Appendix).

The reflex vertices split D_b into convex chains D_1, ..., D_k. Each yields a CC sweep. The
trajectory and the outer boundary are the lower envelopes of the results (Lemma 4.1). The inner
boundary is D_b with its undercuts closed (Figure 7). Time and space are O(m n), which is optimal
(Corollaries 4.5 and 4.6).

Lemma A.3 (at most one crossing) also holds for degenerate input. T(G_t, D_i) is the minimum over a
in D_i of D_b(a) + h(x - a) for a convex function h. So the left subtrajectory minus the right one
never decreases along x, even with jumps and parallel edges. It is zero at one point, on one
segment, or nowhere.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import reduce
from itertools import pairwise
from typing import NamedTuple

from exactsweep.geometry.frame import HomogeneousPoint
from exactsweep.procedures.cc import merge_by_slope, subtrajectory
from exactsweep.procedures.chain import (
    Break,
    Chain,
    find_point,
    partition,
    precedes,
    take_corners,
)
from exactsweep.procedures.graph import Graph, Piece, lower_envelope_cm, subtract


class Untouched(NamedTuple):
    """An x-range of D_b that G does not touch, from left to right.

    G touches D_b at `left` along the piece `before` of T, at `right` along the piece `after`.
    """

    before: Piece
    left: Break
    after: Piece
    right: Break


def trajectory_cm(generatrix: Chain, directrix: Chain) -> Graph:
    """Compute the trajectory T(G_t, D_b) of a convex top chain along a monotone bottom chain.

    Procedure Trajectory_CM, for convex reversed G_t and D_b. Cost: O(m n).

    >>> list(trajectory_cm(Chain.of([(-1, 0), (0, 0)]), Chain.of([(0, 0), (2, 2), (4, 0)])))
    [(-1, 0), (0, 0), (Fraction(3, 2), Fraction(3, 2)), (3, 0), (4, 0)]
    """
    # Step 1: partition D_b into convex chains D_1, ..., D_k.
    (convex,), parts = partition(generatrix, directrix)
    # Step 2: for i = 1, ..., k, compute T(G_t, D_i) by Trajectory_CC, and the lower envelope t_i of
    # t_{i-1} and T(G_t, D_i) by LowerEnvelope_CM; t_1 is T(G_t, D_1). Step 3: return t_k.
    return reduce(lower_envelope_cm, (subtrajectory(convex, part) for part in parts))


def sweep_inner_cm(generatrix: Chain, directrix: Chain, trajectory: Graph | None = None) -> Chain:
    """Compute the inner boundary of the sweep of a convex G_t along a monotone D_b.

    Procedure SweepI_CM. Where two subtrajectories meet, G touches D_b in two places, which the
    events give. The part of G_t between them is the bottom chain of an undercut (Figure 7a). If the
    subtrajectories share a segment, all its points give the same bottom chain (Figure 7b). At a
    jump of the trajectory, G rises or falls along its vertical edge, and the highest position
    bounds the undercut. Cost: O(m n).

    >>> sweep_inner_cm(Chain.of([(-1, -1), (0, -1)]), Chain.of([(0, 0), (1, 1), (2, 0)])).points
    [(0, 0), (Fraction(1, 2), Fraction(1, 2)), (Fraction(3, 2), Fraction(1, 2)), (2, 0)]
    """
    # Step 2: compute T(G_t, D_b).
    if trajectory is None:
        trajectory = trajectory_cm(generatrix, directrix)
    # Step 3: for each intersection of subtrajectories, find the bottom chain of the undercut, if
    # there is one.
    undercuts: list[Untouched] = []
    bottoms: list[list[HomogeneousPoint]] = []
    meetings = zip(pairwise(trajectory.pieces), trajectory.breaks[1:-1], strict=True)
    for (before, after), at in meetings:
        (*_, end), (*_, start, _) = before, after
        if start == end:
            # Edges that meet at the same vertices of G and D, mostly of one subtrajectory.
            continue
        _, left = find_touched(generatrix, directrix, before, at, at)
        right, _ = find_touched(generatrix, directrix, after, at, at)
        (a, b), (u, v) = subtract(before, after), at
        x, y, w = find_point(after if a * u + b * v < 0 else before, at)
        # From the first vertex of G_t in contact on the left to the last one on the right. They are
        # vertices end[2] and start[2] of reversed G_t, which runs along G_t from right to left.
        of_g = reversed(generatrix.vertices[start[2] : end[2] + 1])
        # G_t at the position (x, y, w).
        placed = [(x * gw - gx * w, y * gw - gy * w, w * gw) for gx, gy, gw in of_g]
        # Only the first and the last vertex can lie beyond the contacts.
        bottoms.append(
            placed[precedes(placed[0], left) : len(placed) - precedes(right, placed[-1])]
        )
        undercuts.append(Untouched(before, left, after, right))
    # Steps 1 and 4: copy D_b into L, with the top chains of the undercuts replaced; return L.
    return close(directrix, undercuts, bottoms)


def sweep_outer_cm(generatrix: Chain, bottom: Chain, directrix: Chain) -> Graph:
    """Compute the outer boundary of the sweep of a convex G along a monotone D_b.

    Procedure SweepO_CM. SweepO_CC(G_t, D_i) is Trajectory_CC for the merged edges of reversed G_t
    and of `bottom` (G_b). So steps 1 to 3 are those of Trajectory_CM for these edges. Cost: O(m n).

    >>> bar, lid = Chain.of([(0, 0), (1, 0)]), Chain.of([(-1, 0), (0, 0)])
    >>> list(sweep_outer_cm(lid, bar, Chain.of([(0, 0), (2, 2), (4, 0)])))
    [(-1, 0), (1, 0), (2, 1), (3, 0), (5, 0)]
    """
    return trajectory_cm(merge_by_slope(generatrix, bottom), directrix)


def find_touched(
    generatrix: Chain, directrix: Chain, piece: Piece, start: Break, end: Break
) -> tuple[Break, Break]:
    """Find both ends of the x-range of D_b that G touches between two breaks of a piece.

    At position x, vertex g of reversed G_t is at x - g. If the piece leads from vertices d and g to
    d' and g', G touches D_b from max(d, start - g') to min(d', end - g).
    """
    _, _, _, (_, i, j), (_, i_end, j_end) = piece
    (x, w), (u, v) = start, end
    (gx, _, gw), (hx, _, hw) = generatrix.vertices[j_end], generatrix.vertices[j]
    first, last = (x * gw - gx * w, w * gw), (u * hw - hx * v, v * hw)
    (dx, _, dw), (ex, _, ew) = directrix.vertices[i], directrix.vertices[i_end]
    left, right = (dx, dw), (ex, ew)
    return left if precedes(first, left) else first, right if precedes(right, last) else last


def close(
    directrix: Chain, undercuts: Iterable[Untouched], bottoms: Iterable[list[HomogeneousPoint]]
) -> Chain:
    """Replace the top chains of undercuts, pieces of D_b, by their bottom chains (Figure 7)."""
    inner: list[HomogeneousPoint] = []
    done = 0
    for (before, left, after, right), bottom in zip(undercuts, bottoms, strict=True):
        _, _, _, (_, i, _), _ = before
        _, _, _, _, (_, k, _) = after
        first, last = _find_contact(directrix, before, left), _find_contact(directrix, after, right)
        inner += [*directrix.vertices[done : i + 1], first, *bottom, last]
        done = k
    return Chain(take_corners(inner + directrix.vertices[done:]))


def _find_contact(directrix: Chain, piece: Piece, at: Break) -> HomogeneousPoint:
    """Find the point of D_b at a break that G touches along a piece of T."""
    _, _, _, (_, i, _), (_, i_end, _) = piece
    return find_point(directrix.lines[i], at) if i < i_end else directrix.vertices[i]
