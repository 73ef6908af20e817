"""The features of G that draw the edges of the loops, and their positions on the trajectory.

G draws both loops as it moves along the trajectory T. An edge of a loop is a piece of an edge of G
at a vertex of T, of the path of a vertex of G along an edge of T, or of the path of an edge of G
along a parallel edge of T. One edge of a loop may need several features: one vertex of G after the
other may touch the same edge of D.

If the path of a vertex of G is on a loop, the vertex is convex, and G near it lies on one side of
the path, because G stays inside the outer loop and outside the inner one. For two convex polygons
this leaves two or four vertices for each direction of T.

Long periodic shapes draw each edge hundreds of times. So the search is lazy, and stops at the first
piece that covers the edge.
"""

from __future__ import annotations

from bisect import bisect_left
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from math import ceil, floor
from typing import Literal, NamedTuple

from exactsweep.evidence.contact import find_facing
from exactsweep.geometry.direction import Vector
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.segment import (
    Segment,
    choose_cover,
    find_offset,
    lay_point,
    make_segment,
    measure_along,
)
from exactsweep.geometry.vectors import minus
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Edge, Rational, Vertex


class Feature(NamedTuple):
    """A vertex or an edge of a loop, by number; edge k runs from vertex k to vertex k + 1."""

    kind: Literal["vertex", "edge"]
    number: int


class DrawnPiece(NamedTuple):
    """A piece of a loop's edge that a feature of G draws.

    Attributes:
        position: the vertex or the edge of the trajectory along which it draws.
        feature: the feature of G.
        piece: the drawn piece, on the line of the edge.
    """

    position: Feature
    feature: Feature
    piece: Segment


class _Way(NamedTuple):
    """An edge of the trajectory, in the order of low ends, and ints around its range."""

    low: Rational
    number: int
    high: Rational
    offset: Rational
    floor: int
    ceiling: int


class _Pens(NamedTuple):
    """The features of G that may draw along one direction, by line, and the bounds of all."""

    by_offset: dict[Rational, list[tuple[Feature, Segment]]]
    low: Rational
    high: Rational


class DrawnEdge(NamedTuple):
    """An edge of a loop, and the finder of the features that draw it.

    Attributes:
        edge: its ends.
        whole: the edge as a piece of its line.
        tracer: the Tracer of the sweep.
    """

    edge: Edge
    whole: Segment
    tracer: Tracer

    def covers(self, drawn: DrawnPiece) -> bool:
        """Decide whether a piece is all of the edge."""
        _, _, low, high = drawn.piece
        return low <= self.whole.low and self.whole.high <= high

    def choose(self) -> list[DrawnPiece]:
        """Choose few pieces that together cover the edge.

        The search tries, in this order, until it has covered the edge: edges of G with an end in
        common; vertices and edges of G along edges of the trajectory; other edges of G.

        Raises ExactSweepError if nothing draws the edge, because it does not belong to the sweep.
        """
        whole, tracer = self.whole, self.tracer
        tried: list[DrawnPiece] = []
        for source in (
            tracer.from_ends(whole, self.edge),
            tracer.along(whole),
            tracer.at_vertices(whole),
        ):
            for drawn in source:
                if self.covers(drawn):
                    return [drawn]
                if drawn.piece.shares_piece(whole):
                    tried.append(drawn)
            chosen = choose_cover(whole, [(d.piece, k) for k, d in enumerate(tried)])
            if chosen is not None:
                return [tried[k] for k in chosen]
        raise ExactSweepError("no feature of the generatrix draws this edge")


