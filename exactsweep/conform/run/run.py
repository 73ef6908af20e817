"""A run: everything that came of holding an implementation against cases."""

from __future__ import annotations

from bisect import insort
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, NamedTuple

from exactsweep import __version__
from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.outcome import Outcome, read_exact
from exactsweep.conform.run.protocol import Hello
from exactsweep.conform.run.spool import Spool
from exactsweep.corpus.case import KINDS
from exactsweep.geometry.number import format_fraction
from exactsweep.words import count

SHOWN = 5
"""How many failures of each fault are kept with all that belongs to them, the smallest."""
MOST_FAULTS = 40
"""More faults than that are not told apart; the rest of them are, by verdict."""
_MOST_DIAGNOSES = 1000


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


_DIFFERENT = (Verdict.CONSERVATIVE, Verdict.UNSOUND, Verdict.WRONG)


class Tally:
    """Counts of verdicts, and what goes with them.

    Args:
        outcomes: the outcomes to begin with.

    Attributes:
        counts: Counter of (group, verdict); a group is "all", a class or a flag.
        worst: dict from the name of a loop to its Worst, where there was anything to measure.
        seconds: that all answers took together.
        slowest: the longest time of one answer, and the id of its case.
        largest: the most bytes that the program held for one answer, likewise; 0 if unknown.
        granted: the greatest rounding with which a loop is within, and the id of its case.
        different: how many trajectories are conservative, unsound or wrong.
        diagnoses: Counter of what these are exact for.

    Example:
        >>> summary = Tally([Outcome("a", "CC", ("parallel-edges",), Verdict.EXACT)])
        >>> summary.groups(), summary.verdicts(), summary.counts["CC", Verdict.EXACT]
        (['all', 'CC', 'parallel-edges'], [<Verdict.EXACT: 'exact'>], 1)
    """

    def __init__(self, outcomes: Iterable[Outcome] = ()) -> None:
        self.counts: Counter[tuple[str, Verdict]] = Counter()
        self.worst: dict[str, Worst] = {}
        self.seconds = 0.0
        self.slowest = (0.0, "")
        self.largest = (0, "")
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
        self.slowest = max(self.slowest, (outcome.seconds, outcome.id))
        self.largest = max(self.largest, (outcome.memory or 0, outcome.id))
        for part in outcome.parts:
            if part["name"] == "trajectory" and Verdict(part["verdict"]) in _DIFFERENT:
                self.different += 1
                for words in part["diagnosis"]:
                    # Of a reference point that moves, each case has an offset of its own.
                    if words in self.diagnoses or len(self.diagnoses) < _MOST_DIAGNOSES:
                        self.diagnoses[words] += 1
            if part["granted"] and Verdict(part["verdict"]) is Verdict.WITHIN:
                self.granted = max(self.granted, (read_exact(part["granted"]), outcome.id))
            if part["distance_squared"] is not None and part["area"] is not None:
                distance = read_exact(part["distance_squared"][0]), outcome.id
                area = read_exact(part["area"]), outcome.id
                old = self.worst.get(part["name"], Worst(distance, area))
                self.worst[part["name"]] = Worst(max(old[0], distance), max(old[1], area))

    def diagnosis(self) -> str | None:
        """Say what all trajectories that differ are exact for, or None."""
        for words, number in self.diagnoses.most_common(1):
            if number == self.different > 1:
                return f"all {number} trajectories that differ: {words}"
        return None

    def total(self, verdict: Verdict | None = None, group: str = ALL) -> int:
        """Return how many cases there are, in a group, with a verdict or with any."""
        verdicts = Verdict if verdict is None else (verdict,)
        return sum(self.counts[group, one] for one in verdicts)

    @property
    def judged(self) -> int:
        """How many cases the implementation could do and we could judge."""
        return self.total() - self.total(Verdict.UNSUPPORTED) - self.total(Verdict.UNDECIDED)

    def failures(self, accepted: Verdict) -> int:
        """Return how many verdicts are worse than an accepted one, as `fails` has it."""
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
    """Whether a verdict is worse than an accepted one; what was not judged is no failure.

    >>> fails(Verdict.WITHIN, Verdict.EQUIVALENT), fails(Verdict.UNSUPPORTED, Verdict.EXACT)
    (True, False)
    """
    judged = verdict not in (Verdict.UNSUPPORTED, Verdict.UNDECIDED)
    return judged and verdict.severity > accepted.severity


class Fault:
    """Failures that show the same fault.

    Args:
        verdict: of all of them.
        name: what `name_fault` says of them.

    Attributes:
        count: how many there are.
    """

    def __init__(self, verdict: Verdict, name: str) -> None:
        self.verdict, self.name, self.count = verdict, name, 0
        self._kept: list[tuple[int, int, Outcome]] = []

    def add(self, outcome: Outcome) -> None:
        """Count an outcome, and keep it if it is among the smallest."""
        insort(self._kept, (_measure(outcome), self.count, outcome))
        del self._kept[SHOWN:]
        self.count += 1

    @property
    def kept(self) -> list[Outcome]:
        """The smallest ones, whole, the smallest first."""
        return [outcome for _, _, outcome in self._kept]


