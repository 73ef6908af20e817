"""Polygons in a file, read on demand."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from functools import partial
from itertools import chain
from operator import sub
from typing import NamedTuple, NoReturn, Self, TypeVar

from exactsweep.formats.curved.curves import round_root_up
from exactsweep.formats.curved.path import SimpleLines
from exactsweep.formats.error import FormatError
from exactsweep.formats.filling import Filled, Rule, fill
from exactsweep.formats.part_list import Remarks
from exactsweep.formats.rounded import RoundedOutline
from exactsweep.formats.size import FAULT, require_count
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.near import bound_points
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import AnyPolygon, Region
from exactsweep.numbers.error import NumberError
from exactsweep.numbers.limits import get_limits
from exactsweep.numbers.number import Point
from exactsweep.words import count

_Any = TypeVar("_Any")
_PolygonOrRegion = TypeVar("_PolygonOrRegion", Polygon, Region)


class NamedPolygon(NamedTuple):
    """A polygon in a file.

    Attributes:
        name: its id, or None.
        layer: its DXF or Inkscape layer, or None.
        error: a bound on the Hausdorff distance between its boundary and the drawn curves; 0 if
            there are none.
    """

    polygon: Polygon
    name: str | None = None
    layer: str | None = None
    error: Fraction = Fraction(0)


class NamedRegion(NamedTuple):
    """A polygon with holes in a file; attributes as for `NamedPolygon`."""

    region: Region
    name: str | None = None
    layer: str | None = None
    error: Fraction = Fraction(0)

    def flipped(self) -> Self:
        """Flip the Y axis."""
        return self._replace(region=self.region.scaled((1, -1)))


class Candidate(NamedTuple):
    """A polygon in a file, parsed on demand, so that an invalid one does not affect others."""

    place: str  # in the file, for messages; "" if the errors of `vertices` include it
    vertices: Callable[[], Sequence[Point]]  # parses the vertices, or raises FormatError
    name: str | None = None
    layer: str | None = None
    holes: Callable[[], Sequence[Candidate]] = tuple  # the inner rings
    fault: str = ""  # why it is not a polygon, if known before parsing
    ornament: bool = False  # whether it cannot be part of any outline
    error: Fraction = Fraction(0)
    rule: Rule | None = None  # for rings that touch or cross themselves; None to reject them
    clean: Fraction = Fraction(0)  # the minimum area of the regions to read
    finer: Callable[[Fraction], Candidate | None] | None = None  # flattens at another tolerance
    words: tuple[str, ...] = ()  # SVG classes
    groups: tuple[str, ...] = ()  # ids of the SVG groups around it
    rounded: RoundedOutline | None = None  # if it is a disc, a slot or a rounded polygon
    points: tuple[Point, ...] = ()  # the vertices of rejected open lines

    @classmethod
    def from_error(
        cls,
        reason: str | Exception,
        name: str | None = None,
        layer: str | None = None,
        *,
        ornament: bool = False,
    ) -> Self:
        fault = str(reason)

        def vertices() -> NoReturn:
            raise FormatError(fault)

        return cls("", vertices, name, layer, fault=fault, ornament=ornament)

    def rejected(self, reason: str, *, ornament: bool = False) -> Self:
        found = type(self).from_error(reason, self.name, self.layer, ornament=ornament)
        return found._replace(groups=self.groups)

    @classmethod
    def of_rings(
        cls,
        rings: Iterable[tuple[str, Callable[[], Sequence[Point]]]],
        place: str = "",
        name: str | None = None,
        layer: str | None = None,
        error: Fraction = Fraction(0),
    ) -> Self:
        """Make a candidate from pairs (place, parser), the exterior first."""
        exterior, *holes = (cls(where, read) for where, read in rings)
        return exterior._replace(
            place=place or exterior.place,
            name=name,
            layer=layer,
            holes=partial(tuple, holes),
            error=error,
        )

    def flipped(self) -> Self:
        return self._replace(
            vertices=lambda: [Point(p.x, -p.y) for p in self.vertices()],
            holes=lambda: [hole.flipped() for hole in self.holes()],
            rounded=self.rounded and self.rounded.flipped(),
        )

    def polygon(self) -> Polygon:
        """Parse the polygon; raises FormatError, or PolygonError if it is not simple."""
        for hole in self.holes():
            raise FormatError(f"{hole.place}: a hole; read the polygon as a Region")
        return self._read(self._make_polygon)

    def region(self) -> Region:
        holes = self.holes()
        if not holes:
            return Region(self.polygon())
        return self._read(
            lambda: Region(self._checked_vertices(), [hole._checked_vertices() for hole in holes])
        )

    def read(self, read: Callable[[Candidate], _Any], remarks: Remarks) -> list[_Any]:
        """Read the outline or, if it is not simple, the regions that it fills."""
        if not self.clean:
            try:
                return [read(self)]
            except PolygonError:
                if self.rule is None:
                    raise
        return [*map(read, self.split(remarks))]

    def split(self, remarks: Remarks) -> list[Candidate]:
        """Return the outline or the regions that it fills, except those smaller than `clean`."""
        pieces: list[Candidate] = [self]
        try:
            self.region()
        except PolygonError as error:
            if self.rule is not None:
                rings = [self.vertices(), *(hole.vertices() for hole in self.holes())]
                filled = fill(rings, self.rule, measured=bool(self.error))
                pieces = [*self.make_regions(filled)]
            if self.rule is None or not pieces:
                raise
            regions = count(len(pieces), "polygon")
            remarks.notes.append(f"{error}; {regions} by the {self.rule} fill rule")
        found = []
        for piece in pieces:
            area = piece.region().area if self.clean else self.clean
            if area < self.clean:
                remarks.left_out.append(f"{piece.place}: area {float(area):.3g} is below --clean")
            else:
                found.append(piece)
        return found

    def make_regions(self, filled: Filled) -> list[Self]:
        error = self.error + round_root_up(filled.hidden)
        found: list[Self] = []
        for region in filled.regions:
            readers = [(f"{self.place}: ring {k}", ring.copy) for k, ring in enumerate(region)]
            piece = self.of_rings(readers, self.place, self.name, self.layer, error)
            found.append(piece._replace(words=self.words, groups=self.groups))
        if not error:
            return found
        return [
            piece._replace(finer=partial(self._find_finer, found, k))
            for k, piece in enumerate(found)
        ]

    def _find_finer(self, found: Sequence[Self], k: int, tolerance: Fraction) -> Candidate | None:
        finer = self.finer(tolerance) if self.finer else None
        return match_region(found, k, finer.split(Remarks([], [])) if finer else [])

    def _make_polygon(self) -> Polygon:
        points = self._checked_vertices()
        known = points.polygon if isinstance(points, SimpleLines) else None
        return known or Polygon(points)

    def shape(self) -> AnyPolygon:
        return self.region() if self.holes() else self.polygon()

    def _checked_vertices(self) -> Sequence[Point]:
        """Parse the vertices; reject numbers that transformations made too long."""
        points = self.vertices()
        numbers = (n for c in chain.from_iterable(points) for n in c.as_integer_ratio())
        longest = max(map(abs, numbers), default=0)
        most = get_limits().answer_digits
        # A bit is 0.30103 digits, rounded up.
        if longest.bit_length() * 30_103 > most * 100_000:
            raise NumberError(f"a coordinate has more than {most} digits (max_digits)")
        return points

    def _read(self, shape: Callable[[], _PolygonOrRegion]) -> _PolygonOrRegion:
        try:
            return shape()
        except (PolygonError, NumberError) as error:
            kind = PolygonError if isinstance(error, PolygonError) else FormatError
            raise kind(f"{self.place}: {error}" if self.place else str(error)) from None

    def named_polygons(self, remarks: Remarks) -> list[NamedPolygon]:
        return self.read(lambda c: NamedPolygon(c.polygon(), c.name, c.layer, c.error), remarks)

    def named_regions(self, remarks: Remarks) -> list[NamedRegion]:
        return self.read(lambda c: NamedRegion(c.region(), c.name, c.layer, c.error), remarks)


def match_region(
    pieces: Sequence[Candidate], k: int, others: Sequence[Candidate]
) -> Candidate | None:
    """Return the region that corresponds to piece k at another tolerance, or None."""
    if len(pieces) != len(others):
        return None
    one, other = pieces[k], others[k]
    moves = map(sub, bound_points(one.vertices()), bound_points(other.vertices()))
    return other if max(map(abs, moves)) <= one.error + other.error else None


def limit_faults(drawn: Iterable[_Any]) -> Iterator[_Any]:
    """Yield the items; raise FormatError if too many are rejected candidates."""
    number, first = 0, ""
    for one in drawn:
        if isinstance(one, Candidate) and one.fault:
            number, first = number + 1, first or one.fault
            try:
                require_count(number, FAULT, "elements that are not polygons")
            except FormatError as error:
                raise FormatError(f"{error}; the first: {first}") from None
        yield one
