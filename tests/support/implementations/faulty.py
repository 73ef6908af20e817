"""A correct implementation with one fault: `python faulty.py FAULT`, or `--list` for the faults.

These are faults of processes, and some of geometry for the reports; `mistakes` has the others.
"""

from __future__ import annotations

import json
import os
import signal
import sys
import time
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from correct import answer, hello, written

Case = dict[str, Any]
Result = dict[str, Any]
Loop = list[tuple[Any, Any]]

SLOW = 30.0


def on(name: str, change: Callable[[Loop], Any]) -> Callable[[Result, Case], Result]:
    """Return a fault of one loop."""
    return lambda result, case: {**result, name: change(list(result[name]))}


def on_trajectory(change: Callable[[Loop], Any]) -> Callable[[Result, Case], Result]:
    return on("trajectory", change)


def notch(loop: Loop) -> int:
    """Return the place of the first reflex vertex, the end of a slide into a notch."""
    for k, (x, y) in enumerate(loop):
        (px, py), (qx, qy) = loop[k - 1], loop[(k + 1) % len(loop)]
        if (x - px) * (qy - y) < (y - py) * (qx - x):
            return k
    raise ValueError("convex")


def moved(loop: Loop, k: int, dx: object, dy: object) -> Loop:
    """One vertex moved."""
    x, y = loop[k]
    return [*loop[:k], (x + Fraction(str(dx)), y + Fraction(str(dy))), *loop[k + 1 :]]


def hull(loop: Loop) -> Loop:
    k = notch(loop)
    return loop[:k] + loop[k + 1 :]


def each(change: Callable[[Any], Any]) -> Callable[[Loop], Loop]:
    return lambda loop: [(change(x), change(y)) for x, y in loop]


def everywhere(change: Callable[[Loop], Loop]) -> Callable[[Result, Case], Result]:
    return lambda result, case: {
        **result,
        **{name: change(list(result[name])) for name in ("trajectory", "inner", "outer")},
    }


def sign_of_generatrix(result: Result, case: Case) -> Result:
    """Return the sum of D and G, about the reference point."""
    x, y = map(Fraction, case["reference"])
    turned = [[str(-Fraction(a)), str(-Fraction(b))] for a, b in case["generatrix"]]
    loop = answer({**case, "generatrix": turned, "reference": ["0", "0"]})["trajectory"]
    return {**result, "trajectory": [(a + x, b + y) for a, b in loop]}


GEOMETRY: dict[str, Callable[[Result, Case], Result]] = {
    "sign-of-g": sign_of_generatrix,
    "vertex-outward": on_trajectory(lambda loop: moved(loop, 0, "-1/3", "-1/3")),
    "vertex-inward": on_trajectory(lambda loop: moved(loop, 0, "1/3", "1/3")),
    "hull": on_trajectory(hull),
    "fit-dropped": lambda result, case: {**result, "exact_fits": []},
    "undercut-open": lambda result, case: {**result, "inner": case["directrix"]},
    "to-floats": everywhere(each(float)),
    "reversed": everywhere(lambda loop: loop[::-1]),
    "another-start": everywhere(lambda loop: loop[1:] + loop[:1]),
    "nan": on_trajectory(lambda loop: [(float("nan"), 0), *loop[1:]]),
    "wrong-id": lambda result, case: {**result, "id": "another"},
    "no-id": lambda result, case: {k: v for k, v in result.items() if k != "id"},
    "error": lambda result, case: {"id": case["id"], "error": "division by zero"},
    "unsupported": lambda result, case: {"id": case["id"], "unsupported": "too hard"},
}


def crash(line: str) -> None:
    print("about to fail", file=sys.stderr, flush=True)
    sys.exit(3)


def segfault(line: str) -> None:
    os.kill(os.getpid(), signal.SIGSEGV)


def slow(line: str) -> None:
    time.sleep(SLOW)
    print(line, flush=True)


def huge(line: str) -> None:
    while True:
        print('"trajectory": [' * 1000, end="")


def half(line: str) -> None:
    print(line[: len(line) // 2], end="", flush=True)
    sys.exit(0)


# A process that is done with an answer: what is written, and what happens then.
PROCESS: dict[str, Callable[[str], object]] = {
    "slow": slow,
    "silent": lambda line: None,
    "crash": crash,
    "segfault": segfault,
    "half-an-answer": half,
    "garbage": lambda line: print("Segmentation fault (core dumped)", flush=True),
    "debug-print": lambda line: print(f"computing ...\n{line}", flush=True),
    "binary": lambda line: sys.stdout.buffer.write(b"\x00\xff\xfe\n") and sys.stdout.flush(),
    "list": lambda line: print(f"[{line}]", flush=True),
    "huge": huge,
    "twice": lambda line: print(f"{line}\n{line}", flush=True),
}


def faulty(fault: str, case: Case) -> None:
    result = answer(case)
    if fault in GEOMETRY:
        print(written(GEOMETRY[fault](result, case)), flush=True)
    else:
        PROCESS[fault](written(result))


def main(fault: str) -> None:
    if fault == "--list":
        print(*GEOMETRY, *PROCESS)
        return
    print(written(hello(hello=f"faulty: {fault}")), flush=True)
    for line in sys.stdin:
        case = json.loads(line)
        if "bye" in case:
            break
        faulty(fault, case)


if __name__ == "__main__":
    main(sys.argv[1])
