"""Repair of layouts by small moves; the judge accepts each result.

Two convex pieces keep a distance if the difference of their moves is long enough in the direction
that separates them, which is a linear condition. Hildreth's method ("A quadratic programming
procedure", Naval Research Logistics Quarterly 4, 1957) finds the shortest moves that satisfy the
conditions of all nearby pieces. It uses floats, which prove nothing, so each round judges the moved
layout exactly and adds conditions. Deep overlaps use their shortest repair instead. A few rounds
suffice if the gaps between parts are as large as the faults, as after rounding. After the last
round, each faulty placement moves to the nearest position free of all others, if there is one.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import chain
from math import hypot
from typing import NamedTuple

from exactsweep.layout.board import Board
from exactsweep.layout.clearance import list_clearances
from exactsweep.layout.fault import Fault
from exactsweep.layout.judge import Judgement, judge_layout
from exactsweep.layout.layout import Layout
from exactsweep.layout.repair import find_free_move
from exactsweep.layout.solid import OutsideForm, Solid, share_scale
from exactsweep.numbers.digits import find_magnitude
from exactsweep.numbers.number import ORIGIN, Point

_ROUNDS, _SINGLE_ROUNDS, _SWEEPS, _UPDATES = 24, 3, 4000, 4 * 10**6
# Extra clearance relative to the fault, so that rounded moves remain valid, and the share of it
# that sweeps and rounding may use.
_MORE, _NEARLY = Fraction(1, 2**7), Fraction(1, 2**3)
# Overlaps deeper than this fraction of the smallest part's size are repaired singly.
_DEEP = Fraction(1, 2**6)
# Other pieces within this multiple of the deepest overlap must stay apart.
_REACH = 8
_MAX_FAULTS = 2000
# Beyond this number of vertex pairs, a repair is faster than a comparison of pieces.
_MOST = 10**4
_MOVABLE = {"overlap", "outside", "too close", "undecided"}


class _Condition(NamedTuple):
    """A minimum length of the relative move in a unit direction; negative if there is a gap."""

    placements: tuple[int, ...]
    x: float
    y: float
    length: Fraction


class RepairedLayout(NamedTuple):
    """A valid layout near a given one, and the moves by placement index."""

    layout: Layout
    moves: dict[int, Point]
    judgement: Judgement

    @property
    def longest_squared(self) -> Fraction:
        return max((x * x + y * y for x, y in self.moves.values()), default=Fraction(0))


def repair_layout(judgement: Judgement) -> RepairedLayout | None:
    """Repair a layout by small moves.

    It is None if no such moves were found, a fault does not depend on positions, or there are
    more than 2,000 faults. It takes up to thirty judgements and the repairs of deep faults.

    >>> from exactsweep.corpus import find_layout_case
    >>> nudged = judge_layout(find_layout_case("layouts-tangram-nudged").layout)
    >>> nudged.valid, repair_layout(nudged).judgement.valid
    (False, True)
    """
    first, layout = judgement, judgement.layout
    conditions: list[_Condition] = []
    moves: dict[int, Point] = {}
    for k in range(_ROUNDS + _SINGLE_ROUNDS):
        if judgement.valid:
            break
        faults = judgement.faults
        if len(faults) > _MAX_FAULTS or not all(fault.kind in _MOVABLE for fault in faults):
            return None
        if k == _ROUNDS:
            judgement = first
        if k < _ROUNDS:
            found, near = _list_conditions(judgement)
            more = _MORE * max((one.length for one in (*conditions, *found)), default=Fraction(0))
            conditions += (_add_moves(one, moves, more) for one in found)
            others = [_add_moves(one, moves, min(more, -one.length)) for one in near]
            moves = _find_least_moves(conditions + others, more * _NEARLY)
            judgement = judge_layout(_move(layout, moves))
        else:
            judgement = judge_layout(_move(judgement.layout, _move_one_by_one(judgement)))
    return _sum_up(layout, judgement) if judgement.valid else None


def _sum_up(layout: Layout, judgement: Judgement) -> RepairedLayout:
    moves = {}
    for k, (old, new) in enumerate(
        zip(layout.placements, judgement.layout.placements, strict=True)
    ):
        if old.move != new.move:
            moves[k] = Point(new.move.x - old.move.x, new.move.y - old.move.y)
    return RepairedLayout(judgement.layout, moves, judgement)


def _move(layout: Layout, moves: dict[int, Point]) -> Layout:
    placements = list(layout.placements)
    for k, (x, y) in moves.items():
        at = placements[k].move
        placements[k] = replace(placements[k], move=Point(at.x + x, at.y + y))
    return replace(layout, placements=tuple(placements))


def _list_conditions(judgement: Judgement) -> tuple[list[_Condition], list[_Condition]]:
    """List the conditions of faults and, if none is deep, of other nearby pieces."""
    board, faults = judgement._board, judgement.faults
    found = [
        one for f in faults for one in _list_piece_conditions(board, f.placements, Fraction(0))
    ]
    longest = max((one.length for one in found), default=board.grain)
    if longest > board.grain * _DEEP:
        return [*chain.from_iterable(map(_use_repair, faults))], []
    reach = _REACH * longest
    near: list[tuple[int, ...]] = [*board.list_near(board.layout.spacing + reach)]
    near += ((k,) for k in board.placed)
    faulty = {fault.placements for fault in faults}
    others = (_list_piece_conditions(board, at, reach) for at in near if at not in faulty)
    return found, [*chain.from_iterable(others)]


def _list_piece_conditions(
    board: Board, at: tuple[int, ...], reach: Fraction
) -> Iterator[_Condition]:
    """Yield the conditions of nearby pieces of two placements, or of one and the obstacles."""
    k = at[-1]
    walls = range(len(board.obstacles)) if len(at) < 2 else ()
    pairs = [(board.obstacles[wall], board.required(wall)) for wall in walls]
    for fixed, required in pairs or [(board.solid(at[0]), board.layout.spacing)]:
        part = board.solid(k)
        if _count(part) * _count(fixed) > _MOST:
            continue
        is_outside = isinstance(fixed.form, OutsideForm)
        pair = share_scale(part, fixed) if is_outside else share_scale(fixed, part)
        needed = required + part.slack + fixed.slack
        for one in list_clearances(*pair, needed + reach):
            x, y = one.hulls.normal
            length = needed - one.bound(up=False)
            yield _make_condition(at, Fraction(x), Fraction(y), length)


def _count(solid: Solid) -> int:
    return sum(len(points) for points, _ in solid.form.rounded)


def _use_repair(fault: Fault) -> Iterator[_Condition]:
    move = fault.move
    if move and move != ORIGIN:
        size = max(map(abs, move))
        length = size * Fraction(hypot(move.x / size, move.y / size))
        yield _make_condition(fault.placements, *move, length)


def _make_condition(at: tuple[int, ...], x: Fraction, y: Fraction, length: Fraction) -> _Condition:
    size = max(abs(x), abs(y))
    a, b = float(x / size), float(y / size)
    norm = hypot(a, b)
    return _Condition(at, a / norm, b / norm, length)


def _add_moves(one: _Condition, moves: dict[int, Point], more: Fraction) -> _Condition:
    """Add the previous moves to a condition on further moves, and lengthen it by `more`."""
    x, y = moves.get(one.placements[-1], ORIGIN)
    if len(one.placements) > 1:
        before = moves.get(one.placements[0], ORIGIN)
        x, y = x - before.x, y - before.y
    reached = Fraction(one.x) * x + Fraction(one.y) * y
    return one._replace(length=reached + one.length + more)


def _find_least_moves(conditions: Sequence[_Condition], nearly: Fraction) -> dict[int, Point]:
    unit = max((one.length for one in conditions), default=Fraction(0))
    if unit <= 0:
        return {}
    lengths = [float(one.length / unit) for one in conditions]
    enough = float(nearly / unit)
    at: dict[int, list[float]] = defaultdict(lambda: [0.0, 0.0])
    pressures = [0.0] * len(conditions)
    ends = [(at[one.placements[-1]], at[one.placements[0]], *one[1:3]) for one in conditions]
    for _ in range(min(_SWEEPS, _UPDATES // len(conditions))):
        worst = 0.0
        for k, (here, there, x, y) in enumerate(ends):
            missing = lengths[k] - x * here[0] - y * here[1]
            if there is not here:
                missing = (missing + x * there[0] + y * there[1]) / 2
            worst = max(worst, missing)
            change = max(-pressures[k], missing)
            if change:
                pressures[k] += change
                here[0] += change * x
                here[1] += change * y
                if there is not here:
                    there[0] -= change * x
                    there[1] -= change * y
        if worst <= enough:
            break
    step = Fraction(10) ** find_magnitude(nearly)
    return {
        k: Point(*(round(Fraction(c) * unit / step) * step for c in (x, y)))
        for k, (x, y) in at.items()
        if x or y
    }


def _move_one_by_one(judgement: Judgement) -> dict[int, Point]:
    moves: dict[int, Point] = {}
    for fault in judgement.faults:
        if moves.keys() & set(fault.placements):
            continue
        for k in reversed(fault.placements):
            move = find_free_move(judgement._board, k)
            if move is not None:
                moves[k] = move
                break
    return moves
