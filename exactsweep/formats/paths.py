"""Reader of paths: WKT and GeoJSON lines and points, SVG paths, and JSON lists of points."""

from itertools import islice

from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import parse_json, read_vertices
from exactsweep.formats.node import JsonNode
from exactsweep.formats.reading import Reading
from exactsweep.formats.wkt import parse_wkt_path
from exactsweep.geometry.polyline import Polyline
from exactsweep.numbers.error import prefix_errors

_LINES = ("LineString", "Point")


def parse_path(
    text: str, *, is_list: bool = False, reading: Reading | None = None
) -> Polyline | None:
    """Read a path; return None for other text, and raise FormatError for an invalid path.

    A path is a WKT LINESTRING or POINT; a GeoJSON LineString or Point, or a Feature with one; an
    SVG document with one open unfilled path of straight segments; or a JSON list of one or two
    points. With `is_list`, longer JSON lists and filled or closed SVG paths are also paths.

    >>> svg = '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0h2v1" fill="none"/></svg>'
    >>> print(parse_path("LINESTRING (0 0, 0.5 0)"), "and", parse_path(svg))
    (0,0) (1/2,0) and (0,0) (2,0) (2,1)
    """
    start = text.lstrip()
    if start[:1] == "<":
        return _read_svg_path(text, reading or Reading(), filled=is_list)
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


def _read_svg_path(text: str, reading: Reading, *, filled: bool) -> Polyline | None:
    """Read an SVG with a single path, open and unfilled unless `filled` is set, else None."""
    from exactsweep.formats.curved import svg
    from exactsweep.formats.curved.svg_placed import PlacedElement, Style, name_kind
    from exactsweep.formats.curved.xml import parse_xml

    root = parse_xml(text)
    if name_kind(root) != "svg":
        return None
    placed = PlacedElement(root, None, reading, style=Style(root))
    shapes = [*islice(svg.Document(root, reading).shapes(placed, 0), 2)]
    if len(shapes) != 1 or (svg.is_filled(shapes[0]) and not filled):
        return None
    with prefix_errors(shapes[0].place, FormatError):
        found = svg.SHAPES[name_kind(shapes[0].element)](shapes[0], shapes[0].matrix, reading)
        if len(found) != 1 or (found[0].is_closed and not filled):
            return None
        if not found[0].is_exact:
            raise FormatError("a path with curves; draw it with straight segments")
    return Polyline(found[0].points, closed=found[0].is_closed)
