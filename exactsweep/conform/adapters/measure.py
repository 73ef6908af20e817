"""`python -m exactsweep.conform.adapters.measure FOLDER`: judges every program that is here.

Each is asked each of its questions, on the corpus and on generated cases. The journals stay in the
folder, and what is there already is not asked again. Then the tables are written, with the smallest
example of each kind, in the place of those of a file between two marks, if one is given; and a page
that says who is exact on what.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack
from datetime import date
from itertools import chain
from pathlib import Path
from typing import Any

import click

from exactsweep.conform.adapters.adapter import MissingError
from exactsweep.conform.adapters.names import NAMES, load
from exactsweep.conform.adapters.page import write_page
from exactsweep.conform.adapters.table import Rows, read_journal, write_tables
from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.journal import Journal
from exactsweep.conform.run.outcome import Outcome
from exactsweep.conform.run.pool import Judges
from exactsweep.conform.run.run import Run
from exactsweep.conform.run.runner import judge_cases
from exactsweep.corpus import FAMILIES, Case, cases, generate
from exactsweep.corpus.case_json import list_expected_rings

BEGIN, END = "<!-- measured -->\n", "<!-- end of what was measured -->\n"
SEED = 1
TO_SHRINK = 8.0
"""Seconds for each smallest example."""
_SHOWN = (Verdict.CONSERVATIVE, Verdict.UNSOUND, Verdict.WRONG, Verdict.MALFORMED, Verdict.CRASH)
_LONGEST = 6


def choose_cases(each: int, most: int | None) -> Iterator[Case]:
    """Yield the corpus, then so many generated cases of each family."""
    drawn = chain.from_iterable(generate(family, SEED, each) for family in FAMILIES)
    return chain(cases(max_size=most), drawn)


def judge(name: str, question: str, chosen: Iterator[Case], seconds: float, folder: Path) -> None:
    """Judge a program by one question, and keep its outcomes and the smallest failures."""
    command = [sys.executable, "-m", "exactsweep.conform.adapters", name, "--ask", question]
    with ExitStack() as stack:
        judges = stack.enter_context(Judges(command, seconds=seconds))
        path = folder / f"{name}.{question}"
        # Only the name of the interpreter may differ from machine to machine.
        journal = stack.enter_context(
            Journal(path, command=command[1:], hello=judges.hello, seconds=seconds, resume=True)
        )
        run = Run(judges.hello, command)
        judge_cases(run, judges, chosen, journal=journal)
        if run.complaints or run.interrupted:
            raise click.ClickException(f"{name}: {'; '.join(run.complaints) or 'interrupted'}")
    small = folder / f"{name}.{question}.small"
    if not small.exists():
        with Judges(command, seconds=seconds) as judges:
            found = [outcome for _, outcome in judges.shrink(find_smallest(run), TO_SHRINK)]
        text = "".join(f"{json.dumps(outcome.to_json())}\n" for outcome in found)
        small.write_text(text, encoding="utf-8")


def find_smallest(run: Run) -> list[Outcome]:
    """Find for each verdict that is shown the failure with the fewest vertices."""
    found: dict[Verdict, Outcome] = {}
    for outcome in run.show():
        if outcome.verdict in _SHOWN and outcome.case is not None:
            known = found.get(outcome.verdict)
            if known is None or _size(outcome.case) < _size(known.case or {}):
                found[outcome.verdict] = outcome
    return [found[verdict] for verdict in _SHOWN if verdict in found]


def _size(case: Mapping[str, Any]) -> int:
    return sum(len(ring) for ring in (*_rings(case, "directrix"), *_rings(case, "generatrix")))


def _rings(case: Mapping[str, Any], name: str) -> list[Any]:
    return [case[name], *case.get(f"{name}_holes", ())]


def write_examples(folder: Path) -> str:
    """Write the smallest failure of each kind as a table in Markdown."""
    lines = ["| program | verdict | D and G | exact | its answer |", "|---|---|---|---|---|"]
    for name in NAMES:
        for path in sorted(folder.glob(f"{name}.*.small")):
            question = path.name.split(".")[1]
            for line in path.read_text(encoding="utf-8").splitlines():
                outcome = json.loads(line)
                case, part = outcome["case"], "trajectory" if question == "sweep" else question
                pair = "; ".join(_write(_rings(case, side)) for side in ("directrix", "generatrix"))
                answer = (outcome.get("result") or {}).get(part)
                said = outcome["reason"] if answer is None else _write(_as_rings(answer))
                exact = _write(list_expected_rings(case, part))
                asked = f"{name}, {question.replace('_', ' ')}"
                lines.append(f"| {asked} | {outcome['verdict']} | {pair} | {exact} | {said} |")
    return "\n".join(lines) + "\n"


def _as_rings(answer: Any) -> list[Any]:
    nested = bool(answer) and bool(answer[0]) and isinstance(answer[0][0], list)
    return list(answer) if nested else [answer]


def _write(rings: Sequence[Sequence[Any]]) -> str:
    """Write rings in a cell; of long ones how many vertices they have."""
    said = []
    for ring in rings:
        if len(ring) > _LONGEST:
            said.append(f"{len(ring)} vertices")
        else:
            said.append(" ".join(f"({','.join(map(_cut, point))})" for point in ring))
    return " and ".join(said) or "none"


def _cut(number: object) -> str:
    text = str(number)
    return text if len(text) <= 12 else f"{text[:9]}..."


@click.command()
@click.argument("folder", type=click.Path(file_okay=False, path_type=Path))
@click.option("--each", default=100, show_default=True, help="Generated cases of each family.")
@click.option("--most", type=int, help="The most vertices of a case of the corpus; not all.")
@click.option("--only", multiple=True, type=click.Choice(NAMES), help="Not all programs.")
@click.option("--no-judging", is_flag=True, help="Only write what the folder has already.")
@click.option("--timeout", "seconds", default=10.0, show_default=True, help="For one answer.")
@click.option(
    "--page", type=click.Path(path_type=Path, dir_okay=False), help="Who is exact on what: a file."
)
@click.option(
    "--into", type=click.Path(path_type=Path, exists=True), help="The file with the marks."
)
def main(
    folder: Path,
    each: int,
    most: int | None,
    only: Sequence[str],
    seconds: float,
    into: Path | None,
    page: Path | None,
    no_judging: bool,
) -> None:
    """Judge other programs and write what came of it."""
    folder.mkdir(exist_ok=True)
    missing = []
    for name in () if no_judging else only or NAMES:
        try:
            adapter = load(name)
        except MissingError as error:
            missing.append(f"{name}: {error}")
            continue
        adapter.close()
        for question in adapter.hello.questions:
            judge(name, question, choose_cases(each, most), seconds, folder)
            click.echo(f"{name}, {question}: done", err=True)
    rows: Rows = {}
    found = [path for name in NAMES for path in sorted(folder.glob(f"{name}.*"))]
    journals = [path for path in found if path.suffix != ".small"]
    for path in journals:
        read_journal(path, rows)
    asked = f"{len(list(cases(max_size=most)))} cases of the corpus"
    if most is not None:
        asked += f", of at most {most} vertices"
    asked += f", and {each} of each family of the generator"
    text = (
        f"Measured on {date.today():%d %B %Y}: {asked}, seed {SEED}.\n\n{write_tables(rows)}\n"
        f"The smallest example of each kind:\n\n{write_examples(folder)}"
    )
    if page is not None:
        page.write_text(write_page(journals, asked), encoding="utf-8")
    if into is None:
        click.echo(text)
    else:
        before, _, rest = into.read_text(encoding="utf-8").partition(BEGIN)
        after = rest.partition(END)[2]
        into.write_text(f"{before}{BEGIN}{text}{END}{after}", encoding="utf-8")
    for line in missing:
        click.echo(line, err=True)


if __name__ == "__main__":
    main()
