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

from exactsweep.geometry.edges import BoxedEdge, EdgeIndex, Rings, move_edge
from exactsweep.geometry.near import PER_ROW, Bounds
from exactsweep.geometry.vectors import is_on_segment, minus, touch
from exactsweep.numbers.number import Rational, Vertex

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
    """Relate a shape to another shape or a path, translated by (x / scale, y / scale).

    Cost: one search for the edges in the intersection of the two boxes, and one more for each edge
    there if they are many.

    >>> square = EdgeIndex([[(0, 0), (2, 0), (2, 2), (0, 2)]])
    >>> [relate(square, square, k, k).value for k in (1, 2, 3)]
    ['OVERLAP', 'CONTACT', 'FREE']
    """
    (left, right, low, high), (west, east, south, north) = shape.box, part.box
    left, right = max(left * scale, west * scale + x), min(right * scale, east * scale + x)
    low, high = max(low * scale, south * scale + y), min(high * scale, north * scale + y)
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
    """Find the cones at common points of the boundaries; None if the edges imply an overlap."""
    cones: defaultdict[Vertex, tuple[set[_EdgeCone], set[_EdgeCone]]]
    cones = defaultdict(lambda: (set(), set()))
    along: list[tuple[Sequence[Vertex], BoxedEdge, BoxedEdge]] = []
    near = part.near_moved(box, *position)
    # A search takes as long as a scan of the edges in one row.
    is_few = len(near) <= PER_ROW
    others = [move_edge(other, *position) for other in near] if is_few else []
    origin = 0, 0, position[2]
    for found in shape.near_moved(box, *origin):
        edge = move_edge(found, *origin)
        left, right, low, high, p, q, _, _ = edge
        if not is_few:
            near = part.near_moved(edge[:4], *position)
            others = [move_edge(other, *position) for other in near]
        for other in others:
            west, east, south, north, a, b, _, _ = other
            if west > right:
                break
            if east < left or south > high or north < low:
                continue
            common = touch(p, q, a, b)
            if common is None:
                common = touch(p, q, b, a)
                # A path may run along an edge, as its left side is not in its interior.
                if common is None or not (shape.is_path or part.is_path):
                    return None
            for z in common:
                # A vertex belongs to the edge that ends there.
                if p != z != a:
                    ours, theirs = cones[z]
                    ours.add(_find_cone(z, edge, shape.rings))
                    theirs.add(_find_cone(z, other, part.rings))
            if len(common) == 2:
                along.append((common, edge, other))
    # Another ring may touch the interior of one of two overlapping edges.
    for (first, last), edge, other in along:
        for z, (ours, theirs) in cones.items():
            if first < z < last and is_on_segment(z, first, last):
                ours.add(_find_cone(z, edge, shape.rings))
                theirs.add(_find_cone(z, other, part.rings))
    return cones


def _find_cone(z: Vertex, edge: BoxedEdge, rings: Rings) -> _EdgeCone:
    """Return the cone at the end of an edge, or at a point in its interior."""
    _, _, _, _, p, q, ring, k = edge
    if z != q:
        return minus(q, p), minus(p, q)
    points = rings[ring]
    return minus(points[(k + 2) % len(points)], points[(k + 1) % len(points)]), minus(p, q)


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
    """Decide whether a closed shape contains another, by one `relate` per outer ring."""
    shape = EdgeIndex(inner)
    others = [find_outside(outer[0], shape.box), *([hole[::-1]] for hole in outer[1:])]
    return all(relate(EdgeIndex(rings), shape) is not Relation.OVERLAP for rings in others)
