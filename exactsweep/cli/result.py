"""Output of results: reports, JSON, WKT, certificates, and polygons with optional rounding."""

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from pathlib import PurePath
from typing import NamedTuple

import click

from exactsweep import InnerFit, NoFitPolygon, NoFitUnion, Sweep
from exactsweep.cli.options import Decorator, gather, takes_output
from exactsweep.cli.output import measure_columns, write, write_readable
from exactsweep.cli.pair import coordinates_of_files, errors_of_files, name_files
from exactsweep.cli.parts import print_notes
from exactsweep.cli.working import working
from exactsweep.formats import FORMATS, FormatError, NamedRegion, format_polygons, round_regions
from exactsweep.formats.reading import INSUNITS
from exactsweep.formats.rounding import MAX_PLACES, Changes, Rounding, Side, contains, round_fits
from exactsweep.numbers.number import Fit
from exactsweep.text import report as reports
from exactsweep.text import results
from exactsweep.text.report import approximate
from exactsweep.words import count


def _make_rounding(places: int | None, outward: bool) -> Rounding | None:
    if outward and places is None:
        raise click.UsageError("--round-outward needs --round PLACES.")
    return None if places is None else Rounding(places, outward)


takes_rounding = gather(
    "rounding",
    _make_rounding,
    click.option(
        "--round",
        "places",
        type=click.IntRange(0, MAX_PLACES),
        metavar="PLACES",
        help="Round to this number of decimal places; standard error reports the changes.",
    ),
    click.option(
        "--round-outward",
        "outward",
        is_flag=True,
        help="With --round: forbidden regions only grow and free regions only shrink, so that the "
        "result provably permits no overlap.",
    ),
)

takes_format = click.option(
    "--to",
    "target",
    type=click.Choice(FORMATS),
    help="Write the polygons of the result in this format; default: by the suffix of -o. "
    "'--to json' is the same as '--json'.",
)


def export(
    regions: Sequence[NamedRegion],
    fits: Sequence[Fit],
    target: str,
    rounding: Rounding | None,
    output: str,
    side_of: Callable[[NamedRegion], Side],
) -> None:
    """Write polygons and exact fits, and report on standard error how rounding changed them.

    `side_of` is "outward" for forbidden regions, "inward" for free ones, and "closest" for others.
    """
    notes: list[str] = []
    has_error = any(region.error for region in regions)
    if rounding is not None:
        if rounding.outward and has_error:
            regions, fits = [*enlarge(regions, side_of)], ()
        wanted = side_of if rounding.outward else _closest
        with working("rounding"):
            rounded, changes = round_regions(regions, rounding.places, wanted)
        ends, moved = round_fits(fits, rounding)
        decides = any(side_of(region) != "closest" for region in regions)
        is_safe = rounding.outward or not (
            moved or has_error or not _is_safe(regions, rounded, side_of)
        )
        change = _describe_changes(changes, moved, rounding, decides and is_safe)
        if change and decides and not is_safe:
            change += "; it may permit an overlap (--round-outward does not)"
        notes = [change] if change else []
        if (regions or fits) and not (rounded or ends):
            places = rounding.places
            raise FormatError(f"rounding to {places} decimal places leaves nothing; use more")
        regions, fits = rounded, ends
    coordinates = coordinates_of_files()
    if target not in ("svg", "dxf") and click.get_current_context().params.get("y_down"):
        # These formats do not define the direction of Y, so --y-down applies to the output as well.
        coordinates = coordinates._replace(y_down=False)
    try:
        decimals = rounding is not None
        text = format_polygons(regions, target, fits, decimals=decimals, coordinates=coordinates)
    except FormatError as error:
        hint = "; use --to json, or --round" if "finite decimal" in str(error) else ""
        raise FormatError(f"{error}{hint}") from None
    write_readable(text, output)
    if coordinates.y_down != (target == "svg"):
        before, after = ("down", "up") if coordinates.y_down else ("up", "down")
        flipped = f"Y axis flipped: {before} in the input, {after} in {target.upper()}"
        notes = [flipped, *notes]
    if target == "dxf" and coordinates.unit not in (None, *INSUNITS.values()):
        notes.append("DXF has no code for this unit (--unit mm converts the numbers)")
    print_notes(notes)


def enlarge(
    regions: Sequence[NamedRegion], side_of: Callable[[NamedRegion], Side]
) -> Iterator[NamedRegion]:
    """Offset boundaries by the errors of curves, so that the result holds for the exact curves.

    Forbidden regions are dilated by an octagon around a disc whose radius is the error; free
    regions are eroded by it.
    """
    from exactsweep import Region, inner_fit_polygon, no_fit_polygon

    for one in regions:
        side, e = side_of(one), one.error
        if side == "closest" or not e:
            yield one
            continue
        # The sides are at distance e or more from the center, since (1 + 5/12)**2 > 2.
        f = e * Fraction(5, 12)
        octagon = [(e, f), (f, e), (-f, e), (-e, f), (-e, -f), (-f, -e), (f, -e), (e, -f)]
        if side == "outward":
            grown = no_fit_polygon(one.region, octagon)
            yield one._replace(region=Region(grown.exterior, grown.holes), error=Fraction(0))
        else:
            for region in inner_fit_polygon(one.region, octagon).regions:
                yield one._replace(region=region, error=Fraction(0))


def _closest(region: NamedRegion) -> Side:
    return "closest"


def _is_safe(
    old: Sequence[NamedRegion],
    new: Sequence[NamedRegion],
    side_of: Callable[[NamedRegion], Side],
) -> bool:
    for before, after in zip(old, new, strict=True):
        inner, outer = before.region, after.region
        side = side_of(before)
        if side == "inward":
            inner, outer = outer, inner
        if side != "closest" and not contains(outer, inner):
            return False
    return True


def _describe_changes(changes: Changes, moved: int, rounding: Rounding, is_safe: bool) -> str:
    if not changes.changed and not moved:
        return ""
    parts = [f"rounded: {count(changes.changed, 'polygon')}"]
    if changes.distance:
        parts.append(f"moved by at most {approximate(changes.distance, up=True)}")
    if moved:
        parts.append(f"{count(moved, 'exact fit')} {'dropped' if rounding.outward else 'moved'}")
    if changes.left_out:
        parts.append(f"{count(changes.left_out, 'ring')} vanished")
    if is_safe:
        parts.append("proved to permit no overlap")
    return ", ".join(parts)


class Form(NamedTuple):
    """The requested form: "report", "json", "wkt", "certificate", or "to" with a format."""

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
        raise click.UsageError(f"--{chosen[0]} and --{chosen[1]} cannot be combined.")
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
    if not error:
        return ""
    about = approximate(error, up=True)
    return f"note: curves are flattened; results are exact except within {about} of a boundary\n"


def write_wkt(regions: Sequence[NamedRegion], fits: Sequence[Fit] = ()) -> str:
    try:
        return format_polygons(regions, "wkt", fits) if regions or fits else "POLYGON EMPTY\n"
    except FormatError as error:
        raise FormatError(f"{error}; use --json, or --round") from None


def write_result(result: Sweep | NoFitPolygon | NoFitUnion | InnerFit, form: Form) -> None:
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
                    print_notes(["the certificate refers to the flattened curves"])
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
