"""Bounds on the Hausdorff distance of loops.

Loops are curves here, so a filled notch counts with its depth. Let e be a piece of an edge of one
loop, with ends a and b, and f_j(p) the squared distance of a point p from edge j of the other;
f = min_j f_j. An edge is convex, so f_j is greatest on e at an end of e, and

    (1)  max(f(a), f(b))  <=  max f on e  <=  max(f_j(a), f_j(b))  for each j.

The search uses the right side for the edges nearest to a and to b; if one edge is nearest to both,
(1) is an equality. Otherwise it cuts e: at the foot of an end of these two edges, so that vertices
along a line cost no accuracy, or else in the middle. The piece with the greatest upper bound comes
first; the search ends when that bound is equal or close to the greatest value found.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from heapq import heappop, heappush
from itertools import chain, count
from math import floor, lcm
from typing import NamedTuple

from exactsweep.geometry.distance import measure_to_edge
from exactsweep.numbers.number import PointRings

IntPair = tuple[int, int]
Squares = tuple[Fraction, Fraction]

_MOST_CUTS = 1000
_MOST_LOOKED_AT = 1_500_000
"""Edges examined for cuts, in either direction: a few seconds."""
_CLOSE = 1 + Fraction(1, 2**32)


class Place(NamedTuple):
    """A point (x / w, y / w) in integers."""

    x: int
    y: int
    w: int = 1


class LoopEdge:
    """An edge of a loop between two lattice points, which may be equal."""

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

    def find_foot(self, p: IntPair) -> Fraction:
        """Return the parameter of the foot of the perpendicular from a point."""
        along = (p[0] - self.a[0]) * self.dx + (p[1] - self.a[1]) * self.dy
        return Fraction(along, self.length)

    def distance(self, place: Place) -> Fraction:
        """Return the squared distance of a place."""
        x, y, w = place
        (ax, ay), (bx, by) = self.a, self.b
        n, d = measure_to_edge((x, y), ((ax * w, ay * w), (bx * w, by * w)))
        return Fraction(int(n), int(d) * w * w)


class _PieceEnd(NamedTuple):
    """An end of a piece: its parameter, its position and the nearest edge of the other loop."""

    t: Fraction
    place: Place
    near: LoopEdge


def _find_cut(edge: LoopEdge, start: _PieceEnd, end: _PieceEnd) -> Fraction:
    """Return the parameter at which a piece of an edge is cut.

    >>> low, high = LoopEdge((0, 0), (4, 0)), LoopEdge((4, 0), (9, 0))
    >>> edge = LoopEdge((0, 1), (10, 1))
    >>> ends = (_PieceEnd(Fraction(t), edge.at(Fraction(t)), e) for t, e in ((0, low), (1, high)))
    >>> _find_cut(edge, *ends)
    Fraction(2, 5)
    """
    near = chain.from_iterable((other.a, other.b) for other in (start.near, end.near))
    feet = (t for t in map(edge.find_foot, near) if start.t < t < end.t)
    return next(feet, (start.t + end.t) / 2)


def bound_distance(first: PointRings, second: PointRings) -> Squares:
    """Bound the square of the Hausdorff distance of two sets of rings.

    Args:
        first: rings, each a sequence of Point, not closed; at least one vertex in all.
        second: likewise.

    Returns:
        (low, high) with low <= distance squared <= high. They differ by less than one part in 2^32,
        unless that takes more than 1000 cuts, or fewer for more than 1500 edges.

    Cost: O((m + n + c) (m + n)) operations on rationals for c cuts.

    Example:
        >>> from exactsweep import Point
        >>> square = [Point(Fraction(x), Fraction(y)) for x, y in [(0, 0), (4, 0), (4, 4), (0, 4)]]
        >>> dented = [*square[:3], Point(Fraction(2), Fraction(1)), square[3]]
        >>> low, high = bound_distance([square], [dented])
        >>> float(low), high <= low * (1 + Fraction(1, 2**32))
        (2.769230769230769, True)
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


def _find_nearest(place: Place, edges: list[LoopEdge]) -> tuple[Fraction, LoopEdge]:
    """Find the nearest edge and its squared distance, and move it to the front."""
    nearest, (x, y, w) = edges[0], place
    best = nearest.distance(place)
    bound = floor(best * w * w)
    for edge in edges:
        dx = max(edge.left * w - x, x - edge.right * w, 0)
        dy = max(edge.bottom * w - y, y - edge.top * w, 0)
        if dx * dx + dy * dy <= bound and (distance := edge.distance(place)) < best:
            best, nearest = distance, edge
            bound = floor(best * w * w)
    # The next place is usually close, so its search begins with this edge.
    edges.remove(nearest)
    edges.insert(0, nearest)
    return best, nearest


def _bound_one_way(
    rings: Sequence[Sequence[IntPair]], target: Sequence[Sequence[IntPair]]
) -> Squares:
    """Bound the greatest squared distance of a point of some rings from others."""
    edges = [LoopEdge(ring[k - 1], p) for ring in target for k, p in enumerate(ring)]
    known = {frozenset((edge.a, edge.b)) for edge in edges}
    low, number = Fraction(0), count()
    # The greatest bound first, and then by number.
    pieces: list[tuple[Fraction, int, LoopEdge, _PieceEnd, _PieceEnd]] = []

    def look(place: Place) -> LoopEdge:
        nonlocal low
        distance, near = _find_nearest(place, edges)
        low = max(low, distance)
        return near

    def add(edge: LoopEdge, start: _PieceEnd, end: _PieceEnd) -> None:
        bound = min(
            max(near.distance(start.place), near.distance(end.place))
            for near in (start.near, end.near)
        )
        heappush(pieces, (-bound, next(number), edge, start, end))

    for ring in rings:
        near = [look(Place(*p)) for p in ring]
        for k, b in enumerate(ring):
            edge = LoopEdge(ring[k - 1], b)
            if edge.length and frozenset((edge.a, edge.b)) not in known:
                ends = ((0, edge.a, near[k - 1]), (1, b, near[k]))
                add(edge, *(_PieceEnd(Fraction(t), Place(*p), other) for t, p, other in ends))
    for _ in range(min(_MOST_CUTS, _MOST_LOOKED_AT // len(edges))):
        if not pieces or -pieces[0][0] <= low * _CLOSE:
            break
        _, _, edge, start, end = heappop(pieces)
        t = _find_cut(edge, start, end)
        cut = _PieceEnd(t, edge.at(t), look(edge.at(t)))
        add(edge, start, cut)
        add(edge, cut, end)
    return low, max(low, -pieces[0][0]) if pieces else low
