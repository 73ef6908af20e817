"""Conversion of the caller's shapes to Regions on one lattice."""

from __future__ import annotations

from collections.abc import Sequence

from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import lcm_within, read_interface
from exactsweep.geometry.region import AnyPolygon, Region, Vertices
from exactsweep.numbers.error import name_refusals
from exactsweep.numbers.number import Vertex, ratio


def to_shape(shape: Region | Vertices, name: str) -> AnyPolygon:
    """Read a Polygon, a Region or the vertices of a polygon: a Region if there are holes.

    Raises:
        PolygonError: the polygon is not simple. The message begins with the name.
        NumberError: a coordinate is not an exact number. The message begins likewise.
    """
    if isinstance(shape, Region):
        return shape if shape.holes else shape.exterior
    if isinstance(shape, Polygon):
        return shape
    with name_refusals(name):
        exterior, *holes = read_interface(shape) or [shape]
        # A single ring needs no name of its own.
        return Region(exterior, holes) if holes else Polygon(exterior)


_WIDE, _LONG = 64, 1024
"""The most bits of a useful scale: if most vertices are on another lattice, and otherwise."""


def to_region(shape: Region | Vertices, name: str) -> Region:
    """Read a shape as `to_shape` does, but always as a Region.

    >>> to_region([(0, 0), (1, 0), (0, 1)], "part").area
    Fraction(1, 2)
    """
    return shape if isinstance(shape, Region) else Region(to_shape(shape, name))


def share_lattice(
    regions: Sequence[Region], scale: int | None = None
) -> tuple[int, list[list[list[Vertex]]]]:
    """Put regions on the coarsest integer lattice that holds them all.

    Args:
        regions: any number of Regions.
        scale: the scale of a lattice with most vertices, as a substitute if the common scale is
            long.

    Returns:
        The scale, and the rings of each region times the scale, with the interior on the left.
        Vertices off the given lattice are Fractions. If the scale had more than 1024 bits, it is 1
        and the vertices are unchanged, because all numbers would be longer than any vertex.

    >>> share_lattice([Region([(0, 0), ("1/2", 0), (0, "1/3")])])
    (6, [[[(0, 0), (3, 0), (0, 2)]]])
    """
    lattices = [region.lattice() for region in regions]
    common = lcm_within(own for own, _ in lattices)
    if common is None or common.bit_length() > (_LONG if scale is None else _WIDE):
        return scale or 1, [_scale_rings(region, scale or 1) for region in regions]
    return common, [_enlarge(rings, common // own) for own, rings in lattices]


def _enlarge(rings: Sequence[Sequence[Vertex]], factor: int) -> list[list[Vertex]]:
    if factor == 1:
        return list(map(list, rings))
    return [[(x * factor, y * factor) for x, y in ring] for ring in rings]


def _scale_rings(region: Region, scale: int) -> list[list[Vertex]]:
    """Multiply rings by a scale; interior on the left, ints for vertices on the lattice."""
    exterior, *holes = region.rings
    return [
        [(ratio(x * scale, 1), ratio(y * scale, 1)) for x, y in ring]
        for ring in (exterior, *((hole[0], *hole[:0:-1]) for hole in holes))
    ]