class Tracer:
    """The features of G and of the trajectory, for look-ups of those that draw.

    Args:
        path: the trajectory of G's origin.
        generatrix: the features of G.
        directions: the directions of all edges to look up, one at least.
    """

    def __init__(self, path: Outline, generatrix: Outline, directions: Iterable[Vector]) -> None:
        self.path, self.generatrix = path, generatrix
        self._edges: dict[Vector, list[tuple[int, Segment]]] = {u: [] for u in directions}
        self._lines: defaultdict[tuple[Vector, Rational], list[Segment]] = defaultdict(list)
        for i, own in enumerate(generatrix.pieces):
            if own.direction in self._edges:
                self._edges[own.direction].append((i, own))
                self._lines[own.direction, own.offset].append(own)
        self._ways: dict[Vector, list[_Way]] = {u: [] for u in self._edges}
        self._ways_on: defaultdict[tuple[Vector, Rational], list[_Way]] = defaultdict(list)
        for k, (u, offset, low, high) in enumerate(path.pieces):
            if u in self._ways:
                self._ways[u].append(_Way(low, k, high, offset, floor(low), ceil(high)))
        for u, ways in self._ways.items():
            ways.sort()
            for way in ways:
                self._ways_on[u, way.offset].append(way)
        self._longest = {
            u: max((w.high - w.low for w in ws), default=0) for u, ws in self._ways.items()
        }
        self._facing: defaultdict[Vector, set[int]] = defaultdict(set)
        used = [u for u, ways in self._ways.items() if ways]
        both_ways = Outline([((0, 0), u) for u in used])
        for k, i in find_facing(both_ways, generatrix, range(2 * len(used))):
            self._facing[used[k // 2]].add(i)
        self._pens: dict[Vector, _Pens] = {}

    def from_ends(self, whole: Segment, ends: Sequence[Vertex]) -> Iterator[DrawnPiece]:
        """Find the edges of G that end, at a vertex of the trajectory, in one of some points."""
        for i, own in self._edges[whole.direction]:
            corners = self.generatrix.edge(i)
            for p in ends:
                for q in corners:
                    k = self.path.numbers.get(minus(p, q))
                    if k is not None:
                        yield self._at(whole, i, own, k)

    def along(self, whole: Segment) -> Iterator[DrawnPiece]:
        """Find the vertices and edges of G that draw along edges of the trajectory, by these."""
        u, offset, whole_low, whole_high = whole
        if not self._ways[u]:
            return
        first, last = floor(whole_low), ceil(whole_high)
        pens = self._find_pens(u)
        for way in self._find_near(whole, pens):
            # Ints decide quickly which features come near the edge.
            low, high = first - way.ceiling, last - way.floor
            for feature, (_, _, start, end) in pens.by_offset.get(offset - way.offset, ()):
                if start < high and low < end:
                    piece = Segment(u, offset, way.low + start, way.high + end)
                    yield DrawnPiece(Feature("edge", way.number), feature, piece)

    def _find_near(self, whole: Segment, pens: _Pens) -> Sequence[_Way]:
        """Find the edges of the trajectory along which a feature may reach an edge, sorted.

        The search looks on each line from which a vertex of G draws the edge, or on all parallel
        lines if these are fewer. On parallel lines, one long edge makes all edges seem near.
        """
        u, line, _, _ = whole
        low, high = whole.low - pens.high, whole.high - pens.low
        ways = self._ways[u]
        first, last = bisect_left(ways, (low - self._longest[u],)), bisect_left(ways, (high,))
        if last - first <= len(pens.by_offset):
            return ways[first:last]
        near: list[_Way] = []
        for offset in pens.by_offset:
            on_line = self._ways_on.get((u, line - offset), [])
            near += on_line[bisect_left(on_line, low, key=_high) : bisect_left(on_line, (high,))]
        return sorted(near)

    def _find_pens(self, u: Vector) -> _Pens:
        if u not in self._pens:
            g, edges = self.generatrix, dict(self._edges[u])
            by_offset: defaultdict[Rational, list[tuple[Feature, Segment]]] = defaultdict(list)
            for i in sorted(self._facing[u].union(edges, (g.after[i] for i in edges))):
                # An edge of G draws all that its first vertex draws.
                feature = Feature("edge" if i in edges else "vertex", i)
                pen = edges[i] if i in edges else lay_point(g.vertices[i], u)
                by_offset[pen.offset].append((feature, pen))
            pens = [pen for line in by_offset.values() for _, pen in line]
            low, high = min(pen.low for pen in pens), max(pen.high for pen in pens)
            self._pens[u] = _Pens(by_offset, low, high)
        return self._pens[u]

    def at_vertices(self, whole: Segment) -> Iterator[DrawnPiece]:
        """Find the edges of G that draw at vertices of the trajectory, by the edges."""
        u = whole.direction
        for i, own in self._edges[u]:
            line = whole.offset - own.offset
            low, high = whole.low - own.high, whole.high - own.low
            # A vertical line has one x, that of its points times -1.
            near = self.path.vertices_between(*((low, high) if u[0] else (-line, -line)))
            vertices = [(self.path.vertices[k], k) for k in near]
            places = [(measure_along(u, t), k) for t, k in vertices if find_offset(u, t) == line]
            for along, k in sorted(places):
                if low < along < high:
                    yield self._at(whole, i, own, k)

    def _at(self, whole: Segment, i: int, own: Segment, k: int) -> DrawnPiece:
        along = measure_along(own.direction, self.path.vertices[k])
        piece = Segment(own.direction, whole.offset, own.low + along, own.high + along)
        return DrawnPiece(Feature("vertex", k), Feature("edge", i), piece)

    def is_covered_at(self, whole: Segment, k: int) -> bool:
        """Decide whether an edge of G covers an edge of a loop at vertex k of the trajectory."""
        u, t = whole.direction, self.path.vertices[k]
        along = measure_along(u, t)
        return any(
            own.low + along <= whole.low and whole.high <= own.high + along
            for own in self._lines.get((u, whole.offset - find_offset(u, t)), ())
        )

    def find_slide(self, whole: Segment) -> list[Vertex]:
        """Find where on an edge of the trajectory an edge of G covers an edge of a loop.

        Returns the two ends of the first piece of positive length; if there is none, the first
        single position, if any.
        """
        u = whole.direction
        single: list[Vertex] = []
        for _, own in self._edges[u]:
            low, high = whole.high - own.high, whole.low - own.low
            ways = self._ways_on.get((u, whole.offset - own.offset), [])
            # The trajectory may touch the range in an end, and return into it.
            nearest = bisect_left(ways, low, key=_high)
            for way in ways[nearest : nearest + 2]:
                first, last = max(low, way.low), min(high, way.high)
                if first <= last:
                    ends = [self.path.pieces[way.number].point(x) for x in (first, last)]
                    if first < last:
                        return ends
                    single = single or ends[:1]
        return single


def _high(way: _Way) -> Rational:
    return way.high


def find_drawn_edges(edges: Sequence[Edge], path: Outline, generatrix: Outline) -> list[DrawnEdge]:
    """Prepare the search for the features of G that draw edges of the loops.

    Args:
        edges: edges of the loops, or pieces of them.
        path: the trajectory of G's origin.
        generatrix: the features of G.

    Cost: O((t + m) log(t + m)) for t edges of the trajectory and m of G, plus the pairs that
    `find_facing` finds for the directions of the edges.
    """
    pieces = list(map(make_segment, edges))
    tracer = Tracer(path, generatrix, dict.fromkeys(piece.direction for piece in pieces))
    return [DrawnEdge(edge, whole, tracer) for edge, whole in zip(edges, pieces, strict=True)]
