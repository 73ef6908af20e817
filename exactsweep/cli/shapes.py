from contextlib import suppress
from itertools import combinations

import click

from exactsweep import Polyline, Region, minkowski_sum, overlap
from exactsweep.cli import pair
from exactsweep.cli.options import PATH, takes_output
from exactsweep.cli.output import measure_columns, write, write_readable
from exactsweep.cli.parts import read_named, report_error, report_skipped
from exactsweep.cli.result import export, takes_format, takes_rounding, write_wkt
from exactsweep.cli.working import working
from exactsweep.formats import FormatError, NamedRegion, polygons, read_text, show_path
from exactsweep.formats.candidate import Candidate
from exactsweep.formats.paths import parse_path
from exactsweep.formats.reading import Reading
from exactsweep.formats.rounding import Rounding


def _read(
    a: str, b: str, as_path: bool, reading: pair.ReadingOptions
) -> tuple[Region, Region | Polyline]:
    file, choice = polygons.split_choice(b)
    if choice is None:
        with polygons.prefix_path(file):
            text = read_text(file)
            path = parse_path(text, is_list=as_path, reading=Reading(**reading))
        if path is not None:
            return _read_with_path(a, file, path, text.lstrip().startswith("<"), reading)
        if as_path:
            raise click.UsageError(
                f"{show_path(file)} is not a path; --path reads lists of points, LINESTRING, "
                "LineString and SVG paths."
            )
        if b == "-":
            with polygons.prefix_path(b):
                return polygons.read_region(a, **reading), polygons.parse_region(text, **reading)
    elif as_path:
        raise click.UsageError("--path reads whole files; omit the # and the name.")
    return pair.read_two(a, b, reading)


def _is_path(file: str) -> bool:
    with suppress(FormatError):
        return file != "-" and parse_path(read_text(file)) is not None
    return False


def _read_with_path(
    a: str, file: str, path: Polyline, is_svg: bool, reading: pair.ReadingOptions
) -> tuple[Region, Polyline]:
    """Read the polygon to be added to a path, with Y up if their Y axes differ in direction."""
    name, found = show_path(polygons.split_choice(a)[0]), polygons.read_choice(a, **reading)
    report_skipped([f"{name}: {reason}" for reason in found.left_out])
    notes = [f"{name}: {note}" for note in found.notes]
    y_down = is_svg if reading["y_down"] is None else reading["y_down"]
    coordinates = found.coordinates
    if coordinates.y_down and not y_down:
        found[:] = [one.flipped() for one in found]
        notes.append(f"{name}: Y axis flipped, because {show_path(file)} has Y up")
    elif y_down and not coordinates.y_down:
        path = Polyline([(x, -y) for x, y in path.points], closed=path.closed)
        notes.append(f"{show_path(file)}: Y axis flipped, because {name} has Y up")
    pair.keep_coordinates(coordinates._replace(y_down=coordinates.y_down and y_down), notes)
    pair.keep_errors(found[0].error)
    report_error(found[0].error, reading)
    with polygons.prefix_path(name):
        return polygons.read_single(found[0], Candidate.region), path


