"""`exactsweep ifp`."""

import click

from exactsweep import Point, Region, free_positions
from exactsweep.cli.pair import takes_shapes
from exactsweep.cli.result import Form, takes_form, write_result
from exactsweep.formats import NamedRegion
from exactsweep.formats.rounding import Side
from exactsweep.text.report import report_inner_fit
from exactsweep.text.results import inner_fit_to_json, inner_fit_to_regions, inner_fit_to_wkt


@click.command("ifp")
@takes_shapes("CONTAINER", "PART", others="placed")
@takes_form("the positions")
def ifp_command(
    container: Region, part: Region, placed: list[Region], reference: Point, form: Form
) -> None:
    """Find all positions of a part inside a container.

    Given --placed FILE, once or several times, PART does not overlap the polygons of the files
    either. They stand where the files have them.

    Holes of CONTAINER are defects, which PART has to avoid. The answer has regions of positions,
    perhaps with holes, and exact fits, at which CONTAINER is exactly as wide as PART. It is empty
    where PART does not fit.

    Files are read as by 'exactsweep sweep'. --wkt writes a POLYGON for each region and a LINESTRING
    or a POINT for each exact fit, or POLYGON EMPTY, if all coordinates are finite decimals, and is
    refused otherwise.
    """
    result = free_positions(container, placed, part, reference=reference)
    write_result(
        result,
        form,
        to_json=inner_fit_to_json,
        to_wkt=inner_fit_to_wkt,
        to_regions=inner_fit_to_regions,
        side_of=_side,
        report=report_inner_fit,
    )


def _side(region: NamedRegion) -> Side:
    return "inward"
