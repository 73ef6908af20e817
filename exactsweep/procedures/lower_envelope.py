"""LowerEnvelope_CM and LowerEnvelope_MM: lower envelopes of chains (Appendix, Section 5.1)."""

from __future__ import annotations

from collections.abc import Sequence

from exactsweep.procedures.chain import ChainError
from exactsweep.procedures.envelope import Envelope, crossing, height, joined, line_of, precedes


def lower_envelope_cm(partial: Envelope, piece: Envelope) -> Envelope:
    """Extend the partial trajectory T_{i-1} by the sub-trajectory T(G_t, D_i) (Appendix).

    Procedure LowerEnvelope_CM, which also serves the sub-outer chains (Corollary A.4): both are
    walked from right to left, from where the first of them ends to where the partial trajectory is
    no longer above the piece; what lies right of that is trimmed off the partial trajectory.

    Args:
        partial: the envelope so far; it is changed in place.
        piece: one convex chain, starting over the partial trajectory, that crosses it at most
            once and is the lower one on the right (Lemma A.3); if it crosses more often, only the
            last crossing counts (see `mm.sweep_pairs`). If it ends first, what is left of the
            partial trajectory beyond is dropped: in a CM sweep the next piece is lower there.

    Returns:
        The same envelope.

    Raises:
        ChainError: the piece does not start over the partial trajectory.

    Cost: O(edges of the piece + edges trimmed off), and O(log n) to find the right end.

    Example:
        >>> e = Envelope.of([(0, 0), (2, -2), (4, 0)])
        >>> print(lower_envelope_cm(e, Envelope.of([(2, 0), (4, -2), (6, 0)])))
        (0, 0) (2, -2) (3, -1) (4, -2) (6, 0)
    """
    partial._lines = None
    breaks, edges, sources = partial.breaks, partial.edges, partial.sources
    start, end = piece.breaks[0], breaks[-1]
    if precedes(start, breaks[0]) or precedes(end, start):
        raise ChainError("the piece does not start over the partial trajectory")
    j = 0
    if precedes(piece.breaks[-1], end):
        end = piece.breaks[-1]
        k, j = partial.edge_before(end), len(piece.edges) - 1
        if height(edges[k], piece.edges[j], end) <= 0:
            return partial
        del edges[k + 1 :], sources[k + 1 :], breaks[k + 2 :]
        breaks[-1] = end
        j = _trim(partial, piece, j)
    elif precedes(start, end):
        j = piece.edge_before(end)
        if height(edges[-1], piece.edges[j], end) > 0:
            j = _trim(partial, piece, j)
        elif not precedes(end, piece.breaks[j + 1]):
            j += 1
    sources += piece.sources[j:]
    edges += piece.edges[j:]
    breaks += piece.breaks[j + 1 :]
    return partial


def _trim(partial: Envelope, piece: Envelope, j: int) -> int:
    """Trim the partial trajectory to where the piece takes over; return the piece's edge there.

    Invariant: just left of the last break, which lies on edge j of the piece or at its right end,
    the partial trajectory is above the piece.
    """
    breaks, edges, sources = partial.breaks, partial.edges, partial.sources
    top, (bdx, bdy, bc) = edges[-1], line_of(piece.edges[j])
    adx, ady, ac = line_of(top)
    while True:
        mine, others = breaks[-2], piece.breaks[j]
        order = others[0] * mine[1] - mine[0] * others[1]
        n, d = others if order > 0 else mine
        u, v = ady * bdx - bdy * adx, ac * bdx - bc * adx
        above = u * n + v * d
        if above < 0:
            breaks[-1] = crossing(u, v)
            return j
        if order > 0:
            if above == 0 or j == 0:
                # They meet in a vertex; or the piece starts below: a step down.
                breaks[-1] = others
                return j
        else:
            del edges[-1], sources[-1], breaks[-1]
            if above == 0 or not edges:
                return j
            below, top = top, edges[-1]
            # At a crossing the next edge ends as high as this one began; at a step up it may end
            # on or below the piece, which then takes over right there.
            if not joined(top, below) and height(top, piece.edges[j], mine) <= 0:
                return j
            adx, ady, ac = line_of(top)
        if order >= 0:
            if j == 0:
                return j
            j -= 1
            bdx, bdy, bc = line_of(piece.edges[j])


