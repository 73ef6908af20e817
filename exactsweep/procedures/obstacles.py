"""Several shapes that a part must not overlap: the outside of a container, and placed shapes.

The positions of overlap are the union of the open sets O_k = int D_k + int I(G), one for each shape
D_k. (1) to (6) of `contact_lines` and `free_positions` hold for such a union:

(1) A boundary point of the union is one of some O_k, so it lies on a contact segment of D_k.
(2) Left of a contact segment of D_k lies O_k, and so the union.
(3) to (5) follow from (1) and (2).
(6) Around a single free position, open sectors of the O_k cover all directions. A sector starts
    along a contact segment that leaves the position, or against one that ends there, with the
    sector on its left. Two lines that do not both have segments in both directions give too few
    starts: the direction between the ends of the other sectors would need a sector that starts
    before it.

This also holds for shapes that touch or overlap each other. Where rings of the union touch in a
point, `free_positions` separates them.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from math import ceil, floor

from exactsweep.geometry.overlap import Overlap, Rings
from exactsweep.numbers.number import Point
from exactsweep.procedures.leeway import bound


class Obstacles:
    """A test whether a part overlaps the outside of a container or a placed shape.

    Args:
        outside: the outside of the container, as its rings clockwise and those of its defects.
        placed: the rings of each placed shape.
        part: the rings of the part.
    """

    def __init__(self, outside: Rings, placed: Sequence[Rings], part: Rings) -> None:
        left, right, low, high = bound(part)
        # For each placed shape, bounds of the positions at which the part can meet it.
        self._near = [
            (west - right, east - left, south - high, north - low)
            for west, east, south, north in map(bound, placed)
        ]
        self._outside = Overlap(outside, part, unbounded=True)
        self._of_placed = cache(lambda k: Overlap(placed[k], part))
        # The shape that overlapped last is likely to do so again.
        self._last = 0

    def at(self, t: Point) -> bool:
        """Decide whether the part at a position overlaps any of the shapes.

        Cost: O(k) for k placed shapes, and that of `Overlap.at` for each shape nearby.
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
