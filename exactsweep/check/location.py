"""The location of a point relative to a polygon."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from exactsweep.check.shape import list_rings, scale_shapes
from exactsweep.geometry.reading import read_point
from exactsweep.numbers.error import explain_type_errors
from exactsweep.numbers.number import Vertex


@explain_type_errors
def point_in_polygon(point: tuple[Any, Any], polygon: Any) -> int:
    """Locate a point: 1 in the interior of a polygon, 0 on its boundary, -1 outside.

    Args:
        point: a pair of rationals.
        polygon: a Polygon, its vertices or a Region, with n edges.

    Raises:
        PolygonError: the polygon is not simple, or the point is not a pair.
        NumberError: a coordinate is not an exact number.

    Cost: O(n) comparisons.

    >>> square = [(0, 0), (2, 0), (2, 2), (0, 2)]
    >>> [point_in_polygon(p, square) for p in [(1, 1), (2, "1/3"), (3, 1)]]
    [1, 0, -1]
    """
    at = read_point(point, "point")
    _, (shape, ((place,),)) = scale_shapes([list_rings(polygon), ((at,),)])
    return locate_in_shape(place, shape)


def locate_in_shape(point: Vertex, rings: Sequence[Sequence[Vertex]]) -> int:
    """Locate a point relative to a shape; holes are outside."""
    sides = [locate(point, ring) for ring in rings]
    return 0 if 0 in sides else 1 if sides.count(1) == 1 else -1


def locate(point: Vertex, loop: Sequence[Vertex]) -> int:
    """Locate a point relative to a simple loop by the parity of the edges right of it."""
    x, y = point
    side = -1
    ax, ay = loop[-1]
    for bx, by in loop:
        # An edge contains its lower end but not its upper one. So a vertex at the height of the
        # point counts once where the boundary continues, and twice or not at all where it turns
        # back.
        if (ay <= y) != (by <= y):
            turn = (bx - ax) * (y - ay) - (by - ay) * (x - ax)
            if turn == 0:
                return 0
            if (turn > 0) == (by > ay):
                side = -side
        elif (bx == x and by == y) or (ay == by == y and min(ax, bx) <= x <= max(ax, bx)):
            return 0
        ax, ay = bx, by
    return side
