"""Polygons from text, in whichever format the content shows."""

from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import parse_json, read_vertices
from exactsweep.formats.files import file_name, read_text
from exactsweep.formats.geojson import read_geojson
from exactsweep.formats.wkt import parse_wkt
from exactsweep.polygon import Point, Polygon


def parse_polygon(text: str) -> Polygon:
    """Read a polygon from JSON, GeoJSON or WKT.

    Args:
        text: a JSON list of pairs, or an object with such a list as "vertices"; a GeoJSON Polygon,
            or a Feature of one; or a WKT POLYGON.  Numbers are decimals, exactly as they are
            written; in JSON, strings such as "-7/2" are numbers, too.

    Returns:
        A Polygon.

    Raises:
        FormatError: none of these; the message says where, by line and column or by JSON path.
        PolygonError: not a simple polygon; the message names vertices by their index.

    Cost: linear in the length of the text, and that of `Polygon`.

    Example:
        >>> parse_polygon("[[0, 0], [0.5, 0], [0, 1e0]]") == parse_polygon(
        ...     "POLYGON ((0 0, 0.5 0, 0 1, 0 0))"
        ... )
        True
    """
    return Polygon(_vertices(text))


def read_polygon(path: str) -> Polygon:
    """Read a polygon from a file, or from standard input.

    Args:
        path: a path, or "-" for standard input.

    Returns:
        A Polygon, as `parse_polygon` does.

    Raises:
        FormatError: anything wrong with the file or in it; the message names the file.
    """
    try:
        return parse_polygon(read_text(path))
    except ValueError as error:
        raise FormatError(f"{file_name(path)}: {error}") from None


def _vertices(text: str) -> list[Point]:
    first = text.lstrip()[:1]
    if not first:
        raise FormatError("empty")
    if first.isalpha():
        return parse_wkt(text)
    if first not in "[{":
        raise FormatError(f"starts with {first!a}: neither JSON list, JSON object nor WKT")
    document = parse_json(text)
    if not isinstance(document, dict):
        return read_vertices(document, "$")
    if "vertices" in document:
        return read_vertices(document["vertices"], "$.vertices")
    if "type" in document:
        return read_geojson(document)
    raise FormatError('$ has neither "vertices" nor, as in GeoJSON, a "type"')
