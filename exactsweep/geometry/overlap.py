"""The relation of two shapes, one of them translated: overlap, contact, or apart.

Let D and G be shapes with connected interiors, G translated. At a vertex or inside an edge,
the boundary of a shape has a *cone* on its left, counter-clockwise from the outgoing ray to the
incoming ray. Where several rings touch, the shape is the intersection of their cones.

(1) Interiors meet if two edges cross, or if the shapes have a common direction at a common point of
    the boundaries: a ray of one shape lies inside all cones of the other, or two edges overlap in
    the same direction. Otherwise, if the boundaries have a common point on a ring R of G, then D
    stays on the side of R on which it touches R, and the interiors are disjoint.
(2) If the boundaries are disjoint, interiors meet if and only if a ring of one shape lies inside
    the other shape. One vertex of the ring decides.

A path is a ring that runs back and forth, or two such rings. Its cones are empty, because each ray
is both outgoing and incoming; its interior is the path itself.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from enum import Enum

from exactsweep.geometry.edges import BoxedEdge, EdgeIndex, Rings
from exactsweep.geometry.near import Bounds
from exactsweep.geometry.vectors import minus, orientation
from exactsweep.numbers.number import Edge, Rational, Vertex

_EdgeCone = tuple[Vertex, Vertex]
"""The outgoing and the incoming ray at a point of a boundary."""


class Relation(Enum):
    """The relation of two shapes."""

    APART = "FREE"
    CONTACT = "CONTACT"
    OVERLAP = "OVERLAP"


def relate(
    shape: EdgeIndex, part: EdgeIndex, x: Rational = 0, y: Rational = 0, scale: int = 1
) -> Relation:
    """Find the relation of two shapes, or a shape and a path, the second at (x / scale, y / scale).

    Only edges that meet the intersection of the two boxes are examined. Cost: one
    `EdgeIndex.near` per such edge.

    >>> square = EdgeIndex([[(0, 0), (2, 0), (2, 2), (0, 2)]])
    >>> [relate(square, square, k, k).value for k in (1, 2, 3)]
    ['OVERLAP', 'CONTACT', 'FREE']
    """
    x0, x1, y0, y1 = x // scale, -(-x // scale), y // scale, -(-y // scale)
    (left, right, low, high), (west, east, south, north) = shape.box, part.box
    left, right = max(left, west + x0), min(right, east + x1)
    low, high = max(low, south + y0), min(high, north + y1)
    if left > right or low > high:
        return Relation.APART
    cones = _find_cones(shape, part, (left, right, low, high), (x, y, scale))
    if cones is None:
        return Relation.OVERLAP
    if cones:
        meet = any(_cones_meet(*around) for around in cones.values())
        return Relation.OVERLAP if meet else Relation.CONTACT
    for one, other, dx, dy in ((shape, part, x, y), (part, shape, -x, -y)):
        if any(one.contains(u * scale + dx, v * scale + dy, scale) for (u, v), *_ in other.rings):
            return Relation.OVERLAP
    return Relation.APART


def _find_cones(
    shape: EdgeIndex, part: EdgeIndex, box: Bounds, position: tuple[Rational, Rational, int]
) -> Mapping[Vertex, tuple[set[_EdgeCone], set[_EdgeCone]]] | None:
    """Find the cones of both shapes at the common points of their boundaries.

    Returns None if edges cross, or overlap in the same direction.
    """
    cones: defaultdict[Vertex, tuple[set[_EdgeCone], set[_EdgeCone]]]
    cones = defaultdict(lambda: (set(), set()))
    along: list[tuple[Vertex, ...]] = []
    has_path = shape.is_path or part.is_path
    x, y, scale = position
    x0, x1, y0, y1 = x // scale, -(-x // scale), y // scale, -(-y // scale)
    for edge in shape.near(box):
        p, q = _move(edge, 0, 0, scale)
        (px, py), (qx, qy) = p, q
        dx, dy, c = qx - px, qy - py, qx * py - qy * px
        for other in part.near((edge[0] - x1, edge[1] - x0, edge[2] - y1, edge[3] - y0)):
            a, b = _move(other, x, y, scale)
            of_a, of_b = dx * a[1] - dy * a[0] - c, dx * b[1] - dy * b[0] - c
            if (of_a > 0 < of_b) or (of_a < 0 > of_b):
                continue
            of_p, of_q = orientation(a, b, p), orientation(a, b, q)
            if (of_p > 0 < of_q) or (of_p < 0 > of_q):
                continue
            if of_a and of_b and of_p and of_q:
                return None
            if of_a == of_b == 0:
                first, last = max(min(a, b), min(p, q)), min(max(a, b), max(p, q))
                if first < last and (a < b) == (p < q) and not has_path:
                    return None
                common = {first, last} if first <= last else set()
                along.append((first, last, p, q, a, b))
            else:
                common = {a if of_a == 0 else b if of_b == 0 else p if of_p == 0 else q}
            for z in common:
                ours, theirs = cones[z]
                if z != p:
                    rx, ry = shape.after(edge)
                    ours.add(_find_cone(z, p, q, (rx * scale, ry * scale)))
                if z != a:
                    rx, ry = part.after(other)
                    theirs.add(_find_cone(z, a, b, (rx * scale + x, ry * scale + y)))
    # Another ring may touch the interior of one of two overlapping edges.
    for first, last, p, q, a, b in along:
        for z, (ours, theirs) in cones.items():
            if first < z < last and orientation(p, q, z) == 0:
                ours.add(_find_cone(z, p, q, q))
                theirs.add(_find_cone(z, a, b, b))
    return cones


def _move(edge: BoxedEdge, x: Rational, y: Rational, scale: int) -> Edge:
    """Return an edge on the lattice of a position."""
    _, _, _, _, ax, ay, bx, by, _, _ = edge
    return (ax * scale + x, ay * scale + y), (bx * scale + x, by * scale + y)


def _find_cone(z: Vertex, p: Vertex, q: Vertex, r: Vertex) -> _EdgeCone:
    """Return the cone at a point of the edge p q, followed by r."""
    return minus(r if z == q else q, z), minus(p, z)


def _cones_meet(ours: Iterable[_EdgeCone], others: Iterable[_EdgeCone]) -> bool:
    """Decide whether two intersections of cones have a common direction, by (1)."""
    return any(
        all(_is_in_cone(ray, other) for other in opposite)
        for cones, opposite in ((ours, others), (others, ours))
        for cone in cones
        for ray in cone
    )


def _is_in_cone(ray: Vertex, cone: _EdgeCone) -> bool:
    (x, y), ((ux, uy), (vx, vy)) = ray, cone
    after, before = ux * y > uy * x, x * vy > y * vx
    return (after and before) if ux * vy >= uy * vx else (after or before)


def find_outside(ring: Sequence[Vertex], room: Bounds) -> Rings:
    """Return the complement of a ring within a frame around the ring and a box.

    A shape inside the box overlaps this shape if and only if it overlaps the complement.
    """
    (left, right, low, high), (west, east, south, north) = EdgeIndex([ring]).box, room
    left, right, low, high = min(left, west), max(right, east), min(low, south), max(high, north)
    frame = [(left - 1, low - 1), (right + 1, low - 1)]
    frame += [(right + 1, high + 1), (left - 1, high + 1)]
    return [frame, [*ring[::-1]]]


def contains(outer: Rings, inner: Rings) -> bool:
    """Decide whether a closed shape contains another one.

    Cost: one `relate` per ring of the outer shape.
    """
    shape = EdgeIndex(inner)
    others = [find_outside(outer[0], shape.box), *([hole[::-1]] for hole in outer[1:])]
    return all(relate(EdgeIndex(rings), shape) is not Relation.OVERLAP for rings in others)
