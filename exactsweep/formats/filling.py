"""Regions filled by rings that may touch or cross themselves and each other.

Edges are cut where they meet. A sweep line finds the winding numbers on both sides of each piece;
pieces with the filled area on only one side form the boundary. Tracing it with the area on the
left, always to the next piece clockwise, yields the faces. A face that visits a vertex twice is cut
into two rings there.
"""

from bisect import bisect_left
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cmp_to_key
from itertools import pairwise
from typing import Literal, NamedTuple

from exactsweep.geometry.canonical import PolygonError, find_doubled_area
from exactsweep.geometry.distance import measure_to_edge
from exactsweep.geometry.near import find_near
from exactsweep.geometry.reading import to_lattice
from exactsweep.geometry.vectors import angle_key, compare_angles, intersect, minus, orientation
from exactsweep.numbers.number import Edge, Point, Rational, Vertex

MAX_PAIRS = 5_000_000  # pairs of nearby edges; each cut of an edge counts as 20 pairs
Rule = Literal["nonzero", "evenodd", "positive"]
_IS_FILLED: dict[Rule, Callable[[int], bool]] = {
    "nonzero": lambda number: number != 0,
    "evenodd": lambda number: number % 2 == 1,
    "positive": lambda number: number > 0,
}


class Filled(NamedTuple):
    regions: list[list[list[Point]]]  # for each, the exterior, counter-clockwise, and the holes
    touching: bool  # whether edges coincide, or meet anywhere except at common endpoints
    hidden: Fraction  # bounds the squared distance of interior edges from the boundary, if measured


def fill(rings: Sequence[Sequence[Point]], rule: Rule, *, measured: bool = False) -> Filled:
    """Find the regions that rings fill; compute `hidden` if `measured` and edges touch.

    Raises PolygonError if too many edges cross or are close together (MAX_PAIRS).

    Cost: O((n + k) log n) for n edges and k intersections, if the sweep line crosses few edges.

    >>> bow = [Point(*map(Fraction, p)) for p in [(0, 0), (2, 2), (2, 0), (0, 2)]]
    >>> [[*map(find_doubled_area, rings)] for rings in fill([bow], "nonzero").regions]
    [[Fraction(2, 1)], [Fraction(2, 1)]]
    """
    scale, points = to_lattice([p for ring in rings for p in ring])
    edges: defaultdict[Edge, int] = defaultdict(int)
    first = drawn = 0
    for ring in rings:
        own = points[first : first + len(ring)]
        first += len(ring)
        for a, b in pairwise((*own, own[0])):
            if a != b:
                drawn += 1
                edges[min(a, b), max(a, b)] += 1 if a < b else -1
    pieces = _cut(edges)
    order = {piece: k for k, piece in enumerate(pieces)}
    classified = _classify(pieces, _IS_FILLED[rule])
    found = [
        [[Point(Fraction(x) / scale, Fraction(y) / scale) for x, y in ring] for ring in one]
        for one in _nest_rings([*_trace(classified.boundary)], classified.below, order)
    ]
    touching = pieces.keys() != edges.keys() or len(edges) < drawn
    is_measured = measured and touching and classified.boundary
    hidden = _measure(classified.inside, classified.boundary) if is_measured else Fraction(0)
    return Filled(found, touching, hidden / scale**2)


def _cut(numbers: Mapping[Edge, int]) -> dict[Edge, int]:
    """Cut edges where they meet; return the net number of times each piece runs to the right."""
    edges = [*numbers]
    boxes = [(a[0], b[0], min(a[1], b[1]), max(a[1], b[1])) for a, b in edges]
    cuts: defaultdict[int, set[Vertex]] = defaultdict(set)
    left = MAX_PAIRS
    for i, k in find_near(boxes):
        left -= 1
        for x, y in intersect(edges[i], edges[k]):
            point = _simplify(x), _simplify(y)
            for number in (i, k):
                if point not in edges[number]:
                    cuts[number].add(point)
                    left -= 20
        if left < 0:
            raise PolygonError("too many edges cross or are close together")
    found: defaultdict[Edge, int] = defaultdict(int)
    for k, (a, b) in enumerate(edges):
        for piece in pairwise((a, *sorted(cuts.get(k, ())), b)):
            found[piece] += numbers[a, b]
    return found


