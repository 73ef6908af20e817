"""The command `exactsweep explain`."""

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
    """Explain a sweep step by step.

    Each edge of the trajectory is a step. The explanation states its direction and ends, the
    features in contact, the reason for its end, and the undercuts and exact fits along it. Then it
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
