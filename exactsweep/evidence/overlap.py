"""Overlap of two fixed shapes: verdict, area, witness, and the shortest separating move."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from exactsweep.evidence.minkowski import solve_pair
from exactsweep.geometry.distance import (
    SquaredDistance,
    distance_squared,
    find_foot,
)
from exactsweep.geometry.edges import EdgeIndex, Rings
from exactsweep.geometry.intersection import (
    find_common_boundary,
    find_common_point,
    measure_common_area,
)
from exactsweep.geometry.overlap import relate
from exactsweep.geometry.region import Region, Vertices, share_lattice, to_region
from exactsweep.numbers.error import explain_type_errors
from exactsweep.numbers.number import ORIGIN, Area, Edge, Point


@dataclass(frozen=True, repr=False)
class Overlap:
    """The relation of two shapes at fixed positions; see `exactsweep.overlap`.

    Each property is computed on first access, exactly. Two overlaps are equal if their shapes are.

    Attributes:
        a: a Region.
        b: another Region.
    """

    a: Region
    b: Region

    @cached_property
    def _lattice(self) -> tuple[int, list[Rings]]:
        scale, (first, second) = share_lattice([self.a, self.b])
        return scale, [first, second]

    @cached_property
    def verdict(self) -> str:
        """The relation: "OVERLAP" if interiors meet, "CONTACT" if only boundaries do, or "FREE"."""
        first, second = self._lattice[1]
        relation: str = relate(EdgeIndex(first), EdgeIndex(second)).value
        return relation

    @cached_property
    def _boundary(self) -> list[Edge]:
        return find_common_boundary(*self._lattice[1]) if self.verdict == "OVERLAP" else []

    @cached_property
    def area(self) -> Fraction:
        """The area of the intersection."""
        return Area(measure_common_area(self._boundary) / self._lattice[0] ** 2)

    @cached_property
    def witness(self) -> Point | None:
        """A point inside both shapes, or a common point of shapes in contact, or None."""
        if self.verdict == "FREE":
            return None
        if self.verdict == "CONTACT":
            return self._distance.points[0]
        scale, rings = self._lattice
        x, y = find_common_point(self._boundary, *rings)
        return Point(x / scale, y / scale)

    @cached_property
    def _distance(self) -> SquaredDistance:
        return distance_squared(self.a, self.b)

    @property
    def distance_squared(self) -> Fraction:
        """The squared distance between the shapes, 0 if they have a common point."""
        return Fraction(0) if self.verdict != "FREE" else self._distance.value

    @property
    def nearest(self) -> tuple[Point, Point]:
        """Two nearest points, one of each shape; equal if the shapes have a common point."""
        point = self.witness
        return self._distance.points if point is None else (point, point)

    @cached_property
    def move(self) -> Point:
        """The shortest translation of b after which the shapes do not overlap.

        It may lead into a hole or a cavity of the other shape, or to an exact fit. Among equally
        short ones, it is the lexicographically least.
        """
        if self.verdict != "OVERLAP":
            return ORIGIN
        found = solve_pair(self.a, self.b)
        loops = [found.trajectory, *found.holes]
        edges = [edge for loop in loops for edge in zip(loop, (*loop[1:], loop[0]), strict=True)]
        feet = (find_foot(ORIGIN, edge) for edge in (*edges, *found.fits))
        return min(feet, key=lambda p: (p.x * p.x + p.y * p.y, p))

    @property
    def depth_squared(self) -> Fraction:
        """The squared length of the shortest move, 0 if the shapes do not overlap."""
        x, y = self.move
        return x * x + y * y

    def __repr__(self) -> str:
        return f"<Overlap of {len(self.a)} and {len(self.b)} vertices: {self.verdict}>"


@explain_type_errors
def overlap(a: Region | Vertices, b: Region | Vertices) -> Overlap:
    """Relate two shapes in place: whether and how far they overlap, and how far apart they are.

    Args:
        a: a Polygon, a Region, the vertices of a polygon, or a shapely polygon; holes are allowed.
        b: the other shape, in any of these forms.

    Returns:
        An Overlap with `verdict`, `area`, `witness`, `distance_squared`, `move` and
        `depth_squared`.

    Raises:
        PolygonError: a shape is not valid.
        NumberError: a coordinate is not an exact number. Messages begin with "a" or "b".

    Cost: O((m + n) log(m + n)) for the verdict, if few edges are near each other; for the shortest
    move, as for `no_fit_polygon`.

    Example:
        >>> o = overlap([(0, 0), (4, 0), (4, 4), (0, 4)], [(2, 2), (6, 2), (6, 6), (2, 6)])
        >>> o.verdict, o.area, o.move, o.depth_squared
        ('OVERLAP', Fraction(4, 1), Point(x=Fraction(0, 1), y=Fraction(2, 1)), Fraction(4, 1))
    """
    return Overlap(to_region(a, "a"), to_region(b, "b"))
