from pathlib import PurePath

import click

from exactsweep.cli.options import PATH, takes_output
from exactsweep.cli.pair import ReadingOptions, keep_coordinates, takes_reading
from exactsweep.cli.parts import read_named
from exactsweep.cli.result import export, takes_rounding
from exactsweep.formats import FORMATS, FormatError, show_path
from exactsweep.formats.rounding import Rounding, Side
from exactsweep.geometry.canonical import PolygonError
from exactsweep.words import count


@click.command("convert")
@click.argument("files", nargs=-1, required=True, type=PATH)
@click.option(
    "--to",
    "form",
    type=click.Choice(FORMATS),
    help="Output format; default: by the suffix of the output.",
)
@click.option(
    "--free",
    is_flag=True,
    help="With --round-outward: the polygons are free regions, so they shrink.",
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
    """Convert polygons to another format.

    Reads all polygons in FILES, or one as FILE#NAME, with holes, names and layers. FILES may be
    folders and patterns such as 'parts/*.dxf'. Standard error lists skipped elements; the exit code
    is 1 if no polygon remains.

    The conversion is exact. WKT, GeoJSON, SVG and DXF can only represent finite decimals, so 1/3
    needs --round. In DXF, holes become polylines like the exterior.

    Example:
      exactsweep convert drawing.dxf --flatten 1/100 --join 1e-6 --unit mm -o parts.json
      exactsweep convert drawings --flatten 0.01 --nested -o parts.json
      exactsweep convert parts.json#0 --to wkt --round 6
    """
    form = form or PurePath(output).suffix[1:].lower()
    if form not in FORMATS:
        raise click.UsageError(f"Give a format: --to {', '.join(FORMATS)}.")
    polygons = read_named(files, reading, keep=True)
    keep_coordinates(polygons.coordinates)
    # Without --round-outward, boundaries may move to either side.
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
            f"{count(holes, 'hole')} written as closed polylines; read them with --nested",
            err=True,
        )
