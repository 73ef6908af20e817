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
from exactsweep.procedures.chain import ChainError

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
        breaks: list[Break] = [(chain[0][0], 1)]
        pieces: list[Piece] = []
        for start, (qx, qy) in pairwise(chain):
            px, py = start
            dx, dy = qx - px, qy - py
            if dx < 0:
                raise ChainError(f"({qx}, {qy}) lies left of ({px}, {py}): not an X-monotone chain")
            if dx:
                pieces.append((dx, dy, py * dx - px * dy, start, source))
                breaks.append((qx, 1))
        if not pieces:
            raise ChainError("a chain of no width: all of its edges are vertical")
        return cls(breaks, pieces)

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

    def edge_before(self, at: Break) -> int:
        """The number of the piece that holds just left of a break. Cost: O(log n)."""
        n, d = at
        return bisect_left(self.breaks, True, key=lambda b: b[0] * d >= n * b[1]) - 1

    def edge_after(self, at: Break) -> int:
        """The number of the piece that holds just right of a break. Cost: O(log n)."""
        n, d = at
        return bisect_left(self.breaks, True, key=lambda b: b[0] * d > n * b[1]) - 1

    def take_all(self, chain: Envelope) -> None:
        """Append a chain that starts where this one ends, or right of that. Cost: O(its size)."""
        if precedes(self.breaks[-1], chain.breaks[0]):
            self.pieces.append(GAP)
            self.breaks.append(chain.breaks[0])
        self.breaks += chain.breaks[1:]
        self.pieces += chain.pieces

    def take_between(self, chain: Envelope, start: Break, end: Break) -> None:
        """Append the pieces of a chain between two breaks, if the second is right of the first.

        Args:
            chain: an envelope over the whole range between the breaks.
            start: the first break.
            end: the second break.

        Cost: O(log n + pieces taken).
        """
        if precedes(start, end):
            first, last = chain.edge_after(start), chain.edge_before(end)
            self.pieces += chain.pieces[first : last + 1]
            self.breaks += chain.breaks[first + 1 : last + 1]
            self.breaks.append(end)

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
