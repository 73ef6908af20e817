"""The regions that rings fill that cross or touch themselves or each other, exactly.

All edges are cut where they meet. From left to right, in the order of a sweep line, each piece gets
the winding numbers on both of its sides. Pieces with the filled area on one side only are its
boundary. Walked with the area on the left, and at each vertex by the next piece clockwise, they
make the faces. Faces are cut into two rings at vertices that
they visit twice.
"""

from __future__ import annotations

from bisect import bisect_left
from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cmp_to_key
from itertools import pairwise
from typing import Literal, NamedTuple

from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.distance import measure_to_edge
from exactsweep.geometry.near import find_near
from exactsweep.geometry.reading import to_lattice
from exactsweep.geometry.vectors import compare_angles, minus, turn, way_key
from exactsweep.numbers.number import Edge, Point, Rational, Vertex, divide_exactly

Rule = Literal["nonzero", "evenodd", "positive"]
"""A rule that says by its winding number whether a point is filled."""

_IS_FILLED: dict[Rule, Callable[[int], bool]] = {
    "nonzero": lambda number: number != 0,
    "evenodd": lambda number: number % 2 == 1,
    "positive": lambda number: number > 0,
}

_WindingNumbers = tuple[int, int]
"""The winding numbers below and above an edge that runs from left to right."""


class Filled(NamedTuple):
    """The regions that rings fill.

    Attributes:
        regions: of each, the exterior, counter-clockwise, and the holes.
        hidden: a bound on the squared distance of edges inside from the boundary, if it is
            measured.
    """

    regions: list[list[list[Point]]]
    hidden: Fraction


def fill(rings: Sequence[Sequence[Point]], rule: Rule, *, measured: bool = False) -> Filled:
    """Find the regions that rings fill.

    Args:
        rings: the vertices of each ring, the first one perhaps again at the end.
        rule: the points that are filled: those with a winding number that is not 0, odd or
            positive.
        measured: whether to measure `hidden`.

    Returns:
        The Filled; regions in the order of their least vertices.

    Cost: O((n + k) log n) for n edges and k points where they meet, if the sweep line meets few.

    Example:
        >>> bow = [Point(*map(Fraction, p)) for p in [(0, 0), (2, 2), (2, 0), (0, 2)]]
        >>> [[*map(find_doubled_area, rings)] for rings in fill([bow], "nonzero").regions]
        [[Fraction(2, 1)], [Fraction(2, 1)]]
    """
    scale, points = to_lattice(*zip(*(p for ring in rings for p in ring), strict=True))
    edges: list[Edge] = []
    first = 0
    for ring in rings:
        own = points[first : first + len(ring)]
        first += len(ring)
        edges += [(a, b) for a, b in pairwise((*own, own[0])) if a != b]
    sides = _wind(_cut(edges))
    is_filled = _IS_FILLED[rule]
    boundary: list[Edge] = []
    inside: list[Edge] = []
    for (a, b), (below, above) in sides.items():
        is_below, is_above = is_filled(below), is_filled(above)
        if is_below != is_above:
            boundary.append((a, b) if is_above else (b, a))
        elif below or above:
            inside.append((a, b))
    found = [
        [[Point(Fraction(x) / scale, Fraction(y) / scale) for x, y in ring] for ring in one]
        for one in _gather(_walk(boundary))
    ]
    hidden = _measure(inside, boundary) if measured and boundary else Fraction(0)
    return Filled(found, hidden / scale**2)


def _cut(edges: Sequence[Edge]) -> list[Edge]:
    """Cut edges where they meet."""
    boxes = [(min(a[0], b[0]), max(a[0], b[0]), min(a[1], b[1]), max(a[1], b[1])) for a, b in edges]
    cuts: defaultdict[int, set[Vertex]] = defaultdict(set)
    for i, k in find_near(boxes):
        for point in _meet(edges[i], edges[k]):
            for number in (i, k):
                if point not in edges[number]:
                    cuts[number].add(point)
    found: list[Edge] = []
    for k, (a, b) in enumerate(edges):
        inner = sorted(cuts[k], reverse=a > b) if k in cuts else []
        found += pairwise((a, *inner, b))
    return found


def _meet(one: Edge, other: Edge) -> Iterator[Vertex]:
    """Yield the point where two edges meet, or the ends of what they share."""
    (a, b), (p, q) = one, other
    of_p, of_q, of_a, of_b = turn(a, b, p), turn(a, b, q), turn(p, q, a), turn(p, q, b)
    if of_p == of_q == 0:
        for low, high, ends in ((a, b, other), (p, q, one)):
            yield from (end for end in ends if min(low, high) <= end <= max(low, high))
    elif of_p * of_q <= 0 >= of_a * of_b:
        share = Fraction(of_p) / (of_p - of_q)
        x, y = p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])
        yield (_simplify(x), _simplify(y))


