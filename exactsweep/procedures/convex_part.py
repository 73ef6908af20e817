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

So what matters of a pair is the edges with slopes between the ends of both parts, which in an MM
sweep of real outlines is nothing for most pairs. Slopes are ints (see `split_by_slope`), so that
edges are found and merged without products.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from math import inf
from typing import NamedTuple, cast

from exactsweep.numbers.number import divide_exactly
from exactsweep.numbers.point import Rational, Vertex
from exactsweep.procedures.chain import KeptChain, measure_width, require_convex, split_by_slope
from exactsweep.procedures.envelope import Break, Envelope, Piece

Box = tuple[Rational, Rational, Rational]
"""Bounds of a convex part: (left, right, low), of its x-range and its least y, rounded to ints."""

Slope = Rational | float
"""Of an edge, as `split_by_slope` has it, or infinite."""


class ConvexPart(NamedTuple):
    """A convex part with its vertices on the lattice.

    Attributes:
        points: its vertices, the end edges whole.
        left: the break on the first edge from which on it holds; None if that is its start.
        right: the same on the last edge.
        flattest: the slope from which on it matters: of its first edge, or infinite where the other
            polygon has to turn about the left end, (5).
        steepest: the same for the right end.
        slopes: of its edges, ascending.
        edges: each as a vector.
    """

    points: Sequence[Vertex]
    left: Break | None
    right: Break | None
    flattest: Slope
    steepest: Slope
    slopes: Sequence[Rational]
    edges: list[Vertex]

    @property
    def box(self) -> Box:
        """Its box."""
        return (*self.x_range, self.points[bisect_left(self.slopes, 0)][1])

    @property
    def x_range(self) -> tuple[Rational, Rational]:
        """Its x-range, rounded outwards to ints."""
        points = self.points
        return round_outwards(self.left or (points[0][0], 1), self.right or (points[-1][0], 1))

    def sweep(self, chain: ConvexPart, source: int) -> Envelope | None:
        """The CC sweep of a part of reversed G_t along this part, as far as it matters.

        Args:
            chain: the part of G_t, not cut.
            source: the number of what is swept.

        Returns an envelope; None if nothing matters. Cost: O(m_i + n_t).
        """
        points, left, right, flattest, steepest, slopes, edges = self
        origins, _, _, chain_flattest, chain_steepest, chain_slopes, others = chain
        i, last_i, j, last_j = _find_what_matters(
            slopes, flattest, steepest, chain_slopes, chain_flattest, chain_steepest
        )
        if i >= last_i and j >= last_j:
            return None
        (x, y), (ox, oy) = points[i], origins[j]
        x += ox
        y += oy
        # Whole, an end edge goes beyond the break; it may have been left out for its slope, (4).
        breaks: list[Break] = [(x, 1)]
        if left is not None and i == 0 < last_i:
            n, d = left
            breaks = [(n + ox * d, d)]
        if right is not None and not i < last_i == len(edges):
            right = None
        pieces: list[Piece] = []
        while True:  # (1)
            if i < last_i:
                dx, dy = edges[i]
                turn = slopes[i] - chain_slopes[j] if j < last_j else -1
                if turn < 0:
                    i += 1
                elif turn > 0:
                    dx, dy = others[j]
                    j += 1
                else:
                    along, rise = others[j]
                    dx += along
                    dy += rise
                    i += 1
                    j += 1
            elif j < last_j:
                dx, dy = others[j]
                j += 1
            else:
                break
            pieces.append((dx, dy, y * dx - x * dy, (x, y), source))
            x += dx
            y += dy
            breaks.append((x, 1))
        if right is not None:
            n, d = right
            breaks[-1] = n + (x - points[-1][0]) * d, d
        return Envelope(breaks, pieces)


