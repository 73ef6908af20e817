"""Convex parts, and what of their sub-trajectories matters (Sections 4 and 5, step 1).

A convex part is a maximal run of edges that become steeper: of D_b, of reversed G_t, or of a
trajectory that is the directrix of the next sweep. Each edge is whole and holds between two breaks.
Mostly all vertices are on the lattice, and only the two end edges may be cut by a break; what they
have beyond is above the part, on the chain that it was cut from. Inside a trajectory, the vertices
are crossings: there each edge is known by its line.

What matters of T(G_t, D_i), the sum of a part c of reversed G_t and a part p = D_i:

    (1)  T(G_t, D_i) has the edges of c and of p in order of slope (Lemma 3.1).
    (2)  Where the part before p is at least as low at their common end, p need not be turned about
         there: G standing on that end with an edge flatter than p's first one would overlap the
         part before. So these edges of c are above the envelope except for single points, and need
         not be made.
    (3)  The same holds for p's last edge and the steeper edges of c.
    (4)  A sum does not know which of its two chains moves: (2) and (3) hold with c and p exchanged.
    (5)  At a convex end of both, on the lattice, or at a lower end than the neighbour's, p has to
         be turned about; so it has at the ends of D_b.

In an MM sweep what matters of a pair is the edges whose slopes lie between the ends of both parts,
which for most pairs of real outlines is nothing.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import inf
from operator import itemgetter
from typing import NamedTuple, cast

from exactsweep.geometry.point import Rational, Vertex
from exactsweep.procedures.chain import find_convex_parts
from exactsweep.procedures.envelope import Break, Envelope, Piece, bound_slope, take_edges

Box = tuple[Rational, Rational, Rational]
"""Bounds of a convex part: (left, right, low), of its x-range and its least y, rounded to ints."""

Slopes = tuple[Rational | float, Rational | float]
"""Bounds of the slopes in which a convex part matters: (flattest, steepest).

