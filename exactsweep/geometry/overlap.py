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

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from enum import Enum
from functools import cached_property
from itertools import chain, pairwise
from math import inf, lcm
from operator import itemgetter
from typing import Any

from exactsweep.numbers.number import Point, Rational, Vertex

Rings = Sequence[Sequence[Vertex]]
"""The boundary of a shape: rings with the interior on the left."""

Places = defaultdict[tuple[int, int], set[Vertex]]
"""Points on an edge, by the number of the ring and of the edge in it."""

Bounds = tuple[Any, Any, Any, Any]
"""The left, right, low and high end of a box."""

BoxedEdge = tuple[
    Rational, Rational, Rational, Rational, Rational, Rational, Rational, Rational, int, int
]
"""An edge: its box, its ends (ax, ay) and (bx, by), the number of its ring, its number there."""

_FEW = 24
"""The number of edges up to which a search examines all of them."""
_MOST_COLUMNS = 512


class Relation(Enum):
    """The relation of two shapes."""

    APART = "apart"
    CONTACT = "contact"
    OVERLAP = "overlap"


class EdgeIndex:
    """The boundary of a shape, for look-ups of the edges near a place.

    Args:
        rings: the rings, with the interior on the left.
        unbounded: whether the shape has all points outside the rings.
    """

    def __init__(self, rings: Rings, *, unbounded: bool = False) -> None:
        self.rings = rings
        self.unbounded = unbounded

    @cached_property
    def box(self) -> Bounds:
        """The bounds of the shape."""
        if self.unbounded:
            return -inf, inf, -inf, inf
        xs, ys = zip(*chain.from_iterable(self.rings), strict=True)
        return min(xs), max(xs), min(ys), max(ys)

    @cached_property
    def edges(self) -> list[BoxedEdge]:
        """The edges, by the left ends of their boxes."""
        found = []
        for k, ring in enumerate(self.rings):
            ax, ay = ring[-1]
            for i, (bx, by) in enumerate(ring):
                left, right = (ax, bx) if ax < bx else (bx, ax)
                low, high = (ay, by) if ay < by else (by, ay)
                number = (i or len(ring)) - 1
                found.append((left, right, low, high, ax, ay, bx, by, k, number))
                ax, ay = bx, by
        found.sort()
        return found

    @cached_property
    def _lefts(self) -> list[Rational]:
        return [edge[0] for edge in self.edges]

    @cached_property
    def _columns(self) -> tuple[Rational, list[tuple[list[BoxedEdge], int]]]:
        """The width of columns, and for each its edges, and the edges that start before its end."""
        edges, lefts = self.edges, self._lefts
        count = min(len(edges), _MOST_COLUMNS)
        start = lefts[0]
        width = (max(edge[1] for edge in edges) - start) // count + 1
        columns: list[list[BoxedEdge]] = [[] for _ in range(count)]
        for edge in edges:
            first, last = (edge[0] - start) // width, (edge[1] - start) // width
            for column in columns[first : last + 1]:
                column.append(edge)
        ends = (bisect_left(lefts, start + k * width) for k in range(1, count + 1))
        return width, list(zip(columns, ends, strict=True))

    def _between(self, left: Rational, right: Rational) -> list[BoxedEdge]:
        """List edges by their left ends, all that meet an x-range among them."""
        edges = self.edges
        if len(edges) <= _FEW:
            return edges
        lefts, (width, columns) = self._lefts, self._columns
        k = min(max((left - lefts[0]) // width, 0), len(columns) - 1)
        column, end = columns[k]
        return column + edges[end : bisect_right(lefts, right)]

    def near(self, box: Bounds) -> list[BoxedEdge]:
        """Return the edges whose boxes meet a box, by their left ends.

        Cost: O(log n) and O(1) for each edge that meets the x-range or the column of its left end.
        """
        left, right, low, high = box
        return [
            edge
            for edge in self._between(left, right)
            if edge[0] <= right and edge[1] >= left and edge[2] <= high and edge[3] >= low
        ]

    def holds(self, x: Rational, y: Rational, factor: int) -> bool:
        """Decide whether a point, multiplied by a factor, is inside and not on the boundary.

        Cost: as for `near`.
        """
        if not self.unbounded:
            left, right, low, high = self.box
            if not (factor * left < x < factor * right and factor * low < y < factor * high):
                return False
        edges = self._between(x // factor, -(-x // factor))
        return _is_between((edge[4:8] for edge in edges), x, y, factor, self.unbounded)


_CrossingEdges = tuple[int, int, int, int]
"""Two edges that cross, each by the number of its ring and its number there."""


def relate(
    a: EdgeIndex, b: EdgeIndex, x: Rational, y: Rational, scale: int = 1
) -> tuple[Relation, _CrossingEdges | None]:
    """Find the relation of two shapes, the second one moved by (x / scale, y / scale).

    All crossings of edges, all places where boundaries touch, and all points of both interiors lie
    in the intersection of the two boxes, the *window*. So the function examines the window only.

    Args:
        a: a shape; it may have several pieces, and it may be unbounded.
        b: a bounded shape with a connected interior.
        x: the move in x.
        y: the move in y.
        scale: the divisor of the move.

    Returns:
        The relation, and two edges that cross, if it found any.

    Cost: O(k log k) for k edges that meet the window, O(1) for each two of them that meet along its
    longer side, and that of `EdgeIndex.holds` for each place at which the boundaries touch.
    """
    x0, x1, y0, y1 = x // scale, -(-x // scale), y // scale, -(-y // scale)
    (left, right, low, high), (west, east, south, north) = a.box, b.box
    west, east, south, north = west + x0, east + x1, south + y0, north + y1
    left, right = left if left > west else west, right if right < east else east
    low, high = low if low > south else south, high if high < north else north
    if left > right or low > high:
        return Relation.APART, None
    window = left, right, low, high
    ours = a.near(window)
    theirs = b.near((left - x1, right - x0, low - y1, high - y0)) if ours else []
    near, waiting, axis = ours, [], 2 if high - low > right - left else 0
    if len(ours) > _FEW:
        # A sweep along the longer side of the window.
        start = itemgetter(axis)
        theirs.sort(key=start)
        near, waiting = [], sorted(ours, key=start, reverse=True)
    on_a: Places = defaultdict(set)
    on_b: Places = defaultdict(set)
    # The middle of a common piece of both boundaries, times two, is inside neither.
    middles: set[Vertex] = set()
    for west, east, south, north, ax, ay, bx, by, ring, number in theirs:
        west, east, south, north = west + x0, east + x1, south + y0, north + y1
        if scale != 1:
            ax, ay, bx, by = ax * scale, ay * scale, bx * scale, by * scale
        ax, ay, bx, by = ax + x, ay + y, bx + x, by + y
        if near is not ours:
            begin, end = (south, north) if axis else (west, east)
            while waiting and waiting[-1][axis] <= end:
                near.append(waiting.pop())
            near = [edge for edge in near if edge[axis + 1] >= begin]
        for left, right, low, high, px, py, qx, qy, k, i in near:
            if left > east or right < west or low > north or high < south:
                continue
            if scale != 1:
                px, py, qx, qy = px * scale, py * scale, qx * scale, qy * scale
            # Most edges are on one side of the other edge.
            dx, dy = qx - px, qy - py
            of_a = dx * (ay - py) - dy * (ax - px)
            of_b = dx * (by - py) - dy * (bx - px)
            if (of_a > 0 < of_b) or (of_a < 0 > of_b):
                continue
            shared = touch((ax, ay), (bx, by), (px, py), (qx, qy))
            if shared is None:
                return Relation.OVERLAP, (k, i, ring, number)
            if shared:
                on_a[k, i].update(shared)
                on_b[ring, number].update(shared)
                middles.add((shared[0][0] + shared[-1][0], shared[0][1] + shared[-1][1]))
    if not on_a and not a.unbounded and window != a.box and _leaves(b.box, a.box, x1, x0, y1, y0):
        return Relation.APART, None
    unit = 2 * scale
    left, right, low, high = (unit * end for end in window)
    for mine, others, edges, places, shift, back in (
        (a, b, ours, on_a, (0, 0), (2 * x, 2 * y)),
        (b, a, theirs, on_b, (x, y), (0, 0)),
    ):
        rings = {k: mine.rings[k] for k in {edge[8] for edge in edges} or {0}}
        dx, dy = back
        for px, py in find_points_between(rings, places, scale, shift):
            if (
                left <= px <= right
                and low <= py <= high
                and (px, py) not in middles
                and others.holds(px - dx, py - dy, unit)
            ):
                return Relation.OVERLAP, None
    return Relation.CONTACT if on_a else Relation.APART, None


def _leaves(inner: Bounds, outer: Bounds, x1: int, x0: int, y1: int, y0: int) -> bool:
    """Decide whether a box, moved by (x0, y0) to (x1, y1), is not inside another one."""
    left, right, low, high = outer
    west, east, south, north = inner
    return bool(west + x1 < left or east + x0 > right or south + y1 < low or north + y0 > high)


class Overlap:
    """The test whether a shape overlaps another one moved by t.

    Args:
        stationary: the rings of D, the interior on the left. D may have several pieces. It may be
            unbounded, with clockwise rings only.
        orbiting: the rings of G.
        unbounded: whether D is unbounded.
    """

    def __init__(self, stationary: Rings, orbiting: Rings, *, unbounded: bool = False) -> None:
        self._shapes = EdgeIndex(stationary, unbounded=unbounded), EdgeIndex(orbiting)
        # Edges that crossed last time are likely to cross again.
        self._last: _CrossingEdges | None = None

    def at(self, t: Point) -> bool:
        """Decide whether the interiors of D and G + t meet.

        Cost: that of `relate`, or O(1) if the edges that crossed last time cross again.

        >>> square = [[(0, 0), (2, 0), (2, 2), (0, 2)]]
        >>> overlap = Overlap(square, square)
        >>> from fractions import Fraction
        >>> [overlap.at(Point(Fraction(x), Fraction(y))) for x, y in [(0, 0), (1, 1), (2, 1)]]
        [True, True, False]
        """
        (n, d), (m, e) = t.x.as_integer_ratio(), t.y.as_integer_ratio()
        scale = lcm(d, e)
        x, y = n * (scale // d), m * (scale // e)
        if self._last is not None:
            k, i, j, h = self._last
            fixed, moved = self._shapes[0].rings[k], self._shapes[1].rings[j]
            edge = [(u * scale, v * scale) for u, v in (fixed[i], fixed[i + 1 - len(fixed)])]
            other = moved[h], moved[h + 1 - len(moved)]
            if touch(*edge, *((u * scale + x, v * scale + y) for u, v in other)) is None:
                return True
        relation, crossing = relate(*self._shapes, x, y, scale)
        self._last = crossing or self._last
        return relation is Relation.OVERLAP


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
    edges = ((*p, *q) for ring in rings for p, q in pairwise((*ring, ring[0])))
    return _is_between(edges, *doubled, 2, False)


def _is_between(
    edges: Iterable[tuple[Rational, Rational, Rational, Rational]],
    x: Rational,
    y: Rational,
    factor: int,
    inside: bool,
) -> bool:
    """Decide whether a point on no edge is inside, by the parity of the edges above it.

    `inside` says whether points above all edges are inside. Each edge changes the side.
    """
    for px, py, qx, qy in edges:
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
