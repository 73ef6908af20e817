"""Points of the plane, and type names for pairs of exact numbers."""

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
        """Write the point as Python would, also with ints of more than 4300 digits."""
        x, y = (
            f"Fraction({write_int(c.numerator)}, {write_int(c.denominator)})"
            if isinstance(c, Fraction)
            else repr(c)
            for c in self
        )
        return f"Point(x={x}, y={y})"


_make_point = partial(tuple.__new__, Point)
"""A faster `Point._make`, which is written in Python."""


def make_points(xs: Iterable[Fraction], ys: Iterable[Fraction]) -> list[Point]:
    """Make points of two lists of coordinates. Cost: O(n).

    >>> make_points([Fraction(1)], [Fraction(2)])
    [Point(x=Fraction(1, 1), y=Fraction(2, 1))]
    """
    return list(map(_make_point, zip(xs, ys, strict=True)))


ORIGIN = Point(Fraction(0), Fraction(0))


Rational = int | Fraction
Vertex = tuple[Rational, Rational]
Edge = tuple[Vertex, Vertex]
Loop = tuple[Point, ...]
"""The vertices of a closed line; the last vertex does not repeat the first."""
Fit = tuple[Point, Point]
"""An exact fit by its ends, which are equal for a single position."""
PointRings = Sequence[Sequence[Point]]
"""Rings; the last vertex of a ring does not repeat the first."""
