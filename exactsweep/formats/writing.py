"""Polygons out: exactly, or not at all."""

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from html import escape
from itertools import chain

from exactsweep.formats.decimals import format_decimal
from exactsweep.formats.error import FormatError
from exactsweep.formats.outline import NamedPolygon
from exactsweep.geometry.number import format_fraction, quoted
from exactsweep.geometry.point import Point
from exactsweep.geometry.polygon import Polygon

_Row = list[tuple[str, str]]


def format_polygons(polygons: Iterable[Polygon | NamedPolygon], form: str) -> str:
    """Write polygons as text that `parse_polygons` reads back as the same polygons.

    Args:
        polygons: Polygons, or NamedPolygons, whose names are written where the format has names,
            and which are on the layer of that name, or "0", in DXF.
        form: one of FORMATS.

    Returns:
        The text of a file.

    Raises:
        FormatError: no such format; no polygon; a coordinate that is not a finite decimal, such as
            1/3, which only "json" can hold; a name that the format cannot hold.

    Cost: linear in the length of the result, times that of a division of numbers so long.

    Example:
        >>> print(format_polygons([Polygon([(0, 0), ("1/2", 0), (0, 1)])], "wkt"), end="")
        POLYGON ((0 0, 0.5 0, 0 1, 0 0))
    """
    if form not in FORMATS:
        raise FormatError(f"{quoted(form)} is none of the formats {', '.join(FORMATS)}")
    named = [p if isinstance(p, NamedPolygon) else NamedPolygon(p) for p in polygons]
    if not named:
        raise FormatError("no polygon to be written")
    return _WRITERS[form](named)


def rounded_polygons(
    polygons: Iterable[NamedPolygon], places: int
) -> tuple[list[NamedPolygon], int, Fraction]:
    """Round polygons to decimals, for formats that hold no other numbers.

    Args:
        polygons: NamedPolygons.
        places: how many decimal places.

    Returns:
        (list of NamedPolygon, how many coordinates are changed, the largest change).

    Raises:
        PolygonError: what comes out is not a simple polygon.

    Example:
        >>> third = NamedPolygon(Polygon([(0, 0), ("1/3", 0), (0, 1)]))
        >>> rounded_polygons([third], 2)[1:]
        (1, Fraction(1, 300))
    """
    found, changes = [], []
    for polygon, name, layer in polygons:
        points = [Point(round(v.x, places), round(v.y, places)) for v in polygon.vertices]
        pairs = zip(chain(*polygon.vertices), chain(*points), strict=True)
        changes += [abs(old - new) for old, new in pairs if old != new]
        found.append(NamedPolygon(Polygon(points), name, layer))
    return found, len(changes), max(changes, default=Fraction(0))


def _json(polygons: Sequence[NamedPolygon]) -> str:
    if len(polygons) == 1 and polygons[0].name is None:
        return json.dumps(polygons[0].polygon.vertices, default=format_fraction) + "\n"
    lines = []
    for polygon, name, _ in polygons:
        document = ({} if name is None else {"id": name}) | {"vertices": polygon.vertices}
        lines.append(json.dumps(document, default=format_fraction))
    return '{"polygons": [\n  ' + ",\n  ".join(lines) + "\n]}\n"


def _wkt(polygons: Sequence[NamedPolygon]) -> str:
    names = (_called(k, polygon) for k, polygon in enumerate(polygons))
    return "".join(
        wkt_polygon({name: p.polygon.vertices}) for name, p in zip(names, polygons, strict=True)
    )


def wkt_polygon(rings: Mapping[str, Sequence[Point]]) -> str:
    r"""Write one WKT POLYGON, a line.

    Args:
        rings: the exterior and the holes, each by the name that a refusal gives it.

    Raises:
        FormatError: a coordinate that is not a finite decimal.

    Example:
        >>> wkt_polygon({"ring": Polygon([(0, 0), ("1/2", 0), (0, 1)]).vertices})
        'POLYGON ((0 0, 0.5 0, 0 1, 0 0))\n'
    """
    rows = [wkt_points(name, [*ring, ring[0]]) for name, ring in rings.items()]
    return f"POLYGON ({', '.join(rows)})\n"


