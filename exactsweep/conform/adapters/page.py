"""A page on exactness with a row for each program and a column for each kind of case."""

from __future__ import annotations

import json
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable
from datetime import date
from pathlib import Path

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.outcome import Outcome, outcome_from_json

_RIGHT = (Verdict.EXACT, Verdict.EQUIVALENT, Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS)


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
HEAD = """# Who is exact on what

A cell has how many of the cases that a program was asked it answers exactly; `+` how many more
except for rounding that its numbers explain; `of` how many it was asked. Lost exact fits do not
count here, since programs for Minkowski sums cannot know them. What is left is wrong, broken, or no
answer: the page on [other programs](README.md) says what. A blank: none of these cases is for that
program.

"""


def write_page(journals: Iterable[Path], asked: str) -> str:
    """Write the page in Markdown.

    Args:
        journals: of 'exactsweep conform', one for each program and question.
        asked: which cases were put to the programs.

    Returns:
        The text, with the day of today.

    Cost: linear.
    """
    cells: dict[str, dict[str, Counter[str]]] = defaultdict(lambda: defaultdict(Counter))
    for path in journals:
        with path.open(encoding="utf-8") as lines:
            hello = json.loads(next(lines))["hello"]
            is_inside = hello.get("questions") == ["inner_fit"]
            for outcome in map(outcome_from_json, map(json.loads, lines)):
                for column in _list_columns(outcome, is_inside):
                    cells[hello["hello"]][column][_name(outcome.verdict)] += 1
    names = [*COLUMNS, INSIDE]
    rows = [["program", *names], ["---", *("---:" for _ in names)]]
    rows += ([name, *(_write(found[c]) for c in names)] for name, found in cells.items())
    table = "".join(f"| {' | '.join(row)} |\n" for row in rows)
    return f"{HEAD}Measured on {date.today():%d %B %Y}: {asked}.\n\n{table}"


def _list_columns(outcome: Outcome, is_inside: bool) -> list[str]:
    if outcome.verdict in (Verdict.UNSUPPORTED, Verdict.UNDECIDED):
        return []
    return [INSIDE] if is_inside else [name for name, fits in COLUMNS.items() if fits(outcome)]


def _name(verdict: Verdict) -> str:
    return "right" if verdict in _RIGHT else verdict.value


def _write(found: Counter[str]) -> str:
    """Write a cell.

    >>> _write(Counter(right=3, within=1, wrong=1)), _write(Counter())
    ('3 + 1 of 5', '')
    """
    if not found:
        return ""
    rounded = f" + {found['within']}" if found["within"] else ""
    return f"{found['right']}{rounded} of {found.total()}"
