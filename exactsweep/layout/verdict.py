"""The relation of two true solids, proved by increasingly precise rational rotations.

Let d be the sum of the slacks of two solids, and s their required distance.

(1) If the solids are more than d apart, the true solids are disjoint. If their distance is at least
    s + d, the true distance is at least s; if it is less than s - d, the true one is less than s.
(2) A point inside a solid, farther from its boundary than the slack, is inside the true solid.
(3) More precise rotations lower only their own part of the slack. If nearly all of it is due to
    flattened curves, only a finer flattening can decide.
"""

from collections.abc import Callable
from fractions import Fraction
from typing import NamedTuple

from exactsweep.geometry.distance import SquaredDistance
from exactsweep.geometry.overlap import Relation
from exactsweep.layout import clearance
from exactsweep.layout.deep import find_deep_point
from exactsweep.layout.nearest import find_gap
from exactsweep.layout.solid import Solid, meet, share_scale
from exactsweep.numbers.number import Point

MAX_BITS = 256  # the maximum precision of rational rotations
# Rotations are precise enough once the slack of curves is this many times theirs, by (3).
_SHARE = 1000
# Returns the pair of solids, with rotation errors of at most 2**-bits.
Refine = Callable[[int], tuple[Solid, Solid]]


class PairVerdict(NamedTuple):
    meeting: Relation | None  # None if undecided
    gap: SquaredDistance | None  # if less than required; rounded up by 2^-63 for rounded solids
    too_close: bool | None  # whether it is less than required; None if undecided
    bits: int  # the precision of the rotations
    slack: Fraction  # of both solids; 0 for exact rotations of polygons
    error: Fraction = Fraction(0)  # the part of the slack due to flattened curves


def judge_pair(refine: Refine, bits: int, spacing: Fraction) -> PairVerdict:
    """Judge two solids, doubling the precision of rotations until the verdict is proved."""
    while True:
        a, b = share_scale(*refine(bits))
        found = _decide(a, b, bits, spacing)
        turns = found.slack - found.error
        if found.too_close is not None or bits >= MAX_BITS or turns * _SHARE <= found.error:
            return found
        bits *= 2


def _decide(a: Solid, b: Solid, bits: int, spacing: Fraction) -> PairVerdict:
    if clearance.is_rounded(a, b):
        return _decide_rounded(a, b, bits, spacing)
    slack, gap = a.slack + b.slack, None
    meeting: Relation | None = meet(a, b)
    too_close: bool | None = False
    if meeting is Relation.OVERLAP:
        if slack and find_witness(a, b) is None:
            meeting = too_close = None
    elif not slack:
        gap = find_gap(a, b, spacing * spacing) if spacing else None
        too_close = gap is not None
    else:
        meeting, gap = Relation.APART, find_gap(a, b, (spacing + slack) ** 2)
        if gap is not None and gap.value <= slack * slack:
            meeting = too_close = gap = None
        elif gap is not None and spacing:
            is_closer = spacing > slack and gap.value < (spacing - slack) ** 2
            too_close = True if is_closer else None
    return PairVerdict(meeting, gap, too_close, bits, slack, a.error + b.error)


def _decide_rounded(a: Solid, b: Solid, bits: int, spacing: Fraction) -> PairVerdict:
    slack = a.slack + b.slack
    found = clearance.find_clearance(a, b, spacing + slack)
    meeting: Relation | None = Relation.APART
    gap: SquaredDistance | None = None
    too_close: bool | None = False
    if found is not None and found.is_below(-slack):
        meeting = Relation.OVERLAP
        if slack and clearance.find_rounded_witness(a, b) is None:
            meeting = too_close = None
    elif found is not None and slack and found.is_at_most(slack):
        meeting = too_close = None
    elif found is not None:
        if found.is_at_most(Fraction(0)):
            meeting = Relation.CONTACT
        if spacing > slack and found.is_below(spacing - slack):
            too_close, gap = True, clearance.measure_gap(a, b, found)
        elif found.is_below(spacing + slack):
            too_close = None if slack else spacing > 0
    return PairVerdict(meeting, gap, too_close, bits, slack, a.error + b.error)


def find_witness(a: Solid, b: Solid) -> Point | None:
    """Find a point inside both true solids by (2); None if not found. They share a lattice."""
    if clearance.is_rounded(a, b):
        return clearance.find_rounded_witness(a, b)
    return find_deep_point(a, b)
