"""Pieces of envelopes: edges and lines between breaks, compared by integer arithmetic.

Which of two lines is lower at x = n / d is the sign of u * n + v * d, with u and v from the lines
alone: no division, and no Fraction.
"""

from __future__ import annotations

from fractions import Fraction

from exactsweep.chain import ChainError, Edge, Rational, Vertex
from exactsweep.number import quotient

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


def joined(before: Piece, after: Piece) -> bool:
    """Whether one edge ends in the point object that the next one starts with.

    Then both are consecutive edges of one convex chain.
    """
    return before is not None and after is not None and len(before) == 2 and before[1] is after[0]


def point_on(edge: Piece, at: Break) -> Vertex:
    """The point of an edge at a break.  Cost: O(1)."""
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
    """The line through an edge.  Cost: O(1)."""
    if edge is None:
        raise ChainError("the envelope has a hole: its chains do not overlap in x")
    if len(edge) == 3:
        return edge
    (px, py), (qx, qy) = edge
    dx, dy = qx - px, qy - py
    return dx, dy, py * dx - px * dy


def cross(start: Vertex, end: Vertex, edge: Edge) -> Rational:
    """Positive when start to end is steeper than the edge, zero when parallel.  Cost: O(1)."""
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

    The lines cross at x = -v/u.  Cost: O(1), four products.
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
