"""Readers of vertices: pairs of numbers, and objects with a `__geo_interface__`."""

from collections.abc import Iterable, Mapping, Sequence

from exactsweep.geometry.canonical import PolygonError
from exactsweep.numbers.error import name_refusals, quote
from exactsweep.numbers.number import Point, to_fraction

Pairs = Iterable[Iterable[object]]


def read_point(pair: Iterable[object], name: str) -> Point:
    """Read a pair of numbers; a refusal begins with the given name."""
    # Text, sets and mappings unpack too, but not into coordinates.
    if isinstance(pair, (str, bytes, set, frozenset, dict)):
        raise PolygonError(f"{name} is {type(pair).__name__}, not a pair of numbers")
    try:
        x, y = pair
    except (TypeError, ValueError):
        raise PolygonError(f"{name} is not a pair of numbers") from None
    with name_refusals(name):
        return Point(to_fraction(x), to_fraction(y))


def refuse_number(k: object, what: str, count: int) -> PolygonError:
    """Make the error for an index k outside the given count of vertices or edges."""
    return PolygonError(f"there is no {what} {quote(k)}: they are numbered 0 to {count - 1}")


def read_interface(shape: object) -> list[Pairs] | None:
    """Read the rings of an object with a `__geo_interface__`, such as a polygon of shapely.

    Args:
        shape: any object.

    Returns:
        The exterior and the holes; None if the object has no such attribute.

    Raises:
        PolygonError: the attribute is not one polygon, or the polygon is empty.

    Example:
        >>> import shapely
        >>> read_interface(shapely.box(0, 0, 2, 1))
        [[(2.0, 0.0), (2.0, 1.0), (0.0, 1.0), (0.0, 0.0), (2.0, 0.0)]]
    """
    told = getattr(shape, "__geo_interface__", None)
    if isinstance(told, Mapping) and told.get("type") == "Feature":
        told = told.get("geometry")
    if told is None:
        return None
    kind = told.get("type") if isinstance(told, Mapping) else type(told).__name__
    if kind not in ("Polygon", "LinearRing"):
        raise PolygonError(f"a {kind} is not a polygon")
    coordinates = told.get("coordinates")
    rings = coordinates if kind == "Polygon" else [coordinates]
    if not isinstance(rings, Sequence) or not all(isinstance(ring, Iterable) for ring in rings):
        raise PolygonError(f"a {kind} without rings is not a polygon")
    # Some iterables can be read only once.
    rings = [[*ring] for ring in rings]
    if not any(rings):
        raise PolygonError("the polygon is empty")
    return [*rings]
