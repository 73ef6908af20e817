"""Piecewise linear functions of x, and their lower envelopes (Section 5.1, Appendix).

By Lemma A.3, the partial trajectory and the next subtrajectory meet in a point or in a segment.
If D_b has vertical edges, they may also pass each other without meeting, where one of them ends:
the envelope then jumps.

Erratum. Section 5.1 claims that the envelope of N segments has O(N) pieces. It can have order N
alpha(N) pieces, alpha the inverse Ackermann function (A. Wiernik and M. Sharir, "Planar
realizations of nonlinear Davenport-Schinzel sequences by segments", Discrete & Computational
Geometry 3, 1988). One merge takes linear time, but its result can be larger than its input.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from itertools import pairwise

from exactsweep.geometry.frame import HomogeneousPoint
from exactsweep.numbers.number import Vertex
from exactsweep.procedures.chain import Break, Chain, find_point, precedes

VertexContact = tuple[HomogeneousPoint, int, int]
"""(position, i, j): at this position of G vertex i of D_b meets vertex j of reversed G_t (VV)."""

Piece = tuple[int, int, int, VertexContact, VertexContact]
"""(dx, dy, c, start, end): a line, and the contacts at both ends of its edge (Table 1).

    start (i, j), end (i + 1, j)      VE: vertex j of G slides along edge i of D_b
    start (i, j), end (i, j + 1)      EV: edge j of G slides over vertex i of D_b
    start (i, j), end (i + 1, j + 1)  EE: edge j of G slides along edge i of D_b

