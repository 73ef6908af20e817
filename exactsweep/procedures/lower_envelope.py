"""LowerEnvelope_CM and LowerEnvelope_MM: lower envelopes of chains (Appendix, Section 5.1).

Lemma A.3 allows the partial trajectory and the next sub-trajectory to meet in a point or in a
segment. With vertical edges in D_b they may also pass each other without meeting, where one of
them ends: the envelope then jumps, and its chain has a vertical edge there.

Erratum. Section 5.1 claims that the envelope of N segments has O(N) pieces. It can have order
N alpha(N) pieces, alpha the inverse Ackermann function: A. Wiernik and M. Sharir, "Planar
realizations of nonlinear Davenport-Schinzel sequences by segments", Discrete & Computational
Geometry 3 (1988). One merge takes linear time, but its result can be larger than its input.
"""

from __future__ import annotations

from collections.abc import Sequence

from exactsweep.procedures.chain import ChainError
from exactsweep.procedures.envelope import (
    Break,
    Envelope,
    find_crossing,
    precedes,
)


def lower_envelope_cm(partial: Envelope, piece: Envelope) -> Envelope:
    """Extend the partial trajectory T_{i-1} by the sub-trajectory T(G_t, D_i) (Appendix).

    Procedure LowerEnvelope_CM, also for sub-outer chains (Corollary A.4). It walks along both from
    right to left. It starts where the first of them ends, and stops where the partial trajectory is
    no longer above the piece. The partial trajectory loses everything right of that place.

    Args:
        partial: the envelope so far; it is changed in place.
        piece: one convex chain that starts over the partial trajectory, crosses it at most once and
            is lower on the right (Lemma A.3). If it crosses more often, only the last crossing
            counts (see `part_pairs.sweep_pairs`). If it ends first, the partial trajectory loses
            its end beyond: in a CM sweep the next piece is lower there.

    Returns:
        The envelope `partial`.

    Raises:
        ChainError: the piece does not start over the partial trajectory.

    Cost: O(edges of the piece + edges trimmed off), and O(log n) to find the right end.

    Example:
        >>> e = Envelope.of([(0, 0), (2, -2), (4, 0)])
        >>> print(lower_envelope_cm(e, Envelope.of([(2, 0), (4, -2), (6, 0)])))
        (0, 0) (2, -2) (3, -1) (4, -2) (6, 0)
    """
    (first, first_d), (n, d) = partial.breaks[0], partial.breaks[-1]
    (start, start_d), (last, last_d) = piece.breaks[0], piece.breaks[-1]
    over = n * start_d - start * d
    if start * first_d < first * start_d or over < 0:
        raise ChainError("the piece does not start over the partial trajectory")
    if over:
        join(partial, piece, ends_first=last * d < n * last_d)
    else:
        partial.take_all(piece)
    return partial


# Where the piece takes over. P is the partial trajectory, Q the piece. The walk goes from right to
# left, over edge i of P and edge j of Q. Let x be the lesser right end of the two edges. At the
# head of the loop, just left of x,
#
#     (1)  P is above Q.
#
# Let x' be the greater left end of the two edges, and let the lines be P_i and Q_j.
#
#     (2)  P_i < Q_j at x': they cross between x' and x. By Lemma A.3 P is lower left of the
#          crossing, and Q right of it. Q takes over at the crossing.
#     (3)  P_i = Q_j at x': Q takes over at x', in a vertex of one of them.
#     (4)  P_i > Q_j at x', and Q begins there: Q takes over at x', by a step down.
#     (5)  P_i > Q_j at x', and P begins there: Q takes over at x', and nothing of P is left.
#     (6)  P_i > Q_j at x', an end of edge i: edge i is above Q throughout and is dropped. If edge
#          i - 1 ends at or below Q_j there, which needs a step of P, Q takes over at x'. If not,
#          (1) holds for edge i - 1.
#     (7)  P_i > Q_j at x', an end of edge j alone: (1) holds for edge j - 1, Q being continuous.
#
# Each round ends the walk, or decreases i, j or both by one.