def _simplify(value: Rational) -> Rational:
    return value.numerator if value.denominator == 1 else value


class _Classified(NamedTuple):
    boundary: list[Edge]  # pieces with the filled area only on their left
    inside: list[Edge]  # other pieces with a nonzero winding number on a side
    below: dict[Edge, Edge | None]  # for each boundary piece, the next one below its left end


def _classify(numbers: Mapping[Edge, int], is_filled: Callable[[int], bool]) -> _Classified:
    """Classify pieces by the winding numbers on both sides, with a sweep line."""
    starting: defaultdict[Vertex, list[Edge]] = defaultdict(list)
    vertices = set()
    for a, b in numbers:
        starting[a].append((a, b))
        vertices |= {a, b}
    found = _Classified([], [], {})
    line: list[Edge] = []
    above: dict[Edge, int] = {}
    for vertex in sorted(vertices):
        low = bisect_left(line, True, key=lambda e: orientation(e[0], e[1], vertex) <= 0)
        high = low
        while high < len(line) and line[high][1] == vertex:
            high += 1
        new = starting[vertex]
        if len(new) > 1:
            new = sorted(new, key=cmp_to_key(_compare_slopes))
        line[low:high] = new
        winding = above[line[low - 1]] if low else 0
        down = (line[k] for k in range(low - 1, -1, -1))
        under = next((e for e in down if e in found.below), None) if new else None
        for edge in new:
            a, b = edge
            above[edge] = winding + numbers[edge]
            is_below, is_above = is_filled(winding), is_filled(above[edge])
            if is_below != is_above:
                found.boundary.append((a, b) if is_above else (b, a))
                found.below[edge], under = under, edge
            elif winding or above[edge]:
                found.inside.append(edge)
            winding = above[edge]
    return found


def _compare_slopes(one: Edge, other: Edge) -> int:
    side = orientation(*one, other[1])
    return -1 if side > 0 else int(side < 0)


def _trace(boundary: Sequence[Edge]) -> Iterator[list[Vertex]]:
    """Trace the rings of the boundary, with the area on the left."""
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
    """Return the end of the next edge clockwise from the edge (b, a)."""
    if len(ends) == 1:
        return ends[0]
    back = minus(a, b)
    ordered = sorted(((minus(end, b), end) for end in ends), key=lambda one: angle_key(one[0]))
    before = [end for u, end in ordered if compare_angles(u, back) < 0]
    return before[-1] if before else ordered[-1][1]


def _nest_rings(
    rings: Sequence[list[Vertex]], below: Mapping[Edge, Edge | None], order: Mapping[Edge, int]
) -> list[list[list[Vertex]]]:
    edges = [[(min(a, b), max(a, b)) for a, b in pairwise((*ring, ring[0]))] for ring in rings]
    owner = {edge: k for k, row in enumerate(edges) for edge in row}
    found = {k: [ring] for k, ring in enumerate(rings) if find_doubled_area(ring) > 0}
    exteriors = {k: k for k in found}
    for k in sorted(set(range(len(rings))) - found.keys(), key=lambda k: min(rings[k])):
        chain = [k]
        while chain[-1] not in exteriors:
            # Below the least vertex of a hole is its exterior or another hole.
            ring = rings[chain[-1]]
            i = ring.index(min(ring))
            under = below[ring[i], ring[i - 1]]
            assert under is not None
            chain.append(owner[under])
        exteriors |= dict.fromkeys(chain, exteriors[chain[-1]])
        found[exteriors[k]].append(rings[k])
    first = {k: min(order[edge] for edge in edges[k]) for k in found}
    return [found[k] for k in sorted(found, key=first.__getitem__)]


def _measure(inside: Sequence[Edge], boundary: Sequence[Edge]) -> Fraction:
    """Bound the maximum squared distance of edges from the boundary."""
    most = Fraction(0)
    for a, b in inside:
        x, y = minus(b, a)
        near = min(Fraction(*measure_to_edge(a, edge)) for edge in boundary)
        # The square of a sum is at most twice the sum of the squares.
        most = max(most, 2 * (near + x * x + y * y))
    return most
