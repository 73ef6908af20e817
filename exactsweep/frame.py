"""The coordinates in which a pair is swept: one integer lattice, the shared direction as X axis."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from exactsweep.chain import Rational, Vertex
from exactsweep.direction import Vector
from exactsweep.polygon import ORIGIN, Point, Polygon


class Frame(NamedTuple):
    """The common integer lattice of a pair, turned so that the shared direction is the X axis.

    A point v is (u . v, u_perp . v) * scale there; u_perp is u turned by 90 degrees.
    """

    direction: Vector
    scale: int

    def lattice(self, polygon: Polygon) -> list[Vertex]:
        """Vertices of a polygon on the lattice, not turned, in canonical order."""
        scale, points = polygon.lattice()
        k = self.scale // scale
        return [(k * x, k * y) for x, y in points]

    def raised(self, points: Sequence[Point], shift: Point) -> list[Vertex]:
        """Points less a vector on the lattice, not turned; as ints where they lie on it."""
        scale, (dx, dy) = self.scale, shift
        return [(_plain((x - dx) * scale), _plain((y - dy) * scale)) for x, y in points]

    def turned(self, points: Sequence[Vertex]) -> list[Vertex]:
        """Points of the lattice in the frame."""
        p, q = self.direction
        return [(p * x + q * y, p * y - q * x) for x, y in points]

    def leave(self, points: Sequence[Vertex], shift: Point) -> list[Point]:
        """Points of the frame in the plane, moved by a vector."""
        p, q = self.direction
        scale = self.scale * (p * p + q * q)
        if (p, q) != (1, 0):
            points = [(p * x - q * y, q * x + p * y) for x, y in points]
        if scale == 1 and shift == ORIGIN:
            return [Point(_fraction(x), _fraction(y)) for x, y in points]
        dx, dy = shift
        return [Point(Fraction(x) / scale + dx, Fraction(y) / scale + dy) for x, y in points]


def _fraction(value: Rational) -> Fraction:
    return value if isinstance(value, Fraction) else Fraction(value)


def _plain(value: Fraction) -> Rational:
    return value.numerator if value.denominator == 1 else value
