"""Readers that put vertices, given as pairs or a `__geo_interface__`, on an integer lattice."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain
from math import gcd, lcm
from typing import Any, cast
from warnings import warn

from exactsweep.geometry.canonical import PolygonError
from exactsweep.numbers.error import NumberError, quote
from exactsweep.numbers.number import Point, Vertex, to_fraction

LATTICE_BITS = 8192
_TWO_INTS = [int, int]
_PACKAGE = "exactsweep."
_GEOJSON = {"type", "geometry", "coordinates"}
_HINTS = {
    **dict.fromkeys(("LineString", "Point"), "; Polyline reads it"),
    **dict.fromkeys(
        ("MultiPolygon", "GeometryCollection"),
        "; parts_from_shapely of exactsweep.formats reads its polygons",
    ),
}

Lattice = tuple[int, Sequence[Vertex]]
"""A scale and points; each point represents its coordinates divided by the scale."""

Pairs = Iterable[Iterable[object]]


def read_point(pair: Iterable[object], name: str) -> Point:
    """Read a pair of numbers; errors begin with the given name."""
    # Strings, sets and mappings unpack too, but not into coordinates.
    if isinstance(pair, (str, bytes, set, frozenset, dict)):
        raise PolygonError(f"{name} is {type(pair).__name__}, not a pair of numbers")
    try:
        x, y = pair
    except (TypeError, ValueError):
        raise PolygonError(f"{name} is {quote(pair)}, not a pair of numbers") from None
    try:
        return Point(to_fraction(x), to_fraction(y))
    except NumberError as error:
        raise NumberError(f"{name}: {error}") from None


def find_geometry(shape: object) -> Mapping[str, Any] | None:
    """Return the geometry of a GeoJSON dict or a `__geo_interface__`; None for other objects."""
    is_geojson = isinstance(shape, Mapping) and not _GEOJSON.isdisjoint(shape)
    found = shape if is_geojson else getattr(shape, "__geo_interface__", None)
    if isinstance(found, Mapping) and found.get("type") == "Feature":
        found = found.get("geometry")
    return found if isinstance(found, Mapping) else None


def read_interface(shape: object) -> list[Pairs] | None:
    """Read the exterior and the holes of an object with a `__geo_interface__`, or a GeoJSON dict.

    Z coordinates are dropped, with a warning. Returns None for other objects; raises PolygonError
    unless the object is a single nonempty polygon.

    >>> import shapely
    >>> read_interface(shapely.box(0, 0, 2, 1))
    [[(2.0, 0.0), (2.0, 1.0), (0.0, 1.0), (0.0, 0.0), (2.0, 0.0)]]
    """
    geometry = find_geometry(shape)
    if geometry is None:
        return None
    kind, coordinates = geometry.get("type"), geometry.get("coordinates")
    if kind not in ("Polygon", "LinearRing"):
        raise PolygonError(f"a {kind} is not a polygon{_HINTS.get(str(kind), '')}")
    rings: Any = coordinates if kind == "Polygon" else [coordinates]
    if not isinstance(rings, Sequence) or not all(isinstance(ring, Iterable) for ring in rings):
        raise PolygonError(f"a {kind} without rings is not a polygon")
    found: list[Pairs] = [drop_heights(ring) for ring in rings]
    if not any(found):
        raise PolygonError("the polygon is empty")
    return found


def drop_heights(points: Iterable[Any]) -> list[Any]:
    """List points without Z coordinates; if any are dropped, warn the package's caller."""
    listed = [*points]
    if not any(isinstance(point, Sequence) and len(point) == 3 for point in listed):
        return listed
    level, frame = 1, sys._getframe()
    while frame.f_back and frame.f_globals.get("__name__", "").startswith(_PACKAGE):
        level, frame = level + 1, frame.f_back
    warn("Z coordinates are dropped: a sweep is planar", stacklevel=level)
    return [point[:2] if len(point) == 3 else point for point in listed]


def read_vertices(vertices: Iterable[Iterable[object]]) -> Lattice:
    """Read the vertices of a polygon, and put them on a lattice as `to_lattice` does.

    Raises PolygonError for a vertex that is not a pair, or for a polygon with holes, and
    NumberError for a coordinate that is not an exact number.

    >>> read_vertices([(0, 1), ("1/2", 0), [2, 0.5]])
    (2, [(0, 2), (1, 0), (4, 1)])
    """
    if isinstance(vertices, (set, frozenset)):
        raise PolygonError("the vertices are a set, which has no order")
    rings = read_interface(vertices)
    if rings is not None:
        if len(rings) > 1:
            raise PolygonError("the polygon has holes; use a Region")
        (vertices,) = rings
    elif isinstance(vertices, (str, bytes, Mapping)):
        raise PolygonError(
            f"{type(vertices).__name__} is not a sequence of vertices; in exactsweep.formats, "
            "from_wkt reads WKT, and parse_region reads JSON, GeoJSON and other texts"
        )
    try:
        pairs = iter(vertices)
    except TypeError:
        raise PolygonError(f"{type(vertices).__name__} is not a sequence of vertices") from None
    rows: list[Any] = list(pairs)
    if all(type(row) in (tuple, list) and [*map(type, row)] == _TWO_INTS for row in rows):
        return 1, [*map(tuple, rows)]
    return to_lattice([read_point(pair, f"vertex {i}") for i, pair in enumerate(rows)])


def to_lattice(points: Sequence[Point]) -> Lattice:
    """Put points on the coarsest integer lattice that contains them.

    Returns the scale, which is the least common denominator, and the points times the scale, as
    pairs of ints. If the scale would exceed 8192 bits, it is 1 and the points are unchanged: with
    unrelated denominators, each int would be longer than all coordinates together.
    """
    scale = lcm_within({c.denominator for point in points for c in point})
    if scale is None:
        return 1, points
    return scale, [
        (x.numerator * (scale // x.denominator), y.numerator * (scale // y.denominator))
        for x, y in points
    ]


def reduce_lattice(scale: int, points: Sequence[Vertex]) -> tuple[int, tuple[Vertex, ...]]:
    """Divide a scale and its points by their common divisor."""
    # If the scale is above one, all coordinates are ints.
    common = 1 if scale == 1 else gcd(scale, *cast(Iterator[int], chain.from_iterable(points)))
    if common == 1:
        return scale, tuple(points)
    return scale // common, tuple((x // common, y // common) for x, y in points)


def lcm_within(denominators: Iterable[int], bits: int = LATTICE_BITS) -> int | None:
    """Return the least common multiple, or None if it has more than the given number of bits."""
    scale = 1
    for denominator in denominators:
        scale = lcm(scale, denominator)
        if scale.bit_length() > bits:
            return None
    return scale
