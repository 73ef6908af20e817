"""Results of the comparison, as they are kept and shown."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from typing import Any

from benchmarks.clock import Times
from benchmarks.peers.cases import Case


@dataclass
class Result:
    """One program on one case: how long, how, and how much of the answer is right.

    `wrong` counts the exact loops' vertices that the program's answer lacks, out of `vertices`;
    `note` stands in for everything else when there is no answer.
    """

    program: str
    operation: str
    case: Case
    times: Times | None = None
    vertices: int = 0
    wrong: int = 0
    note: str = ""


@dataclass
class Comparison:
    """All that one run measured."""

    machine: str
    versions: dict[str, str] = field(default_factory=dict)
    skipped: dict[str, str] = field(default_factory=dict)
    results: list[Result] = field(default_factory=list)
    pairs_a_second: dict[str, float] = field(default_factory=dict)
    memory: dict[str, float] = field(default_factory=dict)

    def find(self, program: str, operation: str, case: Case) -> Result | None:
        """The result of a program on a pair."""
        key = (program, operation, case[:3])
        return next((r for r in self.results if (r.program, r.operation, r.case[:3]) == key), None)

    def to_json(self) -> dict[str, Any]:
        return asdict(self)

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Comparison:
        results = [
            Result(
                **{
                    **result,
                    "case": Case(*result["case"]),
                    "times": None if result["times"] is None else Times(*result["times"]),
                }
            )
            for result in data["results"]
        ]
        return cls(**{**data, "results": results})
