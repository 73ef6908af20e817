"""Sums of convex rings, each with each: at first their boxes, and a ring where it is asked for.

There are as many as pairs of pieces, and few of them are ever met.
"""

from __future__ import annotations

import operator
from collections.abc import Iterable, Sequence
from functools import lru_cache

from exactsweep.check.boxes import Rectangle
from exactsweep.check.standalone import (
    Node,
    Ring,
    Work,
    add,
    add_convex,
    from_lowest,
    grid_box,
    node,
    reduce,
)
from exactsweep.numbers.number import Rational, Vertex

_SUM = 20  # steps to put a sum into its place, where it takes memory, too
_KEPT = 2**16  # rings that are not made again


class ConvexSums:
    """The different sums of each of some convex rings with each of others, large ones first.

    Args:
        first: counter-clockwise; one of two vertices is a segment, one of one a point.
        second: likewise.
        budget: the steps that they may take.

    Attributes:
        boxes: around the sums, of ints, rounded outwards.
        bits: of the longest coordinate, or more.

    Cost: for k pairs O(k log k), and linear for each ring that is asked for.

    Example:
        >>> from exactsweep.check.no_fit import UNLIMITED
        >>> sums = ConvexSums([[(0, 0), (1, 0), (0, 1)]], [[(0, 0), (2, 0)]], UNLIMITED)
        >>> sums.boxes, sums.ring(0)
        ([(0, 3, 0, 1)], [(0, 0, 1), (3, 0, 1), (2, 1, 1), (0, 1, 1)])
    """

    def __init__(
        self,
        first: Iterable[Sequence[Vertex]],
        second: Iterable[Sequence[Vertex]],
        budget: Work,
    ) -> None:
        ones, others = ([*map(_enter, rings)] for rings in (first, second))
        longest = [
            max((_measure_bits(ring) for ring in rings), default=0) for rings in (ones, others)
        ]
        are_ints = all(w == 1 for ring in (*ones, *others) for _, _, w in ring)
        self.bits = 1 + (max(longest) if are_ints else sum(longest))
        budget.take(_SUM * len(ones) * len(others), self.bits)
        # Rings of one form, by its number, at one place are one: many pieces of a comb are.
        forms: dict[object, int] = {}
        one_forms, other_forms = (
            [
                (ring, forms.setdefault(_move_to_origin(ring), len(forms)), grid_box(ring, 1))
                for ring in rings
            ]
            for rings in (ones, others)
        )
        found: dict[object, tuple[Rectangle, Ring, Ring]] = {}
        for one, form, around in one_forms:
            for other, other_form, beside in other_forms:
                key = form, other_form, reduce(*add(one[0], other[0]))
                if key not in found:
                    left, right, low, high = map(operator.add, around, beside)
                    found[key] = (left, right, low, high), one, other
        ordered = sorted(found.values(), key=lambda entry: _measure_width(entry[0]), reverse=True)
        self.boxes = [box for box, _, _ in ordered]
        self._pairs = [(one, other) for _, one, other in ordered]
        self._budget = budget
        self.ring = lru_cache(_KEPT)(self._make_ring)

    def _make_ring(self, k: int) -> Ring:
        """Sum k."""
        one, other = self._pairs[k]
        self._budget.take(2 * (len(one) + len(other)), self.bits)
        return add_convex(one, other)


def _enter(ring: Sequence[Vertex]) -> Ring:
    """A ring of nodes, from its lowest vertex on."""
    return from_lowest([node(*p) for p in ring])


def _move_to_origin(ring: Ring) -> tuple[Node, ...]:
    x0, y0, w0 = ring[0]
    return tuple(reduce(*add(p, (-x0, -y0, w0))) for p in ring)


def _measure_bits(ring: Ring) -> int:
    return max(c.bit_length() for p in ring for c in p)


def _measure_width(box: Rectangle) -> Rational:
    left, right, low, high = box
    return right - left + high - low
