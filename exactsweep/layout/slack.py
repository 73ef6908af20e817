"""The proved slack of a valid layout: how far its container can shrink, and its parts can grow.

A convex container K shrinks about a corner c to c + s (K - c). For an edge with n.p <= h, a part
with maximum m of n.p, including errors, is inside if m - n.c <= s (h - n.c). So the minimum s is a
maximum of quotients. A disc shrinks about its center to the maximum distance of the parts' points.
Numbers are rounded up, and the judge accepts the shrunk layout.
"""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from exactsweep.geometry.region import Region
from exactsweep.layout.judge import Judgement, judge_layout
from exactsweep.layout.layout import Layout
from exactsweep.layout.rounded import RoundedPiece, bound_root
from exactsweep.layout.solid import Solid
from exactsweep.numbers.digits import find_magnitude
from exactsweep.numbers.number import Point

_BITS, _DIGITS = 128, 30


class ProvedSlack(NamedTuple):
    layout: Layout  # with the shrunk container
    scale: Fraction  # of the container, at most 1
    center: Point  # the fixed point: a corner of a polygon, the center of a disc
    growth: Fraction  # all parts can grow by this in place, at the given spacing


def find_slack(judgement: Judgement) -> ProvedSlack | None:
    """Find the slack of a layout; None if it is invalid, has defects, or lacks a convex container.

    >>> from exactsweep.corpus import find_layout_case
    >>> slack = find_slack(judge_layout(find_layout_case("layouts-record-squares-11").layout))
    >>> float(1 - slack.scale) < 1e-6 and float(slack.growth) < 1e-8
    True
    """
    layout, container = judgement.layout, judgement.layout.container
    if not judgement.valid or container is None or layout.defects:
        return None
    board = judgement._board
    solids = [board.solid(k) for k in board.placed]
    shrunk: Region | RoundedPiece
    if isinstance(container, RoundedPiece):
        if len(container.points) > 1:
            return None
        center, scale = container.points[0], _shrink_disc(container, solids, layout)
        shrunk = container._replace(radius=container.radius * scale)
    else:
        center, ring = container.exterior.vertices[0], container.exterior.vertices
        if not container.is_convex:
            return None
        scale = _shrink_polygon(ring, center, solids, layout)
        x, y = center
        shrunk = Region([(x + scale * (p.x - x), y + scale * (p.y - y)) for p in ring])
    found = replace(layout, container=shrunk)
    if scale > 1 or not judge_layout(found).valid:
        return None
    return ProvedSlack(found, scale, center, _find_growth(judgement, solids))


def _list_points(solid: Solid) -> Iterator[tuple[Point, Fraction]]:
    for piece, radius in solid.rounded:
        for x, y in piece:
            yield solid.to_point(x, y), Fraction(radius) / solid.scale


def _find_room(solid: Solid, layout: Layout) -> Fraction:
    """Return the distance that the judge needs: the margin, and the errors with a reserve."""
    return layout.margin + 2 * solid.slack + layout.error


def _shrink_polygon(
    ring: tuple[Point, ...], center: Point, solids: list[Solid], layout: Layout
) -> Fraction:
    scale = Fraction(0)
    for a, b in pairwise((*ring, ring[0])):
        x, y = b.y - a.y, a.x - b.x
        height = x * (a.x - center.x) + y * (a.y - center.y)
        length = bound_root(x * x + y * y, _BITS)[1]
        if not height:
            # The sides at the fixed corner stay on their lines.
            continue
        for solid in solids:
            room = _find_room(solid, layout)
            reach = max(
                x * (p.x - center.x) + y * (p.y - center.y) + length * radius
                for p, radius in _list_points(solid)
            )
            scale = max(scale, (reach + length * room) / height)
    return min(_round_up(scale), Fraction(1)) if scale else Fraction(1)


def _shrink_disc(container: RoundedPiece, solids: list[Solid], layout: Layout) -> Fraction:
    (x, y), reach = container.points[0], Fraction(0)
    for solid in solids:
        room = _find_room(solid, layout)
        for p, radius in _list_points(solid):
            apart = bound_root((p.x - x) ** 2 + (p.y - y) ** 2, _BITS)[1]
            reach = max(reach, apart + radius + room)
    return min(_round_up(reach / container.radius), Fraction(1)) if reach else Fraction(1)


def _round_up(value: Fraction) -> Fraction:
    unit = Fraction(10) ** (find_magnitude(value) - _DIGITS + 1)
    return -(-value // unit) * unit


def _find_growth(judgement: Judgement, solids: list[Solid]) -> Fraction:
    nearest = judgement.distance
    if nearest is None:
        return Fraction(0)
    slack = max((solid.slack for solid in solids), default=Fraction(0))
    low = bound_root(nearest.square, _BITS)[0]
    if any(part.pieces for part in judgement.layout.parts):
        low *= 1 - Fraction(1, 2**60)
    return max(Fraction(0), (low - 2 * slack - judgement.layout.spacing) / 2)
