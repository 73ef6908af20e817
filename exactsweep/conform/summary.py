"""What a run comes to: verdicts counted by class and flag, and the greatest errors."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from fractions import Fraction
from typing import NamedTuple

from exactsweep.conform.outcome import Outcome
from exactsweep.conform.verdict import Verdict
from exactsweep.corpus.case import KINDS
from exactsweep.number import to_fraction

ALL = "all"
ACCEPTED = Verdict.EQUIVALENT_BUT_FOR_EXACT_FITS
"""The worst verdict that passes, unless the caller says otherwise."""


class Worst(NamedTuple):
    """The outcomes in which one kind of loop is furthest off.

    Attributes:
        distance_squared: the greatest squared Hausdorff distance, from below, and its case's id.
        area: the greatest area of the symmetric difference, and its case's id.
    """

    distance_squared: tuple[Fraction, str]
    area: tuple[Fraction, str]


class Summary:
    """Counts of verdicts, and what goes with them.

    Args:
        outcomes: the outcomes to begin with.

    Attributes:
        counts: Counter of (group, verdict); a group is "all", a class or a flag.
        worst: dict from the name of a loop to its Worst, where there was anything to measure.
        seconds: that all answers took together.
        slowest: the longest time of one answer, and the id of its case.

    Example:
        >>> summary = Summary([Outcome("a", "CC", ("parallel-edges",), Verdict.EXACT)])
        >>> summary.groups(), summary.verdicts(), summary.counts["CC", Verdict.EXACT]
        (['all', 'CC', 'parallel-edges'], [<Verdict.EXACT: 'exact'>], 1)
    """

    def __init__(self, outcomes: Iterable[Outcome] = ()) -> None:
        self.counts: Counter[tuple[str, Verdict]] = Counter()
        self.worst: dict[str, Worst] = {}
        self.seconds = 0.0
        self.slowest = (0.0, "")
        for outcome in outcomes:
            self.add(outcome)

    def add(self, outcome: Outcome) -> None:
        """Count an outcome."""
        for group in (ALL, outcome.kind, *outcome.flags):
            self.counts[group, outcome.verdict] += 1
        self.seconds += outcome.seconds
        self.slowest = max(self.slowest, (outcome.seconds, outcome.id))
        for part in outcome.parts:
            if part["distance_squared"] is not None and part["area"] is not None:
                distance = to_fraction(part["distance_squared"][0]), outcome.id
                area = to_fraction(part["area"]), outcome.id
                old = self.worst.get(part["name"], Worst(distance, area))
                self.worst[part["name"]] = Worst(max(old[0], distance), max(old[1], area))

    def total(self, verdict: Verdict | None = None, group: str = ALL) -> int:
        """Return how many cases there are, in a group, with a verdict or with any."""
        verdicts = Verdict if verdict is None else (verdict,)
        return sum(self.counts[group, one] for one in verdicts)

    def failures(self, accepted: Verdict) -> int:
        """Return how many verdicts are worse than an accepted one; unsupported is no failure."""
        return sum(self.total(verdict) for verdict in Verdict if fails(verdict, accepted))

    def groups(self) -> list[str]:
        """Return the groups that have cases: all, the classes, the flags by name."""
        found = {group for group, _ in self.counts}
        first = [group for group in (ALL, *KINDS) if group in found]
        return first + sorted(found.difference(first))

    def verdicts(self) -> list[Verdict]:
        """Return the verdicts that were given, from best to worst."""
        return [verdict for verdict in Verdict if self.total(verdict)]


def fails(verdict: Verdict, accepted: Verdict) -> bool:
    """Whether a verdict is worse than an accepted one; unsupported is no failure.

    >>> fails(Verdict.WITHIN, Verdict.EQUIVALENT), fails(Verdict.UNSUPPORTED, Verdict.EXACT)
    (True, False)
    """
    return verdict is not Verdict.UNSUPPORTED and verdict.severity > accepted.severity
