"""Run one operation of one program in a separate process, which can be stopped.

    python -m benchmarks.peers.worker MODULE OPERATION SECONDS < pair.json > result.json

The function OPERATION of MODULE takes the generatrix and the directrix, and returns the timed
function; for the module "adapted", OPERATION is the name of a program.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from fractions import Fraction
from importlib import import_module

from benchmarks.clock import milliseconds, peak, require_fine_clock

Coordinate = int | float | Fraction
Loop = Sequence[tuple[Coordinate, Coordinate]]


def main() -> None:
    require_fine_clock()
    module, operation, seconds = sys.argv[1:]
    pair = json.load(sys.stdin)
    program = import_module(f"benchmarks.peers.{module}")
    given = ([(x, y) for x, y in pair[name]] for name in ("generatrix", "directrix"))
    is_adapted = module == "adapted"
    task = program.prepare(operation, *given) if is_adapted else getattr(program, operation)(*given)
    result: list[Loop] = []

    def run() -> None:
        result[:] = task()

    times = milliseconds(run, float(seconds))
    memory = peak()
    loops = [[(str(Fraction(x)), str(Fraction(y))) for x, y in loop] for loop in result]
    if is_adapted:
        # The exterior is the leftmost ring.
        loops = [min(loops, key=lambda loop: min(Fraction(x) for x, _ in loop))]
    json.dump({"milliseconds": times, "loops": loops, "memory": memory}, sys.stdout)


if __name__ == "__main__":
    main()
