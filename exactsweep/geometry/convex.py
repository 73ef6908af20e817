"""Convex pieces of a shape, cut along diagonals from vertex to vertex.

(1) Near a vertex the interior consists of open *cones*, each counter-clockwise from an outgoing
    edge to an incoming one. A diagonal joins two vertices through the interior, and splits a cone
    at each end.
(2) Every cone wider than a half turn contains a diagonal. Without such cones, every face is convex:
    a hole in a face would have one at a corner.
(3) So the pieces consist of the edges of the shape, and of each diagonal in both directions.
    Consecutive collinear edges of a piece are merged.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, pairwise
from math import isqrt

from exactsweep.geometry.near import Bounds, BoxRows, bound_points
from exactsweep.geometry.vectors import angle_key, cross, is_between, minus, orientation

IntVertex = tuple[int, int]
IntRing = Sequence[IntVertex]
ConvexRing = list[IntVertex]
"""A convex ring, counter-clockwise, without straight angles."""

_Corner = tuple[IntVertex, IntVertex]
# Number of vertices tried along the boundary in each direction.
_FOLLOWED = 16

_IntEdge = tuple[IntVertex, IntVertex]


class _Plan:
    """The vertices and the edges of a shape, with the diagonals found so far."""

    def __init__(self, rings: Sequence[IntRing]) -> None:
        self._vertices = [*dict.fromkeys(chain.from_iterable(rings))]
        self._places = BoxRows([(x, x, y, y) for x, y in self._vertices])
        edges = [edge for ring in rings for edge in pairwise((*ring, ring[0]))]
        if len(rings) > 1:
            split = (sorted({a, b, *self._find_on(a, b)}, reverse=a > b) for a, b in edges)
            edges = list(chain.from_iterable(map(pairwise, split)))
        self.edges: list[_IntEdge] = edges
        self._rows = BoxRows([bound_points(edge) for edge in edges])
        left, right, low, high = box = bound_points(self._vertices)
        self.width = int(max(right - left, high - low))
        # The first square around a point has 64 vertices on average.
        self.reach = 4 * self.width // isqrt(len(self._vertices)) + 1
        # A long diagonal would span many rows, so use a single row; entry 0 is its bounds.
        self._diagonals = BoxRows([box])

    def _find_on(self, a: IntVertex, b: IntVertex) -> Iterator[IntVertex]:
        return (v for v in self._find(bound_points((a, b))) if is_between(v, a, b))

    def _find(self, box: Bounds) -> Iterator[IntVertex]:
        return (self._vertices[k] for k in self._places.find(box))

    def find_around(self, p: IntVertex, reach: int) -> Iterator[IntVertex]:
        """Find the vertices in a square around a point."""
        x, y = p
        return self._find((x - reach, x + reach, y - reach, y + reach))

    def is_blocked(self, p: IntVertex, q: IntVertex) -> bool:
        """Decide whether an edge that does not end in p or q meets the segment between them."""
        box = bound_points((p, q))
        for k in chain(self._rows.find(box), filter(None, self._diagonals.find(box))):
            a, b = self.edges[k]
            if a in (p, q) or b in (p, q):
                continue
            from_a, from_b = orientation(p, q, a), orientation(p, q, b)
            if (from_a > 0 < from_b) or (from_a < 0 > from_b):
                continue
            if orientation(a, b, p) * orientation(a, b, q) <= 0:
                return True
        return False

    def add(self, p: IntVertex, q: IntVertex) -> None:
        """Add a diagonal."""
        self._diagonals.add(bound_points((p, q)), len(self.edges))
        self.edges.append((p, q))


def cut_to_convex(rings: Sequence[IntRing]) -> list[ConvexRing]:
    """Cut a shape into convex pieces between its vertices; rings may touch at points.

    Cost: for each reflex vertex, the number of diagonals tried times the number of nearby vertices
    and edges, O(n) at worst.
    """
    plan = _Plan(rings)
    cones = _find_cones(plan.edges)
    for p in list(cones):
        while (wide := next((cone for cone in cones[p] if _is_wide(cone)), None)) is not None:
            q = _find_diagonal(p, wide, cones, plan)
            plan.add(p, q)
            _halve(cones[p], minus(q, p))
            _halve(cones[q], minus(p, q))
    return _walk_faces(cones)


def _find_cones(edges: Sequence[tuple[IntVertex, IntVertex]]) -> dict[IntVertex, list[_Corner]]:
    directions: defaultdict[IntVertex, list[tuple[IntVertex, bool]]] = defaultdict(list)
    for a, b in edges:
        directions[a].append((minus(b, a), True))
        directions[b].append((minus(a, b), False))
    cones: dict[IntVertex, list[_Corner]] = {}
    for p, found in directions.items():
        if len(found) > 2:
            found.sort(key=lambda direction: angle_key(direction[0]))
        starts = next(k for k, (_, is_start) in enumerate(found) if is_start)
        found = found[starts:] + found[:starts]
        cones[p] = [(found[k][0], found[k + 1][0]) for k in range(0, len(found), 2)]
    return cones


def _find_diagonal(
    p: IntVertex, wide: _Corner, cones: dict[IntVertex, list[_Corner]], plan: _Plan
) -> IntVertex:
    """Find the other end of a short diagonal that splits a wide cone and leaves few others."""
    for vertices in _list_candidates(p, wide, cones, plan):
        for q in _list_ends(p, wide, cones, vertices):
            if not plan.is_blocked(p, q):
                return q
    raise AssertionError  # By (2) a diagonal exists.


def _list_candidates(
    p: IntVertex, wide: _Corner, cones: dict[IntVertex, list[_Corner]], plan: _Plan
) -> Iterator[Iterable[IntVertex]]:
    """Yield vertices around p, then some along the face of a wide cone, then farther ones."""
    reach = plan.reach
    yield plan.find_around(p, reach)
    yield _follow_face(p, wide, cones)
    while reach <= plan.width:
        reach *= 2
        yield plan.find_around(p, reach)


def _follow_face(
    p: IntVertex, wide: _Corner, cones: dict[IntVertex, list[_Corner]]
) -> set[IntVertex]:
    """Return the next vertices along the boundary of a face, in both directions."""
    # Diagonals from neighboring vertices of a curve have neighboring ends, which may be far away.
    found = set()
    for side in (0, 1):
        (x, y), direction = p, wide[side]
        for _ in range(_FOLLOWED):
            dx, dy = direction
            x, y, back = x + dx, y + dy, (-dx, -dy)
            found.add((x, y))
            direction = next(cone[side] for cone in cones[x, y] if cone[1 - side] == back)
    return found


def _list_ends(
    p: IntVertex,
    wide: _Corner,
    cones: dict[IntVertex, list[_Corner]],
    vertices: Iterable[IntVertex],
) -> list[IntVertex]:
    """List the candidate ends of a diagonal, best first."""
    ranked = []
    for q in vertices:
        direction = minus(q, p)
        if direction == (0, 0) or not _surrounds(wide, direction):
            continue
        back = (-direction[0], -direction[1])
        opposite = next((cone for cone in cones[q] if _surrounds(cone, back)), None)
        if opposite is not None:
            remaining = sum(map(_is_wide, (*_halves(wide, direction), *_halves(opposite, back))))
            saved = _is_wide(opposite)
            ranked.append(
                (remaining - saved, direction[0] * direction[0] + direction[1] * direction[1], q)
            )
    return [q for _, _, q in sorted(ranked)]


def _walk_faces(cones: dict[IntVertex, list[_Corner]]) -> list[ConvexRing]:
    """Trace the faces: an edge leads to the cone that ends in the reverse direction."""
    ending = {(p, end): start for p, found in cones.items() for start, end in found}
    pieces = []
    while ending:
        first, direction = next(((p, end), start) for (p, end), start in ending.items())
        key, piece = first, []
        while key in ending:
            direction = ending.pop(key)
            p, back = key
            if back[0] * direction[1] != back[1] * direction[0]:
                piece.append(p)
            key = (p[0] + direction[0], p[1] + direction[1]), (-direction[0], -direction[1])
        pieces.append(piece)
    return pieces


def _is_wide(cone: _Corner) -> bool:
    return cross(*cone) < 0


def _surrounds(cone: _Corner, direction: IntVertex) -> bool:
    """Decide whether a direction is strictly inside a cone."""
    after, before, turned = (
        cross(cone[0], direction) > 0,
        cross(direction, cone[1]) > 0,
        cross(*cone),
    )
    return after or before if turned < 0 else after and (before or not turned)


def _halves(cone: _Corner, direction: IntVertex) -> list[_Corner]:
    return [(cone[0], direction), (direction, cone[1])]


def _halve(cones: list[_Corner], direction: IntVertex) -> None:
    k = next(k for k, cone in enumerate(cones) if _surrounds(cone, direction))
    cones[k : k + 1] = _halves(cones[k], direction)
