"""A page about the exact answers and the failures of other programs."""

from __future__ import annotations

import json
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from datetime import date
from itertools import product
from pathlib import Path

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.outcome import outcome_from_json
from exactsweep.conform.run.run import ALL, Tally

_RIGHT = (Verdict.EXACT, Verdict.EQUIVALENT, Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS)
_OTHERS = tuple(v for v in Verdict if v not in (*_RIGHT, Verdict.UNSUPPORTED))
_SHOWN = (Verdict.CONSERVATIVE, Verdict.UNSOUND, Verdict.WRONG, Verdict.MALFORMED)
_ASKED = {
    "sweep": "outer path",
    "no_fit": "no-fit polygon",
    "minkowski_sum": "Minkowski sum",
    "inner_fit": "inside a container",
}

# The columns, each with its classes and flags.
COLUMNS = {
    "convex": ("CC",),
    "monotone": ("CM", "MM"),
    "any shape": ("SS",),
    "holes in the answer": ("no-fit-hole",),
    "off the grid": ("rounded-answer",),
    "nearly parallel": ("near-parallel",),
    "thin": ("sliver",),
    "beyond 2^53": ("huge",),
}
INSIDE = "inside a container"
HEAD = """# Exactness of other programs

A cell counts the cases that a program answers exactly; `+` counts answers that differ only by the
rounding of the program's numbers; `of` counts the cases asked. Lost exact fits do not count, since
programs for Minkowski sums cannot find them. A cell is blank if no such case applies to the
program. [Other programs](README.md) lists the questions put to each.

"""
FAILURES = """
## All verdicts

The last column has the id of the smallest case that the program answers incorrectly;
`exactsweep corpus show ID` prints it.

"""


def write_page(journals: Iterable[Path], asked: str) -> str:
    """Write the page in Markdown, with the current date."""
    found: dict[tuple[str, str], Tally] = defaultdict(Tally)
    smallest: dict[tuple[str, str], tuple[int, str]] = {}
    for path in journals:
        with path.open(encoding="utf-8") as lines:
            hello = json.loads(next(lines))["hello"]
            (question,) = hello.get("questions", ["sweep"])
            key = hello["hello"], _ASKED[question]
            for outcome in map(outcome_from_json, map(json.loads, lines)):
                if outcome.verdict is Verdict.UNSUPPORTED:
                    continue
                found[key].add(outcome)
                if outcome.verdict in _SHOWN:
                    measured = outcome.size, outcome.id
                    smallest[key] = min(smallest.get(key, measured), measured)
    rows = []
    for program in dict.fromkeys(name for name, _ in found):
        mine = {asked: tally for (name, asked), tally in found.items() if name == program}
        inside = [mine.pop(INSIDE)] if INSIDE in mine else []
        cells = (_write(mine.values(), groups) for groups in COLUMNS.values())
        rows.append([program, *cells, _write(inside, [ALL])])
    used = [verdict for verdict in _OTHERS if any(t.total(verdict) for t in found.values())]
    failures = (
        [
            *key,
            str(tally.total()),
            str(_count([tally], [ALL], _RIGHT)),
            *(str(tally.total(verdict) or "") for verdict in used),
            smallest[key][1] if key in smallest else "",
        ]
        for key, tally in found.items()
    )
    head = ["program", "asked", "cases", "exact", *used, "smallest failure"]
    return (
        f"{HEAD}Measured on {date.today():%d %B %Y}: {asked}.\n\n"
        + _tabulate(["program", *COLUMNS, INSIDE], rows)
        + FAILURES
        + _tabulate(head, failures)
    )


def _tabulate(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    rule = ["---", *["---:"] * (len(head) - 1)]
    lines: Iterator[Sequence[str]] = iter([head, rule, *rows])
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def _count(tallies: Iterable[Tally], groups: Iterable[str], verdicts: Iterable[Verdict]) -> int:
    return sum(t.total(v, group) for t, group, v in product(tallies, groups, verdicts))


def _write(tallies: Iterable[Tally], groups: Iterable[str]) -> str:
    """Write a cell.

    >>> from exactsweep.conform.run.outcome import Outcome
    >>> outcomes = [Outcome("", "CC", (), v) for v in (*Verdict, Verdict.EXACT)]
    >>> _write([Tally(outcomes)], ["CC"]), _write([Tally(outcomes)], ["CM"])
    ('4 + 1 of 13', '')
    """
    tallies = [*tallies]
    asked = _count(tallies, groups, (v for v in Verdict if v.is_judgement))
    rounded = _count(tallies, groups, [Verdict.WITHIN])
    right = _count(tallies, groups, _RIGHT)
    return f"{right}{f' + {rounded}' if rounded else ''} of {asked}" if asked else ""
