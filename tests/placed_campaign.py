"""Hold free positions among placed shapes against `classify`: `python -m tests.placed_campaign`.

Scene NUMBER is drawn by a `random.Random` of its own, seeded with "SEED:NUMBER", so that a failing
one comes again with `--seed SEED --first NUMBER --positions 1`.
"""

import random
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from itertools import count
from pathlib import Path

import click
from rich.console import Console

# The tests import one another by bare names, as pytest sets them up.
sys.path.insert(0, str(Path(__file__).parent / "support"))
from placed import draw_scene, find_mismatch

AT_ONCE = 40


def try_scene(seed: int, most: int, number: int) -> tuple[int, str, int, str]:
    """The number of a scene, its family, how many positions were tried, and what is wrong."""
    rng = random.Random(f"{seed}:{number}")
    scene = draw_scene(rng)
    try:
        return number, scene.family, *find_mismatch(scene, most, rng)
    except Exception as error:
        return number, scene.family, 1, f"{type(error).__name__}: {error}: {scene}"


@click.command()
@click.option(
    "--positions", default=200_000, show_default=True, help="How many positions at least."
)
@click.option("--most", default=100, show_default=True, help="Positions of one scene.")
@click.option("--seed", default=1, show_default=True)
@click.option("--first", default=0, show_default=True, help="The number of the first scene.")
@click.option("--workers", default=1, show_default=True, help="How many processes.")
def main(positions: int, most: int, seed: int, first: int, workers: int) -> None:
    """Compare free positions in random scenes with the definition."""
    console = Console()
    tried: Counter[str] = Counter()
    scenes: Counter[str] = Counter()
    failed = 0
    with ProcessPoolExecutor(workers) as pool:
        for start in count(first, AT_ONCE):
            numbers = range(start, start + AT_ONCE)
            for number, family, size, failure in pool.map(partial(try_scene, seed, most), numbers):
                scenes[family] += 1
                tried[family] += size
                if failure:
                    failed += 1
                    console.print(
                        f"scene {seed}:{number}: {failure}", highlight=False, markup=False
                    )
            if tried.total() >= positions:
                break
    for family in sorted(tried):
        console.print(f"{family}: {scenes[family]} scenes, {tried[family]} positions")
    console.print(f"{tried.total()} positions, {failed} scenes with mismatches")
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
