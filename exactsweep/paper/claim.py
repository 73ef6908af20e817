"""Claims of the paper, and the evidence for and against them.

A check looks for counterexamples to the printed statement and to the corrected one. A row fails if
the corrected statement has a counterexample, or if the printed one has none despite its verdict.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from enum import Enum
from time import process_time
from typing import Any, NamedTuple

from exactsweep.corpus.generator.prng import Prng
from exactsweep.paper.growth import LIMITS, Growth, double

Corners = Sequence[tuple[int, int]]


class ClaimVerdict(Enum):
    REPRODUCED = "reproduced"
    CONDITION = "reproduced with a condition"
    SHARPENED = "sharpened"
    REFUTED = "refuted as stated"
    BY_THEOREM = "refuted by theorem"
    MISPRINT = "misprint"
    ADDED = "added"

    @property
    def contradicts_paper(self) -> bool:
        return self not in (ClaimVerdict.REPRODUCED, ClaimVerdict.SHARPENED, ClaimVerdict.ADDED)


class Counterexample(NamedTuple):
    """A case in which a statement fails, and how it was found; G and D may be empty."""

    text: str
    how: str
    generatrix: Corners = ()
    directrix: Corners = ()


class Table(NamedTuple):
    caption: str
    header: Sequence[str]
    rows: Sequence[Sequence[str]]


@dataclass(frozen=True)
class Evidence:
    """The findings of a check.

    `tried` describes the tested cases, and `failure` a counterexample to the corrected statement;
    `cases` are counterexamples to the printed one. `sampled` is the minimum number of random pairs
    per law, `searched` the number of cases in exhaustive searches.
    """

    tried: str = ""
    failure: str = ""
    cases: tuple[Counterexample, ...] = ()
    tables: tuple[Table, ...] = ()
    growth: tuple[Growth, ...] = ()
    sampled: int = 0
    searched: int = 0


Observation = str | Counterexample | Table | Growth | Evidence
"""A result of a check. A string describes a failure unless it is empty."""


@dataclass(frozen=True)
class Effort:
    seed: int = 1
    quick: bool = False

    def random(self, label: str) -> Prng:
        return Prng(f"{self.seed} {label}")

    def cases(self, count: int) -> int:
        """Return the number of cases to try: three times `count`, in a quick run a tenth of it."""
        return max(1, count // 10) if self.quick else 3 * count

    def sizes(self, first: int = 16, quick: int = 2, full: int = 4) -> list[tuple[int, int]]:
        """Return the sizes (m, n): the first one and its doublings."""
        return double(first, quick if self.quick else full)


@dataclass(frozen=True)
class Claim:
    """A row of the ledger; the top of ledger.toml describes the fields."""

    name: str
    section: str
    words: str
    verdict: ClaimVerdict
    evidence: tuple[str, ...]
    code: tuple[str, ...]
    check: Callable[[Effort], Iterable[Observation]] = field(repr=False)
    correction: str = ""
    proof: str = ""
    weight: int = 0
    kernel: str = ""
    see: tuple[str, ...] = ()
    figure: str = ""
    chosen: str = ""


class Finding(NamedTuple):
    """A claim with the evidence and the CPU time of its check."""

    claim: Claim
    evidence: Evidence
    seconds: float

    @property
    def disagreement(self) -> str:
        """The conflict between evidence and verdict, or an empty string."""
        evidence, is_refuted = self.evidence, self.claim.verdict.contradicts_paper
        if evidence.failure:
            return evidence.failure
        if is_refuted and not evidence.cases:
            return "no counterexample to the printed statement was found"
        if not is_refuted and evidence.cases:
            return f"the printed statement fails: {evidence.cases[0].text}"
        announced = {kind for kind in self.claim.evidence if kind not in ("case", "cited")}
        if differing := sorted(announced ^ self._kinds):
            return f"the kinds of evidence announced and found differ in {differing}"
        return ""

    @property
    def _kinds(self) -> set[str]:
        found = self.evidence
        units = {series.unit in LIMITS for series in found.growth}
        present = {
            "proved": bool(self.claim.proof),
            "exhaustive": found.searched > 0,
            "sampled": found.sampled > 0,
            "counted": False in units,
            "measured": True in units,
        }
        return {kind for kind, is_present in present.items() if is_present}


def find_first_failure(failures: Iterable[str]) -> str:
    return next(filter(None, failures), "")


def gather(parts: Iterable[Observation]) -> Evidence:
    found = [
        part if isinstance(part, Evidence) else _TO_EVIDENCE[type(part)](part) for part in parts
    ]
    cases, tables, growth = (
        tuple(one for part in found for one in getattr(part, name))
        for name in ("cases", "tables", "growth")
    )
    return Evidence(
        " ".join(filter(None, (part.tried for part in found))),
        find_first_failure(part.failure for part in found),
        *(cases, tables, growth),
        max((part.sampled for part in found), default=0),
        sum(part.searched for part in found),
    )


_TO_EVIDENCE: dict[type, Callable[[Any], Evidence]] = {
    str: lambda text: Evidence(failure=text),
    Counterexample: lambda case: Evidence(cases=(case,)),
    Table: lambda table: Evidence(tables=(table,)),
    Growth: lambda series: Evidence(failure=series.failure, growth=(series,)),
}


def reproduce(claims: Iterable[Claim], effort: Effort) -> Iterator[Finding]:
    """Check claims one by one; an exception counts as a failure.

    >>> from exactsweep.paper.ledger import find
    >>> row, = reproduce([find("Slope")], Effort(quick=True))
    >>> row.claim.verdict.value, row.disagreement
    ('misprint', '')
    """
    for claim in claims:
        start = process_time()
        try:
            evidence = gather(claim.check(effort))
        except Exception as error:
            evidence = Evidence("Stopped by an exception.", f"{type(error).__name__}: {error}")
        yield Finding(claim, evidence, process_time() - start)
