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

For the inner boundary the directrix is the complement of the lower trajectory's upper side, turned
by half a turn. Its convex parts are the concave runs of T. Their vertices are usually crossings,
not on the lattice. But a sweep of a part moves its edges, pieces of lattice edges, by vertices of
G, and G's edges by the vertices of the part. So integer lines and breaks n/d suffice.

Where G touches D_b the inner loop is D_b itself, and the trajectory shows where G touches D_b. Let
an edge of the trajectory come from part i of G_t and part j of D_b. If D_j has an edge of the same
slope, a vertex of G slides along that edge, or an edge of G lies on it, and G touches all points
passed. Otherwise an edge of G slides over the vertex of D_j between whose edges its slope lies
(Table 1: VE, EE, EV).

The inner boundary R(x) = max over u of T(u) + G_t(x - u) (Lemma 5.3) is nowhere above D_b, since
T(u) <= D_b(x) - G_t(x - u). It equals D_b(x) where this holds with equality, that is, where G
touches D. So only the gaps between touched points need a computation of R.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import chain, pairwise

from exactsweep.numbers.number import Vertex
from exactsweep.procedures.chain import complement, find_convex_parts, inverse, take_corners
from exactsweep.procedures.convex_part import (
    find_touched,
    measure_unit,
    split_chain,
    split_parts,
)
from exactsweep.procedures.envelope import (
    Break,
    Envelope,
    Span,
    precedes,
    value,
)
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


def _take_inside(trajectory: Envelope) -> Envelope:
    """Return the inverse of the complement of a lower trajectory, edges as lines. Cost: O(t)."""
    return Envelope(
        [(-n, d) for n, d in reversed(trajectory.breaks)],
        [(dx, dy, -c, None, source) for dx, dy, c, _, source in reversed(trajectory.pieces)],
    )


def find_gaps(trajectory: Envelope, parts: Sequence[Sequence[Vertex]]) -> list[Span]:
    """Find the x-ranges of D_b between points that G touches, left to right.

    Args:
        trajectory: T(G_t, D_b), `sources` as `trajectory_mm` numbers them.
        parts: the convex parts of D_b.

    Returns:
        list of open x-ranges, none of them empty.

    Cost: O(t log m + m) for t edges of T, and a sort of the touched ranges of each edge of D_b.

    >>> from exactsweep.procedures.mm import trajectory_mm
    >>> notch = [(0, 0), (2, 0), (3, 2), (4, 0), (6, 0)]
    >>> trajectory = trajectory_mm([(1, 0), (0, 0)], notch)
    >>> (left, right), = find_gaps(trajectory, find_convex_parts(notch))
    >>> value(left), value(right)
    (Fraction(5, 2), Fraction(7, 2))
    """
    touched: list[list[list[Span]]] = [[[] for _ in part[1:]] for part in parts]
    last = edge = -1
    for k, source in enumerate(trajectory.sources):
        part = source % len(parts)
        # Pieces from one source become steeper.
        first = edge if source == last else 0
        edge, span = find_touched(parts[part], trajectory, k, first)
        touched[part][edge].append(span)
        last = source
    found: list[Span] = []
    reach: Break = (parts[0][0][0], 1)
    for of_edge in chain.from_iterable(touched):
        if len(of_edge) > 1 and any(precedes(b[0], a[0]) for a, b in pairwise(of_edge)):
            of_edge.sort(key=lambda span: value(span[0]))
        for begin, end in of_edge:
            (n, d), (m, e), (o, f) = reach, begin, end
            if n * e < m * d:
                found.append((reach, begin))
            if n * f < o * d:
                reach = end
    return found


def _close_gaps(floor: Envelope, closed: Envelope, gaps: Iterable[Span]) -> Envelope:
    """Replace an envelope by another one over gaps, which ascend. Cost: O(n)."""
    joined = Envelope([floor.breaks[0]], [])
    for left, right in gaps:
        joined.take_between(floor, joined.breaks[-1], left)
        joined.take_between(closed, left, right)
    joined.take_between(floor, joined.breaks[-1], floor.breaks[-1])
    return joined


def inner_mm(
    generatrix_top: Sequence[Vertex], trajectory: Envelope, directrix: Sequence[Vertex]
) -> list[Vertex]:
    """Inner boundary: I(G) slides along the inside of T (Lemma 5.3).

    After half a turn, G_t slides along the bottom chain of the inverse of T's complement. Where G
    touches D_b the boundary is D_b itself, so the function sweeps the gaps only (see `find_gaps`).
    This is the faster algorithm that the paper mentions after Corollary 5.8.

    Cost: O(t log m + m) to find the gaps, and O(t' n log n) for the t' edges of T along which G
    overlaps a gap; all t of them at worst.

    >>> notch, flat = [(0, 0), (2, 0), (2, 2), (3, 2), (3, 0), (6, 0)], [(2, 0), (0, 0)]
    >>> inner_mm(flat, trajectory_mm(flat, notch), notch)
    [(0, 0), (6, 0)]
    """
    parts = find_convex_parts(directrix)
    open_spans = [((-n, d), (-m, e)) for (m, e), (n, d) in reversed(find_gaps(trajectory, parts))]
    if not open_spans:
        return take_corners(directrix)
    inside, reversed_top = _take_inside(trajectory), inverse(generatrix_top)
    unit = measure_unit(reversed_top, inside)
    chains, slots = split_chain(reversed_top, unit), split_parts(inside, unit)
    floor = Envelope.of(inverse(complement(directrix)))
    closed = sweep_pairs(chains, slots, open_spans)
    return inverse(complement(list(_close_gaps(floor, closed, open_spans))))
