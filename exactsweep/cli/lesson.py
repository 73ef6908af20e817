"""The command `exactsweep lesson`."""

import click

from exactsweep.cli.options import takes_output
from exactsweep.cli.output import write


@click.command("lesson")
@click.argument("name", required=False)
@takes_output
def lesson_command(name: str | None, output: str) -> None:
    """Write a lesson as an HTML page, with its code and pictures.

    Lessons are notebooks; the page shows their stored output. Without NAME, lists the lessons.

    Example:
      exactsweep lesson gallery -o gallery.html
    """
    from exactsweep.lessons import list_titles, render_lesson

    if name is None:
        write("".join(f"{key:<8}  {title}\n" for key, title in list_titles().items()), output)
    else:
        write(render_lesson(name), output)
