"""`exactsweep sweep`."""

import click

from exactsweep import Sweep
from exactsweep.cli.output import takes_output, terminal_size, write
from exactsweep.cli.pair import takes_pair
from exactsweep.formats import FormatError
from exactsweep.text.results import certificate_to_json, sweep_to_json, sweep_to_wkt


@click.command("sweep")
@takes_pair
@click.option("--json", "as_json", is_flag=True, help="Write everything, exactly, as JSON.")
@click.option("--wkt", "as_wkt", is_flag=True, help="Write the three loops, exactly, as WKT.")
@click.option(
    "--certificate",
    is_flag=True,
    help="Write everything, and the reasons, as JSON for 'exactsweep verify'.",
)
@takes_output
def sweep_command(
    result: Sweep, as_json: bool, as_wkt: bool, certificate: bool, output: str
) -> None:
    """Sweep one polygon around another.

    GENERATRIX goes round DIRECTRIX, in contact all the way, and never overlapping. Each is a file,
    or - for standard input: JSON (a list of pairs or an object with such a list as "vertices"),
    GeoJSON, WKT, SVG or DXF. Of a file with several polygons, FILE#NAME chooses one by its name,
    its index from 0 or its layer. Decimals are read exactly; JSON may hold fractions, too, as
    strings such as "-7/2". Without files, a built-in example is swept.

    WKT has no fractions: --wkt writes the trajectory, the inner and the outer loop, a POLYGON a
    line, if all their coordinates are finite decimals, and is refused otherwise.
    """
    formats = {"--json": as_json, "--wkt": as_wkt, "--certificate": certificate}
    chosen = [option for option, given in formats.items() if given]
    if len(chosen) > 1:
        raise click.UsageError(f"{chosen[0]} and {chosen[1]} exclude each other.")
    if as_json:
        text = sweep_to_json(result)
    elif certificate:
        text = certificate_to_json(result)
    elif as_wkt:
        try:
            text = sweep_to_wkt(result)
        except FormatError as error:
            raise FormatError(f"{error}; use --json") from None
    else:
        # rich takes longer to import than all the rest.
        from exactsweep.text.report import report

        terminal = terminal_size(output)
        text = report(result, terminal and terminal.columns)
    write(text, output)
