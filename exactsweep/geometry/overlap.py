"""The relation of two shapes when one of them is moved: overlap, contact, or apart.

Let D and G be shapes with connected interiors, the second one moved. At a vertex or inside an edge,
the boundary of a shape has a *cone* on its left: from the ray that leaves to the ray that arrives,
counter-clockwise. Where several rings touch, the shape is the intersection of their cones.

(1) Interiors meet if two edges cross; or if both shapes have a direction at a common point of the
    boundaries: a ray of one shape lies inside all cones of the other, or two edges run along each
    other in one direction. Otherwise, let the boundaries have a common point, on a ring R of G.
    Then D stays on that side of R on which it touches R, and the interiors are disjoint.
(2) If the boundaries are disjoint, interiors meet if and only if a ring of one shape lies inside
    the other shape. One vertex of the ring decides that.

A path is a ring that runs forth and back, or two such rings. Its cones are empty, because each of
its rays leaves and arrives; its interior is the path itself.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from enum import Enum
from functools import cached_property
from itertools import chain, pairwise
from typing import Any

from exactsweep.geometry.near import BoxRows
from exactsweep.geometry.vectors import cross, minus, turn
from exactsweep.numbers.number import Edge, Rational, Vertex

Rings = Sequence[Sequence[Vertex]]
"""The boundary of a shape: rings with the interior on the left."""

Places = defaultdict[tuple[int, int], set[Vertex]]
"""Points on an edge, by the number of the ring and of the edge in it."""

Bounds = tuple[Any, Any, Any, Any]
"""The left, right, low and high end of a box."""

BoxedEdge = tuple[int, int, int, int, Rational, Rational, Rational, Rational, int, int]
"""An edge: its box, rounded outwards to ints; its ends (ax, ay) and (bx, by); the number of its
ring, and its number there."""

_MovedEdge = tuple[Rational, Rational, Rational, Rational, Vertex, Vertex, BoxedEdge]
"""An edge on the lattice of a position: its box, its ends, and the edge itself."""

_Cone = tuple[Vertex, Vertex]
"""The rays that leave and arrive at a point of a boundary."""

_FEW = 64
"""The number of edges up to which a search examines all of them."""


class Relation(Enum):
    """The relation of two shapes."""

    APART = "apart"
    CONTACT = "contact"
    OVERLAP = "overlap"


class Boundary:
    """The boundary of a shape or of a path, for searches of the edges near a place.

    Args:
        rings: the rings, with the interior on the left.
    """

    def __init__(self, rings: Rings) -> None:
        self.rings = rings

    @cached_property
    def box(self) -> Bounds:
        """The bounds of the shape."""
        xs, ys = zip(*chain.from_iterable(self.rings), strict=True)
        return min(xs), max(xs), min(ys), max(ys)

    @cached_property
    def is_path(self) -> bool:
        """Whether the rings enclose no area."""
        return not sum(cross(ring[k - 1], ring[k]) for ring in self.rings for k in range(len(ring)))

    @cached_property
    def edges(self) -> list[BoxedEdge]:
        """The edges, by the left ends of their boxes."""
        found: list[BoxedEdge] = []
        for k, ring in enumerate(self.rings):
            ax, ay = ring[-1]
            for i, (bx, by) in enumerate(ring):
                left, right = (ax, bx) if ax < bx else (bx, ax)
                low, high = (ay, by) if ay < by else (by, ay)
                box = left // 1, -(-right // 1), low // 1, -(-high // 1)
                found.append((*box, ax, ay, bx, by, k, (i or len(ring)) - 1))
                ax, ay = bx, by
        found.sort()
        return found

    @cached_property
    def _rows(self) -> BoxRows:
        return BoxRows([edge[:4] for edge in self.edges])

    def near(self, box: Bounds) -> list[BoxedEdge]:
        """Return the edges whose boxes meet a box, by their left ends.

        Cost: that of `BoxRows.find`.
        """
        edges = self.edges
        if len(edges) > _FEW:
            return [edges[k] for k in sorted(self._rows.find(box))]
        left, right, low, high = box
        return [
            edge
            for edge in edges
            if edge[0] <= right and edge[1] >= left and edge[2] <= high and edge[3] >= low
        ]

    def contains(self, x: Rational, y: Rational, scale: int) -> bool:
        """Decide whether (x / scale, y / scale), which is on no edge, is inside.

        Cost: that of `near` for a ray to the left.
        """
        left, right, low, high = self.box
        if not (left * scale < x < right * scale and low * scale < y < high * scale):
            return False
        is_inside = False
        ray = left // 1, -(-x // scale), y // scale, -(-y // scale)
        for _, _, _, _, ax, ay, bx, by, _, _ in self.near(ray):
            up = ay < by
            if (ay * scale <= y < by * scale) if up else (by * scale <= y < ay * scale):
                side = (bx - ax) * (y - ay * scale) - (by - ay) * (x - ax * scale)
                is_inside ^= (side < 0) == up
        return is_inside

    def after(self, edge: BoxedEdge) -> Vertex:
        """Return the vertex after an edge."""
        ring = self.rings[edge[8]]
        return ring[(edge[9] + 2) % len(ring)]


class Pair:
    """Two shapes, the second one moved.

    Args:
        shape: a shape with a connected interior, or a path.
        part: another one; not both are paths.
    """

    def __init__(self, shape: Boundary, part: Boundary) -> None:
        self._shape, self._part = shape, part
        self._has_path = shape.is_path or part.is_path
        # Edges that crossed last time are likely to cross again.
        self._crossing: tuple[BoxedEdge, BoxedEdge] | None = None

    def relate(self, x: Rational, y: Rational, scale: int = 1) -> Relation:
        """Find the relation of the shapes, the second one moved by (x / scale, y / scale).

        All common points of the boundaries lie in the intersection of the two boxes. So only the
        edges that meet it are examined.

        Cost: that of `Boundary.near`, and of a search for the pairs of edges that meet; O(1) if the
        edges that crossed last time cross again.

        >>> square = Boundary([[(0, 0), (2, 0), (2, 2), (0, 2)]])
        >>> [Pair(square, square).relate(k, k).value for k in (1, 2, 3)]
        ['overlap', 'contact', 'apart']
        """
        shape, part = self._shape, self._part
        if self._crossing:
            ours, other = self._crossing
            if _cross(_move(ours, 0, 0, scale)[4:6], _move(other, x, y, scale)[4:6]):
                return Relation.OVERLAP
        x0, x1, y0, y1 = x // scale, -(-x // scale), y // scale, -(-y // scale)
        (left, right, low, high), (west, east, south, north) = shape.box, part.box
        left, right = max(left, west + x0), min(right, east + x1)
        low, high = max(low, south + y0), min(high, north + y1)
        if left > right or low > high:
            return Relation.APART
        near = shape.near((left, right, low, high))
        others = part.near((left - x1, right - x0, low - y1, high - y0)) if near else []
        cones = self._find_cones(near if others else [], others, x, y, scale)
        if cones is None:
            return Relation.OVERLAP
        if cones:
            meet = any(_cones_meet(*around) for around in cones.values())
            return Relation.OVERLAP if meet else Relation.CONTACT
        for one, second, dx, dy in ((shape, part, x, y), (part, shape, -x, -y)):
            for (px, py), *_ in second.rings:
                if one.contains(px * scale + dx, py * scale + dy, scale):
                    return Relation.OVERLAP
        return Relation.APART

    def _find_cones(
        self,
        near: Sequence[BoxedEdge],
        others: Sequence[BoxedEdge],
        x: Rational,
        y: Rational,
        scale: int,
    ) -> Mapping[Vertex, tuple[set[_Cone], set[_Cone]]] | None:
        """Find the cones of both shapes at the common points of their boundaries.

        Returns:
            The cones by points; None if edges cross, or run along each other in one direction.
        """
        cones: defaultdict[Vertex, tuple[set[_Cone], set[_Cone]]]
        cones = defaultdict(lambda: (set(), set()))
        along: list[tuple[Vertex, ...]] = []
        x0, x1, y0, y1 = x // scale, -(-x // scale), y // scale, -(-y // scale)
        many = len(others) > _FEW
        meeting = [] if many else [_move(edge, x, y, scale) for edge in others]
        for edge in near:
            left, right, low, high, p, q, _ = _move(edge, 0, 0, scale)
            (px, py), (qx, qy) = p, q
            dx, dy, c = qx - px, qy - py, qx * py - qy * px
            if many:
                box = edge[0] - x1, edge[1] - x0, edge[2] - y1, edge[3] - y0
                meeting = [_move(other, x, y, scale) for other in self._part.near(box)]
            for west, east, south, north, a, b, other in meeting:
                if west > right or east < left or south > high or north < low:
                    continue
                (ax, ay), (bx, by) = a, b
                of_a, of_b = dx * ay - dy * ax - c, dx * by - dy * bx - c
                if (of_a > 0 < of_b) or (of_a < 0 > of_b):
                    continue
                ex, ey = bx - ax, by - ay
                of_p, of_q = ex * (py - ay) - ey * (px - ax), ex * (qy - ay) - ey * (qx - ax)
                if (of_p > 0 < of_q) or (of_p < 0 > of_q):
                    continue
                if of_a and of_b and of_p and of_q:
                    self._crossing = edge, other
                    return None
                if of_a == of_b == 0:
                    first, last = max(min(a, b), min(p, q)), min(max(a, b), max(p, q))
                    if first < last and (a < b) == (p < q) and not self._has_path:
                        return None
                    common = {first, last} if first <= last else set()
                    along.append((first, last, p, q, a, b))
                else:
                    common = {a if of_a == 0 else b if of_b == 0 else p if of_p == 0 else q}
                for z in common:
                    mine, others_there = cones[z]
                    if z != p:
                        rx, ry = self._shape.after(edge)
                        mine.add(_find_cone(z, p, q, (rx * scale, ry * scale)))
                    if z != a:
                        rx, ry = self._part.after(other)
                        others_there.add(_find_cone(z, a, b, (rx * scale + x, ry * scale + y)))
        # Where edges run along each other, another ring may touch one of them inside.
        single = len(self._shape.rings) == len(self._part.rings) == 1
        for first, last, p, q, a, b in () if single else along:
            for z, (mine, others_there) in cones.items():
                if first < z < last and cross(minus(q, p), minus(z, p)) == 0:
                    mine.add(_find_cone(z, p, q, q))
                    others_there.add(_find_cone(z, a, b, b))
        return cones


def relate(shape: Boundary, part: Boundary) -> Relation:
    """Find the relation of two shapes where they are, as `Pair.relate` does."""
    return Pair(shape, part).relate(0, 0)


def _move(edge: BoxedEdge, x: Rational, y: Rational, scale: int) -> _MovedEdge:
    """Return an edge times a scale, moved."""
    left, right, low, high, ax, ay, bx, by, _, _ = edge
    return (
        left * scale + x,
        right * scale + x,
        low * scale + y,
        high * scale + y,
        (ax * scale + x, ay * scale + y),
        (bx * scale + x, by * scale + y),
        edge,
    )


def _cross(edge: Edge, other: Edge) -> bool:
    """Decide whether two edges cross, each at a point inside the other one."""
    (p, q), (a, b) = edge, other
    return (turn(p, q, a) > 0 > turn(p, q, b) or turn(p, q, a) < 0 < turn(p, q, b)) and (
        turn(a, b, p) > 0 > turn(a, b, q) or turn(a, b, p) < 0 < turn(a, b, q)
    )


def _find_cone(z: Vertex, p: Vertex, q: Vertex, r: Vertex) -> _Cone:
    """Return the rays that leave and arrive at a point of the edge p q, which goes on to r."""
    return minus(r if z == q else q, z), minus(p, z)


def _cones_meet(ours: Iterable[_Cone], others: Iterable[_Cone]) -> bool:
    """Decide whether two intersections of cones have a common direction, by (1)."""
    return any(
        all(_is_in_cone(ray, other) for other in opposite)
        for cones, opposite in ((ours, others), (others, ours))
        for cone in cones
        for ray in cone
    )


def _is_in_cone(ray: Vertex, cone: _Cone) -> bool:
    """Decide whether a ray is strictly inside a cone."""
    leaving, arriving = cone
    after, before = cross(leaving, ray) > 0, cross(ray, arriving) > 0
    return (after and before) if cross(leaving, arriving) >= 0 else (after or before)


def find_outside(ring: Sequence[Vertex], room: Bounds) -> Rings:
    """Return the outside of a ring, within a frame around the ring and a room.

    A shape inside the room overlaps the outside of the ring if and only if it overlaps this shape.

    >>> find_outside([(0, 0), (2, 0), (0, 2)], (0, 5, 0, 1))
    [[(-1, -1), (6, -1), (6, 3), (-1, 3)], [(0, 2), (2, 0), (0, 0)]]
    """
    (left, right, low, high), (west, east, south, north) = Boundary([ring]).box, room
    left, right, low, high = min(left, west), max(right, east), min(low, south), max(high, north)
    frame = [(left - 1, low - 1), (right + 1, low - 1)]
    frame += [(right + 1, high + 1), (left - 1, high + 1)]
    return [frame, [*ring[::-1]]]


def contains(outer: Rings, inner: Rings) -> bool:
    """Decide whether a shape contains another one, boundaries included.

    Cost: that of `Pair.relate` for each ring of the outer shape.

    >>> square, larger = ([[(0, 0), (k, 0), (k, k), (0, k)]] for k in (1, 2))
    >>> contains(larger, square), contains(square, larger), contains(square, square)
    (True, False, True)
    """
    shape = Boundary(inner)
    others = [find_outside(outer[0], shape.box), *([hole[::-1]] for hole in outer[1:])]
    return all(relate(Boundary(rings), shape) is not Relation.OVERLAP for rings in others)


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
    x, y = doubled
    inside = False
    for ring in rings:
        for (px, py), (qx, qy) in pairwise((*ring, ring[0])):
            ax, bx = px * 2 - x, qx * 2 - x
            if (ax > 0) != (bx > 0):
                ay, by = py * 2 - y, qy * 2 - y
                turn = ax * by - ay * bx
                if turn == 0:
                    return False
                if (turn < 0) == (bx > ax):
                    inside = not inside
            elif bx == 0:
                # A vertex counts as the end of the edge before it.
                ay, by = py * 2 - y, qy * 2 - y
                if by == 0 or (ax == 0 and (ay < 0) != (by < 0)):
                    return False
    return inside
