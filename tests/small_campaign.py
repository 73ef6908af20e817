"""Hold the kernel against the definition on small pairs, steered: `python -m tests.small_campaign`.

Half of the pairs are drawn afresh. The other half are bred from pairs that made the kernel decide
in a way that few others did; which those are is noted for every fourth pair. One of forty is held
against the definition in all that is known about it, the others in loops and exact fits.

What has been done is kept in a journal, from which a campaign goes on where it was stopped. Shards
come in rounds of four, and what a shard draws depends on the seed and the rounds before: so the
pairs are the same whatever the number of processes, and wherever the campaign was interrupted.
"""

import hashlib
import json
import subprocess
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from datetime import date
from functools import partial
from pathlib import Path
from random import Random
from typing import Any, NamedTuple

import click
from rich.console import Console
from rich.table import Table

import exactsweep
from exactsweep.check import (
    reference_exact_fits,
    reference_inner_fit,
    reference_loops,
    reference_no_fit,
    reference_swept,
    verify,
)

# The tests import one another by bare names, as pytest sets them up.
sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parent / "support"))
import tampering
from decisions import NOTED, ROOT, load_noted_kernel
from shape_certificates import falsified
from small_pairs import Shape, SmallPair, breed, draw, draw_shapeless, shares_direction, shrink

SHARD = 1000
ROUND = 4  # shards that know of the same rounds before them
NOTED_SHARE, DEEP_SHARE = 4, 40  # one of so many
SHAPELESS_SHARE, FRESH_SHARE = 5, 4  # of those drawn; of the former, not bred from the last one
KEPT = 4  # pairs for each outcome
FALSIFIED = 4  # changes of each certificate
RARE = 0.02  # of the pairs that notes are taken of


class Answer(NamedTuple):
    """What came of one pair; `failure` is empty when all is well."""

    kind: str
    fits: int
    holes: int
    failure: str = ""


class Shard(NamedTuple):
    """What came of a shard, as the journal has it."""

    number: int
    kinds: dict[str, int]
    fits: int
    holes: int
    seconds: float
    noted: int
    seen: dict[str, int]  # the number of pairs for each outcome, "decision:way"
    kept: list[tuple[str, Any]]
    failures: list[str]


class Known:
    """What the rounds before have seen."""

    def __init__(self) -> None:
        self.noted = 0
        self.hits: Counter[str] = Counter()
        self.kept: dict[str, list[Any]] = defaultdict(list)

    def learn(self, shard: Shard) -> None:
        """Add what a shard has seen."""
        self.noted += shard.noted
        self.hits.update(shard.seen)
        for outcome, pair in shard.kept:
            if self.wants(outcome):
                self.kept[outcome].append(pair)

    def wants(self, outcome: str) -> bool:
        """Whether more pairs with an outcome are to be kept."""
        return len(self.kept.get(outcome, ())) < KEPT

    def is_rare(self, outcome: str) -> bool:
        """Whether few pairs have had an outcome."""
        return self.hits[outcome] <= RARE * self.noted

    def pick(self, rng: Random, count: int) -> list[SmallPair]:
        """Pairs with rare outcomes, the rarest most often."""
        outcomes = sorted(self.kept)
        if not outcomes:
            return []
        weights = [1 / self.hits[outcome] for outcome in outcomes]
        chosen = rng.choices(outcomes, weights, k=count)
        return [_read_pair(rng.choice(self.kept[outcome])) for outcome in chosen]


def _read_pair(written: Any) -> SmallPair:
    return SmallPair(*([[(x, y) for x, y in ring] for ring in shape] for shape in written))


# --- One pair ------------------------------------------------------------------------------------


def answer(pair: SmallPair, kernel: Any = exactsweep, deep: bool = False) -> Answer:
    """Sweep a pair and hold it against the definition."""
    try:
        return _hold(pair, kernel, deep)
    except Exception as error:
        return Answer("", 0, 0, f"{type(error).__name__}: {error}")


def _hold(pair: SmallPair, kernel: Any, deep: bool) -> Answer:
    shapes = g, d = _shapes(pair, exactsweep)
    if kernel is not exactsweep:
        shapes = _shapes(pair, kernel)
    s = kernel.sweep(*shapes)
    failure = ""
    if s.kind == "SS":
        n = kernel.no_fit_polygon(shapes[1], shapes[0])
        if (n.exterior.vertices, _vertices(n.holes), n.exact_fits) != reference_no_fit(d, g):
            failure = "no-fit polygon"
    else:
        for name, loop in reference_loops(g, d, s.direction)._asdict().items():
            if getattr(s, name).vertices != loop:
                failure = f"{name}, swept in direction {s.direction}"
        if s.exact_fits != reference_exact_fits(g, d, s.direction):
            failure = f"exact fits, swept in direction {s.direction}"
    if deep and not failure:
        failure = _hold_deeply(pair, s, kernel.inner_fit_polygon(shapes[1], shapes[0]))
    return Answer(s.kind, len(s.exact_fits), len(s.no_fit_holes), failure)


