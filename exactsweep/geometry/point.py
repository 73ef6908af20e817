"""Points of the plane, and what pairs of exact numbers are called."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from exactsweep.geometry.digits import write_int


class Point(NamedTuple):
    """A point or translation of the plane."""

    x: Fraction
    y: Fraction

    def __repr__(self) -> str:
        """As Python writes it; but Python refuses to write ints of more than 4300 digits."""
        x, y = (
            f"Fraction({write_int(c.numerator)}, {write_int(c.denominator)})"
            if isinstance(c, Fraction)
            else repr(c)
            for c in self
        )
        return f"Point(x={x}, y={y})"


ORIGIN = Point(Fraction(0), Fraction(0))


Rational = int | Fraction


Vertex = tuple[Rational, Rational]


Edge = tuple[Vertex, Vertex]


LatticePoint = tuple[int | Fraction, int | Fraction]
