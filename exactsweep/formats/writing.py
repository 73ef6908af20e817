"""Exact writers of polygons."""

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import chain

from exactsweep.formats.candidate import NamedPolygon, NamedRegion
from exactsweep.formats.csv import write_csv_rows
from exactsweep.formats.decimals import format_decimal
from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import quote_fraction, write_json
from exactsweep.formats.folder import make_unique
from exactsweep.formats.part_list import Coordinates
from exactsweep.formats.reading import INSUNITS, UNITS
from exactsweep.geometry.region import AnyPolygon, Region
from exactsweep.numbers.digits import find_magnitude
from exactsweep.numbers.error import explain_type_errors, quote
from exactsweep.numbers.number import Fit, Point

_Decimals = list[tuple[str, str]]


@explain_type_errors
def format_polygons(
    polygons: Iterable[AnyPolygon | NamedPolygon | NamedRegion],
    form: str,
    fits: Sequence[Fit] = (),
    *,
    decimals: bool = False,
    coordinates: Coordinates | None = None,
) -> str:
    """Write polygons as text that `parse_regions` reads back exactly.

    In DXF, each ring, even of a hole, is a closed polyline.

    Args:
        polygons: Polygons and Regions, named or not. The DXF layer is the layer, the name, or "0".
        form: one of FORMATS.
        fits: exact fits, pairs of points: LINESTRINGs and POINTs in WKT and GeoJSON, lines on the
            layer "exact fits" in DXF, open lines in SVG, separate rows in CSV.
        decimals: whether to write JSON numbers as decimals instead of strings.
        coordinates: the direction of Y and the unit, as from `read_regions`. Y is flipped if it
            differs from the format (down in SVG, up in all others); SVG and DXF state the unit. By
            default, numbers remain unchanged.

    Raises:
        FormatError: an unknown format, no polygon, a number such as 1/3 in a format other than
            "json", or a name that the format cannot represent.

    Cost: linear in the length of the result, times the cost of a division.

    Example:
        >>> from exactsweep import Polygon
        >>> print(format_polygons([Polygon([(0, 0), ("1/2", 0), (0, 1)])], "wkt"), end="")
        POLYGON ((0 0, 0.5 0, 0 1, 0 0))
    """
    if form not in FORMATS:
        raise FormatError(f"unknown format {quote(form)}; choose from {', '.join(FORMATS)}")
    named = [_name(polygon) for polygon in polygons]
    if not named and not fits:
        raise FormatError("no polygon to write")
    coordinates = coordinates or Coordinates(form == "svg")
    if coordinates.y_down != (form == "svg"):
        named = [one.flipped() for one in named]
        fits = [(Point(p.x, -p.y), Point(q.x, -q.y)) for p, q in fits]
    if decimals and form == "json":
        return _json(named, fits, None, format_decimal)
    return _WRITERS[form](named, fits, coordinates.unit)


def _json(
    regions: Sequence[NamedRegion],
    fits: Sequence[Fit],
    unit: Fraction | None,
    number: Callable[[Fraction], str] = quote_fraction,
) -> str:
    lines = []
    for region, name, _, error in regions:
        exterior, *holes = region.rings
        rings = {"exterior": exterior, "holes": holes} if holes else {"vertices": exterior}
        known = {"error": error} if error else {}
        lines.append(write_json(({} if name is None else {"id": name}) | rings | known, number))
    if len(regions) == 1 and regions[0].name is None and not (fits or regions[0].error):
        region = regions[0].region
        return (lines[0] if region.holes else write_json(region.vertices, number)) + "\n"
    after = f',\n "exact_fits": {write_json(fits, number)}' if fits else ""
    return '{"polygons": [\n  ' + ",\n  ".join(lines) + f"\n]{after}}}\n"


def _wkt(regions: Sequence[NamedRegion], fits: Sequence[Fit], unit: Fraction | None) -> str:
    lines = [write_wkt_polygon(_name_rings(k, region)) for k, region in enumerate(regions)]
    for k, fit in enumerate(fits):
        ends = list(dict.fromkeys(fit))
        kind = "LINESTRING" if len(ends) > 1 else "POINT"
        lines.append(f"{kind} {write_wkt_points(f'exact fit {k}', ends)}\n")
    return "".join(lines)


