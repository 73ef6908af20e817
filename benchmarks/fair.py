"""CGAL and the kernel on the same pairs: cached, rebuilt and parsed polygons.

CGAL's time is that of its fastest strategy for each step, including exact coordinates of the
result; its three loops are three sums. Both programs run alternately. The table shows the minimum
processor time of several runs, and the peak memory in MB including the interpreter.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from statistics import median
from typing import NamedTuple

from rich.table import Table

from benchmarks.families import ANY_SHAPE, FAMILIES
from benchmarks.outlines import list_outlines
from benchmarks.peers.cgal import Best, Cgal
from benchmarks.peers.run import UNLIMITED, Ran, run_on, same
from exactsweep import sweep
from exactsweep.corpus.generator.shapes import Ring

# CGAL's modes, and the operations of `benchmarks.peers.ours` in the same state.
MODES = {"kept": "trajectory", "": "first", "text": "text"}
SIZES = (16, 64, 256)
SHAPES = (("radial", 16, 16), ("radial", 64, 64), ("radial", 256, 64), ("tangled", 26, 18))
# The themes of the corpus with outlines of parts.
CORPUS = ("caves", "interlocking", "jigsaw", "parts", "rectilinear", "spirals")
ONE_OF = 8  # measures one in eight pairs of a theme
TURNS = 2
SECONDS = 0.1  # of repetitions of each operation in each turn
BYTES = 1_000_000

Pair = tuple[Ring, Ring]


class Side(NamedTuple):
    """The minimum time in milliseconds, and the peak memory in bytes."""

    time: float
    memory: int


class Measured(NamedTuple):
    """The kernel and CGAL on one pair in one state."""

    ours: Side
    cgal: Side

    @property
    def ratio(self) -> float:
        """The time of CGAL divided by that of the kernel."""
        return self.cgal.time / self.ours.time

    def cells(self) -> list[str]:
        return [f"{self.ours.time:.3f}", f"{self.cgal.time:.3f}", f"{self.ratio:.2f}"]


def measure(
    cgal: Cgal, name: str, pair: Pair, operation: str, mode: str = "kept"
) -> Measured | None:
    """Measure both programs in one mode; None if CGAL has no correct answer within its limit."""
    generatrix, directrix = pair
    inverse = [(-x, -y) for x, y in generatrix]
    ours: list[Ran] = []
    theirs: list[list[Best]] = []
    for _ in range(TURNS):
        ours.append(run_on(pair, "ours", operation, UNLIMITED, SECONDS))
        path, *others = ours[0].loops
        steps = [cgal.best(name, "trajectory", directrix, inverse, mode)]
        failed, differing = cgal.failed, cgal.differing
        if operation == "loops":
            steps += [
                cgal.best(name, stage, path, generatrix, mode) for stage in ("inner", "outer")
            ]
        cgal.failed, cgal.differing = failed, differing
        found = [step for step in steps if step]
        right = [path, *others] if len(steps) == 3 else [path]
        if len(found) < len(steps) or not all(map(same, right, (step.loop for step in found))):
            return None
        theirs.append(found)
    return Measured(
        Side(min(min(ran.times) for ran in ours), max(ran.memory for ran in ours)),
        Side(
            min(sum(step.times.least for step in steps) for steps in theirs),
            max(step.memory for steps in theirs for step in steps),
        ),
    )


def measure_row(cgal: Cgal, name: str, m: int, n: int) -> list[str]:
    """Return the row of one pair: each mode, three loops, memory, and failed strategies."""
    pair = (FAMILIES | ANY_SHAPE)[name](m, n, 0)
    row = [f"{name} {m}, {n}"]
    failures = None
    for mode, operation in MODES.items():
        found = measure(
            cgal, name, pair, "no_fit" if name in ANY_SHAPE and mode == "kept" else operation, mode
        )
        failures = failures or (cgal.failed, cgal.differing)
        row += found.cells() if found else ["-"] * 3
    loops = None if name in ANY_SHAPE else measure(cgal, name, pair, "loops")
    row += loops.cells() if loops else ["-"] * 3
    held = loops or found
    row += [f"{side.memory / BYTES:.0f}" for side in held] if held else ["-"] * 2
    return [*row, *map(str, failures or ())]


def measure_outlines(cgal: Cgal) -> Iterator[list[str]]:
    """Yield rows for themes of the corpus by class: pairs, ratios, unanswered, memory."""
    outlines: defaultdict[str, list[Pair]] = defaultdict(list)
    for family, pair in list_outlines(CORPUS):
        kind = "any shape" if sweep(*pair).kind == "SS" else "monotone"
        outlines[f"{family}, {kind}"].append(pair)
    for name, pairs in outlines.items():
        all_of = [measure(cgal, name, pair, "no_fit") for pair in pairs[::ONE_OF]]
        found = [measured for measured in all_of if measured]
        if found:
            yield [name, *_summarize(found), str(len(all_of) - len(found))]


def _summarize(found: Sequence[Measured]) -> list[str]:
    ratios = sorted(measured.ratio for measured in found)
    memory = [max(side.memory for side in sides) for sides in zip(*found, strict=True)]
    return [
        str(len(found)),
        *(f"{ratio:.2f}" for ratio in (median(ratios), ratios[0], ratios[-1])),
        *(f"{held / BYTES:.0f}" for held in memory),
    ]


def tabulate(cgal: Cgal) -> Iterator[Table]:
    """Tabulate the families, and the outlines of the corpus."""
    failed = ("crashes", "other answers")
    table = Table(title=f"CGAL {cgal.version}")
    table.add_column("pair")
    for state in ("cached", "new", "from text", "three loops"):
        for column in (state, "CGAL", "times"):
            table.add_column(column, justify="right")
    for column in ("MB", "CGAL", *failed):
        table.add_column(column, justify="right")
    for name, m, n in [(name, k, k) for k in SIZES for name in FAMILIES] + list(SHAPES):
        table.add_row(*measure_row(cgal, name, m, n))
    yield table
    outlines = Table(
        title="Outlines of the corpus: no-fit polygons of cached shapes, speed relative to CGAL"
    )
    outlines.add_column("family")
    for column in ("pairs", "median", "min", "max", "MB", "CGAL", "unanswered by CGAL"):
        outlines.add_column(column, justify="right")
    for row in measure_outlines(cgal):
        outlines.add_row(*row)
    yield outlines
