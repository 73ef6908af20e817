"""`python -m benchmarks.peers.adapters.measure FOLDER`: judge all installed programs.

Each program answers the questions that it supports, on the corpus and on generated cases. A second
run resumes the journals in the folder. A page then lists the exact answers and the failures.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, closing
from itertools import chain
from pathlib import Path

import click

from benchmarks.peers.adapters.adapter import MissingError
from benchmarks.peers.adapters.names import NAMES, load
from benchmarks.peers.adapters.page import write_page
from exactsweep.conform.run.journal import Journal
from exactsweep.conform.run.pool import Judges
from exactsweep.conform.run.process import Terms
from exactsweep.conform.run.protocol import QUESTIONS
from exactsweep.conform.run.run import Run
from exactsweep.conform.run.runner import judge_cases
from exactsweep.corpus import FAMILIES, Case, cases, generate

SEED = 1


def choose_cases(each: int, most: int | None) -> Iterator[Case]:
    """Yield the corpus, then some generated cases of each family."""
    drawn = chain.from_iterable(generate(family, SEED, each) for family in FAMILIES)
    return chain(cases(max_size=most), drawn)


def judge(name: str, question: str, chosen: Iterator[Case], seconds: float, folder: Path) -> None:
    """Judge a program on one question, with a journal."""
    command = [sys.executable, "-m", "benchmarks.peers.adapters", name, "--ask", question]
    with ExitStack() as stack:
        terms = Terms(command, seconds)
        judges = stack.enter_context(closing(Judges(terms)))
        path = folder / f"{name}.{question}"
        # The interpreter's path depends on the machine.
        journal = stack.enter_context(
            Journal(path, terms._replace(command=command[1:]), judges.hello, resume=True)
        )
        run = Run(judges.hello, command)
        judge_cases(run, judges, chosen, journal=journal)
        if run.complaints or run.interrupted:
            raise click.ClickException(f"{name}: {'; '.join(run.complaints) or 'interrupted'}")


@click.command()
@click.argument("folder", type=click.Path(file_okay=False, path_type=Path))
@click.option(
    "--each", default=100, show_default=True, help="Number of generated cases per family."
)
@click.option("--most", type=int, help="Skip cases of the corpus with more vertices.")
@click.option(
    "--only", multiple=True, type=click.Choice(NAMES), help="Judge only this program. (repeatable)"
)
@click.option(
    "--no-judging", is_flag=True, help="Only write the page from the journals in the folder."
)
@click.option(
    "--timeout",
    "seconds",
    default=10.0,
    show_default=True,
    help="Time limit of an answer in seconds.",
)
@click.option(
    "--page", type=click.Path(path_type=Path, dir_okay=False), help="Write the page to a file."
)
def main(
    folder: Path,
    each: int,
    most: int | None,
    only: Sequence[str],
    seconds: float,
    page: Path | None,
    no_judging: bool,
) -> None:
    """Judge other programs, and write a page about their exactness."""
    folder.mkdir(exist_ok=True)
    for name in () if no_judging else only or NAMES:
        try:
            adapter = load(name)
        except MissingError as error:
            click.echo(f"{name}: {error}", err=True)
            continue
        adapter.close()
        for question in adapter.hello.questions:
            judge(name, question, choose_cases(each, most), seconds, folder)
            click.echo(f"{name}, {question}: done", err=True)
    asked = f"{len(list(cases(max_size=most)))} cases of the corpus"
    asked += f", of at most {most} vertices" if most is not None else ""
    asked += f", and {each} of each family of the generator, seed {SEED}"
    journals = (folder / f"{name}.{question}" for name in NAMES for question in QUESTIONS)
    text = write_page(filter(Path.is_file, journals), asked)
    if page is None:
        click.echo(text)
    else:
        page.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
