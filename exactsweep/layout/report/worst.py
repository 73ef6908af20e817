"""The faults of a judgement, the worst first."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import NamedTuple, get_args

from exactsweep.layout.fault import Fault, FaultKind
from exactsweep.layout.judge import Judgement

MOST_MEASURED = 200
"""The number of faults that are measured; nobody reads a longer list."""


class WorstFirst(NamedTuple):
    """A fault and its measure.

    Attributes:
        fault: the Fault.
        square: the squared length of the shortest move that repairs the fault, or the squared
            distance of parts too close; None if there is no measure, or it was not computed.
    """

    fault: Fault
    square: Fraction | None


def rank_faults(
    judgement: Judgement, tell: Callable[[int, int], object] = lambda done, total: None
) -> list[WorstFirst]:
    """Sort the faults of a judgement by kind, and within a kind the worst first.

    Args:
        judgement: a Judgement.
        tell: a function that is called with the number of measured faults and their final number.

    Returns:
        list of WorstFirst. The shortest move that repairs it measures an overlap or a part outside,
        the distance measures parts too close. Only the first MOST_MEASURED faults are measured.

    Cost: that of `Fault.move` for each measured fault.
    """
    found = []
    total = min(len(judgement.faults), MOST_MEASURED)
    for k, fault in enumerate(judgement.faults):
        square = None
        if k < MOST_MEASURED:
            tell(k, total)
            square = fault.depth_squared
        found.append(WorstFirst(fault, square))
    order = get_args(FaultKind)
    return sorted(found, key=lambda one: (order.index(one.fault.kind), *_rank(one)))


def _rank(one: WorstFirst) -> tuple[bool, Fraction]:
    """Rank a fault among those of its kind."""
    if one.fault.distance_squared is not None:
        return False, one.fault.distance_squared
    # A part that fits nowhere is worse than a part that fits.
    fits_nowhere = one.square is None and one.fault.kind == "outside"
    return not fits_nowhere, -(one.square or Fraction(0))
