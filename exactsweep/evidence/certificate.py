"""Certificates as plain JSON data: claims, and the reasons of a sweep by the procedures.

All numbers are strings, reduced rationals; all indices count the vertices as the certificate lists
them, edge k running from vertex k to the next. `exactsweep.check.verify`, which shares no code with
this side, documents the claim of each list, and the conditions that prove the claims.

Polygons of any shape have claims alone: `verify` finds all places where a free position could be,
and compares the claim with them. Positions are translations of the polygon that moves.

A monotone sweep has reasons for every edge of its loops. The trajectory and the exact fits are
positions of the reference point. The certificate has the input (`generatrix`, `directrix`,
`reference`, `direction`), the answer (`kind`, `trajectory`, `inner`, `outer`, `area`, `exact_fits`)
and its reasons: `contacts`, for each edge of the trajectory its contacts as [event, feature of G,
feature of D]; `inner_drawn` and `outer_drawn`, for each edge of the loop what draws it as [[where
on the trajectory], [feature of G]].

>>> from exactsweep import sweep
>>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
>>> proof = sweep(square, square).certificate()
>>> proof["contacts"][0], proof["outer_drawn"][0]
([['EE', 2, 0]], [[['edge', 0], ['edge', 0]]])
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any

from exactsweep.evidence.drawn import DrawnPiece
from exactsweep.geometry.direction import Vector
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.number import Point

HEADER = {"format": "exactsweep certificate", "version": 2}
_DIGITS_OF_AN_INT = 4300

Fits = Iterable[Sequence[Point]]


def write_direction(direction: Vector) -> list[int | str]:
    """Write two ints, each in a string if it has more digits than readers of JSON accept."""
    texts = [(number, format_fraction(Fraction(number))) for number in direction]
    return [text if len(text) > _DIGITS_OF_AN_INT else number for number, text in texts]


def write_drawn(edges: Iterable[Iterable[DrawnPiece]]) -> list[list[list[list[str | int]]]]:
    """Write what draws each edge: [[where on the trajectory], [feature of G]]."""
    return [[[list(place), list(feature)] for place, feature, _ in drawn] for drawn in edges]


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
        **HEADER,
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
        **HEADER,
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
