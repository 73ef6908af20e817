"""The solids of a layout: placed parts, the outside and the defects, as fine as needed."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cached_property
from math import ceil, floor

from exactsweep.geometry.lattice import lcm_within
from exactsweep.geometry.point_set import AffineMap
from exactsweep.geometry.region import Region
from exactsweep.geometry.turn import Turn
from exactsweep.layout.layout import Layout
from exactsweep.layout.near import find_near
from exactsweep.layout.solid import LatticeBox, LatticeForm, Solid, make_form, measure_reach
from exactsweep.numbers.point import Rational

BITS = 64
"""As near are rational turns at first to angles that have none."""

_SHARED_BITS = 1024
_ROOM = 1


class Board:
    """The solids of a layout.

    Args:
        layout: a Layout.

    Attributes:
        placed: the numbers of the placements whose parts are simple.
    """

    def __init__(self, layout: Layout) -> None:
        self.layout = layout
        parts = layout.part_by_id
        self.placed = [
            k for k, one in enumerate(layout.placements) if parts[one.part].region is not None
        ]
        self._forms: dict[tuple[str, Turn, bool, int], tuple[int, LatticeForm]] = {}
        self._solids: dict[tuple[int, int], Solid] = {}

    def turned(self, k: int, bits: int = BITS) -> Region:
        """Return the part of a placement, mirrored and turned by a rational turn, not moved."""
        placement = self.layout.placements[k]
        region = self.layout.part_by_id[placement.part].region
        assert region is not None
        cosine, sine, _ = placement.turn.near(bits)
        across = -1 if placement.mirrored else 1
        return region._image(AffineMap(across * cosine, -sine, across * sine, cosine))

    def _form(self, k: int, bits: int) -> tuple[int, LatticeForm]:
        placement = self.layout.placements[k]
        key = placement.part, placement.turn, placement.mirrored, bits
        found = self._forms.get(key)
        if found is None:
            found = self._forms[key] = make_form(self.turned(k, bits))
        return found

    @cached_property
    def _scale(self) -> int | None:
        """The scale of the lattice that all solids share, if there is one."""
        layout = self.layout
        scales = {self._form(k, BITS)[0] for k in self.placed}
        scales.add(layout.container.lattice()[0])
        scales.update(c.denominator for k in self.placed for c in layout.placements[k].move)
        scale = lcm_within(scales)
        return None if scale is None or scale.bit_length() > _SHARED_BITS else scale

    def solid(self, k: int, bits: int = BITS) -> Solid:
        """Return the solid of a placement, of which the turn is off by at most 2**-bits."""
        found = self._solids.get((k, bits))
        if found is not None:
            return found
        placement = self.layout.placements[k]
        scale, form = self._form(k, bits)
        x, y = placement.move
        shared = self._scale if bits == BITS else None
        finer = shared or lcm_within((scale, x.denominator, y.denominator)) or scale
        slack = placement.turn.near(bits).error
        if slack:
            slack *= self._reaches[placement.part]
        solid = Solid(
            form.scaled(finer // scale),
            _multiply(x, finer),
            _multiply(y, finer),
            finer,
            slack,
        )
        self._solids[k, bits] = solid
        return solid

    @cached_property
    def _reaches(self) -> dict[str, Fraction]:
        """How far each part reaches from its origin."""
        return {part.id: measure_reach(part.region) for part in self.layout.parts if part.region}

    @cached_property
    def around(self) -> list[Solid]:
        """The outside of the container in a frame around everything, and each defect."""
        container = self.layout.container
        low, high = container.bounding_box
        room = _ROOM + self.layout.margin + self.layout.spacing
        xs: list[Rational] = [low.x, high.x]
        ys: list[Rational] = [low.y, high.y]
        for k in self.placed:
            solid = self.solid(k)
            left, right, bottom, top = solid.box
            xs += (left // solid.scale, -(-right // solid.scale))
            ys += (bottom // solid.scale, -(-top // solid.scale))
            room = max(room, solid.slack + _ROOM)
        left, right = floor(min(xs) - room), ceil(max(xs) + room)
        bottom, top = floor(min(ys) - room), ceil(max(ys) + room)
        frame = [(left, bottom), (right, bottom), (right, top), (left, top)]
        regions = [Region(frame, [container.exterior]), *map(Region, container.holes)]
        found = []
        for region in regions:
            scale, form = make_form(region)
            finer = self._scale or scale
            found.append(Solid(form.scaled(finer // scale), 0, 0, finer, Fraction(0)))
        return found

    @cached_property
    def grain(self) -> Fraction:
        """The least width or height of a placed part."""
        sizes = [
            Fraction(min(right - left, high - low)) / solid.scale
            for solid in map(self.solid, self.placed)
            for left, right, low, high in [solid.box]
        ]
        return min(sizes)

    @cached_property
    def unit(self) -> int:
        """The scale on which boxes are compared: that of the lattice, or fine enough."""
        return self._scale or ceil(1024 / self.grain)

    def list_near(self, reach: Fraction) -> Iterator[tuple[int, int]]:
        """Find the pairs of placements whose boxes are within reach in both coordinates."""
        placed, unit = self.placed, self.unit
        boxes = [_enlarge(self.solid(k), unit) for k in placed]
        for k, j in find_near(boxes, ceil(reach * unit)):
            yield placed[k], placed[j]


def _multiply(value: Fraction, scale: int) -> int:
    """A number on a lattice: an int, if the lattice holds it."""
    found = value * scale
    return found.numerator if found.denominator == 1 else found  # type: ignore[return-value]


def _enlarge(solid: Solid, unit: int) -> LatticeBox:
    """The box of a solid in a unit, with room for its slack."""
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
