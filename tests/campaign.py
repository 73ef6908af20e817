"""Compare the kernel with a reference on many random pairs: `python -m tests.campaign NAME`.

NAME says how pairs are drawn: `monotone` (every degeneracy on purpose, placed anywhere), `small`
(small ints, of all classes, most of them bred from another), `shapes` (any shapes with holes),
`touching` (Regions whose rings touch) or `around` (containers with defects, and parts whose holes
may go around these). Pair NUMBER is drawn by a `random.Random` of its own, seeded
with "SEED:NUMBER": a failing one comes again with `--seed SEED --first NUMBER --pairs 1`.
"""

import os
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path
from random import Random

import click
from rich.console import Console
from rich.progress import track

# The tests import one another by bare names, as pytest sets them up.
sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parent / "support"))
import families
import small_pairs
from definition import find_failure
from shape_families import SHAPES, random_shapes
from small_pairs import SmallPair, shares_direction, shrink

from exactsweep.corpus import Case
from exactsweep.corpus.case_json import case_to_line

SHAPELESS_SHARE, DEEP_SHARE = 5, 10  # one of so many
TOGETHER = 100  # pairs that a process is given at once


def draw_monotone(rng: Random, names: Sequence[str] = families.FAMILIES) -> SmallPair:
    pair = families.random_pair(rng, names)
    return SmallPair([pair.generatrix], [pair.directrix])


def draw_small(rng: Random) -> SmallPair:
    draw = small_pairs.draw if rng.randrange(SHAPELESS_SHARE) else small_pairs.draw_shapeless
    pair = draw(rng)
    for _ in range(rng.choice([0, 1, 2, 4])):
        pair = small_pairs.breed(rng, pair)
    return pair


def draw_shapes(rng: Random, names: Sequence[str] = tuple(SHAPES)) -> SmallPair:
    pair = random_shapes(rng, tuple(names))
    g, d = (
        [[(x, y) for x, y in ring.vertices] for ring in (shape.exterior, *shape.holes)]
        for shape in (pair.generatrix, pair.directrix)
    )
    return SmallPair(g, d)


STRATEGIES: dict[str, Callable[[Random], SmallPair]] = {
    "monotone": draw_monotone,
    "small": draw_small,
    "shapes": draw_shapes,
    "touching": small_pairs.draw_touching,
    "around": small_pairs.draw_around,
}


def draw(name: str, seed: int, number: int) -> SmallPair:
    return STRATEGIES[name](Random(f"{seed}:{number}"))


def by_definition(name: str, seed: int, numbers: range) -> list[str]:
    """Compare pairs with the definition: loops of all, every answer of one in ten."""
    share = 1 if name in ("touching", "around") else DEEP_SHARE
    return [find_failure(draw(name, seed, k), deep=k % share == 0) for k in numbers]


def by_sfcgal(name: str, seed: int, numbers: range) -> list[str]:
    """Compare pairs with SFCGAL, an unrelated program, in all but exact fits."""
    return list(ask_sfcgal([case_of(draw(name, seed, number)) for number in numbers]))


REFERENCES = {"definition": by_definition, "sfcgal": by_sfcgal}


def case_of(pair: SmallPair) -> Case:
    """The kernel's answers for a pair."""
    (g, *g_holes), (d, *d_holes) = pair
    return Case.of("pair", "", d, g, (0, 0), (), directrix_holes=d_holes, generatrix_holes=g_holes)


def ask_sfcgal(cases: Sequence[Case]) -> Iterator[str]:
    """Yield for each case what SFCGAL says: nothing if it agrees, that it differs, or crashes.

    After a crash the next case is given to a new process.
    """
    left = list(cases)
    while left:
        with tempfile.TemporaryFile("w+") as given, tempfile.TemporaryFile("w+") as said:
            given.writelines(map(case_to_line, left))
            given.seek(0)
            done = subprocess.run(
                [sys.executable, Path(__file__).parent / "support" / "sfcgal_sweep.py"],
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


def describe(name: str, seed: int, number: int, failure: str) -> str:
    """A failing pair, and the smallest one that dropping and moving its vertices leads to."""

    def fails(candidate: SmallPair) -> bool:
        found = find_failure(candidate, deep=True)
        return found.split()[:1] == failure.split()[:1]

    pair = draw(name, seed, number)
    least = shrink(pair, fails)
    return (
        f"pair {seed}:{number}: {failure}\n"
        f"    G, D = {least.generatrix}, {least.directrix}\n    from {pair}"
    )


@click.command()
@click.argument("name", type=click.Choice([*STRATEGIES]))
@click.option("--pairs", default=20_000, show_default=True, help="How many pairs.")
@click.option("--seed", default=1, show_default=True)
@click.option("--first", default=0, show_default=True, help="The number of the first pair.")
@click.option("--reference", type=click.Choice([*REFERENCES]), default="definition")
@click.option("--workers", default=1, show_default=True, help="How many processes.")
def main(name: str, pairs: int, seed: int, first: int, reference: str, workers: int) -> None:
    """Compare random pairs with a reference; exit code 1 if one differs."""
    console = Console(soft_wrap=True, highlight=False, markup=False)
    end = first + pairs
    chunks = [range(k, min(k + TOGETHER, end)) for k in range(first, end, TOGETHER)]
    kinds: Counter[str] = Counter()
    wrong = 0
    with ProcessPoolExecutor(workers) as pool:
        results = pool.map(partial(REFERENCES[reference], name, seed), chunks)
        progress = Console(stderr=True)
        for numbers, said in track(
            zip(chunks, results, strict=True), total=len(chunks), console=progress
        ):
            for number, failure in zip(numbers, said, strict=True):
                if failure.startswith("crashes"):
                    kinds[failure] += 1
                elif failure:
                    wrong += 1
                    console.print(describe(name, seed, number, failure))
                else:
                    shared = shares_direction(draw(name, seed, number))
                    kinds["monotone" if shared else "of any shape"] += 1
    counts = ", ".join(f"{count:,} {kind}" for kind, count in sorted(kinds.items()))
    console.print(f"{name}, {reference}, seed {seed}: {counts}; {wrong} mismatches")
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()
