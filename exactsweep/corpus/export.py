"""Cases for other programs: WKT, GeoJSON, and a sheet to look at; JSON is in `case_json`."""

import csv
import json
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from html import escape
from io import StringIO
from math import isqrt
from typing import Any, NamedTuple

from exactsweep.canvas.scale import Scale
from exactsweep.corpus.case import Case
from exactsweep.corpus.facts import is_clockwise
from exactsweep.corpus.representable import types_holding
from exactsweep.draw.notebook import sweep_svg
from exactsweep.draw.sweeps import path
from exactsweep.formats.error import FormatError
from exactsweep.formats.writing import wkt_points, wkt_polygon
from exactsweep.geometry.number import format_fraction
from exactsweep.geometry.point import Point
from exactsweep.sweep import sweep

# A little more than a picture is wide and high, and two lines under it.
_WIDTH, _HEIGHT = 440, 370


class Figure(NamedTuple):
    """A ring or a segment of a case.

    Attributes:
        name: "directrix", "generatrix", "trajectory", "inner", "outer" or "exact fit".
        closed: whether it is a ring; a segment has two points.
        points: tuple of Point, a ring's first one not repeated.
    """

    name: str
    closed: bool
    points: Sequence[Point]


def figures(case: Case) -> Iterator[Figure]:
    """Yield the rings and segments of a case: its input, and the expected answer."""
    yield Figure("directrix", True, case.directrix_ring)
    yield Figure("generatrix", True, case.generatrix_ring)
    yield Figure("trajectory", True, case.trajectory.vertices)
    yield Figure("inner", True, case.inner.vertices)
    yield Figure("outer", True, case.outer.vertices)
    for fit in case.exact_fits:
        yield Figure("exact fit", False, fit)


def cases_to_wkt(cases: Iterable[Case]) -> Iterator[str]:
    """Write cases as a table of comma-separated values, a ring or segment a row.

    Args:
        cases: the cases.

    Returns:
        An iterator of lines: the names of the columns, then for each figure the case's id, the
        figure's name, POLYGON or LINESTRING, and why that is missing: WKT has decimals only, and
        with 1/3 rounded the figure would be another one.

    Cost: linear in the length of the result, times that of dividing numbers of its length.

    Example:
        >>> from exactsweep.corpus import find_case
        >>> print(*list(cases_to_wkt([find_case("fits-square")]))[4:6], sep="", end="")
        fits-square,inner,"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))",
        fits-square,outer,"POLYGON ((-1 -1, 4 -1, 4 4, -1 4, -1 -1))",
    """
    yield _row("case", "figure", "wkt", "missing because")
    for case in cases:
        for name, closed, points in figures(case):
            try:
                ring = wkt_polygon({name: points}).rstrip() if closed else ""
                yield _row(case.id, name, ring or f"LINESTRING {wkt_points(name, points)}", "")
            except FormatError as error:
                yield _row(case.id, name, "", str(error))


def _row(*fields: str) -> str:
    text = StringIO()
    csv.writer(text, lineterminator="\n").writerow(fields)
    return text.getvalue()


def cases_to_geojson(cases: Iterable[Case]) -> Iterator[str]:
    """Write cases as one FeatureCollection (RFC 7946), a ring or segment a feature.

    Args:
        cases: the cases.

    Returns:
        An iterator of lines, a feature a line. Polygons are counter-clockwise and closed, as RFC
        7946 wants them; apart from that the rings of D and G are as given. Readers take numbers for
        doubles: where some coordinate is none, "exact" is false, the geometry has the nearest
        doubles, or is null beyond their range, and "vertices" are the exact ones, as strings.

    Cost: linear in the length of the result.

    Example:
        >>> from exactsweep.corpus import find_case
        >>> text = "".join(cases_to_geojson([find_case("worked-roof")]))
        >>> [f["properties"]["figure"] for f in json.loads(text)["features"]][:2]
        ['directrix', 'generatrix']
    """
    yield '{"type":"FeatureCollection","features":['
    separator = "\n"
    for case in cases:
        for figure in figures(case):
            yield separator + json.dumps(_feature(case, figure), separators=(",", ":"))
            separator = ",\n"
    yield "\n]}\n"


def _feature(case: Case, figure: Figure) -> dict[str, Any]:
    name, closed, points = figure
    properties: dict[str, Any] = {
        "case": case.id,
        "figure": name,
        "class": case.kind,
        "flags": case.flags,
    }
    properties["exact"] = "binary64" in types_holding([c for point in points for c in point], 1)
    if not properties["exact"]:
        properties["vertices"] = [[format_fraction(c) for c in point] for point in points]
    geometry: dict[str, Any] | None = None
    with suppress(OverflowError):
        places = [[float(c) for c in point] for point in points]
        geometry = {"type": "LineString", "coordinates": places}
        if closed:
            ring = places[::-1] if is_clockwise(points) else places
            geometry = {"type": "Polygon", "coordinates": [[*ring, ring[0]]]}
    return {"type": "Feature", "properties": properties, "geometry": geometry}


def cases_to_svg(cases: Iterable[Case]) -> Iterator[str]:
    """Draw cases on a sheet of pictures, in rows and columns, each as a notebook shows the sweep.

    Args:
        cases: the cases.

    Returns:
        An iterator of parts of the text.

    Cost: that of the sweeps with their undercuts, and linear in the number of vertices.

    Example:
        >>> from exactsweep.corpus import find_case
        >>> "".join(cases_to_svg([find_case("fits-square")])).count("<title>CM sweep of 4 around 8")
        1
    """
    drawn = list(cases)
    columns = max(1, isqrt(max(0, len(drawn) - 1)) + 1)
    width, height = columns * _WIDTH, -(-len(drawn) // columns) * _HEIGHT
    yield (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
        'font-family="sans-serif" font-size="14">\n<rect width="100%" height="100%" fill="#fff"/>\n'
    )
    for k, case in enumerate(drawn):
        x, y = k % columns * _WIDTH, k // columns * _HEIGHT
        s = sweep(case.generatrix, case.directrix, reference=case.reference)
        note = f"{case.kind}, {case.size} vertices"
        if not Scale.of(s.outer.vertices, path(s).vertices).is_true:
            note += ", axes scaled apart"
        yield (
            f'<g transform="translate({x} {y})">\n{sweep_svg(s)}\n'
            f'<text x="12" y="{_HEIGHT - 34}">{escape(case.id)}</text>\n'
            f'<text x="12" y="{_HEIGHT - 16}" fill="#777">{note}</text>\n</g>\n'
        )
    yield "</svg>\n"
