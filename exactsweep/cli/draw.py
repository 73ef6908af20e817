"""The command `exactsweep draw`."""

from collections.abc import Callable

import click

from exactsweep import InnerFit, NoFitPolygon, Point, Sweep
from exactsweep.cli.options import checked, requires_output
from exactsweep.cli.output import replace_file
from exactsweep.cli.pair import coordinates_of_files, takes_pair, takes_question, to_point
from exactsweep.cli.working import working
from exactsweep.formats import show_path
from exactsweep.formats.files import prefix_os_errors
from exactsweep.numbers.error import prefix_errors
from exactsweep.words import spell_out


def _require_suffix(path: str) -> str:
    from exactsweep.draw import read_suffix

    with prefix_errors(show_path(path)):
        read_suffix(path)
    return path


@click.command("draw")
@takes_question
@takes_pair
@click.option(
    "--position",
    "positions",
    nargs=2,
    multiple=True,
    callback=checked(lambda pairs: [*map(to_point, pairs)]),
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
    drawn at each --position; by default, at positions that close undercuts, in exact fits and at
    the first vertex. For tiny polygons and flat pictures, enlarged details are below.

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
        y_down = coordinates_of_files().y_down
        plot: Callable[..., object] = plot_sweep if isinstance(result, Sweep) else plot_positions
        plot(result, axes, positions=positions or None, y_down=y_down)
    if title:
        # Fonts lack unprintable characters, and a dollar sign starts a formula.
        axes.set_title(spell_out(title).replace("$", r"\$"), loc="left")
    with prefix_os_errors(output), working("drawing"), replace_file(output) as path:
        save(figure, path)
