"""Minkowski sums of SFCGAL by pysfcgal, computed by CGAL.

Promise: exact rationals, by CGAL's kernel with exact constructions. The first polygon may have
holes; holes of the second one are ignored.

Question: `minkowski_sum` of D and -G, or of -G and D if only G has holes, in WKT with fractions.
"""

from __future__ import annotations

import re
from fractions import Fraction
from importlib.metadata import version

from benchmarks.peers.adapters.adapter import (
    Adapter,
    AnsweredRings,
    AskedShape,
    Number,
    sum_adapter,
)
from exactsweep.numbers.digits import format_fraction

_RING = re.compile(r"\(([^()]+)\)")


def adapter(name: str) -> Adapter:
    import pysfcgal  # noqa: F401

    return sum_adapter(f"pysfcgal {version('pysfcgal')}", "rational", _add_either, shapes="any")


def _add_either(directrix: AskedShape, inverse: AskedShape) -> AnsweredRings:
    if len(inverse) > 1:
        if len(directrix) > 1:
            raise NotImplementedError("holes in both")
        directrix, inverse = inverse, directrix
    return add(directrix, inverse)


def add(first: AskedShape, second: AskedShape) -> list[list[list[str]]]:
    """Return the rings of the sum of two shapes, the second of which has no holes."""
    from pysfcgal.geometry import Geometry

    one, other = (Geometry.from_wkt(_write(shape)) for shape in (first, second))
    text = one.minkowski_sum(other).to_wkt()
    return [[point.split() for point in ring.split(",")] for ring in _RING.findall(text)]


def _write(shape: AskedShape) -> str:
    closed = ([*ring, ring[0]] for ring in shape)
    rings = (", ".join(f"{_number(x)} {_number(y)}" for x, y in ring) for ring in closed)
    return f"POLYGON ({', '.join(f'({ring})' for ring in rings)})"


def _number(c: Number) -> str:
    return format_fraction(Fraction(c))
