"""Hold small pairs against SFCGAL, an unrelated program: `python -m tests.sfcgal_campaign`.

Pairs are drawn as by `small_campaign`, of all classes, and half of them are bred from others. Both
find the trajectory, the holes, the outer loop, and all that is left out inside. Where SFCGAL ends
with a crash, the pair is counted apart, and the next one is given to a process of its own.
"""

import os
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import islice
from pathlib import Path
from random import Random

import click
from rich.console import Console
from rich.progress import track

from exactsweep.corpus import Case
from exactsweep.corpus.case_json import case_to_line

# The tests import one another by bare names, as pytest sets them up.
SUPPORT = str(Path(__file__).parent / "support")
sys.path.insert(0, SUPPORT)
from small_pairs import SmallPair, breed, draw, draw_shapeless  # noqa: E402

SHAPELESS_SHARE = 5  # one of so many
TOGETHER = 250  # pairs that are handed over at once
OTHER = Path(SUPPORT) / "sfcgal_sweep.py"


def pairs_of(rng: Random) -> Iterator[SmallPair]:
    """Pairs drawn afresh, each followed by one bred from it."""
    while True:
        pair = draw(rng) if rng.randrange(SHAPELESS_SHARE) else draw_shapeless(rng)
        yield pair
        yield breed(rng, pair)


def case_of(pair: SmallPair, id: str) -> Case:
    """What the kernel answers."""
    (g, *g_holes), (d, *d_holes) = pair
    return Case.of(id, id, d, g, (0, 0), (), directrix_holes=d_holes, generatrix_holes=g_holes)


def ask(cases: Sequence[Case]) -> Iterator[str]:
    """What the other program says of each: nothing if it agrees, that it differs, or crashes."""
    left = list(cases)
    while left:
        with tempfile.TemporaryFile("w+") as given, tempfile.TemporaryFile("w+") as said:
            given.writelines(map(case_to_line, left))
            given.seek(0)
            done = subprocess.run(
                [sys.executable, OTHER],
                stdin=given,
                stdout=said,
                stderr=subprocess.PIPE,
                env=os.environ | {"PYTHONFAULTHANDLER": ""},
                check=False,
            )
            said.seek(0)
            lines = said.read().splitlines()
        for case, line in zip(left, lines, strict=False):
            yield line.removeprefix(case.id).strip()
        if len(lines) < len(left):
            words = done.stderr.decode(errors="replace").strip().splitlines()
            yield f"crashes: {words[-1] if words else f'signal {-done.returncode}'}"
        left = left[len(lines) + 1 :]


@click.command()
@click.option("--pairs", default=10_000, show_default=True, help="How many.")
@click.option("--seed", default=1, show_default=True)
def main(pairs: int, seed: int) -> None:
    """Hold small pairs against SFCGAL; exit code 1 if it differs on one."""
    console = Console(soft_wrap=True, highlight=False, markup=False)
    drawn = pairs_of(Random(f"{seed}"))
    kinds: Counter[str] = Counter()
    crashes: Counter[str] = Counter()
    wrong = 0
    for first in track(range(0, pairs, TOGETHER), "pairs", console=Console(stderr=True)):
        some = list(islice(drawn, min(TOGETHER, pairs - first)))
        cases = [case_of(pair, f"pair-{seed}-{first + k}") for k, pair in enumerate(some)]
        for pair, case, said in zip(some, cases, ask(cases), strict=True):
            if said.startswith("crashes"):
                crashes[said] += 1
            elif said:
                wrong += 1
                console.print(f"{case.id} {said}\n    G, D = {pair.generatrix}, {pair.directrix}")
            else:
                kinds[case.kind] += 1
    counts = ", ".join(f"{kinds[kind]:,} {kind}" for kind in sorted(kinds))
    console.print(f"{kinds.total():,} pairs agree ({counts}), {wrong} differ")
    for said, count in crashes.most_common():
        console.print(f"{count:,} {said}")
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()
