"""The command `exactsweep view`."""

import click

from exactsweep import InnerFit, NoFitPolygon, Sweep
from exactsweep.cli.options import takes_output
from exactsweep.cli.output import write
from exactsweep.cli.pair import coordinates_of_files, name_files_of_pair, takes_pair, takes_question
from exactsweep.cli.working import working
from exactsweep.formats import show_path


@click.command("view")
@takes_question
@takes_pair
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
    files = name_files_of_pair()
    names = None if files is None else (show_path(files[0]), show_path(files[1]))
    if names and not isinstance(result, Sweep):
        # The stationary polygon is the first file.
        names = names[1], names[0]
    with working("making the page") as update:
        text = make_page(result, names=names, y_down=coordinates_of_files().y_down, tell=update)
    write(text, output)
