"""Hold no-fit polygons of any shapes against the definition: `python -m tests.shapes_campaign`.

Pair NUMBER is drawn by a `random.Random` of its own, seeded with "SEED:NUMBER", so that a failing
one comes again with `--seed SEED --first NUMBER --pairs 1`.
"""

import random
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import click
from rich.console import Console
from rich.progress import track
from rich.table import Table

import exactsweep
from exactsweep import Point
from exactsweep.check import (
    ReferenceNoFit,
    classify,
    point_in_polygon,
    reference_inner_fit,
    reference_no_fit,
    reference_swept,
    verify,
)

# The tests import one another by bare names, as pytest sets them up.
sys.path.insert(0, str(Path(__file__).parent / "support"))
from cells import Holed
from shape_certificates import falsified
from shape_families import SHAPES, ShapePair, random_shapes

# What is held against the definition is asked for by name, when a pair is tried.
kernel: Any = exactsweep
WAYS = ("no_fit", "inner_fit", "sweep", "certificates", "classify")
FALSIFIED = 3  # of each certificate


class ShapeOutcome(NamedTuple):
    """What came of one pair; `failure` is empty when all is well."""

    number: int
    family: str
    placement: str
    holes: int
    fits: int
    failure: str


def failure_of(pair: ShapePair, ways: tuple[str, ...], rng: random.Random) -> str:
    """Say what is wrong with the answers for a pair, held against the definition."""
    d, g = pair.directrix, pair.generatrix
    true = reference_no_fit(d, g)
    checks = {
        "no_fit": lambda: no_fit_failure(d, g, true),
        "inner_fit": lambda: inner_fit_failure(d, g),
        "sweep": lambda: sweep_failure(d, g, true),
        "certificates": lambda: certificates_failure(d, g, rng),
        "classify": lambda: classify_failure(d, g, true, rng),
    }
    for way in ways:
        try:
            if failure := checks[way]():
                return f"{way}: {failure}"
        except Exception as error:
            return f"{way}: {type(error).__name__}: {error}"
    return ""


def no_fit_failure(d: Holed, g: Holed, true: ReferenceNoFit) -> str:
    """Hold `no_fit_polygon` against the reference."""
    found = kernel.no_fit_polygon(region(d), region(g))
    if found.exterior.vertices != true.exterior:
        return "exterior"
    if tuple(hole.vertices for hole in found.holes) != true.holes:
        return "holes"
    return "exact fits" if found.exact_fits != true.exact_fits else ""


def inner_fit_failure(d: Holed, g: Holed) -> str:
    """Hold `inner_fit_polygon` against the reference, D being the container."""
    true = reference_inner_fit(d, g)
    found = kernel.inner_fit_polygon(region(d), region(g))
    regions = tuple(
        (r.exterior.vertices, tuple(hole.vertices for hole in r.holes)) for r in found.regions
    )
    if regions != true.regions:
        return "regions"
    return "exact fits" if found.exact_fits != true.exact_fits else ""


def sweep_failure(d: Holed, g: Holed, true: ReferenceNoFit) -> str:
    """Hold `sweep` against the reference, and have its certificate proved."""
    s = kernel.sweep(region(g), region(d))
    swept = reference_swept(d, g, true.exterior)
    if s.trajectory.vertices != true.exterior:
        return "trajectory"
    for name in ("outer", "inner"):
        if getattr(s, name).vertices != getattr(swept, name):
            return name
    unswept = tuple(loop.vertices for loop in s.unswept)
    return "unswept" if unswept != swept.unswept else ""


def certificates_failure(d: Holed, g: Holed, rng: random.Random) -> str:
    """Have certificates proved, and refused with a witness once they are changed."""
    one, other = region(d), region(g)
    answers = kernel.no_fit_polygon, kernel.inner_fit_polygon, lambda d, g: kernel.sweep(g, d)
    for answer in answers:
        certificate = answer(one, other).certificate()
        result = verify(certificate)
        if not result.proved:
            return f"{certificate.get('claim')}: {result.reason}"
        # Those of monotone polygons have a campaign of their own.
        if "claim" in certificate:
            changes = list(falsified(certificate, rng))
            for change, false in rng.sample(changes, min(FALSIFIED, len(changes))):
                result = verify(false)
                if result.proved or (result.witness is None and change != "area"):
                    return f"{certificate['claim']}, {change}: {result.reason}"
    return ""


