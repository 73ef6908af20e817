"""Open convex pieces of a shape.

A shape is cut along diagonals, each from a vertex to a vertex through the interior, until no angle
of any face is wider than half a turn. Then every face is convex: a hole in a face would have a
corner that is a wide angle of the face. Diagonals suffice, because every set of diagonals that do
not cross can be completed to a triangulation.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Iterable, Iterator, Sequence

from exactsweep.check.cone import Cone, cross, dot, subtract
from exactsweep.check.meeting import find_cones_of, split_where_touching
from exactsweep.check.shape import LatticeRing, LatticeShape, list_edges
from exactsweep.check.standalone import Work
from exactsweep.numbers.number import Rational, Vertex

_NEAR = 32  # as many vertices to either side are tried first

_Wall = tuple[Rational, Rational, Rational, Rational, Vertex, Vertex]
"""A segment by its ends, behind its least and its greatest x and y."""


def cut_to_convex(shape: LatticeShape, budget: Work) -> list[LatticeRing]:
    """Cut a shape into convex pieces without new vertices.

    Args:
        shape: n edges, c of its vertices concave; its interior need not be connected.
        budget: the steps that it may take.

    Returns:
        Convex rings, counter-clockwise, without straight angles. Their interiors are disjoint, and
        together with the diagonals between them they are the interior of the shape.

    Cost: O(c n) where diagonals go to vertices near in x, O(c n**2) at worst.

    >>> from exactsweep.check.no_fit import UNLIMITED
    >>> len(cut_to_convex((((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)),), UNLIMITED))
    2
    """
    touching = split_where_touching(shape)
    cones, walls = find_cones_of(touching), [_box(*edge) for edge in list_edges(touching)]
    order = sorted(cones)
    bits = measure_bits(order)
    for p in cones:
        while wide := next((cone for cone in cones[p] if cone.is_wide), None):
            q = _find_diagonal(p, wide, order, cones, walls, lambda steps: budget.take(steps, bits))
            walls.append(_box(p, q))
            for a, b in ((p, q), (q, p)):
                _split(cones[a], subtract(b, a))
    return _faces(cones)


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
    take: Callable[[int], None],
) -> Vertex:
    """The end of the best diagonal into a wide angle: to a vertex near in x, else to any."""
    k = bisect_left(order, p)
    for ends in (order[max(k - _NEAR, 0) : k + _NEAR + 1], order):
        take(2 * len(ends))
        for _, _, q in sorted(_rank_diagonals(p, wide, ends, cones)):
            take(1 + len(walls) // 8)
            if not _is_blocked(p, q, walls):
                return q
    raise AssertionError("a wide angle has a diagonal")


def _rank_diagonals(
    p: Vertex, wide: Cone, ends: Iterable[Vertex], cones: dict[Vertex, list[Cone]]
) -> Iterator[tuple[int, Rational, Vertex]]:
    """Rank diagonals by the wide angles left at both ends, then by squared length."""
    for q in ends:
        way = subtract(q, p)
        if not wide.surrounds(way):  # nor any that is none, to p itself
            continue
        back = (-way[0], -way[1])
        if opposite := next((cone for cone in cones[q] if cone.surrounds(back)), None):
            halves = [*_halves(wide, way), *_halves(opposite, back)]
            remaining = sum(half.is_wide for half in halves) - opposite.is_wide
            yield remaining, dot(way, way), q


def _is_blocked(p: Vertex, q: Vertex, walls: Sequence[_Wall]) -> bool:
    """Decide whether a wall that does not end in p or q meets the segment between them.

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


def measure_bits(points: Iterable[Vertex]) -> int:
    """Measure the longest coordinate, 32 times as long for Fractions, which take more time."""
    ratios = [c.as_integer_ratio() for p in points for c in p]
    bits = max(max(n.bit_length(), d.bit_length()) for n, d in ratios)
    return bits if all(d == 1 for _, d in ratios) else 32 * bits
