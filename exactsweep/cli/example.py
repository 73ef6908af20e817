from pathlib import Path

import click

from exactsweep.cli.options import takes_output
from exactsweep.cli.output import write
from exactsweep.formats import FormatError, show_path


@click.command("example")
@click.argument("name", required=False)
@takes_output
def example_command(name: str | None, output: str) -> None:
    """Write a template program for 'exactsweep conform'.

    A template implements the protocol and has one function to replace; comments at the top explain
    how to build it. Without NAME, lists the templates.

    Example:
      exactsweep example
      exactsweep example doubles.cpp -o mine.cpp
    """
    from importlib.resources import files

    from exactsweep.conform.examples import SUMMARIES
    from exactsweep.corpus.names import require_known

    if name is None:
        width = max(map(len, SUMMARIES))
        lines = (f"{each.ljust(width)}  {words}\n" for each, words in SUMMARIES.items())
        write("".join(lines), output)
        return
    require_known(name, SUMMARIES, "example")
    if output != "-" and Path(output).exists():
        raise FormatError(f"{show_path(output)}: already exists")
    program = files("exactsweep.conform.examples").joinpath(name)
    write(program.read_text(encoding="utf-8"), output)


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
