"""Positions at which the bounds of a part lie in those of its container: all others are overlapped.

(1) Where the bounds of the part reach beyond those of the container, so do inner points of it, and
    the part overlaps what is outside.
(2) So of a contact segment only what lies in the *leeway* matters, the box of the other positions,
    which is closed, and as wide and high as the container is wider and higher than the part.
"""

from __future__ import annotations

from itertools import chain
from typing import NamedTuple

from exactsweep.geometry.overlap import Rings
from exactsweep.numbers.point import Rational, Vertex


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
    """The leeway of a part in a container. Cost: O(m + n)."""
    around, within = bound(container), bound(part)
    return Leeway(*(a - b for a, b in zip(around, within, strict=True)))


def frame_outside(container: Rings) -> list[list[Vertex]]:
    """The rings of what is outside of a container and in its bounds, the interior on the left.

    A part with its bounds in those of the container can overlap what is outside of it only there.
    """
    left, right, low, high = bound(container)
    return [
        [(left, low), (right, low), (right, high), (left, high)],
        *([*ring[::-1]] for ring in container),
    ]


def bound(rings: Rings) -> tuple[Rational, Rational, Rational, Rational]:
    """The bounds of a shape: left, right, low, high."""
    xs, ys = zip(*chain.from_iterable(rings), strict=True)
    return min(xs), max(xs), min(ys), max(ys)
