"""Ranking of faults, and the context of a report."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import NamedTuple, get_args

from exactsweep.layout.fault import Fault, FaultKind
from exactsweep.layout.judge import Judgement
from exactsweep.numbers.number import ORIGIN
from exactsweep.text.report import take_root
from exactsweep.words import spell_out

MAX_MEASURED = 200  # faults, unless all of these are tiny
# Faults this many times smaller than the layout look like rounding.
_ROUNDING = 10**6
_MEASURED = "overlap", "outside", "too close"


class WorstFirst(NamedTuple):
    fault: Fault
    square: Fraction | None  # the squared depth, or the squared distance of parts too close
    accepted: bool = False  # whether it is within the accepted depth

    @property
    def depth(self) -> Fraction:
        """A bound on the depth of a fault, or on the missing distance."""
        fault = self.fault
        if fault.distance_squared is not None and fault.required is not None:
            missing = fault.required**2 - fault.distance_squared
            return missing / (fault.required + take_root(fault.distance_squared)) + fault.bound
        root = fault.box_depth if self.square is None else take_root(self.square)
        return root + fault.bound

    def is_rounding(self, judgement: Judgement) -> bool:
        """Return whether the fault is known to be tiny compared with the layout."""
        low, high = judgement.box or (ORIGIN, ORIGIN)
        size = max(high.x - low.x, high.y - low.y)
        is_known = self.square is not None or len(self.fault.placements) > 1
        return is_known and self.fault.kind in _MEASURED and self.depth * _ROUNDING < size


class ReportContext(NamedTuple):
    unchecked: Sequence[str] = ()  # rules and shapes that were not judged
    places: Sequence[str] = ()  # the location of each placement in the file
    unit: str = ""  # of length, such as "mm"
    accepted: Fraction | None = None  # faults up to this depth are accepted

    def name_placement(self, judgement: Judgement, k: int) -> str:
        part = judgement.layout.placements[k].part
        place = self.places[k] if k < len(self.places) else ""
        name = str(k) if part == str(k) else f"{k} {part}".strip()
        return spell_out(f"{name} ({place})" if place else name)

    def name_placements(self, judgement: Judgement, fault: Fault) -> str:
        if fault.part is not None and len(fault.placements) != 1:
            return spell_out(f"part {fault.part}")
        return " and ".join(self.name_placement(judgement, k) for k in fault.placements)

    def add_unit(self, length: str) -> str:
        return f"{length} {self.unit}" if self.unit else length


NO_CONTEXT = ReportContext()  # the context of a layout without a file


def rank_faults(
    judgement: Judgement,
    report: Callable[[int, int], object] = lambda done, total: None,
    accepted: Fraction | None = None,
) -> list[WorstFirst]:
    """Sort the faults of a judgement: accepted ones last, then by kind, the worst first.

    At most MAX_MEASURED faults are measured, beginning with the greatest overlaps of boxes; more
    if all of these are tiny, and all if some depth is accepted. `report` takes the number of
    measured faults and the total.
    """
    order, faults = get_args(FaultKind), judgement.faults
    total = len(faults)
    if accepted is None and total > MAX_MEASURED:
        total = MAX_MEASURED
        faults = tuple(sorted(faults, key=lambda f: (order.index(f.kind), -f.box_depth)))
    found, is_tiny = list[WorstFirst](), False
    for k, fault in enumerate(faults):
        if k == total:
            is_tiny = all(one.is_rounding(judgement) for one in found)
        square, is_accepted = fault.distance_squared, False
        if k < total or (is_tiny and not WorstFirst(fault, square).is_rounding(judgement)):
            report(k, total if k < total else len(faults))
            square = fault.depth_squared if square is None else square
            is_accepted = accepted is not None and fault.is_within(accepted)
        found.append(WorstFirst(fault, square, is_accepted))
    return sorted(found, key=lambda one: (one.accepted, order.index(one.fault.kind), *_rank(one)))


def _rank(one: WorstFirst) -> tuple[bool, Fraction]:
    if one.fault.distance_squared is not None:
        return False, one.fault.distance_squared
    # A part that fits nowhere is worst.
    fits_nowhere = one.square is None and one.fault.kind == "outside"
    return not fits_nowhere, -(one.square or Fraction(0))
