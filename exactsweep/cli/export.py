"""Output of results as polygons, with optional rounding and a report of the changes."""

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction

import click

from exactsweep.cli.options import gather
from exactsweep.cli.output import write_readable
from exactsweep.cli.pair import coordinates_of_files
from exactsweep.cli.parts import print_notes
from exactsweep.cli.working import working
from exactsweep.formats import FORMATS, FormatError, NamedRegion, format_polygons, round_regions
from exactsweep.formats.reading import INSUNITS
from exactsweep.formats.rounding import MAX_PLACES, Changes, Rounding, Side, contains, round_fits
from exactsweep.numbers.number import Fit
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
"""Decorator: --round and --round-outward, as `rounding`, or None without them."""

takes_format = click.option(
    "--to",
    "target",
    type=click.Choice(FORMATS),
    help="Write the polygons of the result in this format; default: by the suffix of -o. "
    "'--to json' is the same as '--json'.",
)
"""Decorator: --to FORMAT, as `target`."""


def export(
    regions: Sequence[NamedRegion],
    fits: Sequence[Fit],
    target: str,
    rounding: Rounding | None,
    output: str,
    side_of: Callable[[NamedRegion], Side],
) -> None:
    """Write polygons and exact fits; report on standard error what rounding changed.

    Flips the Y axis if the format has another direction than the input; keeps the unit. `side_of`
    returns "outward" for a forbidden region, "inward" for a free one, and "closest" for others.
    Raises FormatError if the format cannot represent a coordinate, or rounding leaves nothing.
    """
    said: list[str] = []
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
        change = _say(changes, moved, rounding, decides and is_safe)
        if change and decides and not is_safe:
            change += "; it may permit an overlap (--round-outward does not)"
        said = [change] if change else []
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
        said = [flipped, *said]
    if target == "dxf" and coordinates.unit not in (None, *INSUNITS.values()):
        said.append("DXF has no code for this unit (--unit mm scales the numbers)")
    print_notes(said)


def enlarge(
    regions: Sequence[NamedRegion], side_of: Callable[[NamedRegion], Side]
) -> Iterator[NamedRegion]:
    """Offset boundaries by the errors of curves, so that the result holds for the exact curves.

    Forbidden regions grow by the Minkowski sum with an octagon around a disc whose radius is the
    error; free regions shrink by the erosion.
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


def _say(changes: Changes, moved: int, rounding: Rounding, is_safe: bool) -> str:
    """Describe in one line what rounding changed; return "" if nothing changed."""
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
