"""`exactsweep view`."""

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
    """Write a page on which the generatrix can be moved.

    The page is one HTML file that needs no network: open it in a browser. The generatrix goes
    around the directrix, around holes of the no-fit polygon and into exact fits, by a slider, by
    dragging or by the keyboard; the contact is named all the way, and vertices, undercuts and exact
    fits tell their exact coordinates.

    Of a no-fit polygon or an inner fit the page shows the positions alone.

    Files are read as by 'exactsweep sweep'; without files, its example is shown.

    Example:
      exactsweep view house.json block.wkt -o sweep.html
      exactsweep view --of ifp sheet.json part.wkt -o fit.html
    """
    from exactsweep.view import make_page

    files = name_files_of_pair()
    names = None if files is None else (show_path(files[0]), show_path(files[1]))
    if names and not isinstance(result, Sweep):
        # What stays is given first.
        names = names[1], names[0]
    with working("making the page") as tell:
        text = make_page(result, names=names, y_down=coordinates_of_files().y_down, tell=tell)
    write(text, output)
