"""Affine maps of the plane, in rational arithmetic."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from exactsweep.geometry.point import Point


class Affine(NamedTuple):
    """The map (x, y) -> (a x + c y + e, b x + d y + f), numbers in the order of SVG's `matrix`."""

    a: Fraction
    b: Fraction
    c: Fraction
    d: Fraction
    e: Fraction
    f: Fraction

    def __matmul__(self, first: Affine) -> Affine:
        """Return the map that does `first` and then this one."""
        if self is IDENTITY or first is IDENTITY:
            return first if self is IDENTITY else self
        x, y = self.vector(first.a, first.b), self.vector(first.c, first.d)
        return Affine(*x, *y, *self.point(first.e, first.f))

    def point(self, x: Fraction, y: Fraction) -> Point:
        """Map a point."""
        if self is IDENTITY:
            return Point(x, y)
        return Point(self.a * x + self.c * y + self.e, self.b * x + self.d * y + self.f)

    def vector(self, x: Fraction, y: Fraction) -> Point:
        """Map a difference of two points."""
        return Point(self.a * x + self.c * y, self.b * x + self.d * y)


def affine(*numbers: int | Fraction) -> Affine:
    """Make a map of its six numbers.

    >>> affine(0, 1, -1, 0, 5, 0).point(Fraction(1), Fraction(0))
    Point(x=Fraction(5, 1), y=Fraction(1, 1))
    """
    return Affine(*map(Fraction, numbers))


IDENTITY = affine(1, 0, 0, 1, 0, 0)
