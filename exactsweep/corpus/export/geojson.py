"""Cases as GeoJSON (RFC 7946), whose readers take numbers for doubles.

A figure whose coordinates are not all doubles is marked: its "exact" is false, its geometry has the
nearest doubles, or is null beyond their range, and its "vertices" are the exact ones, as strings.
"""

import json
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from exactsweep.corpus.case import Case
from exactsweep.corpus.representable import types_holding
from exactsweep.geometry.number import format_fraction
from exactsweep.geometry.point import Point


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


def cases_to_geojson(cases: Iterable[Case]) -> Iterator[str]:
    """Write cases as one FeatureCollection, a ring or segment a feature.

    Args:
        cases: the cases.

    Returns:
        An iterator of lines, a feature a line. Polygons are counter-clockwise and closed, as RFC
        7946 wants them; the rings of D and G are else as given.

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
    exact = "binary64" in types_holding([c for point in figure.points for c in point], 1)
    properties = {
        "case": case.id,
        "figure": figure.name,
        "class": case.kind,
        "flags": case.flags,
        "exact": exact,
    }
    if not exact:
        properties["vertices"] = [[format_fraction(c) for c in point] for point in figure.points]
    return {
        "type": "Feature",
        "properties": properties,
        "geometry": _geometry(figure),
    }


def _geometry(figure: Figure) -> dict[str, Any] | None:
    points = figure.points
    if figure.closed:
        points = points if _area(points) > 0 else points[::-1]
        points = [*points, points[0]]
    try:
        numbers = [[_double(c) for c in point] for point in points]
    except OverflowError:
        return None
    if figure.closed:
        return {"type": "Polygon", "coordinates": [numbers]}
    return {"type": "LineString", "coordinates": numbers}


def _double(value: Fraction) -> int | float:
    nearest = value.numerator / value.denominator
    return int(nearest) if abs(nearest) < 2**53 and nearest == int(nearest) else nearest


def _area(ring: Sequence[Point]) -> Fraction:
    pairs = zip(ring, [*ring[1:], ring[0]], strict=True)
    return sum((p.x * q.y - q.x * p.y for p, q in pairs), start=Fraction(0))
