"""Points and simple polygons: validated, immutable, in canonical form (Section 1 of the paper)."""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import chain
from math import lcm
from typing import Any, Self, cast

from exactsweep.geometry.canonical import (
    are_chains_monotone,
    canonicalize_ring,
    find_doubled_area,
    find_turns,
)
from exactsweep.geometry.point_set import AffineMap, PointSet
from exactsweep.geometry.reading import (
    read_vertices,
    reduce_lattice,
    to_lattice,
)
from exactsweep.numbers.digits import abridge, write_literal
from exactsweep.numbers.number import (
    Area,
    Point,
    Vertex,
    divide,
)

_SHOWN_VERTICES, _SHOWN_LENGTH = 8, 26


class Polygon(PointSet):
    """A simple polygon in canonical form; polygons are equal if they are the same set of points.

    Args:
        vertices: pairs of numbers that `to_fraction` accepts, a Polygon, or an object with a
            `__geo_interface__`, such as a shapely polygon, in either orientation. The first vertex
            may be repeated at the end; equal neighbors and collinear vertices are allowed.

    Raises:
        PolygonError: vertices that are not pairs, fewer than three distinct ones, zero area, a
            spike, or a boundary that touches or crosses itself. The message names vertices and
            edges by their index in the input; edge i runs from vertex i to the next.
        NumberError: a coordinate that is not an exact number.

    Cost: O(n) for a convex polygon of n vertices, O(n log n) for any other.

    Example:
        >>> Polygon([(0, 0), (0, 2), ("1/2", 1), (0, 0)])
        Polygon([(0, 0), ('1/2', 1), (0, 2)])
    """

    __slots__ = (
        "_convex",
        "_directions",
        "_edge_index",
        "_lattice",
        "_monotone",
        "_vertex_index",
        "_vertices",
    )

    _convex: bool | None
    _directions: Any  # the directions of monotonicity, cached by `direction`
    _monotone: bool | None
    _vertices: tuple[Point, ...] | None
    _lattice: tuple[int, tuple[Vertex, ...]] | None

    def __init__(self, vertices: "Polygon | Iterable[Iterable[object]]") -> None:
        if isinstance(vertices, Polygon):
            for name in Polygon.__slots__:
                setattr(self, name, getattr(vertices, name))
            return
        scale, points = read_vertices(vertices)
        ring = canonicalize_ring(points)
        self._set(ring.points, scale, ring.vertex_index, ring.edge_index)
        self._convex, self._monotone = ring.convex, ring.monotone

    def _set(self, points: Sequence[Vertex], scale: int | None, *numbers: Sequence[int]) -> None:
        self._vertices = self._lattice = self._convex = self._monotone = self._directions = None
        if scale is None:
            self._vertices = cast(tuple[Point, ...], tuple(points))
        else:
            self._lattice = reduce_lattice(scale, points)
        self._vertex_index, self._edge_index = numbers

    @classmethod
    def _trust(
        cls, points: Sequence[Vertex], scale: int | None = None, *numbers: Sequence[int]
    ) -> Self:
        """Make a Polygon without validation, from canonical Points or points on a lattice."""
        polygon = cls.__new__(cls)
        polygon._set(points, scale, *(numbers or [range(len(points))] * 2))
        return polygon

    @property
    def vertices(self) -> tuple[Point, ...]:
        """Tuple of Point: counter-clockwise, only corners, least first, not closed."""
        if self._vertices is None:
            scale, points = cast(tuple[int, Any], self.lattice())
            if not isinstance(points[0], Point):
                points = tuple(Point(divide(x, scale), divide(y, scale)) for x, y in points)
            self._vertices = points
        return self._vertices

    @property
    def exterior(self) -> "Polygon":
        """The polygon itself."""
        return self

    @property
    def holes(self) -> tuple["Polygon", ...]:
        """No holes."""
        return ()

    def lattice(self) -> tuple[int, tuple[Vertex, ...]]:
        """Return `(scale, points)`, the polygon on the coarsest integer lattice that contains it.

        The points are pairs of ints: the vertices times the scale, which is the least possible. If
        it would have more than 8192 bits, the scale is 1 and the points are the vertices.

        >>> Polygon([(0, 0), ("1/2", 0), (0, "1/3")]).lattice()
        (6, ((0, 0), (3, 0), (0, 2)))
        """
        if self._lattice is None:
            assert self._vertices is not None
            scale, points = to_lattice(self._vertices)
            self._lattice = scale, tuple(points)
        return self._lattice

    @property
    def area(self) -> Fraction:
        """The area, a positive Fraction."""
        scale, points = self.lattice()
        return Area(Fraction(find_doubled_area(points), 2 * scale * scale))

    @property
    def is_convex(self) -> bool:
        """Whether the polygon is convex."""
        if self._convex is None:
            self._convex = min(find_turns(self.lattice()[1])) > 0
        return self._convex

    @property
    def is_x_monotone(self) -> bool:
        """Whether the intersection with every vertical line is connected."""
        if self._monotone is None:
            self._monotone = are_chains_monotone(self.lattice()[1])
        return self._monotone

    def _image(self, under: AffineMap) -> "Polygon":
        """Return the image under an affine map, with the same vertex and edge numbering."""
        old, points = self.lattice()
        scale = old * lcm(*(c.denominator for c in under[:4]))
        scale = lcm(scale, under.dx.denominator, under.dy.denominator)
        a, b, c, d = (int(part * (scale // old)) for part in under[:4])
        dx, dy = int(under.dx * scale), int(under.dy * scale)
        image = [(a * x + b * y + dx, c * x + d * y + dy) for x, y in points]
        first, n = image.index(min(image)), len(image)
        order = starts = [*range(first, n), *range(first)]
        if a * d < b * c:
            order = [*range(first, -1, -1), *range(n - 1, first, -1)]
            # In reverse order, the edge from vertex k to vertex k + 1 started at vertex k + 1.
            starts = [*order[1:], first]
        found: Sequence[Vertex] = [image[k] for k in order]
        numbers = [self._vertex_index[k] for k in order], [self._edge_index[k] for k in starts]
        if all(type(part) is int for point in found for part in point):
            return Polygon._trust(found, scale, *numbers)
        # The lattice would be too fine, so keep rational vertices.
        found = [Point(Fraction(x) / scale, Fraction(y) / scale) for x, y in found]
        return Polygon._trust(found, None, *numbers)

    index, count = Sequence.index, Sequence.count

    def __eq__(self, other: object) -> bool:
        # Region.__eq__ handles regions.
        if not isinstance(other, Polygon):
            return NotImplemented
        return self.vertices == other.vertices

    def __reduce__(self) -> tuple[object, ...]:
        scale, points = self.lattice()
        return Polygon._trust, (points, scale, [*self._vertex_index], [*self._edge_index])

    def __hash__(self) -> int:
        return hash(self.vertices)

    def __repr__(self) -> str:
        vertices = [[*map(write_literal, v)] for v in self.vertices[:_SHOWN_VERTICES]]
        if len(self) > _SHOWN_VERTICES or max(map(len, chain(*vertices))) > _SHOWN_LENGTH:
            return f"<Polygon of {len(self)} vertices: {self}>"
        return f"Polygon([{', '.join(f'({x}, {y})' for x, y in vertices)}])"

    def __str__(self) -> str:
        shown = [f"({', '.join(map(abridge, v))})" for v in self.vertices[:_SHOWN_VERTICES]]
        if len(self) > _SHOWN_VERTICES:
            shown.append(f"... {len(self) - _SHOWN_VERTICES} more")
        return " ".join(shown)

    def __format__(self, spec: str) -> str:
        """Format all coordinates by a float format specifier, as in `f"{polygon:.3f}"`."""
        return " ".join(format(vertex, spec) for vertex in self.vertices) if spec else str(self)


Sequence.register(Polygon)
