"""Conversion to and from shapely, numpy and sympy."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Protocol

from exactsweep.formats.candidate import NamedRegion
from exactsweep.formats.choice import choose
from exactsweep.formats.error import FormatError
from exactsweep.formats.part_list import PartList, Remarks
from exactsweep.formats.wkt import parse_wkt
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import AnyPolygon, Region
from exactsweep.numbers.digits import abridge
from exactsweep.numbers.error import explain_type_errors, quote, require_imports
from exactsweep.numbers.number import Point

if TYPE_CHECKING:
    import numpy
    import shapely
    import sympy


class HasGeoInterface(Protocol):
    """A shape or an answer with a GeoJSON representation."""

    @property
    def __geo_interface__(self) -> dict[str, Any]: ...


@explain_type_errors
def from_shapely(geometry: shapely.Polygon) -> AnyPolygon:
    """Convert a shapely Polygon or LinearRing to a Polygon, or to a Region if it has holes.

    Floats keep their exact binary values; Z coordinates are dropped, with a warning. Raises
    FormatError for other geometries, and otherwise the errors of `Region`.

    >>> import shapely
    >>> print(from_shapely(shapely.box(0, 0, 1.5, 1)))
    (0, 0) (3/2, 0) (3/2, 1) (0, 1)
    """
    kind = getattr(geometry, "geom_type", type(geometry).__name__)
    if kind not in ("Polygon", "LinearRing"):
        raise FormatError(f"{kind} is not a shapely polygon")
    if geometry.is_empty:
        raise FormatError("the polygon is empty")
    found = Region(geometry)
    return found if found.holes else found.exterior


@explain_type_errors
def parts_from_shapely(geometries: Iterable[shapely.Geometry]) -> PartList[NamedRegion]:
    """Convert all polygons in shapely geometries; raises FormatError if there are none.

    Args:
        geometries: a MultiPolygon or a collection, several geometries, or a geopandas GeoSeries,
            whose index names the parts.

    Returns:
        A PartList of NamedRegion, in order; `left_out` lists elements that are not polygons.

    Example:
        >>> import shapely
        >>> both = shapely.MultiPolygon([shapely.box(0, 0, 1, 1), shapely.box(2, 0, 4, 1)])
        >>> [part.region.area for part in parts_from_shapely(both)]
        [Fraction(1, 1), Fraction(2, 1)]
    """

    def read(part: tuple[str | None, shapely.Geometry], remarks: Remarks) -> list[NamedRegion]:
        return [NamedRegion(Region(from_shapely(part[1])), part[0])]

    return PartList(_list_parts(geometries)).read_each(read)


def _list_parts(geometries: Any, name: str | None = None) -> Iterator[tuple[str | None, Any]]:
    """Flatten nested geometries; the index of a series names its elements."""
    if hasattr(geometries, "geoms"):
        geometries = geometries.geoms
    if hasattr(geometries, "geom_type") and not hasattr(geometries, "items"):
        yield name, geometries
    elif hasattr(geometries, "items"):
        for key, geometry in geometries.items():
            yield from _list_parts(geometry, str(key))
    else:
        for geometry in geometries:
            yield from _list_parts(geometry, name)


@explain_type_errors
def from_wkt(text: str) -> AnyPolygon:
    """Read a WKT POLYGON, or a MULTIPOLYGON with one element, as a Polygon or Region.

    Raises:
        FormatError: not WKT, or several polygons (use `parse_regions`).
        PolygonError: not a region.

    Example:
        >>> print(from_wkt("POLYGON ((0 0, 0.1 0, 0 1, 0 0))"))
        (0, 0) (1/10, 0) (0, 1)
    """
    return choose(parse_wkt(text), None).shape()


@explain_type_errors
def to_shapely(shape: HasGeoInterface, *, nearest: bool = False) -> shapely.Geometry:
    """Convert a shape or an answer to a shapely geometry with float coordinates.

    Args:
        shape: a Polygon, a Region, a Polyline, or an answer: a Sweep (its area), a NoFitPolygon, an
            InnerFit, or a Layout (its placed parts).
        nearest: whether to round to the nearest floats; edges may then cross.

    Returns:
        A shapely Polygon; for an InnerFit a MultiPolygon; for an answer with exact fits and for a
        Layout a GeometryCollection; for a Polyline a LineString or Point.

    Raises:
        FormatError: a coordinate is not a float (unless `nearest`), or exceeds the float range.

    Example:
        >>> print(to_shapely(Polygon([(0, 0), ("1/2", 0), (0, 1)])))
        POLYGON ((0 0, 0.5 0, 0 1, 0 0))
    """
    with require_imports("shapely", "a shapely geometry", FormatError):
        import shapely.geometry

    if not isinstance(shape, (Polygon, Region)):
        described = getattr(shape, "__geo_interface__", None)
        if described is None:
            raise FormatError(f"{quote(shape)} is neither a shape nor an answer")
        return shapely.geometry.shape(_to_floats(described, nearest))
    shell, *holes = shape.rings
    rows = _floats(shell, nearest)
    inner = [_floats(hole, nearest, f"hole {k}, ") for k, hole in enumerate(holes)]
    return shapely.Polygon(rows, inner)


def _to_floats(node: Any, nearest: bool) -> Any:
    if isinstance(node, dict):
        return {key: _to_floats(value, nearest) for key, value in node.items()}
    if isinstance(node, tuple):
        if len(node) == 2 and all(isinstance(c, int | float | Fraction) for c in node):
            point = Point(*map(Fraction, node))
            return tuple(_float(c, str(point), nearest) for c in point)
        return [_to_floats(value, nearest) for value in node]
    return node


@explain_type_errors
def from_numpy(array: numpy.ndarray) -> Polygon:
    """Convert an array of shape (n, 2) to a polygon.

    The array has ints, floats (with their exact binary values), or objects that `to_fraction`
    accepts. Raises FormatError for other shapes, and otherwise the errors of `Polygon`.

    >>> import numpy
    >>> print(from_numpy(numpy.array([[0, 0], [1, 0], [0, 0.5]])))
    (0, 0) (1, 0) (0, 1/2)
    """
    if len(array.shape) != 2 or array.shape[1] != 2:
        raise FormatError(f"the array has shape {array.shape}, not (n, 2)")
    return Polygon(array)


@explain_type_errors
def to_numpy(polygon: Polygon, dtype: str = "object", *, nearest: bool = False) -> numpy.ndarray:
    """Convert the vertices to an array of shape (n, 2).

    Args:
        polygon: a Polygon.
        dtype: "object" for Fractions, "int64" or "float64".
        nearest: as for `to_shapely`; only for "float64".

    Raises FormatError for another dtype, or a coordinate that the dtype cannot represent.

    Example:
        >>> to_numpy(Polygon([(0, 0), (1, 0), (0, "1/2")]), "float64").tolist()
        [[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]]
    """
    with require_imports("numpy", "an array", FormatError):
        import numpy

    if dtype == "object":
        return numpy.array([list(vertex) for vertex in polygon.vertices], dtype=object)
    if dtype == "float64":
        return numpy.array(_floats(polygon.vertices, nearest))
    if dtype != "int64":
        raise FormatError(f"dtype must be 'object', 'int64' or 'float64', not {quote(dtype)}")
    for i, vertex in enumerate(polygon.vertices):
        for value in vertex:
            if value.denominator != 1 or not -(2**63) <= value < 2**63:
                raise FormatError(f"vertex {i}: {abridge(value)} is not an int64")
    return numpy.array([[int(x), int(y)] for x, y in polygon.vertices], dtype=numpy.int64)


def _floats(ring: Sequence[Point], nearest: bool, name: str = "") -> list[tuple[float, float]]:
    rows = []
    for i, (x, y) in enumerate(ring):
        vertex = f"{name}vertex {i}"
        rows.append((_float(x, vertex, nearest), _float(y, vertex, nearest)))
    return rows


def _float(value: Fraction, vertex: str, nearest: bool) -> float:
    try:
        found = value.numerator / value.denominator
    except OverflowError:
        raise FormatError(f"{vertex}: {abridge(value)} exceeds the float range") from None
    if found != value and not nearest:
        raise FormatError(f"{vertex}: {abridge(value)} is not a float; nearest=True rounds")
    return found


@explain_type_errors
def to_sympy(polygon: Polygon) -> sympy.Polygon:
    """Convert a polygon to a `sympy.geometry.Polygon`.

    sympy detects collinear vertices in floating point. Raises FormatError if it would drop
    vertices.

    >>> triangle = Polygon([(0, 0), (1, 0), (0, "1/3")])
    >>> from_sympy(to_sympy(triangle)) == triangle
    True
    """
    import sympy

    found = sympy.Polygon(*polygon.vertices)
    if not isinstance(found, sympy.Polygon) or len(found.vertices) != len(polygon):
        raise FormatError("sympy would drop vertices that it takes for collinear")
    return found


@explain_type_errors
def from_sympy(polygon: sympy.Polygon) -> Polygon:
    """Convert a rational `sympy.geometry.Polygon`, a triangle or a regular polygon.

    Raises FormatError for other objects, and otherwise the errors of `Polygon`.
    """
    import sympy

    # sympy.Polygon(...) returns a Segment or a Point for collinear vertices.
    if not isinstance(polygon, sympy.Polygon):
        raise FormatError(f"a sympy {type(polygon).__name__} is not a polygon")
    return Polygon(polygon.vertices)
