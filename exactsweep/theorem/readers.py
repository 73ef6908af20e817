"""Values in certificates as terms for Coq.

Claims depend on these readers; most belong to `standalone.py`. Evidence is not trusted.
"""

from __future__ import annotations

from contextlib import suppress
from fractions import Fraction
from itertools import groupby
from math import lcm
from typing import Any

from exactsweep.check.standalone import SHAPE, number, place, point, read, ring, rings_of
from exactsweep.geometry.convex import cut_to_convex

RationalPoint = tuple[Fraction, Fraction]
RationalRing = list[RationalPoint]


def read_rational(item: Any) -> Fraction:
    """Read a number."""
    return Fraction(number("number", item))


def read_ring(item: Any) -> RationalRing:
    """Read a loop, or the points of a rounded piece."""
    return [*map(place, read("points", item, [point]))]


def read_rings(items: Any) -> list[RationalRing]:
    """Read loops."""
    return [*map(read_ring, items)]


def read_shape(item: Any) -> list[RationalRing]:
    """Read a shape, the exterior counter-clockwise, holes clockwise."""
    return [[*map(place, points)] for points in rings_of(read("shape", item, SHAPE))]


def read_pieces(items: Any) -> list[RationalRing]:
    """Read convex pieces, or none."""
    return [[*map(place, ring("piece", points))] for points in items or []]


def read_all_pieces(items: Any) -> list[list[RationalRing]]:
    """Read the pieces of each body."""
    return [*map(read_pieces, items)]


def read_path(item: Any) -> RationalRing:
    """Read a path and drop points equal to their predecessors."""
    return [point for point, _ in groupby(read_ring(item))]


def read_fits(items: Any) -> list[tuple[RationalPoint, RationalPoint]]:
    """Read exact fits or slits: pairs of points."""
    return [(place(p), place(q)) for p, q in read("fits", items, [[point, point]])]


def read_regions(items: Any) -> list[Any]:
    """Read the regions of an inner fit."""
    return [(read_ring(item["exterior"]), read_rings(item["holes"])) for item in items]


def read_sums(items: Any) -> list[Any]:
    """Read the listed sums."""
    return [*map(tuple, items)]


def read_frame(item: Any) -> tuple[Fraction, ...]:
    """Read a frame, which may be missing."""
    return tuple(map(read_rational, item or ["0"] * 4))


def cut_region(exterior: Any, holes: Any, *inner: Any) -> tuple[Any, ...]:
    """Cut into convex pieces: a region with its holes, then the inner loop and each hole."""
    first, *others = map(read_ring, [exterior, *inner, *holes])
    return _cut([first, *(points[::-1] for points in others)]), [_cut([e]) for e in others]


def cut_regions(items: Any) -> list[Any]:
    """Cut each region of an inner fit."""
    return [cut_region(item["exterior"], item["holes"]) for item in items]


def _cut(rings: list[RationalRing]) -> list[RationalRing]:
    unit = lcm(*(n.denominator for points in rings for p in points for n in p))
    scaled = [[(int(x * unit), int(y * unit)) for x, y in points] for points in rings]
    with suppress(Exception):  # rings that touch or cross themselves cannot be cut
        found = cut_to_convex(scaled)
        return [[(Fraction(x, unit), Fraction(y, unit)) for x, y in piece] for piece in found]
    return []
