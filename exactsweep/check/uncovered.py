"""What open convex sets leave of segments and points, decided on one line at a time."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import gcd
from typing import NamedTuple

from exactsweep.check.cone import Pair, cross, minus
from exactsweep.check.shape import Ring, edges_of
from exactsweep.geometry.point import Rational

Segment = tuple[Pair, Pair]
Span = tuple[Rational, Rational]


class Line(NamedTuple):
    """All (x, y) with dx y - dy x = c: a primitive direction to the right, or straight up."""

    dx: int
    dy: int
    c: int

    @property
    def axis(self) -> int:
        """Which coordinate tells the points of the line apart."""
        return 0 if self.dx else 1

    def at(self, along: Rational) -> Pair:
        """The point with that coordinate."""
        if self.dx:
            return along, Fraction(self.c + self.dy * along) / self.dx
        return -self.c, along


def line_through(a: Pair, b: Pair) -> Line:
    """The line through two different points with integer coordinates."""
    dx, dy = (int(c) for c in minus(b, a))
    common = gcd(dx, dy)
    if (dx, dy) < (0, 0):
        common = -common
    dx, dy = dx // common, dy // common
    return Line(dx, dy, int(dx * a[1] - dy * a[0]))


class Piece(NamedTuple):
    """A part of a line, of positive length."""

    line: Line
    low: Rational
    high: Rational

    @property
    def ends(self) -> Segment:
        """Both ends, the lexicographically least first."""
        return self.line.at(self.low), self.line.at(self.high)


class _Reach(NamedTuple):
    """How far an open set reaches to the left of a direction."""

    low: Rational
    high: Rational
    values: Sequence[Rational]


class OpenSets:
    """The union of the interiors of convex rings with integer vertices."""

    def __init__(self, rings: Iterable[Ring]) -> None:
        self._rings = list(dict.fromkeys(rings))
        self._boxes = [
            (min(xs), max(xs), min(ys), max(ys))
            for xs, ys in (zip(*ring, strict=True) for ring in self._rings)
        ]
        self._reaches: dict[tuple[int, int], list[_Reach]] = {}

    def uncovered(self, segments: Iterable[Segment]) -> tuple[list[Piece], set[Pair]]:
        """Take the union away from segments.

        Args:
            segments: pairs of different points with integer coordinates.

        Returns:
            What is left of all of them together: pieces, of which those on one line are apart from
            each other, and single points.

        Cost: for s segments on l lines and k rings of v vertices in all, O(lk + s log s) and
        O(v) for each line at worst.
        """
        by_line: dict[Line, list[Span]] = defaultdict(list)
        for a, b in segments:
            line = line_through(a, b)
            low, high = sorted((a[line.axis], b[line.axis]))
            by_line[line].append((low, high))
        pieces, points = [], set()
        for line, spans in by_line.items():
            closed = _joined(spans)
            shadows = sorted(self._shadows(line, closed[0][0], closed[-1][1]))
            for low, high in _without(closed, shadows):
                if low < high:
                    pieces.append(Piece(line, low, high))
                else:
                    points.add(line.at(low))
        return pieces, points

    def holds(self, point: Pair) -> bool:
        """Whether a point is in the union."""
        return self._holds_near(point, None, range(len(self._rings)))

    def is_beside(self, line: Line, along: Rational, side: int) -> bool:
        """Whether points close to one of the line are in the union.

        Args:
            line: a line.
            along: the coordinate of a point on it, which is not in the union.
            side: 1 for the points straight to the left of the line, -1 for those to the right.
        """
        near = [k for k, r in enumerate(self._along(line)) if r.low <= line.c <= r.high]
        way = (-side * line.dy, side * line.dx)
        return self._holds_near(line.at(along), way, near)

    def _holds_near(self, point: Pair, way: Pair | None, numbers: Iterable[int]) -> bool:
        """Whether the union has a point, or points close to it in a direction."""
        # Homogeneous: only ints below.
        (x, y), w = point, Fraction(point[0]).denominator * Fraction(point[1]).denominator
        px, py = int(x * w), int(y * w)
        for k in numbers:
            x_low, x_high, y_low, y_high = self._boxes[k]
            if not (x_low * w <= px <= x_high * w and y_low * w <= py <= y_high * w):
                continue
            for (ax, ay), (bx, by) in edges_of([self._rings[k]]):
                dx, dy = bx - ax, by - ay
                side = dx * (py - ay * w) - dy * (px - ax * w)
                if side < 0 or (side == 0 and (way is None or cross((dx, dy), way) <= 0)):
                    break
            else:
                return True
        return False

    def _along(self, line: Line) -> list[_Reach]:
        direction = line[:2]
        if direction not in self._reaches:
            dx, dy = direction
            found = []
            for ring in self._rings:
                values = [dx * y - dy * x for x, y in ring]
                found.append(_Reach(min(values), max(values), values))
            self._reaches[direction] = found
        return self._reaches[direction]

    def _shadows(self, line: Line, first: Rational, last: Rational) -> Iterable[Span]:
        """The open intervals in which the sets meet a line, those beyond a range left out."""
        c, axis = line.c, line.axis
        for ring, box, reach in zip(self._rings, self._boxes, self._along(line), strict=True):
            if not reach.low < c < reach.high:
                continue
            if box[2 * axis] >= last or box[2 * axis + 1] <= first:
                continue
            ends: list[Rational] = []
            before, p = reach.values[-1] - c, ring[-1]
            for value, q in zip(reach.values, ring, strict=True):
                after = value - c
                if after == 0:
                    ends.append(q[axis])
                elif before and (before > 0) != (after > 0):
                    share = Fraction(p[axis] * after - q[axis] * before)
                    ends.append(share / (after - before))
                before, p = after, q
            yield min(ends), max(ends)


def _joined(spans: Iterable[Span]) -> list[Span]:
    """The union of closed intervals."""
    joined: list[Span] = []
    for low, high in sorted(spans):
        if joined and low <= joined[-1][1]:
            joined[-1] = joined[-1][0], max(high, joined[-1][1])
        else:
            joined.append((low, high))
    return joined


def _without(closed: Iterable[Span], opened: Sequence[Span]) -> Iterable[Span]:
    """What sorted open intervals leave of closed ones: closed intervals, and points."""
    for start, end in closed:
        # Invariant: what is before `start` is decided, and `start` is in no interval seen so far.
        for low, high in opened:
            if low >= end:
                break
            if high > start:
                if low >= start:
                    yield start, low
                start = high
        if start <= end:
            yield start, end
