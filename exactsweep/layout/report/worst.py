"""The faults of a judgement in the order in which people want them: the worst first."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import NamedTuple, get_args

from exactsweep.layout.fault import Fault, FaultKind
from exactsweep.layout.judge import Judgement

MOST_MEASURED = 200
"""Of so many faults it is found how bad they are; of a layout with more, nobody reads on."""


class WorstFirst(NamedTuple):
    """A fault, and how bad it is.

    Attributes:
        fault: the Fault.
        square: the squared length of the shortest move that repairs it, or by which it is too
            close; None where there is none, or it was not measured.
    """

    fault: Fault
    square: Fraction | None


def rank_faults(
    judgement: Judgement, tell: Callable[[int, int], object] = lambda done, total: None
) -> list[WorstFirst]:
    """Sort the faults of a judgement by kind, and within a kind the worst first.

    Args:
        judgement: a Judgement.
        tell: is called with the number of faults measured, and of all that will be.

    Returns:
        list of WorstFirst. Overlaps, and parts outside, are measured by the shortest move that
        repairs them, parts too close by their distance; only the first MOST_MEASURED are.

    Cost: that of `Fault.move` for each fault that is measured.
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
    # A part that fits nowhere is worse than any that does.
    fits_nowhere = one.square is None and one.fault.kind == "outside"
    return not fits_nowhere, -(one.square or Fraction(0))
