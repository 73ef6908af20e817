"""The Hausdorff distance of two loops: how far a point of one can be from all of the other.

Loops are taken as curves, not as the regions inside, so that a notch filled or a hole forgotten
counts with its depth. The distance is the greater of two, from each loop to the other one.

Bounds. Let e be a piece of an edge of one loop, and f_j(p) the squared distance of a point p to
edge j of the other. A segment is convex, so is the distance to it, and so f_j is greatest on e at
an end of e. The squared distance to the whole loop is f = min_j f_j. Hence on e

    max(f(a), f(b))  <=  max f  <=  min_j max(f_j(a), f_j(b)),       a and b the ends of e.

Where one edge is nearest to both ends, both sides are equal, and the maximum is known exactly.
Otherwise e is cut in two. The maximum of f over a loop need not be at a vertex; inside e it is
where two edges are equally near, and e is cut there where possible: f_j is quadratic in the place
on e as long as the nearest feature of edge j stays the same, and the place is a root of the
difference, or, for edges that continue each other along e, the foot of an end. Roots may be
irrational; they are rounded, and the bounds do not mind where e is cut.
The piece with the greatest upper bound is cut first; once that bound is no greater than the
greatest value found, the latter is the maximum. If that does not happen before the two are close,
they are returned as they are.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from heapq import heappop, heappush
from itertools import count
from math import isqrt, lcm
from typing import NamedTuple

from exactsweep.numbers.point import PointRings

IntPair = tuple[int, int]


_BITS = 128


_LONG = 8192


Squares = tuple[Fraction, Fraction]


_CUTS = 1000
_MOST_LOOKED_AT = 1_500_000
"""Edges looked at for cuts, in either direction: some seconds."""

_CLOSE = 1 + Fraction(1, 2**32)


class LoopEdge:
    """An edge of a loop.

    Args:
        a: one end, a pair of ints.
        b: the other one; it may be the same.
    """

    __slots__ = ("a", "b", "bottom", "dx", "dy", "left", "length", "right", "top")

    def __init__(self, a: IntPair, b: IntPair) -> None:
        self.a, self.b = a, b
        self.dx, self.dy = b[0] - a[0], b[1] - a[1]
        self.length = self.dx * self.dx + self.dy * self.dy
        self.left, self.right = sorted((a[0], b[0]))
        self.bottom, self.top = sorted((a[1], b[1]))

    def at(self, t: Fraction) -> Place:
        """The place a + t (b - a).

        Example:
            >>> LoopEdge((0, 0), (2, 1)).at(Fraction(1, 3))
            Place(2, 1, 3)
        """
        p, q = t.as_integer_ratio()
        return Place(self.a[0] * q + p * self.dx, self.a[1] * q + p * self.dy, q)

    def foot(self, p: IntPair) -> Fraction:
        """The share of the edge at which a square line from a point meets its line.

        The edge has a length.
        """
        x, y = p[0] - self.a[0], p[1] - self.a[1]
        return Fraction(x * self.dx + y * self.dy, self.length)

    def distance(self, place: Place) -> Fraction:
        """The squared distance of a place.

        Example:
            >>> LoopEdge((0, 0), (2, 1)).distance(Place(1, 0, 1))
            Fraction(1, 5)
        """
        w = place.w
        x, y = place.x - self.a[0] * w, place.y - self.a[1] * w
        along = x * self.dx + y * self.dy
        if 0 < along < self.length * w:
            off = x * self.dy - y * self.dx
            return Fraction(off * off, self.length * w * w)
        if along > 0:
            x, y = place.x - self.b[0] * w, place.y - self.b[1] * w
        return Fraction(x * x + y * y, w * w)

    def along(self, edge: LoopEdge, t: Fraction) -> tuple[tuple[int, int, int], int]:
        """The squared distance of places on an edge to the feature that is nearest at t.

        Returns:
            The coefficients of t^2, t and 1, and a number that they are to be divided by.
        """
        u, v = edge.dx, edge.dy
        x, y = edge.a[0] - self.a[0], edge.a[1] - self.a[1]
        p, q = t.as_integer_ratio()
        along = (x * q + p * u) * self.dx + (y * q + p * v) * self.dy
        if 0 < along < self.length * q:
            off, step = x * self.dy - y * self.dx, u * self.dy - v * self.dx
            return (step * step, 2 * off * step, off * off), self.length
        if along > 0:
            x, y = edge.a[0] - self.b[0], edge.a[1] - self.b[1]
        return (edge.length, 2 * (u * x + v * y), x * x + y * y), 1


class Place:
    """A point (x / w, y / w), all of them ints."""

    __slots__ = ("w", "x", "y")

    def __init__(self, x: int, y: int, w: int) -> None:
        self.x, self.y, self.w = x, y, w

    def __repr__(self) -> str:
        return f"Place({self.x}, {self.y}, {self.w})"

    def box_distance(self, segment: LoopEdge) -> int:
        """The squared distance to the box around an edge, times w^2; quick."""
        x, y, w = self.x, self.y, self.w
        dx = max(segment.left * w - x, x - segment.right * w, 0)
        dy = max(segment.bottom * w - y, y - segment.top * w, 0)
        return dx * dx + dy * dy

    def bound(self, square: Fraction) -> int:
        """The least int above which a box distance is greater than that of a squared distance."""
        return square.numerator * self.w * self.w // square.denominator


class Edges:
    """All edges of some rings, asked for the nearest one."""

    def __init__(self, rings: Sequence[Sequence[IntPair]]) -> None:
        self._segments = [LoopEdge(ring[k - 1], p) for ring in rings for k, p in enumerate(ring)]
        self._ends = {frozenset((segment.a, segment.b)) for segment in self._segments}

    def has(self, edge: LoopEdge) -> bool:
        """Decide whether there is an edge with the same ends."""
        return frozenset((edge.a, edge.b)) in self._ends

    def nearest(self, place: Place) -> tuple[Fraction, LoopEdge]:
        """The squared distance of a place to the rings, and an edge that has it."""
        segments = self._segments
        nearest = segments[0]
        best = nearest.distance(place)
        bound = place.bound(best)
        for segment in segments:
            if place.box_distance(segment) <= bound:
                distance = segment.distance(place)
                if distance < best:
                    best, nearest, bound = distance, segment, place.bound(distance)
        # The next place asked for is close as a rule: begin with this edge then.
        segments.remove(nearest)
        segments.insert(0, nearest)
        return best, nearest

    def upper_bound(self, a: Place, b: Place, hints: Sequence[LoopEdge]) -> Fraction:
        """The least, over all edges, of the greater squared distance of two places to the edge."""
        best = min(max(segment.distance(a), segment.distance(b)) for segment in hints)
        bound_a, bound_b = a.bound(best), b.bound(best)
        for segment in self._segments:
            if a.box_distance(segment) <= bound_a and b.box_distance(segment) <= bound_b:
                best = min(best, max(segment.distance(a), segment.distance(b)))
                bound_a, bound_b = a.bound(best), b.bound(best)
        return best


def find_equally_near(
    edge: LoopEdge, start: Fraction, end: Fraction, near_start: LoopEdge, near_end: LoopEdge
) -> Fraction:
    """Find where, on a piece of an edge, the edge nearest to its end becomes the nearest one.

    Args:
        edge: the edge.
        start: the piece's first end, as a share of the edge.
        end: the second one.
        near_start: an edge that is nearest to the first end.
        near_end: one nearest to the second end.

    Returns:
        A share strictly between the two: where both are equally near; or else the foot of an end
        of one of them; or else half-way. Exact where it is rational and not too long, otherwise
        rounded.

    Example:
        >>> low, high = LoopEdge((0, 0), (9, 0)), LoopEdge((0, 8), (9, 8))
        >>> find_equally_near(LoopEdge((1, 1), (1, 7)), Fraction(0), Fraction(1), low, high)
        Fraction(1, 2)
    """
    (first, m), (second, n) = near_start.along(edge, start), near_end.along(edge, end)
    square, mixed, constant = (p * n - q * m for p, q in zip(first, second, strict=True))
    roots: list[Fraction] = []
    if square:
        discriminant = mixed * mixed - 4 * square * constant
        if discriminant >= 0:
            root, one = _square_root(discriminant)
            roots = [Fraction(sign * root - mixed * one, 2 * square * one) for sign in (-1, 1)]
    elif mixed:
        roots = [Fraction(-constant, mixed)]
    # Where both run along the edge, as if they were one, they are equally near everywhere.
    feet = (edge.foot(p) for near in (near_start, near_end) for p in (near.a, near.b))
    shares = (t if t.denominator.bit_length() <= _LONG else _round(t) for t in (*roots, *feet))
    return next((t for t in shares if start < t < end), (start + end) / 2)


def _square_root(value: int) -> tuple[int, int]:
    """The root and 1 if it is an integer; else one rounded, and what it is to be divided by."""
    root = isqrt(value)
    if root * root == value:
        return root, 1
    return isqrt(value << 2 * _BITS), 1 << _BITS


def _round(value: Fraction) -> Fraction:
    """The number to some 128 digits in base 2."""
    p, q = value.as_integer_ratio()
    shift = max(0, _BITS + q.bit_length() - p.bit_length())
    return Fraction((p << shift) // q, 1 << shift)


class _PieceEnd(NamedTuple):
    """An end of a piece of an edge: its share of the edge, and an edge that is nearest to it."""

    share: Fraction
    near: LoopEdge


class _EdgePiece(NamedTuple):
    """A piece of an edge; the least one of a heap has the greatest bound.

    Attributes:
        bound: of the squared distance on the piece, from above, negative.
        number: tells pieces of equal bounds apart.
        edge: of which it is a piece.
        start: one end.
        end: the other one.
    """

    bound: Fraction
    number: int
    edge: LoopEdge
    start: _PieceEnd
    end: _PieceEnd


def bound_distance(first: PointRings, second: PointRings) -> Squares:
    """Bound the square of the Hausdorff distance of two sets of rings.

    Args:
        first: rings, each a sequence of Point, not closed; at least one vertex in all.
        second: likewise.

    Returns:
        (low, high), Fractions with low <= distance squared <= high: equal where the maximum is
        found exactly, as it is wherever it is at a vertex; otherwise less than one part in 2^32
        apart, unless 1000 cuts, of loops of more than 500 vertices fewer, do not lead there.

    Cost: O((m + n + c) (m + n)) operations on rationals for c cuts.

    Example:
        >>> from exactsweep import Point
        >>> square = [Point(Fraction(x), Fraction(y)) for x, y in [(0, 0), (4, 0), (4, 4), (0, 4)]]
        >>> dented = [*square[:3], Point(Fraction(2), Fraction(1)), square[3]]
        >>> bound_distance([square], [dented])
        (Fraction(36, 13), Fraction(36, 13))
    """
    scale = lcm(*(c.denominator for rings in (first, second) for r in rings for p in r for c in p))
    one, other = (
        [[(int(x * scale), int(y * scale)) for x, y in ring] for ring in rings]
        for rings in (first, second)
    )
    there = _one_way(one, other)
    back = _one_way(other, one)
    low, high = (max(bounds) for bounds in zip(there, back, strict=True))
    return low / scale**2, high / scale**2


def _one_way(rings: Sequence[Sequence[IntPair]], target: Sequence[Sequence[IntPair]]) -> Squares:
    """Bounds of the greatest squared distance of a point of some rings to others."""
    edges = Edges(target)
    pieces: list[_EdgePiece] = []
    number = count()

    def add(edge: LoopEdge, start: _PieceEnd, end: _PieceEnd) -> None:
        ends = edge.at(start.share), edge.at(end.share)
        bound = edges.upper_bound(*ends, (start.near, end.near))
        heappush(pieces, _EdgePiece(-bound, next(number), edge, start, end))

    low = Fraction(0)
    for ring in rings:
        found = [edges.nearest(Place(x, y, 1)) for x, y in ring]
        low = max(low, *(distance for distance, _ in found))
        for k, b in enumerate(ring):
            edge = LoopEdge(ring[k - 1], b)
            if edge.length and not edges.has(edge):
                start = _PieceEnd(Fraction(0), found[k - 1][1])
                add(edge, start, _PieceEnd(Fraction(1), found[k][1]))
    # A cut looks for one nearest edge and for two bounds, among all.
    cuts = min(_CUTS, _MOST_LOOKED_AT // (3 * sum(map(len, target))))
    for _ in range(cuts):
        if not pieces or -pieces[0].bound <= low * _CLOSE:
            break
        _, _, edge, start, end = heappop(pieces)
        t = find_equally_near(edge, start.share, end.share, start.near, end.near)
        distance, near = edges.nearest(edge.at(t))
        low = max(low, distance)
        add(edge, start, _PieceEnd(t, near))
        add(edge, _PieceEnd(t, near), end)
    return low, max(low, -pieces[0].bound) if pieces else low
