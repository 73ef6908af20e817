"""The no-fit polygon of two polygons of any shape, and the inner fit of a part in a container."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any, Literal

from exactsweep.evidence.certificate import claim_inner_fit
from exactsweep.evidence.certified import Certified
from exactsweep.evidence.sweep import Solution, claim_pair, place_fits, place_loop, solve
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.direction import Vector
from exactsweep.geometry.frame import Kind
from exactsweep.geometry.interface import GeoJson, collect
from exactsweep.geometry.point_set import is_on
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import read_point
from exactsweep.geometry.region import Region, share_lattice
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.number import ORIGIN, Area, Fit, Point
from exactsweep.procedures.positions import FreeRegions, find_inner_fit
from exactsweep.words import count, write_pair


class RegionAnswer(Certified):
    """Regions of positions and exact fits."""

    reference: Point

    @cached_property
    @abstractmethod
    def solution(self) -> Solution | FreeRegions:
        """The positions of the moving shapes' origin."""

    @cached_property
    @abstractmethod
    def regions(self) -> tuple[Region, ...]:
        """The regions of positions, sorted."""

    @cached_property
    def exact_fits(self) -> tuple[Fit, ...]:
        """The positions without play on either side, as in `NoFitPolygon.exact_fits`."""
        return place_fits(self.solution.fits, self.reference)

    def _locate(self, position: Iterable[object]) -> Literal["inside", "boundary", "outside"]:
        t = read_point(position, "position")
        loops = [ring for region in self.regions for ring in region.rings]
        if any(is_on(t, loop) for loop in (*loops, *self.exact_fits)):
            return "boundary"
        return "inside" if any(region.contains(t) for region in self.regions) else "outside"

    @property
    def __geo_interface__(self) -> GeoJson:
        """A GeoJSON MultiPolygon, or a GeometryCollection if there are exact fits."""
        return collect([region.rings for region in self.regions], self.exact_fits)

    @property
    def area(self) -> Fraction:
        """The area of the regions."""
        return Area(add_up(region.area for region in self.regions))

    def __str__(self) -> str:
        fits = (" ".join(map(write_pair, dict.fromkeys(fit))) for fit in self.exact_fits)
        lines = [*self._describe(), *(f"exact fit: {fit}" for fit in fits)]
        return "\n".join(lines) or "it does not fit"

    def _describe(self) -> list[str]:
        return [f"region, {len(region)} vertices: {region}" for region in self.regions]


def place_regions(found: FreeRegions, reference: Point) -> tuple[Region, ...]:
    """Convert the regions of positions of the origin to Regions for a reference point, sorted."""
    regions = (
        Region(place_loop(exterior, reference), [place_loop(h, reference) for h in holes])
        for exterior, holes in found.regions
    )
    return tuple(sorted(regions, key=lambda region: region.rings))


class OverlapRegions(RegionAnswer):
    """The positions where moving shapes overlap stationary ones."""

    def locate(self, position: Iterable[object]) -> Literal["overlap", "contact", "free"]:
        """Locate a position of the moving shapes' reference point, a pair of numbers.

        Returns "overlap" if interiors overlap; "contact" if shapes only touch, on a loop or in an
        exact fit; "free" if they are apart. Cost: computing the loops and fits.

        >>> from exactsweep import no_fit_polygon
        >>> n = no_fit_polygon([(0, 0), (1, 0), (0, 1)], [(0, 0), (1, 0), (0, 1)])
        >>> n.locate((0, 0)), n.locate((1, 0)), n.locate((1, 1))
        ('overlap', 'contact', 'free')
        """
        found = self._locate(position)
        return "overlap" if found == "inside" else "contact" if found == "boundary" else "free"


