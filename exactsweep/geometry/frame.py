"""The coordinates of a sweep: one integer lattice, with the shared direction as X axis."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from exactsweep.geometry.direction import X_AXIS, Vector
from exactsweep.geometry.vectors import minus
from exactsweep.numbers.number import (
    ORIGIN,
    Point,
    Vertex,
    divide_all,
    divide_exactly,
    make_points,
    ratio,
)


class Frame(NamedTuple):
    """The common integer lattice of a pair, turned so that the shared direction is the X axis.

    A point v has the coordinates (u . v, u_perp . v) * scale, where u_perp is u turned by 90
    degrees.
    """

    direction: Vector
    scale: int

    def enter(self, scale: int, points: Sequence[Vertex]) -> list[Vertex]:
        """Convert points from a lattice of another scale, as of `Polygon.lattice`, to the frame.

        Cost: O(n).
        """
        k = self.scale // scale
        p, q = self.direction
        if k == 1 and (p, q) == X_AXIS:
            return list(points)
        p, q = k * p, k * q
        return [(p * x + q * y, p * y - q * x) for x, y in points]

    def enter_point(self, point: Point, shift: Point = ORIGIN) -> Vertex:
        """Convert a point minus a vector to the frame; to ints if it is on the lattice."""
        (p, q), scale = self.direction, self.scale
        (x, b), (y, d) = (
            c.as_integer_ratio() for c in (point if shift == ORIGIN else minus(point, shift))
        )
        x, y = x * d * scale, y * b * scale
        return ratio(p * x + q * y, b * d), ratio(p * y - q * x, b * d)

    def leave(self, points: Sequence[Vertex], shift: Point = ORIGIN) -> list[Point]:
        """Convert points of the frame to the plane, moved by a vector. Cost: O(n)."""
        p, q = self.direction
        scale = self.scale * (p * p + q * q)
        if (p, q) == X_AXIS:
            xs, ys = (divide_all(column, scale) for column in zip(*points, strict=True))
        else:
            xs, ys = [], []
            for x, y in points:
                unit = scale
                if type(x) is not int or type(y) is not int:
                    (x, b), (y, d) = x.as_integer_ratio(), y.as_integer_ratio()
                    x, y, unit = x * d, y * b, scale * b * d
                xs.append(divide_exactly(p * x - q * y, unit))
                ys.append(divide_exactly(q * x + p * y, unit))
        if shift != ORIGIN:
            dx, dy = shift
            xs, ys = [x + dx for x in xs], [y + dy for y in ys]
        return make_points(xs, ys)
