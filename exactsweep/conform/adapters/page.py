"""A page on other programs: the kinds of cases on which each is exact, and how it fails."""

from __future__ import annotations

import json
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from datetime import date
from pathlib import Path
from typing import Any

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.outcome import Outcome, outcome_from_json

_RIGHT = (Verdict.EXACT, Verdict.EQUIVALENT, Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS)
_OTHERS = tuple(v for v in Verdict if v not in (*_RIGHT, Verdict.UNSUPPORTED))
_SHOWN = (Verdict.CONSERVATIVE, Verdict.UNSOUND, Verdict.WRONG, Verdict.MALFORMED)
_ASKED = {"sweep": "outer path", "no_fit": "no-fit polygon", "inner_fit": "inside a container"}


def _flagged(flag: str) -> Callable[[Outcome], bool]:
    return lambda outcome: flag in outcome.flags


COLUMNS: dict[str, Callable[[Outcome], bool]] = {
    "convex": lambda outcome: outcome.kind == "CC",
    "monotone": lambda outcome: outcome.kind in ("CM", "MM"),
    "any shape": lambda outcome: outcome.kind == "SS",
    "holes in the answer": _flagged("no-fit-hole"),
    "off the grid": _flagged("rounded-answer"),
    "nearly parallel": _flagged("near-parallel"),
    "thin": _flagged("sliver"),
    "beyond 2^53": _flagged("huge"),
}
INSIDE = "inside a container"
HEAD = """# Exactness of other programs

A cell counts the cases that a program answers exactly; `+` counts those that are right except for
rounding that its numbers explain; `of` counts those that it was asked. Lost exact fits do not
count, since programs for Minkowski sums cannot know them. A blank cell: no such case is for that
program. [Other programs](README.md) lists the questions to each.

"""
FAILURES = """
## All verdicts

The last column names the smallest case that the program does not get right: `exactsweep corpus show
ID` prints it.

"""


def write_page(journals: Iterable[Path], asked: str) -> str:
    """Write the page in Markdown.

    Args:
        journals: of 'exactsweep conform', one for each program and question.
        asked: a description of the cases that the programs got.

    Returns:
        The text, with the day of today.

    Cost: linear.
    """
    cells: dict[str, dict[str, Counter[Verdict]]] = defaultdict(lambda: defaultdict(Counter))
    verdicts: dict[tuple[str, str], Counter[Verdict]] = defaultdict(Counter)
    smallest: dict[tuple[str, str], tuple[int, str]] = {}
    for path in journals:
        with path.open(encoding="utf-8") as lines:
            hello = json.loads(next(lines))["hello"]
            (question,) = hello.get("questions", ["sweep"])
            key = hello["hello"], _ASKED[question]
            for outcome in map(outcome_from_json, map(json.loads, lines)):
                if outcome.verdict is Verdict.UNSUPPORTED:
                    continue
                verdicts[key][outcome.verdict] += 1
                for column in _list_columns(outcome, question):
                    cells[key[0]][column][outcome.verdict] += 1
                if outcome.verdict in _SHOWN:
                    found = _measure(outcome.case or {}), outcome.id
                    smallest[key] = min(smallest.get(key, found), found)
    names = [*COLUMNS, INSIDE]
    rows = ([name, *(_write(found[c]) for c in names)] for name, found in cells.items())
    used = [verdict for verdict in _OTHERS if any(found[verdict] for found in verdicts.values())]
    failures = (
        [
            *key,
            str(found.total()),
            str(_count_right(found)),
            *(str(found[verdict] or "") for verdict in used),
            smallest[key][1] if key in smallest else "",
        ]
        for key, found in verdicts.items()
    )
    head = ["program", "asked", "cases", "exact", *used, "smallest not right"]
    return (
        f"{HEAD}Measured on {date.today():%d %B %Y}: {asked}.\n\n"
        + _tabulate(["program", *names], rows)
        + FAILURES
        + _tabulate(head, failures)
    )


def _tabulate(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    rule = ["---", *["---:"] * (len(head) - 1)]
    lines: Iterator[Sequence[str]] = iter([head, rule, *rows])
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def _list_columns(outcome: Outcome, question: str) -> list[str]:
    if not outcome.verdict.is_judgement:
        return []
    if question == "inner_fit":
        return [INSIDE]
    return [name for name, fits in COLUMNS.items() if fits(outcome)]


def _measure(case: Mapping[str, Any]) -> int:
    return sum(len(case.get(name, ())) for name in ("directrix", "generatrix"))


def _count_right(found: Counter[Verdict]) -> int:
    return sum(found[verdict] for verdict in _RIGHT)


def _write(found: Counter[Verdict]) -> str:
    """Write a cell.

    >>> _write(Counter({Verdict.EXACT: 3, Verdict.WITHIN: 1, Verdict.WRONG: 1})), _write(Counter())
    ('3 + 1 of 5', '')
    """
    if not found:
        return ""
    rounded = f" + {found[Verdict.WITHIN]}" if found[Verdict.WITHIN] else ""
    return f"{_count_right(found)}{rounded} of {found.total()}"
