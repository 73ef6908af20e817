"""The relation of two solids at their true turns, proved by rational turns that get nearer.

Let d be the sum of the slacks of two solids, s the distance that they should have.

(1) Solids that are apart by more than d are apart in truth. If their distance is at least s + d,
    or less than s - d, so it is with s in truth.
(2) A point inside a convex piece of a solid, farther from its sides than the slack, is inside the
    solid in truth.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from exactsweep.geometry.convex import ConvexRing
from exactsweep.geometry.distance import measure_to_edge
from exactsweep.layout.meeting import Relation, meet
from exactsweep.layout.nearest import NearestPoints, find_gap
from exactsweep.layout.pieces import bound_piece, find_common_point
from exactsweep.layout.solid import Solid, share_scale
from exactsweep.numbers.point import Point

MOST_BITS = 256
"""As near are rational turns at most to angles that have none."""


class PairVerdict(NamedTuple):
    """The relation of two solids.

    Attributes:
        meeting: a Relation, None if it is undecided.
        gap: the NearestPoints, if it is less than asked for.
        too_close: whether that is so; None if it is undecided.
        bits: how near the turns were that decided.
        slack: the sum of both slacks, 0 where turns are exact.
    """

    meeting: Relation | None
    gap: NearestPoints | None
    too_close: bool | None
    bits: int
    slack: Fraction


class CommonPoint(NamedTuple):
    """A point inside two solids, and the numbers of a piece of each that has it inside."""

    point: Point
    pieces: tuple[int, int]


Refine = Callable[[int], tuple[Solid, Solid]]
"""The pair of solids, with turns off by at most 2**-bits."""


def judge_pair(refine: Refine, bits: int, spacing: Fraction) -> PairVerdict:
    """Decide how two solids lie, and whether they are less than the spacing apart.

    Args:
        refine: gives the two solids.
        bits: how near the turns are at first; they are doubled until the verdict is proved.
        spacing: the least distance that is asked for.

    Cost: that of `meet` for exact turns, and with a spacing or without exact turns of `find_gap`.
    """
    while True:
        a, b = share_scale(*refine(bits))
        found = _decide(a, b, bits, spacing)
        if (found.meeting and found.too_close is not None) or bits >= MOST_BITS:
            return found
        bits *= 2


def _decide(a: Solid, b: Solid, bits: int, spacing: Fraction) -> PairVerdict:
    meeting, slack = meet(a, b), a.slack + b.slack
    if meeting is Relation.OVERLAP:
        proved = not slack or find_witness(a, b) is not None
        return PairVerdict(
            meeting if proved else None, None, False if proved else None, bits, slack
        )
    if not slack:
        gap = find_gap(a, b, spacing * spacing) if spacing else None
        return PairVerdict(meeting, gap, gap is not None, bits, slack)
    gap = find_gap(a, b, (spacing + slack) ** 2)
    if gap is None:
        return PairVerdict(Relation.APART, None, False, bits, slack)
    if gap.square <= slack * slack:
        return PairVerdict(None, None, None, bits, slack)
    is_closer = spacing > slack and gap.square < (spacing - slack) ** 2
    return PairVerdict(
        Relation.APART, gap, True if is_closer else None if spacing else False, bits, slack
    )


def find_witness(a: Solid, b: Solid) -> CommonPoint | None:
    """Find a point inside two solids, in truth, by (2); None if there is none that proves it.

    Args:
        a: a solid.
        b: another one, on the same lattice.

    Cost: O(p q) for the pieces of both.
    """
    ours, theirs = ([(bound_piece(piece), piece) for piece in solid.pieces] for solid in (a, b))
    for i, ((left, right, low, high), one) in enumerate(ours):
        for j, ((west, east, south, north), other) in enumerate(theirs):
            if left < east and west < right and low < north and south < high:
                point = find_common_point(one, other)
                if (
                    point is not None
                    and _is_deep(point, one, a.slack * a.scale)
                    and _is_deep(point, other, b.slack * b.scale)
                ):
                    return CommonPoint(a.leave(*point), (i, j))
    return None


def _is_deep(point: Point, piece: ConvexRing, slack: Fraction) -> bool:
    """Decide whether a point inside a piece is farther from its sides than the slack."""
    if not slack:
        return True
    sides = (measure_to_edge(point, side) for side in pairwise((*piece, piece[0])))
    return all(square > slack * slack * length for square, length in sides)
