"""`exactsweep ifp`."""

import click

from exactsweep import Point, Region, free_positions
from exactsweep.cli.options import PATH
from exactsweep.cli.pair import read_placed, takes_shapes
from exactsweep.cli.result import Form, takes_form, write_result

_takes_placed = click.option(
    "--placed",
    multiple=True,
    type=PATH,
    metavar="FILE",
    help="Polygons that PART must not overlap either; may be repeated.",
)


@click.command("ifp")
@takes_shapes("CONTAINER", "PART", read_placed, _takes_placed)
@takes_form("the positions")
def ifp_command(shapes: tuple[Region, Region, list[Region]], reference: Point, form: Form) -> None:
    """Find all positions of a part inside a container.

        exactsweep ifp CONTAINER PART            first stays, second moves

    With --placed FILE, once or several times, PART also stays clear of the polygons in these files,
    in their positions in the files.

    Holes of CONTAINER are defects, which PART has to avoid. The answer has regions of positions,
    perhaps with holes, and exact fits, at which CONTAINER is exactly as wide as PART. It is empty
    if PART does not fit.

    The command reads files as 'exactsweep sweep' does. --wkt writes a POLYGON for each region and a
    LINESTRING or a POINT for each exact fit, or POLYGON EMPTY. It refuses coordinates that are not
    finite decimals.

    Example:
      exactsweep ifp sheet.json part.wkt
      exactsweep ifp sheet.json part.wkt --placed first.wkt --placed others.dxf --json
      exactsweep ifp sheet.json part.wkt --certificate -o proof.json
    """
    container, part, placed = shapes
    write_result(free_positions(container, placed, part, reference=reference), form)
