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
from exactsweep.corpus.case import KINDS
from exactsweep.geometry.number import format_fraction

SHOWN = 20
"""How many failures of each verdict are kept with all that belongs to them, the smallest."""


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
        for part in outcome.parts:
            if part["name"] == "trajectory" and Verdict(part["verdict"]) in _DIFFERENT:
                self.different += 1
                self.diagnoses.update(part["diagnosis"])
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


class Run:
    """Outcomes as they come in; memory is bounded but for a line a case.

    Args:
        hello: what the implementation says of itself.
        command: what was run; empty for a function or a stream.
        accepted: the worst verdict that is no failure.

    Attributes:
        outcomes: list of all outcomes; of failures that are not `shown`, without the case, the
            answer and what was measured.
        shrunk: dict from the id of a case to the outcome of a smaller one that fails likewise.
        summary: the counts.
        complaints: list of what is wrong besides, a line each.
        interrupted: whether the run was stopped before its end.
    """

    def __init__(
        self, hello: Hello, command: Sequence[str] = (), accepted: Verdict = ACCEPTED
    ) -> None:
        self.hello, self.command, self.accepted = hello, tuple(command), accepted
        self.outcomes: list[Outcome] = []
        self.shrunk: dict[str, Outcome] = {}
        self.summary = Tally()
        self.complaints: list[str] = []
        self.interrupted = False
        self._shown: dict[Verdict, list[tuple[int, int]]] = {}

    def add(self, outcome: Outcome) -> None:
        """Take in an outcome."""
        place = len(self.outcomes)
        self.outcomes.append(outcome)
        self.summary.add(outcome)
        if not fails(outcome.verdict, self.accepted):
            self._strip(place)
            return
        shown = self._shown.setdefault(outcome.verdict, [])
        insort(shown, (_size(outcome), place))
        if len(shown) > SHOWN:
            self._strip(shown.pop()[1])

    def shown(self) -> Iterator[Outcome]:
        """Yield the failures that are kept whole, verdict by verdict, the smallest first."""
        for verdict in Verdict:
            for _, place in self._shown.get(verdict, ()):
                yield self.outcomes[place]

    def to_be_smaller(self, number: int) -> list[Outcome]:
        """Return some failures of each verdict, the smallest; no timeouts, which take long."""
        return [
            self.outcomes[place]
            for verdict, shown in self._shown.items()
            if verdict is not Verdict.TIMEOUT
            for _, place in shown[:number]
        ]

    def add_smaller(self, id: str, outcome: Outcome) -> None:
        """Take in the outcome of a smaller case than that of this id.

        It is dropped if the verdict is another one after all, as an implementation that does not
        always answer the same may bring about.
        """
        (verdict,) = (found.verdict for found in self.shown() if found.id == id)
        if outcome.verdict is verdict:
            self.shrunk[id] = outcome

    @property
    def passed(self) -> bool:
        """Whether something was judged, nothing failed, and nothing else was wrong."""
        judged = self.summary.total() - self.summary.total(Verdict.UNSUPPORTED)
        failed = self.summary.failures(self.accepted)
        return judged > 0 and failed == 0 and not self.complaints and not self.interrupted

    def to_json(self) -> dict[str, Any]:
        """Return everything as plain data, numbers of the geometry as strings."""
        summary = self.summary
        return {
            "format": "exactsweep conform report",
            "version": 1,
            "exactsweep": __version__,
            **self.hello.to_json(),
            "command": list(self.command),
            "accepted": self.accepted.value,
            "passed": self.passed,
            "interrupted": self.interrupted,
            "complaints": self.complaints,
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
            "worst": {name: _worst(worst) for name, worst in summary.worst.items()},
            "outcomes": [outcome.to_json() for outcome in self.outcomes],
            "shrunk": {id: outcome.to_json() for id, outcome in self.shrunk.items()},
        }

    def _strip(self, place: int) -> None:
        bare = replace(self.outcomes[place], parts=(), case=None, result=None, stderr="")
        self.outcomes[place] = bare


def _size(outcome: Outcome) -> int:
    case = outcome.case
    return len(case["directrix"]) + len(case["generatrix"]) if case else 0


def _worst(worst: Worst) -> dict[str, Any]:
    return {name: [format_fraction(value), id] for name, (value, id) in worst._asdict().items()}
