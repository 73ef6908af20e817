"""Counts of outcomes by class and flag."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from fractions import Fraction

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.outcome import Outcome
from exactsweep.corpus.case import KINDS
from exactsweep.numbers.limits import get_limits, limits
from exactsweep.numbers.number import to_fraction

ALL = "all"

ACCEPTED = Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS
"""The default worst verdict that passes."""


_DIFFERENT = (Verdict.CONSERVATIVE, Verdict.UNSOUND, Verdict.WRONG)


class Tally:
    """Counts of outcomes.

    Attributes:
        counts: Counter of (group, verdict); groups are "all", classes and flags.
        seconds: the total time of all answers.
        granted: the greatest rounding of a loop that is within, and the id of its case.
        different: the number of conservative, unsound and wrong trajectories.
        diagnoses: Counter of their diagnoses.

    Example:
        >>> summary = Tally([Outcome("a", "CC", ("parallel-edges",), Verdict.EXACT)])
        >>> summary.groups(), summary.verdicts(), summary.counts["CC", Verdict.EXACT]
        (['all', 'CC', 'parallel-edges'], [<Verdict.EXACT: 'exact'>], 1)
    """

    def __init__(self, outcomes: Iterable[Outcome] = ()) -> None:
        self.counts: Counter[tuple[str, Verdict]] = Counter()
        self.seconds = 0.0
        self.granted = (Fraction(0), "")
        self.different = 0
        self.diagnoses: Counter[str] = Counter()
        for outcome in outcomes:
            self.add(outcome)

    def add(self, outcome: Outcome) -> None:
        """Count an outcome."""
        for group in (ALL, outcome.kind, *outcome.flags):
            self.counts[group, outcome.verdict] += 1
        self.seconds += outcome.seconds
        for part in outcome.parts:
            if part["name"] in ("trajectory", "no_fit") and Verdict(part["verdict"]) in _DIFFERENT:
                self.different += 1
                self.diagnoses.update(part["diagnosis"])
            if part["granted"] and Verdict(part["verdict"]) is Verdict.WITHIN:
                self.granted = max(self.granted, (read_any_length(part["granted"]), outcome.id))

    def find_cause(self) -> str | None:
        """Find a diagnosis that explains all differing answers."""
        for words, number in self.diagnoses.most_common(1):
            if number == self.different > 1:
                return words
        return None

    def diagnosis(self) -> str | None:
        """Describe the diagnosis that explains all differing answers, if there is one."""
        cause = self.find_cause()
        return cause and f"all {self.different} answers that differ: {cause}"

    def total(self, verdict: Verdict | None = None, group: str = ALL) -> int:
        """Count the cases of a group with one verdict or all verdicts."""
        verdicts = Verdict if verdict is None else (verdict,)
        return sum(self.counts[group, one] for one in verdicts)

    @property
    def judged(self) -> int:
        """The number of judged cases."""
        return sum(self.total(verdict) for verdict in Verdict if verdict.is_judgement)

    def failures(self, accepted: Verdict) -> int:
        """Count the verdicts that `fails` rejects."""
        return sum(self.total(verdict) for verdict in Verdict if fails(verdict, accepted))

    def groups(self) -> list[str]:
        """List the groups that have cases: all, the classes, then the flags."""
        found = {group for group, _ in self.counts}
        first = [group for group in (ALL, *KINDS) if group in found]
        return first + sorted(found.difference(first))

    def verdicts(self) -> list[Verdict]:
        """List the verdicts that occur, from best to worst."""
        return [verdict for verdict in Verdict if self.total(verdict)]


def fails(verdict: Verdict, accepted: Verdict) -> bool:
    """Decide whether a judged case has a worse verdict than the accepted one.

    >>> fails(Verdict.WITHIN, Verdict.EQUIVALENT), fails(Verdict.UNSUPPORTED, Verdict.EXACT)
    (True, False)
    """
    return verdict.is_judgement and verdict.severity > accepted.severity


def read_any_length(text: str) -> Fraction:
    """Read the output of `format_fraction`, of any length; the caller has checked the length.

    Example:
        >>> read_any_length("1" + "0" * 200_000) == 10**200_000
        True
    """
    if len(text) <= get_limits().max_digits:
        return to_fraction(text)
    with limits(max_digits=len(text)):
        return to_fraction(text)
