"""The command `exactsweep ifp`."""

import json

import click

from exactsweep import InnerFit, Point, Region, free_positions
from exactsweep.cli.options import PATH
from exactsweep.cli.output import measure_columns, write, write_readable
from exactsweep.cli.pair import read_placed, takes_shapes
from exactsweep.cli.result import Form, takes_form, write_result
from exactsweep.cli.turns import Pose, takes_turns
from exactsweep.cli.working import working
from exactsweep.text.report import approximate, lay_out, make_table
from exactsweep.text.results import regions_to_json

_takes_placed = click.option(
    "--placed",
    multiple=True,
    type=PATH,
    metavar="FILE",
    help="Polygons, or a layout, that PART must not overlap; repeatable.",
)


@click.command("ifp")
@takes_shapes("CONTAINER", "PART", read_placed, _takes_placed)
@takes_turns("PART")
@takes_form("the positions")
def ifp_command(
    shapes: tuple[Region, list[Region], list[Region]],
    reference: Point,
    poses: list[Pose] | None,
    form: Form,
) -> None:
    """Find all positions of a part inside a container.

        exactsweep ifp CONTAINER PART            first stays, second moves

    With --placed, PART also avoids the polygons of other files, or all placed parts of a layout.
    With --turns or --mirrored, the report and --json have one line per pose.

    PART may be a group of an SVG file, as FILE#group, whose outlines move together. Holes of
    CONTAINER are defects, which PART avoids. The answer consists of regions of positions, possibly
    with holes, and of exact fits, where CONTAINER is exactly as wide as PART. It is empty if PART
    does not fit.

    Files are read as in 'exactsweep sweep'. --wkt writes a POLYGON for each region and a LINESTRING
    or POINT for each exact fit, or POLYGON EMPTY if there are none. It requires coordinates that
    are finite decimals.

    Example:
      exactsweep ifp sheet.json part.wkt
      exactsweep ifp sheet.json part.wkt --placed first.wkt --placed others.dxf --json
      exactsweep ifp sheet.json part.wkt --turns 0,90,180,270 --mirrored --placed nest.json
      exactsweep ifp sheet.json part.wkt --certificate -o proof.json
    """
    container, (part, *attached), placed = shapes
    if poses is None:
        answer = free_positions(container, placed, part, reference=reference, attached=attached)
        write_result(answer, form)
        return
    if form.kind not in ("report", "json"):
        raise click.UsageError(f"--{form.kind} is for a single pose.")
    found = []
    with working("positions") as update:
        for k, pose in enumerate(poses, 1):
            update(f"pose {k} of {len(poses)}")
            at = pose.place_point(reference)
            first, *others = map(pose.place, (part, *attached))
            found.append(free_positions(container, placed, first, reference=at, attached=others))
            # Results are computed on first access; do this here to show progress.
            _ = found[-1].regions
    if form.kind == "json":
        lines = (
            {"turn": pose.turn.to_json(), "mirrored": pose.mirrored, "fits": bool(fit)}
            | json.loads(regions_to_json(fit))
            for pose, fit in zip(poses, found, strict=True)
        )
        write_readable("".join(json.dumps(line) + "\n" for line in lines), form.output)
    else:
        write(_list(poses, found, form.output), form.output)


def _list(poses: list[Pose], found: list[InnerFit], output: str) -> str:
    """Return a table with a row for each pose, including its leftmost position."""
    numbers = ("regions", "exact fits", "area about")
    table = make_table(("turn", "fits", *numbers, "leftmost position"), numbers)
    for pose, fit in zip(poses, found, strict=True):
        points = [p for region in fit.regions for p in region.exterior.vertices]
        points += [p for ends in fit.exact_fits for p in ends]
        first = f"({', '.join(map(approximate, min(points)))})" if points else ""
        sizes = (len(fit.regions), len(fit.exact_fits))
        fits = "yes" if fit else "no"
        table.add_row(pose.name, fits, *map(str, sizes), approximate(fit.area), first)
    return lay_out([table], measure_columns(output))
