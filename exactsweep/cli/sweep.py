"""The command `exactsweep sweep`."""

import click

from exactsweep import Sweep
from exactsweep.cli.pair import takes_pair
from exactsweep.cli.result import Form, takes_form, write_result


@click.command("sweep")
@takes_pair
@takes_form("the loops")
def sweep_command(result: Sweep, form: Form) -> None:
    """Sweep one polygon around another.

    GENERATRIX moves around DIRECTRIX, always in contact and never overlapping:

        exactsweep sweep GENERATRIX DIRECTRIX    first moves, second stays
        exactsweep nfp   STATIONARY ORBITING     first stays, second moves

    Each is a file, or - for standard input: JSON (a list of pairs, or an object with such a list as
    "vertices"), GeoJSON, WKT, CSV, SVG or DXF. FILE#NAME selects one of several polygons by name,
    index from 0 or layer. Decimals are read exactly; in JSON, strings such as "-7/2" are fractions.
    Without files, the command sweeps a built-in example.

    Polygons may have any shape. Holes are inner rings in WKT; in JSON, an object has an "exterior"
    and a list of rings as "holes".

    --wkt writes the trajectory, the inner and the outer loop, and other holes of the swept area,
    one POLYGON per line. WKT can only represent finite decimals; other coordinates need --round.

    Example:
      exactsweep sweep house.json block.wkt
      exactsweep sweep parts.svg#bracket sheet.dxf#0 --flatten 1/1000 --json -o result.json
    """
    write_result(result, form)
