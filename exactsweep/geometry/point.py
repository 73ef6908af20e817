"""Points of the plane, and what pairs of exact numbers are called."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple


class Point(NamedTuple):
    """A point or translation of the plane."""

    x: Fraction
    y: Fraction


ORIGIN = Point(Fraction(0), Fraction(0))


Rational = int | Fraction


Vertex = tuple[Rational, Rational]


Edge = tuple[Vertex, Vertex]


LatticePoint = tuple[int | Fraction, int | Fraction]
