"""Convex parts, and what of their sub-trajectories matters (Sections 4 and 5, step 1).

A convex part is a maximal run of edges that become steeper: of D_b, of reversed G_t, or of a
trajectory that is the directrix of the next sweep. Each edge is known by its line, and holds from
one break to the next. Where all vertices are on the lattice they are kept too, the two end edges
whole even if the breaks cut them: what that adds is above the part, on the chain it was cut from.

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

from collections.abc import Sequence
from itertools import pairwise
from math import inf
from typing import NamedTuple, cast

from exactsweep.geometry.point import Edge, Rational, Vertex
from exactsweep.procedures.cc import merge_by_slope
from exactsweep.procedures.chain import convex_parts
from exactsweep.procedures.envelope import (
    Break,
    Envelope,
    Line,
    bound_slope,
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
    """A convex part: edges that become steeper, and the breaks between which they hold.

    Attributes:
        points: its vertices, the end edges whole; empty where they are not on the lattice.
        lines: those of the edges.
        breaks: edge k holds from break k to break k + 1.
        turns_left: whether the other polygon has to turn about the left end, (5).
        turns_right: the same for the right end.
    """

    points: Sequence[Vertex]
    lines: Sequence[Line]
    breaks: Sequence[Break]
    turns_left: bool
    turns_right: bool

    @classmethod
    def of(
        cls, chain: Sequence[Vertex], turns_left: bool = True, turns_right: bool = True
    ) -> ConvexPart:
        """A strictly convex chain as a part, not cut. Cost: O(n)."""
        lines, breaks = list(map(line_of, pairwise(chain))), [(x, 1) for x, _ in chain]
        return cls(chain, lines, breaks, turns_left, turns_right)

    @property
    def box(self) -> Box:
        """Its box. A convex part is lowest at an end or at a vertex, all of which are breaks."""
        _, lines, breaks, turns_left, turns_right = self
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

        Args:
            chain: the part of G_t, on the lattice, its edges whole.
            source: the number of what is swept.

        Returns an envelope, which has no edges if nothing matters. Cost: O(m_i + n_t).
        """
        points, lines, breaks, turns_left, turns_right = self
        steps = chain.lines
        first, last, at, end = 0, len(lines), 0, len(steps)
        (cx, cy, _), (dx, dy, _) = steps[0], lines[0]
        order = cy * dx - cx * dy
        if order < 0 and not turns_left:  # (2)
            at = count_flatter(steps, lines[0])
        elif order > 0 and not chain.turns_left:  # (4)
            first = count_flatter(lines, steps[0])
        (cx, cy, _), (dx, dy, _) = steps[-1], lines[-1]
        order = cy * dx - cx * dy
        if order > 0 and not turns_right:  # (3)
            end = count_up_to(steps, lines[-1])
        elif order < 0 and not chain.turns_right:  # (4)
            last = count_up_to(lines, steps[-1])
        if not points:
            return self._sweep_lines(chain, source, range(first, last), range(at, end))
        others = chain.points
        piece = Envelope.of_convex(
            merge_by_slope(others[at : end + 1], points[first : last + 1]), source
        )
        # Whole, an end edge goes beyond the break.
        if piece.edges:
            if first == 0 and not turns_left:
                n, d = breaks[0]
                piece.breaks[0] = n + others[at][0] * d, d
            if last == len(lines) and not turns_right:
                n, d = breaks[-1]
                piece.breaks[-1] = n + others[end][0] * d, d
        return piece

    def _sweep_lines(self, chain: ConvexPart, source: int, own: range, others: range) -> Envelope:
        """The same off the lattice, where only lines are known, for the edges that matter."""
        points, steps, breaks = chain.points, chain.lines, self.breaks
        at, end = others.start, others.stop
        n, d = breaks[own.start]
        lines: list[Line | None] = []
        found: list[Break] = [(n + points[at][0] * d, d)]

        def turn(k: int, line: Line, stop: int) -> None:
            """Append the edges of G from `at` on while it turns about the point at a break."""
            n, d = breaks[k]
            dx, dy, c = line
            # The point is (x / w, y / w).
            x, y, w = n * dx, dy * n + c * d, dx * d
            for m in range(at, stop):
                ex, ey, ec = steps[m]
                lines.append((ex * w, ey * w, ec * w + y * ex - x * ey))
                found.append((n + points[m + 1][0] * d, d))

        for k in own:
            dx, dy, c = line = self.lines[k]
            stop = at
            while stop < end and steps[stop][1] * dx < steps[stop][0] * dy:
                stop += 1
            if stop > at:
                turn(k, line, stop)
                at = stop
            x, y = points[at]
            if at < end and steps[at][1] * dx == steps[at][0] * dy:
                at += 1
            lines.append((dx, dy, c + y * dx - x * dy))
            n, d = breaks[k + 1]
            found.append((n + points[at][0] * d, d))
        if at < end:
            turn(own.stop, self.lines[min(own.stop, len(self.lines) - 1)], end)
        return Envelope(found, [None] * len(lines), [source] * len(lines), lines)


