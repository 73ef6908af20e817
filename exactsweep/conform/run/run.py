"""Runs: the outcomes of a program on cases, and their counts by class and flag."""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

from exactsweep import __version__
from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.outcome import Outcome
from exactsweep.conform.run.protocol import Hello
from exactsweep.corpus.case import KINDS
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.limits import get_limits, limits
from exactsweep.numbers.number import to_fraction
from exactsweep.words import count

ALL = "all"
ACCEPTED = Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS  # the default worst verdict that passes
_DIFFERENT = (Verdict.CONSERVATIVE, Verdict.UNSOUND, Verdict.WRONG)
SHOWN = 5  # failures kept in full for each fault
MAX_FAULTS = 40  # others are grouped by verdict


class Tally:
    """Counts of outcomes by group, which is "all", a class or a flag, and verdict.

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
        cause = self.find_cause()
        return cause and f"all {self.different} differing answers: {cause}"

    def total(self, verdict: Verdict | None = None, group: str = ALL) -> int:
        verdicts = Verdict if verdict is None else (verdict,)
        return sum(self.counts[group, one] for one in verdicts)

    @property
    def judged(self) -> int:
        return sum(self.total(verdict) for verdict in Verdict if verdict.is_judgement)

    def failures(self, accepted: Verdict) -> int:
        return sum(self.total(verdict) for verdict in Verdict if fails(verdict, accepted))

    def groups(self) -> list[str]:
        """List the groups that have cases: all, the classes, then the flags."""
        found = {group for group, _ in self.counts}
        first = [group for group in (ALL, *KINDS) if group in found]
        return first + sorted(found.difference(first))

    def verdicts(self) -> list[Verdict]:
        return [verdict for verdict in Verdict if self.total(verdict)]


def fails(verdict: Verdict, accepted: Verdict) -> bool:
    return verdict.is_judgement and verdict.severity > accepted.severity


def read_any_length(text: str) -> Fraction:
    """Read the output of `format_fraction`, of any length; the caller has checked the length.

    >>> read_any_length("1" + "0" * 200_000) == 10**200_000
    True
    """
    if len(text) <= get_limits().max_digits:
        return to_fraction(text)
    with limits(max_digits=len(text)):
        return to_fraction(text)


@dataclass
class NamedFault:
    verdict: Verdict
    name: str
    count: int = 0
    kept: list[Outcome] = field(default_factory=list)

    def add(self, outcomes: Iterable[Outcome], count: int = 1) -> None:
        self.kept = sorted([*self.kept, *outcomes], key=lambda outcome: outcome.size)[:SHOWN]
        self.count += count


class Run:
    """The outcomes of a program, their counts, and other errors."""

    def __init__(
        self,
        hello: Hello,
        command: Sequence[str] = (),  # empty for a function or a stream
        accepted: Verdict = ACCEPTED,  # the worst verdict that passes
        least_judged: Fraction = Fraction(0),  # the required fraction of judged cases
    ) -> None:
        self.hello, self.command, self.accepted = hello, tuple(command), accepted
        self.least_judged = least_judged
        # All outcomes, without the case, the answer and the parts to save memory.
        self.outcomes: list[Outcome] = []
        # By the id of a case, the outcome of a smaller case with the same fault.
        self.shrunk: dict[str, Outcome] = {}
        self.summary = Tally()
        self.complaints: list[str] = []  # errors other than failures, one line each
        self.interrupted = False
        self._faults: dict[str, NamedFault] = {}

    def add(self, outcome: Outcome) -> None:
        """Add an outcome."""
        self.summary.add(outcome)
        bare = replace(outcome, parts=(), case=None, result=None, stderr="")
        self.outcomes.append(bare if len(bare.diagnosis) > 1 else replace(bare, diagnosis=()))
        if fails(outcome.verdict, self.accepted):
            name = outcome.fault
            if name not in self._faults and len(self._faults) >= MAX_FAULTS:
                name = f"{outcome.verdict}: others"
            self._faults.setdefault(name, NamedFault(outcome.verdict, name)).add([outcome])

    def list_faults(self) -> list[NamedFault]:
        """List failures by fault, worst verdict first; a common diagnosis comes first in each."""
        cause = self.summary.find_cause()
        found: dict[str, NamedFault] = {}
        for fault in self._faults.values():
            kept = [outcome.lead_with(cause) for outcome in fault.kept]
            name = kept[0].fault if cause in kept[0].diagnosis else fault.name
            found.setdefault(name, NamedFault(fault.verdict, name)).add(kept, fault.count)
        return sorted(found.values(), key=lambda f: (-f.verdict.severity, -f.count))

    def list_outcomes(self) -> Iterator[Outcome]:
        """Yield all outcomes, complete with case and answer where these are stored."""
        cause = self.summary.find_cause()
        whole = {outcome.id: outcome for outcome in self.show()}
        return (whole.get(bare.id) or bare.lead_with(cause) for bare in self.outcomes)

    def show(self) -> Iterator[Outcome]:
        """Yield the failures stored in full, by fault, the smallest first."""
        for fault in self.list_faults():
            yield from fault.kept

    def list_shrinkable(self, number: int) -> list[Outcome]:
        """List the smallest failures of each fault, except timeouts and memory limits."""
        return [
            outcome
            for fault in self.list_faults()
            if fault.verdict not in (Verdict.TIMEOUT, Verdict.MEMORY)
            for outcome in fault.kept[:number]
        ]

    def add_shrunk(self, id: str, outcome: Outcome) -> None:
        """Add the outcome of a smaller case if it has the same fault."""
        (fault,) = (found.fault for found in self.show() if found.id == id)
        smaller = outcome.lead_with(self.summary.find_cause())
        if smaller.fault == fault:
            self.shrunk[id] = smaller

    def find_objections(self) -> list[str]:
        """List the errors of the run other than failures."""
        judged, total = self.summary.judged, self.summary.total()
        lines = [*self.complaints, *(["interrupted"] if self.interrupted else [])]
        if not judged:
            lines.append("no case was judged")
        elif judged < self.least_judged * total:
            lines.append(f"only {judged} of {count(total, 'case')} judged, fewer than required")
        return lines

    @property
    def passed(self) -> bool:
        """Whether enough cases were judged, none failed and there are no objections."""
        return not self.summary.failures(self.accepted) and not self.find_objections()

    def to_json(self) -> dict[str, Any]:
        """Return plain data with coordinates as strings."""
        summary = self.summary
        return {
            "format": "exactsweep conform report",
            "version": 2,
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
            "outcomes": [outcome.to_json() for outcome in self.list_outcomes()],
            "shrunk": {id: outcome.to_json() for id, outcome in self.shrunk.items()},
        }
