"""Polylines: open or closed paths of segments, or single points."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from itertools import groupby

from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.interface import GeoJson, make_line
from exactsweep.geometry.reading import drop_heights, find_geometry, read_vertices
from exactsweep.numbers.digits import write_literal
from exactsweep.numbers.number import Point
from exactsweep.words import write_pair

_KINDS = ("Point", "LineString", "LinearRing")


@dataclass(frozen=True, init=False, repr=False)
class Polyline:
    """A path of segments; polylines are equal if they have the same points in the same order.

    Args:
        points: one or more pairs of numbers, as for `Polygon`; a Polyline; or a GeoJSON Point,
            LineString or LinearRing, as a dict or a `__geo_interface__`. Z coordinates are dropped.
            Repeated consecutive points count once. The path may cross itself.
        closed: whether a segment joins the last point to the first.

    Raises:
        PolygonError: no point, or an object that is not a path.
        NumberError: a coordinate that is not an exact number. The message begins with the vertex.

    Cost: O(n).

    Example:
        >>> Polyline([(0, 0), (3, 0), (3, "1/2")]).points[2]
        Point(x=Fraction(3, 1), y=Fraction(1, 2))
        >>> import shapely
        >>> print(Polyline(shapely.LineString([(0, 0), (1, 2)])))
        (0,0) (1,2)
    """

    points: tuple[Point, ...]
    closed: bool

    def __init__(
        self, points: Polyline | Iterable[Iterable[object]], *, closed: bool = False
    ) -> None:
        if isinstance(points, Polyline):
            found, closed = list(points.points), closed or points.closed
        else:
            scale, read = read_vertices(_read_path(points))
            found = [Point(Fraction(x, scale), Fraction(y, scale)) for x, y in read]
        found = [point for point, _ in groupby(found)]
        if not found:
            raise PolygonError("a path needs at least one point")
        if closed and len(found) > 1 and found[0] == found[-1]:
            found.pop()
        object.__setattr__(self, "points", tuple(found))
        object.__setattr__(self, "closed", closed)

    def __len__(self) -> int:
        return len(self.points)

    @property
    def __geo_interface__(self) -> GeoJson:
        """The path as a GeoJSON LineString or Point; a closed path repeats its first point."""
        return make_line([*self.points, *self.points[:1]] if self.closed else self.points)

    def __repr__(self) -> str:
        points = ", ".join(f"({write_literal(x)}, {write_literal(y)})" for x, y in self.points)
        return f"Polyline([{points}]{', closed=True' if self.closed else ''})"

    def __str__(self) -> str:
        return " ".join(map(write_pair, self.points)) + (" closed" if self.closed else "")


def _read_path(points: Iterable[Iterable[object]]) -> Iterable[Iterable[object]]:
    geometry = find_geometry(points)
    if geometry is None:
        return points
    kind, coordinates = geometry.get("type"), geometry.get("coordinates")
    if kind not in _KINDS:
        raise PolygonError(f"a {kind} is not a path")
    if not isinstance(coordinates, Iterable):
        raise PolygonError(f"a {kind} without coordinates is not a path")
    return drop_heights([coordinates] if kind == "Point" else coordinates)
