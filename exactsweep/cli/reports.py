"""Options and output of `conform` and `judge`."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

import click

from exactsweep.cli.complete import list_verdicts, offer
from exactsweep.cli.options import checked, gather, takes_file
from exactsweep.cli.output import measure_columns, write
from exactsweep.formats import FormatError, show_path
from exactsweep.numbers.error import quote
from exactsweep.numbers.number import to_fraction

if TYPE_CHECKING:
    from exactsweep.conform.run.protocol import Hello
    from exactsweep.conform.run.run import Run


def require_own_files(paths: Sequence[str | None]) -> None:
    if [*paths].count("-") > 1:
        raise click.UsageError("Only one report can be written to standard output.")
    files = [os.path.realpath(path) for path in paths if path not in (None, "-")]
    if len({*files}) < len(files):
        raise click.UsageError("All outputs must be different files.")


@dataclass
class Reports:
    """The report files of a run, and its conditions for success."""

    accept: str
    least_judged: Fraction
    junit: str | None
    json: str | None
    html: str | None
    badge: str | None
    annotations: bool

    def __post_init__(self) -> None:
        # Fail before a long run instead of after it.
        paths = [path for path in self.list_files() if path is not None]
        require_own_files(paths)
        for path in paths:
            if path != "-" and not Path(path).parent.is_dir():
                raise FormatError(f"{show_path(path)}: its folder does not exist")

    def list_files(self) -> list[str | None]:
        return [self.junit, self.json, self.html, self.badge]

    def begin(self, hello: Hello, command: Sequence[str] = ()) -> Run:
        from exactsweep.conform.judge.verdict import Verdict
        from exactsweep.conform.run.run import Run

        return Run(hello, command, Verdict(self.accept), self.least_judged)

    def write(self, run: Run) -> None:
        """Write the requested files, and the table if standard output is free; exit with 0 or 1."""
        from exactsweep.conform.report.text import close, write_table

        if "-" not in self.list_files():
            write(f"{write_table(run.summary, measure_columns('-'))}\n{close(run)}", "-")
        if self.junit is not None:
            from exactsweep.conform.report.ci import write_junit

            write(write_junit(run), self.junit)
        if self.json is not None:
            write(json.dumps(run.to_json(), indent=1) + "\n", self.json)
        if self.html is not None:
            from exactsweep.conform.report.html import write_html

            write(write_html(run), self.html)
        if self.badge is not None or self.annotations:
            from exactsweep.conform.report.ci import write_annotations, write_badge

            if self.badge is not None:
                write(write_badge(run), self.badge)
            if self.annotations:
                click.echo(write_annotations(run), nl=False, err="-" in self.list_files())
        sys.exit(0 if run.passed else 1)


def to_gap(text: str) -> Fraction:
    found = to_fraction(text)
    if found < 0:
        raise FormatError(f"{text} is negative")
    return found


def _to_share(text: str) -> Fraction:
    number = text.removesuffix("%")
    share = to_fraction(number) / (1 if number == text else 100)
    if not 0 <= share <= 1:
        raise FormatError(f"{text} is not between 0 and 1.")
    return share


def _require_verdict(name: str) -> str:
    allowed = list_verdicts()
    if name not in allowed:
        raise FormatError(f"{quote(name)} is not one of: {', '.join(allowed)}")
    return name


takes_accept = click.option(
    "--accept",
    metavar="VERDICT",
    shell_complete=offer(list_verdicts),
    default="equivalent except for exact fits",
    callback=checked(_require_verdict),
    help="Worst verdict that passes; default: 'equivalent except for exact fits', since exact fits "
    "are reported separately. With 'equivalent', they count.",
)

takes_rounding = click.option(
    "--rounding",
    callback=checked(to_gap),
    metavar="NUMBER",
    help="Maximum coordinate error of an answer that is still 'within'.",
)

takes_reports = gather(
    "reports",
    Reports,
    takes_accept,
    click.option(
        "--least-judged",
        metavar="SHARE",
        default="0",
        callback=checked(_to_share),
        help="Fail if less than this share of the cases is judged, such as 0.9 or 90%.",
    ),
    takes_file("--junit", "Write JUnit XML, for CI."),
    takes_file("--json", "Write all outcomes as JSON."),
    takes_file("--html", "Write a page with a picture of each failure."),
    takes_file("--badge", "Write JSON for a badge with the number of exact answers."),
    click.option(
        "--annotations",
        is_flag=True,
        help="Print the first failures as annotations of GitHub Actions.",
    ),
)
