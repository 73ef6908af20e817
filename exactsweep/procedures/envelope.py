"""Lower envelopes of chains, and LowerEnvelope_CM and LowerEnvelope_MM (Appendix, Section 5.1).

An envelope is kept as the edges it is made of, each whole, with the breaks between which each one
is the lowest. An edge that a crossing cuts short keeps the end points it was given with: on
integer input all edges stay integer, a crossing is only a break n/d, and no Fraction is made
before somebody reads the vertices.

Lemma A.3 allows the partial trajectory and the next sub-trajectory to meet in a point or in a
segment. With vertical edges in D_b they may also pass each other without meeting, where one of
them ends: the envelope then jumps, and its chain has a vertical edge there.

Edges and lines between breaks are compared by integer arithmetic: which of two lines is lower at
x = n / d is the sign of u * n + v * d, with u and v from the lines alone, without a division.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple, cast

from exactsweep.geometry.number import quotient
from exactsweep.geometry.point import Edge, Rational, Vertex
from exactsweep.procedures.chain import ChainError, convex_parts

Break = tuple[Rational, Rational]
"""x = n / d with d > 0; not reduced."""

Span = tuple[Break, Break]
"""An x-range between two breaks."""

Line = tuple[Rational, Rational, Rational]
"""(dx, dy, c) with dx > 0: y = (dy * x + c) / dx."""

Piece = Edge | Line | None
"""A piece of an envelope: an edge; its line, where its ends are not on the lattice; None, a hole
between chains, which counts as infinitely high."""

_SLOPE_UNITS = 2**32


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
        """Append one that starts where this one ends, or right of that. Cost: O(its size)."""
        if precedes(self.breaks[-1], other.breaks[0]):
            self.extend_hole(other.breaks[0])
        self.lines().extend(other.lines())
        self.edges += other.edges
        self.sources += other.sources
        self.breaks += other.breaks[1:]

    def padded(self, start: Break, end: Break) -> Envelope:
        """The same over a wider x-range, with holes at the ends. Cost: O(n)."""
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

        Raises ChainError when it is not X-monotone. Cost: O(n).
        """
        envelope = cls([(chain[0][0], 1)], [], [])
        for part in convex_parts(chain):
            # Points of its own, so that edges are `joined` inside the part alone.
            envelope.extend(cls.of_own([(x, y) for x, y in part], source))
        return envelope

    @classmethod
    def of_own(cls, chain: Sequence[Vertex], source: int = 0) -> Envelope:
        """Wrap a strictly convex chain whose point objects no other chain shares. Cost: O(n)."""
        edges: list[Piece] = list(pairwise(chain))
        return cls([(x, 1) for x, _ in chain], edges, [source] * len(edges))

    def parts(self) -> list[Part]:
        """Convex parts of the envelope, with the breaks between which each one holds.

        The cut edges at either end of a part are whole. What that adds lies above the envelope,
        on the chain it was cut from. Cost: O(n).

        Example:
            >>> from exactsweep.procedures.lower_envelope import lower_envelope_cm
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
            # One and the same point object: consecutive edges of one convex chain. Equal points
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

    def __str__(self) -> str:
        return " ".join(f"({x}, {y})" for x, y in self)

    def restricted(self, start: Rational, end: Rational) -> Envelope:
        """Cut to the x-range from start to end, which must overlap it. Cost: O(n)."""
        breaks = self.breaks
        first = max(k for k, (n, d) in enumerate(breaks[:-1]) if k == 0 or n <= start * d)
        last = min(k for k, (n, d) in enumerate(breaks) if k > first and n >= end * d)
        return Envelope(
            [(start, 1), *breaks[first + 1 : last], (end, 1)],
            self.edges[first:last],
            self.sources[first:last],
        )


def joined(before: Piece, after: Piece) -> bool:
    """Whether one edge ends in the point object that the next one starts with.

    Then both are consecutive edges of one convex chain.
    """
    return before is not None and after is not None and len(before) == 2 and before[1] is after[0]


def point_on(edge: Piece, at: Break) -> Vertex:
    """The point of an edge at a break. Cost: O(1)."""
    n, d = at
    if edge is not None and len(edge) == 2:
        p, q = edge
        if n == p[0] * d:
            return p
        if n == q[0] * d:
            return q
    dx, dy, c = line_of(edge)
    return quotient(n, d), quotient(dy * n + c * d, dx * d)


def line_of(edge: Piece) -> Line:
    """The line through an edge. Cost: O(1)."""
    if edge is None:
        raise ChainError("the envelope has a hole: its chains do not overlap in x")
    if len(edge) == 3:
        return edge
    (px, py), (qx, qy) = edge
    dx, dy = qx - px, qy - py
    return dx, dy, py * dx - px * dy


def cross(start: Vertex, end: Vertex, edge: Edge) -> Rational:
    """Positive when start to end is steeper than the edge, zero when parallel. Cost: O(1)."""
    (px, py), (qx, qy) = edge
    return (qx - px) * (end[1] - start[1]) - (qy - py) * (end[0] - start[0])


def slope_bound(edge: Edge) -> Rational:
    """The slope of an edge in units of 2**-32, rounded down to an int.

    One that is greater than another's is the slope of a steeper edge.
    """
    (px, py), (qx, qy) = edge
    return (qy - py) * _SLOPE_UNITS // (qx - px)


def gap(first: Line, second: Line) -> tuple[Rational, Rational]:
    """Return (u, v) such that at x = n/d the first line minus the second has the sign of u*n + v*d.

    The lines cross at x = -v/u. Cost: O(1), four products.
    """
    adx, ady, ac = first
    bdx, bdy, bc = second
    return ady * bdx - bdy * adx, ac * bdx - bc * adx


def height(first: Piece, second: Piece, at: Break) -> Rational:
    """Positive when the line of the first edge is above that of the second at a break."""
    u, v = gap(line_of(first), line_of(second))
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
    """Where two lines cross whose `gap` is (u, v), u not zero."""
    return (-v, u) if u > 0 else (v, -u)


def value(at: Break) -> Fraction:
    """The x of a break."""
    return quotient(*at)


def precedes(first: Break, second: Break) -> bool:
    """Whether a break lies left of another."""
    return first[0] * second[1] < second[0] * first[1]
