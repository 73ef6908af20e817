"""Cases as WKT, GeoJSON and SVG pictures; `case_json` writes JSON."""

import csv
import json
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from html import escape
from io import StringIO
from itertools import chain
from math import isqrt
from typing import Any, NamedTuple

from exactsweep.canvas.window import Scale
from exactsweep.corpus.answered import find_types
from exactsweep.corpus.case import Case
from exactsweep.draw.notebook import draw_sweep
from exactsweep.draw.sweeps import trace_anchor
from exactsweep.formats.error import FormatError
from exactsweep.formats.writing import write_wkt_points, write_wkt_polygon
from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.number import Point

# The size of a picture with two lines of text.
_WIDTH, _HEIGHT = 440, 370


class CaseFigure(NamedTuple):
    name: str
    closed: bool
    rings: Sequence[Sequence[Point]]


def list_figures(case: Case) -> Iterator[CaseFigure]:
    yield CaseFigure("directrix", True, case.directrix_rings)
    yield CaseFigure("generatrix", True, case.generatrix_rings)
    yield CaseFigure("trajectory", True, case.trajectory.rings)
    yield CaseFigure("inner", True, case.inner.rings)
    yield CaseFigure("outer", True, case.outer.rings)
    for name, shapes in (
        ("hole", case.holes),
        ("unswept", case.unswept),
        ("inner fit", case.inner_regions or ()),
    ):
        yield from (CaseFigure(name, True, shape.rings) for shape in shapes)
    for name, fits in (
        ("exact fit", case.exact_fits),
        ("exact fit inside", case.inner_exact_fits),
    ):
        yield from (CaseFigure(name, False, [tuple(dict.fromkeys(fit))]) for fit in fits)


def cases_to_wkt(cases: Iterable[Case]) -> Iterator[str]:
    """Yield the lines of a CSV table with one polygon or segment per row.

    The columns are the id of the case, the name of the figure, its WKT, and the reason if that is
    missing: WKT has only decimals, so it cannot represent 1/3.

    >>> from exactsweep.corpus import find_case
    >>> print(*list(cases_to_wkt([find_case("fits-square")]))[4:6], sep="", end="")
    fits-square,inner,"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))",
    fits-square,outer,"POLYGON ((-1 -1, 4 -1, 4 4, -1 4, -1 -1))",
    """
    yield _row("case", "figure", "wkt", "missing because")
    for case in cases:
        for figure in list_figures(case):
            try:
                yield _row(case.id, figure.name, _wkt(figure), "")
            except FormatError as error:
                yield _row(case.id, figure.name, "", str(error))


def _wkt(figure: CaseFigure) -> str:
    name, closed, (exterior, *holes) = figure
    if closed:
        inner = {f"{name}, hole {k}": hole for k, hole in enumerate(holes)}
        return write_wkt_polygon({name: exterior, **inner}).rstrip()
    return f"{'POINT' if len(exterior) == 1 else 'LINESTRING'} {write_wkt_points(name, exterior)}"


def _row(*fields: str) -> str:
    text = StringIO()
    csv.writer(text, lineterminator="\n").writerow(fields)
    return text.getvalue()


def cases_to_geojson(cases: Iterable[Case]) -> Iterator[str]:
    """Yield the lines of a FeatureCollection (RFC 7946) with one polygon or segment per feature.

    If some coordinate is not a double, "exact" is false, the geometry has the nearest doubles, or
    is null beyond their range, and "vertices" has the exact vertices as strings, in a list of rings
    if there are holes.

    >>> from exactsweep.corpus import find_case
    >>> text = "".join(cases_to_geojson([find_case("worked-roof")]))
    >>> [f["properties"]["figure"] for f in json.loads(text)["features"]][:2]
    ['directrix', 'generatrix']
    """
    yield '{"type":"FeatureCollection","features":['
    separator = "\n"
    for case in cases:
        for figure in list_figures(case):
            yield separator + json.dumps(_feature(case, figure), separators=(",", ":"))
            separator = ",\n"
    yield "\n]}\n"


def _feature(case: Case, figure: CaseFigure) -> dict[str, Any]:
    name, closed, rings = figure
    properties: dict[str, Any] = {
        "case": case.id,
        "figure": name,
        "class": case.kind,
        "flags": case.flags,
    }
    properties["exact"] = "binary64" in find_types(list(chain(*chain(*rings))), 1)
    if not properties["exact"]:
        exact = [[[format_fraction(c) for c in point] for point in ring] for ring in rings]
        properties["vertices"] = exact[0] if len(exact) == 1 else exact
    geometry: dict[str, Any] | None = None
    with suppress(OverflowError):
        geometry = _geometry(closed, rings)
    return {"type": "Feature", "properties": properties, "geometry": geometry}


def _geometry(closed: bool, rings: Sequence[Sequence[Point]]) -> dict[str, Any]:
    places = [[[float(c) for c in point] for point in ring] for ring in rings]
    if not closed:
        if len(places[0]) == 1:
            return {"type": "Point", "coordinates": places[0][0]}
        return {"type": "LineString", "coordinates": places[0]}
    for k, ring in enumerate(rings):
        if (find_doubled_area(ring) < 0) != (k > 0):
            places[k].reverse()
    return {"type": "Polygon", "coordinates": [[*ring, ring[0]] for ring in places]}


def cases_to_svg(cases: Iterable[Case]) -> Iterator[str]:
    """Yield the text of an SVG image with a picture of each case."""
    drawn = list(cases)
    columns = isqrt(max(0, len(drawn) - 1)) + 1
    width, height = columns * _WIDTH, -(-len(drawn) // columns) * _HEIGHT
    yield (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
        'font-family="sans-serif" font-size="14">\n<rect width="100%" height="100%" fill="#fff"/>\n'
    )
    for k, case in enumerate(drawn):
        x, y = k % columns * _WIDTH, k // columns * _HEIGHT
        s = case.sweep()
        note = f"{case.kind}, {case.size} vertices"
        if not Scale.of(s.outer.vertices, trace_anchor(s).vertices).is_true:
            note += ", axes not to the same scale"
        yield (
            f'<g transform="translate({x} {y})">\n{draw_sweep(s)}\n'
            f'<text x="12" y="{_HEIGHT - 34}">{escape(case.id)}</text>\n'
            f'<text x="12" y="{_HEIGHT - 16}" fill="#777">{note}</text>\n</g>\n'
        )
    yield "</svg>\n"
