"""CGAL's exact Minkowski sums by all its strategies, timed in the adapter's program.

`cgal_sums.cpp` in `benchmarks/peers/adapters` measures the time from exact input to exact
coordinates of the result. The three loops are three runs, each by its fastest strategy: D + I(G);
the result plus G; and the result eroded by I(G).
"""

from __future__ import annotations

import subprocess
from collections import Counter
from fractions import Fraction
from pathlib import Path
from shutil import which
from typing import NamedTuple

from benchmarks.clock import Times
from benchmarks.peers.adapters import MissingError
from benchmarks.peers.adapters.cgal_sum import SOURCE, TAKE_HOLES
from benchmarks.peers.adapters.names import CGAL_STRATEGIES
from benchmarks.peers.adapters.program import write_shape
from benchmarks.peers.process import StoppedError, TooSlowError, run
from benchmarks.peers.worker import Loop
from exactsweep import Polygon
from exactsweep.geometry.canonical import PolygonError

SECONDS = 0.5

SUMS = tuple((strategy, "sum") for strategy in CGAL_STRATEGIES)
EROSIONS = (
    *((strategy, "frame") for strategy in TAKE_HOLES),
    *((strategy, "halves") for strategy in CGAL_STRATEGIES),
)

# Strategies slower than the fastest by this factor are stopped, and skipped on larger pairs of the
# same family.
HOPELESS = 4.0


class Best(NamedTuple):
    """The fastest strategy for a sum or an erosion, its result, and the peak memory in bytes."""

    strategy: str
    times: Times
    loop: Loop
    memory: int


def compile_program(folder: Path, source: Path = SOURCE) -> Path:
    """Compile a program into a folder; raise MissingError without a compiler or CGAL."""
    compiler = which("g++") or which("clang++")
    if compiler is None:
        raise MissingError("no C++ compiler")
    program = folder / source.stem
    command = [compiler, "-std=c++17", "-O3", "-DNDEBUG", "-o", str(program), str(source)]
    done = subprocess.run([*command, "-lgmp", "-lmpfr"], capture_output=True, text=True)
    if done.returncode:
        problem = next((line for line in done.stderr.splitlines() if "error" in line), "")
        raise MissingError(f"cannot be compiled: {problem}")
    return program


class Cgal:
    """A runner of the program that skips slow strategies, and counts failures and wrong answers."""

    def __init__(self, program: Path, limit: float, seconds: float = SECONDS) -> None:
        self._program = program
        self._limit = limit
        self._seconds = seconds
        self.failed = self.differing = 0
        self._worth: dict[tuple[str, str], list[tuple[str, str]]] = {}
        self.version = run([program, "version"], "", limit).strip()

    def best(self, family: str, stage: str, p: Loop, q: Loop, mode: str = "") -> Best | None:
        """Find the fastest strategy for P + Q, or for P eroded by -Q; None if all are too slow."""
        strategies = self._worth.get((family, stage), EROSIONS if stage == "inner" else SUMS)
        found: list[tuple[Best, tuple[str, str]]] = []
        polygons: list[Polygon] = []
        allowed = self._limit
        self.failed = self.differing = 0
        for strategy in strategies:
            try:
                ran = self._run(strategy, p, q, allowed, mode)
                if ran is None:
                    continue
                polygons.append(Polygon(ran.loop))
            except (PolygonError, StoppedError):
                self.failed += 1
                continue
            found.append((ran, strategy))
            allowed = min(allowed, max(1.0, HOPELESS * ran.times.median / 1000))
        if not found:
            return None
        # Some strategies fail on collinear vertices, so CGAL's answer is that of the majority.
        answer = Counter(polygons).most_common(1)[0][0]
        found = [pair for pair, polygon in zip(found, polygons, strict=True) if polygon == answer]
        self.differing = len(polygons) - len(found)
        found.sort(key=lambda pair: pair[0].times.median)
        best = found[0][0]
        self._worth[family, stage] = [
            strategy for ran, strategy in found if ran.times.median <= HOPELESS * best.times.median
        ]
        return best

    def _run(
        self, strategy: tuple[str, str], p: Loop, q: Loop, allowed: float, mode: str
    ) -> Best | None:
        """Run one strategy; None if it is too slow."""
        command: list[str | Path] = [self._program, *strategy, str(self._seconds)]
        given = " ".join(write_shape([[*ring]]) for ring in (p, q))
        try:
            written = run(
                [*command, *([mode] if mode else [])], given, allowed, overhead=self._seconds
            )
        except TooSlowError:
            return None
        times, memory, *lines = written.splitlines()
        if min(map(float, times.split())) > 1000 * allowed:
            return None
        loop = [(Fraction(x), Fraction(y)) for x, y in map(str.split, lines)]
        name = strategy[0] if strategy[1] == "sum" else ", ".join(strategy)
        return Best(name, Times.of([*map(float, times.split())]), loop, 1024 * int(memory))
