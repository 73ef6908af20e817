"""Whether two shapes overlap when one of them is moved: decided exactly, touching or not.

Let A and B be closed shapes, interiors connected. Their interiors meet exactly if

(1) two of their edges cross, or run along each other in the same direction; or else
(2) some piece of one boundary, between two places at which the boundaries touch, lies in the
    interior of the other shape.

For if no boundary enters the other interior, the interior of A lies in that of B or is disjoint
from it, and likewise the other way round: the two are disjoint or the same set, and of the same set
the edges run along each other in the same direction.

Without a crossing, boundaries touch in vertices only, or from vertex to vertex, so that all places
that have to be looked at are on the lattice, or halfway between two points of it.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import ceil, floor, lcm
from operator import itemgetter
from typing import NamedTuple

from exactsweep.geometry.point import Point, Rational, Vertex

Rings = Sequence[Sequence[Vertex]]
"""The boundary of a shape: rings that have its interior on the left."""

Places = defaultdict[tuple[int, int], set[Vertex]]
"""For the numbers of a ring and of an edge of it, points on the edge."""


class _Side(NamedTuple):
    """An edge, with its bounds and its number in its ring."""

    left: Rational
    right: Rational
    low: Rational
    high: Rational
    start: Vertex
    end: Vertex
    ring: int
    number: int


class _Bounds(NamedTuple):
    left: Rational
    right: Rational
    low: Rational
    high: Rational


class Overlap:
    """Whether a shape overlaps another one when it is moved by t.

    Args:
        stationary: the rings of D, the interior on the left. D may have several pieces, and may be
            unbounded: what is left of clockwise rings alone.
        orbiting: the rings of G.
        unbounded: whether D is.
    """

    def __init__(self, stationary: Rings, orbiting: Rings, *, unbounded: bool = False) -> None:
        self._stationary = [list(ring) for ring in stationary]
        self._orbiting = [list(ring) for ring in orbiting]
        self._unbounded = unbounded
        self._fixed = sorted(_sides(stationary))
        self._moved = sorted(_sides(orbiting))
        self._fixed_bounds = _bounds(self._fixed)
        self._moved_bounds = _bounds(self._moved)
        # Where edges crossed last time they are likely to cross again.
        self._last: tuple[_Side, _Side] | None = None

    def at(self, t: Point) -> bool:
        """Whether the interiors of D and G + t meet.

        Cost: O(m n) at worst, for the edges whose bounds meet.

        >>> square = [[(0, 0), (2, 0), (2, 2), (0, 2)]]
        >>> overlap = Overlap(square, square)
        >>> from fractions import Fraction
        >>> [overlap.at(Point(Fraction(x), Fraction(y))) for x, y in [(0, 0), (1, 1), (2, 1)]]
        [True, True, False]
        """
        x, y = t
        scale = lcm(x.denominator, y.denominator)
        shift = int(x * scale), int(y * scale)
        if self._last is not None and _touch(*self._last, scale, shift) is None:
            return True
        touching = self._meet(floor(x), ceil(x), floor(y), ceil(y), scale, shift)
        if touching is None:
            return True
        on_moved, on_fixed = touching
        fixed = [[(px * scale, py * scale) for px, py in ring] for ring in self._stationary]
        sx, sy = shift
        moved = [[(px * scale + sx, py * scale + sy) for px, py in r] for r in self._orbiting]
        return any(
            is_inside(point, other, unbounded=unbounded)
            for rings, places, other, unbounded in (
                (moved, on_moved, fixed, self._unbounded),
                (fixed, on_fixed, moved, False),
            )
            for point in points_between(rings, places)
        )

    def _meet(
        self, left: int, right: int, low: int, high: int, scale: int, shift: tuple[int, int]
    ) -> tuple[Places, Places] | None:
        """Where the boundaries touch, on edges of G and of D; None if they cross.

        G is moved by at least (left, low) and at most (right, high).
        """
        a, b = self._fixed_bounds, self._moved_bounds
        fixed = [
            s
            for s in self._fixed
            if s.left <= b.right + right
            and s.right >= b.left + left
            and s.low <= b.high + high
            and s.high >= b.low + low
        ]
        moved = [
            s
            for s in self._moved
            if s.left + left <= a.right
            and s.right + right >= a.left
            and s.low + low <= a.high
            and s.high + high >= a.low
        ]
        on_moved: Places = defaultdict(set)
        on_fixed: Places = defaultdict(set)
        begin = 0
        widest = max((s.right - s.left for s in fixed), default=0)
        for m in moved:
            m_left, m_right, m_low, m_high = (
                m.left + left,
                m.right + right,
                m.low + low,
                m.high + high,
            )
            while begin < len(fixed) and fixed[begin].left < m_left - widest:
                begin += 1
            for k in range(begin, len(fixed)):
                f = fixed[k]
                if f.left > m_right:
                    break
                if f.right < m_left or f.low > m_high or f.high < m_low:
                    continue
                found = _touch(f, m, scale, shift)
                if found is None:
                    self._last = f, m
                    return None
                if found:
                    on_moved[m.ring, m.number].update(found)
                    on_fixed[f.ring, f.number].update(found)
        return on_moved, on_fixed


def _sides(rings: Rings) -> Iterator[_Side]:
    for k, ring in enumerate(rings):
        for i, p in enumerate(ring):
            q = ring[(i + 1) % len(ring)]
            xs, ys = sorted((p[0], q[0])), sorted((p[1], q[1]))
            yield _Side(xs[0], xs[1], ys[0], ys[1], p, q, k, i)


def _bounds(sides: Sequence[_Side]) -> _Bounds:
    return _Bounds(
        min(map(itemgetter(0), sides)),
        max(map(itemgetter(1), sides)),
        min(map(itemgetter(2), sides)),
        max(map(itemgetter(3), sides)),
    )


def _touch(fixed: _Side, moved: _Side, scale: int, shift: tuple[int, int]) -> list[Vertex] | None:
    (ax, ay), (bx, by), (px, py), (qx, qy) = fixed.start, fixed.end, moved.start, moved.end
    sx, sy = shift
    return touch(
        (ax * scale, ay * scale),
        (bx * scale, by * scale),
        (px * scale + sx, py * scale + sy),
        (qx * scale + sx, qy * scale + sy),
    )


def touch(a: Vertex, b: Vertex, p: Vertex, q: Vertex) -> list[Vertex] | None:
    """The ends of what the edges a b and p q share, or None if their left sides meet.

    Args:
        a: start of an edge, the interior of its shape on the left.
        b: its end.
        p: start of the other edge.
        q: its end.

    Returns:
        No point, one or two; None if the edges cross, or run along each other in one direction.

    Cost: O(1).

    >>> touch((0, 0), (2, 0), (1, 0), (1, 2)), touch((0, 0), (2, 0), (3, 0), (1, 0))
    ([(1, 0)], [(1, 0), (2, 0)])
    >>> touch((0, 0), (2, 0), (1, 0), (3, 0)) is None
    True
    """
    (ax, ay), (bx, by), (px, py), (qx, qy) = a, b, p, q
    dx, dy, ex, ey = bx - ax, by - ay, qx - px, qy - py
    of_a = ex * (ay - py) - ey * (ax - px)
    of_b = ex * (by - py) - ey * (bx - px)
    if (of_a > 0 and of_b > 0) or (of_a < 0 and of_b < 0):
        return []
    of_p = dx * (py - ay) - dy * (px - ax)
    of_q = dx * (qy - ay) - dy * (qx - ax)
    if (of_p > 0 and of_q > 0) or (of_p < 0 and of_q < 0):
        return []
    if of_a == 0 == of_b:
        low, high = max(min(a, b), min(p, q)), min(max(a, b), max(p, q))
        if low > high:
            return []
        if low < high and (a < b) == (p < q):
            return None
        return [low, high]
    if of_a and of_b and of_p and of_q:
        return None
    # They are not parallel and meet in one point, an end of one of them.
    return [a if of_a == 0 else b if of_b == 0 else p if of_p == 0 else q]


def points_between(rings: Rings, places: Places) -> Iterator[Vertex]:
    """A point, times two, of each piece of the rings between places; a vertex if there are none."""
    for k, ring in enumerate(rings):
        found = False
        for i, p in enumerate(ring):
            on_edge = places.get((k, i))
            if not on_edge:
                continue
            found = True
            q = ring[(i + 1) % len(ring)]
            along = sorted({p, q, *on_edge}, reverse=q < p)
            yield from ((ax + bx, ay + by) for (ax, ay), (bx, by) in pairwise(along))
        if not found:
            x, y = ring[0]
            yield 2 * x, 2 * y


def is_inside(doubled: Vertex, rings: Rings, *, unbounded: bool = False) -> bool:
    """Whether a point, given times two, is inside a shape, not on its boundary. Cost: O(n).

    >>> square = [[(0, 0), (2, 0), (2, 2), (0, 2)]]
    >>> is_inside((1, 1), square), is_inside((4, 1), square)
    (True, False)
    """
    x, y = doubled
    inside = unbounded
    for ring in rings:
        ax, ay = ring[-1]
        ax, ay = 2 * ax - x, 2 * ay - y
        for bx, by in ring:
            bx, by = 2 * bx - x, 2 * by - y
            if (ay > 0) != (by > 0):
                turn = ax * by - ay * bx
                if turn == 0:
                    return False
                # The edge passes the point on the right, whichever way it runs.
                if (turn > 0) == (by > ay):
                    inside = not inside
            elif (ay == 0 == by and (ax <= 0 <= bx or bx <= 0 <= ax)) or ax == ay == 0:
                return False
            ax, ay = bx, by
    return inside
