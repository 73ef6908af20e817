"""The shared direction of a pair, and its frame, which rotates that direction to the X axis.

Section 2 assumes "without loss of generality" that the shared direction is the X axis. A sweep
commutes with every invertible linear map. The integer matrix [u; u_perp] maps u to the X axis
without square roots, and the loops do not depend on the choice of u.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

from exactsweep.geometry.direction import (
    X_AXIS,
    DirectionError,
    Vector,
    find_monotone_directions,
)
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.vectors import minus
from exactsweep.numbers.number import (
    ORIGIN,
    Point,
    Vertex,
    divide,
    ratio,
)
from exactsweep.words import write_degrees, write_vector

Kind = Literal["CC", "CM", "MM", "SS"]
"""The classes of pairs in the paper, and "SS" for polygons of any shape."""


def find_shared_direction(generatrix: Polygon, directrix: Polygon) -> Vector | None:
    """Choose the simplest direction in which both polygons are monotone; None if there is none.

    Cost: O(m + n) for the X axis, else O((m + n) log(m + n)).
    """
    if generatrix.is_x_monotone and directrix.is_x_monotone:
        return X_AXIS
    one, other = (find_monotone_directions(polygon) for polygon in (generatrix, directrix))
    shared = one & other
    return shared.simplest() if shared else None


def require_monotone(polygon: Polygon, direction: Vector, name: str) -> None:
    """Raise DirectionError if a polygon is not monotone in the requested direction."""
    found = find_monotone_directions(polygon)
    if direction not in found:
        raise DirectionError(
            f"the {name} is not monotone in direction {write_vector(direction)}, "
            f"{write_degrees(direction)} degrees; its directions of monotonicity: {found}"
        )


class Frame(NamedTuple):
    """The common integer lattice of a pair, rotated so that the shared direction u is the X axis.

    A point v has the coordinates (u . v, u_perp . v) * scale, where u_perp is u rotated by 90
    degrees.
    """

    direction: Vector
    scale: int

    def enter(self, scale: int, points: Sequence[Vertex]) -> list[Vertex]:
        """Convert points from a lattice of another scale to the frame."""
        k = self.scale // scale
        p, q = self.direction
        if k == 1 and (p, q) == X_AXIS:
            return list(points)
        p, q = k * p, k * q
        return [(p * x + q * y, p * y - q * x) for x, y in points]

    def enter_point(self, point: Point, shift: Point = ORIGIN) -> Vertex:
        """Subtract a vector from a point and convert it to the frame; ints if on the lattice."""
        (p, q), scale = self.direction, self.scale
        x, y = point if shift == ORIGIN else minus(point, shift)
        return ratio((p * x + q * y) * scale, 1), ratio((p * y - q * x) * scale, 1)

    def leave(self, points: Sequence[Vertex], shift: Point = ORIGIN) -> list[Point]:
        """Convert points of the frame to the plane, and add a vector."""
        p, q = self.direction
        scale = self.scale * (p * p + q * q)
        found = []
        for x, y in points:
            unit = scale
            if type(x) is not int or type(y) is not int:
                (x, b), (y, d) = x.as_integer_ratio(), y.as_integer_ratio()
                x, y, unit = x * d, y * b, scale * b * d
            found.append(Point(divide(p * x - q * y, unit), divide(q * x + p * y, unit)))
        return found if shift == ORIGIN else [Point(x + shift.x, y + shift.y) for x, y in found]
