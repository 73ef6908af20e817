"""Tables in Markdown of the verdicts that programs got.

In brackets is how far loops are off at most, in units of the program's numbers or, of floats, in
parts of the largest coordinate.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.outcome import Outcome, outcome_from_json
from exactsweep.corpus.case_json import list_expected_rings
from exactsweep.numbers.number import read_any_length

COLUMNS = {
    "exact or equivalent": (Verdict.EXACT, Verdict.EQUIVALENT),
    "except for exact fits": (Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS,),
    "within": (Verdict.WITHIN,),
    "conservative": (Verdict.CONSERVATIVE,),
    "unsound": (Verdict.UNSOUND,),
    "wrong": (Verdict.WRONG,),
    "malformed": (Verdict.MALFORMED,),
    "crash": (Verdict.CRASH,),
    "timeout": (Verdict.TIMEOUT,),
    "undecided": (Verdict.UNDECIDED,),
}
TITLES = {
    False: "No-fit polygons of pairs that share a direction",
    True: "No-fit polygons of any shapes",
}
INSIDE = "Positions inside a container"
_OFF = (Verdict.WITHIN, Verdict.CONSERVATIVE, Verdict.UNSOUND, Verdict.WRONG)


@dataclass
class Row:
    """One program.

    Attributes:
        counts: how many cases got which verdict.
        relative: whether distances are in parts of the largest coordinate: of floats.
        squares: for each verdict, the greatest squared distance.
    """

    relative: bool = False
    counts: Counter[Verdict] = field(default_factory=Counter)
    squares: dict[Verdict, Fraction] = field(default_factory=dict)

    def add(self, outcome: Outcome) -> None:
        """Count an outcome."""
        self.counts[outcome.verdict] += 1
        for part in outcome.parts:
            if part["distance_squared"] is None or outcome.verdict not in _OFF:
                continue
            square = read_any_length(part["distance_squared"][1])
            if square and self.relative and outcome.case is not None:
                rings = list_expected_rings(outcome.case, part["name"])
                square /= max(abs(Fraction(c)) for ring in rings for p in ring for c in p) ** 2
            known = self.squares.get(outcome.verdict, Fraction(0))
            self.squares[outcome.verdict] = max(known, square)

    def cells(self) -> list[str]:
        """The cells of the row after the first one."""
        return [str(self.counts.total()), *map(self._cell, COLUMNS.values())]

    def _cell(self, verdicts: Sequence[Verdict]) -> str:
        count = sum(self.counts[verdict] for verdict in verdicts)
        square = self.squares.get(verdicts[0], Fraction(0))
        return f"{count} ({float(square) ** 0.5:.2g})" if square else str(count or "")


Rows = dict[str, dict[str, Row]]
"""By the title of a table and the name of a program."""


def read_journal(path: Path, rows: Rows) -> None:
    """Count the outcomes of a journal of 'exactsweep conform', by table and program."""
    with path.open(encoding="utf-8") as lines:
        hello = json.loads(next(lines))["hello"]
        relative = hello["numbers"] == "binary64"
        (question,) = hello.get("questions", ["sweep"])
        for line in lines:
            outcome = outcome_from_json(json.loads(line))
            if outcome.verdict is not Verdict.UNSUPPORTED:
                title = INSIDE if question == "inner_fit" else TITLES[outcome.kind == "SS"]
                table = rows.setdefault(title, {})
                table.setdefault(hello["hello"], Row(relative)).add(outcome)


def write_tables(rows: Rows) -> str:
    """Write the tables in Markdown, a row a program; columns that nobody needs are left out."""
    texts = []
    for title in (*TITLES.values(), INSIDE):
        table = rows.get(title, {})
        if not table:
            continue
        cells = {name: row.cells() for name, row in table.items()}
        used = [k for k in range(len(COLUMNS)) if any(row[k + 1] for row in cells.values())]
        names = [[*COLUMNS][k] for k in used]
        lines = [
            f"**{title}**\n",
            f"| program | cases | {' | '.join(names)} |",
            f"|---|{'---:|' * (1 + len(used))}",
        ]
        for name, row in cells.items():
            lines.append(f"| {name} | {' | '.join([row[0], *(row[k + 1] for k in used)])} |")
        texts.append("\n".join(lines) + "\n")
    return "\n".join(texts)
