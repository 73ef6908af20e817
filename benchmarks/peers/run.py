"""Runs all programs on all cases, one after the other, in processes of their own.

The kernel is measured before and after the others on each pair, so that a machine that is
busier at one time than at another shows in its spread and not in the ratios.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterable
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple, cast

from benchmarks.clock import Times, machine, milliseconds
from benchmarks.outlines import list_outlines
from benchmarks.peers import ours
from benchmarks.peers.adapted import NAMES, version
from benchmarks.peers.cases import CASES, FLOOR_CASES, LOOPS, MEMORY_CASE, TRAJECTORY, Case
from benchmarks.peers.cgal import Cgal, compile_program
from benchmarks.peers.measured import Comparison, Result
from benchmarks.peers.process import StoppedError, run
from benchmarks.peers.worker import Loop
from exactsweep import Polygon
from exactsweep.conform.adapters import MissingError
from exactsweep.corpus.generator.shapes import Ring

OURS, CHECKED, CGAL, FLOOR = "exactsweep", "with checks", "CGAL", "floor"
READING = "ints to polygons"
FUNCTIONS = {TRAJECTORY: "trajectory", LOOPS: "loops"}
SECONDS = 0.5
STARTING = 3.0
"""Seconds that a process of Python may take to start, beyond the limit."""
UNLIMITED = 3600.0


def compare(
    folder: Path,
    *,
    limit: float,
    quick: bool = False,
    cgal_program: Path | None = None,
    say: Callable[[str], None] = print,
) -> Comparison:
    """Measure everything.

    Args:
        folder: where CGAL's program is compiled.
        limit: seconds that one program may take on one case.
        quick: pairs up to 64 vertices only.
        cgal_program: CGAL's program, if it is compiled already.
        say: a function that is called with the current activity.
    """
    found = Comparison(machine(), versions={OURS: ours.version()})
    cgal: Cgal | None = None
    try:
        cgal = Cgal(cgal_program or compile_program(folder), limit)
        found.versions[CGAL] = f"CGAL {cgal.version}"
    except MissingError as problem:
        found.skipped[CGAL] = str(problem)
    peers = []
    for name in NAMES:
        try:
            found.versions[name] = version(name)
            peers.append(name)
        except MissingError as problem:
            found.skipped[name] = str(problem)
    for case in CASES:
        if quick and max(case.m, case.n) > 64:
            continue
        say(f"{case.family} {case.m}, {case.n}")
        found.results += measure(case, peers, cgal, limit)
    for case in () if quick else FLOOR_CASES:
        say(f"floor of {case.family} {case.m}, {case.n}")
        found.results += measure_floor(case)
    say("small pairs")
    for operation in (TRAJECTORY, LOOPS):
        found.pairs_a_second[operation] = pairs_a_second(operation)
        found.pairs_a_second[f"{operation}, {CHECKED}"] = pairs_a_second(operation, checked=True)
    if not quick:
        say("memory")
        found.memory = memory(MEMORY_CASE)
    return found


def measure(case: Case, peers: Iterable[str], cgal: Cgal | None, limit: float) -> list[Result]:
    """All programs on one pair."""
    before = {operation: run_ours(case, operation) for operation in case.operations}
    exact = {operation: ran.loops for operation, ran in before.items()}
    results = []
    if cgal is not None:
        results += measure_cgal(case, cgal, limit, exact)
    for name in peers:
        try:
            times, loops, _ = run_worker("adapted", name, case, limit)
            results.append(_result(name, TRAJECTORY, case, times, exact[TRAJECTORY], loops))
        except StoppedError as problem:
            results.append(Result(name, TRAJECTORY, case, note=str(problem)))
    for operation in case.operations:
        times = before[operation].times + run_ours(case, operation).times
        results.append(_result(OURS, operation, case, times, exact[operation], exact[operation]))
        times, loops, _ = run_worker("ours", f"checked_{FUNCTIONS[operation]}", case, UNLIMITED)
        results.append(_result(CHECKED, operation, case, times, exact[operation], loops))
    return results


def measure_cgal(
    case: Case, cgal: Cgal, limit: float, exact: dict[str, list[Loop]]
) -> list[Result]:
    """The trajectory by the fastest strategy, and the three loops by the fastest for each."""
    generatrix, directrix = case.pair()
    inverse = [(-x, -y) for x, y in generatrix]
    slow = f"> {limit:g} s"
    trajectory = cgal.best(case.family, TRAJECTORY, directrix, inverse)
    if trajectory is None:
        return [Result(CGAL, operation, case, note=slow) for operation in case.operations]
    one = _result(CGAL, TRAJECTORY, case, trajectory.times, exact[TRAJECTORY], [trajectory.loop])
    one.note = trajectory.strategy
    if LOOPS not in case.operations:
        return [one]
    swept = exact[TRAJECTORY][0]
    inner = cgal.best(case.family, "inner", swept, generatrix)
    outer = cgal.best(case.family, "outer", swept, generatrix)
    if inner is None or outer is None:
        return [one, Result(CGAL, LOOPS, case, note=slow)]
    times = Times(*map(sum, zip(trajectory.times, inner.times, outer.times, strict=True)))
    three = _result(
        CGAL, LOOPS, case, times, exact[LOOPS], [trajectory.loop, inner.loop, outer.loop]
    )
    three.note = "; ".join(best.strategy for best in (trajectory, inner, outer))
    return [one, three]


def measure_floor(case: Case) -> list[Result]:
    """A trajectory, the making of its Fractions alone, and the reading of its polygons."""
    times, loops, _ = run_ours(case, TRAJECTORY)
    floor = run_worker("ours", "floor", case, UNLIMITED).times
    reading = run_worker("ours", "reading", case, UNLIMITED).times
    return [
        _result(OURS, TRAJECTORY, case, times + run_ours(case, TRAJECTORY).times, loops, loops),
        _result(FLOOR, TRAJECTORY, case, floor, loops, loops),
        _result(READING, TRAJECTORY, case, reading, loops, loops),
    ]


class Ran(NamedTuple):
    """One operation in a process of its own: milliseconds of each run, loops, bytes at most."""

    times: list[float]
    loops: list[Loop]
    memory: int


def run_ours(case: Case, operation: str) -> Ran:
    """The kernel; what it gives is the measure of all others."""
    return run_worker("ours", FUNCTIONS[operation], case, UNLIMITED)


def run_worker(module: str, operation: str, case: Case, limit: float) -> Ran:
    """Run an operation on the pair of a case, as `run_on`."""
    return run_on(case.pair(), module, operation, limit)


def run_on(
    pair: tuple[Ring, Ring], module: str, operation: str, limit: float, seconds: float = SECONDS
) -> Ran:
    """Run one operation on a pair in a process of its own.

    Raises StoppedError when it takes too long or fails.
    """
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


def _result(
    program: str,
    operation: str,
    case: Case,
    times: list[float] | Times,
    exact: list[Loop],
    given: list[Loop],
) -> Result:
    wrong = 0
    for right, answer in zip(exact, given, strict=True):
        if answer is not right and not same(right, answer):
            wrong += max(1, len(set(right) - {(Fraction(x), Fraction(y)) for x, y in answer}))
    return Result(
        program,
        operation,
        case,
        times if isinstance(times, Times) else Times.of(times),
        sum(map(len, exact)),
        wrong,
    )


def same(right: Loop, answer: Loop) -> bool:
    """Decide whether a loop is the same set of points as a canonical one."""
    try:
        return list(Polygon(answer).vertices) == list(right)
    except ValueError:
        return False


def pairs_a_second(operation: str, *, checked: bool = False, passes: int = 3) -> float:
    """Pairs of outlines of parts a second on one core, the median of some passes over all."""
    name = FUNCTIONS[operation]
    task = getattr(ours, f"checked_{name}" if checked else name)
    tasks = [task(*pair) for _, pair in list_outlines(["parts"])]

    def sweep_all() -> None:
        for sweep in tasks:
            sweep()

    times = [milliseconds(sweep_all, 0)[0] for _ in range(passes)]
    return 1000 * len(tasks) / Times.of(times).median


def memory(case: Case) -> dict[str, float]:
    """Peak memory of the trajectory in a process of its own; see `benchmarks.peers.memory`."""
    command = [sys.executable, "-m", "benchmarks.peers.memory"]
    peaks: dict[str, float] = json.loads(
        run([*command, case.family, str(case.m), str(case.n)], "", UNLIMITED)
    )
    return peaks
