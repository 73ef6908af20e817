"""Shapes with holes as the checking side sees them: rings of points, the interior on their left.

The first ring is the exterior, counter-clockwise; the others are holes, clockwise.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import lcm
from typing import Any

from exactsweep.check.cone import divide
from exactsweep.check.standalone import Node, find_scale, node
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.number import Loop, Point, Vertex, divide_exactly

Outlines = tuple[Loop, ...]
"""A shape: the exterior and its holes, all counter-clockwise."""
LatticeRing = tuple[Vertex, ...]
LatticeShape = tuple[LatticeRing, ...]


def list_rings(shape: Any) -> Outlines:
    """The rings of a Polygon, of its vertices or of a Region, the exterior first."""
    has_rings = hasattr(shape, "exterior") and hasattr(shape, "holes")
    rings = (shape.exterior, *shape.holes) if has_rings else (shape,)
    return tuple(Polygon(ring).vertices for ring in rings)


def list_edges(shape: Iterable[LatticeRing]) -> list[tuple[Vertex, Vertex]]:
    """The edges of all rings, the interior on the left."""
    return [edge for ring in shape for edge in zip(ring, (*ring[1:], ring[0]), strict=True)]


def scale_shapes(shapes: Sequence[Outlines]) -> tuple[int, list[LatticeShape]]:
    """Scale shapes by the `find_scale` of all their vertices."""
    scale = find_scale([node(*p) for shape in shapes for ring in shape for p in ring])
    return scale, [_scale_shape(shape, scale) for shape in shapes]


def bring_to_integers(shapes: Sequence[Outlines]) -> tuple[int, list[LatticeShape]]:
    """Bring shapes to a common integer lattice, however fine."""
    scale = lcm(*(c.denominator for shape in shapes for ring in shape for p in ring for c in p))
    return scale, [_scale_shape(shape, scale) for shape in shapes]


def _scale_shape(rings: Outlines, scale: int) -> LatticeShape:
    exterior, *holes = (scale_ring(ring, scale) for ring in rings)
    return exterior, *(hole[::-1] for hole in holes)


def scale_ring(points: Iterable[Point], scale: int) -> LatticeRing:
    """Points times a scale: ints where they come out, else Fractions."""
    return tuple(
        (divide(x.numerator * scale, x.denominator), divide(y.numerator * scale, y.denominator))
        for x, y in points
    )


def to_points(ring: Iterable[Vertex], scale: int) -> tuple[Point, ...]:
    """Leave the lattice."""
    return tuple(to_point(p, scale) for p in ring)


def to_point(p: Vertex, scale: int) -> Point:
    """Leave the lattice."""
    return Point(divide_exactly(p[0], scale), divide_exactly(p[1], scale))


def to_vertex(p: Node) -> Vertex:
    """The coordinates of a point, ints where they come out."""
    return divide(p[0], p[2]), divide(p[1], p[2])
