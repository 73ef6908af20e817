"""The edges of a shape, for box queries and point location."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from itertools import chain, pairwise

from exactsweep.geometry.near import Bounds, BoxRows, bound_points
from exactsweep.geometry.vectors import cross, is_on_segment
from exactsweep.numbers.number import Edge, Rational, Vertex

Rings = Sequence[Sequence[Vertex]]
"""The boundary of a shape: rings with the interior on the left."""

BoxedEdge = tuple[Rational, Rational, Rational, Rational, Vertex, Vertex, int, int]
"""An edge: its box, rounded outwards to ints; its start and its end; the index of its ring, and its
index in the ring."""


class EdgeIndex:
    """An index of the edges of a shape or a path; rings have the interior on the left."""

    def __init__(self, rings: Rings) -> None:
        self.rings = rings

    @cached_property
    def box(self) -> Bounds:
        """The bounds of the shape."""
        return bound_points(chain.from_iterable(self.rings))

    @cached_property
    def is_path(self) -> bool:
        """Whether the rings enclose no area."""
        return not sum(cross(ring[k - 1], ring[k]) for ring in self.rings for k in range(len(ring)))

    @cached_property
    def edges(self) -> list[BoxedEdge]:
        """The edges, sorted by the left ends of their boxes."""
        found: list[BoxedEdge] = []
        for k, ring in enumerate(self.rings):
            ax, ay = ring[-1]
            for i, (bx, by) in enumerate(ring):
                left, right = (ax, bx) if ax < bx else (bx, ax)
                low, high = (ay, by) if ay < by else (by, ay)
                box = left // 1, -(-right // 1), low // 1, -(-high // 1)
                found.append((*box, (ax, ay), (bx, by), k, (i or len(ring)) - 1))
                ax, ay = bx, by
        found.sort()
        return found

    @cached_property
    def _rows(self) -> BoxRows:
        return BoxRows([edge[:4] for edge in self.edges])

    def near(self, box: Bounds) -> list[BoxedEdge]:
        """Return the edges whose boxes meet a box, sorted by their left ends."""
        return [self.edges[k] for k in sorted(self._rows.find(box))]

    def near_moved(self, box: Bounds, x: Rational, y: Rational, scale: int) -> list[BoxedEdge]:
        """Return the edges whose boxes meet a box after `move_edge`, in the same order."""
        left, right, low, high = box
        columns = (left - x) // scale, -((x - right) // scale)
        return self.near((*columns, (low - y) // scale, -((y - high) // scale)))

    def contains(self, x: Rational, y: Rational, scale: int) -> bool:
        """Decide by ray casting whether (x / scale, y / scale), not on an edge, is inside."""
        left, right, low, high = self.box
        if not (left * scale < x < right * scale and low * scale < y < high * scale):
            return False
        ray = left // 1, -(-x // scale), y // scale, -(-y // scale)
        return _is_around(x, y, ((edge[4], edge[5]) for edge in self.near(ray)), scale)


def move_edge(edge: BoxedEdge, x: Rational, y: Rational, scale: int) -> BoxedEdge:
    """Multiply an edge by a scale, then translate it by (x, y)."""
    left, right, low, high, (ax, ay), (bx, by), ring, k = edge
    a, b = (ax * scale + x, ay * scale + y), (bx * scale + x, by * scale + y)
    columns = left * scale + x, right * scale + x
    return (*columns, low * scale + y, high * scale + y, a, b, ring, k)


def is_inside(point: Vertex, rings: Rings) -> bool:
    """Decide whether a point is in the interior of a shape. Cost: O(n).

    >>> square = [[(0, 0), (2, 0), (2, 2), (0, 2)]]
    >>> is_inside((1, 1), square), is_inside((2, 1), square)
    (True, False)
    """
    edges = [edge for ring in rings for edge in pairwise((*ring, ring[0]))]
    return _is_around(*point, edges) and not any(is_on_segment(point, *edge) for edge in edges)


def _is_around(x: Rational, y: Rational, edges: Iterable[Edge], scale: int = 1) -> bool:
    """Decide whether a point off all edges has an odd number of edges on its left."""
    odd = False
    for (ax, ay), (bx, by) in edges:
        up = ay < by
        if (ay * scale <= y < by * scale) if up else (by * scale <= y < ay * scale):
            side = (bx - ax) * (y - ay * scale) - (by - ay) * (x - ax * scale)
            odd ^= (side < 0) == up
    return odd
