"""CGAL: its exact Minkowski sums by every strategy it has, timed in the program of the adapter.

The program (`cgal_sums.cpp` in `benchmarks/peers/adapters`) times what is between reading exact
numbers and having exact coordinates of the result. The three loops are three runs: D + I(G); the
result plus G; and the result eroded by I(G), each by the strategy that is fastest for it.
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

# A strategy this many times slower than the fastest on a smaller pair of the same family is not
# tried on a larger one; on one pair none is given longer than this many times the fastest.
HOPELESS = 4.0


class Best(NamedTuple):
    """The fastest strategy for a sum or an erosion, and what it gave; most memory in bytes."""

    strategy: str
    times: Times
    loop: Loop
    memory: int


def compile_program(folder: Path, source: Path = SOURCE) -> Path:
    """Compile a program into a folder.

    Raises MissingError if there is no compiler or no CGAL for it.
    """
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
    """Runs the program, and remembers which strategies are worth a try.

    Args:
        program: the compiled program.
        limit: seconds that one run may take.
        seconds: for how long runs are repeated.

    Attributes:
        failed: how many strategies crashed or gave no polygon when `best` was last called.
        differing: how many gave another answer than most of them.
    """

    def __init__(self, program: Path, limit: float, seconds: float = SECONDS) -> None:
        self._program = program
        self._limit = limit
        self._seconds = seconds
        self.failed = self.differing = 0
        self._worth: dict[tuple[str, str], list[tuple[str, str]]] = {}
        self.version = run([program, "version"], "", limit).strip()

    def best(self, family: str, stage: str, p: Loop, q: Loop, mode: str = "") -> Best | None:
        """The fastest strategy to P + Q, or to P eroded by -Q.

        Args:
            family: the family of the pair.
            stage: "trajectory", "outer" or "inner"; what is learnt holds for family and stage.
            p: vertices of P, counter-clockwise.
            q: vertices of Q, counter-clockwise.
            mode: "kept" for all runs on the same polygons, "text" for reading them in each.

        Returns:
            None if no strategy ends within the limit.
        """
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
        # Some strategies go wrong on collinear vertices: what most of them say is CGAL's answer.
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
        """Run one strategy; None if it is too slow. On collinear vertices some of them crash."""
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
