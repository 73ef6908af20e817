"""Open Minkowski sums of convex pieces, and what they cover of a segment.

Points are homogeneous: (x, y, w) is (x/w, y/w), w > 0. A line (a, b, c) has the points with
a x + b y + c w > 0 on its left. Parameters along a segment run from 0 to 1.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import gcd
from typing import Any, NamedTuple

Node = tuple[int, int, int]
Line = tuple[int, int, int]
Box = tuple[int, int, int, int]
"""Left, right, low and high end in cells of a grid, rounded outwards."""
Interval = tuple[Fraction, Fraction]

_CELLS = 1 << 30


class Side(NamedTuple):
    """An edge with its direction and its line."""

    start: Node
    end: Node
    direction: tuple[int, int]
    line: Line


def make_side(p: Node, q: Node) -> Side:
    """Return the edge from one point to another."""
    (x, y, w), (u, v, z) = p, q
    dx, dy = u * w - x * z, v * w - y * z
    common = gcd(dx, dy) or 1
    return _side(p, q, (dx // common, dy // common))


def _side(p: Node, q: Node, direction: tuple[int, int]) -> Side:
    (x, y, w), (dx, dy) = p, direction
    level = dy * x - dx * y
    common = gcd(level, w)
    w //= common
    return Side(p, q, direction, (-dy * w, dx * w, level // common))


def make_node(x: Fraction | int, y: Fraction | int) -> Node:
    """Return a point in homogeneous coordinates."""
    (n, d), (m, e) = x.as_integer_ratio(), y.as_integer_ratio()
    w = d // gcd(d, e) * e
    return n * (w // d), m * (w // e), w


def between(p: Node, q: Node, parameter: Fraction) -> Node:
    """Return the point of a segment at a parameter."""
    (x, y, w), (u, v, z), (n, d) = p, q, parameter.as_integer_ratio()
    s, t = (d - n) * z, n * w
    common = gcd(x * s + u * t, y * s + v * t, d * w * z)
    return (x * s + u * t) // common, (y * s + v * t) // common, d * w * z // common


class Grid:
    """A grid of cells around points, on which boxes are ints."""

    def __init__(self, points: Sequence[Node]) -> None:
        xs, ys = [x // w for x, _, w in points], [y // w for _, y, w in points]
        self._size = max(max(xs) - min(xs), max(ys) - min(ys)) + 1

    def box(self, points: Sequence[Node]) -> Box:
        """Return the box of points."""
        size = self._size
        xs = [x * _CELLS // (w * size) for x, _, w in points]
        ys = [y * _CELLS // (w * size) for _, y, w in points]
        return min(xs), max(xs) + 1, min(ys), max(ys) + 1


class Tree(NamedTuple):
    """Boxes in a tree: the box of all, its half perimeter, and two trees or a number."""

    box: Box
    size: int
    item: Any


def grow(boxes: Sequence[tuple[Box, int]]) -> Tree:
    """Put numbered boxes in a tree, halving the list along its longer axis."""
    if len(boxes) == 1:
        return Tree(boxes[0][0], -1, boxes[0][1])
    lefts, rights, lows, highs = zip(*(box for box, _ in boxes), strict=True)
    left, right, low, high = box = min(lefts), max(rights), min(lows), max(highs)
    axis = 0 if right - left > high - low else 2
    ordered = sorted(boxes, key=lambda entry: entry[0][axis] + entry[0][axis + 1])
    half = len(boxes) // 2
    return Tree(box, right - left + high - low, (grow(ordered[:half]), grow(ordered[half:])))


def find_touching(one: Tree, other: Tree, third: Tree) -> Iterator[tuple[int, int, int]]:
    """Find the items of three trees such that the first box meets the sum of the others."""
    stack = [(one, other, third)]
    while stack:
        trees = stack.pop()
        ((left, right, low, high), k, _), ((a, b, c, d), m, _), ((e, f, g, h), n, _) = trees
        if left > b + f or right < a + e or low > d + h or high < c + g:
            continue
        one, other, third = trees
        if k >= m and k >= n:
            if k < 0:
                yield one.item, other.item, third.item
            else:
                stack += [(half, other, third) for half in one.item]
        elif m >= n:
            stack += [(one, half, third) for half in other.item]
        else:
            stack += [(one, other, half) for half in third.item]


class Sums:
    """The open sums of convex pieces of two shapes, numbered through.

    Sum i n + j is that of piece i of the first shape and piece j of the second one, which has n.

    Args:
        first: convex rings, counter-clockwise, or segments.
        second: convex rings with w = 1.
        grid: a grid.
    """

    def __init__(
        self, first: Sequence[Sequence[Node]], second: Sequence[Sequence[Node]], grid: Grid
    ) -> None:
        self._first, self._second = [*map(_from_lowest, first)], [*map(_from_lowest, second)]
        self._sides: dict[int, list[Side]] = {}
        self._areas: dict[int, int] = {}
        self.grid, self.columns = grid, len(second)
        self.count = len(first) * len(second)
        self.trees = [
            grow([(grid.box(points), k) for k, points in enumerate(shape)])
            for shape in (first, second)
        ]

    def sides(self, k: int) -> list[Side]:
        """Return the edges of a sum, counter-clockwise from its lowest vertex, the left of two."""
        found = self._sides.get(k)
        if found is None:
            pieces = self._first[k // self.columns], self._second[k % self.columns]
            found = self._sides[k] = _add(*pieces)
        return found

    def box(self, k: int) -> Box:
        """Return the box of a sum."""
        return self.grid.box([side.start for side in self.sides(k)])

    def measure(self, k: int) -> int:
        """Return twice the area of a sum, its corners rounded to the grid."""
        area = self._areas.get(k)
        if area is None:
            size = self.grid._size
            corners = [
                (x * _CELLS // (w * size), y * _CELLS // (w * size))
                for (x, y, w), *_ in self.sides(k)
            ]
            area = sum(
                x * v - u * y
                for (x, y), (u, v) in zip(corners, corners[1:] + corners[:1], strict=True)
            )
            self._areas[k] = area
        return area


def _from_lowest(points: Sequence[Node]) -> list[Side]:
    """Return the edges of a piece from its lowest vertex on, the left of two."""
    k = min(
        range(len(points)),
        key=lambda k: (Fraction(points[k][1], points[k][2]), Fraction(points[k][0], points[k][2])),
    )
    ring = [*points[k:], *points[:k]]
    return [make_side(p, q) for p, q in zip(ring, ring[1:] + ring[:1], strict=True)]


def _add(one: Sequence[Side], other: Sequence[Side]) -> list[Side]:
    """Merge the edges of two convex pieces by direction."""
    i = j = 0
    m, n = len(one), len(other)
    corners, directions = [], []
    while i < m or j < n:
        (x, y, w), _, (dx, dy), _ = one[i % m]
        (u, v, _), _, (ex, ey), _ = other[j % n]
        corners.append((x + u * w, y + v * w, w))
        turn = 1 if j == n else -1 if i == m else dx * ey - dy * ex
        directions.append((dx, dy) if turn >= 0 else (ex, ey))
        i, j = i + (turn >= 0), j + (turn <= 0)
    return [*map(_side, corners, corners[1:] + corners[:1], directions)]


def clip(sides: Sequence[Side], a: Node, b: Node) -> Interval | None:
    """Find the open interval of a segment inside an open convex polygon.

    Returns:
        Its ends, from -1 or to 2 if it continues beyond an end of the segment; None if it is empty.
    """
    (x, y, w), (u, v, z) = a, b
    low, low_unit, high, high_unit = -1, 1, 2, 1
    for *_, (k, m, n) in sides:
        at_a, at_b = (k * x + m * y + n * w) * z, (k * u + m * v + n * z) * w
        if at_a <= 0:
            if at_b <= 0:
                return None
            if -at_a * low_unit > low * (at_b - at_a):
                low, low_unit = -at_a, at_b - at_a
        elif at_b <= 0 and at_a * high_unit < high * (at_a - at_b):
            high, high_unit = at_a, at_a - at_b
    if low * high_unit < high * low_unit:
        return Fraction(low, low_unit), Fraction(high, high_unit)
    return None


def intersect(side: Side, other: Side) -> Interval | None:
    """Find the closed interval of a segment on another segment or a point.

    Returns:
        Its ends, perhaps beyond those of the segment; None if both have no point in common.
    """
    (a, b, (dx, dy), (k, m, n)), (p, q, *_, (e, f, g)) = side, other
    at_p, at_q = k * p[0] + m * p[1] + n * p[2], k * q[0] + m * q[1] + n * q[2]
    if (at_p > 0 and at_q > 0) or (at_p < 0 and at_q < 0):
        return None
    if at_p == at_q == 0:
        at_a, at_b, at_p, at_q = (Fraction(dx * x + dy * y, w) for x, y, w in (a, b, p, q))
        low, high = min(at_p, at_q), max(at_p, at_q)
        if low > at_b or high < at_a:
            return None
        return (low - at_a) / (at_b - at_a), (high - at_a) / (at_b - at_a)
    at_a = (e * a[0] + f * a[1] + g * a[2]) * b[2]
    at_b = (e * b[0] + f * b[1] + g * b[2]) * a[2]
    if at_a == at_b or (at_a > 0 and at_b > 0) or (at_a < 0 and at_b < 0):
        return None
    at = Fraction(at_a, at_a - at_b)
    return at, at


def is_right(side: Side, other: Side) -> bool:
    """Return whether another segment is right of the line of a side, and does not touch it."""
    (a, b, c), (x, y, w), (u, v, z) = side.line, other.start, other.end
    return a * x + b * y + c * w < 0 and a * u + b * v + c * z < 0
