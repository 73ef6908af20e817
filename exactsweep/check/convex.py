"""Open convex pieces of a shape.

A shape is cut along diagonals, each from a vertex to a vertex through the interior, until no angle
of any face is wider than half a turn. Then every face is convex: a hole in a face would have a
corner that is a wide angle of the face. Diagonals suffice, because every set of diagonals that do
not cross can be completed to a triangulation.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction

from exactsweep.check.cone import Cone, cross, dot, find_way, reduce_way
from exactsweep.check.meeting import find_angles, split_where_touching
from exactsweep.check.shape import LatticeRing, LatticeShape, list_edges
from exactsweep.check.standalone import Grid, Node, Work, grid_box, line, node, side
from exactsweep.numbers.number import Vertex

_NEAR = 32  # as many vertices to either side are tried first


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
    faces = _Faces(split_where_touching(shape), budget)
    faces.cut()
    return faces.walk()


class _Faces:
    """The faces between the edges of a shape and diagonals."""

    def __init__(self, shape: LatticeShape, budget: Work) -> None:
        self._budget = budget
        self._vertices = {node(*p): p for ring in shape for p in ring}
        self._order = sorted(self._vertices, key=self._vertices.__getitem__)
        self._angles = {node(*p): cones for p, cones in find_angles(shape).items()}
        self._bits = measure_bits(self._order)
        # The other end of each side of a face, by its first end and its direction.
        self._ahead: dict[tuple[Node, Vertex], Node] = {}
        self._walls: list[tuple[Grid, Node, Node]] = []
        for a, b in list_edges(shape):
            self._add_wall(node(*a), node(*b))

    def _add_wall(self, p: Node, q: Node) -> Vertex:
        """Add an edge, or a diagonal; return the direction of the side from p to q."""
        self._walls.append((grid_box((p, q), 1), p, q))
        way = reduce_way(find_way(p, q))
        self._ahead[p, way] = q
        return way

    def cut(self) -> None:
        """Cut all wide angles."""
        for k, p in enumerate(self._order):
            while wide := next((cone for cone in self._angles[p] if cone.is_wide), None):
                q = self._find_diagonal(k, p, wide)
                dx, dy = way = self._add_wall(p, q)
                self._ahead[q, (-dx, -dy)] = p
                _split(self._angles[p], way)
                _split(self._angles[q], (-dx, -dy))

    def walk(self) -> list[LatticeRing]:
        """Walk around the faces: the end of an edge is the cone that ends in the way back."""
        ending = {(p, cone.end): cone for p, found in self._angles.items() for cone in found}
        faces = []
        while ending:
            (p, end), cone = ending.popitem()
            face, first = [], (p, end)
            while True:
                if cross(*cone):
                    face.append(self._vertices[p])
                dx, dy = cone.start
                p, back = self._ahead[p, cone.start], (-dx, -dy)
                if (p, back) == first:
                    break
                cone = ending.pop((p, back))
            faces.append(tuple(face))
        return faces

    def _find_diagonal(self, k: int, p: Node, wide: Cone) -> Node:
        """The end of the best diagonal into a wide angle: to a vertex near in x, else to any."""
        for ends in (self._order[max(k - _NEAR, 0) : k + _NEAR + 1], self._order):
            self._budget.take(2 * len(ends), self._bits)
            for _, _, _, q in sorted(self._rank_diagonals(p, wide, ends)):
                self._budget.take(1 + len(self._walls) // 8, self._bits)
                if not _is_blocked(p, q, self._walls):
                    return q
        raise AssertionError("a wide angle has a diagonal")

    def _rank_diagonals(
        self, p: Node, wide: Cone, ends: Iterable[Node]
    ) -> Iterator[tuple[int, Fraction, Vertex, Node]]:
        """Rank diagonals by the wide angles left at both ends, then by squared length."""
        for q in ends:
            way = find_way(p, q)
            if not wide.surrounds(way):  # nor any that is none, to p itself
                continue
            back = (-way[0], -way[1])
            if opposite := next((cone for cone in self._angles[q] if cone.surrounds(back)), None):
                halves = [*_halves(wide, way), *_halves(opposite, back)]
                remaining = sum(half.is_wide for half in halves) - opposite.is_wide
                length = Fraction(dot(way, way), (p[2] * q[2]) ** 2)
                yield remaining, length, self._vertices[q], q


def measure_bits(points: Iterable[Node]) -> int:
    """Measure the longest number by which two points are compared."""
    return max(max(x.bit_length(), y.bit_length()) + w.bit_length() - 1 for x, y, w in points)


def _halves(cone: Cone, way: Vertex) -> list[Cone]:
    return [Cone(cone.start, way), Cone(way, cone.end)]


def _split(cones: list[Cone], way: Vertex) -> None:
    k = next(k for k, cone in enumerate(cones) if cone.surrounds(way))
    cones[k : k + 1] = _halves(cones[k], way)


def _is_blocked(p: Node, q: Node, walls: Iterable[tuple[Grid, Node, Node]]) -> bool:
    """Decide whether a wall that does not end in p or q meets the segment between them.

    A wall along the segment does not count, as at its end there is another one that does not.
    """
    of, (first, last, bottom, top) = line(p, q), grid_box((p, q), 1)
    for (left, right, low, high), a, b in walls:
        # Most are nowhere near.
        if left > last or right < first or low > top or high < bottom:
            continue
        if p in (a, b) or q in (a, b):
            continue
        from_a, from_b = side(of, a), side(of, b)
        if from_a * from_b > 0 or from_a == from_b == 0:
            continue
        along = line(a, b)
        if side(along, p) * side(along, q) <= 0:
            return True
    return False
