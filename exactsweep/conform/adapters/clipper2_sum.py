"""Clipper2: its Minkowski sum, through the package clipper2-py.

What it promises: integers of up to 61 bits in magnitude; vertices of the result are integers, so
crossings are rounded. `MinkowskiSum` moves a pattern along a path, so it is the sum of two
boundaries.

What it is asked: the sum of -G, as the pattern, and D, as a closed path, times the scale that
makes the case integer. Rings that run clockwise are holes, which the sum of two boundaries may
have where that of the polygons has none, and are left out. A ring that touches itself may have
such a hole, too; it is united with `fillings`, by the rule nonzero.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from importlib.metadata import version
from typing import SupportsInt

from exactsweep.conform.adapters.adapter import (
    Adapter,
    Ring,
    fillings,
    peer_hello,
    require_range,
)

MOST = 2**61 - 1


def adapter(name: str) -> Adapter:
    """Return the adapter.

    Raises:
        ImportError: it is not installed.
    """
    import clipper2
    import numpy as np

    def rings(directrix: Ring, inverse: Ring) -> Sequence[Ring]:
        require_range(directrix, inverse, MOST)
        paths = clipper2.minkowski_sum(inverse, directrix, True)
        outer = pairs(path for path in paths if clipper2.is_positive(path))
        if not (inside := fillings(outer, directrix, inverse)):
            return outer
        united = [np.array(ring) for ring in (*outer, *inside)]
        return pairs(clipper2.union(united, clipper2.FillRule.NON_ZERO))

    def pairs(paths: Iterable[Iterable[Iterable[SupportsInt]]]) -> list[Ring]:
        return [[(int(x), int(y)) for x, y in path] for path in paths]

    program = f"Clipper2 {clipper2.CLIPPER2_VERSION} (clipper2-py {version('clipper2-py')})"
    return Adapter(peer_hello(program, "int64"), rings)
