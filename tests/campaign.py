"""Compare answers with a reference on many random inputs: `python -m tests.campaign NAME`.

NAME selects the inputs. Pairs: `monotone` (with all degeneracies, placed anywhere), `small` (small
ints, all classes, mostly mutated from others), `shapes` (any shapes with holes), `touching`
(Regions whose rings touch), `around` (containers with defects, and parts whose holes may enclose
these).
`layouts` are whole layouts with their judgements; `scenes` are containers with placed shapes, and
the free positions of a part; `rounded` are discs, slots and rounded rectangles near contact;
`packings` are layouts of these with certificates. Input NUMBER depends only on "SEED:NUMBER", so
`--seed SEED --first NUMBER --count 1` reproduces a failure.
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
from typing import Any, NamedTuple

import click
from rich.console import Console
from rich.progress import track

# Tests import each other by bare names, as under pytest.
sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parent / "support"))
import families
import layout_reference
import placed
import small_pairs
from definition import find_failure
from packings import compare_packing, draw_packing
from random_layouts import draw_layout
from rounded import compare_rounded, draw_rounded
from shape_families import SHAPES, random_shapes
from small_pairs import SmallPair, shares_direction, shrink

from exactsweep.corpus import Case
from exactsweep.corpus.case_json import case_to_line

SHAPELESS_SHARE = 5  # one in five pairs
TOGETHER = 100  # inputs per task


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


def compare_pair(pair: SmallPair, rng: Random, deep: bool) -> str:
    return find_failure(pair, deep=deep)


def name_class(pair: SmallPair) -> str:
    return "monotone" if shares_direction(pair) else "of any shape"


class Compared(NamedTuple):
    """The class of an input, and a difference from the reference, if there is one."""

    kind: str
    failure: str


class Strategy(NamedTuple):
    """Functions that draw inputs and compare the answers with the definition.

    Attributes:
        draw: draws an input.
        deep: compares all answers of every `deep`-th input.
        compare: describes a difference from the definition; "" if there is none.
        name: names the class of an input, for the counts.
    """

    draw: Callable[[Random], Any]
    deep: int = 10
    compare: Callable[[Any, Random, bool], str] = compare_pair
    name: Callable[[Any], str] = name_class


STRATEGIES = {
    "monotone": Strategy(draw_monotone),
    "small": Strategy(draw_small, 50),
    "shapes": Strategy(draw_shapes),
    "touching": Strategy(small_pairs.draw_touching, 1),
    "around": Strategy(small_pairs.draw_around, 1),
    "packings": Strategy(draw_packing, 1, compare_packing, lambda packing: packing.verdict),
    "layouts": Strategy(draw_layout, 1, layout_reference.compare, lambda drawn: drawn.family),
    "rounded": Strategy(draw_rounded, 1, compare_rounded, lambda pair: pair.verdict),
    "scenes": Strategy(placed.draw_scene, 1, placed.compare, lambda scene: scene.family),
}


def seeded(seed: int, number: int) -> Random:
    return Random(f"{seed}:{number}")


def by_definition(name: str, seed: int, numbers: range) -> list[Compared]:
    """Compare inputs with the definition."""
    strategy = STRATEGIES[name]

    def compare(number: int) -> Compared:
        rng = seeded(seed, number)
        drawn = strategy.draw(rng)
        try:
            failure = strategy.compare(drawn, rng, number % strategy.deep == 0)
        except Exception as error:
            failure = f"{type(error).__name__}: {error}"
        return Compared(strategy.name(drawn), failure)

    return [compare(number) for number in numbers]


def find_failures(name: str, seed: int, numbers: range) -> list[str]:
    """List inputs that differ from the definition."""
    return [failure for _, failure in by_definition(name, seed, numbers) if failure]


def by_sfcgal(name: str, seed: int, numbers: range) -> list[Compared]:
    """Compare pairs, except for exact fits, with SFCGAL, an independent program."""
    pairs = [STRATEGIES[name].draw(seeded(seed, number)) for number in numbers]
    answers = ask_sfcgal([case_of(pair) for pair in pairs])
    return [Compared(name_class(pair), line) for pair, line in zip(pairs, answers, strict=True)]


REFERENCES = {"definition": by_definition, "sfcgal": by_sfcgal}


def case_of(pair: SmallPair) -> Case:
    """Return the kernel's answers for a pair."""
    (g, *g_holes), (d, *d_holes) = pair
    return Case.of("pair", "", d, g, (0, 0), (), directrix_holes=d_holes, generatrix_holes=g_holes)


