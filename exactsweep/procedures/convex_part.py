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
         part before. So these edges of c are above the envelope but for single points, and need
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
from itertools import islice, pairwise
from math import inf
from operator import itemgetter
from typing import NamedTuple, cast

from exactsweep.geometry.point import Edge, Rational, Vertex
from exactsweep.procedures.cc import merge_by_slope
from exactsweep.procedures.chain import convex_parts
from exactsweep.procedures.envelope import (
    Break,
    Envelope,
    Line,
    bound_slope,
    cross,
    difference,
    line_of,
    lower_bound,
)


class Box(NamedTuple):
    """Bounds of a convex part: of its x-range, its least y, and the slopes in which it matters.

    x and y are rounded outwards to ints. Slopes are ints as `bound_slope` gives them, or infinite
    where the other polygon turns about an end of the part.
    """

    left: Rational
    right: Rational
    low: Rational
    flattest: Rational | float
    steepest: Rational | float


class ConvexPart(NamedTuple):
    """A convex part with its vertices on the lattice.

    Attributes:
        points: its vertices, the end edges whole.
        left: the break on the first edge from which on it holds.
        right: the same on the last edge.
        turns_left: whether the other polygon has to turn about the left end, (5).
        turns_right: the same for the right end.
    """

    points: Sequence[Vertex]
    left: Break
    right: Break
    turns_left: bool
    turns_right: bool

    @property
    def box(self) -> Box:
        """Its box."""
        points, (left, left_d), (right, right_d), turns_left, turns_right = self
        return Box(
            left // left_d,
            -(-right // right_d),
            min(points, key=itemgetter(1))[1],
            -inf if turns_left else bound_slope(line_of((points[0], points[1]))),
            inf if turns_right else bound_slope(line_of((points[-2], points[-1]))),
        )

    def sweep(self, chain: ConvexPart, source: int) -> Envelope:
        """The CC sweep of a part of reversed G_t along this part, as far as it matters.

        Args:
            chain: the part of G_t, not cut.
            source: the number of what is swept.

        Returns an envelope, which has no edges if nothing matters. Cost: O(m_i + n_t).
        """
        points, left, right, turns_left, turns_right = self
        others, _, _, others_turn_left, others_turn_right = chain
        merged = merge_by_slope(
            others,
            points,
            (not others_turn_left, not others_turn_right),
            (not turns_left, not turns_right),
        )
        piece = Envelope.of_convex(merged, source)
        if len(merged) == 1:
            return piece
        # Whole, an end edge goes beyond the break; it may have been left out for its slope, (4).
        if not turns_left and (
            others_turn_left or cross(points[0], points[1], (others[0], others[1])) >= 0
        ):
            piece.breaks[0] = left[0] + (merged[0][0] - points[0][0]) * left[1], left[1]
        if not turns_right and (
            others_turn_right or cross(points[-2], points[-1], (others[-2], others[-1])) <= 0
        ):
            piece.breaks[-1] = right[0] + (merged[-1][0] - points[-1][0]) * right[1], right[1]
        return piece


class CrossingPart(NamedTuple):
    """A convex part whose vertices are crossings: edges by their lines.

    Attributes:
        lines: of the edges.
        breaks: edge k holds from break k to break k + 1.
        turns_left: whether the other polygon has to turn about the left end, (5).
        turns_right: the same for the right end.
    """

    lines: Sequence[Line]
    breaks: Sequence[Break]
    turns_left: bool
    turns_right: bool

    @property
    def box(self) -> Box:
        """Its box. A convex part is lowest at an end or at a vertex, all of which are breaks."""
        lines, breaks, turns_left, turns_right = self
        (left, left_d), (right, right_d) = breaks[0], breaks[-1]
        return Box(
            left // left_d,
            -(-right // right_d),
            min(lower_bound(lines[0], breaks[0]), *map(lower_bound, lines, breaks[1:])),
            -inf if turns_left else bound_slope(lines[0]),
            inf if turns_right else bound_slope(lines[-1]),
        )

    def sweep(self, chain: ConvexPart, source: int) -> Envelope:
        """The CC sweep of a part of reversed G_t along this part, as far as it matters.

        An edge is moved by a vertex of G; an edge of G by a crossing (x/w, y/w), which makes its
        line integer again when it is multiplied by w.

        Arguments, result and cost as for `ConvexPart.sweep`.
        """
        own, breaks, turns_left, turns_right = self
        points = chain.points
        steps = list(map(line_of, pairwise(points)))
        first, last, at, end = 0, len(own), 0, len(steps)
        if not turns_left:  # (2)
            dx, dy, _ = own[0]
            while at < end and steps[at][1] * dx < steps[at][0] * dy:
                at += 1
        if not turns_right:  # (3)
            dx, dy, _ = own[-1]
            while at < end and steps[end - 1][1] * dx > steps[end - 1][0] * dy:
                end -= 1
        if not chain.turns_left:  # (4)
            dx, dy, _ = steps[0]
            while first < last and own[first][1] * dx < own[first][0] * dy:
                first += 1
        if not chain.turns_right:  # (4)
            dx, dy, _ = steps[-1]
            while first < last and own[last - 1][1] * dx > own[last - 1][0] * dy:
                last -= 1
        n, d = breaks[first]
        lines: list[Line | None] = []
        found: list[Break] = [(n + points[at][0] * d, d)]
        for k in range(first, last + 1):
            # About vertex k, G turns up to the slope of edge k, in the end up to its own last edge.
            dx, dy, c = own[k] if k < len(own) else own[-1]
            start = at
            while at < end and (k == last or steps[at][1] * dx < steps[at][0] * dy):
                at += 1
            if at > start:
                n, d = breaks[k]
                x, y, w = n * dx, dy * n + c * d, dx * d
                for (ex, ey, ec), (px, _) in zip(
                    steps[start:at], points[start + 1 : at + 1], strict=True
                ):
                    lines.append((ex * w, ey * w, ec * w + y * ex - x * ey))
                    found.append((n + px * d, d))
            if k < last:
                px, py = points[at]
                if at < end and steps[at][1] * dx == steps[at][0] * dy:
                    at += 1
                lines.append((dx, dy, c + py * dx - px * dy))
                n, d = breaks[k + 1]
                found.append((n + points[at][0] * d, d))
        return Envelope(found, [None] * len(lines), [source] * len(lines), lines)


def count_flatter(points: Sequence[Vertex], edge: Edge) -> int:
    """How many edges of a convex chain are flatter than an edge. Cost: O(log n)."""
    (px, py), (qx, qy) = edge
    dx, dy = qx - px, qy - py
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
    """A strictly convex chain as the only part. Cost: O(1)."""
    return ConvexPart(chain, (chain[0][0], 1), (chain[-1][0], 1), True, True)


def split_chain(chain: Sequence[Vertex]) -> list[ConvexPart]:
    """Step 1: the convex parts of a bottom chain, from left to right.

    Raises ChainError when it is not X-monotone. Cost: O(m).
    """
    chains = convex_parts(chain)
    # Not zero at a wall, of which the lower end has to be turned about.
    rises = [after[0][1] - before[-1][1] for before, after in pairwise(chains)]
    return [
        ConvexPart(part, (part[0][0], 1), (part[-1][0], 1), before < 0, after > 0)
        for part, before, after in zip(chains, [-1, *rises], [*rises, 1], strict=True)
    ]


def split_envelope(envelope: Envelope) -> Iterator[CrossingPart]:
    """Step 1: the convex parts of an envelope without gaps, from left to right. Cost: O(m)."""
    breaks, lines = envelope.breaks, cast(list[Line], envelope.lines())
    start, turns_left = 0, True
    for k in range(1, len(lines)):
        n, d = breaks[k]
        u, v = difference(lines[k - 1], lines[k])
        above = u * n + v * d
        if above != 0 or u >= 0:
            yield CrossingPart(lines[start:k], breaks[start : k + 1], turns_left, above < 0)
            start, turns_left = k, above > 0
    yield CrossingPart(lines[start:], breaks[start:], turns_left, True)


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
    edges, parts = iter(cast(list[Edge], directrix.edges)), []
    for _, breaks, turns_left, turns_right in split_envelope(directrix):
        whole = list(islice(edges, len(breaks) - 1))
        points = [whole[0][0], *[q for _, q in whole]]
        parts.append(ConvexPart(points, breaks[0], breaks[-1], turns_left, turns_right))
    return parts
