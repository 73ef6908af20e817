"""The features of a shape: its vertices and edges, numbered across all rings."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Literal

from exactsweep.geometry.edges import EdgeIndex
from exactsweep.geometry.region import AnyPolygon
from exactsweep.geometry.segment import Segment, make_segment
from exactsweep.geometry.vectors import is_between
from exactsweep.numbers.number import Edge, Point, Vertex


class Outline:
    """The boundary of a shape, interior on the left, as numbered features.

    Edge k runs from vertex k to the next vertex of its ring.

    Attributes:
        vertices: the vertices of all rings, ring by ring.
        after: for each vertex, the number of the next vertex of its ring.
        before: for each vertex, the number of the previous vertex of its ring.
        starts: for each ring, the number of its first vertex.
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
        self._index = EdgeIndex(rings)

    def edge(self, k: int) -> Edge:
        """Return the ends of edge k."""
        return self.vertices[k], self.vertices[self.after[k]]

    @property
    def edges(self) -> list[Edge]:
        """All edges, by number."""
        return [self.edge(k) for k in range(len(self.vertices))]

    @cached_property
    def pieces(self) -> list[Segment]:
        """All edges as segments of their lines."""
        return list(map(make_segment, self.edges))

    def find_at(self, point: Vertex, scale: int = 1) -> Iterator[tuple[Literal["V", "E"], int]]:
        """Find the vertices at point / scale, and the edges that contain it in their interior."""
        x, y = point
        box = x // scale, -(-x // scale), y // scale, -(-y // scale)
        for _, _, _, _, (ax, ay), (bx, by), ring, k in self._index.near(box):
            start = ax * scale, ay * scale
            if point == start:
                yield "V", self.starts[ring] + k
            elif is_between(point, start, (bx * scale, by * scale)):
                yield "E", self.starts[ring] + k


def number_features(
    shape: AnyPolygon,
) -> tuple[dict[int, Point], dict[int, tuple[int, int]]]:
    """Map vertex numbers of the input to points, and edge numbers to the numbers of both ends."""
    numbers = [shape.vertex_index(k) for k in range(len(shape))]
    ends = {
        shape.edge_index(k): (numbers[k], numbers[after])
        for k, after in enumerate(Outline(shape.rings).after)
    }
    return dict(zip(numbers, shape.vertices, strict=True)), ends
