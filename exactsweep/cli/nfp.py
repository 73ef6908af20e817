"""`exactsweep nfp`."""

from fractions import Fraction
from itertools import product

import click

from exactsweep import NoFitPolygon, Point, no_fit_polygon
from exactsweep.cli.export import export
from exactsweep.cli.output import measure_columns, write, write_readable
from exactsweep.cli.pair import errors_of_files, keep_errors, read_each, takes_shapes
from exactsweep.cli.result import Form, describe_error, takes_form, write_result
from exactsweep.cli.turns import Pose, takes_turns
from exactsweep.cli.working import working
from exactsweep.formats import NamedRegion
from exactsweep.geometry.turn import read_turn
from exactsweep.numbers.digits import format_fraction
from exactsweep.text.report import approximate, lay_out, make_table
from exactsweep.text.results import no_fit_to_regions

_AS_READ = Pose(read_turn(0))


@click.command("nfp")
@takes_shapes("STATIONARY", "ORBITING", read_each)
@takes_turns("ORBITING")
@takes_form("the no-fit polygon and the exact fits")
def nfp_command(
    shapes: tuple[list[NamedRegion], list[NamedRegion]],
    reference: Point,
    poses: list[Pose] | None,
    form: Form,
) -> None:
    """Compute the no-fit polygon of a pair, or of several pairs.

    The no-fit polygon is the set of positions where ORBITING overlaps STATIONARY. It has an
    exterior, the trajectory of a sweep; holes, where ORBITING fits into a cave or a hole; and exact
    fits, positions and segments of positions without room to either side.

        exactsweep nfp   STATIONARY ORBITING     first stays, second moves
        exactsweep sweep GENERATRIX DIRECTRIX    first moves, second stays

    The command reads files as 'exactsweep sweep' does. Each argument may also be a folder or a
    pattern; with --turns or --mirrored, each pose of ORBITING makes a pair. For several pairs the
    report and --json have one line per pair, and --to writes all polygons.

    --wkt writes a POLYGON with its holes, and a LINESTRING or a POINT for each exact fit, if all
    coordinates are finite decimals.

    Example:
      exactsweep nfp plate.json fork.wkt
      exactsweep nfp sheet.dxf#0 parts.svg#bracket --reference 1/2 0 --json -o result.json
      exactsweep nfp plate.json fork.wkt --turns 0,90,180,270 --mirrored
      exactsweep nfp sheet.dxf#0 part.svg --to dxf --round 3 --round-outward -o nfp.dxf
    """
    posed = [(g, pose) for g in shapes[1] for pose in poses or (_AS_READ,)]
    orbiting = [
        (pose.place_point(reference), g if poses is None else _turn(g, pose)) for g, pose in posed
    ]
    pairs = [(d, g) for d in shapes[0] for _, g in orbiting]
    keep_errors(*(max(one.error for one in shape) for shape in shapes))
    found = []
    with working("no-fit polygons") as update:
        for k, (d, (at, g)) in enumerate(product(shapes[0], orbiting), 1):
            update(f"no-fit polygon {k} of {len(pairs)}")
            found.append(no_fit_polygon(d.region, g.region, reference=at))
            # Computed on first access: here, for the progress.
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
    name = f"{part.name} turned by {pose.name}"
    return part._replace(name=name, region=pose.place(part.region))


def _list(names: list[tuple[str, str]], found: list[NoFitPolygon], output: str) -> str:
    numbers = ("vertices", "holes", "exact fits", "area about")
    table = make_table(("stationary", "orbiting", "class", *numbers), numbers)
    for (d, g), n in zip(names, found, strict=True):
        sizes = (len(n.exterior), len(n.holes), len(n.exact_fits))
        table.add_row(d, g, n.kind, *map(str, sizes), approximate(n.area))
    return lay_out([table], measure_columns(output))
