"""The command `exactsweep compare`."""

import json
import sys
from fractions import Fraction

import click

from exactsweep.cli.complete import CASES, offer
from exactsweep.cli.options import PATH, takes_output
from exactsweep.cli.output import write
from exactsweep.cli.reports import takes_accept, takes_rounding
from exactsweep.formats import read_certificate


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
    pairs of points. Numbers are integers, decimals, which stand for the nearest binary64, or
    strings such as "-7/2".

    \b
    Verdicts; the worst part of the answer decides:
      exact          the vertices of the exact loop, in order
      equivalent     the same set of points, with other vertices
      equivalent except for exact fits
      within         the exact loop except for rounding
      false exact fits
      conservative   misses free positions, permits no overlap
      unsound        permits overlap
      wrong          both
      malformed      not a region: nan, too few vertices, crossing edges, ...
      unsupported    nothing to compare
      undecided      not compared within 60 CPU seconds

    For each part, the report states the distance and the area between the loops, and a place to
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
