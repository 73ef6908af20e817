"""The exact test whether two shapes overlap when one of them is moved.

Let A and B be closed shapes with connected interiors. Their interiors meet if and only if

(1) two of their edges cross, or run along each other in the same direction; or
(2) some piece of one boundary, between two places at which the boundaries touch, lies in the
    interior of the other shape.

Proof: if no boundary enters the other interior, the interior of A lies in that of B or is disjoint
from it, and vice versa. So the interiors are disjoint or equal. If they are equal, the edges run
along each other in the same direction.

If no edges cross, boundaries touch only in vertices, or from vertex to vertex. So all places that
the test examines are on the lattice, or halfway between two lattice points.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import pairwise
from math import ceil, floor, lcm
from operator import itemgetter
from typing import NamedTuple

from exactsweep.numbers.point import Edge, Point, Rational, Vertex

Rings = Sequence[Sequence[Vertex]]
"""The boundary of a shape: rings with the interior on the left."""

Places = defaultdict[tuple[int, int], set[Vertex]]
"""Points on an edge, by the number of the ring and of the edge in it."""


_COLUMNS = 512


class _BoundedEdge(NamedTuple):
    """An edge with its bounds, and its number in the ring."""

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


class _EdgesByColumn:
    """The edges of a shape by columns of its x-range, for finding those near a place.

    Args:
        rings: the rings, with the interior on the left.
        unbounded: whether all rings are clockwise, so that the shape is unbounded.
    """

    def __init__(self, rings: Rings, *, unbounded: bool = False) -> None:
        self.rings = [list(ring) for ring in rings]
        self.unbounded = unbounded
        self.sides = sorted(_sides(rings))
        self.bounds = _bounds(self.sides)
        count = min(len(self.sides), _COLUMNS)
        self._width = (self.bounds.right - self.bounds.left) // count + 1
        self._columns: list[list[tuple[int, _BoundedEdge]]] = [[] for _ in range(count)]
        for side in self.sides:
            first, last = self._column(side.left), self._column(side.right)
            for column in self._columns[first : last + 1]:
                column.append((first, side))

    def _column(self, x: Rational) -> int:
        return int((x - self.bounds.left) // self._width)

    def near(self, bounds: _Bounds) -> list[_BoundedEdge]:
        """Find the edges whose bounds meet the given ones, column by column, by left end."""
        first = max(self._column(bounds.left), 0)
        last = min(self._column(bounds.right), len(self._columns) - 1)
        return [
            side
            for k in range(first, last + 1)
            for start, side in self._columns[k]
            if (start == k or k == first)
            and side.left <= bounds.right
            and side.right >= bounds.left
            and side.low <= bounds.high
            and side.high >= bounds.low
        ]

    def holds(self, x: Rational, y: Rational, factor: int) -> bool:
        """Decide whether a point, multiplied by a factor, is inside and not on the boundary."""
        # The point lies in the column of its floor, or in the next one.
        k = self._column(x // factor)
        edges = [
            (side.start, side.end)
            for column in range(max(k, 0), min(k + 2, len(self._columns)))
            for first, side in self._columns[column]
            if first == column or column == k or k < 0
        ]
        return _is_between(edges, x, y, factor, self.unbounded)


class Overlap:
    """The test whether a shape overlaps another one moved by t; prepared at the first call.

    Args:
        stationary: the rings of D, the interior on the left. D may have several pieces. It may be
            unbounded, with clockwise rings only.
        orbiting: the rings of G.
        unbounded: whether D is unbounded.
    """

    def __init__(self, stationary: Rings, orbiting: Rings, *, unbounded: bool = False) -> None:
        self._shapes = stationary, orbiting, unbounded
        # Edges that crossed last time are likely to cross again.
        self._last: tuple[_BoundedEdge, _BoundedEdge] | None = None

    @cached_property
    def _fixed(self) -> _EdgesByColumn:
        return _EdgesByColumn(self._shapes[0], unbounded=self._shapes[2])

    @cached_property
    def _moved(self) -> _EdgesByColumn:
        return _EdgesByColumn(self._shapes[1])

    def at(self, t: Point) -> bool:
        """Decide whether the interiors of D and G + t meet.

        Cost: O(m n) at worst, for the edges whose bounds meet, and O(m + n) for each place at which
        the boundaries touch; far less if G + t is near few edges of D.

        >>> square = [[(0, 0), (2, 0), (2, 2), (0, 2)]]
        >>> overlap = Overlap(square, square)
        >>> from fractions import Fraction
        >>> [overlap.at(Point(Fraction(x), Fraction(y))) for x, y in [(0, 0), (1, 1), (2, 1)]]
        [True, True, False]
        """
        x, y = t
        scale = lcm(x.denominator, y.denominator)
        shift = dx, dy = int(x * scale), int(y * scale)
        if self._last is not None and _touch(*self._last, scale, shift) is None:
            return True
        around = self._moved.bounds
        fixed = self._fixed.near(
            _Bounds(
                around.left + floor(x),
                around.right + ceil(x),
                around.low + floor(y),
                around.high + ceil(y),
            )
        )
        touching = self._meet(fixed, floor(x), ceil(x), floor(y), ceil(y), scale, shift)
        if touching is None:
            return True
        on_moved, on_fixed = touching
        moved_rings = dict(enumerate(self._moved.rings))
        # If G + t contains a ring of D, all edges of the ring are near.
        fixed_rings = {k: self._fixed.rings[k] for k in {side.ring for side in fixed}}
        return any(
            self._fixed.holds(px, py, 2 * scale)
            for px, py in find_points_between(moved_rings, on_moved, scale, shift)
        ) or any(
            self._moved.holds(px - 2 * dx, py - 2 * dy, 2 * scale)
            for px, py in find_points_between(fixed_rings, on_fixed, scale)
        )

    def _meet(
        self,
        fixed: Sequence[_BoundedEdge],
        left: int,
        right: int,
        low: int,
        high: int,
        scale: int,
        shift: tuple[int, int],
    ) -> tuple[Places, Places] | None:
        """Find where the boundaries touch, on edges of G and of D; None if they cross.

        The move of G is at least (left, low) and at most (right, high).
        """
        on_moved: Places = defaultdict(set)
        on_fixed: Places = defaultdict(set)
        for f in fixed:
            near = _Bounds(f.left - right, f.right - left, f.low - high, f.high - low)
            for m in self._moved.near(near):
                found = _touch(f, m, scale, shift)
                if found is None:
                    self._last = f, m
                    return None
                if found:
                    on_moved[m.ring, m.number].update(found)
                    on_fixed[f.ring, f.number].update(found)
        return on_moved, on_fixed


def _sides(rings: Rings) -> Iterator[_BoundedEdge]:
    for k, ring in enumerate(rings):
        for i, p in enumerate(ring):
            q = ring[(i + 1) % len(ring)]
            xs, ys = sorted((p[0], q[0])), sorted((p[1], q[1]))
            yield _BoundedEdge(xs[0], xs[1], ys[0], ys[1], p, q, k, i)


def _bounds(sides: Sequence[_BoundedEdge]) -> _Bounds:
    return _Bounds(
        min(map(itemgetter(0), sides)),
        max(map(itemgetter(1), sides)),
        min(map(itemgetter(2), sides)),
        max(map(itemgetter(3), sides)),
    )


def _touch(
    fixed: _BoundedEdge, moved: _BoundedEdge, scale: int, shift: tuple[int, int]
) -> list[Vertex] | None:
    (ax, ay), (bx, by), (px, py), (qx, qy) = fixed.start, fixed.end, moved.start, moved.end
    sx, sy = shift
    return touch(
        (ax * scale, ay * scale),
        (bx * scale, by * scale),
        (px * scale + sx, py * scale + sy),
        (qx * scale + sx, qy * scale + sy),
    )


def touch(a: Vertex, b: Vertex, p: Vertex, q: Vertex) -> list[Vertex] | None:
    """Return the ends of the common part of edges a b and p q, or None if their left sides meet.

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
    # The edges are not parallel and meet in one point, an end of one of them.
    return [a if of_a == 0 else b if of_b == 0 else p if of_p == 0 else q]


