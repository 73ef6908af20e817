"""pyclipper: its Minkowski sum, on integers; crossings are rounded to integers."""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import version as installed

import pyclipper

from benchmarks.peers.worker import Loop
from exactsweep.corpus.generator.shapes import Ring


def version() -> str:
    return f"pyclipper {installed('pyclipper')}"


def trajectory(generatrix: Ring, directrix: Ring) -> Callable[[], list[Loop]]:
    inverse = [(-x, -y) for x, y in generatrix]

    def run() -> list[Loop]:
        paths = pyclipper.MinkowskiSum(inverse, directrix, True)
        return [max(paths, key=lambda path: abs(pyclipper.Area(path)))]

    return run
