"""The command `exactsweep judge`."""

from itertools import chain

import click

from exactsweep.cli.options import takes_file
from exactsweep.cli.reports import Reports, takes_reports
from exactsweep.formats.files import open_bytes


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
