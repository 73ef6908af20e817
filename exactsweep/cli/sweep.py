from collections.abc import Callable

import click

from exactsweep import InnerFit, NoFitPolygon, Point, Sweep
from exactsweep.cli import pair
from exactsweep.cli.options import checked, requires_output, takes_output
from exactsweep.cli.output import measure_terminal, replace_file, write
from exactsweep.cli.result import Form, takes_form, write_result
from exactsweep.cli.working import working
from exactsweep.formats import show_path
from exactsweep.formats.files import prefix_os_errors
from exactsweep.numbers.error import prefix_errors
from exactsweep.words import spell_out


@click.command("sweep")
@pair.takes_pair
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


@click.command("explain")
@pair.takes_pair
@click.option("--json", "as_json", is_flag=True, help="Write the steps as exact JSON.")
@takes_output
def explain_command(result: Sweep, as_json: bool, output: str) -> None:
    """Explain a sweep step by step.

    Each edge of the trajectory is a step. For each, the explanation states the direction, both
    ends, the features in contact, why the step ends, and undercuts and exact fits along it. Then it
    describes the holes of the no-fit polygon and the exact fits. Vertices and edges are numbered as
    in the files; edge i runs from vertex i to the next.

    Files are read as in 'exactsweep sweep'; without files, the command explains the example.

    Example:
      exactsweep explain house.json block.wkt
    """
    from exactsweep.text.explanation import describe_steps
    from exactsweep.text.results import explanation_to_json

    with working("explaining the sweep"):
        lines = (
            [explanation_to_json(result)]
            if as_json
            else [f"{one}\n" for one in describe_steps(result)]
        )
        text = "".join(lines)
    terminal = measure_terminal(output)
    if terminal and text.count("\n") > terminal.lines:
        click.echo_via_pager(text)
    else:
        write(text, output)


def _require_suffix(path: str) -> str:
    from exactsweep.draw import read_suffix

    with prefix_errors(show_path(path)):
        read_suffix(path)
    return path


@click.command("draw")
@pair.takes_question
@pair.takes_pair
@click.option(
    "--position",
    "positions",
    nargs=2,
    multiple=True,
    callback=checked(lambda pairs: [*map(pair.to_point, pairs)]),
    metavar="X Y",
    help="Draw the generatrix with its reference point here; repeatable.",
)
@click.option("--title", help="Title of the picture.")
@click.option(
    "--size",
    nargs=2,
    type=click.FloatRange(min=1, max=100),
    metavar="WIDTH HEIGHT",
    help="Size in inches; default: 7.2 4.8.",
)
@requires_output("Output file, with the suffix .svg, .pdf or .png.", _require_suffix)
def draw_command(
    result: Sweep | NoFitPolygon | InnerFit,
    positions: list[Point],
    title: str | None,
    size: tuple[float, float] | None,
    output: str,
) -> None:
    """Draw a sweep, a no-fit polygon or an inner fit.

    The picture of a sweep shows both polygons, the inner and the outer loop, the trajectory in one
    color per contact event, hatched undercuts, exact fits, and the generatrix. The generatrix is
    drawn at each --position; by default, at positions that close undercuts, at exact fits and at
    the first vertex. Enlarged details of tiny or flat polygons are drawn below.

    The picture of a no-fit polygon or an inner fit shows all loops, free regions and exact fits.

    Files are read as in 'exactsweep sweep'; without files, the command draws the example.

    Example:
      exactsweep draw house.json block.wkt --position 13/5 13/5 -o block.svg
      exactsweep draw --of nfp block.wkt house.json -o nfp.svg
    """
    from exactsweep.draw import make_figure, plot_positions, plot_sweep, save

    figure = make_figure(size=size)
    (axes,) = figure.axes
    with working("sweeping"):
        y_down = pair.coordinates_of_files().y_down
        plot: Callable[..., object] = plot_sweep if isinstance(result, Sweep) else plot_positions
        plot(result, axes, positions=positions or None, y_down=y_down)
    if title:
        # Fonts lack unprintable characters, and a dollar sign starts a formula.
        axes.set_title(spell_out(title).replace("$", r"\$"), loc="left")
    with prefix_os_errors(output), working("drawing"), replace_file(output) as path:
        save(figure, path)


@click.command("view")
@pair.takes_question
@pair.takes_pair
@takes_output
def view_command(result: Sweep | NoFitPolygon | InnerFit, output: str) -> None:
    """Write an interactive HTML page.

    The page is one file that needs no network. The slider, the mouse or the keyboard moves the
    generatrix along the trajectory, around holes of the no-fit polygon and into exact fits. The
    page lists the contacts, and shows exact coordinates of vertices, undercuts and exact fits. With
    --of nfp or --of ifp, it shows a no-fit polygon or an inner fit.

    Files are read as in 'exactsweep sweep'; without files, the command shows the example.

    Example:
      exactsweep view house.json block.wkt -o sweep.html
      exactsweep view --of ifp sheet.json part.wkt -o fit.html
    """
    from exactsweep.view import make_page

    if output.lower().endswith((".svg", ".pdf", ".png")):
        raise click.UsageError("The page is HTML; use 'exactsweep draw' for pictures.")
    files = pair.name_files_of_pair()
    names = None if files is None else (show_path(files[0]), show_path(files[1]))
    if names and not isinstance(result, Sweep):
        # The stationary polygon is the first file.
        names = names[1], names[0]
    with working("making the page") as update:
        y_down = pair.coordinates_of_files().y_down
        text = make_page(result, names=names, y_down=y_down, progress=update)
    write(text, output)
