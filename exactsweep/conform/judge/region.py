"""The exact difference of two regions with arbitrary rings, as trapezoids.

A point belongs to a region if it has an odd winding number. So rings may cross, have either
orientation, and enclose holes.

Vertical lines through all vertices cut the plane into slabs, which edges cross from side to side.
Two edges cross inside a slab if and only if their order is reversed from one side to the other;
vertical lines through these crossings cut it further. Then neighboring edges bound trapezoids, and
each edge changes the parity of its region. The trapezoids in exactly one region form the
difference.
"""

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import chain, pairwise
from math import lcm
from typing import NamedTuple

from exactsweep.geometry.distance import measure_to_edge
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Fit, Point, PointRings, Rational

Height = tuple[Fraction, Fraction]
MAX_WORK = 300_000  # edges summed over all slabs: about 15 seconds
_PARTS = tuple((Fraction(a, 9), Fraction(b, 9)) for a, b in ((3, 6), (1, 2), (7, 8)))


class Trapezoid(NamedTuple):
    """An open trapezoid in exactly one of two regions, the first or the second."""

    first: bool
    left: Fraction
    right: Fraction
    low: Height  # y of the lower edge at both sides
    high: Height  # y of the upper edge
    edges: tuple[Fit, ...] = ()

    @property
    def area(self) -> Fraction:
        gaps = self.high[0] - self.low[0] + self.high[1] - self.low[1]
        return gaps * (self.right - self.left) / 2

    def corners(self) -> tuple[Point, ...]:
        """Return four corners counter-clockwise; a triangle repeats one."""
        sides = (self.left, self.low[0]), (self.right, self.low[1])
        return tuple(
            Point(*p) for p in (*sides, (self.right, self.high[1]), (self.left, self.high[0]))
        )

    def points(self) -> Iterator[Point]:
        width = self.right - self.left
        for a, b in _PARTS:
            x = find_simplest(self.left + a * width, self.left + b * width)
            share = (x - self.left) / width
            low, high = (y[0] + share * (y[1] - y[0]) for y in (self.low, self.high))
            for c, d in _PARTS:
                yield Point(x, find_simplest(low + c * (high - low), low + d * (high - low)))


class _RegionEdge(NamedTuple):
    left: Point
    right: Point
    slope: Fraction
    region: int

    def at(self, x: Fraction) -> Fraction:
        return self.left.y + (x - self.left.x) * self.slope if x != self.left.x else self.left.y


Ordered = Sequence[tuple[Height, _RegionEdge]]


class RegionError(ExactSweepError):
    pass


def find_differences(first: PointRings, second: PointRings) -> Iterator[Trapezoid]:
    """Yield the trapezoids in exactly one of two regions, from left to right.

    There are none if and only if the regions differ by a set of zero area. A RegionError is raised
    if the work would exceed MAX_WORK. The cost is O((n + k) w log w) for n edges with k crossings,
    at most w in one slab.

    >>> square = [Point(Fraction(x), Fraction(y)) for x, y in [(0, 0), (2, 0), (2, 2), (0, 2)]]
    >>> bow_tie = [square[k] for k in (0, 2, 1, 3)]
    >>> sum(cell.area for cell in find_differences([square], [bow_tie]))
    Fraction(2, 1)
    """
    for left, right, ordered in _cut([*_edges(first, 0), *_edges(second, 1)]):
        inside = [False, False]
        for (bottom, edge), (top, upper) in pairwise(ordered):
            inside[edge.region] = not inside[edge.region]
            if inside[0] != inside[1] and bottom != top:
                edges = (edge.left, edge.right), (upper.left, upper.right)
                yield Trapezoid(inside[0], left, right, bottom, top, edges)