def _hold_deeply(pair: SmallPair, s: Any, inner: Any) -> str:
    """Hold everything else that is known about a pair against the definition."""
    g, d = _shapes(pair, exactsweep)
    if shares_direction(pair) != (s.kind != "SS"):
        return f"kind {s.kind}"
    result = verify(s.certificate())
    if not result.proved:
        return f"certificate: {result.reason}"
    if s.kind == "SS":
        if (s.outer.vertices, s.inner.vertices, _vertices(s.unswept)) != reference_swept(d, g):
            return "swept area"
    else:
        if (s.trajectory.vertices, (), s.exact_fits) != reference_no_fit(d, g):
            return "the two definitions differ"
        if sum(u.polygon.area for u in s.undercuts) + d.area != s.inner.area:
            return "areas of the undercuts"
        if not all(s.vertex_contacts):
            return "a vertex of the trajectory without contact"
    if not all(s.contacts):
        return "an edge of the trajectory without contact"
    if failure := _find_accepted((s.certificate(), inner.certificate()), Random(repr(pair))):
        return failure
    regions = tuple((r.exterior.vertices, _vertices(r.holes)) for r in inner.regions)
    if (regions, inner.exact_fits) != reference_inner_fit(d, g):
        return "inner fit"
    return ""


def _find_accepted(certificates: Sequence[Any], rng: Random) -> str:
    """Change certificates in one place each; none may be proved then."""
    for certificate in certificates:
        change = falsified if "claim" in certificate else tampering.changes
        changed = list(change(certificate, rng))
        for name, false in rng.sample(changed, min(FALSIFIED, len(changed))):
            if verify(false).proved:
                return f"proved, though changed: {name}"
    return ""


def _shapes(pair: SmallPair, kernel: Any) -> tuple[Any, Any]:
    return _shape(pair.generatrix, kernel), _shape(pair.directrix, kernel)


def _shape(shape: Shape, kernel: Any) -> Any:
    return kernel.Region(shape[0], shape[1:]) if shape[1:] else kernel.Polygon(shape[0])


def _vertices(loops: Any) -> Any:
    return tuple(loop.vertices for loop in loops)


# --- Many pairs ----------------------------------------------------------------------------------


def pairs_of(rng: Random, known: Known) -> Iterator[SmallPair]:
    """The pairs of a shard, every second one bred from what is known."""
    parents = known.pick(rng, SHARD)
    shapeless = draw_shapeless(rng)
    for k in range(SHARD):
        if parents and k % 2:
            yield breed(rng, parents[k])
        elif rng.randrange(SHAPELESS_SHARE):
            yield draw(rng)
        else:
            fresh = rng.randrange(FRESH_SHARE) == 0
            shapeless = draw_shapeless(rng) if fresh else breed(rng, shapeless)
            yield shapeless


