"""The parts of segments and points that open convex sets leave, found on one line at a time."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from exactsweep.check.boxes import BoxTree
from exactsweep.check.cone import divide
from exactsweep.check.convex_sums import ConvexSums
from exactsweep.check.standalone import Grid, Node, Ring, Work, edges, grid_box, line, node
from exactsweep.numbers.number import Edge, Rational, Vertex

# Steps to put a segment on its line, and to begin with it.
_SEGMENT = 16

_Unreduced = tuple[int, int]
"""A number by its numerator and its denominator, which is positive; not reduced: to compare two of
them so takes a tenth of the time that it takes with Fractions."""

_Interval = tuple[_Unreduced, _Unreduced]
"""A closed interval."""


def find_axis(line: Node) -> int:
    """The coordinate that tells the points of a line apart."""
    return 0 if line[1] else 1


def find_place(line: Node, along: Rational) -> Vertex:
    """The point of a line with that coordinate."""
    a, b, c = line
    return (along, divide(-a * along - c, b)) if b else (divide(-c, a), along)


class LinePiece(NamedTuple):
    """A part of a line, of positive length; the line leads to the right, or straight up."""

    line: Node
    low: Rational
    high: Rational

    def holds(self, p: Vertex) -> bool:
        """Decide whether a point of the line is on the part."""
        return self.low <= p[find_axis(self.line)] <= self.high

    @property
    def ends(self) -> Edge:
        """Both ends, the lexicographically least first."""
        return find_place(self.line, self.low), find_place(self.line, self.high)

    @property
    def box(self) -> Grid:
        """The box around it, rounded outwards."""
        return grid_box([node(*p) for p in self.ends], 1)


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

    def uncovered(
        self, segments: Iterable[tuple[Node, Node]]
    ) -> tuple[list[LinePiece], set[Vertex]]:
        """Take the union away from segments.

        Args:
            segments: pairs of different points.

        Returns:
            The remainder of their union: pieces, disjoint if they are on one line, and single
            points.

        Cost: for s segments on l lines and k rings of v vertices in all, O(lk + s log s) and
        O(v) for each line at worst; only rings near a line are examined.
        """
        by_line: dict[Node, list[_Interval]] = defaultdict(list)
        for p, q in segments:
            self._budget.take(_SEGMENT)
            (a, b, c), ends = line(p, q), (p, q)
            if (b, -a) < (0, 0):
                (a, b, c), ends = (-a, -b, -c), (q, p)
            low, high = ((p[0], p[2]) if b else (p[1], p[2]) for p in ends)
            by_line[a, b, c].append((low, high))
        pieces, points = [], set()
        for of, found in by_line.items():
            spans = _unite(found)
            self._leave_on(of, spans)
            for low, high in spans:
                start, end = divide(*low), divide(*high)
                if start == end:
                    points.add(find_place(of, start))
                else:
                    pieces.append(LinePiece(of, start, end))
        return pieces, points

    def _leave_on(self, of: Node, spans: list[_Interval]) -> None:
        """Take the union away from closed intervals on a line, the large sets first."""
        a, b, c = of
        axis, bits = find_axis(of), self.bits + max(n.bit_length() for n in of)
        box = _frame(of, spans)
        for k in self._tree.near(box):
            ring = self._sums.ring(k)
            self._budget.take(1 + len(ring) // 4, bits)
            sides = [a * x + b * y + c * w for x, y, w in ring]
            if min(sides) < 0 < max(sides):
                self._budget.take(2 + (len(ring) + len(spans)) // 4, bits)
                spans[:] = _cut_away(spans, *_find_shadow(ring, sides, axis))
                if not spans:
                    break
                box[:] = _frame(of, spans)

    def holds(self, point: Vertex) -> bool:
        """Decide whether a point is in the union."""
        return self._holds_near(point, (0, 0))

    def is_beside(self, line: Node, along: Rational, side: int) -> bool:
        """Decide whether points close to one of the line are in the union.

        Args:
            line: a line.
            along: the coordinate of a point on it, which is not in the union.
            side: 1 for the points straight to the left of the line, -1 for those to the right.
        """
        return self._holds_near(find_place(line, along), (side * line[0], side * line[1]))

    def _holds_near(self, point: Vertex, way: Vertex) -> bool:
        """Decide whether the union has a point, or points close to it in a direction."""
        (x, y, w), (dx, dy) = (p := node(*point)), way
        left, right, low, high = grid_box([p], 1)
        bits = self.bits + w.bit_length()
        # Boxes that meet this one, which is turned inside out, hold the point.
        for k in self._tree.near((right, left, high, low)):
            ring = self._sums.ring(k)
            self._budget.take(1 + len(ring) // 8, bits)
            for e in edges(ring):
                a, b, c = line(*e)
                at = a * x + b * y + c * w
                if at < 0 or (at == 0 and a * dx + b * dy <= 0):
                    break
            else:
                return True
        return False


def _frame(line: Node, spans: Sequence[_Interval]) -> list[int]:
    """The box that open sets have to meet, by more than the border, to meet intervals on a line."""
    a, b, c = line
    (n, d), (m, e) = spans[0][0], spans[-1][1]
    first, last = n // d + 1, -(-m // e) - 1
    if b == 0:
        return [-c // a + 1, -(c // a) - 1, first, last]
    up, down = (-a * n - c * d, b * d), (-a * m - c * e, b * e)
    if a > 0:
        up, down = down, up
    return [first, last, up[0] // up[1] + 1, -(-down[0] // down[1]) - 1]


def _find_shadow(ring: Ring, sides: Sequence[int], axis: int) -> _Interval:
    """The open interval in which the inside of a ring, on both sides of a line, meets it."""
    ends: list[_Unreduced] = []
    before, p = sides[-1], ring[-1]
    for after, q in zip(sides, ring, strict=True):
        if after == 0:
            ends.append((q[axis], q[2]))
        elif before < 0 < after:
            ends.append((p[axis] * after - q[axis] * before, p[2] * after - q[2] * before))
        elif after < 0 < before:
            ends.append((q[axis] * before - p[axis] * after, q[2] * before - p[2] * after))
        before, p = after, q
    low = high = ends[0]
    for end in ends[1:]:
        low, high = (end if _is_least(end, low) else low), (high if _is_least(end, high) else end)
    return low, high


def _is_least(p: _Unreduced, q: _Unreduced) -> bool:
    return p[0] * q[1] <= q[0] * p[1]


def _unite(spans: list[_Interval]) -> list[_Interval]:
    """The union of closed intervals."""
    joined: list[_Interval] = []
    for low, high in sorted(spans, key=lambda span: divide(*span[0])):
        if joined and _is_least(low, joined[-1][1]):
            if _is_least(joined[-1][1], high):
                joined[-1] = joined[-1][0], high
        else:
            joined.append((low, high))
    return joined


def _cut_away(spans: Iterable[_Interval], low: _Unreduced, high: _Unreduced) -> Iterator[_Interval]:
    """Take an open interval away from closed ones, which may be points."""
    for start, end in spans:
        if _is_least(start, low):
            yield start, end if _is_least(end, low) else low
        if _is_least(high, end):
            yield start if _is_least(high, start) else high, end
