"""The result of a sweep or a fit: as a report, as JSON or WKT, as a certificate, as polygons."""

from collections.abc import Callable
from functools import wraps
from typing import Any, NamedTuple, TypeVar

import click

from exactsweep import InnerFit, NoFitPolygon, Sweep
from exactsweep.cli.export import export, takes_format, takes_rounding
from exactsweep.cli.output import measure_terminal, takes_output, write, write_readable
from exactsweep.cli.working import working
from exactsweep.formats import FormatError, NamedRegion
from exactsweep.formats.rounding import Rounding, Side
from exactsweep.text.results import certificate_to_json

_Result = TypeVar("_Result", Sweep, NoFitPolygon, InnerFit)


class Form(NamedTuple):
    """In which form a result is wanted.

    Attributes:
        kind: "report", "json", "wkt", "certificate", or "polygons".
        target: the format of the polygons.
        rounding: how they are rounded.
        output: the file, or "-".
        everything: whether a report shows all vertices.
    """

    kind: str
    target: str
    rounding: Rounding | None
    output: str
    everything: bool


def takes_form(wkt: str) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Give a command the options of its answer, as `form`.

    Args:
        wkt: what --wkt writes.
    """

    def decorated(command: Callable[..., None]) -> Callable[..., None]:
        @click.option("--json", is_flag=True, help="Write everything, exactly, as JSON.")
        @click.option("--wkt", is_flag=True, help=f"Write {wkt}, exactly, as WKT.")
        @click.option(
            "--certificate",
            is_flag=True,
            help="Write everything, and the reasons, as JSON for 'exactsweep verify'.",
        )
        @click.option("--all", "everything", is_flag=True, help="Report all vertices.")
        @takes_format
        @takes_rounding
        @takes_output
        @wraps(command)
        def with_form(
            *arguments: Any,
            json: bool,
            wkt: bool,
            certificate: bool,
            everything: bool,
            target: str | None,
            rounding: Rounding | None,
            output: str,
            **options: Any,
        ) -> None:
            given = {
                "--json": json,
                "--wkt": wkt,
                "--certificate": certificate,
                "--to": target,
                "--all": everything,
            }
            chosen = [name for name, value in given.items() if value]
            if len(chosen) > 1:
                raise click.UsageError(f"{chosen[0]} and {chosen[1]} exclude each other.")
            kind = chosen[0].removeprefix("--") if chosen else "report"
            if rounding is not None:
                if kind not in ("json", "wkt", "to"):
                    raise click.UsageError("--round goes with --to FORMAT, --json or --wkt.")
                kind, target = "to", target or kind
            form = Form(kind, target or "", rounding, output, everything)
            command(*arguments, form=form, **options)

        return with_form

    return decorated


def write_result(
    result: _Result,
    form: Form,
    *,
    to_json: Callable[[_Result], str],
    to_wkt: Callable[[_Result], str],
    to_regions: Callable[[_Result], list[NamedRegion]],
    side_of: Callable[[NamedRegion], Side],
    report: Callable[..., str],
) -> None:
    """Write a result in a form of `takes_form`."""
    terminal = measure_terminal(form.output)
    with working("computing"):
        if form.kind == "to":
            fits = () if isinstance(result, Sweep) else result.exact_fits
            regions = to_regions(result)
        elif form.kind == "json":
            text = to_json(result)
        elif form.kind == "certificate":
            text = certificate_to_json(result)
        elif form.kind == "wkt":
            try:
                text = to_wkt(result)
            except FormatError as error:
                raise FormatError(f"{error}; use --json, or --round") from None
        else:
            text = report(result, terminal and terminal.columns, everything=form.everything)
    if form.kind == "to":
        export(regions, fits, form.target, form.rounding, form.output, side_of)
    elif form.kind == "report":
        write(text, form.output)
    else:
        write_readable(text, form.output)
