"""Certificates: a sweep with the reasons for every edge of its loops, as plain JSON data.

All numbers are strings, reduced rationals; all indices count the vertices as the certificate lists
them, edge k running from vertex k to the next. The trajectory and the exact fits are positions of
the reference point. `exactsweep.check.verify`, which shares no code with this side, documents the
claim of each list, and the conditions under which the claims together prove the sweep.

A certificate has the input (`generatrix`, `directrix`, `reference`, `direction`), the answer
(`kind`, `trajectory`, `inner`, `outer`, `area`, `exact_fits`) and its reasons: `contacts`, for each
edge of the trajectory its contacts as [event, feature of G, feature of D]; `inner_drawn` and
`outer_drawn`, for each edge of the loop what draws it as [[where on the trajectory], [feature of
G]].

>>> from exactsweep import sweep
>>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
>>> proof = sweep(square, square).certificate()
>>> proof["contacts"][0], proof["outer_drawn"][0]
([['EE', 2, 0]], [[['edge', 0], ['edge', 0]]])
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from exactsweep.evidence.drawn import DrawnPiece
from exactsweep.geometry.direction import Vector
from exactsweep.numbers.digits import format_fraction

FORMAT = "exactsweep certificate"
VERSION = 2
_DIGITS_OF_AN_INT = 4300


def write_direction(direction: Vector) -> list[int | str]:
    """Write two ints, each in a string if it has more digits than readers of JSON accept."""
    texts = [(number, format_fraction(Fraction(number))) for number in direction]
    return [text if len(text) > _DIGITS_OF_AN_INT else number for number, text in texts]


def write_drawn(edges: Iterable[Iterable[DrawnPiece]]) -> list[list[list[list[str | int]]]]:
    """Write what draws each edge: [[where on the trajectory], [feature of G]]."""
    return [[[list(place), list(feature)] for place, feature, _ in drawn] for drawn in edges]
