"""Classification of one translation of a polygon: free, in contact, or overlapping.

All pairs of edges whose boxes meet are compared, on ints. If boundaries meet without crossing, a
vertex of one lies on the other; there the interiors are compared as cones.

- If edges cross, or cones at a common point share a direction, the interiors meet.
- If there are only other common points, the interiors are disjoint: a ring could enter the other
  interior only from a common point, in a direction of both cones.
- If there is no common point, the exterior of one is inside the other interior, or they are apart.
  If only holes were inside, both exteriors would surround them, and the inner exterior would
  separate the interior of the other polygon.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import chain
from typing import Any, Literal, NamedTuple

from exactsweep.check.cone import dot, find_common_direction, find_direction_inside
from exactsweep.check.location import locate_in_shape
from exactsweep.check.meeting import find_cones_of, list_meetings, split_where_touching
from exactsweep.check.shape import LatticeShape, find_box, list_rings, meet, scale_shapes
from exactsweep.geometry.reading import read_point
from exactsweep.numbers.error import explain_type_errors, prefix_errors
from exactsweep.numbers.number import Point, Vertex

Meeting = Literal["FREE", "CONTACT", "OVERLAP"]


class Classification(NamedTuple):
    """A verdict, with a point in both interiors (OVERLAP) or on both boundaries (CONTACT)."""

    verdict: Meeting
    witness: Point | None


@explain_type_errors
def classify(directrix: Any, generatrix: Any, t: tuple[Any, Any]) -> Classification:
    """Decide whether a directrix D meets a translated generatrix G + t.

    The directrix is the first argument here, but the second one of `sweep`.

    Args:
        directrix: D, a Polygon, its vertices or a Region, with m edges.
        generatrix: G, in any of these forms, with n edges.
        t: a pair of rationals.

    Returns:
        A Classification. OVERLAP: the interiors meet, and the witness is in both. CONTACT: only the
        boundaries meet, and the witness is on both. FREE: there is no common point, and no witness.

    Raises:
        PolygonError: a polygon is not simple.
        NumberError: a coordinate is not an exact number. Messages begin with the argument's name.

    Cost: O(m n) for the edges in the intersection of both boxes.
    Source: Definition 1.1.

    >>> square = [(0, 0), (2, 0), (2, 2), (0, 2)]
    >>> pair = {"directrix": square, "generatrix": square}
    >>> [classify(**pair, t=t).verdict for t in [(3, 0), (2, 1), (1, 1)]]
    ['FREE', 'CONTACT', 'OVERLAP']
    """
    x, y = read_point(t, "the position")
    with prefix_errors("directrix"):
        polygons = [list_rings(directrix)]
    with prefix_errors("generatrix"):
        polygons.append(list_rings(generatrix))
    scale, (d, g, (((dx, dy),),)) = scale_shapes([*polygons, ((Point(x, y),),)])
    shapes = d, tuple(tuple((px + dx, py + dy) for px, py in ring) for ring in g)
    if not meet(*(find_box(shape[0]) for shape in shapes)):
        return Classification("FREE", None)
    contact = None
    for point, cones in list_meetings(shapes):
        if direction := find_common_direction(*cones):
            return Classification("OVERLAP", _witness(point, direction, shapes, scale))
        contact = contact or point
    if contact:
        return Classification("CONTACT", _point(*contact, scale))
    for inner, outer in (shapes, shapes[::-1]):
        start = inner[0][0]
        if locate_in_shape(start, outer) > 0:
            direction = find_direction_inside(find_cones_of(split_where_touching(inner))[start][0])
            return Classification("OVERLAP", _witness(start, direction, shapes, scale))
    return Classification("FREE", None)


def _witness(
    point: Vertex, direction: Vertex, shapes: tuple[LatticeShape, LatticeShape], scale: int
) -> Point:
    """Return the point halfway to the next boundary in a common direction of the cones."""
    x, y = point
    dx, dy = direction
    reach = []
    for loop in chain(*shapes):
        # Signed distances of the vertices from the ray's line, and positions along it.
        off = [dx * (vy - y) - dy * (vx - x) for vx, vy in loop]
        for k, (vx, vy) in enumerate(loop):
            a, b = off[k - 1], off[k]
            # Where the ray leaves a shape, the boundary reaches its line from the right or leaves
            # it to the left. The neighbors of an edge along the ray give the ends of the edge.
            if a != b and a <= 0 <= b:
                ux, uy = loop[k - 1]
                share = Fraction(a) / (a - b)
                ahead = dx * (ux + share * (vx - ux) - x) + dy * (uy + share * (vy - uy) - y)
                if ahead > 0:
                    reach.append(ahead)
    half = min(reach) / (2 * dot(direction, direction))
    return _point(x + half * dx, y + half * dy, scale)


def _point(x: int | Fraction, y: int | Fraction, scale: int) -> Point:
    return Point(Fraction(x) / scale, Fraction(y) / scale)
