"""Hold the kernel against the definition on many random pairs: `python -m tests.campaign`.

Pair NUMBER is drawn by a `random.Random` of its own, seeded with "SEED:NUMBER", so that a failing
one comes again with `--seed SEED --first NUMBER --pairs 1`.
"""

import random
import sys
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path
from typing import NamedTuple

import click
from rich.console import Console
from rich.progress import track
from rich.table import Table

from exactsweep import Point, Polygon, Sweep, sweep
from exactsweep.check import (
    classify,
    point_in_polygon,
    reference_exact_fits,
    reference_loops,
)

# The tests import one another by bare names, as pytest sets them up.
sys.path.insert(0, str(Path(__file__).parent / "support"))
from families import FAMILIES, Pair, Ring, random_pair

Direction = tuple[int, int]
Fit = tuple[Point, Point]


class Outcome(NamedTuple):
    """What came of one pair; `failure` is empty when all is well."""

    number: int
    family: str
    placement: str
    kind: str
    fits: int
    failure: str


def failure_of(generatrix: Ring, directrix: Ring, direction: Direction) -> str:
    """Say what is wrong with the sweep of a pair, held against the definition."""
    loops = reference_loops(generatrix, directrix, direction)
    fits = reference_exact_fits(generatrix, directrix, direction)
    try:
        for chosen in (None, direction):
            s = sweep(generatrix, directrix, direction=chosen)
            for name in loops._fields:
                if getattr(s, name).vertices != getattr(loops, name):
                    return f"{name}, swept in direction {s.direction}"
            if s.exact_fits != fits:
                return f"exact fits, swept in direction {s.direction}"
        if not all(s.contacts):
            return "an edge of the trajectory without contact"
        if failure := undercuts_failure_of(s):
            return failure
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    for fit in fits:
        if not is_exact_fit(generatrix, directrix, fit):
            return f"{fit} is not an exact fit"
    return ""


def undercuts_failure_of(s: Sweep) -> str:
    """Say what is wrong with the undercuts of a sweep whose loops are right."""
    if sum(u.polygon.area for u in s.undercuts) + s.directrix.area != s.inner.area:
        return "areas of the undercuts"
    for undercut in s.undercuts:
        if classify(s.directrix, undercut.polygon, (0, 0)).verdict != "CONTACT":
            return f"{undercut.polygon} is no pocket of D"
        for extreme in undercut.extremes:
            if point_in_polygon(extreme, s.directrix) or point_in_polygon(extreme, s.inner):
                return f"{extreme} is no extreme contact point"
        for position in undercut.positions:
            if point_in_polygon(position, s.trajectory):
                return f"{position} closes an undercut but is not on the trajectory"
    return ""


def is_exact_fit(generatrix: Ring | Polygon, directrix: Ring | Polygon, fit: Fit) -> bool:
    """Whether both ends and the midpoint of a segment touch, and what is just beside overlaps."""
    (ax, ay), (bx, by) = fit
    x, y = (ax + bx) / 2, (ay + by) / 2
    dx, dy = (by - ay) / 10**40, (ax - bx) / 10**40
    verdicts = [
        classify(directrix, generatrix, t).verdict
        for t in (*fit, (x, y), (x + dx, y + dy), (x - dx, y - dy))
    ]
    return verdicts == ["CONTACT"] * 3 + ["OVERLAP"] * 2