@click.command("sum")
@click.argument("a", metavar="A", type=PATH)
@click.argument("b", metavar="B", type=PATH)
@click.option(
    "--path",
    "as_path",
    is_flag=True,
    help="Read B as a path even if it is a list of three or more points.",
)
@click.option("--json", is_flag=True, help="Write the exact result as JSON.")
@click.option("--wkt", is_flag=True, help="Write the sum as an exact WKT POLYGON.")
@click.option(
    "--certificate",
    is_flag=True,
    help="Write a certificate for 'exactsweep verify'. For two polygons, it certifies the no-fit "
    "polygon of A and -B, which has the same boundary.",
)
@takes_format
@takes_rounding
@pair.takes_reading
@takes_output
def sum_command(
    a: str,
    b: str,
    as_path: bool,
    json: bool,
    wkt: bool,
    certificate: bool,
    target: str | None,
    rounding: Rounding | None,
    reading: pair.ReadingOptions,
    output: str,
) -> None:
    """Compute a Minkowski sum.

    The Minkowski sum consists of all sums of a point of A and a point of B. It may have holes. If B
    is a path, the sum is the area that A covers while its origin follows the path. A path is a WKT
    LINESTRING or POINT, a GeoJSON LineString or Point, an SVG file with one open path of straight
    segments without a fill, or a JSON list of two points. With --path, it may also be a longer
    list, or a filled or closed SVG path.

    The Minkowski difference, or erosion, of A by B consists of all positions of B inside A; use
    'exactsweep ifp A B'.

    Files are read as in 'exactsweep sweep'.

    Example:
      exactsweep sum part.json tool.wkt
      exactsweep sum part.json line.wkt --json
      exactsweep sum part.json points.json --path --to svg -o covered.svg
    """
    if sum(map(bool, (json, wkt, target, certificate))) > 1:
        raise click.UsageError("Give only one of --json, --wkt, --certificate and --to.")
    from exactsweep.text import pairs

    try:
        first, second = _read(a, b, as_path, reading)
    except FormatError:
        if _is_path(a):
            raise click.UsageError(f"{show_path(a)} is a path; give it second, as B.") from None
        raise
    if certificate:
        from exactsweep.text.results import certificate_to_json

        with working("proving"):
            proof = certificate_to_json(minkowski_sum(first, second))
        write_readable(proof, output)
        return
    with working("computing"):
        found = minkowski_sum(first, second)
    if rounding is not None or target is not None:
        target = target or ("json" if json else "wkt" if wkt else None)
        if target is None:
            raise click.UsageError("--round needs --to FORMAT, --json or --wkt.")
        export([NamedRegion(found, "sum")], (), target, rounding, output, lambda _: "outward")
    elif json:
        write_readable(pairs.sum_to_json(first, second, found), output)
    elif wkt:
        write_readable(write_wkt([NamedRegion(found, "sum")]), output)
    else:
        write(pairs.report_sum(first, second, found, measure_columns(output)), output)


def _list_pairs(
    a: str, b: str | None, reading: pair.ReadingOptions
) -> list[tuple[NamedRegion, NamedRegion]]:
    if b is not None:
        first, second = pair.read_each(a, b, reading)
        return [(one, other) for one in first for other in second]
    found = read_named([a], reading)
    pair.keep_coordinates(found.coordinates)
    if len(found) < 2:
        raise FormatError(f"{show_path(a)}: contains a single polygon; give a second file")
    return [*combinations(found, 2)]


@click.command("overlap")
@click.argument("a", metavar="A", type=PATH)
@click.argument("b", metavar="[B]", required=False, type=PATH)
@click.option("--json", is_flag=True, help="Write the exact result as JSON.")
@pair.takes_reading
@takes_output
def overlap_command(
    a: str, b: str | None, json: bool, reading: pair.ReadingOptions, output: str
) -> None:
    """Compare polygons in place: overlap, area, depth.

    With one file, compares all pairs of its polygons; with two files, each polygon of A with each
    of B. The verdict is OVERLAP if interiors intersect, CONTACT if only boundaries do, and FREE
    otherwise. The depth is the length of the shortest translation of the second polygon that
    separates the interiors.

    For several pairs, the report and --json have one line for each pair that overlaps or touches.
    Files are read as in 'exactsweep sweep'.

    Example:
      exactsweep overlap first.wkt second.json
      exactsweep overlap nest.svg --flatten 0.01
      exactsweep overlap parts.dxf --json
    """
    from exactsweep.text import pairs as texts

    listed = _list_pairs(a, b, reading)
    columns = measure_columns(output)
    if len(listed) == 1:
        ((one, other),) = listed
        with working("computing"):
            o = overlap(one.region, other.region)
            text = texts.overlap_to_json(o) if json else texts.report_overlap(o, columns)
    else:
        found = []
        with working("overlaps") as update:
            for k, (one, other) in enumerate(listed, 1):
                update(f"pair {k} of {len(listed)}")
                o = overlap(one.region, other.region)
                if o.verdict != "FREE":
                    found.append(texts.NamedOverlap(str(one.name), str(other.name), o))
            free = len(listed) - len(found)
            text = (
                texts.overlaps_to_json(found)
                if json
                else texts.report_overlaps(found, free, columns)
            )
    if json:
        write_readable(text, output)
    else:
        write(text, output)
