"""The cost of `verify`, undercuts and the page, compared with the sweep.

The sweep time excludes the construction of the polygons. `verify` takes a parsed certificate;
`json.loads` has its own column.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from functools import partial
from itertools import product

from rich.table import Table

from benchmarks.clock import milliseconds
from benchmarks.families import FAMILIES
from exactsweep import Polygon, Sweep, sweep
from exactsweep.check import verify
from exactsweep.corpus.generator.growing import mm
from exactsweep.corpus.generator.shapes import Ring

VERIFY_BAR = 20.0
PAGE_BAR = 2000.0
NAMES = ("cc", "cm", "cm_hard", "mm", "stair")
SIZES = ((16, 16), (64, 64), (256, 64), (256, 256))


def comb(teeth: int, pitch: int = 4000, height: int = 10**6) -> Ring:
    """Make a comb of 4 k + 2 vertices, with teeth a quarter of the pitch wide."""
    top: Ring = []
    for x in range(0, pitch * teeth, pitch):
        top += [(x, 2 * height), (x + pitch // 4, 2 * height)]
        top += [(x + pitch // 4, height), (x + pitch, height)]
    return [(0, 0), (pitch * teeth, 0), *top[::-1]]


def least(call: Callable[[], object]) -> float:
    """Return the minimum time of several calls in milliseconds."""
    return min(milliseconds(call))


def after_loops(step: Callable[[Sweep], object], *pair: Polygon) -> float:
    """Return the minimum time of a step after the sweep, in milliseconds."""
    times = []
    for _ in range(3):
        s = sweep(*pair)
        take_loops(s)
        times += milliseconds(partial(step, s), seconds=0)
    return min(times)


def take_loops(s: Sweep) -> None:
    """Compute the three loops."""
    assert s.trajectory.vertices
    assert s.inner.vertices
    assert s.outer.vertices


def run_trajectory(generatrix: Polygon, directrix: Polygon) -> None:
    """Sweep, and compute the trajectory."""
    assert sweep(generatrix, directrix).trajectory.vertices


def run_loops(generatrix: Polygon, directrix: Polygon) -> None:
    """Sweep, and compute the three loops."""
    take_loops(sweep(generatrix, directrix))


def tabulate(*, quick: bool) -> Iterator[Table]:
    """Measure pairs of every family and, unless `quick`, the page of a large pair."""
    table = Table(
        *("family", "m, n", "trajectory", "three loops", "verify", "times", "JSON, times"),
        *("undercuts", "times the trajectory", "certificate"),
        title=f"milliseconds, minimum of runs; limit of verify: {VERIFY_BAR:g} times the loops",
    )
    for name, (m, n) in product(NAMES, SIZES[:1] if quick else SIZES):
        pair = tuple(map(Polygon, FAMILIES[name](m, n, 0)))
        text = json.dumps(sweep(*pair).certificate())
        certificate = json.loads(text)
        assert verify(certificate).proved
        trajectory, loops = least(partial(run_trajectory, *pair)), least(partial(run_loops, *pair))
        proof, reading = least(partial(verify, certificate)), least(partial(json.loads, text))
        undercuts = after_loops(lambda s: s.undercuts, *pair)
        table.add_row(
            *(name, f"{m}, {n}", f"{trajectory:.2f}", f"{loops:.2f}"),
            *(f"{proof:.1f}", f"{proof / loops:.1f}", f"{reading / loops:.1f}"),
            *(f"{undercuts:.2f}", f"{undercuts / trajectory:.1f}"),
            f"{after_loops(lambda s: s.certificate(), *pair):.1f}",
        )
    yield table
    if not quick:
        yield tabulate_page()


def tabulate_page() -> Table:
    """Time the page data of a zigzag of 1,000 vertices around a comb of 1,002."""
    # Only this benchmark needs the page.
    from exactsweep.view.data import gather_page_data

    pair = Polygon(mm(1002, 1000, 0)[0]), Polygon(comb(250))
    table = Table("the page of 1,000 around 1,002", "ms", title=f"limit: {PAGE_BAR:g} ms")
    table.add_row("three loops", f"{least(partial(run_loops, *pair)):.0f}")
    steps: dict[str, Callable[[Sweep], object]] = {
        "undercuts": lambda s: s.undercuts,
        "exact fits": lambda s: s.exact_fits,
        "contacts": lambda s: s.contacts,
        "certificate": lambda s: s.certificate(),
    }
    for name, step in steps.items():
        table.add_row(name, f"{after_loops(step, *pair):.0f}")
    table.add_row("the whole page", f"{least(lambda: gather_page_data(sweep(*pair))):.0f}")
    return table