class Run:
    """Outcomes as they come in; memory is bounded but for a few bytes a case.

    Args:
        hello: what the implementation says of itself.
        command: what was run; empty for a function or a stream.
        accepted: the worst verdict that is no failure.
        least_judged: the least part of the cases that must be judged for the run to pass.

    Attributes:
        outcomes: sequence of all outcomes, without the case, the answer and what was measured.
        shrunk: dict from the id of a case to the outcome of a smaller one with the same fault.
        summary: the counts.
        complaints: list of what is wrong besides, a line each.
        interrupted: whether the run was stopped before its end.
    """

    def __init__(
        self,
        hello: Hello,
        command: Sequence[str] = (),
        accepted: Verdict = ACCEPTED,
        least_judged: Fraction = Fraction(0),
    ) -> None:
        self.hello, self.command, self.accepted = hello, tuple(command), accepted
        self.least_judged = least_judged
        self.outcomes = Spool()
        self.shrunk: dict[str, Outcome] = {}
        self.summary = Tally()
        self.complaints: list[str] = []
        self.interrupted = False
        self._faults: dict[str, Fault] = {}

    def add(self, outcome: Outcome) -> None:
        """Take in an outcome."""
        self.summary.add(outcome)
        self.outcomes.add(replace(outcome, parts=(), case=None, result=None, stderr=""))
        if fails(outcome.verdict, self.accepted):
            name = outcome.fault
            if name not in self._faults and len(self._faults) >= MOST_FAULTS:
                name = f"{outcome.verdict}: others"
            self._faults.setdefault(name, Fault(outcome.verdict, name)).add(outcome)

    def list_faults(self) -> list[Fault]:
        """Return the failures, those with the same fault together, the worst verdict first."""
        return sorted(self._faults.values(), key=lambda f: (-f.verdict.severity, -f.count))

    def show(self) -> Iterator[Outcome]:
        """Yield the failures that are kept whole, fault by fault, the smallest first."""
        for fault in self.list_faults():
            yield from fault.kept

    def to_be_smaller(self, number: int) -> list[Outcome]:
        """Return some failures of each fault, the smallest; none that may take long to fail."""
        return [
            outcome
            for fault in self.list_faults()
            if fault.verdict not in (Verdict.TIMEOUT, Verdict.MEMORY)
            for outcome in fault.kept[:number]
        ]

    def add_smaller(self, id: str, outcome: Outcome) -> None:
        """Take in the outcome of a smaller case than that of this id.

        It is dropped if it shows another fault after all, as an implementation that does not
        always answer the same may bring about.
        """
        (fault,) = (found.fault for found in self.show() if found.id == id)
        if outcome.fault == fault:
            self.shrunk[id] = outcome

    def find_objections(self) -> list[str]:
        """Return what is wrong with the run besides failures, a line each."""
        judged, total = self.summary.judged, self.summary.total()
        lines = [*self.complaints, *(["interrupted"] if self.interrupted else [])]
        if undecided := self.summary.total(Verdict.UNDECIDED):
            lines.append(f"{count(undecided, 'answer')} could not be compared in time")
        if not judged:
            lines.append("nothing was judged")
        elif judged < self.least_judged * total:
            lines.append(f"only {judged} of {count(total, 'case')} judged, too few")
        return lines

    @property
    def passed(self) -> bool:
        """Whether enough was judged, nothing failed, and nothing else was wrong."""
        return not self.summary.failures(self.accepted) and not self.find_objections()

    def to_json(self) -> dict[str, Any]:
        """Return everything as plain data, numbers of the geometry as strings."""
        summary = self.summary
        whole = {outcome.id: outcome for outcome in self.show()}
        return {
            "format": "exactsweep conform report",
            "version": 1,
            "exactsweep": __version__,
            **self.hello.to_json(),
            "command": list(self.command),
            "accepted": self.accepted.value,
            "least_judged": format_fraction(self.least_judged),
            "passed": self.passed,
            "cases": summary.total(),
            "judged": summary.judged,
            "interrupted": self.interrupted,
            "complaints": self.complaints,
            "objections": self.find_objections(),
            "seconds": round(summary.seconds, 3),
            "slowest": list(summary.slowest),
            "largest": list(summary.largest),
            "counts": {
                group: {
                    verdict.value: summary.counts[group, verdict]
                    for verdict in summary.verdicts()
                    if summary.counts[group, verdict]
                }
                for group in summary.groups()
            },
            "diagnosis": summary.diagnosis(),
            "granted": [format_fraction(summary.granted[0]), summary.granted[1]],
            "faults": [
                {"fault": fault.name, "count": fault.count, "smallest": fault.kept[0].id}
                for fault in self.list_faults()
            ],
            "worst": {name: _worst(worst) for name, worst in summary.worst.items()},
            "outcomes": [whole.get(bare.id, bare).to_json() for bare in self.outcomes],
            "shrunk": {id: outcome.to_json() for id, outcome in self.shrunk.items()},
        }


def _measure(outcome: Outcome) -> int:
    case = outcome.case
    return len(case["directrix"]) + len(case["generatrix"]) if case else 0


def _worst(worst: Worst) -> dict[str, Any]:
    return {name: [format_fraction(value), id] for name, (value, id) in worst._asdict().items()}
