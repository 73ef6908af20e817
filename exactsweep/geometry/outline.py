"""The features of a shape: vertices and edges, counted through all of its rings."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from functools import cached_property

from exactsweep.numbers.point import Edge, Rational, Vertex


class Outline:
    """The boundary of a shape, its interior on the left, for finding features by number.

    Edge k runs from vertex k to the next one of its ring.

    Args:
        rings: loops, not closed.

    Attributes:
        vertices: the vertices of all rings, one ring after another.
        after: for each vertex the number of the next one of its ring.
        before: for each vertex the number of the one before.
        starts: of each ring the number of its first vertex.
        numbers: dict from a vertex to its number, the last one of several.

    >>> square = Outline([[(0, 0), (1, 0), (1, 1), (0, 1)]])
    >>> square.edge(3), square.numbers[1, 1]
    (((0, 1), (0, 0)), 2)
    """

    def __init__(self, rings: Sequence[Sequence[Vertex]]) -> None:
        self.vertices: list[Vertex] = []
        self.after: list[int] = []
        self.before: list[int] = []
        self.starts: list[int] = []
        for ring in rings:
            first, size = len(self.vertices), len(ring)
            self.starts.append(first)
            self.vertices += ring
            self.after += [*range(first + 1, first + size), first]
            self.before += [first + size - 1, *range(first, first + size - 1)]
        self.numbers = {vertex: k for k, vertex in enumerate(self.vertices)}

    def edge(self, k: int) -> Edge:
        """Edge k."""
        return self.vertices[k], self.vertices[self.after[k]]

    @property
    def edges(self) -> list[Edge]:
        """All edges, by number."""
        return [self.edge(k) for k in range(len(self.vertices))]

    @cached_property
    def _by_x(self) -> tuple[list[Rational], list[int]]:
        order = sorted(range(len(self.vertices)), key=lambda k: self.vertices[k][0])
        return [self.vertices[k][0] for k in order], order

    def vertices_between(self, low: Rational, high: Rational) -> list[int]:
        """The numbers of the vertices in an x-range, ends included, by x.

        Cost: O(log n + their number), and the first time O(n log n).
        """
        xs, order = self._by_x
        return order[bisect_left(xs, low) : bisect_right(xs, high)]

    def scaled(self, factor: int) -> Outline:
        """The same, enlarged by a positive factor. Cost: O(n)."""
        larger = Outline([[(factor * x, factor * y) for x, y in self.vertices]])
        larger.after, larger.before, larger.starts = self.after, self.before, self.starts
        return larger

    def vertices_at(self, point: Vertex) -> Sequence[int]:
        """List the vertices at a point, one for each ring that touches there. Cost: O(1)."""
        return self._vertices_by_point.get(point, ())

    @cached_property
    def _vertices_by_point(self) -> dict[Vertex, list[int]]:
        found: dict[Vertex, list[int]] = {}
        for k, vertex in enumerate(self.vertices):
            found.setdefault(vertex, []).append(k)
        return found

    def edges_through(self, point: Vertex) -> Iterator[int]:
        """The numbers of the edges whose interior holds a point. Cost: O(n)."""
        tx, ty = point
        for k, (px, py) in enumerate(self.vertices):
            qx, qy = self.vertices[self.after[k]]
            if (px <= tx <= qx or qx <= tx <= px) and (
                (qx - px) * (ty - py) == (qy - py) * (tx - px)
                and (px, py) != point != (qx, qy)
                and (py <= ty <= qy or qy <= ty <= py)
            ):
                yield k