def _simplify(value: Rational) -> Rational:
    return value.numerator if value.denominator == 1 else value


def _wind(pieces: Sequence[Edge]) -> dict[Edge, _WindingNumbers]:
    """Find the winding numbers on both sides of each piece."""
    numbers: defaultdict[Edge, int] = defaultdict(int)
    for a, b in pieces:
        numbers[min(a, b), max(a, b)] += 1 if a < b else -1
    starting: defaultdict[Vertex, list[Edge]] = defaultdict(list)
    vertices = set()
    for a, b in numbers:
        starting[a].append((a, b))
        vertices |= {a, b}
    found: dict[Edge, _WindingNumbers] = {}
    line: list[Edge] = []
    for vertex in sorted(vertices):
        low = bisect_left(line, True, key=lambda e: turn(e[0], e[1], vertex) <= 0)
        high = low
        while high < len(line) and line[high][1] == vertex:
            high += 1
        new = sorted(starting[vertex], key=cmp_to_key(_compare_slopes))
        line[low:high] = new
        winding = found[line[low - 1]][1] if low else 0
        for edge in new:
            found[edge] = winding, winding + numbers[edge]
            winding += numbers[edge]
    return found


def _compare_slopes(one: Edge, other: Edge) -> int:
    side = turn(*one, other[1])
    return -1 if side > 0 else int(side < 0)


def _walk(boundary: Sequence[Edge]) -> Iterator[list[Vertex]]:
    """Yield the rings that edges make, the area on their left."""
    leaving: defaultdict[Vertex, list[Vertex]] = defaultdict(list)
    for a, b in boundary:
        leaving[a].append(b)
    left = set(boundary)
    for first in sorted(boundary):
        if first not in left:
            continue
        ring: list[Vertex] = []
        at: dict[Vertex, int] = {}
        a, b = first
        while (a, b) in left:
            left.remove((a, b))
            if a in at:
                start = at[a]
                yield ring[start:]
                for vertex in ring[start:]:
                    del at[vertex]
                del ring[start:]
            at[a] = len(ring)
            ring.append(a)
            a, b = b, _find_next(a, b, leaving[b])
        yield ring


def _find_next(a: Vertex, b: Vertex, ends: Sequence[Vertex]) -> Vertex:
    """Return the end of the next edge clockwise from the one back."""
    if len(ends) == 1:
        return ends[0]
    back = minus(a, b)
    ordered = sorted(((minus(end, b), end) for end in ends), key=lambda one: way_key(one[0]))
    before = [end for way, end in ordered if compare_angles(way, back) < 0]
    return before[-1] if before else ordered[-1][1]


def _gather(rings: Iterator[list[Vertex]]) -> list[list[list[Vertex]]]:
    """Put each hole to the exterior around it."""
    exteriors: list[tuple[Rational, list[list[Vertex]]]] = []
    holes = []
    for ring in rings:
        area = find_doubled_area(ring)
        if area > 0:
            exteriors.append((area, [ring]))
        else:
            holes.append(ring)
    for hole in holes:
        around = min(
            (one for one in exteriors if _is_around(one[1][0], hole)), key=lambda one: one[0]
        )
        around[1].append(hole)
    return [one for _, one in sorted(exteriors, key=lambda one: min(one[1][0]))]


def _is_around(ring: Sequence[Vertex], hole: Sequence[Vertex]) -> bool:
    """Decide whether a hole, which may touch a ring in vertices, is inside it."""
    # The middle of an edge is on no other ring.
    (x, y), (u, v) = hole[:2]
    x, y = Fraction(x + u) / 2, Fraction(y + v) / 2
    number = 0
    for a, b in pairwise((*ring, ring[0])):
        if (a[1] <= y) != (b[1] <= y) and (turn(a, b, (x, y)) > 0) == (b[1] > a[1]):
            number += 1
    return number % 2 == 1


def _measure(inside: Sequence[Edge], boundary: Sequence[Edge]) -> Fraction:
    """Bound the squared distance of edges from a boundary, by one end and the length of each."""
    most = Fraction(0)
    for a, b in inside:
        x, y = minus(b, a)
        near = min(divide_exactly(*measure_to_edge(a, edge)) for edge in boundary)
        # The square of a sum is at most twice the sum of the squares.
        most = max(most, 2 * (near + x * x + y * y))
    return most