def join(partial: Envelope, piece: Envelope, *, ends_first: bool = False) -> None:
    """Replace the end of an envelope by a piece, from where the piece becomes the lower one.

    Args:
        partial: the envelope so far; it is changed in place.
        piece: as for `lower_envelope_cm`; the caller has checked that it starts over the partial
            trajectory.
        ends_first: whether the piece ends before the partial trajectory. Then nothing changes if
            the piece is not lower at its end.

    Cost: that of `lower_envelope_cm`.
    """
    breaks, edges = partial.breaks, partial.pieces
    piece_breaks, piece_edges = piece.breaks, piece.pieces
    if ends_first:
        n, d = end = piece_breaks[-1]
        i, j = partial.edge_before(end), len(piece_edges) - 1
    else:
        n, d = end = breaks[-1]
        i, j = len(edges) - 1, 0
        m, e = piece_breaks[1]
        while m * d < n * e:
            j += 1
            m, e = piece_breaks[j + 1]
    adx, ady, ac, _, _ = edges[i]
    bdx, bdy, bc, _, _ = piece_edges[j]
    u, v = ady * bdx - bdy * adx, ac * bdx - bc * adx
    if u * n + v * d <= 0:
        if ends_first:
            return
        i, at = i + 1, end
        m, e = piece_breaks[j + 1]
        if m * d <= n * e:
            j += 1
    else:
        while True:
            n, d = at = breaks[i]
            m, e = others = piece_breaks[j]
            order = m * d - n * e
            if order > 0:
                n, d = at = others
            above = u * n + v * d
            if above < 0:  # (2)
                i, at = i + 1, find_crossing(u, v)
                break
            if order > 0:
                if above == 0 or j == 0:  # (3), (4)
                    i += 1
                    break
            else:
                if above == 0 or i == 0:  # (3), (5)
                    break
                i -= 1  # (6)
                adx, ady, ac, _, _ = edges[i]
                u, v = ady * bdx - bdy * adx, ac * bdx - bc * adx
                if u * n + v * d <= 0:
                    i += 1
                    break
            if order >= 0:  # (7)
                if j == 0:
                    i += 1
                    break
                j -= 1
                bdx, bdy, bc, _, _ = piece_edges[j]
                u, v = ady * bdx - bdy * adx, ac * bdx - bc * adx
    edges[i:] = piece_edges[j:]
    breaks[i:] = piece_breaks[j:]
    breaks[i] = at


def lower_envelope_mm(envelopes: Sequence[Envelope]) -> Envelope:
    """Lower envelope of sub-trajectories, by divide and conquer (Section 5.1).

    Procedure LowerEnvelope_MM. Between chains that do not overlap the envelope has a gap.

    Cost: O(N log k) for k envelopes. N is the largest total size on a level of the recursion, at
    most alpha(k) times the size of the input.

    Example:
        >>> a, b = Envelope.of([(0, 0), (4, 0)]), Envelope.of([(1, 1), (2, -1), (5, 2)])
        >>> print(lower_envelope_mm([a, b]))
        (0, 0) (3/2, 0) (2, -1) (3, 0) (4, 0) (4, 1) (5, 2)
    """
    if len(envelopes) == 1:
        return envelopes[0]
    half = len(envelopes) // 2
    return merge(lower_envelope_mm(envelopes[:half]), lower_envelope_mm(envelopes[half:]))