They are ints as `bound_slope` gives them, or infinite where the other polygon turns about an end of
the part.
"""

_height = itemgetter(1)


class ConvexPart(NamedTuple):
    """A convex part with its vertices on the lattice.

    Attributes:
        points: its vertices, the end edges whole.
        left: the break on the first edge from which on it holds.
        right: the same on the last edge.
        turns_left: whether the other polygon has to turn about the left end, (5).
        turns_right: the same for the right end.
        edges: its edges as pieces.
    """

    points: Sequence[Vertex]
    left: Break
    right: Break
    turns_left: bool
    turns_right: bool
    edges: Sequence[Piece]

    @property
    def box(self) -> Box:
        """Its box."""
        return (*self.x_range, min(self.points, key=_height)[1])

    @property
    def x_range(self) -> tuple[Rational, Rational]:
        """Its x-range, rounded outwards to ints."""
        return round_outwards(self.left, self.right)

    @property
    def slopes(self) -> Slopes:
        """The slopes in which it matters."""
        return bound_slopes(self.edges, self.turns_left, self.turns_right)

    def sweep(self, chain: ConvexPart, source: int) -> Envelope:
        """The CC sweep of a part of reversed G_t along this part, as far as it matters.

        Args:
            chain: the part of G_t, not cut.
            source: the number of what is swept.

        Returns an envelope, which has no pieces if nothing matters. Cost: O(m_i + n_t).
        """
        points, (left, left_d), (right, right_d), turns_left, turns_right, own = self
        origins, _, _, chain_left, chain_right, others = chain
        i, last_i, j, last_j = _find_what_matters(
            own, turns_left, turns_right, others, chain_left, chain_right
        )
        (x, y), (ox, oy) = points[i], origins[j]
        x += ox
        y += oy
        # Whole, an end edge goes beyond the break; it may have been left out for its slope, (4).
        cuts_left = i == 0 < last_i and left != points[0][0] * left_d
        cuts_right = i < last_i == len(own) and right != points[-1][0] * right_d
        breaks: list[Break] = [(left + ox * left_d, left_d) if cuts_left else (x, 1)]
        pieces: list[Piece] = []
        while i < last_i and j < last_j:  # (1)
            dx, dy, _, _, _ = own[i]
            edx, edy, _, _, _ = others[j]
            turn = edx * dy - edy * dx
            if turn > 0:
                dx, dy = edx, edy
                j += 1
            else:
                i += 1
                if turn == 0:
                    dx, dy = dx + edx, dy + edy
                    j += 1
            pieces.append((dx, dy, y * dx - x * dy, (x, y), source))
            x += dx
            y += dy
            breaks.append((x, 1))
        for dx, dy, _, _, _ in own[i:last_i] or others[j:last_j]:
            pieces.append((dx, dy, y * dx - x * dy, (x, y), source))
            x += dx
            y += dy
            breaks.append((x, 1))
        if cuts_right:
            breaks[-1] = right + (x - points[-1][0]) * right_d, right_d
        return Envelope(breaks, pieces)


class CrossingPart(NamedTuple):
    """A convex part whose vertices are crossings: edges by their lines.

    Attributes:
        edges: its edges as pieces.
        breaks: edge k holds from break k to break k + 1.
        turns_left: whether the other polygon has to turn about the left end, (5).
        turns_right: the same for the right end.
    """

    edges: Sequence[Piece]
    breaks: Sequence[Break]
    turns_left: bool
    turns_right: bool

    @property
    def box(self) -> Box:
        """Its box. A convex part is lowest at an end or at a vertex, all of which are breaks."""
        edges, breaks, _, _ = self
        lows = [
            (dy * n + c * d) // (dx * d)
            for (dx, dy, c, _, _), (n, d) in zip((*edges, edges[-1]), breaks, strict=True)
        ]
        return (*self.x_range, min(lows))

    @property
    def x_range(self) -> tuple[Rational, Rational]:
        """Its x-range, rounded outwards to ints."""
        return round_outwards(self.breaks[0], self.breaks[-1])

    @property
    def slopes(self) -> Slopes:
        """The slopes in which it matters."""
        return bound_slopes(self.edges, self.turns_left, self.turns_right)

    def sweep(self, chain: ConvexPart, source: int) -> Envelope:
        """The CC sweep of a part of reversed G_t along this part, as far as it matters.

        An edge is moved by a vertex of G; an edge of G by a crossing (x/w, y/w), which makes its
        line integer again when it is multiplied by w.

        Arguments, result and cost as for `ConvexPart.sweep`.
        """
        own, breaks, turns_left, turns_right = self
        points, _, _, chain_left, chain_right, steps = chain
        first, last, at, end = _find_what_matters(
            own, turns_left, turns_right, steps, chain_left, chain_right
        )
        n, d = breaks[first]
        pieces: list[Piece] = []
        found: list[Break] = [(n + points[at][0] * d, d)]
        for k in range(first, last + 1):
            # About vertex k, G turns up to the slope of edge k, in the end up to its own last edge.
            dx, dy, c, _, _ = own[k] if k < len(own) else own[-1]
            start = at
            while at < end and (k == last or steps[at][1] * dx < steps[at][0] * dy):
                at += 1
            if at > start:
                n, d = breaks[k]
                x, y, w = n * dx, dy * n + c * d, dx * d
                for (ex, ey, ec, _, _), (px, _) in zip(
                    steps[start:at], points[start + 1 : at + 1], strict=True
                ):
                    pieces.append((ex * w, ey * w, ec * w + y * ex - x * ey, None, source))
                    found.append((n + px * d, d))
            if k < last:
                px, py = points[at]
                if at < end and steps[at][1] * dx == steps[at][0] * dy:
                    at += 1
                pieces.append((dx, dy, c + py * dx - px * dy, None, source))
                n, d = breaks[k + 1]
                found.append((n + points[at][0] * d, d))
        return Envelope(found, pieces)


def round_outwards(start: Break, end: Break) -> tuple[Rational, Rational]:
    """The least x-range between ints that holds two breaks. Cost: O(1)."""
    (n, d), (m, e) = start, end
    return n // d, -(-m // e)


def bound_slopes(edges: Sequence[Piece], turns_left: bool, turns_right: bool) -> Slopes:
    """The slopes in which a convex part of some edges matters. Cost: O(1)."""
    return (
        -inf if turns_left else bound_slope(edges[0]),
        inf if turns_right else bound_slope(edges[-1]),
    )


def _find_what_matters(
    own: Sequence[Piece],
    turns_left: bool,
    turns_right: bool,
    others: Sequence[Piece],
    chain_left: bool,
    chain_right: bool,
) -> tuple[int, int, int, int]:
    """Which edges of a part and of a part of reversed G_t matter.

    Args:
        own: the edges of the part.
        turns_left: whether the other polygon has to turn about its left end, (5).
        turns_right: the same for its right end.
        others: the edges of the part of reversed G_t.
        chain_left: whether the other polygon has to turn about its left end.
        chain_right: the same for its right end.

    Returns (first of the part, first that does not matter after it, the same two of the other).
    """
    i, last_i, j, last_j = 0, len(own), 0, len(others)
    (dx, dy, _, _, _), (edx, edy, _, _, _) = own[0], others[0]
    turn = edx * dy - edy * dx
    if turn > 0 and not turns_left:  # (2)
        j = 1
        while j < last_j and others[j][1] * dx < others[j][0] * dy:
            j += 1
    elif turn < 0 and not chain_left:  # (4)
        i = 1
        while i < last_i and own[i][1] * edx < own[i][0] * edy:
            i += 1
    (dx, dy, _, _, _), (edx, edy, _, _, _) = own[-1], others[-1]
    turn = edx * dy - edy * dx
    if turn < 0 and not turns_right:  # (3)
        last_j -= 1
        while j < last_j and others[last_j - 1][1] * dx > others[last_j - 1][0] * dy:
            last_j -= 1
    elif turn > 0 and not chain_right:  # (4)
        last_i -= 1
        while i < last_i and own[last_i - 1][1] * edx > own[last_i - 1][0] * edy:
            last_i -= 1
    return i, last_i, j, last_j


def count_flatter(points: Sequence[Vertex], dx: Rational, dy: Rational) -> int:
    """How many edges of a convex chain are flatter than the slope dy / dx. Cost: O(log n)."""
    low, high = 0, len(points) - 1
    while low < high:
        middle = (low + high) // 2
        (ax, ay), (bx, by) = points[middle], points[middle + 1]
        if (by - ay) * dx < (bx - ax) * dy:
            low = middle + 1
        else:
            high = middle
    return low


def take_whole(chain: Sequence[Vertex]) -> ConvexPart:
    """A strictly convex chain as the only part. Cost: O(n)."""
    return ConvexPart(chain, (chain[0][0], 1), (chain[-1][0], 1), True, True, take_edges(chain))


def split_chain(chain: Sequence[Vertex]) -> list[ConvexPart]:
    """Step 1: the convex parts of a bottom chain, from left to right.

    Raises ChainError when it is not X-monotone. Cost: O(m).
    """
    parts = find_convex_parts(chain)
    # Not zero at a wall, of which the lower end has to be turned about.
    rises = [after[0][1] - before[-1][1] for before, after in pairwise(parts)]
    return [
        ConvexPart(part, (part[0][0], 1), (part[-1][0], 1), before < 0, after > 0, take_edges(part))
        for part, before, after in zip(parts, [-1, *rises], [*rises, 1], strict=True)
    ]


def split_envelope(envelope: Envelope) -> Iterator[CrossingPart]:
    """Step 1: the convex parts of an envelope without gaps, from left to right. Cost: O(m)."""
    breaks, pieces = envelope.breaks, envelope.pieces
    first, turns_left = 0, True
    adx, ady, ac, _, _ = pieces[0]
    for k in range(1, len(pieces)):
        bdx, bdy, bc, _, _ = pieces[k]
        n, d = breaks[k]
        u = ady * bdx - bdy * adx
        above = u * n + (ac * bdx - bc * adx) * d
        if above != 0 or u >= 0:
            yield CrossingPart(pieces[first:k], breaks[first : k + 1], turns_left, above < 0)
            first, turns_left = k, above > 0
        adx, ady, ac = bdx, bdy, bc
    yield CrossingPart(pieces[first:], breaks[first:], turns_left, True)


def split_parts(directrix: Sequence[Vertex] | Envelope) -> list[ConvexPart]:
    """Step 1: the convex parts of a bottom chain, or of an envelope of edges on the lattice.

    A crossing in a lower envelope is concave, so that it ends a part: with the edges that it cuts
    made whole, the parts are on the lattice.

    Raises ChainError when a chain is not X-monotone. Cost: O(m).

    Example:
        >>> from exactsweep.procedures.lower_envelope import lower_envelope_cm
        >>> e = Envelope.of([(0, 0), (3, 1)])
        >>> print(lower_envelope_cm(e, Envelope.of([(1, 2), (4, -1)])))
        (0, 0) (9/4, 3/4) (4, -1)
        >>> [part.points for part in split_parts(e)]
        [[(0, 0), (3, 1)], [(1, 2), (4, -1)]]
    """
    if not isinstance(directrix, Envelope):
        return split_chain(directrix)
    parts = []
    for edges, breaks, turns_left, turns_right in split_envelope(directrix):
        points = [cast(Vertex, start) for _, _, _, start, _ in edges]
        (x, y), (dx, dy, _, _, _) = points[-1], edges[-1]
        points.append((x + dx, y + dy))
        parts.append(ConvexPart(points, breaks[0], breaks[-1], turns_left, turns_right, edges))
    return parts