def ask_sfcgal(cases: Sequence[Case]) -> Iterator[str]:
    """Yield the answer of SFCGAL for each case: "", "differs" or a crash.

    After a crash the next case is given to a new process.
    """
    left = list(cases)
    while left:
        with tempfile.TemporaryFile("w+") as given, tempfile.TemporaryFile("w+") as answers:
            given.writelines(map(case_to_line, left))
            given.seek(0)
            done = subprocess.run(
                [sys.executable, Path(__file__).parent / "support" / "sfcgal_sweep.py"],
                stdin=given,
                stdout=answers,
                stderr=subprocess.PIPE,
                env=os.environ | {"PYTHONFAULTHANDLER": ""},
                check=False,
            )
            answers.seek(0)
            lines = answers.read().splitlines()
        for case, line in zip(left, lines, strict=False):
            yield line.removeprefix(case.id).strip()
        if len(lines) < len(left):
            words = done.stderr.decode(errors="replace").strip().splitlines()
            yield f"crashes: {words[-1] if words else f'signal {-done.returncode}'}"
        left = left[len(lines) + 1 :]


def describe(name: str, seed: int, number: int, failure: str) -> str:
    """Describe a failing input; pairs are shrunk."""
    drawn = STRATEGIES[name].draw(seeded(seed, number))
    found = f"{name} {seed}:{number}: {failure}\n    "
    if not isinstance(drawn, SmallPair):
        return f"{found}from {drawn}"

    def fails(candidate: SmallPair) -> bool:
        return find_failure(candidate, deep=True).split()[:1] == failure.split()[:1]

    least = shrink(drawn, fails)
    return f"{found}G, D = {least.generatrix}, {least.directrix}\n    from {drawn}"


@click.command()
@click.argument("name", type=click.Choice([*STRATEGIES]))
@click.option("--count", default=20_000, show_default=True, help="How many inputs.")
@click.option("--seed", default=1, show_default=True)
@click.option("--first", default=0, show_default=True, help="The number of the first input.")
@click.option(
    "--reference", type=click.Choice([*REFERENCES]), default="definition", help="SFCGAL: of pairs."
)
@click.option("--workers", default=1, show_default=True, help="How many processes.")
def main(name: str, count: int, seed: int, first: int, reference: str, workers: int) -> None:
    """Compare random inputs with a reference; exit code 1 if one differs."""
    if reference == "sfcgal" and name in ("layouts", "rounded", "scenes"):
        raise click.UsageError("SFCGAL is a reference for pairs only")
    console = Console(soft_wrap=True, highlight=False, markup=False)
    end = first + count
    chunks = [range(k, min(k + TOGETHER, end)) for k in range(first, end, TOGETHER)]
    kinds: Counter[str] = Counter()
    wrong = 0
    with ProcessPoolExecutor(workers) as pool:
        results = pool.map(partial(REFERENCES[reference], name, seed), chunks)
        progress = Console(stderr=True)
        for numbers, answers in track(
            zip(chunks, results, strict=True), total=len(chunks), console=progress
        ):
            for number, (kind, failure) in zip(numbers, answers, strict=True):
                if failure and not failure.startswith("crashes"):
                    wrong += 1
                    console.print(describe(name, seed, number, failure))
                else:
                    kinds[failure or kind] += 1
    counts = ", ".join(f"{number:,} {kind}" for kind, number in sorted(kinds.items()))
    console.print(f"{name}, {reference}, seed {seed}: {counts}; {wrong} mismatches")
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()
