"""The no-fit polygon of two polygons of any shape, and the inner fit of a part in a container."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any, Literal

from exactsweep.evidence.shape_certificate import claim_inner_fit, claim_no_fit
from exactsweep.evidence.swept import Swept
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.given import share_lattice
from exactsweep.geometry.point_set import is_on
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import read_point
from exactsweep.geometry.region import Region
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.point import ORIGIN, Fit, Point
from exactsweep.procedures import ss
from exactsweep.words import write_pair


class LatticePair:
    """Two shapes on their common integer lattice, and the way back from it.

    Args:
        fixed: the shape that stays.
        moved: the shape that moves.
        reference: the point of the latter whose positions are told.
        placed: shapes that stay, too.
        scale: that of the lattice, where not all vertices need to be on it.
    """

    def __init__(
        self,
        fixed: Region,
        moved: Region,
        reference: Point = ORIGIN,
        placed: Sequence[Region] = (),
        scale: int | None = None,
    ) -> None:
        self.reference = reference
        self.scale, shapes = share_lattice([fixed, moved, *placed], scale)
        self.fixed, self.moved, *self.placed = shapes

    def leave(self, position: Point) -> Point:
        """The position of the reference point for a position of the origin."""
        if self.reference == ORIGIN:
            return position
        (x, y), (dx, dy) = position, self.reference
        return Point(x + dx, y + dy)

    def polygon(self, loop: Sequence[Point]) -> Polygon:
        """A canonical loop of positions as a Polygon."""
        return Polygon._from_canonical(list(map(self.leave, loop)))

    def polygons(self, loops: Sequence[Sequence[Point]]) -> tuple[Polygon, ...]:
        """Several loops, sorted."""
        return tuple(sorted(map(self.polygon, loops), key=lambda polygon: polygon.vertices))

    def fits(self, found: Sequence[Fit]) -> tuple[Fit, ...]:
        """Exact fits as pairs of positions, sorted."""
        return tuple((self.leave(p), self.leave(q)) for p, q in found)

    def no_fit(self) -> ss.NoFitSS:
        """The no-fit polygon, told in positions of the origin."""
        return ss.no_fit_ss(self.fixed, self.moved, self.scale)

    def inner_fit(self) -> ss.InnerFitSS:
        """The positions inside the fixed shape, told in positions of the origin."""
        return ss.inner_fit_ss(self.fixed, self.moved, self.scale, self.placed)


class NoFitPositions:
    """Where an orbiting polygon overlaps a stationary one; made by `no_fit_polygon`.

    Each part is computed when it is first read.

    Attributes:
        stationary: D, a Region.
        orbiting: G, a Region.
        reference: the point of G whose positions are told, a Point.
        kind: "CC", "CM" or "MM" where the paper's procedures apply, else "SS".
    """

    def __init__(
        self, stationary: Region, orbiting: Region, reference: Point, swept: Swept | None
    ) -> None:
        self.stationary = stationary
        self.orbiting = orbiting
        self.reference = reference
        self.kind = "SS" if swept is None else swept.kind
        self._swept = swept

    @cached_property
    def pair(self) -> LatticePair:
        """The two shapes on their common lattice."""
        return LatticePair(self.stationary, self.orbiting, self.reference)

    @cached_property
    def _found(self) -> ss.NoFitSS:
        return self.pair.no_fit()

    @cached_property
    def exterior(self) -> Polygon:
        """The loop around all positions of overlap: the trajectory."""
        if self._swept is not None:
            return self._swept.trajectory
        return self.pair.polygon(self._found.exterior)

    @cached_property
    def holes(self) -> tuple[Polygon, ...]:
        """The loops around free positions inside, in a cave or a hole, sorted."""
        return () if self._swept is not None else self.pair.polygons(self._found.holes)

    @cached_property
    def exact_fits(self) -> tuple[Fit, ...]:
        """Free positions without free ones around them: segments and points, sorted.

        The end that hangs on a loop comes first, where only one does; a single position is a
        segment of two equal ends.
        """
        if self._swept is not None:
            return self._swept.exact_fits
        return self.pair.fits(self._found.exact_fits)

    def certificate(self) -> dict[str, Any]:
        """Plain JSON data from which anyone can check the answer, told in translations of G.

        Whatever the class of the pair, holes and exact fits are claimed to be all there are.
        """
        back = (-self.reference.x, -self.reference.y)
        return claim_no_fit(
            self.stationary,
            self.orbiting,
            self.exterior.translated(back),
            (hole.translated(back) for hole in self.holes),
            _moved(self.exact_fits, back),
        )

    @property
    def area(self) -> Fraction:
        """The area of the positions of overlap."""
        return self.exterior.area - add_up(hole.area for hole in self.holes)

    def __str__(self) -> str:
        lines = [f"exterior, {len(self.exterior)} vertices: {self.exterior}"]
        lines += [f"hole, {len(hole)} vertices: {hole}" for hole in self.holes]
        return "\n".join([*lines, *map(_said, self.exact_fits)])

    def __repr__(self) -> str:
        return (
            f"<NoFitPolygon {self.kind} of {len(self.orbiting)} around {len(self.stationary)} "
            f"vertices: exterior {len(self.exterior)} vertices, {len(self.holes)} holes, "
            f"{len(self.exact_fits)} exact fits>"
        )


class InnerFitPositions:
    """The positions of a part inside a container, and free of placed shapes if there are any.

    `inner_fit_polygon` and `free_positions` make it. It is true if there is any position.

    Attributes:
        container: a Region, whose holes are defects.
        part: a Region.
        reference: the point of the part whose positions are told, a Point.
        placed: the Regions that the part must not overlap.
    """

    def __init__(
        self, container: Region, part: Region, reference: Point, placed: Sequence[Region] = ()
    ) -> None:
        self.container = container
        self.part = part
        self.reference = reference
        self.placed = tuple(placed)

    @cached_property
    def _pair(self) -> LatticePair:
        return LatticePair(self.container, self.part, self.reference, self.placed)

    def __bool__(self) -> bool:
        return bool(self.regions or self.exact_fits)

    def locate(self, position: Iterable[object]) -> Literal["inside", "boundary", "outside"]:
        """Locate a position: "inside" where the part can move in all directions.

        Args:
            position: a pair of numbers, where the reference point of the part is.

        Returns:
            "inside" a region; on the "boundary" of one, where the part touches what it must not
            overlap, or in an exact fit; or "outside", where it overlaps.

        Raises:
            NumberError: a coordinate is not an exact number.

        Cost: that of the positions, and linear in their size.

        Example:
            >>> from exactsweep import inner_fit_polygon
            >>> f = inner_fit_polygon([(0, 0), (4, 0), (4, 2), (0, 2)], [(0, 0), (1, 0), (0, 1)])
            >>> f.locate((1, 1)), f.locate((0, 1)), f.locate((9, 1))
            ('boundary', 'boundary', 'outside')
        """
        t = read_point(position, "position")
        if any(region.contains(t, strictly=True) for region in self.regions):
            return "inside"
        if any(region.contains(t) for region in self.regions) or any(
            is_on(t, fit) for fit in self.exact_fits
        ):
            return "boundary"
        return "outside"

    @cached_property
    def _found(self) -> ss.InnerFitSS:
        return self._pair.inner_fit()

    @cached_property
    def regions(self) -> tuple[Region, ...]:
        """The free regions, sorted; none where the part does not fit."""
        regions = [
            Region(self._pair.polygon(exterior), self._pair.polygons(holes))
            for exterior, holes in self._found.regions
        ]
        return tuple(sorted(regions, key=lambda region: region.rings))

    @cached_property
    def exact_fits(self) -> tuple[Fit, ...]:
        """Positions without room in some direction, as for `NoFitPolygon`."""
        return self._pair.fits(self._found.exact_fits)

    def certificate(self) -> dict[str, Any]:
        """Plain JSON data from which anyone can check the answer, told in translations.

        Raises:
            PolygonError: shapes are placed, of which certificates do not tell.
        """
        if self.placed:
            raise PolygonError("positions among placed shapes have no certificate")
        back = (-self.reference.x, -self.reference.y)
        return claim_inner_fit(
            self.container,
            self.part,
            (region.translated(back) for region in self.regions),
            _moved(self.exact_fits, back),
        )

    @property
    def area(self) -> Fraction:
        """The area of the free regions."""
        return add_up(region.area for region in self.regions)

    def __str__(self) -> str:
        lines = [f"region, {len(region)} vertices: {region}" for region in self.regions]
        return "\n".join([*lines, *map(_said, self.exact_fits)]) or "it does not fit"

    def __repr__(self) -> str:
        return (
            f"<InnerFit of {len(self.part)} in {len(self.container)} vertices: "
            f"{len(self.regions)} regions, {len(self.exact_fits)} exact fits>"
        )


def _moved(fits: Sequence[Fit], by: tuple[Fraction, Fraction]) -> list[list[Point]]:
    return [[Point(p.x + by[0], p.y + by[1]) for p in fit] for fit in fits]


def _said(fit: Fit) -> str:
    ends = dict.fromkeys(fit)
    return f"exact fit: {' '.join(map(write_pair, ends))}"
