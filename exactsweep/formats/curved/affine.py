"""Affine maps of the plane, in rational arithmetic."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import NamedTuple

from exactsweep.numbers.number import Point, Rational

_ZERO = Fraction(0)


class Affine(NamedTuple):
    """The map (x, y) -> (a x + c y + e, b x + d y + f), in the order of SVG's `matrix`.

    If the true map is irrational, its coefficients differ by at most `error`.
    """

    a: Fraction
    b: Fraction
    c: Fraction
    d: Fraction
    e: Fraction
    f: Fraction
    error: Fraction = Fraction(0)

    def __matmul__(self, first: Affine) -> Affine:
        """Return the map that applies `first` and then this one."""
        if self is IDENTITY or first is IDENTITY:
            return first if self is IDENTITY else self
        x, y = self.vector(first.a, first.b), self.vector(first.c, first.d)
        error = Fraction(0)
        if self.error or first.error:
            # A coefficient of the product is a sum of two products, plus at most one coefficient.
            largest, other = max(map(abs, self[:4])), max(map(abs, first[:6]))
            error = (
                2 * (largest * first.error + other * self.error + self.error * first.error)
                + self.error
            )
        return Affine(*x, *y, *self.point(first.e, first.f), error)

    def point(self, x: Fraction, y: Fraction) -> Point:
        if self is IDENTITY:
            return Point(x, y)
        u, v = self.vector(x, y)
        return Point(u + self.e if self.e else u, v + self.f if self.f else v)

    def vector(self, x: Fraction, y: Fraction) -> Point:
        return Point(_add_products(self.a, x, self.c, y), _add_products(self.b, x, self.d, y))

    def bound_error(self, points: Iterable[Point]) -> Fraction:
        """Bound the error of images of points in the convex hull of `points`."""
        # The error of each coordinate is at most error * (|x| + |y| + 1).
        return 2 * self.error * (1 + max(abs(x) + abs(y) for x, y in points))


def _add_products(a: Fraction, x: Fraction, b: Fraction, y: Fraction) -> Fraction:
    """Return a x + b y, with a fast path for zeros, which most maps have."""
    if b and y:  # pragma: no mutate: time alone
        return a * x + b * y if a and x else b * y
    return a * x if a and x else _ZERO


def make_affine(*numbers: int | Fraction) -> Affine:
    found = Affine(*map(Fraction, numbers))
    return IDENTITY if found == IDENTITY else found


def translate(x: Rational, y: Rational) -> Affine:
    return make_affine(1, 0, 0, 1, x, y)


def scale_axes(x: Rational, y: Rational) -> Affine:
    return make_affine(x, 0, 0, y, 0, 0)


IDENTITY = Affine(*map(Fraction, (1, 0, 0, 1, 0, 0)))
