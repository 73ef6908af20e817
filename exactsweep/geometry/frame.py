"""The shared direction of a pair, and its frame, which rotates that direction to the X axis.

Section 2 assumes "without loss of generality" that the shared direction is the X axis. A sweep
commutes with every invertible linear map. The integer matrix [u; u_perp] maps u to the X axis
without square roots, and the loops do not depend on the choice of u.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import lcm
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
    Rational,
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


HomogeneousPoint = tuple[int, int, int]
"""(x, y, w): the point (x/w, y/w), w > 0."""


def to_homogeneous(x: Rational, y: Rational) -> HomogeneousPoint:
    """Return the homogeneous coordinates of a point, with the least possible w.

    >>> from fractions import Fraction
    >>> to_homogeneous(Fraction(1, 2), Fraction(1, 3))
    (3, 2, 6)
    """
    if isinstance(x, int) and isinstance(y, int):
        return x, y, 1
    w = lcm(x.denominator, y.denominator)
    return int(x * w), int(y * w), w


class Frame(NamedTuple):
    """The common integer lattice of a pair, rotated so that the shared direction u is the X axis.

    A point v has the coordinates (u . v, u_perp . v) * scale, where u_perp is u rotated by 90
    degrees.
    """

    direction: Vector
    scale: int

    def half_turn(self) -> Frame:
        """Return the frame after a half turn: the negative direction is the X axis."""
        p, q = self.direction
        return Frame((-p, -q), self.scale)

    def enter(self, scale: int, points: Sequence[Vertex]) -> list[Vertex]:
        """Convert points from a lattice of another scale to the frame."""
        k = ratio(self.scale, scale)
        p, q = self.direction
        if k == 1 and (p, q) == X_AXIS:
            return list(points)
        u, v = k * p, k * q
        return [(u * x + v * y, u * y - v * x) for x, y in points]

    def enter_point(self, point: Point, shift: Point = ORIGIN) -> Vertex:
        """Subtract a vector from a point and convert it to the frame; ints if on the lattice."""
        (p, q), scale = self.direction, self.scale
        x, y = point if shift == ORIGIN else minus(point, shift)
        return ratio((p * x + q * y) * scale, 1), ratio((p * y - q * x) * scale, 1)

    def leave(self, points: Iterable[HomogeneousPoint]) -> list[Point]:
        """Convert points of the frame to the plane."""
        p, q = self.direction
        scale = self.scale * (p * p + q * q)
        return [
            Point(divide(p * x - q * y, scale * w), divide(q * x + p * y, scale * w))
            for x, y, w in points
        ]

    def leave_point(self, point: Vertex, shift: Point = ORIGIN) -> Point:
        """Convert a point of the frame to the plane, and add a vector."""
        (x, y), (dx, dy) = self.leave([to_homogeneous(*point)])[0], shift
        return Point(x + dx, y + dy)
