"""Shapes as rings of points: the counter-clockwise exterior, then the clockwise holes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import lcm
from typing import Any

from exactsweep.check.cone import divide
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.number import Loop, Point, Rational, Vertex

Outlines = tuple[Loop, ...]
"""A shape: the exterior and its holes, all counter-clockwise."""
LatticeRing = tuple[Vertex, ...]
LatticeShape = tuple[LatticeRing, ...]
Rectangle = tuple[Rational, Rational, Rational, Rational]
"""The least and greatest x, and the least and greatest y."""


def list_rings(shape: Any) -> Outlines:
    """Return the rings of a Polygon, of its vertices or of a Region, the exterior first."""
    has_rings = hasattr(shape, "exterior") and hasattr(shape, "holes")
    rings = (shape.exterior, *shape.holes) if has_rings else (shape,)
    return tuple(Polygon(ring).vertices for ring in rings)


def list_edges(shape: Iterable[LatticeRing]) -> list[tuple[Vertex, Vertex]]:
    """Return the edges of all rings."""
    return [edge for ring in shape for edge in zip(ring, (*ring[1:], ring[0]), strict=True)]


def find_scale(points: Iterable[Point]) -> int:
    """Return the least common denominator, or 1 if it is far longer than each denominator."""
    units = [c.denominator for p in points for c in p]
    scale, longest = 1, max(unit.bit_length() for unit in units)
    for unit in units:
        scale = lcm(scale, unit)
        if scale.bit_length() > max(256, 2 * longest):
            return 1
    return scale


def scale_shapes(shapes: Sequence[Outlines]) -> tuple[int, list[LatticeShape]]:
    """Scale shapes to a common scale chosen by `find_scale`."""
    scale = find_scale([p for shape in shapes for ring in shape for p in ring])
    return scale, [_scale_shape(shape, scale) for shape in shapes]


def _scale_shape(rings: Outlines, scale: int) -> LatticeShape:
    exterior, *holes = (scale_ring(ring, scale) for ring in rings)
    return exterior, *(hole[::-1] for hole in holes)


def scale_ring(points: Iterable[Point], scale: int) -> LatticeRing:
    """Multiply points by a scale, with ints where possible."""
    return tuple(
        (divide(x.numerator * scale, x.denominator), divide(y.numerator * scale, y.denominator))
        for x, y in points
    )


def find_box(points: Iterable[Vertex]) -> Rectangle:
    """Return the bounding box of points."""
    xs, ys = zip(*points, strict=True)
    return min(xs), max(xs), min(ys), max(ys)


def meet(one: Rectangle, other: Rectangle) -> bool:
    """Decide whether two closed boxes intersect."""
    return one[0] <= other[1] and other[0] <= one[1] and one[2] <= other[3] and other[2] <= one[3]
