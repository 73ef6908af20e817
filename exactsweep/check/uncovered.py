"""The parts of segments and points that open convex sets leave, found on one line at a time."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from math import ceil, floor, lcm
from typing import NamedTuple

from exactsweep.check.boxes import BoxTree
from exactsweep.check.cone import cross, divide, reduce_way, subtract
from exactsweep.check.convex_sums import ConvexSums
from exactsweep.check.shape import list_edges
from exactsweep.check.standalone import Work
from exactsweep.numbers.number import Edge, Rational, Vertex

# Steps to put a segment on its line, and to begin with it.
_SEGMENT = 16

Interval = tuple[Rational, Rational]

_Unreduced = tuple[int, int]
"""A number by its numerator and its denominator, which is positive; not reduced: to compare two of
them so takes a tenth of the time that it takes with Fractions."""

_Remnant = tuple[_Unreduced, _Unreduced]
"""A closed interval."""


class LatticeLine(NamedTuple):
    """All (x, y) with dx y - dy x = c: a primitive direction to the right, or straight up."""

    dx: int
    dy: int
    c: Rational

    @property
    def axis(self) -> int:
        """The coordinate that tells the points of the line apart."""
        return 0 if self.dx else 1

    def at(self, along: Rational) -> Vertex:
        """The point with that coordinate."""
        if self.dx:
            return along, divide(self.c + self.dy * along, self.dx)
        return -self.c, along


def find_line(a: Vertex, b: Vertex) -> LatticeLine:
    """The line through two different points."""
    dx, dy = reduce_way(subtract(b, a))
    if (dx, dy) < (0, 0):
        dx, dy = -dx, -dy
    return LatticeLine(dx, dy, divide(dx * a[1] - dy * a[0], 1))


class LinePiece(NamedTuple):
    """A part of a line, of positive length."""

    line: LatticeLine
    low: Rational
    high: Rational

    def holds(self, p: Vertex) -> bool:
        """Decide whether a point of the line is on the part."""
        return self.low <= p[self.line.axis] <= self.high

    @property
    def ends(self) -> Edge:
        """Both ends, the lexicographically least first."""
        return self.line.at(self.low), self.line.at(self.high)

    @property
    def box(self) -> tuple[int, int, int, int]:
        """The box around it, rounded outwards."""
        return _frame(self.line, [(self.low.as_integer_ratio(), self.high.as_integer_ratio())])


_Heights = tuple[int, int, list[int]]
"""Distances of the vertices of a ring to the left of a direction, behind the least and greatest."""


class OpenSets:
    """The union of the interiors of the sums of convex rings, each with each.

    Args:
        first: rings, counter-clockwise; one of two vertices is a segment, one of one a point.
        second: likewise.
        budget: what all that is asked may take.

    Attributes:
        bits: of the longest coordinate, or more.
    """

    def __init__(
        self,
        first: Iterable[Sequence[Vertex]],
        second: Iterable[Sequence[Vertex]],
        budget: Work,
    ) -> None:
        # Large sets first: few of them cover most of the union.
        self._sums = ConvexSums(first, second, budget)
        self._tree = BoxTree(self._sums.boxes, budget)
        self._budget = budget
        self.bits = self._sums.bits

    def uncovered(self, segments: Iterable[Edge]) -> tuple[list[LinePiece], set[Vertex]]:
        """Take the union away from segments.

        Args:
            segments: pairs of different points.

        Returns:
            The remainder of their union: pieces, disjoint if they are on one line, and single
            points.

        Cost: for s segments on l lines and k rings of v vertices in all, O(lk + s log s) and
        O(v) for each line at worst; only rings near a line are examined.
        """
        by_line: dict[LatticeLine, list[Interval]] = defaultdict(list)
        for a, b in segments:
            self._budget.take(_SEGMENT)
            line = find_line(a, b)
            low, high = sorted((a[line.axis], b[line.axis]))
            by_line[line].append((low, high))
        # Lines of one direction come together, and data on the sets for that direction are dropped
        # after them: data for all directions would need memory for all edges times all sets.
        lines = sorted(by_line, key=lambda line: line[:2])
        spans: dict[LatticeLine, list[_Remnant]] = {
            line: [
                (low.as_integer_ratio(), high.as_integer_ratio())
                for low, high in _unite(by_line[line])
            ]
            for line in lines
        }
        pieces, points = [], set()
        way = None
        for line in lines:
            if line[:2] != way:
                way = line[:2]
                heights: dict[int, _Heights] = {}
            self._leave_on(line, spans[line], heights)
            for span in spans[line]:
                start, end = (divide(*ratio) for ratio in span)
                if start == end:
                    points.add(line.at(start))
                else:
                    pieces.append(LinePiece(line, start, end))
        return pieces, points

    def _leave_on(
        self,
        line: LatticeLine,
        spans: list[_Remnant],
        heights: dict[int, _Heights],
    ) -> None:
        """Take the union away from closed intervals on a line, the large sets first."""
        axis, (n, d) = line.axis, line.c.as_integer_ratio()
        bits = max(c.bit_length() for c in (line.dx, line.dy, n, d))
        frame = _frame(line, spans)
        for k in self._tree.near(frame):
            box = self._sums.boxes[k]
            if box[0] >= frame[1] or box[1] <= frame[0]:
                continue
            if box[2] >= frame[3] or box[3] <= frame[2]:
                continue
            ring, scale, length = self._sums.ring(k)
            if k not in heights:
                self._budget.take(1 + len(ring) // 4, length + bits)
                heights[k] = _measure_heights(ring, line)
            low, high, values = heights[k]
            level = n * scale
            if not low * d < level < high * d:
                continue
            self._budget.take(3 + (len(ring) + len(spans)) // 4, length + bits)
            shadow = _find_shadow(ring, scale, [d * value - level for value in values], axis)
            spans[:] = _cut_away(spans, *shadow)
            if not spans:
                break
            frame = _frame(line, spans)

    def holds(self, point: Vertex) -> bool:
        """Decide whether a point is in the union."""
        return self._holds_near(point, None)

    def is_beside(self, line: LatticeLine, along: Rational, side: int) -> bool:
        """Decide whether points close to one of the line are in the union.

        Args:
            line: a line.
            along: the coordinate of a point on it, which is not in the union.
            side: 1 for the points straight to the left of the line, -1 for those to the right.
        """
        return self._holds_near(line.at(along), (-side * line.dy, side * line.dx))

    def _holds_near(self, point: Vertex, way: Vertex | None) -> bool:
        """Decide whether the union has a point, or points close to it in a direction."""
        # Homogeneous: only ints below.
        (x, y), w = point, lcm(point[0].denominator, point[1].denominator)
        px, py = int(x * w), int(y * w)
        left, bottom = floor(x), floor(y)
        right, top = ceil(x), ceil(y)
        # Boxes that meet this one, which is turned inside out, hold the point.
        for k in self._tree.near((right, left, top, bottom)):
            ring, scale, length = self._sums.ring(k)
            self._budget.take(1 + len(ring) // 8, length + w.bit_length())
            qx, qy = px * scale, py * scale
            for (ax, ay), (bx, by) in list_edges([ring]):
                dx, dy = bx - ax, by - ay
                side = dx * (qy - ay * w) - dy * (qx - ax * w)
                if side < 0 or (side == 0 and (way is None or cross((dx, dy), way) <= 0)):
                    break
            else:
                return True
        return False


def _measure_heights(ring: Iterable[tuple[int, int]], line: LatticeLine) -> _Heights:
    values = [line.dx * y - line.dy * x for x, y in ring]
    return min(values), max(values), values


def _frame(line: LatticeLine, spans: Sequence[_Remnant]) -> tuple[int, int, int, int]:
    """The box around intervals on a line, rounded outwards."""
    (n, d), (m, e) = spans[0][0], spans[-1][1]
    first, last = n // d, -(-m // e)
    (dx, dy, _), (c, w) = line, line.c.as_integer_ratio()
    if dx == 0:
        return -c // w, -(c // w), first, last
    low, high = sorted(c + dy * w * along for along in (first, last))
    return first, last, low // (dx * w), -(-high // (dx * w))


def _find_shadow(
    ring: Sequence[tuple[int, int]], scale: int, heights: Sequence[int], axis: int
) -> _Remnant:
    """The open interval in which the inside of a ring, on both sides of a line, meets it.

    Args:
        ring: times the scale.
        scale: of the ring.
        heights: of its vertices above the line, in any unit.
        axis: the coordinate that tells points of the line apart.
    """
    ends: list[_Unreduced] = []
    before, p = heights[-1], ring[-1]
    for after, q in zip(heights, ring, strict=True):
        if after == 0:
            ends.append((q[axis], scale))
        elif before < 0 < after:
            ends.append((p[axis] * after - q[axis] * before, (after - before) * scale))
        elif after < 0 < before:
            ends.append((q[axis] * before - p[axis] * after, (before - after) * scale))
        before, p = after, q
    low = high = ends[0]
    for end in ends[1:]:
        low, high = (end if _is_least(end, low) else low), (high if _is_least(end, high) else end)
    return low, high


def _is_least(p: _Unreduced, q: _Unreduced) -> bool:
    return p[0] * q[1] <= q[0] * p[1]


def _unite(spans: Iterable[Interval]) -> list[Interval]:
    """The union of closed intervals."""
    joined: list[Interval] = []
    for low, high in sorted(spans):
        if joined and low <= joined[-1][1]:
            joined[-1] = joined[-1][0], max(high, joined[-1][1])
        else:
            joined.append((low, high))
    return joined


def _cut_away(spans: Iterable[_Remnant], low: _Unreduced, high: _Unreduced) -> Iterator[_Remnant]:
    """Take an open interval away from closed ones, which may be points."""
    for start, end in spans:
        if _is_least(start, low):
            yield start, end if _is_least(end, low) else low
        if _is_least(high, end):
            yield start if _is_least(high, start) else high, end