def count_flatter(lines: Sequence[Line], line: Line) -> int:
    """How many lines, ascending by slope, are flatter than another. Cost: O(log n)."""
    dx, dy, _ = line
    low, high = 0, len(lines)
    while low < high:
        middle = (low + high) // 2
        ex, ey, _ = lines[middle]
        if ey * dx < ex * dy:
            low = middle + 1
        else:
            high = middle
    return low


def count_up_to(lines: Sequence[Line], line: Line) -> int:
    """How many lines, ascending by slope, are not steeper than another. Cost: O(log n)."""
    k = count_flatter(lines, line)
    # No two are parallel.
    return k + (k < len(lines) and lines[k][1] * line[0] == lines[k][0] * line[1])


def split_parts(directrix: Sequence[Vertex] | Envelope) -> list[ConvexPart]:
    """Step 1: the convex parts of a bottom chain or of an envelope, from left to right.

    Args:
        directrix: points from left to right, vertical edges allowed; or an envelope without gaps.
            If its edges are on the lattice, so are the parts: a crossing in a lower envelope is
            concave, so that it ends a part, and an edge that a crossing cuts is made whole.

    Raises ChainError when the chain is not X-monotone. Cost: O(m).

    Example:
        >>> from exactsweep.procedures.lower_envelope import lower_envelope_cm
        >>> e = Envelope.of([(0, 0), (3, 1)])
        >>> print(lower_envelope_cm(e, Envelope.of([(1, 2), (4, -1)])))
        (0, 0) (9/4, 3/4) (4, -1)
        >>> [part.points for part in split_parts(e)]
        [[(0, 0), (3, 1)], [(1, 2), (4, -1)]]
    """
    if not isinstance(directrix, Envelope):
        chains = convex_parts(directrix)
        # Not zero at a wall, of which the lower end has to be turned about.
        rises = [after[0][1] - before[-1][1] for before, after in pairwise(chains)]
        return [
            ConvexPart.of(chain, before < 0, after > 0)
            for chain, before, after in zip(chains, [-1, *rises], [*rises, 1], strict=True)
        ]
    breaks, edges, lines = directrix.breaks, directrix.edges, cast(list[Line], directrix.lines())
    parts: list[ConvexPart] = []
    start, turns_left = 0, True
    for k in range(1, len(lines) + 1):
        turns_right = turns_next = True
        if k < len(lines):
            n, d = breaks[k]
            u, v = difference(lines[k - 1], lines[k])
            above = u * n + v * d
            if above == 0 and u < 0:
                continue
            turns_right, turns_next = above < 0, above > 0
        points: list[Vertex] = []
        if edges[start] is not None:
            whole = cast(list[Edge], edges[start:k])
            points = [whole[0][0], *[q for _, q in whole]]
        parts.append(
            ConvexPart(points, lines[start:k], breaks[start : k + 1], turns_left, turns_right)
        )
        start, turns_left = k, turns_next
    return parts
