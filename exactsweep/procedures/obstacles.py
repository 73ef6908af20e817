"""Several shapes that a part must not overlap: the outside of a container, and placed shapes.

The positions of overlap are the union of the open sets O_k = int D_k + int I(G), one for each shape
D_k. (1) to (6) of `contact_lines` and `free_positions` hold for such a union:

(1) A boundary point of the union is one of some O_k, so it lies on a contact segment of D_k.
(2) Left of a contact segment of D_k lies O_k, and so the union.
(3) to (5) follow from (1) and (2).
(6) Where a single position is free, open sectors of the O_k cover all directions around it. A
    sector starts along a contact segment that leaves the position, or against one that ends there,
    with the sector on its left. Two lines, of which not both have segments both ways, have too few
    such rays: a sector over the direction between the ends of the others would have to start
    before them.

Shapes that touch or overlap each other are no exception. Where rings of the union touch in a point,
`free_positions` parts them.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from math import ceil, floor

from exactsweep.geometry.overlap import Overlap, Rings
from exactsweep.numbers.point import Point
from exactsweep.procedures.leeway import bound


class Obstacles:
    """The question whether a part overlaps the outside of a container, or a placed shape.

    Args:
        outside: the rings of the container, clockwise, and of its defects: what they leave.
        placed: the rings of each placed shape.
        part: the rings of the part.
    """

    def __init__(self, outside: Rings, placed: Sequence[Rings], part: Rings) -> None:
        left, right, low, high = bound(part)
        # The bounds of positions at which the part can meet each placed shape.
        self._near = [
            (west - right, east - left, south - high, north - low)
            for west, east, south, north in map(bound, placed)
        ]
        self._outside = Overlap(outside, part, unbounded=True)
        self._of_placed = cache(lambda k: Overlap(placed[k], part))
        # The one that overlapped last is likely to do so again.
        self._last = 0

    def at(self, t: Point) -> bool:
        """Decide whether the part overlaps any of them at a position.

        Cost: O(k) for k placed shapes, and a question of `Overlap` for each one that is near.
        """
        low_x, high_x, low_y, high_y = floor(t.x), ceil(t.x), floor(t.y), ceil(t.y)
        near = [
            k
            for k, (left, right, low, high) in enumerate(self._near)
            if left < high_x and low_x < right and low < high_y and low_y < high
        ]
        if self._last in near and self._of_placed(self._last).at(t):
            return True
        if self._outside.at(t):
            return True
        for k in near:
            if k != self._last and self._of_placed(k).at(t):
                self._last = k
                return True
        return False
