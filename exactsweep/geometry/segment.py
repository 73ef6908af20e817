"""Segments with a key for their line, so that a dictionary groups collinear ones.

The key of a line is its primitive integer direction (a, b), with a > 0 or equal to (0, 1), and the
value a * y - b * x.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from exactsweep.geometry.direction import Vector, reduce_direction
from exactsweep.numbers.number import Edge, Rational, Vertex, ratio


class Segment(NamedTuple):
    """The part of a line from low to high in x, or in y if the line is vertical."""

    direction: Vector
    offset: Rational
    low: Rational
    high: Rational

    def minus(self, other: Segment) -> Segment:
        """Return the translations that move some point of a parallel segment to this segment."""
        direction, offset, low, high = other
        return Segment(direction, self.offset - offset, self.low - high, self.high - low)

    def point(self, along: Rational) -> Vertex:
        """Return the point of the line at x, or at y if the line is vertical."""
        (a, b), offset, _, _ = self
        return (along, ratio(offset + b * along, a)) if a else (-offset, along)

    def shares_piece(self, other: Segment) -> bool:
        """Decide whether two collinear segments share a piece of positive length."""
        return self.low < other.high and other.low < self.high


def find_direction(edge: Edge) -> Vector:
    """Return the primitive direction of an edge, regardless of orientation."""
    (px, py), (qx, qy) = edge
    return reduce_direction((qx - px, qy - py))


def lay_point(point: Vertex, direction: Vector) -> Segment:
    """Return a point as a degenerate segment on the line through it in a direction."""
    (a, b), (x, y), along = direction, point, measure_along(direction, point)
    return Segment(direction, ratio(a * y - b * x, 1), along, along)


def make_segment(edge: Edge) -> Segment:
    """Make the segment of an edge."""
    direction = find_direction(edge)
    low, high = sorted(measure_along(direction, end) for end in edge)
    return lay_point(edge[0], direction)._replace(low=low, high=high)


def measure_along(direction: Vector, point: Vertex) -> Rational:
    """Return the coordinate along a line in this direction: x, or y if the line is vertical."""
    return point[0] if direction[0] else point[1]


def choose_cover(whole: Segment, pieces: Iterable[tuple[Segment, int]]) -> list[int] | None:
    """Choose a few collinear pieces that cover a segment; return their indices, or None."""
    pieces = sorted(pieces)
    chosen: list[int] = []
    reached = whole.low
    while reached < whole.high:
        ahead = [(piece.high, k) for piece, k in pieces if piece.low <= reached < piece.high]
        if not ahead:
            return None
        reached, number = max(ahead, key=lambda piece: piece[0])
        chosen.append(number)
    return chosen
