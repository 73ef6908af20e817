"""The work for a small pair: counts of interpreter instructions by kind, the same in every run.

A pair takes less than a millisecond, and a profiler adds more to each call than most functions
take.
"""

from __future__ import annotations

import gc
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from dis import get_instructions
from functools import cache, partial
from types import CodeType, FrameType
from typing import Any, NamedTuple

from rich.table import Table

from benchmarks.families import FAMILIES
from exactsweep import Polygon, Sweep, sweep
from exactsweep.procedures.monotone import LowerMM, MonotoneSolution

PAIRS = (("mm", 16), ("stair", 16), ("cm", 64))
TOO_NEW = (3, 12)  # the first CPython version that does not report all instructions
COUNTED = ("instructions", "calls", "objects", "Fractions", "products", "comparisons")


def take_halves(s: Sweep) -> tuple[LowerMM, LowerMM]:
    """Compute the lower and the upper sweep of a monotone pair."""
    assert isinstance(s.solution, MonotoneSolution)
    return s.solution.halves


class Step(NamedTuple):
    """A named step of a sweep, which may use earlier results."""

    name: str
    run: Callable[[Sweep], object]


STEPS = (
    Step("chains of both", take_halves),
    Step("trajectory, lower envelopes", lambda s: [half.trajectory for half in take_halves(s)]),
    Step("trajectory, vertices", lambda s: s.trajectory.vertices),
    Step("inner loop, chains", lambda s: [half.sweep_inner() for half in take_halves(s)]),
    Step("inner loop, vertices", lambda s: s.inner.vertices),
    Step("outer loop, chains", lambda s: [half.sweep_outer() for half in take_halves(s)]),
    Step("outer loop, vertices", lambda s: s.outer.vertices),
)


def count(run: Callable[[], object]) -> Counter[str]:
    """Count instructions, calls, objects, Fractions, products and comparisons.

    Calls are calls of Python functions. Objects are built by instructions or by classes. Products
    are multiplications and divisions.
    """
    found: Counter[str] = Counter()

    def trace(frame: FrameType, event: str, argument: Any) -> Any:
        if event == "call":
            found["calls"] += 1
            found["objects"] += frame.f_code.co_name == "__init__"
            frame.f_trace_opcodes = True
        elif event == "opcode":
            found["instructions"] += 1
            kind = _kinds(frame.f_code).get(frame.f_lasti)
            if kind:
                found[kind] += 1
        return trace

    def profile(frame: FrameType, event: str, argument: Any) -> None:
        if event == "c_call" and argument.__name__ == "__new__":
            found["objects"] += 1
            found["Fractions"] += argument == object.__new__

    before = sys.gettrace(), sys.getprofile()
    # The garbage collector may call other code at any time.
    collects = gc.isenabled()
    gc.disable()
    sys.setprofile(profile)
    sys.settrace(trace)
    try:
        run()
    finally:
        sys.settrace(before[0])
        sys.setprofile(before[1])
        if collects:
            gc.enable()
    return found


@cache
def _kinds(code: CodeType) -> dict[int, str]:
    """Classify the instructions of a function by kind."""
    kinds = {}
    for instruction in get_instructions(code):
        if instruction.opname == "COMPARE_OP":
            kinds[instruction.offset] = "comparisons"
        elif instruction.opname.startswith("BUILD_"):
            kinds[instruction.offset] = "objects"
        elif instruction.opname == "BINARY_OP" and instruction.argrepr.strip("=") in ("*", "//"):
            kinds[instruction.offset] = "products"
    return kinds


def tabulate() -> Iterator[Table]:
    """Tabulate the instructions of each step of a sweep, one table per pair."""
    for family, size in PAIRS:
        generatrix, directrix = map(Polygon, FAMILIES[family](size, size, 0))
        table = Table("step", *COUNTED, title=f"{family} ({size}, {size})")
        swept = sweep(generatrix, directrix)
        steps = [("classes and direction", count(partial(sweep, generatrix, directrix)))]
        steps += [(step.name, count(partial(step.run, swept))) for step in STEPS]
        steps.append(("all", sum((found for _, found in steps), Counter())))
        again = sweep(generatrix, directrix)
        runs = [count(partial(step.run, again)) for step in STEPS]
        steps.append(("all, for polygons swept before", sum(runs, steps[0][1])))
        for name, found in steps:
            table.add_row(name, *(f"{found[what]:,}" for what in COUNTED))
        yield table
