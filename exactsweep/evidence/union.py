"""The no-fit polygon of two rigid groups of shapes."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import NoReturn

from exactsweep.evidence.no_fit import OverlapRegions, place_regions
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.reading import read_point
from exactsweep.geometry.region import Region, Vertices, share_lattice, to_regions
from exactsweep.numbers.error import explain_type_errors
from exactsweep.numbers.number import Point
from exactsweep.procedures.positions import FreeRegions, find_no_fit_union


class NoFitUnion(OverlapRegions):
    """The positions where any orbiting shape overlaps any stationary one; see `no_fit_union`.

    Each property is computed on first access.

    Attributes:
        stationary: the stationary Regions.
        orbiting: the Regions that move together.
        reference: the point of the orbiting shapes that marks a position, a Point.
        regions: the regions of overlap, possibly with holes, sorted. The positions of overlap in a
            region are connected.
        exact_fits: free positions without play on either side, as for `NoFitPolygon`.
    """

    asked = ("stationary", "orbiting", "reference")

    stationary: tuple[Region, ...]
    orbiting: tuple[Region, ...]

    def __init__(
        self, stationary: tuple[Region, ...], orbiting: tuple[Region, ...], reference: Point
    ) -> None:
        vars(self).update(stationary=stationary, orbiting=orbiting, reference=reference)

    @cached_property
    def solution(self) -> FreeRegions:
        """The positions of the origin of the orbiting shapes."""
        scale, rings = share_lattice([*self.stationary, *self.orbiting])
        number = len(self.stationary)
        return find_no_fit_union(rings[:number], rings[number:], scale)

    @cached_property
    def regions(self) -> tuple[Region, ...]:
        """The regions of overlap, sorted."""
        return place_regions(self.solution, self.reference)

    def _claim(self) -> NoReturn:
        raise PolygonError("certificates do not cover groups of shapes; prove each pair separately")

    def __repr__(self) -> str:
        return f"<NoFitUnion of {len(self.orbiting)} around {len(self.stationary)} shapes>"


@explain_type_errors
def no_fit_union(
    stationary: Iterable[Region | Vertices],
    orbiting: Iterable[Region | Vertices],
    *,
    reference: Iterable[object] = (0, 0),
) -> NoFitUnion:
    """Find the positions where a rigid group of shapes overlaps a stationary group.

    Args:
        stationary: a list of shapes, each a Polygon, a Region or the vertices of a polygon. They
            may touch or overlap each other.
        orbiting: the list of shapes that move together.
        reference: the point of the orbiting shapes that marks a position, in their coordinates.

    Returns:
        A NoFitUnion: the union of the no-fit polygons of all pairs, as regions, and the exact fits.

    Raises:
        PolygonError: a shape is not valid, or a group is empty.
        NumberError: a coordinate is not an exact number. Messages begin with the argument's name.

    Cost: as for `positions.find_no_fit`, summed over all pairs of shapes.

    Example:
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> print(no_fit_union([square, [(2, 0), (3, 0), (3, 1), (2, 1)]], [square]))
        region, 4 vertices: (-1, -1) (3, -1) (3, 1) (-1, 1)
        exact fit: (1,-1) (1,1)
    """
    d, g = to_regions(stationary, "stationary"), to_regions(orbiting, "orbiting")
    if not (d and g):
        raise PolygonError(f"{'orbiting' if d else 'stationary'} has no shape")
    return NoFitUnion(d, g, read_point(reference, "reference"))