def classify_failure(d: Holed, g: Holed, true: ReferenceNoFit, rng: random.Random) -> str:
    """Hold the reference itself against `classify`, at positions on its features and between."""
    loops = (true.exterior, *true.holes)
    points = [p for loop in (*loops, *true.exact_fits) for p in loop]
    for _ in range(20):
        p, q = rng.choice(points), rng.choice(points)
        t = Point((p.x + q.x) / 2, (p.y + q.y) / 2)
        sides = [point_in_polygon(t, loop) for loop in loops]
        if 0 in sides or any(_is_on(t, fit) for fit in true.exact_fits):
            verdict = "CONTACT"
        else:
            verdict = "OVERLAP" if sides.count(1) == 1 else "FREE"
        if (found := classify(d, g, t).verdict) != verdict:
            return f"{found} at {t}, not {verdict}"
    return ""


def _is_on(t: Point, fit: tuple[Point, Point]) -> bool:
    (ax, ay), (bx, by) = fit
    on_line = (bx - ax) * (t.y - ay) == (by - ay) * (t.x - ax)
    return on_line and min(fit) <= t <= max(fit)


def region(shape: Holed) -> Any:
    """A shape as the kernel takes it."""
    return kernel.Region(shape.exterior, shape.holes) if shape.holes else shape.exterior


def try_shapes(
    seed: int, families: tuple[str, ...], ways: tuple[str, ...], number: int
) -> ShapeOutcome:
    rng = random.Random(f"{seed}:{number}")
    pair = random_shapes(rng, families)
    failure = failure_of(pair, ways, rng)
    if failure:
        return ShapeOutcome(number, pair.family, pair.placement, 0, 0, f"{failure}\n    {pair}")
    true = reference_no_fit(pair.directrix, pair.generatrix)
    counts = len(true.holes), len(true.exact_fits)
    return ShapeOutcome(number, pair.family, pair.placement, *counts, "")


def summary(outcomes: list[ShapeOutcome], title: str, column: str) -> Table:
    """Counts of pairs, holes and fits, the rows being the values of a column of the outcomes."""
    table = Table(title=title)
    table.add_column(column)
    counts = {name: Counter[str]() for name in ("pairs", "with holes", "with fits", "mismatches")}
    for name in counts:
        table.add_column(name, justify="right")
    for outcome in outcomes:
        row = getattr(outcome, column)
        counts["pairs"][row] += 1
        counts["with holes"][row] += outcome.holes > 0
        counts["with fits"][row] += outcome.fits > 0
        counts["mismatches"][row] += bool(outcome.failure)
    for row in sorted(counts["pairs"]):
        table.add_row(row, *(str(count[row]) for count in counts.values()))
    table.add_section()
    table.add_row("all", *(str(count.total()) for count in counts.values()))
    return table


@click.command()
@click.option("--pairs", default=20_000, show_default=True, help="How many pairs.")
@click.option("--seed", default=1, show_default=True)
@click.option("--first", default=0, show_default=True, help="The number of the first pair.")
@click.option("--family", "families", multiple=True, type=click.Choice([*SHAPES]), help="Not all.")
@click.option("--way", "ways", multiple=True, type=click.Choice(WAYS), help="Not all.")
@click.option("--workers", default=1, show_default=True, help="How many processes.")
def main(
    pairs: int,
    seed: int,
    first: int,
    families: tuple[str, ...],
    ways: tuple[str, ...],
    workers: int,
) -> None:
    """Compare answers for random pairs of shapes with the definition."""
    console = Console()
    numbers = range(first, first + pairs)
    job = partial(try_shapes, seed, families or tuple(SHAPES), ways or WAYS)
    outcomes: list[ShapeOutcome] = []
    with ProcessPoolExecutor(workers) as pool:
        for outcome in track(pool.map(job, numbers, chunksize=20), "pairs", total=pairs):
            outcomes.append(outcome)
            if outcome.failure:
                head = f"pair {seed}:{outcome.number} ({outcome.family}, {outcome.placement})"
                console.print(f"{head}: {outcome.failure}", highlight=False, markup=False)
    title = f"seed {seed}, pairs {first} to {first + pairs - 1}"
    for column in ("family", "placement"):
        console.print(summary(outcomes, title, column))
    failed = sum(bool(outcome.failure) for outcome in outcomes)
    console.print(f"{len(outcomes)} pairs, {failed} mismatches")
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
