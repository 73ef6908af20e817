"""Shapes as callers give them: read as Regions, put on one lattice."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from exactsweep.geometry.lattice import lcm_within
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import read_interface
from exactsweep.geometry.region import Region, Vertices
from exactsweep.numbers.error import name_refusals
from exactsweep.numbers.point import Vertex


def read_shape(shape: Region | Vertices, name: str) -> Polygon | Region:
    """Read a shape with holes as a Region, any other as a Polygon.

    Args:
        shape: a Polygon, a Region or the vertices of a polygon.
        name: what a refusal begins with.

    Raises:
        PolygonError: the polygon is not simple.
        NumberError: a coordinate is not an exact number.
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
    """Read any shape as a Region; arguments and refusals are those of `read_shape`.

    >>> to_region([(0, 0), (1, 0), (0, 1)], "part").area
    Fraction(1, 2)
    """
    found = shape if isinstance(shape, Region) else read_shape(shape, name)
    return found if isinstance(found, Region) else Region(found)


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
