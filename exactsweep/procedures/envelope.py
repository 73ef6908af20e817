"""Lower envelopes of chains: the edges they are made of, and the breaks between which each holds.

An envelope is kept as the edges it is made of, each whole, with the breaks between which each one
is the lowest. An edge that a crossing cuts short keeps the end points it was given with: on
integer input all edges stay integer, a crossing is only a break n/d, and no Fraction is made
before somebody reads the vertices. Of an edge whose ends are not on the lattice only the line is
kept, which is integer all the same. Where there is no chain the envelope has a gap, which counts
as infinitely high.

Edges and lines between breaks are compared by integer arithmetic: which of two lines is lower at
x = n / d is the sign of u * n + v * d, with u and v from the lines alone, without a division.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import cast

from exactsweep.geometry.number import quotient
from exactsweep.geometry.point import Edge, Rational, Vertex
from exactsweep.procedures.chain import ChainError, convex_parts

Break = tuple[Rational, Rational]
"""x = n / d with d > 0; not reduced."""

Span = tuple[Break, Break]
"""An x-range between two breaks."""

Line = tuple[Rational, Rational, Rational]
"""(dx, dy, c) with dx > 0: y = (dy * x + c) / dx."""

NO_CHAIN = -1
"""The source of a gap."""

_SLOPE_UNITS = 2**32


class Envelope:
    """The lower envelope of chains: edge k is the lowest from break k to break k + 1.

    Iterating gives the vertices from left to right, vertical edges included, no three collinear.

    Attributes:
        breaks: one more than there are edges, ascending.
        edges: each whole; None for one that is not on the lattice, and for a gap.
        sources: of each edge the number of the chain that it comes from, NO_CHAIN for a gap.

    >>> list(Envelope.of([(0, 0), (1, -1), (2, 0)]))
    [(0, 0), (1, -1), (2, 0)]
    """

    __slots__ = ("_lines", "breaks", "edges", "sources")

    def __init__(
        self,
        breaks: list[Break],
        edges: list[Edge | None],
        sources: list[int],
        lines: list[Line | None] | None = None,
    ) -> None:
        self.breaks = breaks
        self.edges = edges
        self.sources = sources
        # Made when they are first asked for; until then all edges are on the lattice.
        self._lines = lines

    @classmethod
    def of(cls, chain: Sequence[Vertex], source: int = 0) -> Envelope:
        """Wrap a chain, from left to right, vertical edges allowed.

        Raises ChainError when it is not X-monotone. Cost: O(n).
        """
        breaks: list[Break] = [(chain[0][0], 1)] if chain else []
        edges: list[Edge | None] = []
        for part in convex_parts(chain):
            breaks += [(x, 1) for x, _ in part[1:]]
            edges += pairwise(part)
        return cls(breaks, edges, [source] * len(edges))

    @classmethod
    def of_convex(cls, chain: Sequence[Vertex], source: int = 0) -> Envelope:
        """Wrap a strictly convex chain. Cost: O(n)."""
        edges: list[Edge | None] = list(pairwise(chain))
        return cls([(x, 1) for x, _ in chain], edges, [source] * len(edges))

    def lines(self) -> list[Line | None]:
        """The lines of the edges, kept from one merge to the next; None for a gap."""
        if self._lines is None:
            self._lines = list(map(line_of, cast(list[Edge], self.edges)))
        return self._lines

    def line(self, k: int) -> Line:
        """The line of edge k. Raises ChainError where there is a gap. Cost: O(1)."""
        if self._lines is None:
            (px, py), (qx, qy) = cast(Edge, self.edges[k])
            dx, dy = qx - px, qy - py
            return dx, dy, py * dx - px * dy
        line = self._lines[k]
        if line is None:
            raise ChainError("the envelope has a gap: its chains do not overlap in x")
        return line

    def point(self, k: int, at: Break) -> Vertex:
        """The point of edge k at a break. Raises ChainError where there is a gap. Cost: O(1)."""
        edge = self.edges[k]
        return point_on_line(self.line(k), at) if edge is None else point_on(edge, at)

    def follows(self, other: Envelope) -> bool:
        """Whether it starts over another one, and ends where that ends or right of it."""
        return not (
            precedes(self.breaks[0], other.breaks[0])
            or precedes(other.breaks[-1], self.breaks[0])
            or precedes(self.breaks[-1], other.breaks[-1])
        )

    def edge_before(self, at: Break, first: int = 0) -> int:
        """The number of the edge, from the first, that holds just left of a break.

        Cost: O(log n).
        """
        n, d = at
        return bisect_left(self.breaks, True, first, key=lambda b: b[0] * d >= n * b[1]) - 1

    def edge_after(self, at: Break) -> int:
        """The number of the edge that holds just right of a break. Cost: O(log n)."""
        n, d = at
        return bisect_left(self.breaks, True, key=lambda b: b[0] * d > n * b[1]) - 1

    def take(self, chain: Envelope, first: int, last: int, end: Break) -> None:
        """Append edges first to last of a chain, cut at the break `end`.

        The break lies on the last edge or where it starts. Cost: O(edges appended).
        """
        if last == len(chain.edges) or not precedes(chain.breaks[last], end):
            last -= 1
        if last >= first:
            self.lines().extend(chain.lines()[first : last + 1])
            self.edges += chain.edges[first : last + 1]
            self.sources += chain.sources[first : last + 1]
            self.breaks += chain.breaks[first + 1 : last + 1]
            self.breaks.append(end)

    def take_all(self, chain: Envelope) -> None:
        """Append a chain that starts where this one ends, or right of that. Cost: O(its size)."""
        self.take_gap(chain.breaks[0])
        self.take(chain, 0, len(chain.edges), chain.breaks[-1])

    def take_gap(self, end: Break) -> None:
        """Append a gap up to a break, if that is right of the end."""
        if precedes(self.breaks[-1], end):
            self.lines().append(None)
            self.edges.append(None)
            self.sources.append(NO_CHAIN)
            self.breaks.append(end)

    def replace_end(self, kept: int, at: Break, chain: Envelope, first: int) -> None:
        """Keep some edges, up to a break; from there on it is a chain from its edge `first` on.

        Cost: O(edges left out and appended).
        """
        if self._lines is not None or chain._lines is not None:
            self.lines()[kept:] = chain.lines()[first:]
        self.edges[kept:] = chain.edges[first:]
        self.sources[kept:] = chain.sources[first:]
        self.breaks[kept:] = [at, *chain.breaks[first + 1 :]]

    def pad(self, start: Break, end: Break) -> Envelope:
        """The same over a wider x-range, with gaps at the ends. Cost: O(n)."""
        padded = Envelope([min(start, self.breaks[0], key=value)], [], [])
        padded.take_all(self)
        padded.take_gap(end)
        return padded

    def restrict(self, start: Rational, end: Rational) -> Envelope:
        """Cut to the x-range from start to end, which must overlap it. Cost: O(n)."""
        first = max(self.edge_after((start, 1)), 0)
        last = min(self.edge_before((end, 1)), len(self.edges) - 1)
        cut = Envelope([(start, 1)], [], [])
        cut.take(self, first, last, (end, 1))
        return cut

    def __iter__(self) -> Iterator[Vertex]:
        edges, sources = self.edges, self.sources
        yield self.point(0, self.breaks[0])
        before, source = edges[0], sources[0]
        for k in range(1, len(edges)):
            last, before, last_source, source = before, edges[k], source, sources[k]
            if last is not None and before is not None and last[1] == before[0]:
                q = before[0]
                # Of one chain no three vertices are collinear; of two they may be, by chance.
                if source == last_source:
                    yield q
                    continue
                (px, py), (rx, ry) = last[0], before[1]
                if (q[0] - px) * (ry - q[1]) != (q[1] - py) * (rx - q[0]):
                    yield q
                continue
            at = self.breaks[k]
            u, v = difference(self.line(k - 1), self.line(k))
            step = u * at[0] + v * at[1] != 0
            if step or u != 0:
                yield self.point(k - 1, at)
            if step:
                yield self.point(k, at)
        yield self.point(len(edges) - 1, self.breaks[-1])

    def __str__(self) -> str:
        return " ".join(f"({x}, {y})" for x, y in self)


def line_of(edge: Edge) -> Line:
    """The line through an edge. Cost: O(1)."""
    (px, py), (qx, qy) = edge
    dx, dy = qx - px, qy - py
    return dx, dy, py * dx - px * dy


def point_on(edge: Edge, at: Break) -> Vertex:
    """The point of an edge at a break. Cost: O(1)."""
    n, d = at
    p, q = edge
    if n == p[0] * d:
        return p
    if n == q[0] * d:
        return q
    return point_on_line(line_of(edge), at)


def point_on_line(line: Line, at: Break) -> Vertex:
    """The point of a line at a break. Cost: O(1)."""
    n, d = at
    dx, dy, c = line
    return quotient(n, d), quotient(dy * n + c * d, dx * d)


def cross(start: Vertex, end: Vertex, edge: Edge) -> Rational:
    """Positive when start to end is steeper than the edge, zero when parallel. Cost: O(1)."""
    (px, py), (qx, qy) = edge
    return (qx - px) * (end[1] - start[1]) - (qy - py) * (end[0] - start[0])


def bound_slope(line: Line) -> Rational:
    """The slope of a line in units of 2**-32, rounded down to an int.

    One that is greater than another's is the slope of a steeper line.
    """
    dx, dy, _ = line
    return dy * _SLOPE_UNITS // dx


def difference(first: Line, second: Line) -> tuple[Rational, Rational]:
    """Return (u, v) such that at x = n/d the first line minus the second has the sign of u*n + v*d.

    The lines cross at x = -v/u. Cost: O(1), four products.
    """
    adx, ady, ac = first
    bdx, bdy, bc = second
    return ady * bdx - bdy * adx, ac * bdx - bc * adx


def height(first: Line, second: Line, at: Break) -> Rational:
    """Positive when the first line is above the second at a break."""
    u, v = difference(first, second)
    return u * at[0] + v * at[1]


def lower_bound(line: Line, at: Break) -> Rational:
    """The y of a line at a break, rounded down to an int."""
    dx, dy, c = line
    n, d = at
    return (dy * n + c * d) // (dx * d)


def upper_bound(line: Line, at: Break) -> Rational:
    """The y of a line at a break, rounded up to an int."""
    dx, dy, c = line
    n, d = at
    return -(-(dy * n + c * d) // (dx * d))


def crossing(u: Rational, v: Rational) -> Break:
    """Where two lines cross whose `difference` is (u, v), u not zero."""
    return (-v, u) if u > 0 else (v, -u)


def value(at: Break) -> Fraction:
    """The x of a break."""
    return quotient(*at)


def precedes(first: Break, second: Break) -> bool:
    """Whether a break lies left of another."""
    return first[0] * second[1] < second[0] * first[1]


def shares_vertex(before: Edge | None, after: Edge | None) -> bool:
    """Whether both are on the lattice and one ends where the other one starts."""
    return before is not None and after is not None and before[1] == after[0]