class CrossingPart(NamedTuple):
    """A convex part whose vertices are crossings: edges by their lines.

    Attributes:
        edges: its edges as pieces.
        breaks: edge k holds from break k to break k + 1.
        flattest: as of a `ConvexPart`.
        steepest: the same.
        slopes: of its edges, ascending.
    """

    edges: Sequence[Piece]
    breaks: Sequence[Break]
    flattest: Slope
    steepest: Slope
    slopes: Sequence[Rational]

    @property
    def box(self) -> Box:
        """Its box. A convex part is lowest at an end or at a vertex, all of which are breaks."""
        k = bisect_left(self.slopes, 0)
        dx, dy, c, _, _ = self.edges[k and k - 1]
        n, d = self.breaks[k]
        return (*self.x_range, (dy * n + c * d) // (dx * d))

    @property
    def x_range(self) -> tuple[Rational, Rational]:
        """Its x-range, rounded outwards to ints."""
        return round_outwards(self.breaks[0], self.breaks[-1])

    def sweep(self, chain: ConvexPart, source: int) -> Envelope | None:
        """The CC sweep of a part of reversed G_t along this part, as far as it matters.

        An edge is moved by a vertex of G; an edge of G by a crossing (x/w, y/w), which makes its
        line integer again when it is multiplied by w.

        Arguments, result and cost as for `ConvexPart.sweep`.
        """
        own, breaks, flattest, steepest, slopes = self
        points, _, _, chain_flattest, chain_steepest, chain_slopes, others = chain
        first, last, at, end = _find_what_matters(
            slopes, flattest, steepest, chain_slopes, chain_flattest, chain_steepest
        )
        if first >= last and at >= end:
            return None
        n, d = breaks[first]
        pieces: list[Piece] = []
        found: list[Break] = [(n + points[at][0] * d, d)]
        for k in range(first, last + 1):
            # About vertex k, G turns up to the slope of edge k, in the end up to its own last edge.
            slope: Slope = slopes[k] if k < last else inf
            if at < end and chain_slopes[at] < slope:
                n, d = breaks[k]
                dx, dy, c, _, _ = own[k] if k < len(own) else own[-1]
                x, y, w = n * dx, dy * n + c * d, dx * d
                while at < end and chain_slopes[at] < slope:
                    (ex, ey), (px, py) = others[at], points[at]
                    c = (py * w + y) * ex - (px * w + x) * ey
                    pieces.append((ex * w, ey * w, c, None, source))
                    found.append((n + (px + ex) * d, d))
                    at += 1
            if k < last:
                dx, dy, c, _, _ = own[k]
                px, py = points[at]
                if at < end and chain_slopes[at] == slope:
                    at += 1
                pieces.append((dx, dy, c + py * dx - px * dy, None, source))
                n, d = breaks[k + 1]
                found.append((n + points[at][0] * d, d))
        return Envelope(found, pieces)


def round_outwards(start: Break, end: Break) -> tuple[Rational, Rational]:
    """The least x-range between ints that holds two breaks. Cost: O(1)."""
    (n, d), (m, e) = start, end
    return n // d, -(-m // e)


def _find_what_matters(
    slopes: Sequence[Rational],
    flattest: Slope,
    steepest: Slope,
    chain_slopes: Sequence[Rational],
    chain_flattest: Slope,
    chain_steepest: Slope,
) -> tuple[int, int, int, int]:
    """Find the edges of a part and of a part of reversed G_t that matter, by their attributes.

    Returns (first of the part, first that does not matter after it, the same two of the other).
    """
    i, last_i, j, last_j = 0, len(slopes), 0, len(chain_slopes)
    if flattest > chain_flattest:  # (2)
        j = bisect_left(chain_slopes, flattest)
    elif flattest < chain_flattest:  # (4)
        i = bisect_left(slopes, chain_flattest)
    if steepest < chain_steepest:  # (3)
        last_j = bisect_right(chain_slopes, steepest)
    elif steepest > chain_steepest:  # (4)
        last_i = bisect_right(slopes, chain_steepest)
    return i, last_i, j, last_j


def count_flatter(points: Sequence[Vertex], dx: Rational, dy: Rational) -> int:
    """Count the edges of a convex chain flatter than the slope dy / dx. Cost: O(log n)."""
    low, high = 0, len(points) - 1
    while low < high:
        middle = (low + high) // 2
        (ax, ay), (bx, by) = points[middle], points[middle + 1]
        if (by - ay) * dx < (bx - ax) * dy:
            low = middle + 1
        else:
            high = middle
    return low


def measure_unit(*directrices: Sequence[Vertex] | Envelope) -> int | None:
    """The unit in which the slopes of chains or envelopes are ints, for `split_parts`.

    A power of two, so that it is mostly the same for a chain with whatever it is swept with.

    None if there are others than ints. Cost: O(n).
    """
    widest = 0
    for chain in directrices:
        width = chain.widest if isinstance(chain, Envelope) else measure_width(chain)
        if width is None:
            return None
        widest = max(widest, int(width))
    return 1 << 2 * widest.bit_length()


def take_whole(chain: Sequence[Vertex], unit: Rational | None) -> ConvexPart:
    """A convex chain as the only part. Raises ChainError when it is not convex. Cost: O(n)."""
    part, *others = split_chain(chain, unit)
    if others:
        require_convex(chain)
    return part


def split_chain(chain: Sequence[Vertex], unit: Rational | None) -> list[ConvexPart]:
    """Step 1: the convex parts of a bottom chain, from left to right.

    Raises ChainError when it is not X-monotone. Cost: O(m).
    """
    kept = chain if type(chain) is KeptChain else None
    # Looked up once: another thread may sweep the polygon with another unit meanwhile.
    before = None if kept is None else kept.parts
    if before is not None and before[0] == unit:
        return before[1]
    found = split_by_slope(chain, unit)
    parts: list[ConvexPart] = []
    # What joins two parts is a vertex, or a wall, of which the lower end has to be turned about.
    falls = True
    for k, (points, slopes, edges) in enumerate(found, 1):
        flattest: Slope = -inf if falls else slopes[0]
        rises = k == len(found)
        if not rises:
            end, start = points[-1][1], found[k][0][0][1]
            rises, falls = start > end, start < end
        steepest: Slope = inf if rises else slopes[-1]
        parts.append(ConvexPart(points, None, None, flattest, steepest, slopes, edges))
    if kept is not None:
        kept.parts = unit, parts
    return parts


def split_envelope(envelope: Envelope, unit: Rational | None) -> Iterator[CrossingPart]:
    """Step 1: the convex parts of an envelope without gaps, from left to right. Cost: O(m)."""
    breaks, pieces = envelope.breaks, envelope.pieces
    slopes: list[Rational] = [
        divide_exactly(dy, dx) if unit is None else dy * unit // dx for dx, dy, _, _, _ in pieces
    ]
    first, flattest = 0, cast(Slope, -inf)
    adx, ady, ac, _, _ = pieces[0]
    for k in range(1, len(pieces)):
        bdx, bdy, bc, _, _ = pieces[k]
        n, d = breaks[k]
        u = ady * bdx - bdy * adx
        above = u * n + (ac * bdx - bc * adx) * d
        if above != 0 or u >= 0:
            steepest = inf if above < 0 else slopes[k - 1]
            own = slopes[first:k]
            yield CrossingPart(pieces[first:k], breaks[first : k + 1], flattest, steepest, own)
            first, flattest = k, -inf if above > 0 else slopes[k]
        adx, ady, ac = bdx, bdy, bc
    yield CrossingPart(pieces[first:], breaks[first:], flattest, inf, slopes[first:])


def split_parts(directrix: Sequence[Vertex] | Envelope, unit: Rational | None) -> list[ConvexPart]:
    """Step 1: the convex parts of a bottom chain, or of an envelope of edges on the lattice.

    A crossing in a lower envelope is concave, so that it ends a part: with the edges that it cuts
    made whole, the parts are on the lattice.

    Raises ChainError when a chain is not X-monotone. Cost: O(m).

    Example:
        >>> from exactsweep.procedures.lower_envelope import lower_envelope_cm
        >>> e = Envelope.of([(0, 0), (3, 1)])
        >>> print(lower_envelope_cm(e, Envelope.of([(1, 2), (4, -1)])))
        (0, 0) (9/4, 3/4) (4, -1)
        >>> [part.points for part in split_parts(e, measure_unit(e))]
        [[(0, 0), (3, 1)], [(1, 2), (4, -1)]]
    """
    if not isinstance(directrix, Envelope):
        return split_chain(directrix, unit)
    parts = []
    for pieces, breaks, flattest, steepest, slopes in split_envelope(directrix, unit):
        points = [cast(Vertex, start) for _, _, _, start, _ in pieces]
        (x, y), (dx, dy, _, _, _) = points[-1], pieces[-1]
        points.append((x + dx, y + dy))
        edges = [(dx, dy) for dx, dy, _, _, _ in pieces]
        parts.append(ConvexPart(points, breaks[0], breaks[-1], flattest, steepest, slopes, edges))
    return parts
