"""`exactsweep example`."""

from __future__ import annotations

from pathlib import Path

import click

from exactsweep.cli.options import takes_output
from exactsweep.cli.output import write
from exactsweep.formats import FormatError, show_path


@click.command("example")
@click.argument("name", required=False)
@takes_output
def example_command(name: str | None, output: str) -> None:
    """Show programs to begin with, for 'exactsweep conform'.

    Each of them speaks the protocol and does convex pairs only. Without NAME, their paths are
    printed; with NAME, such as convex.py, the program, or it is copied by -o FILE.

    Example:
      exactsweep example
      exactsweep example convex.py -o adapter.py
    """
    from importlib.resources import files

    from exactsweep.corpus.names import require_known

    folder = files("exactsweep.conform.examples")
    programs = {entry.name: entry for entry in folder.iterdir() if entry.name.startswith("convex.")}
    if name is None:
        write("".join(f"{programs[each]}\n" for each in sorted(programs)), output)
        return
    if output != "-" and Path(output).exists():
        raise FormatError(f"{show_path(output)}: is there already")
    write(
        programs[require_known(name, sorted(programs), "example")].read_text(encoding="utf-8"),
        output,
    )
