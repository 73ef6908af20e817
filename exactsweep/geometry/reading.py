"""Readers that put vertices, given as pairs or a `__geo_interface__`, on an integer lattice."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from itertools import chain
from math import gcd, lcm
from typing import Any, cast
from warnings import warn

from exactsweep.geometry.canonical import PolygonError
from exactsweep.numbers.error import NumberError, prefix_errors, quote
from exactsweep.numbers.number import Point, Vertex, to_fraction

_LATTICE_BITS = 8192
_PACKAGE = "exactsweep."
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
    with prefix_errors(name):
        return Point(to_fraction(x), to_fraction(y))


def refuse_number(k: object, what: str, count: int) -> PolygonError:
    """Make the error for an out-of-range index k."""
    return PolygonError(f"there is no {what} {quote(k)}: they are numbered 0 to {count - 1}")


def read_interface(shape: object) -> list[Pairs] | None:
    """Read the exterior and the holes of an object with a `__geo_interface__`, or a GeoJSON dict.

    Z coordinates are dropped, with a warning. Returns None for other objects; raises PolygonError
    unless the object is a single nonempty polygon.

    >>> import shapely
    >>> read_interface(shapely.box(0, 0, 2, 1))
    [[(2.0, 0.0), (2.0, 1.0), (0.0, 1.0), (0.0, 0.0), (2.0, 0.0)]]
    """
    interface: Any = shape if _is_geojson(shape) else getattr(shape, "__geo_interface__", None)
    if isinstance(interface, Mapping) and interface.get("type") == "Feature":
        interface = interface.get("geometry")
    if interface is None:
        return None
    kind = interface.get("type") if isinstance(interface, Mapping) else type(interface).__name__
    if kind not in ("Polygon", "LinearRing"):
        raise PolygonError(f"a {kind} is not a polygon{_HINTS.get(str(kind), '')}")
    coordinates = interface.get("coordinates")
    rings = coordinates if kind == "Polygon" else [coordinates]
    if not isinstance(rings, Sequence) or not all(isinstance(ring, Iterable) for ring in rings):
        raise PolygonError(f"a {kind} without rings is not a polygon")
    # Some iterables can be read only once.
    rings = [[*ring] for ring in rings]
    if not any(rings):
        raise PolygonError("the polygon is empty")
    return list(map(drop_heights, rings)) if any(map(has_heights, rings)) else [*rings]


def _is_geojson(shape: object) -> bool:
    return isinstance(shape, Mapping) and not {"geometry", "coordinates"}.isdisjoint(shape)


def has_heights(ring: Sequence[object]) -> bool:
    """Decide whether any point of a ring has a Z coordinate."""
    return any(isinstance(point, Sequence) and len(point) == 3 for point in ring)


def drop_heights(ring: list[Any]) -> list[Any]:
    """Drop the Z coordinates of a ring, with a warning attributed to the package's caller."""
    level, frame = 1, sys._getframe()
    while frame.f_back and frame.f_globals.get("__name__", "").startswith(_PACKAGE):
        level, frame = level + 1, frame.f_back
    warn("Z coordinates are dropped: a sweep is planar", stacklevel=level)
    return [point[:2] if len(point) == 3 else point for point in ring]


def read_vertices(vertices: Iterable[Iterable[object]]) -> Lattice:
    """Read the vertices of a polygon, and put them on a lattice as `to_lattice` does.

    Raises PolygonError for a vertex that is not a pair, or for a polygon with holes, and
    NumberError for a coordinate that is not an exact number.

    >>> read_vertices([(0, 1), ("1/2", 0), [2, 0.5]])
    (2, [(0, 2), (1, 0), (4, 1)])
    """
    if isinstance(vertices, (set, frozenset)):
        raise PolygonError("the vertices are a set, which has no order")
    if isinstance(vertices, (str, bytes, Mapping)) and read_interface(vertices) is None:
        raise PolygonError(
            f"{type(vertices).__name__} is not a sequence of vertices; in exactsweep.formats, "
            "from_wkt reads WKT, and parse_region reads JSON, GeoJSON and other texts"
        )
    rings = read_interface(vertices)
    if rings is not None:
        if len(rings) > 1:
            raise PolygonError("the polygon has holes; use a Region")
        (vertices,) = rings
    try:
        pairs = iter(vertices)
    except TypeError:
        raise PolygonError(f"{type(vertices).__name__} is not a sequence of vertices") from None
    rows = list(pairs)
    if all(type(row) in (tuple, list) and len(row) == 2 for row in rows):  # type: ignore[arg-type]
        if all(type(x) is int and type(y) is int for x, y in rows):
            return 1, cast(Sequence[Vertex], [*map(tuple, rows)])
        # Errors name the vertex below.
        with suppress(NumberError):
            return to_lattice([Point(to_fraction(x), to_fraction(y)) for x, y in rows])
    points = [read_point(pair, f"vertex {i}") for i, pair in enumerate(rows)]
    return to_lattice(points)


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


def reduce_lattice(scale: int, points: tuple[Vertex, ...]) -> tuple[int, tuple[Vertex, ...]]:
    """Divide a scale and its points by their common divisor."""
    # If the scale is above one, all coordinates are ints.
    common = scale
    for coordinate in chain.from_iterable(points):
        if common == 1:
            return scale, points
        common = gcd(common, int(coordinate))
    if common == 1:
        return scale, points
    return scale // common, tuple((x // common, y // common) for x, y in points)


def lcm_within(denominators: Iterable[int], bits: int = _LATTICE_BITS) -> int | None:
    """Return the least common multiple, or None if it has more than the given number of bits."""
    scale = 1
    for denominator in denominators:
        scale = lcm(scale, denominator)
        if scale.bit_length() > bits:
            return None
    return scale
