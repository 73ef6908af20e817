"""The reports that `exactsweep conform` and `exactsweep judge` have in common."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from exactsweep.cli.complete import list_verdicts, offer
from exactsweep.cli.output import measure_terminal, write
from exactsweep.cli.pair import PATH
from exactsweep.formats import FormatError
from exactsweep.numbers.number import to_fraction

if TYPE_CHECKING:
    from exactsweep.conform.run.protocol import Hello
    from exactsweep.conform.run.run import Run


def require_own_files(paths: Sequence[str | None]) -> None:
    """Refuse one file for two reports."""
    files = [os.path.realpath(path) for path in paths if path not in (None, "-")]
    if len({*files}) < len(files):
        raise click.UsageError("Give each report and the journal a file of its own.")


class Reports:
    """The files that a run is reported to, and its acceptance."""

    def __init__(
        self,
        accept: str,
        least_judged: Fraction,
        junit: str | None,
        json: str | None,
        html: str | None,
    ) -> None:
        self.accept, self.least_judged = accept, least_judged
        self.junit, self.json, self.html = junit, json, html
        self._require_places()

    def begin(self, hello: Hello, command: Sequence[str] = ()) -> Run:
        """Begin a run that is measured so."""
        from exactsweep.conform.judge.verdict import Verdict
        from exactsweep.conform.run.run import Run

        return Run(hello, command, Verdict(self.accept), self.least_judged)

    def write(self, run: Run) -> None:
        """Write the table and the files that were asked for, and exit with 1 unless all is well.

        A report to standard output takes the place of the table.

        Raises:
            FormatError: a file cannot be written.
        """
        from exactsweep.conform.report.text import close, write_table

        if "-" not in (self.junit, self.json, self.html):
            terminal = measure_terminal("-")
            columns = terminal and terminal.columns
            write(
                f"{write_table(run.summary, columns)}\n{close(run, is_timed=bool(terminal))}", "-"
            )
        if self.junit is not None:
            from exactsweep.conform.report.junit import write_junit

            write(write_junit(run), self.junit)
        if self.json is not None:
            write(json.dumps(run.to_json(), indent=1) + "\n", self.json)
        if self.html is not None:
            from exactsweep.conform.report.html import write_html

            write(write_html(run), self.html)
        sys.exit(0 if run.passed else 1)

    def _require_places(self) -> None:
        """Refuse, before a long run, what would fail after it."""
        paths = [path for path in (self.junit, self.json, self.html) if path is not None]
        if paths.count("-") > 1:
            raise click.UsageError("Only one report can go to standard output.")
        require_own_files(paths)
        for path in paths:
            if path != "-" and not Path(path).parent.is_dir():
                raise FormatError(f"{path}: its folder is not there")


def takes_reports(command: Callable[..., None]) -> Callable[..., None]:
    """Give a command the options of its reports, as `reports`."""

    @takes_accept
    @click.option(
        "--least-judged",
        metavar="SHARE",
        default="0",
        callback=_to_share,
        help="Fail if less of the cases can be judged: 0.9 or 90%, for example. One at least must.",
    )
    @click.option("--junit", type=PATH, metavar="FILE", help="Write JUnit XML, for CI.")
    @click.option("--json", type=PATH, metavar="FILE", help="Write all outcomes as JSON.")
    @click.option(
        "--html", type=PATH, metavar="FILE", help="Write a page with a picture of each failure."
    )
    @wraps(command)
    def with_reports(
        accept: str,
        least_judged: Fraction,
        junit: str | None,
        json: str | None,
        html: str | None,
        **options: Any,
    ) -> None:
        command(reports=Reports(accept, least_judged, junit, json, html), **options)

    return with_reports


def takes_accept(command: Callable[..., None]) -> Callable[..., None]:
    """Give a command the option --accept VERDICT, as `accept`."""
    option = click.option(
        "--accept",
        metavar="VERDICT",
        shell_complete=offer(list_verdicts),
        default="equivalent except for exact fits",
        callback=_known_verdict,
        help="The worst verdict that passes. If left out: exact, equivalent, and 'equivalent but "
        "for exact fits', as exact fits are reported apart; with --accept equivalent they count.",
    )
    return option(command)


def takes_rounding(command: Callable[..., None]) -> Callable[..., None]:
    """Give a command the option --rounding NUMBER, as `rounding`."""
    option = click.option(
        "--rounding",
        callback=_to_rounding,
        metavar="NUMBER",
        help="By how much less a coordinate may be off and the answer still be 'within'.",
    )
    return option(command)


def _to_rounding(ctx: click.Context, option: click.Parameter, value: str | None) -> Fraction | None:
    try:
        rounding = None if value is None else to_fraction(value)
    except ValueError as error:
        raise click.BadParameter(str(error)) from None
    if rounding is not None and rounding < 0:
        raise click.BadParameter(f"{value} is negative")
    return rounding


def _to_share(ctx: click.Context, option: click.Parameter, value: str) -> Fraction:
    number = value.removesuffix("%")
    try:
        share = to_fraction(number) / (1 if number == value else 100)
    except ValueError as error:
        raise click.BadParameter(str(error)) from None
    if not 0 <= share <= 1:
        raise click.BadParameter(f"{value} is not between 0 and 1.")
    return share


def _known_verdict(ctx: click.Context, option: click.Parameter, name: str) -> str:
    """Refuse what is no verdict, or says nothing on an answer."""
    allowed = list_verdicts()
    if name not in allowed:
        raise click.BadParameter(f"{name!r} is not one of: {', '.join(allowed)}")
    return name
