"""pysfcgal: the Minkowski sum of SFCGAL, which is CGAL's.

What it promises: numbers are exact rationals (CGAL's kernel with exact constructions). The first
polygon may have holes; those of the second one are not looked at.

What it is asked: `minkowski_sum` of D and -G, or of -G and D if only G has holes, read from WKT and
written to it, in which SFCGAL has fractions; so nothing is rounded on the way.
"""

from __future__ import annotations

import re
from fractions import Fraction
from importlib.metadata import version

from exactsweep.conform.adapters.adapter import (
    Adapter,
    AnsweredRings,
    AskedRing,
    AskedShape,
    sum_adapter,
)
from exactsweep.numbers.number import format_fraction

_RING = re.compile(r"\(([^()]+)\)")


def adapter(name: str) -> Adapter:
    """Return the adapter.

    Raises:
        ImportError: it is not installed.
    """
    from pysfcgal.geometry import Geometry

    def written(ring: AskedRing) -> str:
        closed = [*ring, ring[0]]
        points = (" ".join(format_fraction(Fraction(c)) for c in point) for point in closed)
        return f"({', '.join(points)})"

    def polygon(shape: AskedShape) -> Geometry:
        return Geometry.from_wkt(f"POLYGON ({', '.join(map(written, shape))})")

    def add(directrix: AskedShape, inverse: AskedShape) -> AnsweredRings:
        if len(inverse) > 1:
            if len(directrix) > 1:
                raise NotImplementedError("holes in both")
            directrix, inverse = inverse, directrix
        text = polygon(directrix).minkowski_sum(polygon(inverse)).to_wkt()
        return [[point.split() for point in ring.split(",")] for ring in _RING.findall(text)]

    return sum_adapter(f"pysfcgal {version('pysfcgal')}", "rational", add, shapes="any")
