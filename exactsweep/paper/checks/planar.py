"""The topology of a swept area, exactly, for any simple directrix: Theorem 2.2 put to the test.

Nothing here comes from the procedures. The positions at which G touches D without overlap are
found by `exactsweep.check.classify` on an arrangement of segments; G swept along one of its pieces
is a convex polygon, or several if G is not convex; and the parts of the plane that a union of
closed convex polygons leaves free are counted by cutting the plane into vertical slabs.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import combinations, pairwise
from math import lcm
from typing import Generic, TypeVar

from exactsweep.check import classify
from exactsweep.corpus.generator.shapes import Ring
from exactsweep.geometry.hull import find_hull
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.vectors import turn
from exactsweep.numbers.point import Point

SegmentPiece = tuple[Point, Point]
Opening = tuple[SegmentPiece | None, SegmentPiece | None]
"""What bounds a free interval of a vertical line below and above; None, nothing does."""

T = TypeVar("T")


def find_contact_pieces(generatrix: Ring, directrix: Ring) -> list[SegmentPiece]:
    """The pieces of the positions of G in contact with D, connected with the leftmost one.

    Cost: O(m n) segments, cut where they meet, each piece classified: for small polygons.

    >>> triangle = [(0, 0), (1, 0), (0, 1)]
    >>> len(find_contact_pieces(triangle, triangle))
    6
    """
    g, d = Polygon(generatrix).vertices, Polygon(directrix).vertices
    segments = {_order(_minus(v, p), _minus(v, q)) for p, q in _edges(g) for v in d}
    segments |= {_order(_minus(p, w), _minus(q, w)) for p, q in _edges(d) for w in g}
    ends: defaultdict[SegmentPiece, set[Point]] = defaultdict(set)
    for segment in segments:
        ends[segment].update(segment)
    for one, other in combinations(sorted(segments), 2):
        for point in _common(one, other):
            ends[one].add(point)
            ends[other].add(point)
    pieces = {piece for points in ends.values() for piece in pairwise(sorted(points))}
    touching = [
        (p, q)
        for p, q in sorted(pieces)
        if classify(directrix, generatrix, ((p.x + q.x) / 2, (p.y + q.y) / 2)).verdict != "OVERLAP"
    ]
    groups: Groups[Point] = Groups()
    for p, q in touching:
        groups.join(p, q)
    first = groups.root(touching[0][0])
    return [piece for piece in touching if groups.root(piece[0]) == first]


def list_swept_polygons(generatrix: Ring, pieces: Iterable[SegmentPiece]) -> list[list[Point]]:
    """Convex polygons whose union is what an X-monotone G passes over along pieces of its path."""
    cells = cut_to_cells(generatrix)
    return [
        find_hull([Point(p.x + t.x, p.y + t.y) for p in cell for t in piece])
        for piece in pieces
        for cell in cells
    ]


def cut_to_cells(ring: Ring) -> list[list[Point]]:
    """Convex polygons whose union is an X-monotone polygon: itself, or one for each slab.

    >>> len(cut_to_cells([(0, 0), (1, 2), (2, 0), (2, 3), (0, 3)]))
    2
    """
    points = list(Polygon(ring).vertices)
    if Polygon(ring).is_convex:
        return [points]
    edges = [_order(p, q) for p, q in _edges(points) if p.x != q.x]
    cells = []
    for left, right in pairwise(sorted({p.x for p in points})):
        across = [edge for edge in edges if edge[0].x <= left and right <= edge[1].x]
        cells.append(find_hull([Point(x, _at(edge, x)) for edge in across for x in (left, right)]))
    return cells


def count_free_parts(polygons: Sequence[Sequence[Point]]) -> int:
    """Into how many connected parts a union of closed convex polygons divides the rest.

    One for a disc, two for an annulus.

    Args:
        polygons: their vertices, counter-clockwise.

    >>> triangle = [(0, 0), (1, 0), (0, 1)]
    >>> count_free_parts(list_swept_polygons(triangle, find_contact_pieces(triangle, triangle)))
    2
    """
    scale = lcm(*(c.denominator for polygon in polygons for p in polygon for c in p))
    shapes = [_ConvexCell([_scale(p, scale) for p in polygon]) for polygon in polygons]
    edges = [edge for shape in shapes for edge in shape.edges]
    xs = {p.x for edge in edges for p in edge}
    for one, other in combinations(edges, 2):
        xs |= {point.x for point in _common(one, other)}
    cuts = sorted(map(Fraction, xs))
    nothing: list[Opening] = [(None, None)]
    slabs = [_openings(shapes, (left + right) / 2) for left, right in pairwise(cuts)]
    groups: Groups[tuple[int, int]] = Groups()
    for k, (x, (before, after)) in enumerate(
        zip(cuts, pairwise([nothing, *slabs, nothing]), strict=True)
    ):
        for number in range(len(after)):
            groups.root((k + 1, number))
        for gap in _openings(shapes, x):
            # Around a free point all is free: it is inside one gap of the slab on either side.
            y = _inside(gap, x)
            (i,) = (i for i, other in enumerate(before) if _holds(other, x, y))
            (j,) = (j for j, other in enumerate(after) if _holds(other, x, y))
            groups.join((k, i), (k + 1, j))
    return groups.count


def _scale(p: Point, scale: int) -> Point:
    """A point on the lattice, in ints, which are rationals too and take a tenth of the time."""
    return Point(int(p.x * scale), int(p.y * scale))  # type: ignore[arg-type]


class Groups(Generic[T]):
    """Sets of things that are joined with one another.

    >>> groups = Groups()
    >>> groups.join(1, 2), groups.join(3, 4), groups.join(2, 1)
    (None, None, None)
    >>> groups.count
    2
    """

    def __init__(self) -> None:
        self._parents: dict[T, T] = {}

    def root(self, item: T) -> T:
        """The one that stands for the set of an item."""
        parent = self._parents.setdefault(item, item)
        while parent != item:
            item, parent = parent, self._parents[parent]
        return item

    def join(self, item: T, other: T) -> None:
        """Make the sets of two items one."""
        self._parents[self.root(item)] = self.root(other)

    @property
    def count(self) -> int:
        """Count the sets."""
        return sum(item == parent for item, parent in self._parents.items())


class _ConvexCell:
    """A convex polygon as a bottom and a top, made of edges from left to right."""

    def __init__(self, polygon: Sequence[Point]) -> None:
        self.edges = _edges(polygon)
        self.bottom = [(p, q) for p, q in self.edges if p.x < q.x]
        self.top = [(q, p) for p, q in self.edges if q.x < p.x]
        self.left, self.right = min(polygon).x, max(polygon).x

    def section(self, x: Fraction) -> tuple[SegmentPiece, SegmentPiece] | None:
        """The bottom and the top edge over an x; None beside the polygon."""
        if not self.left <= x <= self.right:
            return None
        below = next((e for e in self.bottom if e[0].x <= x <= e[1].x), None)
        above = next((e for e in self.top if e[0].x <= x <= e[1].x), None)
        return None if below is None or above is None else (below, above)


def _openings(shapes: Sequence[_ConvexCell], x: Fraction) -> list[Opening]:
    """The free intervals of a vertical line, from below."""
    found = [section for shape in shapes if (section := shape.section(x))]
    spans = sorted((_at(below, x), _at(above, x), below, above) for below, above in found)
    gaps: list[Opening] = []
    reached: Fraction | None = None
    last: SegmentPiece | None = None
    for low, high, below, above in spans:
        if reached is None or low > reached:
            gaps.append((last, below))
        if reached is None or high > reached:
            reached, last = high, above
    return [*gaps, (last, None)]


def _inside(gap: Opening, x: Fraction) -> Fraction:
    below, above = gap
    if below is None:
        return Fraction(0) if above is None else _at(above, x) - 1
    return _at(below, x) + 1 if above is None else (_at(below, x) + _at(above, x)) / 2


def _holds(gap: Opening, x: Fraction, y: Fraction) -> bool:
    below, above = gap
    return (below is None or _at(below, x) < y) and (above is None or y < _at(above, x))


def _at(edge: SegmentPiece, x: Fraction) -> Fraction:
    p, q = edge
    return p.y + (q.y - p.y) * (x - p.x) / (q.x - p.x)


def _edges(ring: Sequence[T]) -> list[tuple[T, T]]:
    return list(pairwise([*ring, ring[0]]))


def _minus(p: Point, q: Point) -> Point:
    return Point(p.x - q.x, p.y - q.y)


def _order(p: Point, q: Point) -> SegmentPiece:
    return (p, q) if p < q else (q, p)


def _common(one: SegmentPiece, other: SegmentPiece) -> Iterator[Point]:
    """Find where two segments meet: a point, or the ends of what they share."""
    (p, q), (r, s) = one, other
    if max(p.x, q.x) < min(r.x, s.x) or max(r.x, s.x) < min(p.x, q.x):
        return
    from_r, from_s = turn(p, q, r), turn(p, q, s)
    if from_r == from_s == 0:
        low, high = sorted([*one, *other])[1:3]
        if max(min(one), min(other)) <= min(max(one), max(other)):
            yield from {low, high}
        return
    from_p, from_q = turn(r, s, p), turn(r, s, q)
    if from_r * from_s <= 0 and from_p * from_q <= 0:
        share = Fraction(from_r) / (from_r - from_s)
        yield Point(r.x + share * (s.x - r.x), r.y + share * (s.y - r.y))