def lower_envelope_mm(envelopes: Sequence[Envelope]) -> Envelope:
    """Lower envelope of sub-trajectories, by divide and conquer (Section 5.1).

    Procedure LowerEnvelope_MM. Between chains that do not overlap the envelope has a hole.

    Cost: O(N log k) for k envelopes, N being the largest total size on a level of the recursion.
    The paper takes N for the size of the input; the envelope of N segments can have more than a
    constant times N pieces, so that the proved bound has a factor alpha(k) more.

    Example:
        >>> a, b = Envelope.of([(0, 0), (4, 0)]), Envelope.of([(1, 1), (2, -1), (5, 2)])
        >>> print(lower_envelope_mm([a, b]))
        (0, 0) (3/2, 0) (2, -1) (3, 0) (4, 0) (4, 1) (5, 2)
    """
    if len(envelopes) == 1:
        return envelopes[0]
    half = len(envelopes) // 2
    return merge(lower_envelope_mm(envelopes[:half]), lower_envelope_mm(envelopes[half:]))


def merge(first: Envelope, second: Envelope) -> Envelope:
    """Lower envelope of two envelopes, both walked in vertical sync where they overlap.

    Cost: O(size of first + size of second).
    """
    a_breaks, b_breaks = first.breaks, second.breaks
    # The envelope has been on the first or the second chain since edge number `since` of it.
    on_first, since = not precedes(b_breaks[0], a_breaks[0]), 0
    left, right = (first, second) if on_first else (second, first)
    merged = Envelope([left.breaks[0]], [], [])
    n, d = right.breaks[0]
    if not precedes((n, d), left.breaks[-1]):
        merged.extend(left)
        merged.extend(right)
        return merged
    start = left.edge_after((n, d))
    i, j = (start, 0) if on_first else (0, start)
    a_lines, b_lines = first.lines(), second.lines()
    last_a, last_b = len(a_lines) - 1, len(b_lines) - 1
    a, b = a_lines[i], b_lines[j]
    while True:
        end_a, end_b = a_breaks[i + 1], b_breaks[j + 1]
        order = end_a[0] * end_b[1] - end_b[0] * end_a[1]
        if a is None or b is None:
            # Over a hole of one chain the other one is lower throughout.
            if on_first != (a is not None):
                merged.take(*((first, since, i) if on_first else (second, since, j)), (n, d))
                on_first, since = not on_first, j if on_first else i
            if a is None and order > 0:
                j = min(second.edge_before(end_a, j + 1), last_b)
            elif a is not None and order < 0:
                i = min(first.edge_before(end_b, i + 1), last_a)
            a, b = a_lines[i], b_lines[j]
            end_a, end_b = a_breaks[i + 1], b_breaks[j + 1]
            order = end_a[0] * end_b[1] - end_b[0] * end_a[1]
            n, d = end_a if order <= 0 else end_b
        else:
            adx, ady, ac = a
            bdx, bdy, bc = b
            u, v = ady * bdx - bdy * adx, ac * bdx - bc * adx
            at_start = u * n + v * d
            begin = n, d
            n, d = end_a if order <= 0 else end_b
            at_end = u * n + v * d
            # Where both lie on one line, the envelope stays on the chain that it is on.
            if on_first:
                if at_start > 0 or (at_start == 0 and at_end > 0):
                    merged.take(first, since, i, begin)
                    on_first, since = False, j
            elif at_start < 0 or (at_start == 0 and at_end < 0):
                merged.take(second, since, j, begin)
                on_first, since = True, i
            if (at_start < 0 < at_end) or (at_end < 0 < at_start):
                at = crossing(u, v)
                merged.take(*((first, since, i) if on_first else (second, since, j)), at)
                on_first, since = not on_first, j if on_first else i
        if order <= 0:
            if i == last_a:
                over, rest, following, on_over = first, second, j + (order == 0), on_first
                break
            i += 1
            a = a_lines[i]
        if order >= 0:
            if j == last_b:
                over, rest, following, on_over = second, first, i, not on_first
                break
            j += 1
            b = b_lines[j]
    if on_over:
        merged.take(over, since, len(over.edges), over.breaks[-1])
        since = following
    merged.take(rest, since, len(rest.edges), rest.breaks[-1])
    return merged
