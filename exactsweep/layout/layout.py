"""Layouts: a container, parts, and placements of the parts."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, Self

from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.interface import GeoJson, make_polygon
from exactsweep.geometry.point_set import AffineMap
from exactsweep.geometry.region import Region
from exactsweep.geometry.turn import TURN_BITS, Turn
from exactsweep.layout import reading
from exactsweep.layout.reading import LayoutError
from exactsweep.layout.rounded import BodyShape, RoundedPiece, read_pieces, to_region
from exactsweep.numbers.digits import to_plain
from exactsweep.numbers.error import quote
from exactsweep.numbers.number import Loop, Point

_ShapeRings = tuple[Loop, tuple[Loop, ...]]


@dataclass(frozen=True)
class Placement:
    """A copy of a part: mirrored (x to -x), then rotated about its origin, then translated."""

    part: str
    turn: Turn
    move: Point
    mirrored: bool = False

    @classmethod
    def from_json(cls, data: object, path: str) -> Self:
        """Read a placement from JSON data; error messages start with `path`."""
        found = reading.read_object(data, path, ("part", "move"), ("turn", "mirrored"))
        return cls(
            reading.read_id(found["part"], f"{path}.part"),
            reading.read_turn(found.get("turn", 0), f"{path}.turn"),
            reading.read_vertex(found["move"], f"{path}.move"),
            reading.read_flag(found.get("mirrored"), f"{path}.mirrored") or False,
        )

    def rows(self, bits: int = TURN_BITS) -> tuple[Fraction, Fraction, Fraction, Fraction]:
        """Return the rows of the linear map; the error of the rotation is at most 2**-bits."""
        cosine, sine, _ = self.turn.near(bits)
        across = -1 if self.mirrored else 1
        return across * cosine, -sine, across * sine, cosine


@dataclass(frozen=True)
class LayoutPart:
    """A part to be placed, with the rules for its placements.

    Attributes:
        id: its name, unique in the layout.
        exterior: its vertices as in the input, a tuple of Point.
        holes: the vertices of each hole.
        demand: the required number of placements; None for any number.
        turns: the allowed rotations, a tuple of Turn; None for all.
        mirrored: whether placements may be mirrored; None allows it.
        error: a bound on the Hausdorff distance between the rings and the true curves; 0 for a
            polygon.
        mirrored_turns: the allowed rotations of mirrored placements; None for `turns`.
        pieces: a tuple of RoundedPiece, whose union is the part; then `exterior` is empty.
    """

    id: str
    exterior: Loop
    holes: tuple[Loop, ...] = ()
    demand: int | None = None
    turns: tuple[Turn, ...] | None = None
    mirrored: bool | None = None
    error: Fraction = Fraction(0)
    mirrored_turns: tuple[Turn, ...] | None = None
    pieces: tuple[RoundedPiece, ...] = ()

    @classmethod
    def from_json(cls, data: object, path: str) -> Self:
        """Read a part from JSON data; error messages start with `path`."""
        rules = ("demand", "turns", "mirrored", "mirrored_turns")
        found, (exterior, holes), pieces, error = _read_shape(data, path, ("id",), rules)
        demand = found.get("demand")
        turns, mirrored = (
            None
            if found.get(name) is None
            else reading.read_list(found[name], f"{path}.{name}", reading.read_turn)
            for name in ("turns", "mirrored_turns")
        )
        if demand is not None and (type(demand) is not int or demand < 0):
            raise LayoutError(f"{path}.demand is {quote(demand)}, not a non-negative integer")
        return cls(
            reading.read_id(found["id"], f"{path}.id"),
            exterior,
            holes,
            demand,
            turns,
            reading.read_flag(found.get("mirrored"), f"{path}.mirrored"),
            error,
            mirrored,
            pieces,
        )

    def allows(self, placement: Placement) -> bool:
        """Return whether the rotation of a placement is allowed."""
        turns = self.turns
        if placement.mirrored and self.mirrored_turns is not None:
            turns = self.mirrored_turns
        return turns is None or placement.turn in turns

    @property
    def shape(self) -> BodyShape | None:
        """The rounded pieces or the `region`; None if the rings do not bound a region."""
        return self.pieces or self.region

    @cached_property
    def region(self) -> Region | None:
        """The part as a Region; None if it is rounded or its rings do not bound a region."""
        return None if self.pieces else self._read[0]

    @cached_property
    def refusal(self) -> str:
        """The reason why the rings do not bound a region, or ""."""
        return self._read[1]

    @cached_property
    def _read(self) -> tuple[Region | None, str]:
        try:
            return Region(self.exterior, self.holes), ""
        except PolygonError as error:
            # Do not name a single ring.
            return None, str(error) if self.holes else str(error).removeprefix("exterior: ")


@dataclass(frozen=True)
class Defect:
    """A shape that no part may overlap; it may touch or cross the container and other defects."""

    shape: BodyShape
    error: Fraction = Fraction(0)  # as for `LayoutPart`
    spacing: Fraction | None = None  # the required distance to parts; None for the margin

    @classmethod
    def from_json(cls, data: object, path: str) -> Self:
        found, rings, pieces, error = _read_shape(data, path, (), ("spacing",))
        given = found.get("spacing")
        spacing = None if given is None else reading.read_gap(given, f"{path}.spacing")
        return cls(pieces or _make_region(rings, path), error, spacing)


@dataclass(frozen=True)
class Layout:
    """Placements of parts in a container.

    Attributes:
        container: a Region, whose holes are defects; a RoundedPiece, such as a disc; or None.
        spacing: the required distance between placed parts, at least 0.
        margin: the required distance from parts to the container's boundary and to defects, at
            least 0.
        error: as for `LayoutPart`, of the container.
        defects: a tuple of Defect, in addition to the holes of the container.
    """

    container: Region | RoundedPiece | None
    parts: tuple[LayoutPart, ...]
    placements: tuple[Placement, ...]
    spacing: Fraction = Fraction(0)
    margin: Fraction = Fraction(0)
    error: Fraction = Fraction(0)
    defects: tuple[Defect, ...] = ()

    @classmethod
    def from_json(cls, data: object) -> Self:
        """Read a layout from plain JSON data; `layout.schema.json` defines the format.

        Args:
            data: a dict. Numbers are strings such as "1/3" and "0.1", ints, or floats with their
                exact binary values.

        Returns:
            A Layout. Parts need not be simple polygons; the judge reports those that are not. If
            holes of the container touch or cross each other or its boundary, all are `defects`.

        Raises:
            LayoutError: not a layout; the message names the field, such as "placements[3].turn".

        Example:
            >>> square = [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]]
            >>> layout = Layout.from_json({
            ...     "container": {"exterior": [["0", "0"], ["2", "0"], ["2", "1"], ["0", "1"]]},
            ...     "parts": [{"id": "tile", "exterior": square, "demand": 2}],
            ...     "placements": [{"part": "tile", "turn": "0", "move": ["1", "0"]}],
            ... })
            >>> layout.placements[0].move
            Point(x=Fraction(1, 1), y=Fraction(0, 1))
        """
        fields = ("parts", "placements"), ("container", "defects", "spacing", "margin")
        found = reading.read_object(data, "the layout", *fields)
        parts = reading.read_list(found["parts"], "parts", LayoutPart.from_json)
        numbers: dict[str, int] = {}
        for k, part in enumerate(parts):
            if (other := numbers.setdefault(part.id, k)) < k:
                raise LayoutError(f"parts[{k}].id: duplicate of parts[{other}]")
        placements = reading.read_list(found["placements"], "placements", Placement.from_json)
        for k, placement in enumerate(placements):
            if placement.part not in numbers:
                raise LayoutError(
                    f"placements[{k}].part: no part has the id {quote(placement.part)}"
                )
        defects = reading.read_list(found.get("defects", ()), "defects", Defect.from_json)
        container, holes = None, tuple[Defect, ...]()
        error = Fraction(0)
        if found.get("container") is not None:
            container, error, holes = _read_container(found["container"])
        return cls(
            container,
            parts,
            placements,
            reading.read_gap(found.get("spacing", 0), "spacing"),
            reading.read_gap(found.get("margin", 0), "margin"),
            error,
            (*holes, *defects),
        )

    def to_json(self) -> dict[str, Any]:
        """Return plain JSON data for `from_json`, with all numbers as strings."""
        defects = [
            _list_shape(one.shape, one.error)
            | ({} if one.spacing is None else {"spacing": one.spacing})
            for one in self.defects
        ]
        container = self.container
        shape = (container,) if isinstance(container, RoundedPiece) else container
        data = {
            **({} if shape is None else {"container": _list_shape(shape, self.error)}),
            **({"defects": defects} if defects else {}),
            "parts": [_list_fields(part) for part in self.parts],
            "placements": [
                {
                    "part": placement.part,
                    "turn": placement.turn.to_json(),
                    "mirrored": placement.mirrored,
                    "move": placement.move,
                }
                for placement in self.placements
            ],
            "spacing": self.spacing,
            "margin": self.margin,
        }
        return to_plain(data)

    @property
    def __geo_interface__(self) -> GeoJson:
        """The placed parts as a GeoJSON GeometryCollection.

        Irrational rotations are approximated; rounded parts become circumscribed polygons.

        Raises:
            LayoutError: a placed part is not simple.
        """
        placed = []
        for placement in self.placements:
            part = self.part_by_id[placement.part]
            if part.shape is None:
                raise LayoutError(f"part {quote(part.id)}: {part.refusal}")
            at = to_region(part.shape)._image(AffineMap(*placement.rows(), *placement.move))
            placed.append(make_polygon(at.rings))
        return {"type": "GeometryCollection", "geometries": tuple(placed)}

    @property
    def greatest_error(self) -> Fraction:
        """The maximum `error` of the container, the defects and the placed parts."""
        placed = {placement.part for placement in self.placements}
        errors = [part.error for part in self.parts if part.id in placed]
        return max([self.error, *errors, *(one.error for one in self.defects)])

    @cached_property
    def part_by_id(self) -> Mapping[str, LayoutPart]:
        """The parts by id."""
        return {part.id: part for part in self.parts}


def _read_container(
    data: object,
) -> tuple[Region | RoundedPiece, Fraction, tuple[Defect, ...]]:
    _, (exterior, holes), pieces, error = _read_shape(data, "container")
    if len(pieces) > 1:
        raise LayoutError(f"container.pieces has {len(pieces)} pieces, not 1")
    if pieces:
        return pieces[0], error, ()
    alone = _make_region((exterior, ()), "container")
    try:
        return Region(exterior, holes), error, ()
    except PolygonError:
        # Holes that touch or cross become defects.
        defects = (
            Defect(_make_region((hole, ()), f"container.holes[{k}]"), error)
            for k, hole in enumerate(holes)
        )
        return alone, error, tuple(defects)


def _read_shape(
    data: object, path: str, needed: Sequence[str] = (), others: Sequence[str] = ()
) -> tuple[Mapping[str, object], _ShapeRings, tuple[RoundedPiece, ...], Fraction]:
    is_rounded = isinstance(data, Mapping) and "pieces" in data
    form, more = ("pieces", ()) if is_rounded else ("exterior", ("holes",))
    found = reading.read_object(data, path, (*needed, form), (*more, *others, "error"))
    rings: _ShapeRings = ((), ()) if is_rounded else reading.read_rings(found, path)
    pieces = read_pieces(found["pieces"], f"{path}.pieces") if is_rounded else ()
    return found, rings, pieces, reading.read_gap(found.get("error", 0), f"{path}.error")


def _make_region(rings: _ShapeRings, path: str) -> Region:
    try:
        return Region(*rings)
    except PolygonError as error:
        raise LayoutError(f"{path}: {error}") from None


def _list_shape(shape: BodyShape, error: Fraction) -> dict[str, Any]:
    if not isinstance(shape, Region):
        return {"pieces": [piece.to_json() for piece in shape], **_list_error(error)}
    holes = [hole.vertices for hole in shape.holes]
    return {"exterior": shape.exterior.vertices, "holes": holes, **_list_error(error)}


def _list_fields(part: LayoutPart) -> dict[str, Any]:
    turns, mirrored = (
        None if turns is None else [turn.to_json() for turn in turns]
        for turns in (part.turns, part.mirrored_turns)
    )
    allowed = {
        "demand": part.demand,
        "turns": turns,
        "mirrored": part.mirrored,
        "mirrored_turns": mirrored,
    }
    rings = {"exterior": part.exterior, "holes": part.holes}
    return {
        "id": part.id,
        **({"pieces": [piece.to_json() for piece in part.pieces]} if part.pieces else rings),
        **{name: value for name, value in allowed.items() if value is not None},
        **_list_error(part.error),
    }


def _list_error(error: Fraction) -> dict[str, Fraction]:
    return {"error": error} if error else {}
