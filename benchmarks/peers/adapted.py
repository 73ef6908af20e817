"""The exterior of the no-fit polygon by other programs, through their adapters."""

from __future__ import annotations

from collections.abc import Callable

from benchmarks.peers.adapters import load
from benchmarks.peers.adapters.adapter import prepare_shape
from benchmarks.peers.worker import Loop
from exactsweep.corpus.generator.shapes import Ring

NAMES = ("pysfcgal", "shapely", "pyclipper", "klayout")


def version(name: str) -> str:
    return load(name).hello.name


def prepare(name: str, generatrix: Ring, directrix: Ring) -> Callable[[], list[Loop]]:
    """Return a function that calls a program with prepared polygons."""
    adapter = load(name)
    number = float if adapter.hello.numbers == "binary64" else int
    d, g = (
        prepare_shape([[(number(x), number(y)) for x, y in ring]])
        for ring in (directrix, generatrix)
    )
    return lambda: list(adapter.ask("no_fit", d, g)["no_fit"])
