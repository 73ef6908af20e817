"""Sums of convex rings, each with each: at first their boxes, and a ring where it is asked for.

There are as many as pairs of pieces, and few of them are ever met.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import pairwise
from math import lcm
from typing import NamedTuple

from exactsweep.check.boxes import Rectangle
from exactsweep.check.cone import cross
from exactsweep.check.size import Budget
from exactsweep.numbers.point import Rational, Vertex

_SUM = 20  # steps to put a sum into its place, where it takes memory, too
_KEPT = 2**16  # rings that are not made again


class ScaledRing(NamedTuple):
    """A convex ring on a lattice of its own: ints, which stand for themselves over a scale."""

    points: tuple[tuple[int, int], ...]
    scale: int
    bits: int  # of the longest coordinate


class _Ways(NamedTuple):
    """A convex ring times a scale, its edges from the lowest vertex on, of two the left one."""

    scale: int
    lowest: tuple[int, int]
    ways: tuple[tuple[int, int], ...]
    extent: tuple[int, int, int, int]


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
        >>> from exactsweep.check.size import UNLIMITED
        >>> sums = ConvexSums([[(0, 0), (1, 0), (0, 1)]], [[(0, 0), (2, 0)]], UNLIMITED)
        >>> sums.boxes, sums.ring(0).points
        ([(0, 3, 0, 1)], ((0, 0), (3, 0), (2, 1), (0, 1)))
    """

    def __init__(
        self,
        first: Iterable[Sequence[Vertex]],
        second: Iterable[Sequence[Vertex]],
        budget: Budget,
    ) -> None:
        ones, others = list(map(_list_ways, first)), list(map(_list_ways, second))
        longest = [max(map(_measure_bits, ways), default=0) for ways in (ones, others)]
        are_ints = all(ways.scale == 1 for ways in (*ones, *others))
        self.bits = 1 + (max(longest) if are_ints else sum(longest))
        budget.take(_SUM * len(ones) * len(others), self.bits)
        # Rings of one form, by its number, at one place are one: many pieces of a comb are.
        forms: dict[object, int] = {}
        one_forms, other_forms = (
            [forms.setdefault((ways.scale, ways.ways), len(forms)) for ways in listed]
            for listed in (ones, others)
        )
        found: dict[tuple[int, ...], tuple[Rectangle, _Ways, _Ways]] = {}
        for one, form in zip(ones, one_forms, strict=True):
            for other, other_form in zip(others, other_forms, strict=True):
                scale = lcm(one.scale, other.scale)
                f, g = scale // one.scale, scale // other.scale
                x, y = (f * c + g * d for c, d in zip(one.lowest, other.lowest, strict=True))
                key = form, other_form, x, y
                if key not in found:
                    left, right, low, high = (
                        f * c + g * d for c, d in zip(one.extent, other.extent, strict=True)
                    )
                    box = left // scale, -(-right // scale), low // scale, -(-high // scale)
                    found[key] = box, one, other
        ordered = sorted(found.values(), key=lambda entry: _measure_width(entry[0]), reverse=True)
        self.boxes = [box for box, _, _ in ordered]
        self._pairs = [(one, other) for _, one, other in ordered]
        self._budget = budget
        self.ring = lru_cache(_KEPT)(self._make_ring)

    def _make_ring(self, k: int) -> ScaledRing:
        """Sum k, made by merging edges by direction."""
        one, other = self._pairs[k]
        self._budget.take(2 * (len(one.ways) + len(other.ways)), self.bits)
        scale = lcm(one.scale, other.scale)
        points = _merge(_stretch(one, scale), _stretch(other, scale))
        bits = max(c.bit_length() for point in points for c in point)
        return ScaledRing(points, scale, max(bits, scale.bit_length()))


def _list_ways(ring: Sequence[Vertex]) -> _Ways:
    scale = lcm(*(c.denominator for p in ring for c in p))
    points = [(int(x * scale), int(y * scale)) for x, y in ring]
    k = min(range(len(points)), key=lambda i: (points[i][1], points[i][0]))
    around = points[k:] + points[: k + 1] if len(points) > 1 else points
    xs, ys = zip(*points, strict=True)
    ways = tuple((c - a, d - b) for (a, b), (c, d) in pairwise(around))
    return _Ways(scale, points[k], ways, (min(xs), max(xs), min(ys), max(ys)))


def _measure_bits(ways: _Ways) -> int:
    return max(c.bit_length() for c in (ways.scale, *ways.extent))


def _measure_width(box: Rectangle) -> Rational:
    left, right, low, high = box
    return right - left + high - low


def _stretch(ring: _Ways, scale: int) -> _Ways:
    """The same ring times another scale, a multiple of its own."""
    factor = scale // ring.scale
    if factor == 1:
        return ring
    x, y = ring.lowest
    ways = tuple((v * factor, w * factor) for v, w in ring.ways)
    return _Ways(scale, (x * factor, y * factor), ways, ring.extent)


def _merge(one: _Ways, other: _Ways) -> tuple[tuple[int, int], ...]:
    """The sum of two rings of one scale."""
    x, y = one.lowest[0] + other.lowest[0], one.lowest[1] + other.lowest[1]
    ways, others = one.ways, other.ways
    found = [(x, y)]
    i = j = 0
    while i < len(ways) or j < len(others):
        turn = 1 if j == len(others) else -1 if i == len(ways) else cross(ways[i], others[j])
        if turn >= 0:
            x, y = x + ways[i][0], y + ways[i][1]
            i += 1
        if turn <= 0:
            x, y = x + others[j][0], y + others[j][1]
            j += 1
        found.append((x, y))
    return tuple(found[:-1])
