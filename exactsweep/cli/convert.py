"""`exactsweep convert`."""

from pathlib import PurePath

import click

from exactsweep.cli.export import export, takes_rounding
from exactsweep.cli.options import PATH, takes_output
from exactsweep.cli.pair import ReadingOptions, keep_coordinates, takes_reading
from exactsweep.cli.parts import read_named
from exactsweep.formats import (
    FORMATS,
    FormatError,
    show_path,
)
from exactsweep.formats.rounding import Rounding, Side
from exactsweep.geometry.canonical import PolygonError
from exactsweep.words import count


@click.command("convert")
@click.argument("files", nargs=-1, required=True, type=PATH)
@click.option(
    "--to",
    "form",
    type=click.Choice(FORMATS),
    help="The format; by default that of the suffix of the output.",
)
@click.option(
    "--free",
    is_flag=True,
    help="With --round-outward: the polygons are free positions, which shrink.",
)
@takes_rounding
@takes_reading
@takes_output
def convert_command(
    files: tuple[str, ...],
    form: str | None,
    free: bool,
    rounding: Rounding | None,
    reading: ReadingOptions,
    output: str,
) -> None:
    """Write the polygons of files in another format.

    The command reads FILES as 'exactsweep sweep' does, but with all their polygons, or the choice
    after a #, and with holes, names and layers. A folder means all files in it, and a pattern such
    as 'parts/*.dxf' all matching files. Standard error lists the elements that cannot be read; if
    nothing is left, the exit code is 1.

    The output is exactly the input. WKT, GeoJSON, SVG and DXF hold finite decimals only, so they
    cannot hold 1/3. --round rounds all coordinates to decimals. DXF has no holes: their rings
    become polylines like the exterior.

    Example:
      exactsweep convert drawing.dxf --flatten 1/100 --join 1e-6 --unit mm -o parts.json
      exactsweep convert drawings --flatten 0.01 --nested -o parts.json
      exactsweep convert parts.json#0 --to wkt --round 6
    """
    form = form or PurePath(output).suffix[1:].lower()
    if form not in FORMATS:
        raise click.UsageError(f"Give --to, one of {', '.join(FORMATS)}.")
    polygons = read_named(files, reading, keep=True)
    keep_coordinates(polygons.coordinates)
    # The forbidden side of a part is unknown.
    side: Side = "closest"
    if rounding is not None and rounding.outward:
        side = "inward" if free else "outward"
    try:
        export(polygons, (), form, rounding, output, lambda region: side)
    except (FormatError, PolygonError) as error:
        raise FormatError(f"{', '.join(map(show_path, files))}: {error}") from None
    holes = sum(len(polygon.region.holes) for polygon in polygons)
    if form == "dxf" and holes:
        click.echo(
            f"{count(holes, 'hole')} written as closed polylines, which --nested reads as holes",
            err=True,
        )
