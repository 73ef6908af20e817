"""The Hausdorff distance of two loops: how far a point of one can be from all of the other.

Loops are taken as curves, not as the regions inside, so that a notch filled or a hole forgotten
counts with its depth.  The distance is the greater of two, from each loop to the other one.

Bounds.  Let e be a piece of an edge of one loop, and f_j(p) the squared distance of a point p to
edge j of the other.  A segment is convex, so is the distance to it, and so f_j is greatest on e at
an end of e.  The squared distance to the whole loop is f = min_j f_j.  Hence on e

    max(f(a), f(b))  <=  max f  <=  min_j max(f_j(a), f_j(b)),       a and b the ends of e.

Where one edge is nearest to both ends, both sides are equal, and the maximum is known exactly.
Otherwise e is cut in two.  The maximum of f over a loop need not be at a vertex; inside e it is
where two edges are equally near, and e is cut there where possible: f_j is quadratic in the place
on e as long as the nearest feature of edge j stays the same, and the place is a root of the
difference, or, for edges that continue each other along e, the foot of an end.  Roots may be
irrational; they are rounded, and the bounds do not mind where e is cut.
The piece with the greatest upper bound is cut first; once that bound is no greater than the
greatest value found, the latter is the maximum.  If that does not happen before the two are close,
they are returned as they are.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from heapq import heappop, heappush
from itertools import count
from math import lcm

from exactsweep.conform.segment import Edges, Pair, Place, Segment, equally_near
from exactsweep.polygon import Point

Squares = tuple[Fraction, Fraction]
Rings = Sequence[Sequence[Point]]
_End = tuple[Fraction, Segment]  # of a piece: the share of its edge, and an edge nearest to it

_CUTS = 1000
_CLOSE = 1 + Fraction(1, 2**32)


def distance_squared(first: Rings, second: Rings) -> Squares:
    """Bound the square of the Hausdorff distance of two sets of rings.

    Args:
        first: rings, each a sequence of Point, not closed; at least one vertex in all.
        second: likewise.

    Returns:
        (low, high), Fractions with low <= distance squared <= high: equal where the maximum is
        found exactly, as it is wherever it is at a vertex; otherwise less than one part in 2^32
        apart, unless 1000 cuts do not lead there.

    Cost: O((m + n + c) (m + n)) operations on rationals for c cuts.

    Example:
        >>> square = [Point(Fraction(x), Fraction(y)) for x, y in [(0, 0), (4, 0), (4, 4), (0, 4)]]
        >>> dented = [*square[:3], Point(Fraction(2), Fraction(1)), square[3]]
        >>> distance_squared([square], [dented])
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


def _one_way(rings: Sequence[Sequence[Pair]], target: Sequence[Sequence[Pair]]) -> Squares:
    """Bounds of the greatest squared distance of a point of some rings to others."""
    edges = Edges(target)
    pieces: list[tuple[Fraction, int, Segment, _End, _End]] = []
    number = count()

    def add(edge: Segment, start: _End, end: _End) -> None:
        # The heap gives the least first.
        bound = edges.upper_bound(edge.at(start[0]), edge.at(end[0]), (start[1], end[1]))
        heappush(pieces, (-bound, next(number), edge, start, end))

    low = Fraction(0)
    for ring in rings:
        found = [edges.nearest(Place(x, y, 1)) for x, y in ring]
        low = max(low, *(distance for distance, _ in found))
        for k, b in enumerate(ring):
            edge = Segment(ring[k - 1], b)
            if edge.length and not edges.has(edge):
                add(edge, (Fraction(0), found[k - 1][1]), (Fraction(1), found[k][1]))
    for _ in range(_CUTS):
        if not pieces or -pieces[0][0] <= low * _CLOSE:
            break
        _, _, edge, start, end = heappop(pieces)
        t = equally_near(edge, start[0], end[0], start[1], end[1])
        distance, near = edges.nearest(edge.at(t))
        low = max(low, distance)
        add(edge, start, (t, near))
        add(edge, (t, near), end)
    return low, max(low, -pieces[0][0]) if pieces else low