def write_wkt_polygon(rings: Mapping[str, Sequence[Point]]) -> str:
    """Write a WKT POLYGON on one line; messages name rings by their keys."""
    rows = [write_wkt_points(name, [*ring, ring[0]]) for name, ring in rings.items()]
    return f"POLYGON ({', '.join(rows)})\n"


def write_wkt_points(name: str, points: Sequence[Point]) -> str:
    return f"({', '.join(f'{x} {y}' for x, y in _row(name, points, 'WKT'))})"


def _geojson(regions: Sequence[NamedRegion], fits: Sequence[Fit], unit: Fraction | None) -> str:
    features = []
    for rows, (_, name, *_) in zip(_rows(regions, "GeoJSON"), regions, strict=True):
        rings = [_positions([*row, row[0]]) for row in rows]
        identity = "" if name is None else f'"id": {json.dumps(name)}, '
        features.append(_FEATURE % (identity, "", "Polygon", f"[{', '.join(rings)}]"))
    for row in _fit_rows(fits, "GeoJSON"):
        positions = _positions(row)
        at = ("LineString", positions) if row[1:] else ("Point", positions[1:-1])
        features.append(_FEATURE % ("", '"exact fit": true', *at))
    if len(features) == 1:
        return f"{features[0]}\n"
    listed = ",\n  ".join(features)
    return f'{{"type": "FeatureCollection", "features": [\n  {listed}\n]}}\n'


_FEATURE = (
    '{"type": "Feature", %s"properties": {%s}, "geometry": {"type": "%s", "coordinates": %s}}'
)


def _positions(row: _Decimals) -> str:
    return f"[{', '.join(f'[{x}, {y}]' for x, y in row)}]"


def _svg(regions: Sequence[NamedRegion], fits: Sequence[Fit], unit: Fraction | None) -> str:
    from html import escape

    lines = []
    unnamed = [one.name or one.layer for one in regions]
    names = iter(make_unique([name for name in unnamed if name is not None]))
    for rows, name in zip(_rows(regions, "SVG"), unnamed, strict=True):
        identity = "" if name is None else f'id="{escape(_printable(next(names), "SVG"))}" '
        points = [" ".join(f"{x},{y}" for x, y in row) for row in rows]
        if len(points) == 1:
            lines.append(f'  <polygon {identity}points="{points[0]}"/>\n')
        else:
            data = " ".join(f"M{ring}z" for ring in points)
            lines.append(f'  <path {identity}fill-rule="evenodd" d="{data}"/>\n')
    for row in _fit_rows(fits, "SVG"):
        ends = " ".join(f"{x},{y}" for x, y in (row[0], row[-1]))
        lines.append(f'  <polyline class="exact-fit" points="{ends}"/>\n')
    corners = [corner for r in regions for corner in r.region.bounding_box]
    corners += chain.from_iterable(fits)
    low = [min(corner[axis] for corner in corners) for axis in (0, 1)]
    size = [max(corner[axis] for corner in corners) - low[axis] for axis in (0, 1)]
    margin = Fraction(10) ** (find_magnitude(max(size) or Fraction(10)) - 1)
    low, size = [c - margin for c in low], [c + 2 * margin for c in size]
    lengths = zip(("width", "height"), size, strict=True)
    measured = "".join(f'{name}="{_length(c, unit)}" ' for name, c in lengths) if unit else ""
    box = " ".join(map(format_decimal, low + size))
    body = "".join(lines)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" {measured}viewBox="{box}" fill="none" '
        f'stroke="black" stroke-width="{format_decimal(margin / 10)}">\n{body}</svg>\n'
    )


def _length(number: Fraction, unit: Fraction) -> str:
    for name in ("mm", "cm", "in", "pt", "pc", "px"):
        if UNITS[name] == unit:
            return f"{format_decimal(number)}{name}"
    return f"{format_decimal(number * unit)}mm"


