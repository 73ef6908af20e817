"""The command `exactsweep nfp`."""

from fractions import Fraction
from itertools import product

import click

from exactsweep import NoFitPolygon, Point, no_fit_polygon, no_fit_union
from exactsweep.cli.export import export
from exactsweep.cli.output import measure_columns, write, write_readable
from exactsweep.cli.pair import (
    ReadingOptions,
    errors_of_files,
    keep_errors,
    read_each,
    takes_shapes,
)
from exactsweep.cli.parts import print_notes
from exactsweep.cli.result import Form, describe_error, takes_form, write_result
from exactsweep.cli.turns import Pose, takes_turns
from exactsweep.cli.working import working
from exactsweep.formats import NamedRegion, show_path
from exactsweep.geometry.turn import read_turn
from exactsweep.numbers.digits import format_fraction
from exactsweep.text.report import approximate, lay_out, make_table
from exactsweep.text.results import no_fit_to_regions

_AS_READ = Pose(read_turn(0))

_takes_together = click.option(
    "--together",
    is_flag=True,
    help="Treat all polygons of STATIONARY as one rigid shape, and those of ORBITING as another.",
)

_Rigid = tuple[NamedRegion, ...]
"""Polygons that form one rigid shape."""


def _read_shapes(
    stays: str, moves: str, together: bool, reading: ReadingOptions
) -> list[list[_Rigid]]:
    """Read the rigid shapes of two files: single polygons, or all polygons of a group."""
    shapes: list[list[_Rigid]] = []
    sides = read_each(stays, moves, reading, whole=together)
    for path, side in zip((stays, moves), sides, strict=True):
        shapes.append([tuple(side)] if together or side.is_group else [(one,) for one in side])
        if len(shapes[-1]) > 1:
            number = f"{show_path(path)}: {len(side)} polygons"
            print_notes([f"{number}, each handled separately; --together treats all as one shape"])
    return shapes


@click.command("nfp")
@takes_shapes("STATIONARY", "ORBITING", _read_shapes, _takes_together)
@takes_turns("ORBITING")
@takes_form("the no-fit polygon and the exact fits")
def nfp_command(
    shapes: list[list[_Rigid]], reference: Point, poses: list[Pose] | None, form: Form
) -> None:
    """Compute the no-fit polygon of a pair, or of several pairs.

    The no-fit polygon is the set of positions at which ORBITING overlaps STATIONARY. It has an
    exterior, the trajectory of a sweep; holes, where ORBITING fits into a cave or a hole; and exact
    fits, which are positions and segments of positions without room to either side.

        exactsweep nfp   STATIONARY ORBITING     first stays, second moves
        exactsweep sweep GENERATRIX DIRECTRIX    first moves, second stays

    With --together, all polygons of STATIONARY form one rigid shape, and so do those of ORBITING.
    FILE#group of an SVG file is always a rigid shape. The positions of overlap are then regions.

    Files are read as in 'exactsweep sweep'. Each argument may also be a folder or a pattern; with
    --turns or --mirrored, each pose of ORBITING forms a pair. For several pairs, the report and
    --json have one line per pair, and --to writes all polygons.

    --wkt writes a POLYGON with its holes, and a LINESTRING or a POINT for each exact fit, if all
    coordinates are finite decimals.

    Example:
      exactsweep nfp plate.json fork.wkt
      exactsweep nfp sheet.dxf#0 parts.svg#bracket --reference 1/2 0 --json -o result.json
      exactsweep nfp plate.json fork.wkt --turns 0,90,180,270 --mirrored
      exactsweep nfp sheet.dxf#0 part.svg --to dxf --round 3 --round-outward -o nfp.dxf
    """
    keep_errors(*(max(one.error for group in side for one in group) for side in shapes))
    posed = [(g, pose) for g in shapes[1] for pose in poses or (_AS_READ,)]
    if any(len(group) > 1 for side in shapes for group in side):
        if len(shapes[0]) * len(posed) > 1:
            raise click.UsageError("Groups need a single pair and pose: use # or --together.")
        ((stationary,), ((orbiting, pose),)) = shapes[0], posed
        at, moved = pose.place_point(reference), [pose.place(one.region) for one in orbiting]
        write_result(no_fit_union([one.region for one in stationary], moved, reference=at), form)
        return
    turned = [
        (pose.place_point(reference), g if poses is None else _turn(g, pose))
        for (g,), pose in posed
    ]
    pairs = [(d, g) for (d,) in shapes[0] for _, g in turned]
    found = []
    with working("no-fit polygons") as update:
        for k, ((d,), (at, g)) in enumerate(product(shapes[0], turned), 1):
            update(f"no-fit polygon {k} of {len(pairs)}")
            found.append(no_fit_polygon(d.region, g.region, reference=at))
            # Results are computed on first access; do this here to show progress.
            _ = found[-1].holes
    if len(pairs) == 1:
        write_result(found[0], form)
        return
    names = [(str(d.name), str(g.name)) for d, g in pairs]
    errors = [(d.error, g.error) for d, g in pairs]
    if form.kind == "to":
        regions = [
            one._replace(name=f"{g} around {d}")
            for (d, g), result, error in zip(names, found, errors, strict=True)
            for one in no_fit_to_regions(result, *error)
        ]
        fits = [fit for result in found for fit in result.exact_fits]
        export(regions, fits, form.target, form.rounding, form.output, lambda region: "outward")
    elif form.kind == "json":
        from exactsweep.batch.record import write_result_line

        bound = Fraction(sum(errors_of_files()))
        known = {"curve_error": format_fraction(bound)} if bound else {}
        lines = (
            write_result_line(k, {"generatrix": g, "directrix": d} | known, result, "nfp")
            for k, ((d, g), result) in enumerate(zip(names, found, strict=True))
        )
        write_readable(b"".join(lines).decode(), form.output)
    elif form.kind == "report":
        error = sum(errors_of_files())
        write(_list(names, found, form.output) + describe_error(Fraction(error)), form.output)
    else:
        raise click.UsageError(f"--{form.kind} is for a single pair, not for {len(pairs)}.")


def _turn(part: NamedRegion, pose: Pose) -> NamedRegion:
    name = f"{part.name} rotated by {pose.name}"
    return part._replace(name=name, region=pose.place(part.region))


def _list(names: list[tuple[str, str]], found: list[NoFitPolygon], output: str) -> str:
    numbers = ("vertices", "holes", "exact fits", "area about")
    table = make_table(("stationary", "orbiting", "class", *numbers), numbers)
    for (d, g), n in zip(names, found, strict=True):
        sizes = (len(n.exterior), len(n.holes), len(n.exact_fits))
        table.add_row(d, g, n.kind, *map(str, sizes), approximate(n.area))
    return lay_out([table], measure_columns(output))
