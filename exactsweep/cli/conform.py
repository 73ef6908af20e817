import json
import signal
import sys
from collections.abc import Iterator
from contextlib import ExitStack, closing, contextmanager
from fractions import Fraction
from itertools import chain
from math import isnan
from pathlib import Path
from typing import Any

import click

from exactsweep.cli.complete import CASES, list_filters, offer
from exactsweep.cli.options import PATH, checked, takes_file, takes_output
from exactsweep.cli.output import write
from exactsweep.cli.pair import takes_reading
from exactsweep.cli.reports import (
    Reports,
    require_own_files,
    takes_accept,
    takes_reports,
    takes_rounding,
)
from exactsweep.cli.working import show_bar
from exactsweep.formats import FormatError, read_certificate
from exactsweep.formats.files import open_bytes


def _reject_nan(seconds: float) -> float:
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
        is_separated = "--" in given[: len(given) - len(program)]
        own = {name for option in self.params for name in option.opts if name.startswith("--")}
        for word in () if is_separated else program[1:]:
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
    "Test all pairs of your own polygons, in any format; or JSON lines with a directrix and a "
    "generatrix. The command computes the exact answers.",
)
@takes_reading
@click.option(
    "--timeout",
    type=click.FloatRange(min=0, min_open=True),
    callback=checked(_reject_nan),
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
    "max_memory",
    type=click.IntRange(min=1),
    metavar="MIB",
    help="Memory limit for the program and its descendants; default: none.",
)
@takes_file("--journal", "Record each outcome as it arrives.")
@click.option("--resume", is_flag=True, help="Resume the run recorded in the journal.")
@click.option(
    "--shrink",
    type=click.IntRange(min=0),
    default=1,
    metavar="N",
    help="Shrink N failing cases of each fault for --html and --json; default: 1.",
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
    max_memory: int | None,
    journal: str | None,
    resume: bool,
    shrink: int,
    rounding: Fraction | None,
    reports: Reports,
) -> None:
    """Judge a program against exact answers.

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
    from exactsweep.corpus import selection
    from exactsweep.corpus.pairs import read_pairs
    from exactsweep.corpus.shipped import cases, list_summaries, require_prefix

    if path is not None and pairs is not None:
        raise click.UsageError("Give either --cases or --pairs.")
    if any(reading.values()) and pairs is None:
        raise click.UsageError("The options for reading files need --pairs.")
    require_own_files([journal, *reports.list_files()])
    if resume and journal is None:
        raise click.UsageError("--resume needs --journal.")
    terms = Terms(command, timeout, rounding, None if max_memory is None else max_memory * 2**20)
    wanted = selection.read_filters(filters)
    total = None
    given = selection.read_cases(path) if path is not None else None
    if pairs is not None:
        given = read_pairs(pairs, **reading)
    if given is None:
        for prefix in wanted.get("prefix", ()):
            require_prefix(prefix)
    if given is None and sys.stderr is not None and sys.stderr.isatty():
        total = sum(1 for _ in list_summaries(**wanted))
    chosen = cases(**wanted) if given is None else selection.select(given, **wanted)
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
            selection.require_distinct(chosen),
            journal=kept or None,
            report=lambda: show(run.summary.total(), write_counts(run.summary)),
            made_smaller=smaller,
        )
    if not run.summary.total() and not run.interrupted:
        raise selection.SelectionError("no case matches the filters")
    reports.write(run)


@contextmanager
def _end_as_interrupted() -> Iterator[None]:
    old = signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, old)


@click.command("judge")
@takes_file("--cases path", "Cases as JSON lines; default: the corpus and generated cases.")
@takes_reports
def judge_command(path: str | None, reports: Reports) -> None:
    """Judge answers from a pipe.

    Reads the output of a program that implements the protocol of 'exactsweep conform' from standard
    input: its hello, then one JSON result per line. For example:
    'exactsweep corpus generate --count 100 | COMMAND | exactsweep judge'.

    Prints the number of cases by class, flag and verdict, and each fault with its smallest case.
    The exit code is 0 if no verdict is worse than --accept, every line is an answer, and enough
    cases are judged; otherwise it is 1.

    Example:
      exactsweep judge --cases cases.jsonl
    """
    from exactsweep.conform.run.stream import Stream
    from exactsweep.corpus import Case, find_case
    from exactsweep.corpus.names import require_known
    from exactsweep.corpus.selection import read_cases, require_distinct

    if path == "-":
        raise click.UsageError("Standard input contains the answers; give the cases as a file.")
    cases: dict[str, Case] = {}

    def find(id: str) -> Case:
        return find_case(id) if path is None else cases[require_known(id, cases, "case")]

    with open_bytes("-") as answers:
        stream = Stream(answers)
        run = reports.begin(stream.hello)
        if path is not None:
            cases |= {case.id: case for case in require_distinct(read_cases(path))}
        try:
            for outcome in chain(stream.outcomes(find), stream.unanswered(cases.values())):
                run.add(outcome)
        except KeyboardInterrupt:
            run.interrupted = True
    run.complaints += stream.complaints
    reports.write(run)


@click.command("compare")
@click.argument("case", type=PATH, shell_complete=offer(CASES, files=True))
@click.argument("result", type=PATH)
@takes_rounding
@takes_accept
@click.option("--json", "as_json", is_flag=True, help="Write the exact result as JSON.")
@takes_output
def compare_command(
    case: str, result: str, rounding: Fraction | None, accept: str, as_json: bool, output: str
) -> None:
    """Compare an answer with the exact one.

    CASE is the id of a corpus case, or a file with a case, or with a pair of polygons as written by
    'exactsweep sweep --json'. RESULT is a file, or - for standard input: a JSON object with any of
    "trajectory", "inner" and "outer", each a ring or a list of rings, and "exact_fits", a list of
    pairs of points. Numbers are integers, decimals (read as the nearest binary64), or strings such
    as "-7/2".

    \b
    Verdicts; the worst part of the answer decides:
      exact          the vertices of the exact loop, in order
      equivalent     the same set of points, with other vertices
      equivalent except for exact fits
      within         the exact loop up to --rounding
      false exact fits
      conservative   misses free positions, permits no overlap
      unsound        permits overlap
      wrong          both
      malformed      not a region: nan, too few vertices, crossing edges, ...
      unsupported    nothing to compare
      undecided      not compared within 60 CPU seconds

    For each part, the report states the distance and the area between the loops, and a point to
    check by hand. The exit code is 0 if the verdict is no worse than --accept, and 1 otherwise.

    Example:
      exactsweep compare directions-y answer.json
    """  # noqa: D301
    from exactsweep.conform.judge.verdict import Verdict
    from exactsweep.conform.report.text import describe
    from exactsweep.conform.run.outcome import compare_in_time
    from exactsweep.conform.run.run import fails
    from exactsweep.corpus.pairs import read_case

    if case == result == "-":
        raise click.UsageError("Only one file can be standard input (-).")
    found = compare_in_time(read_case(case), read_certificate(result), rounding=rounding)
    write(f"{json.dumps(found.to_json(), indent=2)}\n" if as_json else describe(found), output)
    passed = found.verdict.is_judgement and not fails(found.verdict, Verdict(accept))
    sys.exit(0 if passed else 1)
