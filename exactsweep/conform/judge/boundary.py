"""The boundary of the region that rings enclose, independent of their notation.

A segment bounds the region if and only if an odd number of edges cover it, in either direction:

(1) Two regions differ by a set of zero area if and only if these segments are equal. This does not
    depend on crossings, so only collinear edges are compared.
(2) Segments covered by an even number of edges bound nothing: whiskers, keyholes that connect a
    ring to a hole, and borders between pieces of a region.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import chain, groupby, pairwise
from operator import itemgetter
from typing import NamedTuple

from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.vectors import angle_key, is_on_segment, minus, orientation
from exactsweep.numbers.number import Fit, Loop, Point, PointRings, Vertex

# The slope and the y at x = 0; None and the x of a vertical line.
_LineKey = tuple[Fraction | None, Fraction]


class RingBoundary(NamedTuple):
    solid: tuple[Fit, ...]  # maximal segments that an odd number of edges cover
    through: tuple[Loop, ...]  # the vertices inside each solid segment
    doubled: tuple[Fit, ...]  # maximal segments covered an even number of times; rings of one point


def find_boundary(rings: PointRings) -> RingBoundary:
    """Find the boundary of the region of arbitrary rings, and their doubled segments, sorted.

    >>> square = [Point(Fraction(x), Fraction(y)) for x, y in [(0, 0), (2, 0), (2, 2), (0, 2)]]
    >>> whisker = [*square, Point(Fraction(0), Fraction(3))]
    >>> find_boundary([whisker]).solid == find_boundary([square]).solid
    True
    >>> [[int(p.y) for p in fit] for fit in find_boundary([whisker]).doubled]
    [[2, 3]]
    """
    lines: dict[_LineKey, list[tuple[Point, int]]] = {}
    points = set()
    for ring in rings:
        for k, p in enumerate(ring):
            low, high = sorted((ring[k - 1], p))
            if low != high:
                lines.setdefault(_find_line(low, high), []).extend([(low, 1), (high, -1)])
        if len({*ring}) == 1:
            points.add((ring[0], ring[0]))
    solid: list[tuple[Fit, Loop]] = []
    doubled: list[Fit] = []
    for ends in lines.values():
        for is_solid, (a, *between, b) in _join_along_line(ends):
            if is_solid:
                solid.append(((a, b), tuple(between)))
            else:
                doubled.append((a, b))
    solid.sort()
    segments, through = zip(*solid, strict=True) if solid else ((), ())
    return RingBoundary(segments, through, (*sorted(doubled), *sorted(points)))


def _find_line(p: Point, q: Point) -> _LineKey:
    if p.x == q.x:
        return None, p.x
    slope = (q.y - p.y) / (q.x - p.x)
    return slope, p.y - slope * p.x


def _join_along_line(ends: list[tuple[Point, int]]) -> Iterator[tuple[bool, list[Point]]]:
    """Yield whether each segment of a line is solid, and the points on it."""
    ends.sort()
    count = 0
    points: list[Point] = []
    for p, group in groupby(ends, key=itemgetter(0)):
        before, count = count, count + sum(step for _, step in group)
        points.append(p)
        if not (before and count) or (count - before) % 2:
            if before:
                yield before % 2 == 1, points
            points = [p]


def subtract_fits(segments: Iterable[Fit], fits: Iterable[Fit]) -> tuple[list[Fit], list[Fit]]:
    """Split segments into the pieces on exact fits and the rest."""
    on: list[Fit] = []
    off: list[Fit] = []
    known = list(fits)
    for low, high in map(sorted, segments):
        near = [sorted(fit) for fit in known if are_collinear((*fit, low, high))]
        ends = {low, high, *(p for fit in near for p in fit if low < p < high)}
        pieces = [*pairwise(sorted(ends))] or [(low, high)]
        for a, b in pieces:
            is_on_fit = any(p <= a and b <= q for p, q in near)
            (on if is_on_fit else off).append((a, b))
    return on, off


def are_collinear(points: Sequence[Vertex]) -> bool:
    low, high = min(points), max(points)
    return not any(orientation(low, high, p) for p in points)


def are_bridges(segments: Sequence[Fit], solid: Sequence[Fit]) -> bool:
    """Decide whether doubled segments connect points of a boundary and have no free ends."""
    corners = {*chain.from_iterable(solid)}
    ends = {*chain.from_iterable(segments)}
    near = {p: [segment for segment in segments if is_on_segment(p, *segment)] for p in ends}
    held = {p for p in ends if p in corners or any(is_on_segment(p, *edge) for edge in solid)}
    if any(len(near[p]) < 2 for p in ends - held):
        return False
    grown = list(held)
    while grown:
        for segment in near[grown.pop()]:
            fresh = {p for p in ends - held if is_on_segment(p, *segment)}
            held |= fresh
            grown += fresh
    return held == ends


def trace_rings(boundary: RingBoundary) -> list[Loop]:
    """Trace a boundary as counter-clockwise rings, none of which visits a corner twice."""
    passed = Counter(chain.from_iterable(boundary.through))
    corners = {*chain.from_iterable(boundary.solid), *(p for p in passed if passed[p] > 1)}
    near: dict[Point, list[Point]] = {}
    for (first, last), through in zip(boundary.solid, boundary.through, strict=True):
        for a, b in pairwise((first, *(p for p in through if p in corners), last)):
            near.setdefault(a, []).append(b)
            near.setdefault(b, []).append(a)
    partner: dict[tuple[Point, Point], Point] = {}
    for p, others in near.items():
        ordered = sorted(others, key=lambda other, p=p: angle_key(minus(other, p)))  # type: ignore[misc]
        for a, b in zip(ordered[::2], ordered[1::2], strict=True):
            partner[a, p], partner[b, p] = b, a
    rings: list[Loop] = []
    while partner:
        (a, p), _ = next(iter(partner.items()))
        path, places = [a], {a: 0}
        while (after := partner.pop((a, p), None)) is not None:
            del partner[after, p]
            if p in places:
                rings.append(tuple(path[places[p] :]))
                for q in path[places[p] + 1 :]:
                    del places[q]
                del path[places[p] + 1 :]
            else:
                places[p] = len(path)
                path.append(p)
            a, p = p, after
    return [ring if find_doubled_area(ring) > 0 else ring[::-1] for ring in rings]
