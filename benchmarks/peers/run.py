"""The trajectory by the kernel and by other programs, each in its own process.

On each pair, the kernel runs before and after the others, so its spread shows changes of the
machine's load. `benchmarks.fair` measures CGAL.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from typing import Any, NamedTuple, cast

from rich.markup import escape
from rich.table import Table

from benchmarks.clock import Times, milliseconds
from benchmarks.families import ANY_SHAPE, FAMILIES
from benchmarks.outlines import list_outlines
from benchmarks.peers import ours
from benchmarks.peers.adapted import NAMES, version
from benchmarks.peers.adapters import MissingError
from benchmarks.peers.process import StoppedError, run
from benchmarks.peers.worker import Loop
from exactsweep import Polygon
from exactsweep.corpus.generator.shapes import Ring

OURS, CHECKED = "exactsweep", "with checks"
SIZES = ((16, 16), (64, 64), (256, 64), (256, 256))
# The family of each pair, and the numbers of vertices of its directrix and generatrix.
PAIRS = (
    *((family, m, n) for family in ("cc", "cm", "cm_hard", "mm", "stair") for m, n in SIZES),
    *(("cc", 10_000, 10_000), ("cm_hard", 1024, 256), ("mm", 1024, 256)),
    *(("tangled", 26, 18), *(("radial", m, n) for m, n in SIZES)),
)
TIMES = (
    "CPU time in ms: median (minimum to maximum). The kernel starts from Polygon objects; the "
    "times with checks start from lists of numbers, and include the check for simple polygons, "
    "which other programs omit. For polygons of any shape, the kernel finds all loops and fits."
)
SECONDS = 0.5
STARTING = 3.0  # additional seconds for starting Python
UNLIMITED = 3600.0


class Result(NamedTuple):
    """One program on one pair: `wrong` counts missing vertices; `note` replaces missing times."""

    program: str
    family: str
    m: int
    n: int
    times: Times | None
    wrong: int = 0
    note: str = ""

    def __str__(self) -> str:
        if self.times is None:
            return self.note
        median, least, greatest = (f"{t:.3g}" if t < 1000 else f"{t:.0f}" for t in self.times)
        return f"{median} ({least}..{greatest})" + (f" [{self.wrong}]" if self.wrong else "")


class Comparison(NamedTuple):
    """The results of a run, with the versions of the programs, and missing programs."""

    versions: dict[str, str]
    skipped: dict[str, str]
    results: list[Result]
    pairs_a_second: dict[str, float]


def compare(*, limit: float, quick: bool = False, say: Callable[[str], None] = print) -> Comparison:
    """Measure all pairs and programs."""
    versions, skipped = {OURS: ours.version(), CHECKED: "the same from lists"}, {}
    for name in NAMES:
        try:
            versions[name] = version(name)
        except MissingError as problem:
            skipped[name] = str(problem)
    results: list[Result] = []
    for family, m, n in PAIRS:
        if not (quick and max(m, n) > 64):
            say(f"{family} {m}, {n}")
            results += measure(family, m, n, [name for name in NAMES if name in versions], limit)
    say("small pairs")
    rates = {
        "trajectory": pairs_a_second(ours.trajectory),
        "trajectory, with checks": pairs_a_second(ours.checked_trajectory),
        "three loops": pairs_a_second(ours.loops),
        "three loops, with checks": pairs_a_second(ours.checked_loops),
    }
    return Comparison(versions, skipped, results, rates)


def measure(family: str, m: int, n: int, peers: Iterable[str], limit: float) -> Iterator[Result]:
    """Measure all programs on one pair."""
    pair = (FAMILIES | ANY_SHAPE)[family](m, n, 0)
    operation = "no_fit" if family in ANY_SHAPE else "trajectory"
    before = run_on(pair, "ours", operation, UNLIMITED)
    exact = before.loops[0]
    for name in peers:
        try:
            times, (loop, *_), _ = run_on(pair, "adapted", name, limit)
        except StoppedError as problem:
            yield Result(name, family, m, n, None, note=str(problem))
            continue
        lacking = 0 if same(exact, loop) else max(1, len({*exact} - {*loop}))
        yield Result(name, family, m, n, Times.of(times), lacking)
    after = run_on(pair, "ours", operation, UNLIMITED)
    yield Result(OURS, family, m, n, Times.of(before.times + after.times))
    checked = run_on(pair, "ours", "checked_trajectory", UNLIMITED)
    yield Result(CHECKED, family, m, n, Times.of(checked.times))


class Ran(NamedTuple):
    """The result of an operation in a separate process: ms of each run, loops, peak bytes."""

    times: list[float]
    loops: list[Loop]
    memory: int


def run_on(
    pair: tuple[Ring, Ring], module: str, operation: str, limit: float, seconds: float = SECONDS
) -> Ran:
    """Run one operation on a pair in a separate process; raise StoppedError if it fails."""
    generatrix, directrix = pair
    written = run(
        [sys.executable, "-m", "benchmarks.peers.worker", module, operation, str(seconds)],
        json.dumps({"generatrix": generatrix, "directrix": directrix}),
        limit,
        overhead=STARTING,
    )
    result: dict[str, Any] = json.loads(written)
    if min(result["milliseconds"]) > 1000 * limit:
        raise StoppedError(f"> {limit:g} s")
    loops = [[(Fraction(x), Fraction(y)) for x, y in loop] for loop in result["loops"]]
    return Ran(result["milliseconds"], cast(list[Loop], loops), result["memory"])


def same(right: Loop, answer: Loop) -> bool:
    """Decide whether a loop equals a canonical one."""
    try:
        return list(Polygon(answer).vertices) == list(right)
    except ValueError:
        return False


def pairs_a_second(task: Callable[[Ring, Ring], Callable[[], object]], passes: int = 3) -> float:
    """Measure pairs of outlines per second on one core, the median of several passes."""
    tasks = [task(*pair) for _, pair in list_outlines(["parts"])]

    def sweep_all() -> None:
        for sweep in tasks:
            sweep()

    times = [milliseconds(sweep_all, 0)[0] for _ in range(passes)]
    return 1000 * len(tasks) / Times.of(times).median


def tabulate(found: Comparison) -> Iterator[Table]:
    """Tabulate all pairs and programs, and the small pairs."""
    table = Table(
        "pair", title="the trajectory; in brackets, the number of inexact vertices", caption=TIMES
    )
    for name in found.versions:
        table.add_column(name, justify="right")
    cells = {result[:4]: escape(str(result)) for result in found.results}
    for family, m, n in PAIRS:
        if (OURS, family, m, n) in cells:
            row = (cells[name, family, m, n] for name in found.versions)
            table.add_row(f"{family} {m}, {n}", *row)
    yield table
    small = Table("operation", title="small pairs on one core: outlines of parts, 7 to 38 vertices")
    small.add_column("pairs per second", justify="right")
    for name, rate in found.pairs_a_second.items():
        small.add_row(name, f"{rate:.0f}")
    yield small
