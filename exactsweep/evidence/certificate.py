"""Certificates: a sweep with the reasons for every edge of its loops, as plain JSON data.

All numbers are strings, reduced rationals; all indices count the vertices as the certificate lists
them, edge k running from vertex k to the next. The trajectory and the exact fits are positions of
the reference point. `exactsweep.check.verify`, which shares no code with this side, documents the
claim of each list, and the conditions under which the claims together prove the sweep.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from exactsweep.evidence.contact import Contact
from exactsweep.evidence.drawn import DrawnPiece
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.number import format_fraction
from exactsweep.numbers.point import Point

FORMAT = "exactsweep certificate"
VERSION = 2
_DIGITS_OF_AN_INT = 4300


class Statement(NamedTuple):
    """The content of a certificate of a sweep, features numbered in canonical order.

    Attributes:
        generatrix: G, a Polygon.
        directrix: D, a Polygon.
        kind: "CC", "CM" or "MM".
        direction: the shared direction, a pair of ints.
        reference: the point of G whose path the trajectory is.
        trajectory, inner, outer: the loops, Polygons.
        area: the swept area.
        exact_fits: pairs of Point.
        contacts: for each edge of the trajectory, its contacts.
        inner_drawn, outer_drawn: for each edge of the loop, what draws it.
    """

    generatrix: Polygon
    directrix: Polygon
    kind: str
    direction: Sequence[int]
    reference: Point
    trajectory: Polygon
    inner: Polygon
    outer: Polygon
    area: Fraction
    exact_fits: Sequence[Sequence[Point]]
    contacts: Sequence[Sequence[Contact]]
    inner_drawn: Sequence[Sequence[DrawnPiece]]
    outer_drawn: Sequence[Sequence[DrawnPiece]]


def write_certificate(statement: Statement) -> dict[str, Any]:
    """Write the certificate of a sweep.

    Args:
        statement: the sweep and its reasons.

    Returns:
        A dict ready for `json.dump`: the input (`generatrix`, `directrix`, `reference`,
        `direction`, two ints, each in a string if it is long), the answer (`kind`, `trajectory`,
        `inner`, `outer`, `area`, `exact_fits`) and its reasons: `contacts`, for each edge of the
        trajectory its contacts as [event, feature of G, feature of D]; `inner_drawn` and
        `outer_drawn`, for each edge of the loop what draws it as [[where on the trajectory],
        [feature of G]].

    Cost: linear in the size of the statement.

    Example:
        >>> from exactsweep import sweep
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> proof = sweep(square, square).certificate()
        >>> proof["contacts"][0], proof["outer_drawn"][0]
        ([['EE', 2, 0]], [[['edge', 0], ['edge', 0]]])
    """
    return {
        "format": FORMAT,
        "version": VERSION,
        "generatrix": _points(statement.generatrix.vertices),
        "directrix": _points(statement.directrix.vertices),
        "kind": statement.kind,
        "direction": list(map(_written_int, statement.direction)),
        "reference": _point(statement.reference),
        "trajectory": _points(statement.trajectory.vertices),
        "inner": _points(statement.inner.vertices),
        "outer": _points(statement.outer.vertices),
        "area": format_fraction(statement.area),
        "exact_fits": [_points(fit) for fit in statement.exact_fits],
        "contacts": [[list(c) for c in found] for found in statement.contacts],
        "inner_drawn": _drawn(statement.inner_drawn),
        "outer_drawn": _drawn(statement.outer_drawn),
    }


def _written_int(number: int) -> int | str:
    """An int, or its digits in a string where Python and others do not read that many of an int."""
    text = format_fraction(Fraction(number))
    return text if len(text) > _DIGITS_OF_AN_INT else number


def _drawn(edges: Sequence[Sequence[DrawnPiece]]) -> list[list[list[list[str | int]]]]:
    return [[[list(place), list(feature)] for place, feature, *_ in drawn] for drawn in edges]


def _points(points: Sequence[Point]) -> list[list[str]]:
    return [_point(point) for point in points]


def _point(point: Iterable[Any]) -> list[str]:
    return [format_fraction(c) for c in point]
