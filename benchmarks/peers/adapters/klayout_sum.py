"""Minkowski sums of KLayout's database module.

Promise: integers of 32 bits; vertices of the result are rounded to integers.

Question: `Polygon.minkowski_sum` of D and -G, scaled to integers, without resolving holes. Cases
whose result exceeds 32 bits are skipped. KLayout removes collinear vertices.
"""

from __future__ import annotations

from importlib.metadata import version
from typing import Any

from benchmarks.peers.adapters.adapter import (
    Adapter,
    AnsweredRings,
    AskedShape,
    require_range,
    sum_adapter,
)

MOST = 2**30 - 1


def adapter(name: str) -> Adapter:
    import klayout.db as db

    def polygon(shape: AskedShape) -> Any:
        exterior, *holes = ([db.Point(x, y) for x, y in ring] for ring in shape)
        found = db.Polygon(exterior)
        for hole in holes:
            found.insert_hole(hole)
        return found

    def add(directrix: AskedShape, inverse: AskedShape) -> AnsweredRings:
        require_range(directrix, inverse, MOST)
        total = polygon(directrix).minkowski_sum(polygon(inverse), False)
        holes = range(total.holes())
        found = [total.each_point_hull(), *(total.each_point_hole(hole) for hole in holes)]
        return [[(point.x, point.y) for point in ring] for ring in found]

    return sum_adapter(f"KLayout {version('klayout')}", "int32", add, shapes="any")
