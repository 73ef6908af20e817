"""Points and simple polygons: validated, immutable, in canonical form (Section 1 of the paper)."""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import chain
from math import lcm
from typing import TYPE_CHECKING, Any, Self, cast

from exactsweep.geometry.canonical import (
    PolygonError,
    are_chains_monotone,
    canonicalize_ring,
    find_doubled_area,
    find_turns,
)
from exactsweep.geometry.point_set import AffineMap, PointSet
from exactsweep.geometry.reading import (
    read_vertices,
    reduce_lattice,
    refuse_number,
    to_lattice,
)
from exactsweep.numbers.digits import abridge, write_literal
from exactsweep.numbers.number import (
    Area,
    Point,
    Vertex,
)

if TYPE_CHECKING:
    import sympy

_SHOWN_VERTICES, _SHOWN_LENGTH = 8, 26


class Polygon(PointSet):
    """A simple polygon in canonical form; polygons are equal if they are the same set of points.

    Args:
        vertices: pairs of numbers that `to_fraction` accepts, a Polygon, or an object with a
            `__geo_interface__`, such as a shapely polygon, in either orientation. The first vertex
            may be repeated at the end; equal neighbours and collinear vertices are allowed.

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
    _vertex_index: Sequence[int]
    _edge_index: Sequence[int]

    def __init__(self, vertices: "Polygon | Iterable[Iterable[object]]") -> None:
        if isinstance(vertices, Polygon):
            self._vertices, self._lattice = vertices._vertices, vertices._lattice
            self._convex, self._monotone = vertices._convex, vertices._monotone
            self._directions = vertices._directions
            self._vertex_index, self._edge_index = vertices._vertex_index, vertices._edge_index
            return
        scale, points = read_vertices(vertices)
        ring = canonicalize_ring(points)
        self._vertices = None
        self._lattice = reduce_lattice(scale, ring.points)
        self._vertex_index, self._edge_index = ring.vertex_index, ring.edge_index
        self._convex, self._monotone = ring.convex, ring.monotone
        self._directions = None

    @classmethod
    def _trust(
        cls,
        points: Sequence[Vertex],
        scale: int | None = None,
        vertex_index: Sequence[int] | None = None,
        edge_index: Sequence[int] | None = None,
    ) -> Self:
        """Make a Polygon from canonical points, divided by the scale, without validation."""
        polygon = cls.__new__(cls)
        polygon._vertices = polygon._lattice = None
        if scale is None:
            polygon._vertices = cast(tuple[Point, ...], tuple(points))
        else:
            polygon._lattice = reduce_lattice(scale, tuple(points))
        polygon._convex = polygon._monotone = polygon._directions = None
        polygon._vertex_index = vertex_index or range(len(points))
        polygon._edge_index = edge_index or range(len(points))
        return polygon

    @property
    def vertices(self) -> tuple[Point, ...]:
        """Tuple of Point: counter-clockwise, only corners, least first, not closed."""
        if self._vertices is None:
            scale, points = self.lattice()
            self._vertices = tuple(Point(Fraction(x, scale), Fraction(y, scale)) for x, y in points)
        return self._vertices

    @property
    def exterior(self) -> "Polygon":
        """The polygon itself."""
        return self

    @property
    def holes(self) -> tuple["Polygon", ...]:
        """No holes."""
        return ()

    @property
    def rings(self) -> tuple[tuple[Point, ...], ...]:
        """The vertices, as the only ring."""
        return (self.vertices,)

    def lattice(self) -> tuple[int, tuple[Vertex, ...]]:
        """Return `(scale, points)`, the polygon on the coarsest integer lattice that contains it.

        The points are pairs of ints: the vertices times the scale, which is the least possible. If
        it would have more than 8192 bits, the scale is 1 and the points are the vertices.

        Example:
            >>> Polygon([(0, 0), ("1/2", 0), (0, "1/3")]).lattice()
            (6, ((0, 0), (3, 0), (0, 2)))
        """
        if self._lattice is None:
            assert self._vertices is not None
            scale, points = to_lattice(self._vertices)
            self._lattice = scale, tuple(points)
        return self._lattice

    def vertex_index(self, k: int) -> int:
        """Return the input index of vertex k; negative k count from the end.

        Raises PolygonError if there is no vertex k.
        """
        try:
            return self._vertex_index[k]
        except (TypeError, IndexError):
            raise refuse_number(k, "vertex", len(self)) from None

    def edge_index(self, k: int) -> int:
        """Return the input index of edge k, from vertex k to k + 1.

        If several collinear input edges form edge k, it is the first. Raises PolygonError if there
        is no edge k.

        Example:
            >>> clockwise = Polygon([(0, 0), (0, 2), (2, 0)])
            >>> [clockwise.edge_index(k) for k in range(3)]
            [2, 1, 0]
        """
        try:
            return self._edge_index[k]
        except (TypeError, IndexError):
            raise refuse_number(k, "edge", len(self)) from None

    def _scaled(self) -> tuple[int, Sequence[Vertex]]:
        """Return the lattice if known, otherwise the vertices with scale 1."""
        return self._lattice or (1, self.vertices)

    @property
    def area(self) -> Fraction:
        """The area, a positive Fraction."""
        scale, points = self._scaled()
        return Area(Fraction(find_doubled_area(points), 2 * scale * scale))

    @property
    def is_convex(self) -> bool:
        """Whether the polygon is convex."""
        if self._convex is None:
            self._convex = min(find_turns(self._scaled()[1])) > 0
        return self._convex

    @property
    def is_x_monotone(self) -> bool:
        """Whether the intersection with every vertical line is connected."""
        if self._monotone is None:
            self._monotone = are_chains_monotone(self._scaled()[1])
        return self._monotone

    def _image(self, under: AffineMap) -> "Polygon":
        """Return the image under an affine map, with the same vertex and edge numbering."""
        old, points = self.lattice()
        denominator = lcm(*(c.denominator for c in under[:4]))
        scale = lcm(denominator * old, under.dx.denominator, under.dy.denominator)
        a, b, c, d = (int(part * denominator) * (scale // denominator // old) for part in under[:4])
        dx, dy = int(under.dx * scale), int(under.dy * scale)
        image = [(a * x + b * y + dx, c * x + d * y + dy) for x, y in points]
        vertex_index, edge_index = list(self._vertex_index), list(self._edge_index)
        if a * d < b * c:
            # In reverse order, the edge after a vertex is the edge that preceded it.
            image, vertex_index = image[::-1], vertex_index[::-1]
            edge_index = [*edge_index[-2::-1], edge_index[-1]]
        first = image.index(min(image))
        image = image[first:] + image[:first]
        numbers = [row[first:] + row[:first] for row in (vertex_index, edge_index)]
        if all(type(part) is int for point in image for part in point):
            return Polygon._trust(image, scale, *numbers)
        # The lattice would be too fine, so keep rational vertices.
        found = [Point(Fraction(x) / scale, Fraction(y) / scale) for x, y in image]
        return Polygon._trust(found, None, *numbers)

    def to_sympy(self) -> "sympy.Polygon":
        """Return the polygon as a `sympy.geometry.Polygon`.

        sympy detects collinear vertices in floating point. Raises PolygonError if it would drop
        vertices.
        """
        import sympy

        polygon = sympy.Polygon(
            *(
                tuple(sympy.Rational(c.numerator, c.denominator) for c in vertex)
                for vertex in self.vertices
            )
        )
        if not isinstance(polygon, sympy.Polygon) or len(polygon.vertices) != len(self):
            raise PolygonError("sympy would drop vertices that it takes for collinear")
        return polygon

    @classmethod
    def from_sympy(cls, polygon: "sympy.Polygon") -> "Polygon":
        """Read a rational `sympy.geometry.Polygon`, a triangle or a regular polygon.

        Raises PolygonError for other objects and for polygons that `Polygon` rejects, NumberError
        for irrational or symbolic coordinates.
        """
        import sympy

        # sympy.Polygon(...) returns a Segment or a Point for collinear vertices.
        if not isinstance(polygon, sympy.Polygon):
            raise PolygonError(f"a sympy {type(polygon).__name__} is not a polygon")
        return cls(polygon.vertices)

    def __len__(self) -> int:
        return len(self._vertex_index)

    def index(self, vertex: object, start: int = 0, stop: int | None = None) -> int:
        """Return the index of a vertex; raise ValueError if there is none, as a tuple does."""
        return self.vertices.index(cast(Point, vertex), start, len(self) if stop is None else stop)

    def count(self, vertex: object) -> int:
        """Return 1 for a vertex and 0 for any other point."""
        return self.vertices.count(cast(Point, vertex))

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

    def _facts(self) -> list[tuple[str, str]]:
        return [("area", abridge(self.area)), ("convex", "yes" if self.is_convex else "no")]


Sequence.register(Polygon)
