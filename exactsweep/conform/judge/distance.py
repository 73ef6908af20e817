"""The Hausdorff distance of loops, bounded: how far a point of one can be from all of the other.

Loops are curves here, so that a notch filled counts with its depth. Let e be a piece of an edge of
one loop, with ends a and b, and f_j(p) the squared distance of a point p from edge j of the other;
f = min_j f_j. A segment is convex, so that f_j has its greatest value on e at an end of e, and

    (1)  max(f(a), f(b))  <=  max f on e  <=  min_j max(f_j(a), f_j(b)).

Where one edge is nearest to both ends, both sides of (1) are equal. Otherwise e is cut in two where
two edges are equally near: f_j is quadratic along e as long as the nearest feature of edge j stays
the same. Roots are rounded, which (1) allows. The piece with the greatest upper bound comes first;
the search ends when that bound is no greater than the greatest value found, or close to it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from heapq import heappop, heappush
from itertools import chain, count
from math import floor, isqrt, lcm
from typing import NamedTuple

from exactsweep.numbers.number import PointRings

IntPair = tuple[int, int]
Squares = tuple[Fraction, Fraction]

_BITS = 128
_LONG = 8192
"""Bits of a root that is not rounded."""
_CUTS = 1000
_MOST_LOOKED_AT = 1_500_000
"""Edges looked at for cuts, in either direction: some seconds."""
_CLOSE = 1 + Fraction(1, 2**32)


class Place(NamedTuple):
    """A point (x / w, y / w) in integers."""

    x: int
    y: int
    w: int = 1


class LoopEdge:
    """An edge of a loop between two points of the lattice, which may be equal."""

    __slots__ = ("a", "b", "bottom", "dx", "dy", "left", "length", "right", "top")

    def __init__(self, a: IntPair, b: IntPair) -> None:
        self.a, self.b = a, b
        self.dx, self.dy = b[0] - a[0], b[1] - a[1]
        self.length = self.dx * self.dx + self.dy * self.dy
        self.left, self.right = sorted((a[0], b[0]))
        self.bottom, self.top = sorted((a[1], b[1]))

    def at(self, t: Fraction) -> Place:
        """Return the place a + t (b - a).

        >>> LoopEdge((0, 0), (2, 1)).at(Fraction(1, 3))
        Place(x=2, y=1, w=3)
        """
        p, q = t.as_integer_ratio()
        return Place(self.a[0] * q + p * self.dx, self.a[1] * q + p * self.dy, q)

    def distance(self, place: Place) -> Fraction:
        """Return the squared distance of a place."""
        (_, _, square), divisor = self.along(place, 0, 0, Fraction(0))
        return Fraction(square, divisor * place.w * place.w)

    def is_beyond(self, bounds: Iterable[tuple[Place, int]]) -> bool:
        """Decide whether its box is farther from a place than a bound, squared, times w^2."""
        for (x, y, w), bound in bounds:
            dx = max(self.left * w - x, x - self.right * w, 0)
            dy = max(self.bottom * w - y, y - self.top * w, 0)
            if dx * dx + dy * dy > bound:
                return True
        return False

    def along(self, place: Place, u: int, v: int, t: Fraction) -> tuple[tuple[int, int, int], int]:
        """Express the squared distance from place + s (u, v) to the feature nearest where s is t.

        Returns the coefficients of s^2, s and 1, times place.w squared, and their divisor.
        """
        p, q = t.as_integer_ratio()
        w = place.w
        x, y = place.x - self.a[0] * w, place.y - self.a[1] * w
        along = (x * q + p * u) * self.dx + (y * q + p * v) * self.dy
        if 0 < along < self.length * q * w:
            off, step = x * self.dy - y * self.dx, u * self.dy - v * self.dx
            return (step * step, 2 * off * step, off * off), self.length
        if along > 0:
            x, y = place.x - self.b[0] * w, place.y - self.b[1] * w
        return (u * u + v * v, 2 * (u * x + v * y), x * x + y * y), 1


class LoopEdges:
    """All edges of some rings, asked for the nearest one."""

    def __init__(self, rings: Iterable[Sequence[IntPair]]) -> None:
        self.edges = [LoopEdge(ring[k - 1], p) for ring in rings for k, p in enumerate(ring)]

    def find_nearest(self, *places: Place) -> tuple[Fraction, LoopEdge]:
        """Find the edge that is nearest to the farthest of some places, and the squared distance.

        Of the ends of a piece, the distance is the right side of (1).
        """
        best, nearest = None, self.edges[0]
        bounds: list[tuple[Place, int]] = []
        for edge in self.edges:
            if edge.is_beyond(bounds):
                continue
            distance = max(map(edge.distance, places))
            if best is None or distance < best:
                best, nearest = distance, edge
                bounds = [(place, floor(best * place.w**2)) for place in places]
        assert best is not None
        # The next place is close as a rule: it begins with this edge.
        self.edges.remove(nearest)
        self.edges.insert(0, nearest)
        return best, nearest


class _PieceEnd(NamedTuple):
    share: Fraction
    near: LoopEdge


def _find_cut(edge: LoopEdge, start: _PieceEnd, end: _PieceEnd) -> Fraction:
    """Find where on a piece of an edge another edge becomes the nearest one, if only about there.

    >>> low, high = LoopEdge((0, 0), (9, 0)), LoopEdge((0, 8), (9, 8))
    >>> ends = _PieceEnd(Fraction(0), low), _PieceEnd(Fraction(1), high)
    >>> _find_cut(LoopEdge((1, 1), (1, 7)), *ends)
    Fraction(1, 2)
    """
    (first, m), (second, n) = (
        near.along(Place(*edge.a), edge.dx, edge.dy, share) for share, near in (start, end)
    )
    square, mixed, constant = (p * n - q * m for p, q in zip(first, second, strict=True))
    roots: list[Fraction] = []
    if square and (discriminant := mixed * mixed - 4 * square * constant) >= 0:
        root, one = isqrt(discriminant << 2 * _BITS), 1 << _BITS
        # The one at which the difference of the squared distances grows.
        roots = [Fraction(root - mixed * one, 2 * square * one)]
    elif mixed and not square:
        roots = [Fraction(-constant, mixed)]
    # Where both run along the edge, as if they were one, they are equally near everywhere.
    (x, y), near = edge.a, (start.near, end.near)
    feet = (
        Fraction((px - x) * edge.dx + (py - y) * edge.dy, edge.length)
        for px, py in chain.from_iterable((other.a, other.b) for other in near)
    )
    shares = (t if t.denominator.bit_length() <= _LONG else _round(t) for t in (*roots, *feet))
    inside = (t for t in shares if start.share < t < end.share)
    return next(inside, (start.share + end.share) / 2)


def _round(value: Fraction) -> Fraction:
    """Round a number to some 128 digits in base 2."""
    p, q = value.as_integer_ratio()
    shift = max(0, _BITS + q.bit_length() - p.bit_length())
    return Fraction((p << shift) // q, 1 << shift)


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
    rings = [*first, *second]
    scale = lcm(*(c.denominator for c in chain.from_iterable(chain.from_iterable(rings))))
    one, other = (
        [[(int(x * scale), int(y * scale)) for x, y in ring] for ring in given]
        for given in (first, second)
    )
    there, back = _bound_one_way(one, other), _bound_one_way(other, one)
    low, high = (max(bounds) / scale**2 for bounds in zip(there, back, strict=True))
    return low, high


def _bound_one_way(
    rings: Sequence[Sequence[IntPair]], target: Sequence[Sequence[IntPair]]
) -> Squares:
    """Bound the greatest squared distance of a point of some rings from others."""
    edges = LoopEdges(target)
    known = {frozenset((edge.a, edge.b)) for edge in edges.edges}
    # The greatest bound first, and then by number.
    pieces: list[tuple[Fraction, int, LoopEdge, _PieceEnd, _PieceEnd]] = []
    number = count()

    def add(edge: LoopEdge, start: _PieceEnd, end: _PieceEnd) -> None:
        bound, _ = edges.find_nearest(edge.at(start.share), edge.at(end.share))
        heappush(pieces, (-bound, next(number), edge, start, end))

    low = Fraction(0)
    for ring in rings:
        found = [edges.find_nearest(Place(*p)) for p in ring]
        low = max(low, *(distance for distance, _ in found))
        for k, b in enumerate(ring):
            if ring[k - 1] != b and frozenset((ring[k - 1], b)) not in known:
                ends = _PieceEnd(Fraction(0), found[k - 1][1]), _PieceEnd(Fraction(1), found[k][1])
                add(LoopEdge(ring[k - 1], b), *ends)
    # A cut looks for one nearest edge and for two bounds, among all.
    for _ in range(min(_CUTS, _MOST_LOOKED_AT // (3 * len(edges.edges)))):
        if not pieces or -pieces[0][0] <= low * _CLOSE:
            break
        _, _, edge, start, end = heappop(pieces)
        t = _find_cut(edge, start, end)
        distance, near = edges.find_nearest(edge.at(t))
        low = max(low, distance)
        add(edge, start, _PieceEnd(t, near))
        add(edge, _PieceEnd(t, near), end)
    return low, max(low, -pieces[0][0]) if pieces else low
