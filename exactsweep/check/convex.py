"""Open convex pieces of a shape, and their sums.

A shape is cut along diagonals, each from a vertex to a vertex through the interior, until no angle
of any face is wider than half a turn. Then every face is convex: a hole in a face would have a
corner that is a wide angle of the face. Diagonals suffice, because every set of diagonals that do
not cross can be completed to a triangulation.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence

from exactsweep.check.cone import Cone, cross, dot, subtract
from exactsweep.check.meeting import find_cones_of, split_where_touching
from exactsweep.check.shape import LatticeRing, LatticeShape, list_edges
from exactsweep.geometry.point import Rational, Vertex

_NEAR = 32  # as many vertices to either side are tried first

_Wall = tuple[Rational, Rational, Rational, Rational, Vertex, Vertex]
"""A segment by its ends, behind its least and its greatest x and y."""


def cut_to_convex(shape: LatticeShape) -> list[LatticeRing]:
    """Cut a shape into convex pieces without new vertices.

    Args:
        shape: n edges, c of its vertices concave; its interior need not be connected.

    Returns:
        Convex rings, counter-clockwise, without straight angles. Their interiors are disjoint, and
        together with the diagonals between them they are the interior of the shape.

    Cost: O(c n**2) at worst, O(c n) where the first diagonals tried, to near vertices, are good.

    >>> len(cut_to_convex((((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)),)))
    2
    """
    touching = split_where_touching(shape)
    cones, walls = find_cones_of(touching), [_box(*edge) for edge in list_edges(touching)]
    order = sorted(cones)
    for p in cones:
        while wide := next((cone for cone in cones[p] if _is_wide(cone)), None):
            q = _find_diagonal(p, wide, order, cones, walls)
            walls.append(_box(p, q))
            for a, b in ((p, q), (q, p)):
                _split(cones[a], subtract(b, a))
    return _faces(cones)


def add_convex(first: Sequence[Vertex], second: Sequence[Vertex]) -> LatticeRing:
    """Add two convex rings, counter-clockwise, by merging their edges by direction.

    A ring of two vertices is a segment.

    >>> add_convex([(0, 0), (1, 0), (0, 1)], [(0, 0), (2, 0)])
    ((0, 0), (3, 0), (2, 1), (0, 1))
    """
    a, b = _from_lowest(first), _from_lowest(second)
    x, y = a[0][0] + b[0][0], a[0][1] + b[0][1]
    ways, others = ([subtract(q, p) for p, q in list_edges([ring])] for ring in (a, b))
    found = [(x, y)]
    i = j = 0
    while i < len(ways) or j < len(others):
        turn = 1 if j == len(others) else -1 if i == len(ways) else cross(ways[i], others[j])
        if turn >= 0:
            x, y = x + ways[i][0], y + ways[i][1]
            i += 1
        if turn <= 0:
            x, y = x + others[j][0], y + others[j][1]
            j += 1
        found.append((x, y))
    return tuple(found[:-1])


def _faces(cones: dict[Vertex, list[Cone]]) -> list[LatticeRing]:
    """Walk around the faces: the end of an edge is the cone that ends in the way back."""
    ending = {(p, cone.end): cone for p, found in cones.items() for cone in found}
    faces = []
    while ending:
        (p, end), cone = ending.popitem()
        face, first = [], (p, end)
        while True:
            if cross(*cone):
                face.append(p)
            (x, y), (dx, dy) = p, cone.start
            p = x + dx, y + dy
            if (p, (-dx, -dy)) == first:
                break
            cone = ending.pop((p, (-dx, -dy)))
        faces.append(tuple(face))
    return faces


def _from_lowest(ring: Sequence[Vertex]) -> LatticeRing:
    k = min(range(len(ring)), key=lambda i: (ring[i][1], ring[i][0]))
    return (*ring[k:], *ring[:k])


def _is_wide(cone: Cone) -> bool:
    return cross(cone.start, cone.end) < 0


def _halves(cone: Cone, way: Vertex) -> list[Cone]:
    return [Cone(cone.start, way), Cone(way, cone.end)]


def _split(cones: list[Cone], way: Vertex) -> None:
    k = next(k for k, cone in enumerate(cones) if cone.surrounds(way))
    cones[k : k + 1] = _halves(cones[k], way)


def _box(a: Vertex, b: Vertex) -> _Wall:
    """A wall, and its box."""
    (left, right), (low, high) = (sorted(pair) for pair in zip(a, b, strict=True))
    return left, right, low, high, a, b


def _find_diagonal(
    p: Vertex,
    wide: Cone,
    order: Sequence[Vertex],
    cones: dict[Vertex, list[Cone]],
    walls: Sequence[_Wall],
) -> Vertex:
    """The end of a diagonal into a wide angle: best among those to vertices next in x, if any."""
    k = bisect_left(order, p)
    return next(
        q
        for reach in (_NEAR, len(order))
        for _, _, q in sorted(
            _rank_diagonals(p, wide, order[max(k - reach, 0) : k + reach + 1], cones)
        )
        if not _is_blocked(p, q, walls)
    )


def _rank_diagonals(
    p: Vertex, wide: Cone, ends: Iterable[Vertex], cones: dict[Vertex, list[Cone]]
) -> Iterator[tuple[int, Rational, Vertex]]:
    """How many angles each leaves wide, here and there, and the square of its length."""
    for q in ends:
        way = subtract(q, p)
        if not wide.surrounds(way):  # nor any that is none, to p itself
            continue
        back = (-way[0], -way[1])
        if opposite := next((cone for cone in cones[q] if cone.surrounds(back)), None):
            halves = [*_halves(wide, way), *_halves(opposite, back)]
            remaining = sum(map(_is_wide, halves)) - _is_wide(opposite)
            yield remaining, dot(way, way), q


def _is_blocked(p: Vertex, q: Vertex, walls: Sequence[_Wall]) -> bool:
    """Whether a wall that does not end in p or q meets the segment between them.

    A wall along the segment does not count, as at its end there is another one that does not.
    """
    way = subtract(q, p)
    first, last, bottom, top, _, _ = _box(p, q)
    for left, right, low, high, a, b in walls:
        # Most are nowhere near.
        if left > last or right < first or low > top or high < bottom:
            continue
        if p in (a, b) or q in (a, b):
            continue
        from_a, from_b = cross(way, subtract(a, p)), cross(way, subtract(b, p))
        if from_a * from_b > 0 or from_a == from_b == 0:
            continue
        along = subtract(b, a)
        if cross(along, subtract(p, a)) * cross(along, subtract(q, a)) <= 0:
            return True
    return False
