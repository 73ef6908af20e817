"""Layouts repaired by small moves, judged valid before they are returned.

Each fault requires its placements to move apart by at least d in a direction n. Hildreth's method
finds the shortest moves that do so for all faults, in floats, which decide nothing: the moved
layout is judged again, and new faults add conditions. This ends soon if parts have room of the size
of the faults, as after rounding. It may not end: a free layout nearby need not exist, and finding
one is a hard problem. After some rounds, each placement with a fault moves to the nearest position
free of all neighbours, if there is one.

Source: Hildreth, "A quadratic programming procedure", Naval Research Logistics Quarterly 4, 1957.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from math import hypot
from typing import NamedTuple

from exactsweep.layout.fault import Fault
from exactsweep.layout.judge import Judgement, judge_layout
from exactsweep.layout.layout import Layout
from exactsweep.layout.repair import find_free_move
from exactsweep.numbers.digits import find_magnitude
from exactsweep.numbers.number import ORIGIN, Point

_ROUNDS, _SINGLE_ROUNDS, _MOST, _SWEEPS = 24, 3, 1000, 4000
# Moves overshoot by this factor, to reach a free layout instead of converging to it.
_MORE, _NEARLY = 1 + 2.0**-10, 2.0**-12
_DIGITS = 6
_MOVABLE = {"overlap", "outside", "too close", "undecided"}


class _Condition(NamedTuple):
    """Two placements, or one, that must move apart by a length in a direction."""

    first: int | None
    last: int
    x: float
    y: float
    length: Fraction


class RepairedLayout(NamedTuple):
    """A valid layout near another one.

    Attributes:
        layout: the Layout.
        moves: the number of each moved placement and its move.
        judgement: the Judgement, which is valid.
    """

    layout: Layout
    moves: dict[int, Point]
    judgement: Judgement

    @property
    def longest_squared(self) -> Fraction:
        """The squared length of the longest move."""
        return max((x * x + y * y for x, y in self.moves.values()), default=Fraction(0))


def repair_layout(judgement: Judgement) -> RepairedLayout | None:
    """Repair a layout by small moves.

    None if no such moves were found, or a fault has no position.

    Cost: up to about thirty judgements, and the repairs of all faults of each.

    Example:
        >>> from exactsweep.layout import Layout
        >>> tile = {"id": "tile", "exterior": [[0, 0], [1, 0], [1, 1], [0, 1]]}
        >>> layout = Layout.from_json({
        ...     "container": {"exterior": [[0, 0], [3, 0], [3, 1], [0, 1]]},
        ...     "parts": [tile],
        ...     "placements": [{"part": "tile", "move": [x, 0]} for x in ("0.5", "1.499999999")],
        ... })
        >>> repair_layout(judge_layout(layout)).judgement.valid
        True
    """
    first, layout = judgement, judgement.layout
    conditions: list[_Condition] = []
    moves: dict[int, Point] = {}
    for k in range(_ROUNDS + _SINGLE_ROUNDS):
        if judgement.valid:
            break
        if k == _ROUNDS:
            judgement = first
        faults = judgement.faults
        if len(faults) > _MOST or not all(fault.kind in _MOVABLE for fault in faults):
            return None
        if k < _ROUNDS:
            conditions += _list_conditions(faults, moves)
            moves = _find_least_moves(conditions)
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


def _list_conditions(faults: Iterable[Fault], moves: dict[int, Point]) -> Iterator[_Condition]:
    """Turn the faults that remain after some moves into conditions."""
    for fault in faults:
        if not (move := fault.move) or move == ORIGIN:
            continue
        last = fault.placements[-1]
        first = fault.placements[0] if len(fault.placements) > 1 else None
        size = max(map(abs, move))
        x, y = float(move.x / size), float(move.y / size)
        norm = hypot(x, y)
        x, y = x / norm, y / norm
        before, after = (
            moves.get(first, ORIGIN) if first is not None else ORIGIN,
            moves.get(last, ORIGIN),
        )
        reached = Fraction(x) * (after.x - before.x) + Fraction(y) * (after.y - before.y)
        yield _Condition(first, last, x, y, reached + size * Fraction(norm * _MORE))


def _find_least_moves(conditions: Sequence[_Condition]) -> dict[int, Point]:
    """Find nearly shortest moves that satisfy all conditions, if any exist."""
    unit = max((abs(one.length) for one in conditions), default=Fraction(0))
    if not unit:
        return {}
    lengths = [float(one.length / unit) for one in conditions]
    at: dict[int, list[float]] = defaultdict(lambda: [0.0, 0.0])
    pressures = [0.0] * len(conditions)
    for _ in range(_SWEEPS):
        worst = 0.0
        for k, (first, last, x, y, _) in enumerate(conditions):
            here, there = at[last], None if first is None else at[first]
            missing = lengths[k] - x * here[0] - y * here[1]
            if there is not None:
                missing += x * there[0] + y * there[1]
            worst = max(worst, missing)
            change = max(-pressures[k], missing / (1 if there is None else 2))
            pressures[k] += change
            here[0] += change * x
            here[1] += change * y
            if there is not None:
                there[0] -= change * x
                there[1] -= change * y
        if worst <= _NEARLY * min(map(abs, lengths)):
            break
    return {
        k: Point(_round(Fraction(x) * unit), _round(Fraction(y) * unit))
        for k, (x, y) in at.items()
        if x or y
    }


def _move_one_by_one(judgement: Judgement) -> dict[int, Point]:
    """For one placement of each fault, find the nearest position free of everything else."""
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


def _round(value: Fraction) -> Fraction:
    """Round a number to a few digits, away from 0."""
    if not value:
        return value
    unit = Fraction(10) ** (find_magnitude(abs(value)) - _DIGITS)
    whole = -(-abs(value) // unit) * unit
    return whole if value > 0 else -whole
