"""Clipper and Clipper2: their Minkowski sums, through the packages pyclipper and clipper2-py.

What they promise: integers of up to 62 and 61 bits in magnitude; vertices of the result are
integers, so crossings are rounded. `MinkowskiSum` moves a pattern along a path, so it is the sum of
two boundaries.

What they are asked: the sum of -G, as the pattern, and D, as a closed path, times the scale that
makes the case integer. Rings that run clockwise are holes, which the sum of two boundaries may
have where that of the polygons has none, and are left out. A ring that touches itself may have
such a hole, too; it is united with `fillings`, by the rule nonzero.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from importlib.metadata import version
from typing import Any

from exactsweep.conform.adapters.adapter import Adapter, Ring, fillings, peer_hello, require_range


def adapter(name: str) -> Adapter:
    """Return the adapter of either.

    Raises:
        ImportError: it is not installed.
    """
    return _clipper() if name == "pyclipper" else _clipper2()


def _clipper() -> Adapter:
    import pyclipper

    def unite(paths: Sequence[Ring]) -> Any:
        union = pyclipper.Pyclipper()
        union.AddPaths(paths, pyclipper.PT_SUBJECT, True)
        return union.Execute(pyclipper.CT_UNION, pyclipper.PFT_NONZERO, pyclipper.PFT_NONZERO)

    program = f"pyclipper {version('pyclipper')} (Clipper 6.4.2)"
    return _adapter(program, 62, pyclipper.MinkowskiSum, pyclipper.Orientation, unite)


def _clipper2() -> Adapter:
    import clipper2
    import numpy as np

    def unite(paths: Sequence[Ring]) -> Any:
        return clipper2.union([np.array(path) for path in paths], clipper2.FillRule.NON_ZERO)

    program = f"Clipper2 {clipper2.CLIPPER2_VERSION} (clipper2-py {version('clipper2-py')})"
    return _adapter(program, 61, clipper2.minkowski_sum, clipper2.is_positive, unite)


def _adapter(
    program: str,
    bits: int,
    add: Callable[[Ring, Ring, bool], Any],
    is_outer: Callable[[Any], bool],
    unite: Callable[[Sequence[Ring]], Any],
) -> Adapter:
    def rings(directrix: Ring, inverse: Ring) -> Sequence[Ring]:
        require_range(directrix, inverse, 2**bits - 1)
        outer = pairs(path for path in add(inverse, directrix, True) if is_outer(path))
        inside = fillings(outer, directrix, inverse)
        return pairs(unite([*outer, *inside])) if inside else outer

    def pairs(paths: Iterable[Iterable[Any]]) -> list[Ring]:
        return [[(int(x), int(y)) for x, y in path] for path in paths]

    return Adapter(peer_hello(program, "int64"), rings)
