"""Minkowski sums of Clipper and Clipper2, by the packages pyclipper and clipper2-py.

Promise: integers of up to 62 and 61 bits; crossings are rounded to integers. `MinkowskiSum` moves a
pattern along a path, so it is the sum of two boundaries.

Question: the sum of -G, the pattern, and D, the closed path, scaled to integers, without holes. The
sum of two boundaries may have false or larger holes. If it has a hole, or a ring touches itself,
the answer is the union of all rings and `list_fillings` by the nonzero rule.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from importlib.metadata import version
from typing import Any

from benchmarks.peers.adapters.adapter import (
    Adapter,
    AnsweredRings,
    AskedRing,
    AskedShape,
    list_fillings,
    require_range,
    sum_adapter,
)


def adapter(name: str) -> Adapter:
    """Make the adapter of either program."""
    return _clipper() if name == "pyclipper" else _clipper2()


def _clipper() -> Adapter:
    import pyclipper

    def unite(paths: Sequence[AskedRing]) -> Any:
        union = pyclipper.Pyclipper()
        union.AddPaths(paths, pyclipper.PT_SUBJECT, True)
        return union.Execute(pyclipper.CT_UNION, pyclipper.PFT_NONZERO, pyclipper.PFT_NONZERO)

    program = f"pyclipper {version('pyclipper')} (Clipper 6.4.2)"
    return _adapter(program, 62, pyclipper.MinkowskiSum, pyclipper.Orientation, unite)


def _clipper2() -> Adapter:
    import clipper2
    import numpy as np

    def unite(paths: Sequence[AskedRing]) -> Any:
        return clipper2.union([np.array(path) for path in paths], clipper2.FillRule.NON_ZERO)

    program = f"Clipper2 {clipper2.CLIPPER2_VERSION} (clipper2-py {version('clipper2-py')})"
    return _adapter(program, 61, clipper2.minkowski_sum, clipper2.is_positive, unite)


def _adapter(
    program: str,
    bits: int,
    add: Callable[[AskedRing, AskedRing, bool], Any],
    is_outer: Callable[[Any], bool],
    unite: Callable[[Sequence[AskedRing]], Any],
) -> Adapter:
    def add_up(first: AskedShape, second: AskedShape) -> AnsweredRings:
        require_range(first, second, 2**bits - 1)
        (directrix,), (inverse,) = first, second
        paths = list(add(inverse, directrix, True))
        rings = pairs(paths)
        if all(map(is_outer, paths)) and all(len(set(ring)) == len(ring) for ring in rings):
            return rings
        return pairs(unite([*rings, *list_fillings(directrix, inverse)]))

    def pairs(paths: Iterable[Iterable[Any]]) -> list[AskedRing]:
        return [[(int(x), int(y)) for x, y in path] for path in paths]

    return sum_adapter(program, "int64", add_up)
