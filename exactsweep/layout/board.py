"""The solids of a layout: placed parts, the outside and the defects, as fine as needed."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cached_property
from math import ceil, floor

from exactsweep.geometry.lattice import lcm_within
from exactsweep.geometry.point_set import AffineMap
from exactsweep.geometry.region import Region
from exactsweep.geometry.turn import TURN_BITS, Turn
from exactsweep.layout.layout import Layout
from exactsweep.layout.near import find_near
from exactsweep.layout.outside import cut_outside
from exactsweep.layout.pieces import ConvexRing
from exactsweep.layout.solid import LatticeBox, LatticeForm, Solid, make_form, measure_slack

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
        self._regions = {part.id: part.region for part in layout.parts if part.region is not None}
        self.placed = [k for k, one in enumerate(layout.placements) if one.part in self._regions]
        self._pieces: dict[str, list[ConvexRing]] = {}
        self._forms: dict[tuple[str, Turn, bool, int], tuple[int, LatticeForm]] = {}
        self._solids: dict[tuple[int, int], Solid] = {}

    def _linear(self, k: int, bits: int) -> tuple[Fraction, Fraction, Fraction, Fraction]:
        """The matrix of a placement, by rows."""
        placement = self.layout.placements[k]
        cosine, sine, _ = placement.turn.near(bits)
        across = -1 if placement.mirrored else 1
        return across * cosine, -sine, across * sine, cosine

    def turned(self, k: int, bits: int = TURN_BITS) -> Region:
        """Return the part of a placement, mirrored and turned by a rational turn, not moved."""
        region = self._regions[self.layout.placements[k].part]
        return region._image(AffineMap(*self._linear(k, bits)))

    def pieces(self, part: str) -> list[ConvexRing]:
        """Return the convex pieces of a part, on its own lattice. Cost: that of `cut_to_convex`."""
        found = self._pieces.get(part)
        if found is None:
            _, form = make_form(self._regions[part])
            found = self._pieces[part] = form.pieces
        return found

    def _turned_pieces(self, k: int, bits: int, scale: int) -> list[ConvexRing]:
        """The pieces of a placed part, mirrored and turned, on a lattice."""
        placement = self.layout.placements[k]
        factor = Fraction(scale) / self._regions[placement.part].lattice()[0]
        a, b, c, d = (part * factor for part in self._linear(k, bits))
        turned = [
            [(_whole(a * x + b * y), _whole(c * x + d * y)) for x, y in piece]
            for piece in self.pieces(placement.part)
        ]
        return [piece[::-1] for piece in turned] if placement.mirrored else turned

    def _form(self, k: int, bits: int) -> tuple[int, LatticeForm]:
        placement = self.layout.placements[k]
        key = placement.part, placement.turn, placement.mirrored, bits
        found = self._forms.get(key)
        if found is None:
            found = self._forms[key] = make_form(
                self.turned(k, bits), lambda scale: self._turned_pieces(k, bits, scale)
            )
        return found

    @cached_property
    def _scale(self) -> int | None:
        """The scale of the lattice that all solids share, if there is one."""
        layout = self.layout
        scales = {self._form(k, TURN_BITS)[0] for k in self.placed}
        scales.add(layout.container.lattice()[0])
        scales.update(c.denominator for k in self.placed for c in layout.placements[k].move)
        scale = lcm_within(scales)
        return None if scale is None or scale.bit_length() > _SHARED_BITS else scale

    def solid(self, k: int, bits: int = TURN_BITS) -> Solid:
        """Return the solid of a placement, of which the turn is off by at most 2**-bits."""
        found = self._solids.get((k, bits))
        if found is not None:
            return found
        placement = self.layout.placements[k]
        scale, form = self._form(k, bits)
        x, y = placement.move
        shared = self._scale if bits == TURN_BITS else None
        finer = shared or lcm_within((scale, x.denominator, y.denominator)) or scale
        error = placement.turn.near(bits).error
        slack = measure_slack(self._regions[placement.part], error) if error else error
        solid = Solid(
            form.scaled(finer // scale),
            _whole(x * finer),
            _whole(y * finer),
            finer,
            slack,
        )
        self._solids[k, bits] = solid
        return solid

    @cached_property
    def frame(self) -> tuple[int, int, int, int]:
        """A rectangle that holds all with room to spare: left, low, right, high."""
        low, high = self.layout.container.bounding_box
        xs, ys = [floor(low.x), ceil(high.x)], [floor(low.y), ceil(high.y)]
        slack = Fraction(0)
        for k in self.placed:
            solid = self.solid(k)
            scale, (left, right, bottom, top) = solid.scale, solid.box
            xs += (left // scale, -(-right // scale))
            ys += (bottom // scale, -(-top // scale))
            if solid.slack:
                slack = max(slack, solid.slack)
        # A nearer turn may be off to the other side.
        room = ceil(self.layout.margin + 2 * slack) + _ROOM
        return min(xs) - room, min(ys) - room, max(xs) + room, max(ys) + room

    def _cut_outside(self, scale: int) -> list[ConvexRing]:
        left, low, right, high = (c * scale for c in self.frame)
        own, ring = self.layout.container.exterior.lattice()
        factor = scale // own
        exterior = [(x * factor, y * factor) for x, y in ring]
        return cut_outside(exterior, (left, low, right, high))  # type: ignore[arg-type]

    @cached_property
    def around(self) -> list[Solid]:
        """The outside of the container in the frame, and each defect."""
        left, low, right, high = self.frame
        container = self.layout.container
        frame = [(left, low), (right, low), (right, high), (left, high)]
        outside = Region(frame, [container.exterior])
        found = []
        for region, cut in (
            (outside, self._cut_outside),
            *((hole, None) for hole in container.holes),
        ):
            scale, form = make_form(Region(region), cut)
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


def _whole(value: Fraction) -> int:
    """A number of a lattice: an int, if the lattice holds it."""
    return value.numerator if value.denominator == 1 else value  # type: ignore[return-value]


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