An envelope may use only a part of the edge. Collinear edges count as one.
"""

GAP: Piece = (0, 0, 1, ((0, 0, 0), -1, -1), ((0, 0, 0), -1, -1))
"""The piece between graphs that do not overlap in x: the line at infinity, above all others."""


Ranges = Sequence[tuple[Break, Break]]
"""Disjoint x-ranges, from left to right."""


class Graph:
    """A piecewise linear function of x. Iteration yields the points of its chain.

    Attributes:
        breaks: the breaks, ascending.
        pieces: piece k extends from break k to break k + 1. At a jump the lower limit counts.
    """

    def __init__(self, breaks: list[Break], pieces: list[Piece]) -> None:
        self.breaks, self.pieces = breaks, pieces

    def clip(self, start: Break, end: Break) -> Graph:
        """Return the function between two breaks. Cost: O(log n + its size)."""
        first = find_piece(self, start)
        last = bisect_left(self.breaks, True, key=lambda at: not precedes(at, end))
        return Graph([start, *self.breaks[first + 1 : last], end], self.pieces[first:last])

    def chain(self) -> Chain:
        """Return the graph as a chain: vertical edges at jumps, no three vertices collinear.

        Raises ChainError if the graph has a gap. Cost: O(n).
        """
        vertices = [find_point(self.pieces[0], self.breaks[0])]
        for (before, after), at in zip(pairwise(self.pieces), self.breaks[1:-1], strict=True):
            _, _, _, _, end = before
            _, _, _, start, _ = after
            if end is start:
                # Successive edges of one subtrajectory: no arithmetic is needed.
                vertices.append(start[0])
            elif any(subtract(before, after)):
                # One vertex where the lines cross, two at a jump.
                vertices += dict.fromkeys((find_point(before, at), find_point(after, at)))
        vertices.append(find_point(self.pieces[-1], self.breaks[-1]))
        return Chain(vertices)

    def __iter__(self) -> Iterator[Vertex]:
        return iter(self.chain())


def find_piece(graph: Graph, at: Break) -> int:
    """Return the index of the piece right of a break; -1 left of the graph."""
    return bisect_left(graph.breaks, True, key=lambda other: precedes(at, other)) - 1


def subtract(p: Piece, q: Piece) -> tuple[int, int]:
    """Return (a, b): at x/w, the line of p is above that of q if a x + b w > 0."""
    pdx, pdy, pc, _, _ = p
    qdx, qdy, qc, _, _ = q
    return pdy * qdx - qdy * pdx, pc * qdx - qc * pdx


def find_crossing(a: int, b: int) -> Break:
    """Return the break x/w with a x + b w = 0."""
    return (-b, a) if a > 0 else (b, -a)


# LowerEnvelope_CM. P is the partial trajectory, S the subtrajectory; P_i is pieces[i], and S_j is
# other_pieces[j]. The walk goes from right to left, from the lesser right end of P and S. Before
# each round, with x the lesser right end of P_i and S_j,
#
#     (1)  right of x, P is above S wherever both are defined.
#
# Let x' be the greater left end of P_i and S_j.
#
#     (2)  P_i <= S_j at x: S takes over at x. They meet there, or P has a step there, or the walk
#          has just begun.
#     (3)  P_i < S_j at x': S takes over where the two lines cross.
#     (4)  P_i >= S_j at x': (1) holds for x', and the walk passes the pieces that begin at x'. At
#          the end of S, S takes over at x'; at the end of P, S replaces P.
#
# If S takes over at or right of its right end, P is unchanged. Otherwise S replaces everything in P
# right of that point, even if S ends before P (see `mm`).


def lower_envelope_cm(partial: Graph, subtrajectory: Graph) -> Graph:
    """Extend the partial trajectory T_{i-1} in place by the subtrajectory T(G_t, D_i) (Appendix).

    Procedure LowerEnvelope_CM. "We traverse the subtrajectory from right to left. In the beginning,
    T_{i-1} appears above T(G_t, D_i), and then the intersection is detected by a switch in this
    vertical relationship." They cross at most once, and the subtrajectory is lower on the right
    (Lemma A.3). Without its irrelevant edges, it may begin right of T_{i-1}: it is appended. It may
    also end first: the walk begins at its end.

    Cost: O(edges of the subtrajectory + edges trimmed off), plus O(log n) if it ends first.
    """
    pieces, breaks = partial.pieces, partial.breaks
    other_pieces, other_breaks = subtrajectory.pieces, subtrajectory.breaks
    if precedes(breaks[-1], other_breaks[0]):
        pieces.append(GAP)
        breaks.append(other_breaks[0])
    # The walk begins at the pieces that end at the lesser right end, or extend over it.
    x, w = end = breaks[-1]
    i, j = len(pieces) - 1, -1
    if precedes(other_breaks[-1], end):
        x, w = end = other_breaks[-1]
        i = bisect_left(breaks, True, key=lambda at: not precedes(at, end)) - 1
    while precedes(other_breaks[j + 1], end):
        j += 1
    while i >= 0 and j >= 0:
        a, b = subtract(pieces[i], other_pieces[j])
        if a * x + b * w <= 0:  # (2)
            break
        (x, w), (other_x, other_w) = breaks[i], other_breaks[j]
        order = x * other_w - other_x * w
        if order < 0:
            x, w = other_x, other_w
        if a * x + b * w < 0:  # (3)
            x, w = find_crossing(a, b)
            break
        i -= order >= 0  # (4)
        j -= order <= 0
    if i < 0:
        j, (x, w) = 0, other_breaks[0]
    elif j < 0 or not precedes((x, w), other_breaks[j + 1]):
        j += 1
    if j < len(other_pieces):
        pieces[i + 1 :] = other_pieces[j:]
        breaks[i + 1 :] = [(x, w), *other_breaks[j + 1 :]]
    return partial


def lower_envelope_mm(graphs: Sequence[Graph]) -> Graph:
    """Return the lower envelope of subtrajectories, by divide and conquer (Section 5.1).

    Procedure LowerEnvelope_MM. Between graphs that do not overlap, the envelope has a `GAP`.

    Cost: O(N log k) for k graphs, where N, the largest total size on a level of the recursion, is
    at most alpha(k) times the size of the input.

    >>> rising = Graph([(0, 1), (2, 1)], [(1, 1, 0, ((0, 0, 1), 0, 0), ((2, 2, 1), 1, 0))])
    >>> falling = Graph([(0, 1), (2, 1)], [(1, -1, 2, ((0, 2, 1), 1, 0), ((2, 0, 1), 2, 0))])
    >>> list(lower_envelope_mm([falling, rising])), list(lower_envelope_cm(rising, falling))
    ([(0, 0), (1, 1), (2, 0)], [(0, 0), (1, 1), (2, 0)])
    """
    if len(graphs) == 1:
        return graphs[0]
    half = len(graphs) // 2
    return merge(lower_envelope_mm(graphs[:half]), lower_envelope_mm(graphs[half:]))


# The merge of P and Q, where P begins first, walks along both in sync. Their breaks cut the common
# x-range into intervals over which both are lines. Before each round,
#
#     (1)  the envelope is complete left of x; `merged` are its pieces, `starts` their left ends.
#
# Let [x, end] be the next interval, and s and e the height of P above Q at x and at end.
#
#     (2)  s < 0, or s = 0 and e <= 0: P is lower right of x; otherwise Q is. On one line, s = e =
#          0, and either may be chosen.
#     (3)  s and e have opposite signs: the lines cross in between, and the other one takes over.
#
# If the lower piece is the same as before, it is extended. Left of the common x-range, the envelope
# is P; right of it, the graph that continues.


def merge(first: Graph, second: Graph) -> Graph:
    """Return the lower envelope of two graphs."""
    if precedes(second.breaks[0], first.breaks[0]):
        first, second = second, first
    pieces, breaks = first.pieces, first.breaks
    other_pieces, other_breaks = second.pieces, second.breaks
    x, w = start = other_breaks[0]
    i, j = find_piece(first, start), 0
    # P left of the common x-range, and a gap if P ends before Q begins.
    kept = i + precedes(breaks[i], start)
    starts, merged = breaks[:kept], [*pieces, GAP][:kept]
    while i < len(pieces) and j < len(other_pieces):
        lower, upper = pieces[i], other_pieces[j]
        (end, end_w), (other_end, other_w) = breaks[i + 1], other_breaks[j + 1]
        order = end * other_w - other_end * end_w
        if order > 0:
            end, end_w = other_end, other_w
        i += order <= 0
        j += order >= 0
        a, b = subtract(lower, upper)
        s, e = a * x + b * w, a * end + b * end_w
        if s > 0 or s == 0 < e:  # (2)
            lower, upper = upper, lower
        if not merged or merged[-1] is not lower:
            merged.append(lower)
            starts.append((x, w))
        if s < 0 < e or e < 0 < s:  # (3)
            merged.append(upper)
            starts.append(find_crossing(a, b))
        x, w = end, end_w
    rest, rest_breaks = pieces[i:] or other_pieces[j:], breaks[i + 1 :] or other_breaks[j + 1 :]
    if rest and rest[0] is merged[-1]:
        merged.pop()
        x, w = starts.pop()
    return Graph([*starts, (x, w), *rest_breaks], merged + rest)
