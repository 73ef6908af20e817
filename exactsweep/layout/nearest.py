"""The minimum distance between two solids that do not overlap, and the closest pair of parts.

Two disjoint segments are nearest at an end of one of them, so their squared distance is a quotient
of two ints.
"""

from collections.abc import Iterable
from fractions import Fraction
from math import ceil, isqrt
from typing import NamedTuple

from exactsweep.geometry.distance import SquaredDistance, find_nearest_ends, measure_ends
from exactsweep.geometry.edges import BoxedEdge
from exactsweep.geometry.vectors import minus, orientation, touch
from exactsweep.layout.board import Board
from exactsweep.layout.clearance import Clearance, find_clearance, measure_gap
from exactsweep.layout.solid import LatticeForm, Solid, share_scale
from exactsweep.numbers.number import Edge, Point, Rational


def find_gap(a: Solid, b: Solid, below: Fraction) -> SquaredDistance | None:
    """Find the squared distance of disjoint polygonal solids on one lattice, if below a bound."""
    assert isinstance(a.form, LatticeForm)
    assert isinstance(b.form, LatticeForm)
    scale = a.scale
    bound = below * scale * scale
    n: Rational = bound.numerator
    d: Rational = bound.denominator
    reach = isqrt(n // d) + 1
    x, y = b.x - a.x, b.y - a.y
    left, right, low, high = a.form.box
    west, east, south, north = b.form.box
    ours = a.form.near((west + x - reach, east + x + reach, south + y - reach, north + y + reach))
    around = (left - x - reach, right - x + reach, low - y - reach, high - y + reach)
    theirs = b.form.near(around) if ours else []
    best: tuple[BoxedEdge, BoxedEdge] | None = None
    for e in theirs:
        left, right, low, high = e[0] + x, e[1] + x, e[2] + y, e[3] + y
        farthest, nearest = right + reach, left - reach
        other = _move(e, x, y)
        for f in ours:
            if f[0] > farthest:
                break
            if f[1] < nearest:
                continue
            across = left - f[1] if left > f[1] else f[0] - right if f[0] > right else 0
            up = low - f[3] if low > f[3] else f[2] - high if f[2] > high else 0
            if (across * across + up * up) * d >= n:
                continue
            one = f[4], f[5]
            if _is_far(one, other, n, d) or _is_far(other, one, n, d):
                continue
            square, length = measure_ends(one, other)[:2] if touch(*one, *other) == [] else (0, 1)
            if square * d < n * length:
                n, d, best = square, length, (f, e)
                reach = isqrt(n // d) + 1
                farthest, nearest = right + reach, left - reach
    if best is None:
        return None
    one, other = _move(best[0], 0, 0), _move(best[1], x, y)
    if n:
        p, q = find_nearest_ends(one, other)
    else:
        # Solids that touch without overlap share a vertex of one of them.
        p = q = Point(*map(Fraction, (touch(*one, *other) or [one[0]])[0]))
    return SquaredDistance(
        Fraction(n, d * scale * scale) if type(n) is int else Fraction(n) / d / scale**2,
        (a.to_point(p[0] + a.x, p[1] + a.y), a.to_point(q[0] + a.x, q[1] + a.y)),
    )


def _move(edge: BoxedEdge, x: int, y: int) -> Edge:
    (ax, ay), (bx, by) = edge[4:6]
    return (ax + x, ay + y), (bx + x, by + y)


def _is_far(line: Edge, edge: Edge, n: Rational, d: Rational) -> bool:
    of_p, of_q = (orientation(*line, end) for end in edge)
    least = min(of_p, of_q) if of_p > 0 else -max(of_p, of_q)
    dx, dy = minus(*line)
    return least > 0 and least * least * d >= n * (dx * dx + dy * dy)


class NearestPair(NamedTuple):
    square: Fraction  # rounded up with relative error at most 2^-63 if irrational
    placements: tuple[int, int]
    points: tuple[Point, ...]  # the nearest points; for overlapping parts, a point inside both


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
