"""What open convex sets leave of segments and points, decided on one line at a time."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from math import ceil, floor, gcd
from typing import NamedTuple

from exactsweep.check.columns import BoxColumns, Rectangle
from exactsweep.check.cone import cross, divide, subtract
from exactsweep.check.shape import LatticeRing, list_edges
from exactsweep.geometry.point import Edge, Rational, Vertex

Interval = tuple[Rational, Rational]


class LatticeLine(NamedTuple):
    """All (x, y) with dx y - dy x = c: a primitive direction to the right, or straight up."""

    dx: int
    dy: int
    c: int

    @property
    def axis(self) -> int:
        """Which coordinate tells the points of the line apart."""
        return 0 if self.dx else 1

    def at(self, along: Rational) -> Vertex:
        """The point with that coordinate."""
        if self.dx:
            return along, divide(self.c + self.dy * along, self.dx)
        return -self.c, along


def find_line(a: Vertex, b: Vertex) -> LatticeLine:
    """The line through two different points with integer coordinates."""
    dx, dy = (int(c) for c in subtract(b, a))
    common = gcd(dx, dy)
    if (dx, dy) < (0, 0):
        common = -common
    dx, dy = dx // common, dy // common
    return LatticeLine(dx, dy, int(dx * a[1] - dy * a[0]))


class LinePiece(NamedTuple):
    """A part of a line, of positive length."""

    line: LatticeLine
    low: Rational
    high: Rational

    @property
    def ends(self) -> Edge:
        """Both ends, the lexicographically least first."""
        return self.line.at(self.low), self.line.at(self.high)


class _Reach(NamedTuple):
    """How far an open set reaches to the left of a direction."""

    low: Rational
    high: Rational
    values: Sequence[Rational]


class OpenSets:
    """The union of the interiors of convex rings with integer vertices."""

    def __init__(self, rings: Iterable[LatticeRing]) -> None:
        # Large sets first: few of them cover most of what is covered.
        boxed = [(_find_bounds(ring), ring) for ring in dict.fromkeys(rings)]
        boxed.sort(key=lambda pair: _measure_width(pair[0]), reverse=True)
        self._rings = [ring for _, ring in boxed]
        self._boxes = [box for box, _ in boxed]
        self._columns = BoxColumns(self._boxes)
        # By the direction of a line and the number of the set.
        self._reaches: dict[tuple[int, int], dict[int, _Reach]] = defaultdict(dict)

    def uncovered(self, segments: Iterable[Edge]) -> tuple[list[LinePiece], set[Vertex]]:
        """Take the union away from segments.

        Args:
            segments: pairs of different points with integer coordinates.

        Returns:
            What is left of all of them together: pieces, of which those on one line are apart from
            each other, and single points.

        Cost: for s segments on l lines and k rings of v vertices in all, O(lk + s log s) and
        O(v) for each line at worst; of the rings those near a line are looked at.
        """
        by_line: dict[LatticeLine, list[Interval]] = defaultdict(list)
        for a, b in segments:
            line = find_line(a, b)
            low, high = sorted((a[line.axis], b[line.axis]))
            by_line[line].append((low, high))
        pieces, points = [], set()
        for line, spans in by_line.items():
            for low, high in self._left_on(line, _unite(spans)):
                if low < high:
                    pieces.append(LinePiece(line, low, high))
                else:
                    points.add(line.at(low))
        return pieces, points

    def _left_on(self, line: LatticeLine, spans: list[Interval]) -> list[Interval]:
        """Take the union away from closed intervals on a line, the large sets first."""
        axis = line.axis
        reaches = self._reaches[line[:2]]
        ends = line.at(spans[0][0]), line.at(spans[-1][1])
        # Rounded outwards to ints, which are quicker to compare.
        bottom, top = floor(min(y for _, y in ends)), ceil(max(y for _, y in ends))
        first, last = floor(spans[0][0]), ceil(spans[-1][1])
        for k in self._columns.near(ends[0][0], ends[1][0]):
            box = self._boxes[k]
            if box[2 * axis] >= last or box[2 * axis + 1] <= first:
                continue
            if box[2] > top or box[3] < bottom:
                continue
            if k not in reaches:
                reaches[k] = _measure_reach(self._rings[k], line)
            reach = reaches[k]
            if not reach.low < line.c < reach.high:
                continue
            low, high = _find_shadow(self._rings[k], reach.values, line)
            spans = [part for span in spans for part in _cut_away(span, low, high)]
            if not spans:
                break
            first, last = floor(spans[0][0]), ceil(spans[-1][1])
        return spans

    def holds(self, point: Vertex) -> bool:
        """Whether a point is in the union."""
        return self._holds_near(point, None)

    def is_beside(self, line: LatticeLine, along: Rational, side: int) -> bool:
        """Whether points close to one of the line are in the union.

        Args:
            line: a line.
            along: the coordinate of a point on it, which is not in the union.
            side: 1 for the points straight to the left of the line, -1 for those to the right.
        """
        return self._holds_near(line.at(along), (-side * line.dy, side * line.dx))

    def _holds_near(self, point: Vertex, way: Vertex | None) -> bool:
        """Whether the union has a point, or points close to it in a direction."""
        # Homogeneous: only ints below.
        (x, y), w = point, point[0].denominator * point[1].denominator
        px, py = int(x * w), int(y * w)
        left, bottom = floor(x), floor(y)
        right, top = ceil(x), ceil(y)
        for k in self._columns.near(left, right):
            box = self._boxes[k]
            if box[0] > left or box[1] < right or box[2] > bottom or box[3] < top:
                continue
            for (ax, ay), (bx, by) in list_edges([self._rings[k]]):
                dx, dy = bx - ax, by - ay
                side = dx * (py - ay * w) - dy * (px - ax * w)
                if side < 0 or (side == 0 and (way is None or cross((dx, dy), way) <= 0)):
                    break
            else:
                return True
        return False


def _measure_reach(ring: LatticeRing, line: LatticeLine) -> _Reach:
    values = [line.dx * y - line.dy * x for x, y in ring]
    return _Reach(min(values), max(values), values)


def _find_bounds(ring: LatticeRing) -> Rectangle:
    xs, ys = zip(*ring, strict=True)
    return min(xs), max(xs), min(ys), max(ys)


def _measure_width(box: Rectangle) -> Rational:
    return box[1] - box[0] + box[3] - box[2]


def _find_shadow(ring: LatticeRing, values: Sequence[Rational], line: LatticeLine) -> Interval:
    """The open interval in which the inside of a ring, on both sides of a line, meets it."""
    axis = line.axis
    ends: list[Rational] = []
    before, p = values[-1] - line.c, ring[-1]
    for value, q in zip(values, ring, strict=True):
        after = value - line.c
        if after == 0:
            ends.append(q[axis])
        elif before and (before > 0) != (after > 0):
            ends.append(divide(p[axis] * after - q[axis] * before, after - before))
        before, p = after, q
    return min(ends), max(ends)


def _unite(spans: Iterable[Interval]) -> list[Interval]:
    """The union of closed intervals."""
    joined: list[Interval] = []
    for low, high in sorted(spans):
        if joined and low <= joined[-1][1]:
            joined[-1] = joined[-1][0], max(high, joined[-1][1])
        else:
            joined.append((low, high))
    return joined


def _cut_away(span: Interval, low: Rational, high: Rational) -> Iterator[Interval]:
    """What an open interval leaves of a closed one, which may be a point."""
    start, end = span
    if high <= start or end <= low:
        yield span
        return
    if start <= low:
        yield start, low
    if high <= end:
        yield high, end