def _dxf(regions: Sequence[NamedRegion], fits: Sequence[Fit], unit: Fraction | None) -> str:
    # Some readers assume meters if the unit is missing.
    code = next((code for code, known in INSUNITS.items() if known == unit), 0)
    tags: list[tuple[int, object]] = [(0, "SECTION"), (2, "HEADER"), (9, "$INSUNITS"), (70, code)]
    tags += [(0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")]
    for rows, (_, name, layer, _) in zip(_rows(regions, "DXF"), regions, strict=True):
        on = (8, _printable(layer or name or "0", "DXF"))
        for row in rows:
            tags += [(0, "POLYLINE"), on, (66, 1), (10, 0), (20, 0), (30, 0), (70, 1)]
            for x, y in row:
                tags += [(0, "VERTEX"), on, (10, x), (20, y), (30, 0)]
            tags += [(0, "SEQEND"), on]
    for row in _fit_rows(fits, "DXF"):
        (x, y), (u, v) = row[0], row[-1]
        tags += [(0, "LINE"), (8, "exact fits"), (10, x), (20, y), (30, 0)]
        tags += [(11, u), (21, v), (31, 0)]
    tags += [(0, "ENDSEC"), (0, "EOF")]
    return "".join(f"{code:>3}\n{value}\n" for code, value in tags)


def _csv(regions: Sequence[NamedRegion], fits: Sequence[Fit], unit: Fraction | None) -> str:
    rows = [("polygon", "name", "ring", "x", "y")]
    for k, (rings, (_, name, *_)) in enumerate(zip(_rows(regions, "CSV"), regions, strict=True)):
        for j, ring in enumerate(rings):
            shown = f"hole {j - 1}" if j else "exterior"
            rows += [(str(k), _encodable(name or ""), shown, x, y) for x, y in ring]
    for k, row in enumerate(_fit_rows(fits, "CSV")):
        rows += [(f"fit {k}", f"exact fit {k}", "exact fit", x, y) for x, y in row]
    return write_csv_rows(rows)


def _fit_rows(fits: Sequence[Fit], form: str) -> Iterator[_Decimals]:
    for k, fit in enumerate(fits):
        yield _row(f"exact fit {k}", list(dict.fromkeys(fit)), form)


def _rows(regions: Sequence[NamedRegion], form: str) -> Iterator[list[_Decimals]]:
    """Yield the rings of each region as decimals, holes clockwise."""
    for k, region in enumerate(regions):
        exterior, *holes = [_row(*ring, form) for ring in _name_rings(k, region).items()]
        yield [exterior, *(row[::-1] for row in holes)]


def _name(polygon: AnyPolygon | NamedPolygon | NamedRegion) -> NamedRegion:
    if isinstance(polygon, NamedRegion):
        return polygon
    if isinstance(polygon, NamedPolygon):
        name, layer, error = polygon[1:]
        return NamedRegion(Region(polygon.polygon), name, layer, error)
    return NamedRegion(Region(polygon))


def _name_rings(k: int, region: NamedRegion) -> Mapping[str, Sequence[Point]]:
    name = f"polygon {k}" if region.name is None else ascii(region.name)[1:-1]
    exterior, *holes = region.region.rings
    return {name: exterior} | {f"{name}, hole {j}": hole for j, hole in enumerate(holes)}


def _row(name: str, points: Sequence[Point], form: str) -> _Decimals:
    row = []
    for i, (x, y) in enumerate(points):
        try:
            row.append((format_decimal(x), format_decimal(y)))
        except FormatError as error:
            raise FormatError(f"{name}, vertex {i}: {error}, as {form} requires") from None
    return row


def _encodable(name: str) -> str:
    try:
        name.encode()
    except UnicodeEncodeError:
        raise FormatError(f"the name {quote(name)} is not valid UTF-8") from None
    return name


def _printable(name: str, form: str) -> str:
    if not name.isprintable() or name != name.strip() or not name:
        raise FormatError(f"the name {quote(name)} cannot be written in {form}")
    return name


_Writer = Callable[[Sequence[NamedRegion], Sequence[Fit], Fraction | None], str]
_WRITERS: dict[str, _Writer] = {
    "json": _json,
    "wkt": _wkt,
    "geojson": _geojson,
    "svg": _svg,
    "dxf": _dxf,
    "csv": _csv,
}
FORMATS = tuple(_WRITERS)
"""The output formats."""
