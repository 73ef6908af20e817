"""Break the kernel, and list the failing rows of the ledger.

`python -m tests.mutations` tries all faults, which are in `support/`: wrong answers of the paper's
procedures (`wrong_answers.py`, and `wrong_rarely.py` for faults that few pairs reveal) and of the
evidence (`wrong_evidence.py`), right answers that take too much time or memory (`wrong_costs.py`),
and wrong answers for polygons of any shape (`wrong_shapes.py`).
"""

import sys
from pathlib import Path

import click
from rich.console import Console
from rich.table import Table

from exactsweep.paper.claim import Effort

# Tests import each other by bare names, as under pytest.
sys.path.insert(0, str(Path(__file__).parent / "support"))
import wrong_answers
import wrong_costs
import wrong_evidence
import wrong_rarely
import wrong_shapes
from sabotage import MUTATIONS, Mutation, mutated, red_rows

__all__ = ["MUTATIONS", "SABOTAGES", "Mutation", "mutated", "red_rows"]

SABOTAGES = (wrong_answers, wrong_rarely, wrong_evidence, wrong_costs, wrong_shapes)
"""The modules that register what is in MUTATIONS."""


@click.command()
@click.option("--seed", default=1, show_default=True)
@click.option("--timed", "only_timed", is_flag=True, help="Only what shows in seconds alone.")
@click.option("--only", default="", help="Only faults whose description has this in it.")
@click.option("--named", is_flag=True, help="Try only the rows that must notice.")
def main(seed: int, only_timed: bool, only: str, named: bool) -> None:
    """Show the failing rows for each mutation; exit with 1 if an expected one passes.

    The run tries a tenth of the pairs only. By default it skips faults that only cost time; on
    request it tries these, with full runs of the rows that must detect them.
    """
    table = Table("mutation", "red rows", "missed", show_lines=True)
    missed_any = False
    for mutation in MUTATIONS:
        if mutation.timed != only_timed or only not in mutation.fault:
            continue
        names = mutation.rows if only_timed or named else ()
        red = red_rows(mutation, Effort(seed, quick=not only_timed), names)
        missed = [name for name in mutation.rows if name not in red]
        missed_any = missed_any or bool(missed)
        table.add_row(mutation.fault, f"{len(red)}: {', '.join(red)}", ", ".join(missed))
    Console().print(table)
    sys.exit(missed_any)


if __name__ == "__main__":
    main()