def shrunk(pair: Pair) -> list[Ring]:
    """The rings of a failing pair, with fewer vertices and rounder numbers if it still fails."""
    rings: list[Ring] = [[*Polygon(r).vertices] for r in (pair.generatrix, pair.directrix)]

    def fails(candidate: list[Ring]) -> bool:
        try:
            return bool(failure_of(candidate[0], candidate[1], pair.direction))
        except ValueError:
            return False

    def rounder() -> Iterator[list[Ring]]:
        moved = [[(x - min(r)[0], y - min(r)[1]) for x, y in r] for r in rings]
        for unit in sorted({abs(c) for ring in moved for v in ring for c in v if c})[:3]:
            for size in (1, 2, 6):
                yield [[(x * size / unit, y * size / unit) for x, y in r] for r in moved]

    def smaller() -> Iterator[list[Ring]]:
        for i in range(len(rings[0])):
            yield [rings[0][:i] + rings[0][i + 1 :], rings[1]]
        for i in range(len(rings[1])):
            yield [rings[0], rings[1][:i] + rings[1][i + 1 :]]

    rings = next(filter(fails, rounder()), rings)
    while candidate := next(filter(fails, smaller()), None):
        rings = candidate
    return rings


def try_pair(seed: int, families: tuple[str, ...], number: int) -> Outcome:
    pair = random_pair(random.Random(f"{seed}:{number}"), families)
    failure = failure_of(pair.generatrix, pair.directrix, pair.direction)
    if failure:
        call = "sweep({}, {}, direction={})".format(*map(_text, shrunk(pair)), pair.direction)
        return Outcome(number, pair.family, pair.placement, "", 0, f"{failure}\n    {call}")
    s = sweep(pair.generatrix, pair.directrix)
    return Outcome(number, pair.family, pair.placement, s.kind, len(s.exact_fits), "")


def _text(ring: Ring) -> str:
    pairs = (", ".join(str(c) if c.denominator == 1 else f"'{c}'" for c in v) for v in ring)
    return f"[{', '.join(f'({pair})' for pair in pairs)}]"


def summary(outcomes: list[Outcome], title: str, column: str) -> Table:
    """Counts by class, the rows being the values of a column of the outcomes."""
    table = Table(title=title)
    table.add_column(column)
    kinds = ("CC", "CM", "MM")
    for name in (*kinds, "exact fits"):
        table.add_column(name, justify="right")
    counts = Counter((getattr(o, column), o.kind) for o in outcomes)
    fits: Counter[str] = Counter()
    for outcome in outcomes:
        fits[getattr(outcome, column)] += outcome.fits
    for row in sorted(fits):
        table.add_row(row, *(str(counts[row, kind]) for kind in kinds), str(fits[row]))
    table.add_section()
    totals = [sum(counts[row, kind] for row in fits) for kind in kinds]
    table.add_row("all", *map(str, totals), str(fits.total()))
    return table


@click.command()
@click.option("--pairs", default=20_000, show_default=True, help="How many pairs.")
@click.option("--seed", default=1, show_default=True)
@click.option("--first", default=0, show_default=True, help="The number of the first pair.")
@click.option("--family", "families", multiple=True, type=click.Choice(FAMILIES), help="Not all.")
@click.option("--workers", default=1, show_default=True, help="How many processes.")
def main(pairs: int, seed: int, first: int, families: tuple[str, ...], workers: int) -> None:
    """Sweep random pairs and compare loops and exact fits with the definition."""
    console = Console()
    numbers = range(first, first + pairs)
    job = partial(try_pair, seed, families or FAMILIES)
    outcomes: list[Outcome] = []
    with ProcessPoolExecutor(workers) as pool:
        results = pool.map(job, numbers, chunksize=20)
        for outcome in track(results, "pairs", total=pairs, console=console):
            outcomes.append(outcome)
            if outcome.failure:
                console.print(
                    f"pair {seed}:{outcome.number} ({outcome.family}, {outcome.placement}): "
                    f"{outcome.failure}",
                    highlight=False,
                    markup=False,
                    soft_wrap=True,
                )
    good = [outcome for outcome in outcomes if not outcome.failure]
    title = f"seed {seed}, pairs {first} to {first + pairs - 1}"
    for column in ("family", "placement"):
        console.print(summary(good, title, column))
    failed = len(outcomes) - len(good)
    console.print(f"{len(outcomes)} pairs, {failed} mismatches")
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
