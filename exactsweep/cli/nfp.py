"""`exactsweep nfp`."""

import click

from exactsweep import NoFitPolygon, Point, Region, no_fit_polygon
from exactsweep.cli.pair import takes_shapes
from exactsweep.cli.result import Form, takes_form, write_result
from exactsweep.formats import NamedRegion
from exactsweep.formats.rounding import Side
from exactsweep.text.results import no_fit_to_json, no_fit_to_regions, no_fit_to_wkt


@click.command("nfp")
@takes_shapes("STATIONARY", "ORBITING")
@takes_form("the no-fit polygon and the exact fits")
def nfp_command(stationary: Region, orbiting: Region, reference: Point, form: Form) -> None:
    """Find the no-fit polygon of two polygons.

    That is where ORBITING overlaps STATIONARY: the exterior, which is the trajectory of a sweep;
    holes, where ORBITING fits into a cave or a hole; and exact fits, single positions and segments
    of them, at which it fits without any room.

    Files are read as by 'exactsweep sweep'. --wkt writes a POLYGON with its holes, and a LINESTRING
    or a POINT for each exact fit, if all coordinates are finite decimals, and is refused otherwise.
    """
    result = no_fit_polygon(stationary, orbiting, reference=reference)
    write_result(
        result,
        form,
        to_json=no_fit_to_json,
        to_wkt=no_fit_to_wkt,
        to_regions=no_fit_to_regions,
        side_of=_side,
        report=_report,
    )


def _side(region: NamedRegion) -> Side:
    return "outward"


def _report(result: NoFitPolygon, width: int | None, everything: bool) -> str:
    # rich takes longer to import than all the rest.
    from exactsweep.text.report import no_fit_report

    return no_fit_report(result, width, everything=everything)
