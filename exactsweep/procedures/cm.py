"""The CM sweep: convex generatrix, monotone directrix (Section 4).

The reflex vertices split D_b into convex chains D_1, ..., D_k. Each chain gives a CC sweep. The
trajectory and the outer boundary are the lower envelopes of the results (Lemma 4.1). The inner
boundary is D_b with its undercuts closed (Figure 7). Time and space are O(m n), which is optimal
(Corollaries 4.5 and 4.6).

Lemma A.3, one crossing at most, also holds for degenerate input. T(G_t, D_i) is the minimum over a
in D_i of D_b(a) + h(x - a) for one convex h. For convex h, the difference of two sub-trajectories,
the left one minus the right one, never decreases along x. This holds for every D_b, with jumps and
parallel edges. So the difference is zero in one point, on one segment, or nowhere.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from functools import reduce

from exactsweep.numbers.number import Vertex
from exactsweep.procedures.cc import merge_by_slope
from exactsweep.procedures.chain import find_convex_parts, inverse, require_convex, take_corners
from exactsweep.procedures.convex_part import find_touched, measure_unit, split_parts, take_whole
from exactsweep.procedures.envelope import (
    Break,
    Envelope,
    find_point,
    find_point_on,
    height,
)
from exactsweep.procedures.lower_envelope import lower_envelope_cm


def trajectory_cm(generatrix: Sequence[Vertex], directrix: Sequence[Vertex] | Envelope) -> Envelope:
    """Trajectory T(G_t, D_b) of a convex top chain along a monotone bottom chain.

    Procedure Trajectory_CM.

    Args:
        generatrix: G_t: points from right to left, strictly convex, no vertical edge.
        directrix: D_b: points from left to right, vertical edges allowed; or an envelope.

    Returns:
        the path of G's origin as an envelope; `sources` numbers the D_i.

    Raises:
        ChainError: when the directrix is not X-monotone.

    Cost: O(m n).

    >>> print(trajectory_cm([(1, 0), (0, 0)], [(0, 0), (2, 2), (4, 0)]))
    (-1, 0) (0, 0) (3/2, 3/2) (3, 0) (4, 0)
    """
    return sweep_parts(inverse(generatrix), directrix)


def sweep_outer_cm(
    generatrix_top: Sequence[Vertex],
    generatrix_bottom: Sequence[Vertex],
    directrix: Sequence[Vertex] | Envelope,
) -> Envelope:
    """Outer boundary of the sweep of a convex G along a monotone D_b.

    Procedure SweepO_CM. Arguments as for `sweep_outer_cc` and `trajectory_cm`.

    Raises ChainError if the directrix is not X-monotone. Cost: O(m n).

    >>> print(sweep_outer_cm([(1, 0), (0, 0)], [(0, 0), (1, 0)], [(0, 0), (2, 2), (4, 0)]))
    (-1, 0) (1, 0) (2, 1) (3, 0) (5, 0)
    """
    top, bottom = require_convex(inverse(generatrix_top)), require_convex(generatrix_bottom)
    return sweep_parts(merge_by_slope(top, bottom), directrix)


def sweep_parts(edges: Sequence[Vertex], directrix: Sequence[Vertex] | Envelope) -> Envelope:
    """Step 2: solve the CC sweep of each convex part and take the lower envelope.

    One convex chain has the edges of reversed G_t (or of reversed G_t and G_b).

    >>> print(sweep_parts([(-1, 0), (0, 0)], [(0, 0), (2, 2), (4, 0)]))
    (-1, 0) (0, 0) (3/2, 3/2) (3, 0) (4, 0)
    """
    unit = measure_unit(edges, directrix)
    chain = take_whole(edges, unit)
    pieces = (part.sweep(chain, k) for k, part in enumerate(split_parts(directrix, unit)))
    return reduce(lower_envelope_cm, filter(None, pieces))


def sweep_inner_cm(
    generatrix: Sequence[Vertex], directrix: Sequence[Vertex], trajectory: Envelope | None = None
) -> list[Vertex]:
    """Inner boundary of the sweep of a convex G_t along a monotone D_b.

    Procedure SweepI_CM. Where two sub-trajectories meet, G touches D_b in two places. The part of
    G_t between them replaces D_b there: it is the bottom chain of an undercut (Figure 7a). Where
    the sub-trajectories share a segment, both places are on one edge of G_t (Figure 7b), and all
    points of the segment give the same bottom chain. At a step of the envelope the higher position
    closes the undercut.

    Args:
        generatrix: G_t: points from right to left, strictly convex, no vertical edge.
        directrix: D_b: points from left to right, vertical edges allowed.
        trajectory: the result of `trajectory_cm` for the same chains, if the caller has it.

    Returns:
        points from left to right, vertical edges included, no three collinear.

    Raises:
        ChainError: when the directrix is not X-monotone.

    Cost: O(m n).

    >>> sweep_inner_cm([(1, 1), (0, 1)], [(0, 0), (1, 1), (2, 0)])
    [(0, 0), (Fraction(1, 2), Fraction(1, 2)), (Fraction(3, 2), Fraction(1, 2)), (2, 0)]
    """
    # From left to right, as D_b.
    top = inverse(require_convex(inverse(generatrix)))[::-1]
    parts = find_convex_parts(directrix)
    if trajectory is None:
        trajectory = trajectory_cm(generatrix, directrix)
    pieces, sources = trajectory.pieces, trajectory.sources
    inner: list[Vertex] = []
    joints: set[int] = set()
    done = 0
    for k in range(1, len(pieces)):
        if sources[k] == sources[k - 1]:
            continue
        at = trajectory.breaks[k]
        before, after = parts[sources[k - 1]], parts[sources[k]]
        i, (_, left) = find_touched(before, trajectory, k - 1)
        j, (right, _) = find_touched(after, trajectory, k)
        # At a step of the envelope the higher position closes the undercut.
        step = height(pieces[k - 1], pieces[k], at)
        position = find_point(pieces[k if step < 0 else k - 1], at)
        leaving, arriving = (before[i], before[i + 1]), (after[j], after[j + 1])
        # Without a step, a contact inside an edge of D_b is a vertex of G, and a corner. Others may
        # be collinear with their neighbours, or repeat them.
        inner += before[done : i + 1]
        inner.append(find_point_on(leaving, left))
        if step or inner[-1] in leaving:
            joints.add(len(inner) - 1)
        inner += _place(top, position, at, left, right, touching=step != 0)
        inner.append(find_point_on(arriving, right))
        if step or inner[-1] in arriving:
            joints.add(len(inner) - 1)
        done = j + 1
    inner += parts[sources[-1]][done:]
    return take_corners(inner, joints)


def _place(
    top: Sequence[Vertex],
    position: Vertex,
    at: Break,
    left: Break,
    right: Break,
    *,
    touching: bool,
) -> list[Vertex]:
    """List the vertices of G_t between two breaks, for a position of G at a break.

    `touching` includes vertices at the two breaks. Cost: O(log n + vertices returned).
    """
    (n, d), (low, e), (high, f) = at, left, right
    before, after = (bisect_left, bisect_right) if touching else (bisect_right, bisect_left)
    first = before(top, low * d - n * e, key=lambda v: v[0] * d * e)
    last = after(top, high * d - n * f, key=lambda v: v[0] * d * f)
    x, y = position
    return [(x + u, y + v) for u, v in top[first:last]]
