"""`python -m exactsweep.conform.adapters.table JOURNAL...`: what came of judging programs.

Reads journals of `exactsweep conform`, any number for one program, and writes a table in Markdown,
a row a program: how many cases got which verdict, and how far loops are off at most, in units
of the program's numbers.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path

import click

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.outcome import outcome_from_json

_COLUMNS = {
    "exact or equivalent": (Verdict.EXACT, Verdict.EQUIVALENT),
    "but for exact fits": (Verdict.EQUIVALENT_BUT_FOR_EXACT_FITS,),
    "within": (Verdict.WITHIN,),
    "conservative": (Verdict.CONSERVATIVE,),
    "unsound": (Verdict.UNSOUND,),
    "wrong": (Verdict.WRONG,),
    "malformed": (Verdict.MALFORMED,),
    "crash": (Verdict.CRASH,),
    "timeout": (Verdict.TIMEOUT,),
}
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

    def add(self, lines: Iterable[str]) -> None:
        """Count the outcomes of a journal."""
        for line in lines:
            data = json.loads(line)
            outcome = outcome_from_json(data)
            self.counts[outcome.verdict] += 1
            for part in outcome.parts:
                if part["distance_squared"] is None or outcome.verdict not in _OFF:
                    continue
                square = Fraction(part["distance_squared"][1])
                if self.relative and outcome.case is not None:
                    loop = outcome.case["expected"][part["name"]]
                    square /= max(abs(Fraction(c)) for point in loop for c in point) ** 2
                known = self.squares.get(outcome.verdict, Fraction(0))
                self.squares[outcome.verdict] = max(known, square)

    def cells(self) -> list[str]:
        """The cells of the row after the first one."""
        asked = self.counts.total() - self.counts[Verdict.UNSUPPORTED]
        return [str(asked), *(self._cell(verdicts) for verdicts in _COLUMNS.values())]

    def _cell(self, verdicts: Sequence[Verdict]) -> str:
        count = sum(self.counts[verdict] for verdict in verdicts)
        square = self.squares.get(verdicts[0], Fraction(0))
        return f"{count} ({float(square) ** 0.5:.2g})" if square else str(count or "")


@click.command()
@click.argument("journals", nargs=-1, required=True, type=click.Path(exists=True, path_type=Path))
def main(journals: tuple[Path, ...]) -> None:
    """Write the table of JOURNALS of 'exactsweep conform'."""
    rows: dict[str, Row] = {}
    for path in journals:
        with path.open(encoding="utf-8") as lines:
            hello = json.loads(next(lines))["hello"]
            relative = hello["numbers"] == "binary64"
            rows.setdefault(hello["hello"], Row(relative)).add(lines)
    click.echo(f"| program | cases | {' | '.join(_COLUMNS)} |")
    click.echo(f"|---|{'---:|' * (1 + len(_COLUMNS))}")
    for name, row in rows.items():
        click.echo(f"| {name} | {' | '.join(row.cells())} |")


if __name__ == "__main__":
    main()
