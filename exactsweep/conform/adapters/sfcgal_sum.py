"""pysfcgal: the Minkowski sum of SFCGAL, which is CGAL's.

What it promises: numbers are exact rationals (CGAL's kernel with exact constructions).

What it is asked: `minkowski_sum` of D and -G, read from WKT and written to it, in which SFCGAL has
fractions; so nothing is rounded on the way.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction
from importlib.metadata import version

from exactsweep.conform.adapters.adapter import Adapter, Ring, peer_hello
from exactsweep.geometry.number import format_fraction

_RING = re.compile(r"\(([^()]+)\)")


def adapter(name: str) -> Adapter:
    """Return the adapter.

    Raises:
        ImportError: it is not installed.
    """
    from pysfcgal.geometry import Geometry

    def polygon(ring: Ring) -> Geometry:
        closed = [*ring, ring[0]]
        points = (" ".join(format_fraction(Fraction(c)) for c in point) for point in closed)
        return Geometry.from_wkt(f"POLYGON (({', '.join(points)}))")

    def rings(directrix: Ring, inverse: Ring) -> Sequence[Sequence[Sequence[str]]]:
        text = polygon(directrix).minkowski_sum(polygon(inverse)).to_wkt()
        return [[point.split() for point in ring.split(",")] for ring in _RING.findall(text)]

    return Adapter(peer_hello(f"pysfcgal {version('pysfcgal')}", "rational"), rings)
