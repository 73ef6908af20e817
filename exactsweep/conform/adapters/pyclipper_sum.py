"""pyclipper: the Minkowski sum of Clipper 6.

What it promises: integers of up to 62 bits in magnitude; vertices of the result are integers, so
crossings are rounded. `MinkowskiSum` moves a pattern along a path, so it is the sum of two
boundaries.

What it is asked: the sum of -G, as the pattern, and D, as a closed path, times the scale that
makes the case integer. Rings that run clockwise are holes, which the sum of two boundaries may
have where that of the polygons has none, and are left out. A ring that touches itself may have
such a hole, too; it is united with `fillings`, by the rule nonzero.
"""

from __future__ import annotations

from collections.abc import Sequence
from importlib.metadata import version

from exactsweep.conform.adapters.adapter import (
    Adapter,
    Ring,
    fillings,
    peer_hello,
    require_range,
)

MOST = 2**62 - 1


def adapter(name: str) -> Adapter:
    """Return the adapter.

    Raises:
        ImportError: it is not installed.
    """
    import pyclipper

    def rings(directrix: Ring, inverse: Ring) -> Sequence[Ring]:
        require_range(directrix, inverse, MOST)
        paths = pyclipper.MinkowskiSum(inverse, directrix, True)
        outer = [[(x, y) for x, y in path] for path in paths if pyclipper.Orientation(path)]
        if not (inside := fillings(outer, directrix, inverse)):
            return outer
        union = pyclipper.Pyclipper()
        union.AddPaths([*outer, *inside], pyclipper.PT_SUBJECT, True)
        nonzero = pyclipper.PFT_NONZERO
        united: Sequence[Ring] = union.Execute(pyclipper.CT_UNION, nonzero, nonzero)
        return united

    return Adapter(peer_hello(f"pyclipper {version('pyclipper')} (Clipper 6.4.2)", "int64"), rings)
