"""`exactsweep explain`."""

import click

from exactsweep import Sweep
from exactsweep.cli.options import takes_output
from exactsweep.cli.output import measure_terminal, write
from exactsweep.cli.pair import takes_pair
from exactsweep.cli.working import working


@click.command("explain")
@takes_pair
@click.option("--json", "as_json", is_flag=True, help="Write the steps as exact JSON.")
@takes_output
def explain_command(result: Sweep, as_json: bool, output: str) -> None:
    """Explain a sweep, step by step.

    A step is an edge of the trajectory. The explanation gives its direction and ends, the features
    in contact, the reason for its end, and the undercuts and exact fits on the way. Then it
    describes the holes of the no-fit polygon and the exact fits, with their contacts. Vertices and
    edges have their index in the files; edge i runs from vertex i to the next.

    The command reads files as 'exactsweep sweep' does; without files, it explains the example.

    Example:
      exactsweep explain house.json block.wkt
    """
    from exactsweep.text.explanation import tell
    from exactsweep.text.results import explanation_to_json

    with working("explaining the sweep"):
        lines = [explanation_to_json(result)] if as_json else [f"{one}\n" for one in tell(result)]
        text = "".join(lines)
    terminal = measure_terminal(output)
    if terminal and text.count("\n") > terminal.lines:
        click.echo_via_pager(text)
    else:
        write(text, output)
