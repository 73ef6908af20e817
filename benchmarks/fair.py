"""CGAL and the kernel on the same pairs in the same states: made anew, kept, and from text.

CGAL's time is that of its fastest strategy for the pair; a strategy that crashes or gives another
answer is counted. Both sides are measured in turn, on processor time, each as its least of some
runs.
"""

from __future__ import annotations

import json
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

from rich.table import Table

from benchmarks.clock import machine
from benchmarks.families import ANY_SHAPE, FAMILIES
from benchmarks.peers.cgal import write_input
from exactsweep import Polygon
from exactsweep.conform.adapters.names import CGAL_STRATEGIES
from exactsweep.corpus.generator.shapes import Ring
from exactsweep.geometry.canonical import PolygonError

MODES = {"anew": "", "kept": "kept", "text": "text"}
PAIRS = [(name, 16, 16) for name in FAMILIES] + [(name, 64, 64) for name in FAMILIES]
PAIRS += [("radial", 16, 16), ("radial", 64, 64), ("tangled", 26, 18)]
SECONDS = 0.3
LIMIT = 30.0
TURNS = 2

# The kernel's own process: reads the pair and a mode, writes milliseconds and the loop.
OURS = """
import json, sys
from benchmarks.clock import milliseconds
from exactsweep import Polygon, sweep
rings, mode, seconds = json.load(sys.stdin)
def make():
    return [Polygon([(x, y) for x, y in ring]) for ring in rings]
kept = make()
texts = [[(str(x), str(y)) for x, y in ring] for ring in rings]
fresh = iter([make() for _ in range(103)])
def run():
    if mode == "text":
        g, d = (Polygon(ring) for ring in texts)
    else:
        g, d = kept if mode == "kept" else next(fresh)
    return sweep(g, d).trajectory.vertices
run()
times = milliseconds(run, seconds)
json.dump([min(times), [[str(x), str(y)] for x, y in run()]], sys.stdout)
"""


class Answer(NamedTuple):
    """The least time in milliseconds, and the loop."""

    time: float
    loop: Polygon


def run_apart(command: list[str], given: str) -> str:
    """Run a program and return its output; nothing if it fails or takes too long."""
    try:
        done = subprocess.run(
            command,
            input=given,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            cwd=Path(__file__).parent.parent,
            timeout=LIMIT,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return ""
    return "" if done.returncode else done.stdout


def ask_ours(pair: tuple[Ring, Ring], mode: str) -> Answer | None:
    said = run_apart([sys.executable, "-c", OURS], json.dumps([pair, mode, SECONDS]))
    if not said:
        return None
    time, loop = json.loads(said)
    return Answer(time, Polygon(loop))


def ask_cgal(
    program: Path, pair: tuple[Ring, Ring], mode: str, ways: list[str]
) -> dict[str, Answer | None]:
    """Ask each strategy of CGAL; None if it crashes, takes too long or gives no polygon."""
    generatrix, directrix = pair
    rings = directrix, [(-x, -y) for x, y in generatrix]
    given = write_input(*rings)
    found: dict[str, Answer | None] = {}
    for way in ways:
        said = run_apart([str(program), way, "sum", str(SECONDS), *([mode] if mode else [])], given)
        try:
            times, *lines = said.splitlines() or [""]
            loop = Polygon([(Fraction(x), Fraction(y)) for x, y in map(str.split, lines)])
            found[way] = Answer(min(map(float, times.split())), loop)
        except (PolygonError, ValueError):
            found[way] = None
    return found


def measure(program: Path, name: str, m: int, n: int) -> list[str]:
    """The row of one pair: times in each mode, the ratios, and strategies that failed."""
    pair = (FAMILIES | ANY_SHAPE)[name](m, n, 0)
    row = [f"{name} {m}, {n}"]
    ours = [ask_ours(pair, "kept")]
    assert ours[0]
    right = ours[0].loop
    tried = ask_cgal(program, pair, "", [*CGAL_STRATEGIES])
    good = [way for way, found in tried.items() if found and found.loop == right]
    good.sort(key=lambda way: tried[way].time)  # type: ignore[union-attr]
    for name_of, mode in MODES.items():
        mine, theirs = [], []
        for _ in range(TURNS):
            own = ask_ours(pair, name_of)
            others = ask_cgal(program, pair, mode, good[:2])
            mine += [own] if own else []
            theirs += [found for found in others.values() if found]
        one, other = min(a.time for a in mine), min((a.time for a in theirs), default=0.0)
        row += [f"{one:.3f}", f"{other:.3f}", f"{other / one:.1f}"]
    crashed = sum(found is None for found in tried.values())
    wrong = len(tried) - len(good) - crashed
    return [*row, str(crashed), str(wrong)]


def tabulate(program: Path) -> Table:
    """The table of all pairs."""
    table = Table(title=machine())
    table.add_column("pair")
    for mode in MODES:
        for column in (mode, "CGAL", "times"):
            table.add_column(column, justify="right")
    for column in ("crashes", "other answers"):
        table.add_column(column, justify="right")
    for name, m, n in PAIRS:
        table.add_row(*measure(program, name, m, n))
    return table
