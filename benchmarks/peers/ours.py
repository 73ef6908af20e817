"""The kernel, from polygons or from unchecked vertices to lists of Fractions.

Other programs do not check whether polygons are simple, so compare them with the kernel on
polygons.
"""

from __future__ import annotations

from collections.abc import Callable

import exactsweep
from benchmarks.clock import REPEATS
from benchmarks.peers.worker import Loop
from exactsweep.corpus.generator.shapes import Ring
from exactsweep.procedures import monotone

Outline = Ring | exactsweep.Polygon


def version() -> str:
    return f"exactsweep {exactsweep.__version__}"


def trajectory(generatrix: Outline, directrix: Outline) -> Callable[[], list[Loop]]:
    return checked_trajectory(exactsweep.Polygon(generatrix), exactsweep.Polygon(directrix))


def loops(generatrix: Outline, directrix: Outline) -> Callable[[], list[Loop]]:
    return checked_loops(exactsweep.Polygon(generatrix), exactsweep.Polygon(directrix))


def checked_trajectory(generatrix: Outline, directrix: Outline) -> Callable[[], list[Loop]]:
    return lambda: [exactsweep.sweep(generatrix, directrix).trajectory.vertices]


def checked_loops(generatrix: Outline, directrix: Outline) -> Callable[[], list[Loop]]:
    def run() -> list[Loop]:
        swept = exactsweep.sweep(generatrix, directrix)
        return [swept.trajectory.vertices, swept.inner.vertices, swept.outer.vertices]

    return run


def first(generatrix: Ring, directrix: Ring) -> Callable[[], list[Loop]]:
    """Compute the trajectory of new Polygons."""
    pairs = [
        (exactsweep.Polygon(generatrix), exactsweep.Polygon(directrix)) for _ in range(REPEATS)
    ]

    def run() -> list[Loop]:
        monotone.split_polygon.cache_clear()
        return [exactsweep.sweep(*pairs.pop()).trajectory.vertices]

    return run


def text(generatrix: Ring, directrix: Ring) -> Callable[[], list[Loop]]:
    """Compute the trajectory from coordinates as text."""
    given = [[(str(x), str(y)) for x, y in ring] for ring in (generatrix, directrix)]

    def run() -> list[Loop]:
        monotone.split_polygon.cache_clear()
        return [exactsweep.sweep(*map(exactsweep.Polygon, given)).trajectory.vertices]

    return run


def no_fit(generatrix: Ring, directrix: Ring) -> Callable[[], list[Loop]]:
    """Compute the no-fit polygon of two Polygons, and return its exterior."""
    orbiting, stationary = exactsweep.Polygon(generatrix), exactsweep.Polygon(directrix)

    def run() -> list[Loop]:
        found = exactsweep.no_fit_polygon(stationary, orbiting)
        assert isinstance(found.exact_fits, tuple)
        return [loop.vertices for loop in (found.exterior, *found.holes)]

    return run
