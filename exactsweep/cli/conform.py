"""The command `exactsweep conform`."""

import signal
import sys
from collections.abc import Iterator
from contextlib import ExitStack, closing, contextmanager
from fractions import Fraction
from math import isnan
from pathlib import Path
from typing import Any

import click

from exactsweep.cli.complete import list_filters, offer
from exactsweep.cli.options import checked, takes_file
from exactsweep.cli.pair import takes_reading
from exactsweep.cli.reports import Reports, require_own_files, takes_reports, takes_rounding
from exactsweep.cli.working import show_bar
from exactsweep.formats import FormatError


def _refuse_nan(seconds: float) -> float:
    """Reject nan, which passes every range check."""
    if isnan(seconds):
        raise FormatError("nan is not a number of seconds.")
    return seconds


class _ProgramCommand(click.Command):
    """A command whose own options must precede the program to run."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Reject options of this command after the program, unless -- separates them."""
        given = [*args]
        rest = super().parse_args(ctx, args)
        program: tuple[str, ...] = ctx.params.get("command") or ()
        is_parted = "--" in given[: len(given) - len(program)]
        own = {name for option in self.params for name in option.opts if name.startswith("--")}
        for word in () if is_parted else program[1:]:
            name = word.partition("=")[0]
            if name in own:
                raise click.UsageError(
                    f"{name} after the program would be passed to it. Move it before "
                    f"{program[0]}; or, if it is meant for the program, put -- before {program[0]}."
                )
        return rest


@click.command("conform", cls=_ProgramCommand, context_settings={"allow_interspersed_args": False})
@click.argument("command", nargs=-1, required=True, type=click.UNPROCESSED)
@click.option(
    "--filter",
    "filters",
    multiple=True,
    metavar="NAME=VALUE",
    shell_complete=offer(list_filters),
    help="Select cases: id=PREFIX, flag=NAME, class=CC (CM, MM, SS), size=MAXIMUM of vertices. "
    "Repeatable: cases match any of the ids and classes, and all flags.",
)
@takes_file("--cases path", "Cases as JSON lines; default: the corpus.")
@takes_file(
    "--pairs",
    "Your own polygons in any format, to test all pairs of them; or JSON lines with a directrix "
    "and a generatrix. Exact answers are computed.",
)
@takes_reading
@click.option(
    "--timeout",
    type=click.FloatRange(min=0, min_open=True),
    callback=checked(_refuse_nan),
    default=10.0,
    metavar="SECONDS",
    help="Time limit per answer; default: 10.",
)
@click.option(
    "--workers",
    type=click.IntRange(min=1, max=256),
    default=1,
    metavar="N",
    help="Run N copies of the program in parallel.",
)
@click.option(
    "--memory",
    "most_memory",
    type=click.IntRange(min=1),
    metavar="MIB",
    help="Memory limit for the program and its descendants; default: none.",
)
@takes_file("--journal", "Record each outcome as it arrives.")
@click.option("--resume", is_flag=True, help="Resume the run of the journal.")
@click.option(
    "--shrink",
    type=click.IntRange(min=0),
    default=1,
    metavar="N",
    help="Shrink N failures of each fault for --html and --json; default: 1.",
)
@takes_rounding
@takes_reports
def conform_command(
    command: tuple[str, ...],
    filters: tuple[str, ...],
    path: str | None,
    pairs: str | None,
    reading: dict[str, Any],
    timeout: float,
    workers: int,
    most_memory: int | None,
    journal: str | None,
    resume: bool,
    shrink: int,
    rounding: Fraction | None,
    reports: Reports,
) -> None:
    """Judge a program by exact answers.

    Runs COMMAND with its arguments. The program reads one JSON case per line on standard input and
    writes one JSON result per line on standard output; exactsweep/conform/PROTOCOL.md describes the
    protocol. Options of 'exactsweep conform' come before COMMAND, optionally separated by --.

    Prints the number of cases by class, flag and verdict, and each fault with its smallest case.
    The exit code is 0 if no verdict is worse than --accept, the program exits normally, and enough
    cases are judged; otherwise it is 1.

    Example:
      exactsweep conform --filter class=CC -- python adapter.py
      exactsweep conform --pairs parts.svg -- node adapter.js
    """
    from exactsweep.conform.report.text import write_counts
    from exactsweep.conform.run.journal import Journal
    from exactsweep.conform.run.pool import Judges
    from exactsweep.conform.run.process import Terms
    from exactsweep.conform.run.runner import judge_cases
    from exactsweep.corpus.pairs import read_pairs
    from exactsweep.corpus.selection import (
        SelectionError,
        read_cases,
        read_filters,
        require_distinct,
        select,
    )
    from exactsweep.corpus.shipped import cases, list_summaries, require_start

    if path is not None and pairs is not None:
        raise click.UsageError("Give either --cases or --pairs.")
    if any(reading.values()) and pairs is None:
        raise click.UsageError("The options for reading files need --pairs.")
    require_own_files([journal, *reports.list_files()])
    if resume and journal is None:
        raise click.UsageError("--resume needs --journal.")
    most = None if most_memory is None else most_memory * 2**20
    terms = Terms(command, timeout, rounding, most)
    wanted = read_filters(filters)
    total = None
    given = read_cases(path) if path is not None else None
    if pairs is not None:
        given = read_pairs(pairs, **reading)
    if given is None:
        for prefix in wanted.get("prefix", ()):
            require_start(prefix)
    if given is None and sys.stderr is not None and sys.stderr.isatty():
        total = sum(1 for _ in list_summaries(**wanted))
    chosen = cases(**wanted) if given is None else select(given, **wanted)
    with ExitStack() as stack:
        stack.enter_context(_end_as_interrupted())
        judges = stack.enter_context(closing(Judges(terms, workers)))
        kept = journal and stack.enter_context(
            Journal(Path(journal), terms, judges.hello, resume=resume)
        )
        run = reports.begin(judges.hello, command)
        show = stack.enter_context(show_bar(total))
        smaller = shrink if reports.html or reports.json else 0
        judge_cases(
            run,
            judges,
            require_distinct(chosen),
            journal=kept or None,
            tell=lambda: show(run.summary.total(), write_counts(run.summary)),
            made_smaller=smaller,
        )
    if not run.summary.total() and not run.interrupted:
        raise SelectionError("no case matches the filters")
    reports.write(run)


@contextmanager
def _end_as_interrupted() -> Iterator[None]:
    """Handle SIGTERM like Ctrl-C."""
    old = signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, old)
