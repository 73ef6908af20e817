"""KLayout: its Minkowski sum of polygons, on 32-bit integers; crossings are rounded."""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import version as installed

import klayout.db as db

from benchmarks.peers.worker import Loop
from exactsweep.corpus.generator.shapes import Ring

LIMIT = 2**31


def version() -> str:
    return f"klayout {installed('klayout')}"


def trajectory(generatrix: Ring, directrix: Ring) -> Callable[[], list[Loop]]:
    reach = max(abs(c) for part in (generatrix, directrix) for point in part for c in point)
    if 4 * reach >= LIMIT:
        raise OverflowError("coordinates beyond 32 bits")
    inverse = [(-x, -y) for x, y in generatrix]

    def run() -> list[Loop]:
        first, second = (
            db.Polygon([db.Point(x, y) for x, y in part]) for part in (directrix, inverse)
        )
        return [
            [(point.x, point.y) for point in first.minkowski_sum(second, False).each_point_hull()]
        ]

    return run
