"""`exactsweep draw`."""

import click

from exactsweep import Point, Sweep
from exactsweep.cli.pair import PATH, takes_pair
from exactsweep.draw import new_figure, picture_suffix, plot_sweep, save
from exactsweep.formats import FormatError, file_name
from exactsweep.geometry.number import to_fraction


def _with_suffix(ctx: click.Context, option: click.Parameter, path: str) -> str:
    try:
        picture_suffix(path)
    except ValueError as error:
        raise click.BadParameter(f"{file_name(path)}: {error}") from None
    return path


def _to_points(
    ctx: click.Context, option: click.Parameter, pairs: tuple[tuple[str, str], ...]
) -> list[Point]:
    try:
        return [Point(*map(to_fraction, pair)) for pair in pairs]
    except ValueError as error:
        raise click.BadParameter(str(error)) from None


@click.command("draw")
@takes_pair
@click.option(
    "--position",
    "positions",
    nargs=2,
    multiple=True,
    callback=_to_points,
    metavar="X Y",
    help="Draw the generatrix with its reference point here; may be given several times.",
)
@click.option(
    "-o",
    "--output",
    type=PATH,
    required=True,
    callback=_with_suffix,
    metavar="FILE",
    help="The picture: a file that ends in .svg, .pdf or .png.",
)
def draw_command(result: Sweep, positions: list[Point], output: str) -> None:
    """Draw a sweep.

    The picture has both polygons, the inner and the outer loop, the trajectory with a colour for
    each contact event, undercuts hatched, exact fits marked, and the generatrix at some positions:
    closing undercuts, in exact fits and at the first vertex of the trajectory if none are given.

    Files are read as by 'exactsweep sweep'; without files, its example is drawn.
    """
    figure = new_figure()
    plot_sweep(result, figure.axes[0], positions=positions or None)
    try:
        save(figure, output)
    except OSError as error:
        raise FormatError(f"{file_name(output)}: {error.strerror or error}") from None
