"""Shapes with holes as the checking side sees them: rings of points, the interior on their left.

The first ring is the exterior, counter-clockwise; the others are holes, clockwise.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import lcm
from typing import Any

from exactsweep.check.cone import divide
from exactsweep.check.size import find_common_scale
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.number import divide_exactly
from exactsweep.numbers.point import Point, Rational, Vertex

LatticeRing = tuple[Vertex, ...]
LatticeShape = tuple[LatticeRing, ...]


def list_rings(shape: Any) -> tuple[Polygon, ...]:
    """The rings of a Polygon, of its vertices or of a Region, as Polygons, the exterior first."""
    if hasattr(shape, "exterior") and hasattr(shape, "holes"):
        return Polygon(shape.exterior), *map(Polygon, shape.holes)
    return (Polygon(shape),)


def list_edges(shape: Iterable[LatticeRing]) -> list[tuple[Vertex, Vertex]]:
    """The edges of all rings, the interior on the left."""
    return [edge for ring in shape for edge in zip(ring, (*ring[1:], ring[0]), strict=True)]


def bring_to_one_lattice(
    shapes: Sequence[Sequence[Polygon]], denominators: Iterable[int] = ()
) -> tuple[int, list[LatticeShape]]:
    """Bring shapes to a common integer lattice.

    Args:
        shapes: each an exterior and its holes.
        denominators: of further numbers that are to be on the lattice.

    Returns:
        The scale and the shapes, all multiplied by it. Coordinates are ints, or Fractions
        where `Polygon.lattice` gives such.
    """
    lattices = [[polygon.lattice() for polygon in polygons] for polygons in shapes]
    scale = lcm(*(s for polygons in lattices for s, _ in polygons), *denominators)
    brought = []
    for polygons in lattices:
        rings = [tuple((x * (scale // s), y * (scale // s)) for x, y in p) for s, p in polygons]
        brought.append((rings[0], *(ring[::-1] for ring in rings[1:])))
    return scale, brought


def scale_shapes(shapes: Sequence[Sequence[Polygon]]) -> tuple[int, list[LatticeShape]]:
    """The `find_common_scale` of all vertices of some shapes, and the shapes times that."""
    scale = find_common_scale([p for shape in shapes for ring in shape for p in ring.vertices])
    return scale, [scale_shape(shape, scale) for shape in shapes]


def scale_shape(polygons: Iterable[Polygon], scale: int) -> LatticeShape:
    """An exterior and its holes, times a scale."""
    exterior, *holes = (scale_ring(polygon.vertices, scale) for polygon in polygons)
    return exterior, *(hole[::-1] for hole in holes)


def scale_ring(points: Iterable[Point], scale: int) -> LatticeRing:
    """Points times a scale: ints where they come out, else Fractions."""
    return tuple((_times(x, scale), _times(y, scale)) for x, y in points)


def _times(c: Fraction, scale: int) -> Rational:
    return divide(c.numerator * scale, c.denominator)


def bring_to_integers(shapes: Sequence[Sequence[Polygon]]) -> tuple[int, list[LatticeShape]]:
    """Bring shapes to a common integer lattice, however fine."""
    scale, brought = bring_to_one_lattice(shapes)
    finer = lcm(*(c.denominator for shape in brought for ring in shape for p in ring for c in p))
    if finer == 1:
        return scale, brought
    return scale * finer, [
        tuple(tuple((int(x * finer), int(y * finer)) for x, y in ring) for ring in shape)
        for shape in brought
    ]


def to_points(ring: Iterable[Vertex], scale: int) -> tuple[Point, ...]:
    """Leave the lattice."""
    return tuple(to_point(p, scale) for p in ring)


def to_point(p: Vertex, scale: int) -> Point:
    """Leave the lattice."""
    return Point(divide_exactly(p[0], scale), divide_exactly(p[1], scale))
