"""The shared direction of a pair, and the frame of its sweep: one lattice, rotated to it.

Section 2 assumes that the shared direction is the X axis "without loss of generality". A sweep
commutes with every invertible linear map. The integer matrix [u; u_perp] maps u to the X axis
without square roots, and the loops do not depend on the choice of u.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

from exactsweep.geometry.direction import (
    X_AXIS,
    Y_AXIS,
    DirectionError,
    Vector,
    find_monotone_directions,
    is_monotone,
)
from exactsweep.geometry.polygon import Polygon
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
from exactsweep.words import write_degrees, write_vector

Kind = Literal["CC", "CM", "MM", "SS"]
"""The classes of pairs in the paper, and "SS" for polygons of any shape."""

# The smallest directions except the X axis, in the order of `Directions.simplest`. Most pairs with
# a shared direction share one of these, and then no others need be found.
_SMALL: tuple[Vector, ...] = (Y_AXIS, (1, -1), (1, 1), (1, -2), (1, 2), (2, -1), (2, 1))


def choose_direction(generatrix: Polygon, directrix: Polygon) -> Vector:
    """Choose a direction in which both polygons are monotone.

    The choice is the X axis if possible, else a strict direction with small components, else any
    shared direction. Raises DirectionError, with the directions of each polygon, if there is none.
    Cost: O(m + n) for the X axis or a small direction, else O((m + n) log(m + n)).
    """
    found = find_shared_direction(generatrix, directrix)
    if found is None:
        of_generatrix, of_directrix = map(find_monotone_directions, (generatrix, directrix))
        raise DirectionError(
            "the polygons share no direction of monotonicity: directions of "
            f"the generatrix: {of_generatrix}; of the directrix: {of_directrix}"
        )
    return found


def find_shared_direction(generatrix: Polygon, directrix: Polygon) -> Vector | None:
    """Choose a direction as `choose_direction` does, but return None if there is none."""
    if generatrix.is_x_monotone and directrix.is_x_monotone:
        return X_AXIS
    for polygon in (generatrix, directrix):
        if polygon._directions is not None and not polygon._directions:
            return None
    for direction in _SMALL:
        if is_monotone(generatrix, direction, strict=True) and is_monotone(
            directrix, direction, strict=True
        ):
            return direction
    of_both = [find_monotone_directions(polygon) for polygon in (generatrix, directrix)]
    if not all(of_both):
        return None
    shared = of_both[0] & of_both[1]
    return shared.simplest() if shared else None


def require_monotone(polygon: Polygon, direction: Vector, name: str) -> None:
    """Raise DirectionError if a polygon is not monotone in the requested direction."""
    if not is_monotone(polygon, direction):
        raise DirectionError(
            f"the {name} is not monotone in direction {write_vector(direction)}, "
            f"{write_degrees(direction)} degrees; "
            f"its directions of monotonicity: {find_monotone_directions(polygon)}"
        )


class Frame(NamedTuple):
    """The common integer lattice of a pair, rotated so that the shared direction u is the X axis.

    A point v has the coordinates (u . v, u_perp . v) * scale; u_perp is u rotated by 90 degrees.
    """

    direction: Vector
    scale: int

    def enter(self, scale: int, points: Sequence[Vertex]) -> list[Vertex]:
        """Convert points from a lattice of another scale, as of `Polygon.lattice`, to the frame."""
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
        """Convert points of the frame to the plane, moved by a vector."""
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
