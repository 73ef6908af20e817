"""Reader of paths: WKT and GeoJSON lines and points, SVG paths, and JSON lists of points."""

from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import parse_json, read_vertices
from exactsweep.formats.node import JsonNode
from exactsweep.formats.reading import Reading
from exactsweep.formats.wkt import parse_wkt_path
from exactsweep.geometry.polyline import Polyline

_LINES = ("LineString", "Point")


def parse_path(
    text: str, *, is_list: bool = False, reading: Reading | None = None
) -> Polyline | None:
    """Read a path; return None for other text, and raise FormatError for an invalid path.

    A path is a WKT LINESTRING or POINT; a GeoJSON LineString or Point, or a Feature with one; an
    SVG document with one open unfilled path of straight segments; or a JSON list of one or two
    points. With `is_list`, longer JSON lists and filled or closed SVG paths are also paths.

    >>> print(parse_path("LINESTRING (0 0, 0.5 0)"), "and", parse_path('[[0, 0], ["1/2", 0]]'))
    (0,0) (1/2,0) and (0,0) (1/2,0)
    """
    start = text.lstrip()
    if start[:1] == "<":
        from exactsweep.formats.curved.svg_summand import read_svg_path

        return read_svg_path(text, reading or Reading(), filled=is_list)
    if start[:1] not in ("[", "{"):
        points = parse_wkt_path(text) if start[:1].isalpha() else None
        return None if points is None else Polyline(points)
    try:
        document = parse_json(text)
    except FormatError:
        # Several documents, one per line, are not a path.
        return None
    node = JsonNode(document, "$")
    if isinstance(document, dict):
        if document.get("type") == "Feature":
            node = node.get("geometry", None)
        if not isinstance(node.value, dict) or node.value.get("type") not in _LINES:
            return None
        kind, node = node.value["type"], node.get("coordinates", None)
        found = [node.value] if kind == "Point" else node.value
        if isinstance(found, list):
            found = [pair[:2] if isinstance(pair, list) else pair for pair in found]
        return Polyline(read_vertices(found, node.path))
    if not isinstance(document, list) or not (is_list or len(document) < 3):
        return None
    if any(isinstance(c, list | dict) for pair in document if isinstance(pair, list) for c in pair):
        return None
    return Polyline(read_vertices(document, "$"))
