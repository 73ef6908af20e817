"""The leeway: the positions at which the bounds of a part lie in the bounds of its container.

(1) If the bounds of the part reach beyond those of the container, so do inner points of the part,
    and the part overlaps the outside.
(2) So only the pieces of contact segments in the leeway are relevant. It is a closed box. Its width
    is the width of the container minus that of the part, and its height likewise.
"""

from __future__ import annotations

from itertools import chain
from operator import sub
from typing import NamedTuple

from exactsweep.geometry.overlap import Rings
from exactsweep.numbers.number import Rational, Vertex


class Leeway(NamedTuple):
    """The positions of a part within the bounds of its container, as ranges of x and of y."""

    left: Rational
    right: Rational
    low: Rational
    high: Rational

    @property
    def is_empty(self) -> bool:
        """Decide whether the part is too long or too high."""
        return self.right < self.left or self.high < self.low


def find_leeway(container: Rings, part: Rings) -> Leeway:
    """Find the leeway of a part in a container. Cost: O(m + n)."""
    around, within = bound(container), bound(part)
    return Leeway(*map(sub, around, within))


def frame_outside(container: Rings) -> list[list[Vertex]]:
    """Return the rings of the outside of a container within its bounds, interior on the left.

    A part whose bounds lie in those of the container can overlap the outside only there.
    """
    left, right, low, high = bound(container)
    return [
        [(left, low), (right, low), (right, high), (left, high)],
        *([*ring[::-1]] for ring in container),
    ]


def bound(rings: Rings) -> tuple[Rational, Rational, Rational, Rational]:
    """Return the bounds of a shape: left, right, low, high."""
    xs, ys = zip(*chain.from_iterable(rings), strict=True)
    return min(xs), max(xs), min(ys), max(ys)
