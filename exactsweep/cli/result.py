"""The result of a sweep or a fit: as a report, as JSON or WKT, as a certificate, as polygons."""

from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

import click

from exactsweep import InnerFit, NoFitPolygon, Sweep
from exactsweep.cli.export import export, takes_format, takes_rounding
from exactsweep.cli.options import Decorator, gather, takes_output
from exactsweep.cli.output import measure_columns, write, write_readable
from exactsweep.cli.pair import errors_of_files
from exactsweep.cli.parts import say_all
from exactsweep.cli.working import working
from exactsweep.formats import FormatError, NamedRegion
from exactsweep.formats.rounding import Rounding, Side
from exactsweep.text import report as reports
from exactsweep.text import results
from exactsweep.text.report import approximate


class Form(NamedTuple):
    """The form in which a result is wanted.

    Attributes:
        kind: "report", "json", "wkt", "certificate", "proof", or "to".
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


def _make_form(
    json: bool,
    wkt: bool,
    certificate: bool,
    proof: bool,
    target: str | None,
    everything: bool,
    rounding: Rounding | None,
    output: str,
) -> Form:
    given = {"json": json, "wkt": wkt, "certificate": certificate, "proof": proof, "to": target}
    chosen = [name for name, value in (given | {"all": everything}).items() if value]
    if len(chosen) > 1:
        raise click.UsageError(f"--{chosen[0]} and --{chosen[1]} exclude each other.")
    kind = chosen[0] if chosen else "report"
    if rounding is not None:
        if kind not in ("json", "wkt", "to"):
            raise click.UsageError("--round goes with --to FORMAT, --json or --wkt.")
        kind, target = "to", target or kind
    return Form(kind, target or "", rounding, output, everything)


def takes_form(wkt: str) -> Decorator:
    """Give a command the options of its answer, as `form`; --wkt writes what is named."""
    return gather(
        "form",
        _make_form,
        click.option("--json", is_flag=True, help="Write everything, exactly, as JSON."),
        click.option("--wkt", is_flag=True, help=f"Write {wkt}, exactly, as WKT."),
        click.option(
            "--certificate",
            is_flag=True,
            help="Write everything, and the reasons, as JSON for 'exactsweep verify'.",
        ),
        click.option(
            "--proof",
            is_flag=True,
            help="Write a certificate with the proof that check/standalone.py reads.",
        ),
        click.option("--all", "everything", is_flag=True, help="Report all vertices."),
        takes_format,
        takes_rounding,
        takes_output,
    )


class _Writers(NamedTuple):
    """Functions that write a kind of result, and the side to which a region is rounded."""

    to_json: Callable[..., str]
    to_wkt: Callable[[Any], str]
    to_regions: Callable[..., list[NamedRegion]]
    report: Callable[..., str]
    side_of: Callable[[NamedRegion], Side]


def _find_side(region: NamedRegion) -> Side:
    return "inward" if (region.name or "").startswith(("inner", "unswept")) else "outward"


_WRITERS = {
    Sweep: _Writers(
        results.sweep_to_json,
        results.sweep_to_wkt,
        results.sweep_to_regions,
        reports.report,
        _find_side,
    ),
    NoFitPolygon: _Writers(
        results.no_fit_to_json,
        results.no_fit_to_wkt,
        results.no_fit_to_regions,
        reports.report_no_fit,
        lambda region: "outward",
    ),
    InnerFit: _Writers(
        results.inner_fit_to_json,
        results.inner_fit_to_wkt,
        results.inner_fit_to_regions,
        reports.report_inner_fit,
        lambda region: "inward",
    ),
}


def tell_error(error: Fraction) -> str:
    """Say at the end of a report what it is worth for curves; "" if there were none."""
    if not error:
        return ""
    about = approximate(error, up=True)
    return f"note: curves drawn as lines; free positions are certain {about} from the boundary\n"


def write_result(result: Sweep | NoFitPolygon | InnerFit, form: Form) -> None:
    """Write a result in a form of `takes_form`."""
    columns, writers = measure_columns(form.output), _WRITERS[type(result)]
    first, second = errors_of_files()
    # The second file of a sweep has the polygon that stays.
    stays, moves = (second, first) if isinstance(result, Sweep) else (first, second)
    bound = stays + moves
    with working("computing"):
        match form.kind:
            case "to":
                fits = () if isinstance(result, Sweep) else result.exact_fits
                regions = writers.to_regions(result, stays, moves)
            case "json":
                text = writers.to_json(result, bound)
            case "certificate" | "proof":
                text = results.certificate_to_json(result, proof=form.kind == "proof")
                if bound:
                    say_all(["the certificate is about the lines, not about the curves"])
            case "wkt":
                try:
                    text = writers.to_wkt(result)
                except FormatError as error:
                    raise FormatError(f"{error}; use --json, or --round") from None
            case _:
                text = writers.report(result, columns, everything=form.everything)
                text += tell_error(bound)
    if form.kind == "to":
        export(regions, fits, form.target, form.rounding, form.output, writers.side_of)
    elif form.kind == "report":
        write(text, form.output)
    else:
        write_readable(text, form.output)