def wkt_points(name: str, points: Sequence[Point]) -> str:
    """Write points as a list of WKT, in parentheses; refuses as `wkt_polygon` does."""
    return f"({', '.join(f'{x} {y}' for x, y in _row(name, points, 'WKT'))})"


def _geojson(polygons: Sequence[NamedPolygon]) -> str:
    features = []
    for row, (_, name, _) in zip(_rows(polygons, "GeoJSON"), polygons, strict=True):
        ring = ", ".join(f"[{x}, {y}]" for x, y in [*row, row[0]])
        identity = "" if name is None else f'"id": {json.dumps(name)}, '
        features.append(
            f'{{"type": "Feature", {identity}"properties": {{}}, '
            f'"geometry": {{"type": "Polygon", "coordinates": [[{ring}]]}}}}'
        )
    if len(features) == 1:
        return f"{features[0]}\n"
    listed = ",\n  ".join(features)
    return f'{{"type": "FeatureCollection", "features": [\n  {listed}\n]}}\n'


def _svg(polygons: Sequence[NamedPolygon]) -> str:
    lines = []
    for row, (_, name, _) in zip(_rows(polygons, "SVG"), polygons, strict=True):
        identity = "" if name is None else f'id="{escape(_printable(name, "SVG"))}" '
        points = " ".join(f"{x},{y}" for x, y in row)
        lines.append(f'  <polygon {identity}points="{points}"/>\n')
    corners = [corner for p in polygons for corner in p.polygon.bounding_box]
    low = [min(corner[axis] for corner in corners) for axis in (0, 1)]
    size = [max(corner[axis] for corner in corners) - low[axis] for axis in (0, 1)]
    box = " ".join(map(format_decimal, low + size))
    body = "".join(lines)
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}">\n{body}</svg>\n'


def _dxf(polygons: Sequence[NamedPolygon]) -> str:
    tags: list[tuple[int, object]] = [(0, "SECTION"), (2, "ENTITIES")]
    for row, (_, name, layer) in zip(_rows(polygons, "DXF"), polygons, strict=True):
        on = (8, _printable(layer or name or "0", "DXF"))
        tags += [(0, "POLYLINE"), on, (66, 1), (10, 0), (20, 0), (30, 0), (70, 1)]
        for x, y in row:
            tags += [(0, "VERTEX"), on, (10, x), (20, y), (30, 0)]
        tags += [(0, "SEQEND"), on]
    tags += [(0, "ENDSEC"), (0, "EOF")]
    return "".join(f"{code:>3}\n{value}\n" for code, value in tags)


def _rows(polygons: Sequence[NamedPolygon], form: str) -> list[_Row]:
    """The vertices of each polygon as decimals."""
    return [_row(_called(k, p), p.polygon.vertices, form) for k, p in enumerate(polygons)]


def _called(k: int, polygon: NamedPolygon) -> str:
    return f"polygon {k}" if polygon.name is None else ascii(polygon.name)[1:-1]


def _row(name: str, points: Sequence[Point], form: str) -> _Row:
    row = []
    for i, (x, y) in enumerate(points):
        try:
            row.append((format_decimal(x), format_decimal(y)))
        except FormatError as error:
            raise FormatError(
                f"{name}, vertex {i}: {error}, which is all that {form} can hold"
            ) from None
    return row


def _printable(name: str, form: str) -> str:
    if not name.isprintable() or name != name.strip() or not name:
        raise FormatError(f"the name {quoted(name)} cannot be written in {form}")
    return name


_WRITERS: dict[str, Callable[[Sequence[NamedPolygon]], str]] = {
    "json": _json,
    "wkt": _wkt,
    "geojson": _geojson,
    "svg": _svg,
    "dxf": _dxf,
}
FORMATS = tuple(_WRITERS)
"""The formats that polygons are written in."""
