"""Common boundary points of two shapes, with the cones of their interiors."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterable, Iterator
from fractions import Fraction

from exactsweep.check.cone import (
    Cone,
    Ray,
    cross,
    dot,
    find_cones,
    is_between,
    subtract,
)
from exactsweep.check.shape import LatticeShape, find_box, list_edges, meet
from exactsweep.numbers.number import Edge, Vertex

Cones = list[Cone]


def list_meetings(
    shapes: tuple[LatticeShape, LatticeShape],
) -> Iterator[tuple[Vertex, tuple[Cones, Cones]]]:
    """Yield common boundary points, crossings first, each with the cones of both shapes.

    Cost: O(m n) for m and n edges in the intersection of both boxes.
    """
    through: dict[Vertex, tuple[set[Edge], set[Edge]]] = defaultdict(lambda: (set(), set()))
    for e, f in _list_near(shapes):
        (a, b), (c, d) = e, f
        step, along = subtract(b, a), subtract(d, c)
        from_c, from_d = cross(step, subtract(c, a)), cross(step, subtract(d, a))
        if (from_c > 0 < from_d) or (from_c < 0 > from_d):
            continue
        if from_c * from_d < 0 and cross(along, subtract(a, c)) * cross(along, subtract(b, c)) < 0:
            share = Fraction(from_c) / (from_c - from_d)
            crossing = c[0] + share * along[0], c[1] + share * along[1]
            yield crossing, ([Cone(step, subtract(a, b))], [Cone(along, subtract(c, d))])
        ends = [*(p for p in e if is_between(p, c, d)), *(p for p in f if is_between(p, a, b))]
        for p in ends:
            through[p][0].add(e)
            through[p][1].add(f)
    for p in sorted(through):
        one, other = (_find_cones_at(p, edges) for edges in through[p])
        yield p, (one, other)


def _list_near(shapes: tuple[LatticeShape, LatticeShape]) -> Iterator[tuple[Edge, Edge]]:
    one, other = (
        [
            (box, e)
            for e in list_edges(split_where_touching(shape))
            if meet(box := find_box(e), around)
        ]
        for shape, around in zip(shapes, (find_box(s[0]) for s in shapes[::-1]), strict=True)
    )
    for box, e in one:
        for around, f in other:
            if meet(box, around):
                yield e, f


def _find_cones_at(p: Vertex, edges: Iterable[Edge]) -> Cones:
    """Return the cones of a shape at a point, given its edges through the point."""
    rays = [
        Ray(subtract(q, p), is_ahead)
        for edge in edges
        for q, is_ahead in zip(edge, (False, True), strict=True)
        if q != p
    ]
    return find_cones(rays)


def split_where_touching(shape: LatticeShape) -> LatticeShape:
    """Split edges at the vertices of other rings on them.

    Cost: O(n) for one ring, at most O(n**2) for several.
    """
    if len(shape) == 1:
        return shape
    corners = sorted({p for ring in shape for p in ring})
    rings = []
    for ring in shape:
        points: list[Vertex] = []
        for a, b in list_edges([ring]):
            step = subtract(b, a)
            low, high = min(a, b), max(a, b)
            between = corners[bisect_right(corners, low) : bisect_left(corners, high)]
            inside = [p for p in between if is_between(p, a, b)]
            points += [a, *sorted(inside, key=lambda p: dot(subtract(p, a), step))]
        rings.append(tuple(points))
    return tuple(rings)


def find_cones_of(shape: LatticeShape) -> dict[Vertex, Cones]:
    """Return the cones at each vertex of a shape whose rings touch only at vertices."""
    at: dict[Vertex, list[Edge]] = defaultdict(list)
    for edge in list_edges(shape):
        for p in edge:
            at[p].append(edge)
    return {p: _find_cones_at(p, edges) for p, edges in at.items()}
