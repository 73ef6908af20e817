"""The two placed parts that are nearest to each other."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import ceil, isqrt
from typing import NamedTuple

from exactsweep.layout.board import Board
from exactsweep.layout.meeting import Relation, meet
from exactsweep.layout.nearest import find_gap
from exactsweep.layout.solid import Solid, share_scale
from exactsweep.numbers.point import Point


class NearestPair(NamedTuple):
    """Two placements whose parts are nearest.

    Attributes:
        square: the squared distance, 0 for parts that touch or overlap.
        placements: their numbers.
        points: the nearest point of each; none for parts that overlap.
    """

    square: Fraction
    placements: tuple[int, int]
    points: tuple[Point, ...]


def find_nearest_pair(board: Board) -> NearestPair | None:
    """Find the two placed parts of a board that are nearest to each other.

    Pairs whose boxes meet are looked at first, and then those whose boxes are nearer than the best
    of these.

    Returns:
        A NearestPair; None if fewer than two parts are placed.

    Cost: that of finding the pairs whose boxes are so near, and of `find_gap` for each.
    """
    if len(board.placed) < 2:
        return None
    reach = Fraction(0)
    while not (pairs := list(board.list_near(reach))):
        reach = 2 * reach or board.grain
    best = _find_best(board, pairs, None)
    within = Fraction(isqrt(ceil(best.square * board.unit**2)) + 1, board.unit)
    return best if within <= reach else _find_best(board, board.list_near(within), best)


def _find_best(
    board: Board, pairs: Iterable[tuple[int, int]], best: NearestPair | None
) -> NearestPair:
    """The nearest pair among some, or the best one known, if none is nearer."""
    for k, j in pairs:
        if best is not None and best.square == 0:
            break
        a, b = share_scale(board.solid(k), board.solid(j))
        if meet(a, b) is Relation.OVERLAP:
            return NearestPair(Fraction(0), (k, j), ())
        gap = find_gap(a, b, _bound(a, b) if best is None else best.square)
        if gap is not None:
            best = NearestPair(gap.square, (k, j), gap.points)
    assert best is not None  # the first pair is below its bound
    return best


def _bound(a: Solid, b: Solid) -> Fraction:
    """More than the squared distance of two solids."""
    (ax, ay), (bx, by) = a.form.rings[0][0], b.form.rings[0][0]
    dx, dy = ax + a.x - bx - b.x, ay + a.y - by - b.y
    return Fraction(dx * dx + dy * dy + 1) / a.scale**2
