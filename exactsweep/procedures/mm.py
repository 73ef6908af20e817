"""The MM sweep: monotone generatrix, monotone directrix (Section 5).

G_t is also split into convex parts. Each part yields a CM sweep, and the trajectory is the lower
envelope of the results (Lemma 5.1). Both loops are trajectories of the inverse generatrix along
the two sides of the first trajectory (Lemma 5.3).

Errata. Lemma 5.3: along the inner side, I(G) must stay inside T, and the x-range of I(G) within
that of T. So the boundary extends over D's x-range only. Lemma 5.2: the size is O(m n alpha(min(m,
n))), alpha the inverse Ackermann function (E. Oks and M. Sharir, "Minkowski sums of monotone and
general simple polygons", Discrete & Computational Geometry 35, 2006; see `graph`). Lemma 5.5: the
inner boundary can have order m n^2 edges, not O(m n): near a needle of D_b it has a corner for
every pair of a peak and a valley of G_t.

The inner boundary R(x) = max over u of T(u) + G_t(x - u) (Lemma 5.3) is nowhere above D_b, since
T(u) <= D_b(x) - G_t(x - u), with equality where G touches D_b. So R is computed only in the
undercuts: the faster algorithm that the paper mentions after Corollary 5.8.
"""

from __future__ import annotations

from functools import reduce
from itertools import pairwise

from exactsweep.numbers.number import ratio
from exactsweep.procedures.ceiling import subtrajectories
from exactsweep.procedures.chain import Chain, partition, precedes
from exactsweep.procedures.cm import Untouched, close, find_touched
from exactsweep.procedures.graph import Graph, Ranges, lower_envelope_cm, lower_envelope_mm

# A row is the list of subtrajectories of one G_i. It lacks those that `ceiling` drops, which are
# above the envelope E of all pairs, and all irrelevant edges (see `ConvexPart`), whose interiors
# are above E as well. Let s_j be T(G_i, D_j) with all edges, as in the paper, and let P be the
# partial trajectory when the k-th one is added.
#
#     (1)  P is on E wherever one of s_1, ..., s_{k-1} is on E.
#
# Let LowerEnvelope_CM replace P by s_k right of x, where P is not below s_k: wherever P was on E
# there, s_k is. So P may lose all of it, even where the edges of s_k are irrelevant and neither is
# on E. Left of x, some s_j, j < k, is nowhere above s_k (Lemma A.3). Where s_k is on E there, so is
# s_j, and by (1) so is P. So (1) holds for k + 1, and the lower envelope of all rows is E.


def trajectory_mm(generatrix: Chain, directrix: Chain, ranges: Ranges | None = None) -> Graph:
    """Compute the trajectory T(G_t, D_b) of a monotone top chain along a monotone bottom chain.

    Procedure Trajectory_MM, for reversed G_t and D_b. If disjoint x-ranges (`ranges`) are given,
    the result is valid only over these. Cost: O(m n log n).

    >>> peak = Chain.of([(0, 0), (1, 1), (2, 0)])
    >>> list(trajectory_mm(Chain.of([(-2, -1), (-1, 0), (0, -1)]), peak))
    [(-2, -1), (-1, 0), (0, -1), (1, 0), (2, -1)]
    """
    # Step 1: partition G_t into convex chains G_1, ..., G_l (and D_b for Trajectory_CM).
    generatrix_parts, directrix_parts = partition(generatrix, directrix)
    # Step 2: compute the subtrajectories T(G_i, D_b) for all i, by steps 2 and 3 of Trajectory_CM.
    # To disable pruning, call cc.subtrajectories(generatrix_parts, directrix_parts).
    rows = subtrajectories(generatrix_parts, directrix_parts, ranges)
    envelopes = [reduce(lower_envelope_cm, row) for row in rows if row]
    # Steps 3 and 4: compute their lower envelope by LowerEnvelope_MM, and return it.
    return lower_envelope_mm(envelopes)


def sweep_mm(generatrix: Chain, bottom: Chain, directrix: Chain) -> tuple[Chain, Chain]:
    """Compute the inner and the outer boundary of the sweep of a monotone G along a monotone D_b.

    Procedure Sweep_MM, for reversed G_t, G_b and D_b. Cost: O(m n^2 log n).

    >>> lid, bar, flat = [(-1, -1), (0, -1)], [(0, 0), (1, 0)], [(0, 0), (2, 0)]
    >>> inner, outer = sweep_mm(*map(Chain.of, (lid, bar, flat)))
    >>> inner.points, outer.points
    ([(0, 0), (2, 0)], [(-1, -1), (3, -1)])
    """
    # Step 1: compute the trajectory T(G, D).
    trajectory = trajectory_mm(generatrix, directrix)
    path = trajectory.chain()
    # Step 2: j_i(G, D) <- T(I(G), -T(G, D)) and j_o(G, D) <- T(I(G), T(G, D)).
    inner = sweep_inner_mm(generatrix, directrix, trajectory, path)
    # Step 3: return both.
    return inner, sweep_outer_mm(bottom, path).chain()


def sweep_inner_mm(generatrix: Chain, directrix: Chain, trajectory: Graph, path: Chain) -> Chain:
    """Compute the inner boundary T(I(G), -T): I(G) slides along the inside of T (Lemma 5.3).

    It is computed after a half turn: I(G) becomes G, and the complement of T, whose interior is the
    outside of T, becomes a bottom chain. `path` is T as a chain.

    Cost: O(t log t) to find the undercuts, and O(t' n log n) for the t' <= t edges of T along which
    G is over an undercut.
    """
    undercuts = find_untouched(generatrix, directrix, trajectory)
    if not undercuts:
        return directrix
    ranges = [((-u, v), (-x, w)) for _, (x, w), _, (u, v) in reversed(undercuts)]
    inside = trajectory_mm(generatrix, path.half_turn(), ranges)
    bottoms = [inside.clip(*span).chain().half_turn().vertices for span in reversed(ranges)]
    return close(directrix, undercuts, bottoms)


def sweep_outer_mm(bottom: Chain, path: Chain) -> Graph:
    """Compute the outer boundary T(I(G), T): I(G) slides along the outside of T (Lemma 5.3).

    `bottom` (G_b) is the reversed top chain of I(G). Cost: O(t n log n) for t edges of T.
    """
    return trajectory_mm(bottom, path)


def find_untouched(generatrix: Chain, directrix: Chain, trajectory: Graph) -> list[Untouched]:
    """Find x-ranges of D_b, from left to right, that contain all points that G does not touch.

    Where subtrajectories coincide, T has only one of them, so the ranges also contain points that G
    touches along the others. This does no harm: the inner boundary is D_b there.
    """
    touched = [
        (*find_touched(generatrix, directrix, piece, start, end), piece)
        for piece, (start, end) in zip(trajectory.pieces, pairwise(trajectory.breaks), strict=True)
    ]
    touched.sort(key=lambda contact: ratio(*contact[0]))
    found = []
    _, reach, before = touched[0]
    for first, last, piece in touched:
        if precedes(reach, first):
            found.append(Untouched(before, reach, piece, first))
        if precedes(reach, last):
            reach, before = last, piece
    return found
