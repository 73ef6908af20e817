"""The closest pair of placed parts."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import ceil, isqrt
from typing import NamedTuple

from exactsweep.layout.board import Board
from exactsweep.layout.clearance import Clearance, find_clearance, measure_gap
from exactsweep.layout.nearest import find_gap
from exactsweep.layout.solid import LatticeForm, Solid, share_scale
from exactsweep.numbers.number import Point


class NearestPair(NamedTuple):
    """Two placements whose parts are nearest."""

    square: Fraction  # rounded up with relative error at most 2^-63 if irrational
    placements: tuple[int, int]
    points: tuple[Point, ...]  # the nearest ones; for overlapping parts, a point inside both


def find_nearest_pair(board: Board, touching: tuple[int, int] | None) -> NearestPair | None:
    """Find the nearest placed parts without overlaps; `touching` is a pair in contact, if any."""
    if any(board.solid(k).form.is_rounded for k in board.placed):
        return _find_rounded(board)
    if touching is not None:
        return _find_best(board, [touching], None)
    if len(board.placed) < 2:
        return None
    reach = Fraction(0)
    while not (pairs := list(board.list_near(reach))):
        reach = 2 * reach or board.grain
    best = _find_best(board, pairs, None)
    within = Fraction(isqrt(ceil(best.square * board.unit**2)) + 1, board.unit)
    if within <= reach:
        return best
    seen = set(pairs)
    return _find_best(board, (p for p in board.list_near(within) if p not in seen), best)


def _find_best(
    board: Board, pairs: Iterable[tuple[int, int]], best: NearestPair | None
) -> NearestPair:
    """Return the nearest of the pairs, or `best` if none is nearer."""
    for k, j in pairs:
        if best is not None and best.square == 0:
            break
        a, b = share_scale(board.solid(k), board.solid(j))
        gap = find_gap(a, b, _bound(a, b) if best is None else best.square)
        if gap is not None:
            best = NearestPair(gap.value, (k, j), gap.points)
    assert best is not None  # the first pair is below its bound
    return best


def _find_rounded(board: Board) -> NearestPair | None:
    if len(board.placed) < 2:
        return None
    reach, seen = Fraction(0), set[tuple[int, int]]()
    best: tuple[Clearance, tuple[int, int]] | None = None
    least: Fraction | None = None
    while least is None or reach < least:
        reach = least or 2 * reach or board.grain
        for k, j in board.list_near(reach):
            if (k, j) in seen:
                continue
            seen.add((k, j))
            found = find_clearance(*share_scale(board.solid(k), board.solid(j)), least)
            if found is not None and (best is None or found.is_less(best[0])):
                best, least = (found, (k, j)), found.bound(up=True)
    assert best is not None
    found, (k, j) = best
    gap = measure_gap(*share_scale(board.solid(k), board.solid(j)), found)
    return NearestPair(gap.value, (k, j), gap.points)


def _bound(a: Solid, b: Solid) -> Fraction:
    assert isinstance(a.form, LatticeForm)
    assert isinstance(b.form, LatticeForm)
    (ax, ay), (bx, by) = a.form.rings[0][0], b.form.rings[0][0]
    dx, dy = ax + a.x - bx - b.x, ay + a.y - by - b.y
    return Fraction(dx * dx + dy * dy + 1) / a.scale**2
