"""Shapes as callers give them: read as Regions, put on one lattice."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from exactsweep.geometry.lattice import lcm_within
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import read_interface
from exactsweep.geometry.region import AnyPolygon, Region, Vertices
from exactsweep.numbers.error import name_refusals
from exactsweep.numbers.point import Vertex


def to_shape(shape: Region | Vertices, name: str) -> AnyPolygon:
    """Read a Polygon, a Region or the vertices of a polygon: a Region if there are holes.

    Raises:
        PolygonError: the polygon is not simple; the message begins with the name.
        NumberError: a coordinate is not an exact number; likewise.
    """
    if isinstance(shape, Region):
        return shape if shape.holes else shape.exterior
    if isinstance(shape, Polygon):
        return shape
    with name_refusals(name):
        exterior, *holes = read_interface(shape) or [shape]
        # Of one ring there is no other to be named.
        return Region(exterior, holes) if holes else Polygon(exterior)


def to_region(shape: Region | Vertices, name: str) -> Region:
    """Read the same as a Region.

    >>> to_region([(0, 0), (1, 0), (0, 1)], "part").area
    Fraction(1, 2)
    """
    return shape if isinstance(shape, Region) else Region(to_shape(shape, name))


def share_lattice(regions: Sequence[Region]) -> tuple[int, list[list[list[Vertex]]]]:
    """Put regions on the coarsest integer lattice that holds them all.

    Returns:
        The scale and the rings of each region times the scale, the interior on the left. If the
        scale had more than 8192 bits, 1 and the vertices as they are.

    >>> share_lattice([Region([(0, 0), ("1/2", 0), (0, "1/3")])])
    (6, [[[(0, 0), (3, 0), (0, 2)]]])
    """
    lattices = [region.lattice() for region in regions]
    scale = lcm_within(own for own, _ in lattices)
    if scale is None:
        return 1, [
            [[(Fraction(x, own), Fraction(y, own)) for x, y in ring] for ring in rings]
            for own, rings in lattices
        ]
    return scale, [
        [[(x * (scale // own), y * (scale // own)) for x, y in ring] for ring in rings]
        for own, rings in lattices
    ]
