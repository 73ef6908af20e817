"""Points of the plane, and what pairs of exact numbers are called."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import partial
from typing import NamedTuple

from exactsweep.numbers.digits import write_int


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


_make_point = partial(tuple.__new__, Point)
"""As `Point._make` does, which is written in Python."""


def make_points(xs: Iterable[Fraction], ys: Iterable[Fraction]) -> list[Point]:
    """Put coordinates together, many at a time. Cost: O(n).

    >>> make_points([Fraction(1)], [Fraction(2)])
    [Point(x=Fraction(1, 1), y=Fraction(2, 1))]
    """
    return list(map(_make_point, zip(xs, ys, strict=True)))


ORIGIN = Point(Fraction(0), Fraction(0))


Rational = int | Fraction
Vertex = tuple[Rational, Rational]
Edge = tuple[Vertex, Vertex]
Loop = tuple[Point, ...]
"""The vertices of a closed line; the last one is not the first one again."""
Fit = tuple[Point, Point]
"""An exact fit by its ends, which are equal where it is a single position."""
PointRings = Sequence[Sequence[Point]]
"""Rings, in which the last vertex is not the first one again."""
