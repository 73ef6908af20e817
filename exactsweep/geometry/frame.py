"""The coordinates in which a pair is swept: one integer lattice, the shared direction as X axis."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from exactsweep.geometry.direction import X_AXIS, Vector
from exactsweep.geometry.number import quotients
from exactsweep.geometry.point import ORIGIN, Point, Rational, Vertex
from exactsweep.geometry.polygon import Polygon


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
        return list(points) if k == 1 else [(k * x, k * y) for x, y in points]

    def raised(self, points: Sequence[Point], shift: Point) -> list[Vertex]:
        """Points less a vector on the lattice, not turned; as ints where they lie on it."""
        scale, (dx, dy) = self.scale, shift
        return [(_plain((x - dx) * scale), _plain((y - dy) * scale)) for x, y in points]

    def turned(self, points: Sequence[Vertex]) -> list[Vertex]:
        """Points of the lattice in the frame."""
        p, q = self.direction
        if (p, q) == X_AXIS:
            return list(points)
        return [(p * x + q * y, p * y - q * x) for x, y in points]

    def turned_back(self, points: Sequence[Vertex]) -> Sequence[Vertex]:
        """Points of the frame in the plane, but for a factor."""
        p, q = self.direction
        if (p, q) == X_AXIS:
            return points
        return [(p * x - q * y, q * x + p * y) for x, y in points]

    def leave(self, points: Sequence[Vertex], shift: Point) -> list[Point]:
        """Points of the frame in the plane, moved by a vector."""
        scale = self.scale * sum(c * c for c in self.direction)
        points = self.turned_back(points)
        xs, ys = (quotients(coordinates, scale) for coordinates in zip(*points, strict=True))
        if shift != ORIGIN:
            dx, dy = shift
            xs, ys = [x + dx for x in xs], [y + dy for y in ys]
        return list(map(Point._make, zip(xs, ys, strict=True)))


def _plain(value: Fraction) -> Rational:
    return value.numerator if value.denominator == 1 else value