class NoFitAnswer(OverlapRegions):
    """The loops and exact fits of a no-fit polygon; see `exactsweep.NoFitPolygon`."""

    asked = ("stationary", "orbiting", "reference")

    stationary: Region
    orbiting: Region
    kind: Kind
    solution: Solution

    def __init__(
        self, stationary: Region, orbiting: Region, direction: Vector | None, reference: Point
    ) -> None:
        solution = solve(orbiting, stationary, direction)
        vars(self).update(stationary=stationary, orbiting=orbiting, reference=reference)
        vars(self).update(solution=solution, kind=solution.kind)

    @cached_property
    def exterior(self) -> Polygon:
        """The loop around all positions of overlap: the trajectory."""
        return place_loop(self.solution.trajectory, self.reference)

    @cached_property
    def holes(self) -> tuple[Polygon, ...]:
        """The loops around free positions in cavities and holes, sorted."""
        return tuple(place_loop(hole, self.reference) for hole in self.solution.holes)

    @cached_property
    def regions(self) -> tuple[Region, ...]:
        """The positions of overlap, as one Region."""
        return (Region._trust([self.exterior, *self.holes]),)

    @cached_property
    def exact_fits(self) -> tuple[Fit, ...]:
        """Free positions without play on either side: segments and points, sorted.

        If only one end of a segment lies on a loop, it comes first. A single position is a segment
        with equal ends.
        """
        return super().exact_fits

    def _claim(self) -> dict[str, Any]:
        return claim_pair(self.stationary, self.orbiting, self.solution)

    @property
    def __geo_interface__(self) -> GeoJson:
        """A GeoJSON Polygon, or a GeometryCollection of it and the exact fits if there are any."""
        return super().__geo_interface__ if self.exact_fits else self.regions[0].__geo_interface__

    def _describe(self) -> list[str]:
        holes = [f"hole, {len(hole)} vertices: {hole}" for hole in self.holes]
        return [f"exterior, {len(self.exterior)} vertices: {self.exterior}", *holes]

    def __repr__(self) -> str:
        return (
            f"<NoFitPolygon {self.kind} of {len(self.orbiting)} around {len(self.stationary)} "
            f"vertices: exterior {len(self.exterior)} vertices, {count(len(self.holes), 'hole')}, "
            f"{count(len(self.exact_fits), 'exact fit')}>"
        )


class InnerFitAnswer(RegionAnswer):
    """The regions and exact fits of an inner fit; see `exactsweep.InnerFit`."""

    asked = ("container", "part", "placed", "attached", "reference")

    container: Region
    part: Region
    placed: tuple[Region, ...]
    attached: tuple[Region, ...]

    def __init__(
        self,
        container: Region,
        part: Region,
        reference: Point,
        placed: Sequence[Region] = (),
        attached: Sequence[Region] = (),
    ) -> None:
        vars(self).update(container=container, part=part, reference=reference)
        vars(self).update(placed=tuple(placed), attached=tuple(attached))

    @cached_property
    def solution(self) -> FreeRegions:
        """The positions of the part's origin."""
        given = [self.container, self.part, *self.placed, *self.attached]
        scale, (container, part, *others) = share_lattice(given)
        number = len(self.placed)
        return find_inner_fit(container, part, scale, others[:number], others[number:])

    @cached_property
    def regions(self) -> tuple[Region, ...]:
        """The regions of positions, sorted; none if the part does not fit."""
        return place_regions(self.solution, self.reference)

    def __bool__(self) -> bool:
        return bool(self.regions or self.exact_fits)

    def locate(self, position: Iterable[object]) -> Literal["inside", "boundary", "outside"]:
        """Locate a position of the part's reference point, a pair of numbers.

        Returns "inside" in a region; "boundary" on its boundary or in an exact fit, where the part
        touches an obstacle; "outside" where the part overlaps one. Cost: computing `solution`.

        >>> from exactsweep import inner_fit_polygon
        >>> f = inner_fit_polygon([(0, 0), (4, 0), (4, 2), (0, 2)], [(0, 0), (1, 0), (0, 1)])
        >>> f.locate((1, 1)), f.locate((0, 1)), f.locate((9, 1))
        ('boundary', 'boundary', 'outside')
        """
        return self._locate(position)

    def _claim(self) -> dict[str, Any]:
        if self.placed or self.attached:
            raise PolygonError("certificates do not cover placed shapes or attached ones")
        regions = place_regions(self.solution, ORIGIN)
        return claim_inner_fit(self.container, self.part, regions, self.solution.fits)

    def __repr__(self) -> str:
        return (
            f"<InnerFit of {len(self.part)} in {len(self.container)} vertices: "
            f"{count(len(self.regions), 'region')}, {count(len(self.exact_fits), 'exact fit')}>"
        )
