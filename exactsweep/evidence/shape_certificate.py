"""Certificates for polygons of any shape, as plain JSON data: the claim alone.

All numbers are strings, reduced rationals; positions are translations of the polygon that moves. A
certificate needs no reasons: `exactsweep.check.verify` finds all places where a free position could
be, and compares the claim with them.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from exactsweep.evidence.certificate import FORMAT, VERSION
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.number import Point

Fits = Iterable[Sequence[Point]]


def claim_no_fit(
    directrix: Region,
    generatrix: Region,
    exterior: Polygon,
    holes: Iterable[Polygon],
    exact_fits: Fits,
) -> dict[str, Any]:
    """Write the certificate of a no-fit polygon, as translations. Cost: linear.

    >>> square = Region([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> around = Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> claim_no_fit(square, square, around, [], [])["exterior"][0]
    ['-1', '-1']
    """
    return {
        "format": FORMAT,
        "version": VERSION,
        "claim": "no_fit",
        "directrix": _outline(directrix),
        "generatrix": _outline(generatrix),
        "exterior": write_points(exterior.vertices),
        "holes": [write_points(hole.vertices) for hole in holes],
        "exact_fits": [write_points(fit) for fit in exact_fits],
    }


def claim_inner_fit(
    container: Region, part: Region, regions: Iterable[Region], exact_fits: Fits
) -> dict[str, Any]:
    """Write the certificate of an inner fit, as translations. Cost: linear.

    >>> square = Region([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> claim_inner_fit(square, square, [], [(Point(0, 0), Point(0, 0))])["exact_fits"]
    [[['0', '0'], ['0', '0']]]
    """
    return {
        "format": FORMAT,
        "version": VERSION,
        "claim": "inner_fit",
        "container": _outline(container),
        "part": _outline(part),
        "regions": [_outline(region) for region in regions],
        "exact_fits": [write_points(fit) for fit in exact_fits],
    }


def _outline(region: Region) -> dict[str, Any]:
    holes = [write_points(hole.vertices) for hole in region.holes]
    return {"exterior": write_points(region.exterior.vertices), "holes": holes}


def write_points(points: Iterable[Point]) -> list[list[str]]:
    """Write points as lists of strings. Cost: linear."""
    return [[format_fraction(c) for c in point] for point in points]
