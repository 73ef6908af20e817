"""Lower envelopes of chains: pieces of edges, and the breaks between which each is the lowest.

An envelope stores each piece by the whole line of its edge, and the breaks between which the piece
is the lowest. An edge that a crossing cuts short keeps its start vertex. So all lines of integer
input stay integer, a crossing is only a break n/d, and nothing becomes a Fraction before somebody
reads the vertices. An edge whose ends are not on the lattice is stored by its line alone, which is
integer, too. Where no chain exists, the envelope has a gap, which counts as infinitely high.

Integer arithmetic compares pieces between breaks. The lower of two lines at x = n / d is given by
the sign of u * n + v * d, where u and v depend on the lines alone. No division is needed.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain, pairwise

from exactsweep.numbers.number import Edge, Rational, Vertex, divide_exactly, ratio
from exactsweep.procedures.chain import ChainError, find_convex_parts

Break = tuple[Rational, Rational]
"""x = n / d with d > 0; not reduced."""

Span = tuple[Break, Break]
"""An x-range between two breaks."""

Piece = tuple[Rational, Rational, Rational, Vertex | None, int]
"""(dx, dy, c, start, source): a piece of the line y = (dy * x + c) / dx with dx > 0.

The piece belongs to the edge from `start` to start + (dx, dy), of chain number `source`. `start` is
None for an edge whose ends are not on the lattice.
"""

GAP: Piece = (0, 0, 1, None, -1)
"""A gap between chains: the line at infinity, above all others, of chain -1."""


class Envelope:
    """The lower envelope of chains: piece k is the lowest from break k to break k + 1.

    Iterating gives the vertices from left to right, vertical edges included, no three collinear.

    Attributes:
        breaks: the breaks, ascending, one more than pieces.
        pieces: the pieces from left to right, `GAP` between chains.

    >>> list(Envelope.of([(0, 0), (1, -1), (2, 0)]))
    [(0, 0), (1, -1), (2, 0)]
    """

    __slots__ = ("breaks", "pieces")

    def __init__(self, breaks: list[Break], pieces: list[Piece]) -> None:
        self.breaks = breaks
        self.pieces = pieces

    @classmethod
    def of(cls, chain: Sequence[Vertex], source: int = 0) -> Envelope:
        """Wrap a chain, from left to right, vertical edges allowed.

        Raises ChainError if the chain is not X-monotone. Cost: O(n).
        """
        first, *rest = (cls.of_convex(part, source) for part in find_convex_parts(chain))
        for part in rest:
            first.take_all(part)
        return first

    @classmethod
    def of_convex(cls, chain: Sequence[Vertex], source: int = 0) -> Envelope:
        """Wrap a strictly convex chain. Cost: O(n)."""
        edges: list[Piece] = [
            (dx := qx - px, dy := qy - py, py * dx - px * dy, start, source)
            for start, (qx, qy) in pairwise(chain)
            for px, py in [start]
        ]
        return cls([(x, 1) for x, _ in chain], edges)

    @property
    def sources(self) -> list[int]:
        """The number of the chain of each piece."""
        return [piece[4] for piece in self.pieces]

    @property
    def widest(self) -> Rational | None:
        """The width of the widest edge, if all coordinates are ints. Cost: O(n)."""
        steps = [piece[:2] for piece in self.pieces]
        if all(issubclass(kind, int) for kind in set(map(type, chain.from_iterable(steps)))):
            return max(steps)[0]
        return None

    def point(self, k: int, at: Break) -> Vertex:
        """The point of piece k at a break. Raises ChainError where there is a gap. Cost: O(1)."""
        return find_point(self.pieces[k], at)

    def edge_before(self, at: Break) -> int:
        """The number of the piece that holds just left of a break. Cost: O(log n)."""
        n, d = at
        return bisect_left(self.breaks, True, key=lambda b: b[0] * d >= n * b[1]) - 1

    def edge_after(self, at: Break, first: int = 0) -> int:
        """The number of the piece, from the first, that holds just right of a break.

        Cost: O(log n).
        """
        n, d = at
        return bisect_left(self.breaks, True, first, key=lambda b: b[0] * d > n * b[1]) - 1

    def take_all(self, chain: Envelope) -> None:
        """Append a chain that starts where this one ends, or right of that. Cost: O(its size)."""
        self.take_gap(chain.breaks[0])
        self.breaks += chain.breaks[1:]
        self.pieces += chain.pieces

    def take_gap(self, end: Break) -> None:
        """Append a gap up to a break, if the break is right of the end."""
        if precedes(self.breaks[-1], end):
            self.pieces.append(GAP)
            self.breaks.append(end)

    def take_between(self, chain: Envelope, start: Break, end: Break, first: int = 0) -> int:
        """Append the pieces of a chain between two breaks, if the second is right of the first.

        Args:
            chain: an envelope over the whole range between the breaks.
            start: the first break.
            end: the second break.
            first: the number of a piece of the chain that begins at the first break or left of it.

        Returns the number of the last piece taken, or `first`.
        Cost: O(log n + pieces taken).
        """
        if not precedes(start, end):
            return first
        begin = last = chain.edge_after(start, first)
        breaks = chain.breaks
        (n, d), (m, e) = end, breaks[last + 1]
        while m * d < n * e:
            last += 1
            m, e = breaks[last + 1]
        self.pieces += chain.pieces[begin : last + 1]
        self.breaks += breaks[begin + 1 : last + 1]
        self.breaks.append(end)
        return last

    def keep(self, spans: Sequence[Span]) -> Envelope | None:
        """Keep the parts over some x-ranges, which ascend, and put gaps between them.

        Returns None if the envelope reaches none of the ranges.
        Cost: O(log k) for k x-ranges, O(log n) for each that it reaches, and O(pieces kept).
        """
        kept: Envelope | None = None
        first, last = self.breaks[0], self.breaks[-1]
        begin = bisect_left(spans, True, key=lambda span: precedes(first, span[1]))
        at = 0
        for k in range(begin, len(spans)):
            start, end = spans[k]
            if not precedes(start, last):
                break
            if precedes(last, end):
                end = last
            if kept is not None:
                kept.take_gap(start)
            else:
                # Only the first one may begin left of it.
                if precedes(start, first):
                    start = first
                kept = Envelope([start], [])
            at = kept.take_between(self, start, end, at)
        return kept

    def __iter__(self) -> Iterator[Vertex]:
        breaks, pieces = self.breaks, self.pieces
        before = pieces[0]
        found = [find_point(before, breaks[0])]
        for piece, at in zip(pieces[1:], breaks[1:], strict=False):
            bdx, bdy, bc, start, _ = piece
            adx, ady, ac, begin, _ = before
            u = ady * bdx - bdy * adx
            if (
                u
                and start is not None
                and begin is not None
                and start == (begin[0] + adx, begin[1] + ady)
            ):
                # Usually the edges share a vertex: no arithmetic is needed.
                found.append(start)
            else:
                step = u * at[0] + (ac * bdx - bc * adx) * at[1]
                if step:
                    found.append(find_point(before, at))
                if step or u:
                    found.append(find_point(piece, at))
            before = piece
        found.append(find_point(before, breaks[-1]))
        return iter(found)

    def __str__(self) -> str:
        return " ".join(f"({x}, {y})" for x, y in self)


def find_point(piece: Piece, at: Break) -> Vertex:
    """The point of a piece at a break. Raises ChainError where there is a gap. Cost: O(1)."""
    dx, dy, c, start, _ = piece
    n, d = at
    if start is not None and n == start[0] * d:
        return start
    if not dx:
        raise ChainError("the envelope has a gap: its chains do not overlap in x")
    if d == 1:
        return n, ratio(dy * n + c, dx)
    return ratio(n, d), ratio(dy * n + c * d, dx * d)


def find_point_on(edge: Edge, at: Break) -> Vertex:
    """The point of an edge at a break. Cost: O(1)."""
    n, d = at
    p, q = edge
    if n == p[0] * d:
        return p
    if n == q[0] * d:
        return q
    dx, dy = q[0] - p[0], q[1] - p[1]
    return ratio(n, d), ratio(dy * n + (p[1] * dx - p[0] * dy) * d, dx * d)


def cross(start: Vertex, end: Vertex, piece: Piece) -> Rational:
    """Return a number that is positive if start to end is steeper than a piece, 0 if parallel."""
    return piece[0] * (end[1] - start[1]) - piece[1] * (end[0] - start[0])


def height(first: Piece, second: Piece, at: Break) -> Rational:
    """Return a number that is positive if the first piece's line is above the second's."""
    adx, ady, ac, _, _ = first
    bdx, bdy, bc, _, _ = second
    return (ady * bdx - bdy * adx) * at[0] + (ac * bdx - bc * adx) * at[1]


def find_crossing(u: Rational, v: Rational) -> Break:
    """Find where lines with the difference u * n + v * d at n / d cross, u not zero."""
    return (-v, u) if u > 0 else (v, -u)


def value(at: Break) -> Fraction:
    """Return the x of a break."""
    return divide_exactly(*at)


def precedes(first: Break, second: Break) -> bool:
    """Decide whether a break lies left of another."""
    return first[0] * second[1] < second[0] * first[1]
