"""Layouts repaired by small moves, judged valid before they are returned.

Each round moves the placements of all faults by their repairs, the two of a pair by half of it
each, and judges the layout again. That ends soon where parts have room of the size of the faults,
as after rounding. It may not end: the least moves that free all parts need not exist nearby, and
finding them is a hard problem. What is left after some rounds is moved, one by one, to the nearest
position that is free of all neighbours, if there is any.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction
from typing import NamedTuple

from exactsweep.layout.fault import Fault
from exactsweep.layout.judge import Judgement, judge_layout
from exactsweep.layout.layout import Layout
from exactsweep.layout.repair import find_free_move
from exactsweep.numbers.digits import find_magnitude
from exactsweep.numbers.number import ORIGIN, Point

_ROUNDS, _SINGLE_ROUNDS, _MOST = 16, 3, 1000
# Halves of moves overshoot, so that rounds do not only approach a free layout.
_SHARE = Fraction(9, 16)
_DIGITS = 4
_MOVABLE = {"overlap", "outside", "too close", "undecided"}


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

    Args:
        judgement: the judgement of the layout.

    Returns:
        A RepairedLayout; None if no such moves were found, or a fault is none of positions.

    Cost: up to some twenty judgements, and the repairs of all faults of each.

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
    first = judgement
    for k in range(_ROUNDS + _SINGLE_ROUNDS):
        if judgement.valid:
            return _sum_up(first.layout, judgement)
        faults = judgement.faults
        if len(faults) > _MOST or not all(fault.kind in _MOVABLE for fault in faults):
            return None
        moves = _share_moves(faults) if k < _ROUNDS else _move_one_by_one(judgement)
        if not moves:
            return None
        judgement = judge_layout(_move(judgement.layout, moves))
    return _sum_up(first.layout, judgement) if judgement.valid else None


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


def _share_moves(faults: Iterable[Fault]) -> dict[int, Point]:
    """Share the repairs of faults among their placements; the largest in each direction counts."""
    wanted: dict[int, list[Point]] = {}
    for fault in faults:
        if (move := fault.move) is None:
            continue
        if len(fault.placements) == 1:
            wanted.setdefault(fault.placements[0], []).append(move)
            continue
        first, last = fault.placements
        x, y = (_round(value * _SHARE) for value in move)
        wanted.setdefault(last, []).append(Point(x, y))
        wanted.setdefault(first, []).append(Point(-x, -y))
    found = {
        k: Point(*(max(0, *values) + min(0, *values) for values in zip(*moves, strict=True)))
        for k, moves in wanted.items()
    }
    return {k: move for k, move in found.items() if move != ORIGIN}


def _move_one_by_one(judgement: Judgement) -> dict[int, Point]:
    """Find for one placement of each fault the nearest position free of everything else."""
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
