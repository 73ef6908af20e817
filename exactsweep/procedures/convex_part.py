"""Convex parts and the relevant edges of their sub-trajectories (Sections 4 and 5, step 1).

A convex part is a maximal run of edges of increasing slope: of D_b, of reversed G_t, or of a
trajectory that is the directrix of the next sweep. A part of a chain is stored by its vertices. A
part of a trajectory is stored by the lines of its edges and the breaks between which each holds,
because its vertices may be crossings.

Let c be a part of reversed G_t and p = D_i a part of D_b. The relevant edges of their sum
T(G_t, D_i) are the edges that can lie on the envelope.

    (1)  T(G_t, D_i) has the edges of c and of p in order of slope (Lemma 3.1).
    (2)  Let the part before p be at least as low as p at their common end. If G stood on that end
         with an edge flatter than p's first edge, G would overlap the part before. So these edges
         of c are above the envelope except for single points, and need not be made.
    (3)  The same holds for p's last edge and the steeper edges of c.
    (4)  A sum is symmetric in its two chains, so (2) and (3) hold with c and p exchanged.
    (5)  All slopes are relevant at an end of p that is lower than its neighbour's end, and at the
         ends of D_b.

So the relevant edges of a pair are those with slopes between the ends of both parts. In an MM sweep
of real outlines most pairs have none. Slopes are ints (see `split_by_slope`), so that edges are
found and merged without products.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from math import inf
from typing import NamedTuple, cast

from exactsweep.numbers.number import Rational, Vertex, divide_exactly
from exactsweep.procedures.chain import KeptChain, measure_width, require_convex, split_by_slope
from exactsweep.procedures.envelope import Break, Envelope, Piece, Span

Box = tuple[Rational, Rational, Rational]
"""Bounds of a convex part, rounded outwards to ints: (left, right, low), where low bounds y."""

Slope = Rational | float
"""The slope of an edge in the unit of `split_by_slope`, or an infinity."""


class ConvexPart(NamedTuple):
    """A convex part of a chain.

    Attributes:
        points: the vertices.
        edges: the edges as vectors.
        flattest: the least relevant slope: that of the first edge, or minus infinity where the
            other polygon has to turn about the left end, (5).
        steepest: the greatest relevant slope, likewise for the right end.
        slopes: the slopes of the edges, ascending.
    """

    points: Sequence[Vertex]
    edges: list[Vertex]
    flattest: Slope
    steepest: Slope
    slopes: Sequence[Rational]

    @property
    def box(self) -> Box:
        """The bounds of the part."""
        points = self.points
        low = points[bisect_left(self.slopes, 0)][1]
        return (*round_outwards((points[0][0], 1), (points[-1][0], 1)), low)

    def sweep(self, chain: ConvexPart, source: int) -> Envelope | None:
        """The CC sweep of a part of reversed G_t along this part, as far as it matters.

        Args:
            chain: the part of G_t.
            source: the number of what is swept.

        Returns an envelope; None if nothing matters. Cost: O(m_i + n_t).
        """
        points, edges, _, _, slopes = self
        origins, others, _, _, chain_slopes = chain
        i, last_i, j, last_j = _find_relevant(self, chain)
        if i >= last_i and j >= last_j:
            return None
        (x, y), (ox, oy) = points[i], origins[j]
        x += ox
        y += oy
        breaks: list[Break] = [(x, 1)]
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
                return Envelope(breaks, pieces)
            pieces.append((dx, dy, y * dx - x * dy, (x, y), source))
            x += dx
            y += dy
            breaks.append((x, 1))


class CrossingPart(NamedTuple):
    """A convex part of an envelope, whose vertices may be crossings.

    Attributes:
        edges: the edges as pieces.
        breaks: edge k holds from break k to break k + 1.
        flattest: the least relevant slope, as for `ConvexPart`.
        steepest: the greatest relevant slope, likewise.
        slopes: the slopes of the edges, ascending.
    """

    edges: Sequence[Piece]
    breaks: Sequence[Break]
    flattest: Slope
    steepest: Slope
    slopes: Sequence[Rational]

    @property
    def box(self) -> Box:
        """The bounds of the part. Its lowest point is an end or a vertex, and so at a break."""
        k = bisect_left(self.slopes, 0)
        dx, dy, c, _, _ = self.edges[k and k - 1]
        n, d = self.breaks[k]
        low = (dy * n + c * d) // (dx * d)
        return (*round_outwards(self.breaks[0], self.breaks[-1]), low)

    def sweep(self, chain: ConvexPart, source: int) -> Envelope | None:
        """The CC sweep of a part of reversed G_t along this part, as far as it matters.

        A vertex of G moves an edge of the part. A vertex (x/w, y/w) of the part moves an edge of G,
        whose line is integer again after a multiplication by w.

        Arguments, result and cost are those of `ConvexPart.sweep`.
        """
        own, breaks, _, _, slopes = self
        points, others, _, _, chain_slopes = chain
        first, last, at, end = _find_relevant(self, chain)
        if first >= last and at >= end:
            return None
        n, d = breaks[first]
        pieces: list[Piece] = []
        found: list[Break] = [(n + points[at][0] * d, d)]
        for k in range(first, last + 1):
            # At vertex k, add the edges of G up to the slope of edge k; at the last one, all the
            # rest.
            slope: Slope = slopes[k] if k < last else inf
            if at < end and chain_slopes[at] < slope:
                n, d = breaks[k]
                dx, dy, c, start, _ = own[k] if k < len(own) else own[-1]
                x, y, w = n * dx, dy * n + c * d, dx * d
                if start is not None and n == start[0] * d:
                    (x, y), w = start, 1
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


Parts = Sequence[ConvexPart | CrossingPart]


def round_outwards(start: Break, end: Break) -> tuple[Rational, Rational]:
    """Return the least x-range between ints that contains two breaks. Cost: O(1)."""
    (n, d), (m, e) = start, end
    return n // d, -(-m // e)


def _find_relevant(part: ConvexPart | CrossingPart, chain: ConvexPart) -> tuple[int, int, int, int]:
    """Find the relevant edges of a part and of a part of reversed G_t.

    Returns (start, end) of the edges of the part, then (start, end) for the other one; ends are
    excluded.
    """
    _, _, flattest, steepest, slopes = part
    _, _, chain_flattest, chain_steepest, chain_slopes = chain
    return (
        bisect_left(slopes, chain_flattest),  # (4)
        bisect_right(slopes, chain_steepest),
        bisect_left(chain_slopes, flattest),  # (2)
        bisect_right(chain_slopes, steepest),  # (3)
    )


def find_touched(
    points: Sequence[Vertex], trajectory: Envelope, k: int, first: int = 0
) -> tuple[int, Span]:
    """Find the points of D_b that G touches along a piece of the trajectory (Table 1).

    In order of slope, the piece follows all flatter edges of its part of D_b and of reversed G_t.
    The contact is VE or EE if the part has an edge of that slope, and EV otherwise.

    Args:
        points: the vertices of the part of D_b.
        trajectory: T(G_t, D_b).
        k: the number of a piece whose source has this part.
        first: the number of an edge; all edges before it are flatter than the piece.

    Returns:
        (The number of an edge of the part, the touched x-range on it).

    Cost: O(edges passed over).
    """
    dx, dy, _, start, _ = trajectory.pieces[k]
    v, last = first, len(points) - 1
    while v < last:
        (left, y), (right, z) = points[v], points[v + 1]
        turn = (z - y) * dx - (right - left) * dy
        if turn == 0:
            # G's vertex or edge is over D_b from u - g_right to u - g_left, G being at u.
            x, _ = cast(Vertex, start)
            (n, d), g_right = trajectory.breaks[k], x + dx - right
            (m, e), g_left = trajectory.breaks[k + 1], x - left
            return v, (
                (left, 1) if n <= (left + g_right) * d else (n - g_right * d, d),
                (right, 1) if m >= (right + g_left) * e else (m - g_left * e, e),
            )
        if turn > 0:
            break
        v += 1
    at = points[v][0], 1
    return min(v, last - 1), (at, at)


def measure_unit(*directrices: Sequence[Vertex] | Envelope) -> int | None:
    """Return the unit in which the slopes of chains or envelopes are ints, for `split_parts`.

    The unit is a power of two, so that a chain usually has the same unit in different sweeps. It is
    None if some coordinate is not an int. Cost: O(n).
    """
    widest = 0
    for chain in directrices:
        width = chain.widest if isinstance(chain, Envelope) else measure_width(chain)
        if width is None:
            return None
        widest = max(widest, int(width))
    return 1 << 2 * widest.bit_length()


def take_whole(chain: Sequence[Vertex], unit: Rational | None) -> ConvexPart:
    """Return a convex chain as one part. Raises ChainError if it is not convex. Cost: O(n)."""
    part, *others = split_chain(chain, unit)
    if others:
        require_convex(chain)
    return part


def split_chain(chain: Sequence[Vertex], unit: Rational | None) -> list[ConvexPart]:
    """Step 1: split a bottom chain into convex parts, from left to right.

    Raises ChainError if the chain is not X-monotone. Cost: O(m).
    """
    kept = chain if type(chain) is KeptChain else None
    # One look-up: another thread may sweep the polygon with another unit at the same time.
    before = None if kept is None else kept.parts
    if before is not None and before[0] == unit:
        return before[1]
    found = split_by_slope(chain, unit)
    parts: list[ConvexPart] = []
    # A vertex joins two parts, or a wall. At the lower end of a wall all slopes are relevant, (5).
    falls = True
    for k, (points, slopes, edges) in enumerate(found, 1):
        flattest: Slope = -inf if falls else slopes[0]
        rises = k == len(found)
        if not rises:
            end, start = points[-1][1], found[k][0][0][1]
            rises, falls = start > end, start < end
        steepest: Slope = inf if rises else slopes[-1]
        parts.append(ConvexPart(points, edges, flattest, steepest, slopes))
    if kept is not None:
        kept.parts = unit, parts
    return parts


def split_envelope(envelope: Envelope, unit: Rational | None) -> Iterator[CrossingPart]:
    """Step 1: split an envelope without gaps into convex parts, left to right. Cost: O(m)."""
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


def split_parts(directrix: Sequence[Vertex] | Envelope, unit: Rational | None) -> Parts:
    """Step 1: split a bottom chain or an envelope without gaps into convex parts.

    A crossing in a lower envelope is concave, so a part ends there.

    Raises ChainError if a chain is not X-monotone. Cost: O(m).

    Example:
        >>> from exactsweep.procedures.lower_envelope import lower_envelope_cm
        >>> e = Envelope.of([(0, 0), (3, 1)])
        >>> print(lower_envelope_cm(e, Envelope.of([(1, 2), (4, -1)])))
        (0, 0) (9/4, 3/4) (4, -1)
        >>> [part.box for part in split_parts(e, measure_unit(e))]
        [(0, 3, 0), (2, 4, -1)]
    """
    if isinstance(directrix, Envelope):
        return list(split_envelope(directrix, unit))
    return split_chain(directrix, unit)
