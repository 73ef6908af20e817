"""Compare judgements of layouts with the definition: `python -m tests.layout_campaign`.

Layout NUMBER is drawn by a `random.Random` of its own, seeded with "SEED:NUMBER", so that a failing
one comes again with `--seed SEED --first NUMBER --layouts 1`.
"""

import random
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path
from typing import NamedTuple

import click
from rich.console import Console
from rich.progress import track
from rich.table import Table

# The tests import one another by bare names, as pytest sets them up.
sys.path.insert(0, str(Path(__file__).parent / "support"))
from layout_reference import find_difference, find_unproved, find_wrong_move
from random_layouts import draw_layout

from exactsweep.layout import judge_layout

MOVES = 2


class LayoutOutcome(NamedTuple):
    """The outcome of one layout; `failure` is empty when all is well."""

    number: int
    family: str
    placements: int
    verdict: str
    faults: dict[str, int]
    failure: str


def try_layout(seed: int, number: int) -> LayoutOutcome:
    """Judge one random layout and compare all results with the definition."""
    rng = random.Random(f"{seed}:{number}")
    family, layout = draw_layout(rng)
    try:
        judgement = judge_layout(layout)
        failure = (
            find_difference(layout, judgement)
            or find_wrong_move(layout, judgement, MOVES)
            or find_unproved(judgement, rng)
        )
    except Exception as error:
        return LayoutOutcome(number, family, 0, "", {}, f"{type(error).__name__}: {error}")
    kinds = Counter[str](fault.kind for fault in judgement.faults)
    verdict = "valid" if judgement.valid else "invalid"
    return LayoutOutcome(number, family, len(layout.placements), verdict, dict(kinds), failure)


@click.command()
@click.option("--layouts", default=1000, show_default=True, help="How many layouts.")
@click.option("--seed", default=1, show_default=True)
@click.option("--first", default=0, show_default=True, help="The number of the first layout.")
@click.option("--workers", default=1, show_default=True, help="How many processes.")
def main(layouts: int, seed: int, first: int, workers: int) -> None:
    """Compare judgements of random layouts with the definition."""
    console = Console()
    numbers = range(first, first + layouts)
    table = Table(title=f"seed {seed}, layouts {first} to {first + layouts - 1}")
    counts: dict[str, Counter[str]] = {}
    failed = 0
    with ProcessPoolExecutor(workers) as pool:
        found = pool.map(partial(try_layout, seed), numbers, chunksize=5)
        for outcome in track(found, "layouts", total=layouts):
            counted = counts.setdefault(outcome.family, Counter())
            counted.update(outcome.faults)
            counted.update(["layouts", *([outcome.verdict] if outcome.verdict == "valid" else [])])
            counted["placements"] += outcome.placements
            if outcome.failure:
                failed += 1
                head = f"layout {seed}:{outcome.number} ({outcome.family})"
                console.print(f"{head}: {outcome.failure}", highlight=False, markup=False)
    names = ["layouts", "valid", "placements"]
    names += sorted({name for counted in counts.values() for name in counted} - set(names))
    table.add_column("family")
    for name in names:
        table.add_column(name, justify="right")
    for family, counted in sorted(counts.items()):
        table.add_row(family, *(str(counted[name]) for name in names))
    console.print(table)
    console.print(f"{layouts} layouts, {failed} mismatches")
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
