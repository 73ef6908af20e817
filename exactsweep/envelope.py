"""Lower envelopes of chains, and LowerEnvelope_CM and LowerEnvelope_MM (Appendix, Section 5.1).

An envelope is kept as the edges it is made of, each whole, with the breaks between which each one
is the lowest.  An edge that a crossing cuts short keeps the end points it was given with: on
integer input all edges stay integer, a crossing is only a break n/d, and no Fraction is made
before somebody reads the vertices.

Lemma A.3 allows the partial trajectory and the next sub-trajectory to meet in a point or in a
segment.  With vertical edges in D_b they may also pass each other without meeting, where one of
them ends: the envelope then jumps, and its chain has a vertical edge there.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple, cast

from exactsweep.chain import ChainError, Edge, Rational, Vertex, convex_parts
from exactsweep.piece import (
    Break,
    Line,
    Piece,
    crossing,
    gap,
    height,
    joined,
    line_of,
    point_on,
    precedes,
)


class Part(NamedTuple):
    """A strictly convex chain, and the breaks on its first and last edge between which it holds."""

    points: list[Vertex]
    left: Break
    right: Break


class Envelope:
    """The lower envelope of chains: edge k is the lowest from break k to break k + 1.

    Iterating gives the vertices from left to right, vertical edges included, no three collinear.
    `sources[k]` is the number of the chain that edge k comes from.

    >>> list(Envelope.of([(0, 0), (1, -1), (2, 0)]))
    [(0, 0), (1, -1), (2, 0)]
    """

    __slots__ = ("_lines", "breaks", "edges", "sources")

    def __init__(self, breaks: list[Break], edges: list[Piece], sources: list[int]) -> None:
        self.breaks = breaks
        self.edges = edges
        self.sources = sources
        self._lines: list[Line | None] | None = None

    def lines(self) -> list[Line | None]:
        """The lines of the edges, as `line_of` gives them, kept from one merge to the next."""
        if self._lines is None:
            self._lines = lines = []
            for edge in self.edges:
                if edge is None or len(edge) == 3:
                    lines.append(edge)
                else:
                    (px, py), (qx, qy) = edge
                    dx, dy = qx - px, qy - py
                    lines.append((dx, dy, py * dx - px * dy))
        return self._lines

    def follows(self, other: Envelope) -> bool:
        """Whether it starts over another one, and ends where that ends or right of it."""
        return not (
            precedes(self.breaks[0], other.breaks[0])
            or precedes(other.breaks[-1], self.breaks[0])
            or precedes(self.breaks[-1], other.breaks[-1])
        )

    def extend_hole(self, end: Break) -> None:
        """Append a hole up to a break."""
        self.lines().append(None)
        self.edges.append(None)
        self.sources.append(-1)
        self.breaks.append(end)

    def extend(self, other: Envelope) -> None:
        """Append one that starts where this one ends, or right of that.  Cost: O(its size)."""
        if precedes(self.breaks[-1], other.breaks[0]):
            self.extend_hole(other.breaks[0])
        self.lines().extend(other.lines())
        self.edges += other.edges
        self.sources += other.sources
        self.breaks += other.breaks[1:]

    def padded(self, start: Break, end: Break) -> Envelope:
        """The same over a wider x-range, with holes at the ends.  Cost: O(n)."""
        if not precedes(start, self.breaks[0]) and not precedes(self.breaks[-1], end):
            return self
        padded = Envelope([start], [], [])
        padded.extend(self)
        if precedes(self.breaks[-1], end):
            padded.extend_hole(end)
        return padded

    @classmethod
    def of(cls, chain: Sequence[Vertex], source: int = 0) -> Envelope:
        """Wrap a chain, from left to right, vertical edges allowed.

        Raises ChainError when it is not X-monotone.  Cost: O(n).
        """
        envelope = cls([(chain[0][0], 1)], [], [])
        for part in convex_parts(chain):
            # Points of its own, so that edges are `joined` inside the part alone.
            envelope.extend(cls.of_own([(x, y) for x, y in part], source))
        return envelope

    @classmethod
    def of_own(cls, chain: Sequence[Vertex], source: int = 0) -> Envelope:
        """Wrap a strictly convex chain whose point objects no other chain shares.  Cost: O(n)."""
        edges: list[Piece] = list(pairwise(chain))
        return cls([(x, 1) for x, _ in chain], edges, [source] * len(edges))

    def parts(self) -> list[Part]:
        """Convex parts of the envelope, with the breaks between which each one holds.

        The cut edges at either end of a part are whole.  What that adds lies above the envelope,
        on the chain it was cut from.  Cost: O(n).

        Example:
            >>> e = Envelope.of([(0, 0), (3, 1)])
            >>> print(lower_envelope_cm(e, Envelope.of([(1, 2), (4, -1)])))
            (0, 0) (9/4, 3/4) (4, -1)
            >>> [part.points for part in e.parts()]
            [[(0, 0), (3, 1)], [(1, 2), (4, -1)]]
        """
        parts: list[Part] = []
        edges = cast(list[Edge], self.edges)
        points, first = list(edges[0]), self.breaks[0]
        for k, (start, end) in enumerate(edges[1:], 1):
            # One and the same point object: consecutive edges of one convex chain.  Equal points
            # of two chains start a new part, which is as right and happens seldom.
            if start is not points[-1]:
                parts.append(Part(points, first, self.breaks[k]))
                points, first = [start], self.breaks[k]
            points.append(end)
        parts.append(Part(points, first, self.breaks[-1]))
        return parts

    def __iter__(self) -> Iterator[Vertex]:
        edges, breaks = self.edges, self.breaks
        before = edges[0]
        yield point_on(before, breaks[0])
        for after, at in zip(edges[1:], breaks[1:-1], strict=True):
            if joined(before, after):
                yield cast(Edge, before)[1]
            else:
                n, d = at
                u, v = gap(line_of(before), line_of(after))
                step = u * n + v * d != 0
                if step or u != 0:
                    yield point_on(before, at)
                if step:
                    yield point_on(after, at)
            before = after
        yield point_on(before, breaks[-1])

    def take(self, chain: Envelope, first: int, last: int, end: Break) -> None:
        """Append edges first to last of a chain, cut at the break `end`.

        The break lies on the last edge or where it starts.  Cost: O(edges appended).
        """
        if last == len(chain.edges) or not precedes(chain.breaks[last], end):
            last -= 1
        if last >= first:
            self.lines().extend(chain.lines()[first : last + 1])
            self.edges += chain.edges[first : last + 1]
            self.sources += chain.sources[first : last + 1]
            self.breaks += chain.breaks[first + 1 : last + 1]
            self.breaks.append(end)

    def edge_before(self, at: Break, first: int = 0) -> int:
        """The number of the edge, from the first, that holds just left of a break.

        Cost: O(log n).
        """
        n, d = at
        return bisect_left(self.breaks, True, first, key=lambda b: b[0] * d >= n * b[1]) - 1

    def edge_after(self, at: Break) -> int:
        """The number of the edge that holds just right of a break.  Cost: O(log n)."""
        n, d = at
        return bisect_left(self.breaks, True, key=lambda b: b[0] * d > n * b[1]) - 1

    def __str__(self) -> str:
        return " ".join(f"({x}, {y})" for x, y in self)

    def restricted(self, start: Rational, end: Rational) -> Envelope:
        """Cut to the x-range from start to end, which must overlap it.  Cost: O(n)."""
        breaks = self.breaks
        first = max(k for k, (n, d) in enumerate(breaks[:-1]) if k == 0 or n <= start * d)
        last = min(k for k, (n, d) in enumerate(breaks) if k > first and n >= end * d)
        return Envelope(
            [(start, 1), *breaks[first + 1 : last], (end, 1)],
            self.edges[first:last],
            self.sources[first:last],
        )


def lower_envelope_cm(partial: Envelope, piece: Envelope) -> Envelope:
    """Extend the partial trajectory T_{i-1} by the sub-trajectory T(G_t, D_i) (Appendix).

    Procedure LowerEnvelope_CM, which also serves the sub-outer chains (Corollary A.4): both are
    walked from right to left, from where the first of them ends to where the partial trajectory is
    no longer above the piece; what lies right of that is trimmed off the partial trajectory.

    Args:
        partial: the envelope so far; it is changed in place.
        piece: one convex chain, starting over the partial trajectory, that crosses it at most
            once and is the lower one on the right (Lemma A.3); if it crosses more often, only the
            last crossing counts (see `mm.sweep_pairs`).  If it ends first, what is left of the
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

    Procedure LowerEnvelope_MM.  Between chains that do not overlap the envelope has a hole.

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
