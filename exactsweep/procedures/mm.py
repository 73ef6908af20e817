"""The MM sweep: monotone generatrix, monotone directrix (Section 5).

G_t is split into convex parts, too. Each part gives a CM sweep, and the trajectory is the lower
envelope of the results (Lemma 5.1). Both loops are trajectories of the inverse generatrix, along
the two sides of the first trajectory (Lemma 5.3).

Errata. Lemma 5.3: along the inner side, I(G) must stay inside T, and the x-range of I(G) within
that of T. So the boundary extends over D's x-range only. Trajectory_MM also adds pieces beyond both
ends, where the x-range of I(G) reaches beyond T's; they are cut off. Lemma 5.2: the size is O(m n
alpha(min(m, n))), alpha the inverse Ackermann function (E. Oks and M. Sharir, "Minkowski sums of
monotone and general simple polygons", Discrete & Computational Geometry 35, 2006), since the
envelope of N segments can have more than a constant times N pieces (A. Wiernik and M. Sharir 1988,
see `lower_envelope`). Lemma 5.5: the inner boundary can have order m n^2 edges, not O(m n): near a
needle of D_b it has a corner for every pair of a peak and a valley of G_t.
"""

from __future__ import annotations

from collections.abc import Sequence

from exactsweep.numbers.point import Vertex
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.convex_part import measure_unit, split_chain, split_parts
from exactsweep.procedures.envelope import Envelope
from exactsweep.procedures.mm_inner import inner_mm
from exactsweep.procedures.part_pairs import sweep_pairs


def trajectory_mm(generatrix: Sequence[Vertex], directrix: Sequence[Vertex] | Envelope) -> Envelope:
    """Trajectory T(G_t, D_b) of a monotone top chain along a monotone bottom chain.

    Procedure Trajectory_MM.

    Args:
        generatrix: G_t: points from right to left, vertical edges allowed.
        directrix: D_b: points from left to right, vertical edges allowed; or an envelope.

    Returns:
        the path of G's origin as an envelope; with k convex parts in D_b, `sources` is
        i * k + j where part i of G_t slides along part j of D_b.

    Raises:
        ChainError: when a chain is not X-monotone.

    Cost: O(m n log n).

    >>> print(trajectory_mm([(2, 1), (1, 0), (0, 1)], [(0, 0), (1, 1), (2, 0)]))
    (-2, -1) (-1, 0) (0, -1) (1, 0) (2, -1)
    """
    unit = measure_unit(inverted := inverse(generatrix), directrix)
    return sweep_pairs(split_chain(inverted, unit), split_parts(directrix, unit))


def sweep_mm(
    generatrix_top: Sequence[Vertex],
    generatrix_bottom: Sequence[Vertex],
    directrix: Sequence[Vertex],
    trajectory: Envelope | None = None,
) -> tuple[list[Vertex], list[Vertex]]:
    """Inner and outer boundary of the sweep of a monotone G along a monotone D_b.

    Procedure Sweep_MM: `inner_mm` and `outer_mm` for T(G_t, D_b).

    Args:
        generatrix_top: G_t: points from right to left.
        generatrix_bottom: G_b: points from left to right.
        directrix: D_b: points from left to right.
        trajectory: the result of `trajectory_mm` for G_t and D_b, if the caller has it.

    Returns:
        (inner, outer), each from left to right, vertical edges included, no three collinear.

    Raises:
        ChainError: when a chain is not X-monotone.

    Cost: O(m n^2 log n).

    >>> inner, outer = sweep_mm([(1, 1), (0, 1)], [(0, 0), (1, 0)], [(0, 0), (2, 0)])
    >>> inner == [(0, 0), (2, 0)], outer
    (True, [(-1, -1), (3, -1)])
    """
    if trajectory is None:
        trajectory = trajectory_mm(generatrix_top, directrix)
    return (
        inner_mm(generatrix_top, trajectory, directrix),
        list(outer_mm(generatrix_bottom, trajectory)),
    )


def outer_mm(generatrix_bottom: Sequence[Vertex], trajectory: Envelope) -> Envelope:
    """Outer boundary: I(G) slides along the outside of T (Lemma 5.3).

    Cost: O(t n log n) for t edges of T.

    >>> print(outer_mm([(0, 0), (1, 0)], trajectory_mm([(1, 1), (0, 1)], [(0, 0), (2, 0)])))
    (-1, -1) (3, -1)
    """
    return trajectory_mm(inverse(generatrix_bottom), trajectory)
