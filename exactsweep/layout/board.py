"""The solids of a layout: placed parts, the outside and the defects, in the needed precision."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cache, cached_property
from math import ceil, floor, lcm
from typing import Any

from exactsweep.geometry.near import find_near
from exactsweep.geometry.point_set import AffineMap
from exactsweep.geometry.reading import lcm_within
from exactsweep.geometry.region import Region
from exactsweep.geometry.turn import TURN_BITS, Turn
from exactsweep.layout.layout import Layout
from exactsweep.layout.outside import cut_outside
from exactsweep.layout.solid import (
    LatticeBox,
    LatticeForm,
    MatrixRows,
    Solid,
    make_form,
    measure_slack,
    put_on_lattice,
)

_SHARED_BITS = 1024
_ROOM = 1
_NONE = Fraction(0)


class Board:
    """The solids of a layout.

    Args:
        layout: a Layout.

    Attributes:
        placed: the numbers of the placements of simple parts.
    """

    def __init__(self, layout: Layout) -> None:
        self.layout = layout
        self._regions = {part.id: part.region for part in layout.parts if part.region is not None}
        self.placed = [k for k, one in enumerate(layout.placements) if one.part in self._regions]
        self.base = cache(lambda part: make_form(self._regions[part]))
        self._placed = cache(self._place)
        self._forms: dict[tuple[str, Turn, bool, int], LatticeForm] = {}

    def turned(self, k: int, bits: int = TURN_BITS) -> Region:
        """Return the part of a placement, mirrored and turned by a rational turn, not moved."""
        placement = self.layout.placements[k]
        return self._regions[placement.part]._image(AffineMap(*placement.rows(bits)))

    def _turn(self, k: int, bits: int) -> tuple[int, MatrixRows]:
        """Return the linear map of a placement as ints with a common denominator."""
        rows = self.layout.placements[k].rows(bits)
        denominator = lcm(*(number.denominator for number in rows))
        a, b, c, d = (put_on_lattice(number, denominator) for number in rows)
        return denominator, (a, b, c, d)

    @cached_property
    def _scale(self) -> int | None:
        """Return the scale of the lattice that all solids share, if there is one."""
        layout, placements = self.layout, self.layout.placements
        kinds = {(placements[k].part, placements[k].turn): k for k in self.placed}
        scales = {
            self.base(part)[0] * self._turn(k, TURN_BITS)[0] for (part, _), k in kinds.items()
        }
        scales.add(layout.container.lattice()[0])
        moves = [placements[k].move for k in self.placed]
        scales.update(x.denominator for x, _ in moves)
        scales.update(y.denominator for _, y in moves)
        scale = lcm_within(scales)
        return None if scale is None or scale.bit_length() > _SHARED_BITS else scale

    def solid(self, k: int, bits: int = TURN_BITS) -> Solid:
        """Return the solid of a placement, with a turn off by at most 2**-bits."""
        return self._placed(k, bits)

    def _place(self, k: int, bits: int) -> Solid:
        placement = self.layout.placements[k]
        part, turn, (x, y) = placement.part, placement.turn, placement.move
        shared = self._scale if bits == TURN_BITS else None
        scale = shared or self.base(part)[0] * self._turn(k, bits)[0]
        key = part, turn, placement.mirrored, bits
        form = self._forms.get(key)
        if form is None:
            own, base = self.base(part)
            denominator, (a, b, c, d) = self._turn(k, bits)
            by = scale // (own * denominator)
            form = self._forms[key] = base.mapped((a * by, b * by, c * by, d * by))
        if shared is None:
            # Moves may have other denominators.
            finer = lcm_within((scale, x.denominator, y.denominator)) or scale
            form, scale = form.scaled(finer // scale), finer
        slack = error = self.layout.part_by_id[part].error
        if turn.exact is None:
            slack += measure_slack(self._regions[part], turn.near(bits).error)
        place = put_on_lattice(x, scale), put_on_lattice(y, scale)
        return Solid(form, *place, scale, slack, error)

    @cached_property
    def frame(self) -> tuple[int, int, int, int]:
        """A rectangle with room around everything: left, low, right, high."""
        low, high = self.layout.container.bounding_box
        xs, ys = [floor(low.x), ceil(high.x)], [floor(low.y), ceil(high.y)]
        slack = _NONE
        for k in self.placed:
            solid = self.solid(k)
            scale, (left, right, bottom, top) = solid.scale, solid.box
            xs += (left // scale, -(-right // scale))
            ys += (bottom // scale, -(-top // scale))
            if solid.slack:
                slack = max(slack, solid.slack)
        # A more precise turn may err to the other side.
        room = ceil(self.layout.margin + self.layout.error + 2 * slack) + _ROOM
        return min(xs) - room, min(ys) - room, max(xs) + room, max(ys) + room

    @cached_property
    def around(self) -> list[Solid]:
        """The outside of the container in the frame, and each defect."""
        container = self.layout.container
        own, ring = container.exterior.lattice()
        west, south, east, north = (c * own for c in self.frame)
        exterior: list[Any] = list(ring)
        outside = LatticeForm(
            [[(west, south), (east, south), (east, north), (west, north)], exterior[::-1]],
            lambda: cut_outside(exterior, (west, south, east, north)),
        )
        found = []
        for scale, form in ((own, outside), *(make_form(Region(h)) for h in container.holes)):
            finer = self._scale or scale
            error = self.layout.error
            found.append(Solid(form.scaled(finer // scale), 0, 0, finer, error, error))
        return found

    @cached_property
    def _room(self) -> LatticeBox | None:
        """The box of a rectangular container without the margin, in which parts are inside."""
        low, high = self.layout.container.bounding_box
        if self._scale is None or len(self.layout.container.exterior) > 4:
            return None
        if self.layout.container.exterior.area != (high.x - low.x) * (high.y - low.y):
            return None
        margin, scale = self.layout.margin + self.layout.error, self._scale
        return (
            ceil((low.x + margin) * scale),
            floor((high.x - margin) * scale),
            ceil((low.y + margin) * scale),
            floor((high.y - margin) * scale),
        )

    def is_clear(self, k: int) -> bool:
        """Decide from its box alone whether a part keeps the margin inside the container."""
        if self._room is None or self._scale is None:
            return False
        left, right, low, high = _enlarge(self.solid(k), self._scale)
        west, east, south, north = self._room
        return left >= west and right <= east and low >= south and high <= north

    @cached_property
    def grain(self) -> Fraction:
        """The least width or height of a placed part; 1 if there is none."""
        sizes = [
            Fraction(min(right - left, high - low)) / solid.scale
            for solid in map(self.solid, self.placed)
            for left, right, low, high in [solid.box]
        ]
        return min(sizes, default=Fraction(1))

    @cached_property
    def unit(self) -> int:
        """The scale for comparisons of boxes: that of the lattice, or a fine one."""
        return self._scale or ceil(1024 / self.grain)

    def list_near(self, reach: Fraction) -> Iterator[tuple[int, int]]:
        """Find the pairs of placements whose boxes are within reach in both coordinates."""
        placed, unit = self.placed, self.unit
        boxes = [_enlarge(self.solid(k), unit) for k in placed]
        for k, j in find_near(boxes, ceil(reach * unit)):
            yield placed[k], placed[j]

    def find_defects(self, reach: Fraction) -> dict[int, list[int]]:
        """Find for each placement the defects, as in `around`, whose boxes are within reach."""
        placed, unit = self.placed, self.unit
        boxes = [_enlarge(solid, unit) for solid in (*map(self.solid, placed), *self.around[1:])]
        found: dict[int, list[int]] = {k: [] for k in placed}
        for k, j in find_near(boxes, ceil(reach * unit)):
            if k < len(placed) <= j:
                found[placed[k]].append(j - len(placed) + 1)
        return {k: sorted(walls) for k, walls in found.items()}


def _enlarge(solid: Solid, unit: int) -> LatticeBox:
    """Return the box of a solid in a unit, enlarged by its slack."""
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
