"""Shapes and exact fits as GeoJSON objects, the form of `__geo_interface__`.

Coordinates are ints or floats if these are exact, otherwise Fractions, which a floating-point
library rounds when it reads them.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any

from exactsweep.numbers.digits import is_float
from exactsweep.numbers.number import Fit, Point, PointRings

GeoJson = dict[str, Any]
"""A geometry object of GeoJSON, with tuples for lists."""


def make_polygon(rings: PointRings) -> GeoJson:
    """Make a GeoJSON Polygon from counter-clockwise rings, the exterior first.

    >>> square = [Point(*map(Fraction, p)) for p in ((0, 0), (1, 0), (1, 1), (0, 1))]
    >>> make_polygon([square])["coordinates"]
    (((0, 0), (1, 0), (1, 1), (0, 1), (0, 0)),)
    """
    exterior, *holes = rings
    turned = [exterior, *([hole[0], *hole[:0:-1]] for hole in holes)]
    coordinates = tuple(_list_points([*ring, ring[0]]) for ring in turned)
    return {"type": "Polygon", "coordinates": coordinates}


def make_line(points: Sequence[Point]) -> GeoJson:
    """Make a GeoJSON LineString, or a Point if all points are equal.

    >>> make_line([Point(Fraction(1), Fraction(1, 2))] * 2)
    {'type': 'Point', 'coordinates': (1, 0.5)}
    """
    listed = _list_points(points)
    if len({*listed}) == 1:
        return {"type": "Point", "coordinates": listed[0]}
    return {"type": "LineString", "coordinates": listed}


def collect(areas: Iterable[PointRings], fits: Iterable[Fit]) -> GeoJson:
    """Make a MultiPolygon of areas or, if there are exact fits, a GeometryCollection of both.

    >>> collect([], [])
    {'type': 'MultiPolygon', 'coordinates': ()}
    """
    polygons, lines = [*map(make_polygon, areas)], [*map(make_line, fits)]
    if lines:
        return {"type": "GeometryCollection", "geometries": (*polygons, *lines)}
    return {"type": "MultiPolygon", "coordinates": tuple(p["coordinates"] for p in polygons)}


def _list_points(points: Iterable[Point]) -> tuple[tuple[int | float | Fraction, ...], ...]:
    return tuple((_plain(x), _plain(y)) for x, y in points)


def _plain(value: Fraction) -> int | float | Fraction:
    """Convert a Fraction to the int or float of the same value, if there is one."""
    if value.denominator == 1:
        return value.numerator
    return float(value) if is_float(value) else value