# The merge of A and B walks along both in vertical sync. Let x_0 < x_1 < ... be the breaks of
# either over their common x-range. Between two of them, A is on one edge i and B on one edge j;
# each is a line or a gap. "Own" is the chain that the envelope is on, "other" the other one, and
#
#     (1)  f = own - other, linear between x_k and x_{k+1}.
#
# Before each round, with the walk at x_k and edges i and j to the right of it,
#
#     (2)  `changes` lists where the envelope changes chain left of x_k, with the edges i and j
#          that begin or continue there. Own is nowhere higher between these places.
#
# To keep (2) beyond x_{k+1}, let s = f just right of x_k and e = f just left of x_{k+1}.
#
#     (3)  s > 0, or s = 0 < e: own is higher right of x_k. Change there, which flips the signs of s
#          and e.
#     (4)  Then s <= 0; and s < 0 if e > 0, by (3). So own becomes higher if and only if e > 0.
#          Change at the crossing, which lies between x_k and x_{k+1}.
#     (5)  s <= 0 and e <= 0: own is lower or equal; no change. On one line, s = e = 0, the envelope
#          stays on its chain.
#     (6)  A gap is the line at infinity. Over a gap of one chain s and e have its sign, and nothing
#          crosses. Over gaps of both, s = e = 0.
#
# Where one chain ends, the other one continues alone, in its edge at that place.


def merge(first: Envelope, second: Envelope) -> Envelope:
    """Merge two envelopes into their lower envelope, in vertical sync where they overlap.

    Cost: O(size of first + size of second).
    """
    a_breaks, b_breaks = first.breaks, second.breaks
    on_first = not precedes(b_breaks[0], a_breaks[0])
    own, other = (first, second) if on_first else (second, first)
    merged = Envelope([own.breaks[0]], [])
    n, d = other.breaks[0]
    if not precedes((n, d), own.breaks[-1]):
        merged.take_all(own)
        merged.take_all(other)
        return merged
    start = own.edge_after((n, d))
    i, j = (start, 0) if on_first else (0, start)
    a_pieces, b_pieces = first.pieces, second.pieces
    size_a, size_b = len(a_pieces), len(b_pieces)
    adx, ady, ac, _, _ = a_pieces[i]
    bdx, bdy, bc, _, _ = b_pieces[j]
    (a_n, a_d), (b_n, b_d) = a_breaks[i + 1], b_breaks[j + 1]
    changes: list[tuple[Break, int, int]] = []
    while True:
        u, v = ady * bdx - bdy * adx, ac * bdx - bc * adx
        s = u * n + v * d
        order = a_n * b_d - b_n * a_d
        if order > 0:
            n, d = b_n, b_d
        else:
            n, d = a_n, a_d
        e = u * n + v * d
        if (s >= 0 or e > 0) if on_first else (s <= 0 or e < 0):
            if not on_first:
                s, e = -s, -e
            if s > 0 or s == 0 < e:  # (3)
                mine, others, k, m = a_breaks[i], b_breaks[j], i, j
                if not on_first:
                    mine, others, k, m = others, mine, j, i
                changes.append((others, k, m) if precedes(mine, others) else (mine, k - 1, m))
                on_first = not on_first
                e = -e
            if e > 0:  # (4)
                at = find_crossing(u, v)
                changes.append((at, i, j) if on_first else (at, j, i))
                on_first = not on_first
        if order <= 0:
            i += 1
            if i == size_a:
                j += order == 0
                break
            adx, ady, ac, _, _ = a_pieces[i]
            a_n, a_d = a_breaks[i + 1]
        if order >= 0:
            j += 1
            if j == size_b:
                break
            bdx, bdy, bc, _, _ = b_pieces[j]
            b_n, b_d = b_breaks[j + 1]
    # A chain that has ended cannot be own any more.
    if on_first == (i == size_a):
        changes.append(((n, d), i - 1, j) if on_first else ((n, d), j - 1, i))
    breaks, pieces = merged.breaks, merged.pieces
    since = 0
    for at, last, following in changes:
        if last >= since:
            pieces += own.pieces[since : last + 1]
            breaks += own.breaks[since + 1 : last + 1]
            breaks.append(at)
        own, other, since = other, own, following
    pieces += own.pieces[since:]
    breaks += own.breaks[since + 1 :]
    return merged