def run_shard(seed: int, known: Known, number: int) -> Shard:
    """Draw the pairs of a shard, and hold them against the definition."""
    start = time.process_time()
    noting, notes = load_noted_kernel()
    kinds: Counter[str] = Counter()
    seen: Counter[str] = Counter()
    fits = holes = noted = 0
    kept, failures = [], []
    for k, pair in enumerate(pairs_of(Random(f"{seed}:{number}"), known)):
        takes_notes = (k // 2) % NOTED_SHARE == 0
        deep = (k // 2) % DEEP_SHARE == 0
        found = answer(pair, noting if takes_notes else exactsweep, deep)
        if found.failure:
            failures.append(describe(pair, found))
        kinds[found.kind] += 1
        fits += found.fits
        holes += found.holes
        if takes_notes:
            noted += 1
            for outcome in sorted(notes.take_up()):
                name = f"{outcome.decision}:{outcome.way}"
                seen[name] += 1
                if known.is_rare(name) and known.wants(name) and seen[name] <= KEPT:
                    kept.append((name, pair))
    seconds = round(time.process_time() - start, 2)
    return Shard(number, dict(kinds), fits, holes, seconds, noted, dict(seen), kept, failures)


def find_failure(seed: int, count: int) -> str:
    """Hold a few pairs of all classes, and what is bred from them, against the definition."""
    rng = Random(f"few {seed}")
    for k in range(count):
        drawn = draw_shapeless(rng) if k % 5 == 4 else draw(rng)
        for pair in (drawn, breed(rng, drawn)):
            if failure := answer(pair, deep=k % 2 == 0).failure:
                return f"{failure}: {pair}"
    return ""


def describe(pair: SmallPair, found: Answer) -> str:
    """A failing pair, and the smallest one that it leads to."""
    least = shrink(pair, lambda candidate: bool(answer(candidate, deep=True).failure))
    return f"{found.failure}\n    G, D = {least.generatrix}, {least.directrix}\n    from {pair}"


def run(seed: int, count: int, done: list[Shard], workers: int) -> Iterator[Shard]:
    """Run the shards that are not done, in rounds."""
    known = Known()
    with ProcessPoolExecutor(workers) as pool:
        for first in range(0, count, ROUND):
            numbers = range(first, min(first + ROUND, count))
            ready = {shard.number: shard for shard in done if shard.number in numbers}
            missing = [number for number in numbers if number not in ready]
            for shard in pool.map(partial(run_shard, seed, known), missing):
                ready[shard.number] = shard
                yield shard
            for number in numbers:
                known.learn(ready[number])


# --- The journal and the summary -----------------------------------------------------------------


def digest() -> str:
    """What tells one state of the decisions from another."""
    files = (ROOT.joinpath(*name.split(".")).with_suffix(".py") for name in NOTED)
    return hashlib.sha256(b"".join(path.read_bytes() for path in files)).hexdigest()[:16]


def read_journal(path: Path, seed: int) -> list[Shard]:
    """The shards that are done; a new journal is begun if there is none."""
    if not path.exists():
        command = ["git", "-C", str(ROOT), "rev-parse", "--short", "HEAD"]
        commit = subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()
        head = {"seed": seed, "kernel": digest(), "commit": commit, "date": f"{date.today()}"}
        path.write_text(json.dumps(head) + "\n")
    first, *lines = path.read_text().splitlines(keepends=True)
    head = json.loads(first)
    if (head["seed"], head["kernel"]) != (seed, digest()):
        raise click.ClickException(f"{path} is of another seed or another kernel")
    if lines and not lines[-1].endswith("\n"):  # it was stopped while it wrote
        path.write_text("".join([first, *lines[:-1]]))
        del lines[-1]
    return [Shard(**json.loads(line)) for line in lines]


def summarise(shards: list[Shard], console: Console, show_missing: bool) -> None:
    """Print counts by class, and how many outcomes there have been of those that there are."""
    _, notes = load_noted_kernel()
    kinds: Counter[str] = Counter()
    seen: Counter[str] = Counter()
    for shard in shards:
        kinds.update(shard.kinds)
        seen.update(shard.seen)
    table = Table("class", "pairs")
    for kind in sorted(kinds):
        table.add_row(kind or "failed", f"{kinds[kind]:9,}")
    console.print(table)
    fits, holes = (sum(getattr(s, name) for s in shards) for name in ("fits", "holes"))
    missing = [
        f"  {decision.module} {decision.line}: {way}  {decision.source}"
        for number, decision in enumerate(notes.decisions)
        for k, way in enumerate(decision.ways)
        if not seen[f"{number}:{k}"]
    ]
    every = sum(len(decision.ways) for decision in notes.decisions)
    failures = sum(len(shard.failures) for shard in shards)
    tell(
        console,
        f"{kinds.total():,} pairs, {fits:,} exact fits, {holes:,} holes",
        f"{every - len(missing)} of {every} outcomes of {len(notes.decisions)} decisions",
        *(["never:", *missing] if show_missing else []),
        f"{failures} mismatches, {sum(s.seconds for s in shards):,.0f} s",
    )


def tell(console: Console, *lines: str) -> None:
    """Print lines as they are."""
    for line in lines:
        console.print(line, highlight=False, markup=False, soft_wrap=True)


@click.command()
@click.option("--pairs", default=20_000, show_default=True, help="How many, in thousands.")
@click.option("--seed", default=1, show_default=True)
@click.option("--journal", type=click.Path(path_type=Path), default="small_campaign.jsonl")
@click.option("--workers", default=1, show_default=True, help="How many processes.")
@click.option("--never", is_flag=True, help="List what no pair has made the kernel decide.")
def main(pairs: int, seed: int, journal: Path, workers: int, never: bool) -> None:
    """Hold small pairs against the definition, or go on with it."""
    console = Console()
    shards = read_journal(journal, seed)
    with journal.open("a") as written:
        for shard in run(seed, -(-pairs // SHARD), list(shards), workers):
            shards.append(shard)
            written.write(json.dumps(shard._asdict()) + "\n")
            written.flush()
            tell(console, *(f"shard {seed}:{shard.number}: {text}" for text in shard.failures))
    summarise(shards, console, never)
    sys.exit(any(shard.failures for shard in shards))


if __name__ == "__main__":
    main()
