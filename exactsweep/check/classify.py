"""One translation of one polygon against another: free, in contact, or overlapping.

A plane sweep in the manner of Shamos and Hoey ("Geometric intersection problems", 1976) over the
edges of both polygons, on ints. Where boundaries meet without crossing, they do so at a vertex of
one of them, which is an event; there the two interiors are compared as cones. So

- edges that cross, or cones at a common point with a direction in common: the interiors meet;
- common points, and no two cones meet: the interiors are disjoint, because a boundary could enter
  the other interior only from a common point, along a direction of both cones;
- no common point: one polygon holds the other, or they are apart.
"""

from __future__ import annotations

from fractions import Fraction
from math import lcm
from typing import Any, Literal, NamedTuple

from exactsweep.check.location import Coordinates, locate
from exactsweep.check.meeting import (
    Loop,
    Pair,
    common_direction,
    corner,
    direction_inside,
    dot,
    meetings,
)
from exactsweep.geometry.number import to_fraction
from exactsweep.geometry.point import Point
from exactsweep.geometry.polygon import Polygon

Verdict = Literal["FREE", "CONTACT", "OVERLAP"]


class Classification(NamedTuple):
    """A verdict, and a point of both open interiors (OVERLAP) or of both boundaries (CONTACT)."""

    verdict: Verdict
    witness: Point | None


def classify(directrix: Any, generatrix: Any, t: tuple[Any, Any]) -> Classification:
    """Decide whether G + t, a translate of one simple polygon, meets another, D.

    Args:
        directrix: D, a Polygon or its vertices, m edges, monotone or not.
        generatrix: G, likewise, n edges.
        t: a pair of rationals.

    Returns:
        Classification. OVERLAP: the interiors meet, and the witness is in both of them. CONTACT:
        only the boundaries meet, and the witness is in both. FREE: no common point, None.

    Raises:
        PolygonError: a polygon is not simple.
        NumberError: a coordinate is not an exact number.

    Cost: O((m + n) log(m + n)) comparisons, and as many insertions into one list.
    Source: Definition 1.1.

    >>> square = [(0, 0), (2, 0), (2, 2), (0, 2)]
    >>> [classify(square, square, t).verdict for t in [(3, 0), (2, 1), (1, 1)]]
    ['FREE', 'CONTACT', 'OVERLAP']
    """
    scale, loops = _on_one_lattice(Polygon(directrix), Polygon(generatrix), t)
    if _boxes_apart(*loops):
        return Classification("FREE", None)
    contact = None
    for point, cones in meetings(loops):
        if direction := common_direction(*cones):
            return Classification("OVERLAP", _witness(point, direction, loops, scale))
        contact = contact or point
    if contact:
        return Classification("CONTACT", _point(*contact, scale))
    for inner, outer in (loops, loops[::-1]):
        if locate(inner[0], outer) > 0:
            direction = direction_inside(corner(inner, 0))
            return Classification("OVERLAP", _witness(inner[0], direction, loops, scale))
    return Classification("FREE", None)


def _on_one_lattice(d: Polygon, g: Polygon, t: tuple[Any, Any]) -> tuple[int, tuple[Loop, Loop]]:
    """The vertices of D and of G + t in units of 1 / scale."""
    (d_scale, d_points), (g_scale, g_points) = d.lattice(), g.lattice()
    tx, ty = map(to_fraction, t)
    scale = lcm(d_scale, g_scale, tx.denominator, ty.denominator)
    k, dx, dy = scale // g_scale, int(tx * scale), int(ty * scale)
    moved = [(x * k + dx, y * k + dy) for x, y in g_points]
    k = scale // d_scale
    return scale, ([(x * k, y * k) for x, y in d_points], moved)


def _boxes_apart(one: Loop, other: Loop) -> bool:
    for axis in (0, 1):
        a, b = [p[axis] for p in one], [p[axis] for p in other]
        if max(a) < min(b) or max(b) < min(a):
            return True
    return False


def _witness(point: Coordinates, direction: Pair, loops: tuple[Loop, Loop], scale: int) -> Point:
    """A point of both interiors: half-way to the next boundary in a direction of both cones."""
    x, y = point
    dx, dy = direction
    reach = []
    for loop in loops:
        # Signed distances of the vertices from the ray's line, and positions along it.
        off = [dx * (vy - y) - dy * (vx - x) for vx, vy in loop]
        for k, (vx, vy) in enumerate(loop):
            a, b = off[k - 1], off[k]
            # Of an edge along the ray, the two neighbours give the ends.
            if a != b and (a <= 0 <= b or b <= 0 <= a):
                ux, uy = loop[k - 1]
                share = Fraction(a) / (a - b)
                way = dx * (ux + share * (vx - ux) - x) + dy * (uy + share * (vy - uy) - y)
                if way > 0:
                    reach.append(way)
    half = min(reach) / (2 * dot(direction, direction))
    return _point(x + half * dx, y + half * dy, scale)


def _point(x: int | Fraction, y: int | Fraction, scale: int) -> Point:
    return Point(Fraction(x) / scale, Fraction(y) / scale)
