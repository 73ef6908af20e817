"""GeoJSON (RFC 7946): a Polygon with one ring, alone or as the geometry of a Feature."""

from collections.abc import Mapping

from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import described, read_vertices
from exactsweep.polygon import Point


def read_geojson(document: Mapping[str, object]) -> list[Point]:
    """Read the outer ring of a GeoJSON polygon.

    Args:
        document: an object with a "type", as `parse_json` returns it.

    Returns:
        list of Point, the first one repeated at the end.

    Raises:
        FormatError: another type, inner rings (holes), more than two coordinates, a ring that is
            not closed; the message starts with the JSON path.

    Cost: linear.

    Example:
        >>> ring = [["0", "0"], ["1", "0"], ["0", "1"], ["0", "0"]]
        >>> len(read_geojson({"type": "Polygon", "coordinates": [ring]}))
        4
    """
    path = "$"
    geometry: object = document
    if document["type"] == "Feature":
        path, geometry = "$.geometry", document.get("geometry")
    if not isinstance(geometry, dict):
        raise FormatError(f"{path} is {described(geometry)}, not a Polygon")
    if geometry.get("type") != "Polygon":
        raise FormatError(f"{path}.type is {described(geometry.get('type'))}, not 'Polygon'")
    path += ".coordinates"
    rings = geometry.get("coordinates")
    if not isinstance(rings, list):
        raise FormatError(f"{path} is {described(rings)}, not a list of rings")
    if not rings:
        raise FormatError(f"{path} is empty")
    if len(rings) > 1:
        raise FormatError(f"{path}[1] is an inner ring: polygons with holes cannot be swept")
    ring = read_vertices(rings[0], f"{path}[0]")
    if not ring:
        raise FormatError(f"{path}[0] is empty")
    if ring[0] != ring[-1]:
        raise FormatError(f"{path}[0] is not closed: the last vertex must repeat the first")
    return ring
