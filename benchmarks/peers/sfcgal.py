"""pysfcgal: SFCGAL's Minkowski sum, which is CGAL's by decomposition, with exact numbers."""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction
from importlib.metadata import version as installed

from pysfcgal.geometry import Polygon

from benchmarks.peers.worker import Loop
from exactsweep.corpus.generator.shapes import Ring

_FIRST_RING = re.compile(r"\(([^()]*)\)")


def version() -> str:
    return f"pysfcgal {installed('pysfcgal')}"


def trajectory(generatrix: Ring, directrix: Ring) -> Callable[[], list[Loop]]:
    inverse = [(-x, -y) for x, y in generatrix]

    def run() -> list[Loop]:
        text = Polygon(directrix).minkowski_sum(Polygon(inverse)).to_wkt()
        ring = _FIRST_RING.findall(text)[0].split(",")[:-1]
        return [[(Fraction(x), Fraction(y)) for x, y in map(str.split, ring)]]

    return run
