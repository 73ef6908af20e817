"""`exactsweep convert`."""

from fractions import Fraction
from pathlib import PurePath

import click

from exactsweep.cli.output import takes_output, write
from exactsweep.cli.pair import PATH, takes_nested, takes_tolerance
from exactsweep.formats import (
    FORMATS,
    FormatError,
    file_name,
    format_polygons,
    read_regions,
    rounded_polygons,
)
from exactsweep.words import count


@click.command("convert")
@click.argument("file", type=PATH)
@click.option(
    "--to",
    "form",
    type=click.Choice(FORMATS),
    help="The format; that of the ending of the output's name if left out.",
)
@click.option(
    "--round",
    "places",
    type=click.IntRange(0, 4000),
    metavar="PLACES",
    help="Round to so many decimal places, and say on standard error what that changed.",
)
@takes_nested
@takes_tolerance
@takes_output
def convert_command(
    file: str,
    form: str | None,
    places: int | None,
    nested: bool,
    tolerance: Fraction | None,
    output: str,
) -> None:
    """Write the polygons of a file in another format.

    FILE is read as by 'exactsweep sweep', but with all its polygons, or just the one after a #,
    their holes, names and layers. What is written is exactly what was read, or nothing: WKT,
    GeoJSON, SVG and DXF hold finite decimals only, and 1/3 is none. --round makes decimals of all
    coordinates. DXF has no holes: their rings become polylines like the exterior.
    """
    form = form or PurePath(output).suffix[1:].lower()
    if form not in FORMATS:
        raise click.UsageError(f"Give --to, one of {', '.join(FORMATS)}.")
    polygons = read_regions(file, tolerance, nested=nested)
    try:
        if places is not None:
            polygons, changed, largest = rounded_polygons(polygons, places)
        text = format_polygons(polygons, form)
    except ValueError as error:
        hint = "; use --to json, or --round" if "finite decimal" in str(error) else ""
        raise FormatError(f"{file_name(file)}: {error}{hint}") from None
    write(text, output)
    holes = sum(len(polygon.region.holes) for polygon in polygons)
    if form == "dxf" and holes:
        click.echo(
            f"{count(holes, 'hole')} written as closed polylines, which --nested reads as holes",
            err=True,
        )
    if places is not None and changed:
        # rich takes longer to import than all the rest.
        from exactsweep.text.report import approximation

        click.echo(
            f"rounded: {count(changed, 'coordinate')}, the largest change about "
            f"{approximation(largest)}",
            err=True,
        )