def _cut(edges: list[_RegionEdge]) -> Iterator[tuple[Fraction, Fraction, Ordered]]:
    edges.sort()
    cuts = sorted({x for edge in edges for x in (edge.left.x, edge.right.x)})
    active: list[_RegionEdge] = []
    started = work = 0
    for left, right in pairwise(cuts):
        active = [edge for edge in active if edge.right.x > left]
        while started < len(edges) and edges[started].left.x == left:
            active.append(edges[started])
            started += 1
        ordered = _order(left, right, active)
        inner: set[Fraction] = set()
        work += len(active)
        for share in _crossings(ordered):
            inner.add(left + share * (right - left))
            if work + len(inner) * len(active) > MAX_WORK:
                break
        work += len(inner) * len(active)
        if work > MAX_WORK:
            raise RegionError("too many overlapping or crossing edges to measure")
        for a, b in pairwise([left, *sorted(inner), right]):
            yield a, b, _order(a, b, active) if inner else ordered


def add_areas(cells: Iterable[Trapezoid]) -> Fraction:
    return add_up(cell.area for cell in cells)


def find_simplest(low: Fraction, high: Fraction) -> Fraction:
    """Find the rational of least denominator in a closed interval; the integer nearest to zero.

    It uses continued fractions without recursion, since numbers may be long.

    >>> find_simplest(Fraction(31, 100), Fraction(36, 100))
    Fraction(1, 3)
    """
    if low <= 0 <= high:
        return Fraction(0)
    if high < 0:
        return -find_simplest(-high, -low)
    # Common partial quotients, then the least integer in the interval.
    quotients = []
    while (whole := -(-low.numerator // low.denominator)) > high:
        quotients.append(whole - 1)
        low, high = 1 / (high - (whole - 1)), 1 / (low - (whole - 1))
    value = Fraction(whole)
    for quotient in reversed(quotients):
        value = quotient + 1 / value
    return value


def _edges(rings: PointRings, region: int) -> Iterator[_RegionEdge]:
    for ring in rings:
        for k, p in enumerate(ring):
            left, right = sorted((ring[k - 1], p))
            if left.x < right.x:
                yield _RegionEdge(left, right, (right.y - left.y) / (right.x - left.x), region)


def _crossings(ordered: Ordered) -> Iterator[Fraction]:
    """Yield the fractions of a slab's width at which edges cross, found by insertion sort."""
    below: list[Height] = []
    for heights, _ in ordered:
        low, high = heights
        k = len(below)
        while k and below[k - 1][1] > high:
            k -= 1
            if below[k][0] < low:
                yield (low - below[k][0]) / (low - below[k][0] + below[k][1] - high)
        below.insert(k, heights)


def _order(left: Fraction, right: Fraction, edges: Sequence[_RegionEdge]) -> Ordered:
    return sorted(((edge.at(left), edge.at(right)), edge) for edge in edges)


def measure_distance(first: PointRings, second: PointRings) -> Fraction:
    """Return the greatest squared distance of a vertex from the boundary of the other rings.

    It is symmetric, 0 for equal loops, and at most the square of the Hausdorff distance. Both loops
    must have vertices. The cost is O(m n), but only linear for vertices shared by both loops.

    >>> from exactsweep import Point
    >>> square = [Point(Fraction(x), Fraction(y)) for x, y in [(0, 0), (4, 0), (4, 4), (0, 4)]]
    >>> dented = [*square[:3], Point(Fraction(2), Fraction(3)), square[3]]
    >>> measure_distance([square], [dented])
    Fraction(1, 1)
    """
    scale = lcm(*(c.denominator for c in chain.from_iterable(chain(*first, *second))))
    one, other = (
        [[(int(x * scale), int(y * scale)) for x, y in ring] for ring in rings]
        for rings in (first, second)
    )
    n: Rational = 0
    d: Rational = 1
    for rings, target in ((one, other), (other, one)):
        edges = [(ring[k - 1], p) for ring in target for k, p in enumerate(ring)]
        for p in {*chain(*rings)}.difference(*target):
            least, unit = measure_to_edge(p, edges[0])
            for edge in edges:
                found = measure_to_edge(p, edge)
                if found[0] * unit < least * found[1]:
                    least, unit = found
                if least * d <= n * unit:
                    break
            else:
                n, d = least, unit
    return Fraction(n, d * scale * scale)
