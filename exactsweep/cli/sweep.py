"""`exactsweep sweep`."""

import click

from exactsweep import Sweep
from exactsweep.cli.pair import takes_pair
from exactsweep.cli.result import Form, takes_form, write_result


@click.command("sweep")
@takes_pair
@takes_form("the loops")
def sweep_command(result: Sweep, form: Form) -> None:
    """Sweep one polygon around another.

    GENERATRIX goes around DIRECTRIX, always in contact and never overlapping:

        exactsweep sweep GENERATRIX DIRECTRIX    first moves, second stays
        exactsweep nfp   STATIONARY ORBITING     first stays, second moves

    Each is a file, or - for standard input: JSON (a list of pairs or an object with such a list as
    "vertices"), GeoJSON, WKT, CSV, SVG or DXF. Of a file with several polygons, FILE#NAME chooses
    one by its name, its index from 0 or its layer. Decimals are read exactly; JSON may hold
    fractions, too, as strings such as "-7/2". Without files, a built-in example is swept.

    A polygon may have any shape. One with holes is WKT with inner rings, or a JSON object with a
    list of pairs as "exterior" and a list of such lists as "holes".

    WKT has no fractions: --wkt writes the trajectory, the inner and the outer loop, and further
    holes of the swept area, a POLYGON a line, if all their coordinates are finite decimals, and is
    refused otherwise.

    Example:
      exactsweep sweep house.json block.wkt
      exactsweep sweep parts.svg#bracket sheet.dxf#0 --flatten 1/1000 --json -o result.json
    """
    write_result(result, form)
