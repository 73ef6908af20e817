"""The edges of a shape: search near a place, and the contact of two edges."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from itertools import chain, pairwise

from exactsweep.geometry.near import Bounds, BoxRows
from exactsweep.geometry.vectors import cross
from exactsweep.numbers.number import Rational, Vertex

Rings = Sequence[Sequence[Vertex]]
"""The boundary of a shape: rings with the interior on the left."""

Places = defaultdict[tuple[int, int], set[Vertex]]
"""Points on an edge, by the number of the ring and of the edge in it."""

BoxedEdge = tuple[int, int, int, int, Rational, Rational, Rational, Rational, int, int]
"""An edge: its box, rounded outwards to ints; its ends (ax, ay) and (bx, by); the number of its
ring, and its number there."""

MANY_EDGES = 64
"""The number of edges up to which a search examines all of them."""


class EdgeIndex:
    """The boundary of a shape or of a path, for searches for edges near a place.

    The interior is on the left of the rings.
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
        """Return the edges whose boxes meet a box, by their left ends."""
        edges = self.edges
        if len(edges) > MANY_EDGES:
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


def touch(a: Vertex, b: Vertex, p: Vertex, q: Vertex) -> list[Vertex] | None:
    """Return the ends of the intersection of edges a b and p q, or None if their left sides meet.

    Left sides meet if the edges cross properly, or overlap in the same direction.

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

    The rings are first enlarged by the scale and then moved by the shift; the places are on the
    moved rings. Pieces on edges without places belong to pieces on edges with places, so only the
    latter are examined. Without places the result is a vertex.

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