def find_points_between(
    rings: Mapping[int, Sequence[Vertex]],
    places: Places,
    scale: int = 1,
    shift: Vertex = (0, 0),
) -> Iterator[Vertex]:
    """Yield a point, times two, of each piece of the rings between places, or one vertex.

    The rings are first enlarged by the scale and then moved by the shift. The places are on the
    moved rings. Pieces on edges without places belong to pieces on edges with places, so the
    function examines the latter only. Without places it yields a vertex.

    Cost: O(p log p + r) for p places and r rings.
    """
    dx, dy = shift
    found: set[int] = set()
    for (k, i), on_edge in places.items():
        if not on_edge:
            continue
        found.add(k)
        ring = rings[k]
        ends = {(x * scale + dx, y * scale + dy) for x, y in (ring[i], ring[(i + 1) % len(ring)])}
        along = sorted(ends | on_edge)
        yield from ((ax + bx, ay + by) for (ax, ay), (bx, by) in pairwise(along))
    for k in rings.keys() - found:
        x, y = rings[k][0]
        yield 2 * (x * scale + dx), 2 * (y * scale + dy)


def is_inside(doubled: Vertex, rings: Rings) -> bool:
    """Decide whether a point, multiplied by two, is an inner point of a shape. Cost: O(n).

    >>> square = [[(0, 0), (2, 0), (2, 2), (0, 2)]]
    >>> is_inside((1, 1), square), is_inside((4, 1), square)
    (True, False)
    """
    return is_inside_edges(doubled, (e for ring in rings for e in pairwise((*ring, ring[0]))))


def is_inside_edges(doubled: Vertex, edges: Iterable[Edge]) -> bool:
    """Decide whether a point, multiplied by two, is inside the edges of a shape.

    Edges that do not meet the vertical line through the point may be left out. Cost: O(n).

    >>> is_inside_edges((1, 1), [((0, 0), (2, 0)), ((2, 2), (0, 2))])
    True
    """
    return _is_between(edges, *doubled, 2, False)


def _is_between(edges: Iterable[Edge], x: Rational, y: Rational, factor: int, inside: bool) -> bool:
    """Decide whether a point on no edge is inside, by the parity of the edges above it.

    `inside` says whether points above all edges are inside. Each edge changes the side.
    """
    for (px, py), (qx, qy) in edges:
        ax, bx = px * factor - x, qx * factor - x
        if (ax > 0) != (bx > 0):
            ay, by = py * factor - y, qy * factor - y
            turn = ax * by - ay * bx
            if turn == 0:
                return False
            if (turn < 0) == (bx > ax):
                inside = not inside
        elif bx == 0:
            # A vertex counts as the end of the edge before it.
            ay, by = py * factor - y, qy * factor - y
            if by == 0 or (ax == 0 and (ay < 0) != (by < 0)):
                return False
    return inside
