"""`exactsweep sum`."""

import click

from exactsweep import Polyline, Region, minkowski_sum
from exactsweep.cli.export import export, takes_format, takes_rounding
from exactsweep.cli.options import PATH, takes_output
from exactsweep.cli.output import measure_columns, write, write_readable
from exactsweep.cli.pair import ReadingOptions, read_two, takes_reading
from exactsweep.cli.working import working
from exactsweep.formats import FormatError, NamedRegion, read_text
from exactsweep.formats.paths import parse_path
from exactsweep.formats.polygons import name_file, parse_region, read_region, split_choice
from exactsweep.formats.rounding import Rounding


def _read(
    a: str, b: str, as_path: bool, reading: ReadingOptions
) -> tuple[Region, Region | Polyline]:
    """Read two polygons, or a polygon and a path."""
    file, choice = split_choice(b)
    if choice is None:
        text = read_named_text(file)
        path = parse_named_path(file, text, as_path)
        if path is not None:
            return read_region(a, **reading), path
        if as_path:
            raise click.UsageError("--path is for lists of points, LINESTRING and LineString.")
        if b == "-":
            with name_file(b):
                return read_region(a, **reading), parse_region(text, **reading)
    return read_two(a, b, reading)


def read_named_text(file: str) -> str:
    """Read a file; a message names it."""
    with name_file(file):
        return read_text(file)


def parse_named_path(file: str, text: str, as_path: bool) -> Polyline | None:
    """Read a path, if a text is one; a message names the file."""
    with name_file(file):
        return parse_path(text, is_list=as_path)


@click.command("sum")
@click.argument("a", metavar="A", type=PATH)
@click.argument("b", metavar="B", type=PATH)
@click.option(
    "--path",
    "as_path",
    is_flag=True,
    help="B is a path, also if it is a list of three points or more.",
)
@click.option("--json", is_flag=True, help="Write everything, exactly, as JSON.")
@click.option("--wkt", is_flag=True, help="Write the sum, exactly, as a WKT POLYGON.")
@takes_format
@takes_rounding
@takes_reading
@takes_output
def sum_command(
    a: str,
    b: str,
    as_path: bool,
    json: bool,
    wkt: bool,
    target: str | None,
    rounding: Rounding | None,
    reading: ReadingOptions,
    output: str,
) -> None:
    """Find a Minkowski sum, also with a path.

    The Minkowski sum consists of all sums of a point of A and a point of B. It may have holes. With
    a path as B it is the area that A covers when its origin follows the path. A path is a
    LINESTRING or POINT of WKT, a LineString or Point of GeoJSON, or a JSON list of two points; with
    --path a list of any number.

    The command reads files as 'exactsweep sweep' does.

    Example:
      exactsweep sum part.json tool.wkt
      exactsweep sum part.json line.wkt --json
      exactsweep sum part.json points.json --path --to svg -o covered.svg
    """
    if sum(map(bool, (json, wkt, target))) > 1:
        raise click.UsageError("--json, --wkt and --to exclude each other.")
    from exactsweep.text import pairs

    first, second = _read(a, b, as_path, reading)
    with working("computing"):
        found = minkowski_sum(first, second)
    if rounding is not None or target is not None:
        target = target or ("json" if json else "wkt" if wkt else None)
        if target is None:
            raise click.UsageError("--round goes with --to FORMAT, --json or --wkt.")
        export([NamedRegion(found, "sum")], (), target, rounding, output, lambda _: "outward")
    elif json:
        write_readable(pairs.sum_to_json(first, second, found), output)
    elif wkt:
        try:
            write_readable(pairs.sum_to_wkt(found), output)
        except FormatError as error:
            raise FormatError(f"{error}; use --json, or --round") from None
    else:
        write(pairs.report_sum(first, second, found, measure_columns(output)), output)
