"""Output of sweeps and fits as a report, JSON, WKT, a certificate or polygons."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from pathlib import PurePath
from typing import NamedTuple

import click

from exactsweep import InnerFit, NoFitPolygon, NoFitUnion, Sweep
from exactsweep.cli.export import export, takes_format, takes_rounding
from exactsweep.cli.options import Decorator, gather, takes_output
from exactsweep.cli.output import measure_columns, write, write_readable
from exactsweep.cli.pair import coordinates_of_files, errors_of_files, name_files
from exactsweep.cli.parts import print_notes
from exactsweep.cli.working import working
from exactsweep.formats import FORMATS, FormatError, NamedRegion, format_polygons
from exactsweep.formats.rounding import Rounding, Side
from exactsweep.numbers.number import Fit
from exactsweep.text import report as reports
from exactsweep.text import results
from exactsweep.text.report import approximate


class Form(NamedTuple):
    """The requested form of a result.

    `kind` is "report", "json", "wkt", "certificate", or "to" for polygons in the format `target`.
    """

    kind: str
    target: str
    rounding: Rounding | None
    output: str
    everything: bool


def _make_form(
    json: bool,
    wkt: bool,
    certificate: bool,
    target: str | None,
    everything: bool,
    rounding: Rounding | None,
    output: str,
) -> Form:
    given = {"json": json, "wkt": wkt, "certificate": certificate, "to": target}
    chosen = [name for name, value in (given | {"all": everything}).items() if value]
    if len(chosen) > 1:
        raise click.UsageError(f"--{chosen[0]} and --{chosen[1]} exclude each other.")
    kind = chosen[0] if chosen else "report"
    suffix = PurePath(output).suffix[1:].lower()
    if kind == "report" and suffix in FORMATS:
        kind, target = "to", suffix
    if target == "json" and rounding is None:
        kind = "json"
    if rounding is not None:
        if kind not in ("json", "wkt", "to"):
            raise click.UsageError("--round needs --to FORMAT, --json or --wkt.")
        kind, target = "to", target or kind
    return Form(kind, target or "", rounding, output, everything)


def takes_form(wkt: str) -> Decorator:
    """Add the options for output forms, as `form`; `wkt` describes the output of --wkt."""
    return gather(
        "form",
        _make_form,
        click.option("--json", is_flag=True, help="Write the exact result as JSON."),
        click.option("--wkt", is_flag=True, help=f"Write {wkt} as exact WKT."),
        click.option(
            "--certificate",
            is_flag=True,
            help="Write the result with its proof as JSON, for 'exactsweep verify'.",
        ),
        click.option("--all", "everything", is_flag=True, help="List all vertices in the report."),
        takes_format,
        takes_rounding,
        takes_output,
    )


class _Writers(NamedTuple):
    """Functions that write a kind of result, and the safe side for rounding a region."""

    to_json: Callable[..., str]
    to_regions: Callable[..., list[NamedRegion]]
    report: Callable[..., str]
    side_of: Callable[[NamedRegion], Side]


def _find_side(region: NamedRegion) -> Side:
    return "inward" if (region.name or "").startswith(("inner", "unswept")) else "outward"


_WRITERS: dict[type, _Writers] = {
    Sweep: _Writers(
        results.sweep_to_json,
        results.sweep_to_regions,
        reports.report,
        _find_side,
    ),
    NoFitPolygon: _Writers(
        results.no_fit_to_json,
        results.no_fit_to_regions,
        reports.report_no_fit,
        lambda region: "outward",
    ),
    InnerFit: _Writers(
        results.regions_to_json,
        results.name_regions,
        reports.report_regions,
        lambda region: "inward",
    ),
}
_WRITERS[NoFitUnion] = _WRITERS[InnerFit]._replace(side_of=lambda region: "outward")


def describe_error(error: Fraction) -> str:
    """Describe the errors of curves at the end of a report; return "" without curves."""
    if not error:
        return ""
    about = approximate(error, up=True)
    return f"note: curves are flattened; results are exact except within {about} of a boundary\n"


def write_wkt(regions: Sequence[NamedRegion], fits: Sequence[Fit] = ()) -> str:
    """Write polygons and exact fits as exact WKT, in the coordinates of the input."""
    try:
        return format_polygons(regions, "wkt", fits) if regions or fits else "POLYGON EMPTY\n"
    except FormatError as error:
        raise FormatError(f"{error}; use --json, or --round") from None


def write_result(result: Sweep | NoFitPolygon | NoFitUnion | InnerFit, form: Form) -> None:
    """Write a result in the requested form."""
    columns, writers = measure_columns(form.output), _WRITERS[type(result)]
    first, second = errors_of_files()
    # The second file of a sweep contains the stationary polygon.
    stays, moves = (second, first) if isinstance(result, Sweep) else (first, second)
    bound = stays + moves
    with working("computing"):
        match form.kind:
            case "to" | "wkt":
                fits = () if isinstance(result, Sweep) else result.exact_fits
                regions = writers.to_regions(result, stays, moves)
            case "json":
                text = writers.to_json(result, bound)
            case "certificate":
                text = results.certificate_to_json(result)
                if bound:
                    print_notes(["the certificate is about the flattened curves"])
            case _:
                files = name_files()
                text = writers.report(result, columns, everything=form.everything, files=files)
                text += describe_error(bound)
    if form.kind == "wkt":
        write_readable(write_wkt(regions, fits), form.output)
    elif form.kind == "to":
        if not regions and not fits:
            raise FormatError("the part does not fit; --json and --wkt write an empty answer")
        export(regions, fits, form.target, form.rounding, form.output, writers.side_of)
    elif form.kind == "report":
        write(text, form.output)
    else:
        write_readable(text, form.output)
        if form.kind == "json" and coordinates_of_files().y_down:
            print_notes(["Y points down in the output, as in the files; read it with --y-down"])
