"""Seconds and memory of hard shapes over doubling sizes, each pair in a separate process.

    python -m benchmarks.growth CASE SIZE

Seconds of processor time exclude the construction of the polygons; memory is the peak of the
process, including the interpreter.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from math import cos, isqrt, pi, sin
from random import Random
from time import process_time
from typing import NamedTuple

from rich.table import Table

from benchmarks.clock import peak
from benchmarks.families import ANY_SHAPE
from benchmarks.peers.process import run
from exactsweep import Polygon, inner_fit_polygon, no_fit_polygon, sweep
from exactsweep.check import verify
from exactsweep.corpus.generator.growing import comb
from exactsweep.corpus.generator.shapes import Ring
from exactsweep.layout import Layout, judge_layout
from exactsweep.paper.growth import fit_exponent

LIMIT = 600.0
BYTES = 1_000_000
RUNS = 2

Question = Callable[[], object]


def strips(n: int) -> Ring:
    """Make a zigzag strip with n vertices and height 400."""
    up = [(2 * i, 400 if i % 2 else 0) for i in range(n // 2)]
    return up + [(x, y + 3) for x, y in reversed(up)]


def saw(n: int) -> Ring:
    """Make a saw with n vertices, n odd, and teeth of height 100."""
    return [(0, 0), (n - 3, 0), *((x, 100 if x % 2 else 3) for x in range(n - 3, -1, -1))]


def spikes(n: int, outer: int, inner: int) -> Ring:
    """Make a star of n vertices at two distances from the center."""
    ends = [((inner if k % 2 else outer), 2 * pi * k / n) for k in range(n)]
    return [(round(r * cos(angle)), round(r * sin(angle))) for r, angle in ends]


def hooks(n: int) -> Ring:
    """Make a comb of n = 8 k + 4 vertices whose teeth end in hooks."""
    tooth = (0, 10), (0, 20), (6, 20), (6, 14), (4, 14), (4, 18), (2, 18), (2, 10)
    lefts = range(10, 10 + 10 * (n // 8), 10)
    top = [(left + x, y) for left in lefts for x, y in tooth]
    return [(0, 0), (lefts[-1] + 20, 0), (lefts[-1] + 20, 10), *top[::-1], (0, 10)]


def ask_strips(n: int) -> Question:
    return ask_across(strips(n))


def ask_saws(n: int) -> Question:
    return ask_across(saw(n + 1))


def ask_across(ring: Ring) -> Question:
    upright, lying = Polygon(ring), Polygon([(-y, x) for x, y in ring])
    return lambda: no_fit_polygon(upright, lying).exact_fits


def ask_loops(generatrix: Polygon, directrix: Polygon) -> Question:
    def ask() -> None:
        swept = sweep(generatrix, directrix)
        assert swept.trajectory.vertices
        assert swept.inner.vertices
        assert swept.outer.vertices

    return ask


def plate(n: int) -> list[Ring]:
    """Make a square plate with n square holes at slightly random positions."""
    random, columns = Random(f"plate {n}"), isqrt(n - 1) + 1
    rings: list[Ring] = [[(0, 0), (10 * columns, 0), (10 * columns,) * 2, (0, 10 * columns)]]
    for k in range(n):
        x, y = (10 * at + random.randint(2, 5) for at in divmod(k, columns))
        rings.append([(x, y), (x, y + 3), (x + 3, y + 3), (x + 3, y)])
    return rings


def ask_plate(n: int) -> Question:
    exterior, *holes = plate(n)
    wide = exterior[2][0]
    layout = Layout.from_json(
        {
            "container": {"exterior": [(0, 0), (2 * wide, 0), (2 * wide, wide), (0, wide)]},
            "parts": [{"id": "plate", "exterior": exterior, "holes": holes}],
            "placements": [
                {"part": "plate", "turn": "0", "move": ["0", "0"]},
                {"part": "plate", "turn": "90", "move": [str(2 * wide), "0"]},
            ],
        }
    )
    return lambda: judge_layout(layout).certificate()


def ask_star(n: int) -> Question:
    return ask_loops(Polygon(spikes(2 * (n // 4), 1000, 50)), Polygon(spikes(n, 30000, 1500)))


def ask_pentagon(n: int) -> Question:
    return ask_loops(Polygon(spikes(n, 1000, 200)), Polygon(spikes(5, 100, 100)))


def ask_hooks(n: int) -> Question:
    container, part = Polygon(hooks(n)), Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    return lambda: inner_fit_polygon(container, part).regions


def ask_proof(n: int) -> Question:
    star = Polygon(spikes(n, 1000, 50))
    certificate = json.loads(json.dumps(sweep(star, star).certificate()))

    def ask() -> None:
        assert verify(certificate).proved

    return ask


def ask_denominators(n: int) -> Question:
    random = Random(f"denominators {n}")

    def lengthen(number: int) -> Fraction:
        divisor = random.randrange(10**29, 10**30)
        return number + Fraction(random.randrange(divisor), divisor)

    pair = ([(lengthen(x), lengthen(y)) for x, y in ring] for ring in ANY_SHAPE["radial"](n, n, 0))
    return ask_loops(*map(Polygon, pair))


def ask_digits(n: int) -> Question:
    random, unit = Random(f"digits {n}"), 10**296
    pair = (
        [(unit * x + random.randrange(unit), unit * y + random.randrange(unit)) for x, y in ring]
        for ring in (comb(n, 300, 3000), comb(n, 1000, 9000))
    )
    return ask_loops(*map(Polygon, pair))


class Case(NamedTuple):
    """A question about pairs of growing size."""

    what: str
    ask: Callable[[int], Question]
    sizes: tuple[int, ...]


CASES = {
    "strips": Case(
        "no-fit polygon of strips of n across strips of n",
        ask_strips,
        (50, 100, 200, 400),
    ),
    "saws": Case("no-fit polygon of a saw of n across a saw of n", ask_saws, (100, 200, 400)),
    "star": Case(
        "loops of a star of n / 2 around one of n",
        ask_star,
        (50, 100, 200),
    ),
    "pentagon": Case(
        "loops of a star of n around a pentagon",
        ask_pentagon,
        (250, 500, 1000),
    ),
    "hooks": Case("a square in a comb of n with hooks", ask_hooks, (604, 1204, 2404, 4804)),
    "plate": Case("certificate of two plates of n holes", ask_plate, (250, 500, 1000, 2000)),
    "proof": Case("verify of a star of n around itself", ask_proof, (24, 50, 100)),
    "denominators": Case(
        "loops of radial n, n with denominators of 30 digits", ask_denominators, (10, 20, 40)
    ),
    "digits": Case(
        "loops of combs of n, n with coordinates of 300 digits", ask_digits, (8, 16, 32)
    ),
}


class Grown(NamedTuple):
    """Seconds and MB of a case over its sizes."""

    case: Case
    sizes: tuple[int, ...]
    seconds: list[float]
    memory: list[float]

    @property
    def slopes(self) -> list[float]:
        """The exponents of seconds and of MB over the three largest sizes."""
        return [
            fit_exponent(self.sizes[-3:], values[-3:]) for values in (self.seconds, self.memory)
        ]


def measure_all(*, quick: bool = False) -> Iterator[Grown]:
    """Measure all cases; skip the largest sizes if `quick`."""
    for name, case in CASES.items():
        sizes = case.sizes[: -1 if quick else None]
        runs = [_measure(name, size) for size in sizes]
        yield Grown(case, sizes, *map(list, zip(*runs, strict=True)))


def _measure(name: str, size: int) -> tuple[float, float]:
    found = [
        json.loads(run([sys.executable, "-m", "benchmarks.growth", name, str(size)], "", LIMIT))
        for _ in range(RUNS)
    ]
    return min(one[0] for one in found), min(one[1] for one in found) / BYTES


def tabulate(measured: Iterable[Grown]) -> Table:
    """Tabulate all sizes of all cases, with the slopes at the largest sizes."""
    table = Table("case", title="seconds and MB, slopes over the three largest sizes")
    for column in ("n", "s", "times", "slope", "MB", "slope"):
        table.add_column(column, justify="right")
    for grown in measured:
        name, last = grown.case.what, 0.0
        for size, spent, held in zip(grown.sizes, grown.seconds, grown.memory, strict=True):
            times = f"{spent / last:.1f}" if last else ""
            is_largest = size == grown.sizes[-1]
            slopes = [f"{slope:.1f}" for slope in grown.slopes] if is_largest else ["", ""]
            row = (str(size), f"{spent:.3f}", times, slopes[0], f"{held:.0f}", slopes[1])
            table.add_row(name, *row, end_section=is_largest)
            name, last = "", spent
    return table


def main() -> None:
    name, size = sys.argv[1:]
    question = CASES[name].ask(int(size))
    started = process_time()
    question()
    print(json.dumps([process_time() - started, peak()]))


if __name__ == "__main__":
    main()
