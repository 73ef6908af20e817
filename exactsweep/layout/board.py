"""The solids of a layout: placed parts, the outside of the container, and the defects."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cache, cached_property
from math import ceil, floor, lcm
from typing import Any

from exactsweep.geometry.near import find_near
from exactsweep.geometry.point_set import AffineMap
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import lcm_within
from exactsweep.geometry.region import Region
from exactsweep.geometry.turn import TURN_BITS, Turn
from exactsweep.layout.clearance import is_rounded
from exactsweep.layout.layout import Layout
from exactsweep.layout.pieces import cut_outside
from exactsweep.layout.rounded import RoundedPiece, to_region
from exactsweep.layout.solid import (
    LatticeBox,
    LatticeForm,
    MatrixRows,
    OutsideForm,
    RoundedForm,
    Solid,
    make_form,
    make_rounded_form,
    measure_slack,
    scale_to_int,
)
from exactsweep.numbers.number import Point

_SHARED_BITS = 1024
_ROOM = 1
_NONE = Fraction(0)


class Board:
    """The solids of a layout; `placed` has the indices of the placements of simple parts."""

    def __init__(self, layout: Layout) -> None:
        self.layout = layout
        self._shapes = {part.id: part.shape for part in layout.parts if part.shape is not None}
        self.placed = [k for k, one in enumerate(layout.placements) if one.part in self._shapes]
        self.base = cache(lambda part: make_form(self._shapes[part]))
        self._placed = cache(self._place)
        self._forms: dict[tuple[str, Turn, bool, int, int], LatticeForm | RoundedForm] = {}

    def turned(self, k: int, bits: int = TURN_BITS) -> Region:
        placement = self.layout.placements[k]
        # A rounded part is circumscribed.
        return to_region(self._shapes[placement.part])._image(AffineMap(*placement.rows(bits)))

    def is_rounded(self, placements: Sequence[int]) -> bool:
        """Return whether a placement, or for a single placement any obstacle, is rounded."""
        solids = [*map(self.solid, placements), *(self.obstacles if len(placements) < 2 else ())]
        return is_rounded(*solids)

    def _turn(self, k: int, bits: int) -> tuple[int, MatrixRows]:
        rows = self.layout.placements[k].rows(bits)
        denominator = lcm(*(number.denominator for number in rows))
        a, b, c, d = (scale_to_int(number, denominator) for number in rows)
        return denominator, (a, b, c, d)

    @cached_property
    def _scale(self) -> int | None:
        """The scale of a lattice for all solids; None if it would be too fine."""
        layout, placements = self.layout, self.layout.placements
        kinds = {(placements[k].part, placements[k].turn): k for k in self.placed}
        scales = {
            self.base(part)[0] * self._turn(k, TURN_BITS)[0] for (part, _), k in kinds.items()
        }
        walls = [make_form(one.shape) for one in layout.defects]
        scales.update(scale for scale, _ in walls)
        if isinstance(layout.container, Region):
            scales.add(layout.container.lattice()[0])
        elif layout.container is not None:
            scales.add(layout.container.denominator)
        moves = [placements[k].move for k in self.placed]
        scales.update(x.denominator for x, _ in moves)
        scales.update(y.denominator for _, y in moves)
        scale = lcm_within(scales)
        return None if scale is None or scale.bit_length() > _SHARED_BITS else scale

    def solid(self, k: int, bits: int = TURN_BITS) -> Solid:
        """Return the solid of a placement, with a rotation error of at most 2**-bits."""
        return self._placed(k, bits)

    def _place(self, k: int, bits: int) -> Solid:
        shared = self._scale if bits == TURN_BITS else None
        return self.solid_at(k, self.layout.placements[k].move, bits, shared)

    def solid_at(self, k: int, move: Point, bits: int, shared: int | None = None) -> Solid:
        """Return the solid of a placement at another position, by default on its own lattice."""
        placement = self.layout.placements[k]
        part, turn, (x, y) = placement.part, placement.turn, move
        scale = shared or self.base(part)[0] * self._turn(k, bits)[0]
        key = part, turn, placement.mirrored, bits, scale
        form = self._forms.get(key)
        if form is None:
            own, base = self.base(part)
            denominator, (a, b, c, d) = self._turn(k, bits)
            by = scale // (own * denominator)
            form = self._forms[key] = base.mapped((a * by, b * by, c * by, d * by))
        if shared is None:
            # Translations may have other denominators.
            finer = lcm_within((scale, x.denominator, y.denominator)) or scale
            form, scale = form.scaled(finer // scale), finer
        slack = error = self.layout.part_by_id[part].error
        if turn.exact is None:
            slack += measure_slack(self._shapes[part], turn.near(bits).error)
        place = scale_to_int(x, scale), scale_to_int(y, scale)
        return Solid(form, *place, scale, slack, error)

    @cached_property
    def frame(self) -> tuple[int, int, int, int]:
        """A rectangle with a margin around all shapes: left, low, right, high."""
        xs, ys = [0], [0]
        shapes: list[Region | RoundedPiece] = []
        for one in self.layout.defects:
            shapes += (one.shape,) if isinstance(one.shape, Region) else one.shape
        if self.layout.container is not None:
            shapes.append(self.layout.container)
        boxes = [one.bounding_box for one in shapes]
        if boxes:
            xs, ys = (
                [value for low, high in boxes for value in (floor(low[axis]), ceil(high[axis]))]
                for axis in (0, 1)
            )
        slack = _NONE
        for k in self.placed:
            solid = self.solid(k)
            scale, (left, right, bottom, top) = solid.scale, solid.box
            xs += (left // scale, -(-right // scale))
            ys += (bottom // scale, -(-top // scale))
            if solid.slack:
                slack = max(slack, solid.slack)
        # A more precise rotation may err in the opposite direction.
        room = ceil(self.layout.margin + self.layout.error + 2 * slack) + _ROOM
        return min(xs) - room, min(ys) - room, max(xs) + room, max(ys) + room

    @cached_property
    def obstacles(self) -> list[Solid]:
        """The outside of the container, if there is one, its holes, then the defects."""
        layout = self.layout
        holes = (self._fix(*make_form(Region(hole)), layout.error) for hole in self.holes)
        defects = (self._fix(*make_form(one.shape), one.error) for one in layout.defects)
        return [*self._find_outside(), *holes, *defects]

    def required(self, wall: int) -> Fraction:
        """Return the required distance between parts and an obstacle in `obstacles`."""
        number = wall - self.first_defect - len(self.holes)
        own = self.layout.defects[number].spacing if number >= 0 else None
        return self.layout.margin if own is None else own

    @cached_property
    def greatest_margin(self) -> Fraction:
        spacings = [one.spacing for one in self.layout.defects if one.spacing is not None]
        return max([self.layout.margin, *spacings])

    @property
    def first_defect(self) -> int:
        return 0 if self.layout.container is None else 1

    @property
    def holes(self) -> tuple[Polygon, ...]:
        container = self.layout.container
        return container.holes if isinstance(container, Region) else ()

    @property
    def is_open(self) -> bool:
        """Whether the outside has no convex pieces: without a container, or with a rounded one."""
        return not isinstance(self.layout.container, Region)

    def _find_outside(self) -> Iterator[Solid]:
        container = self.layout.container
        if container is None:
            return
        if isinstance(container, RoundedPiece):
            yield self._fix(*make_rounded_form([container], OutsideForm), self.layout.error)
            return
        own, ring = container.exterior.lattice()
        west, south, east, north = (c * own for c in self.frame)
        exterior: list[Any] = list(ring)
        outside = LatticeForm(
            [[(west, south), (east, south), (east, north), (west, north)], exterior[::-1]],
            lambda: cut_outside(exterior, (west, south, east, north)),
        )
        yield self._fix(own, outside, self.layout.error)

    def _fix(self, scale: int, form: LatticeForm | RoundedForm, error: Fraction) -> Solid:
        finer = self._scale or scale
        return Solid(form.scaled(finer // scale), 0, 0, finer, error, error)

    @cached_property
    def _room(self) -> LatticeBox | None:
        """The box of a rectangular container, shrunk by the margin; None for other containers."""
        container = self.layout.container
        if not isinstance(container, Region) or self._scale is None or len(container.exterior) > 4:
            return None
        low, high = container.bounding_box
        if container.exterior.area != (high.x - low.x) * (high.y - low.y):
            return None
        margin, scale = self.layout.margin + self.layout.error, self._scale
        return (
            ceil((low.x + margin) * scale),
            floor((high.x - margin) * scale),
            ceil((low.y + margin) * scale),
            floor((high.y - margin) * scale),
        )

    def is_clear(self, k: int) -> bool:
        """Return whether the box of a part alone proves that it keeps the margin."""
        if self._room is None or self._scale is None:
            return False
        left, right, low, high = _enlarge(self.solid(k), self._scale)
        west, east, south, north = self._room
        return left >= west and right <= east and low >= south and high <= north

    @cached_property
    def grain(self) -> Fraction:
        """The minimum width or height of a placed part; 1 if there is none."""
        sizes = [
            Fraction(min(right - left, high - low)) / solid.scale
            for solid in map(self.solid, self.placed)
            for left, right, low, high in [solid.box]
        ]
        return min(sizes, default=Fraction(1))

    @cached_property
    def unit(self) -> int:
        return self._scale or ceil(1024 / self.grain)

    def list_near(self, reach: Fraction) -> Iterator[tuple[int, int]]:
        """Yield the pairs of placements whose boxes are within reach in both coordinates."""
        placed, unit = self.placed, self.unit
        boxes = [_enlarge(self.solid(k), unit) for k in placed]
        for k, j in find_near(boxes, ceil(reach * unit)):
            yield placed[k], placed[j]

    def list_neighbors(self, k: int, reach: Fraction) -> list[int]:
        unit, room = self.unit, ceil(reach * self.unit)
        left, right, low, high = _enlarge(self.solid(k), unit)
        found = []
        for j in self.placed:
            west, east, south, north = _enlarge(self.solid(j), unit)
            is_near = west - right <= room >= left - east and south - high <= room >= low - north
            if j != k and is_near:
                found.append(j)
        return found

    def find_defects(self, reach: Fraction) -> dict[int, list[int]]:
        placed, unit, first = self.placed, self.unit, self.first_defect
        solids = *map(self.solid, placed), *self.obstacles[first:]
        boxes = [_enlarge(solid, unit) for solid in solids]
        found: dict[int, list[int]] = {k: [] for k in placed}
        for k, j in find_near(boxes, ceil(reach * unit)):
            if k < len(placed) <= j:
                found[placed[k]].append(j - len(placed) + first)
        return {k: sorted(walls) for k, walls in found.items()}

    def list_obstacles(self) -> Iterator[tuple[int, list[int]]]:
        """Yield each placement with the obstacles in `obstacles` that may be too close."""
        outside = range(self.first_defect)
        for k, defects in self.find_defects(self.greatest_margin).items():
            yield k, defects if self.is_clear(k) else [*outside, *defects]


def _enlarge(solid: Solid, unit: int) -> LatticeBox:
    left, right, low, high = solid.box
    if solid.scale == unit and not solid.slack:
        return left, right, low, high
    scale, room = solid.scale, solid.slack
    return (
        floor((Fraction(left) / scale - room) * unit),
        ceil((Fraction(right) / scale + room) * unit),
        floor((Fraction(low) / scale - room) * unit),
        ceil((Fraction(high) / scale + room) * unit),
    )
