"""The command `exactsweep overlap`."""

from itertools import combinations

import click

from exactsweep import overlap
from exactsweep.cli.options import PATH, takes_output
from exactsweep.cli.output import measure_columns, write, write_readable
from exactsweep.cli.pair import ReadingOptions, keep_coordinates, read_each, takes_reading
from exactsweep.cli.parts import read_named
from exactsweep.cli.working import working
from exactsweep.formats import FormatError, NamedRegion, show_path


def _list_pairs(
    a: str, b: str | None, reading: ReadingOptions
) -> list[tuple[NamedRegion, NamedRegion]]:
    if b is not None:
        first, second = read_each(a, b, reading)
        return [(one, other) for one in first for other in second]
    found = read_named([a], reading)
    keep_coordinates(found.coordinates)
    if len(found) < 2:
        raise FormatError(f"{show_path(a)}: contains a single polygon; give a second file")
    return [*combinations(found, 2)]


@click.command("overlap")
@click.argument("a", metavar="A", type=PATH)
@click.argument("b", metavar="[B]", required=False, type=PATH)
@click.option("--json", is_flag=True, help="Write the exact result as JSON.")
@takes_reading
@takes_output
def overlap_command(
    a: str, b: str | None, json: bool, reading: ReadingOptions, output: str
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
