"""What draws the loops: the features of G that trace their edges, and the positions of G.

Both loops are drawn by G moving along the trajectory T. An edge of a loop is a piece of an edge
of G at a vertex of T, of the path of a vertex of G along an edge of T, or of the path of an edge
of G along an edge of T parallel to it. Several may be needed for one edge: what D's edge shows of
itself to the inner loop can be touched by one vertex of G after the other.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from operator import itemgetter
from typing import Literal, NamedTuple

from exactsweep.evidence.contact import minus
from exactsweep.geometry.direction import Vector
from exactsweep.geometry.error import ExactSweepError
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.point import Edge, Rational, Vertex
from exactsweep.geometry.segment import (
    Segment,
    choose_cover,
    find_offset,
    make_segment,
    measure_along,
)


class Feature(NamedTuple):
    """A vertex or an edge of a loop, by number; edge k runs from vertex k to vertex k + 1."""

    kind: Literal["vertex", "edge"]
    number: int


class Trace(NamedTuple):
    """A feature of G, and the vertex or edge of the trajectory along which it draws."""

    position: Feature
    feature: Feature


class Tracer:
    """Finds what draws the edges of the loops of one sweep.

    Args:
        path: the trajectory of G's origin.
        generatrix: the features of G.
    """

    def __init__(self, path: Outline, generatrix: Outline) -> None:
        self._path = path
        self._generatrix = generatrix
        self._g_edges: defaultdict[Vector, list[tuple[int, Edge, Segment]]] = defaultdict(list)
        self._g_lines: defaultdict[tuple[Vector, Rational], list[Segment]] = defaultdict(list)
        self._g_corners: defaultdict[frozenset[Vector], list[Vertex]] = defaultdict(list)
        segments = [make_segment(edge) for edge in generatrix.edges]
        for i, (edge, own) in enumerate(zip(generatrix.edges, segments, strict=True)):
            self._g_edges[own.direction].append((i, edge, own))
            self._g_lines[own.direction, own.offset].append(own)
            corner = frozenset((segments[generatrix.before[i]].direction, own.direction))
            self._g_corners[corner].append(edge[0])
        self._paths: defaultdict[Vector, list[tuple[Segment, int]]] = defaultdict(list)
        self._lines: defaultdict[tuple[Vector, Rational], list[tuple[Segment, int]]] = defaultdict(
            list
        )
        pieces = [(make_segment(edge), k) for k, edge in enumerate(path.edges)]
        # On one line, edges of a simple loop follow each other.
        for piece, k in sorted(pieces, key=lambda item: item[0].low):
            self._paths[piece.direction].append((piece, k))
            self._lines[piece.direction, piece.offset].append((piece, k))
        self._longest = {u: max(s.high - s.low for s, _ in p) for u, p in self._paths.items()}
        self._g_by_offset: dict[Vector, defaultdict[Rational, list[int]]] = {}
        self._t_by_offset: dict[Vector, defaultdict[Rational, list[tuple[Rational, int]]]] = {}

    def trace(self, edge: Edge) -> list[Trace]:
        """Return features that together draw an edge of the inner or of the outer loop.

        Tried in this order, until the edge is covered: edges of G that end where it ends; vertices
        and edges of G along edges of the trajectory; edges of G at all vertices of it.

        Raises ValueError when nothing draws the edge: it is not one of this sweep's.
        """
        whole = make_segment(edge)
        pieces: list[tuple[Segment, int]] = []
        traces: list[Trace] = []
        for source in (self._from_ends(edge, whole), self._paths_of(whole), self._at_all(whole)):
            for piece, trace in source:
                if piece.offset == whole.offset and piece.shares_piece(whole):
                    pieces.append((piece, len(traces)))
                    traces.append(trace)
            chosen = choose_cover(whole, pieces)
            if chosen is not None:
                return [traces[k] for k in chosen]
        raise ExactSweepError("no feature of the generatrix draws this edge")

    def ends_of(self, position: Feature) -> list[Vertex]:
        """The translation of a vertex of the trajectory, or the two ends of an edge."""
        k = position.number
        if position.kind == "edge":
            return list(self._path.edge(k))
        return [self._path.vertices[k]]

    def closing_range(self, edge: Edge) -> tuple[Vertex, Vertex] | None:
        """Where one edge of G covers a straight bottom chain, G being on an edge of the trajectory.

        Returns the two ends of that piece, which may be equal, or None if there is none.
        """
        whole = make_segment(edge)
        u = whole.direction
        for _, _, own in self._g_edges.get(u, ()):
            low, high = whole.high - own.high, whole.low - own.low
            paths = self._lines.get((u, whole.offset - own.offset), [])
            nearest = bisect_left(paths, low, key=lambda item: item[0].high)
            for path, k in paths[nearest : nearest + 1]:
                first, last = max(low, path.low), min(high, path.high)
                if first <= last:
                    p, q = self._path.edge(k)
                    return _at(p, q, first, u), _at(p, q, last, u)
        return None

    def covering_position(self, chain: Sequence[Vertex]) -> Vertex | None:
        """A translation on the trajectory at which G's boundary covers a chain, if there is one.

        Then each corner of the chain is a vertex of G, between edges of the same directions.
        Cost: O(s) for s edges of the chain and each such vertex, and O(t) to find a translation on
        the trajectory.
        """
        wholes = [make_segment(edge) for edge in pairwise(chain)]
        for w in self._g_corners.get(frozenset(whole.direction for whole in wholes[:2]), ()):
            t = minus(chain[1], w)
            if all(self._covers(whole, t) for whole in wholes) and self._passes(t):
                return t
        return None

    def _covers(self, whole: Segment, t: Vertex) -> bool:
        line = whole.direction, whole.offset - find_offset(whole.direction, t)
        own = self._g_lines.get(line, ())
        return choose_cover(whole, [(piece.moved(t), 0) for piece in own]) is not None

    def _passes(self, t: Vertex) -> bool:
        return t in self._path.numbers or any(True for _ in self._path.edges_through(t))

    def _from_ends(self, edge: Edge, whole: Segment) -> Iterator[tuple[Segment, Trace]]:
        for i, ends, own in self._g_edges.get(whole.direction, ()):
            for p in edge:
                for q in ends:
                    t = minus(p, q)
                    k = self._path.numbers.get(t)
                    if k is not None:
                        yield own.moved(t), Trace(Feature("vertex", k), Feature("edge", i))

    def _paths_of(self, whole: Segment) -> Iterator[tuple[Segment, Trace]]:
        u = whole.direction
        paths = self._paths.get(u)
        if not paths:
            return
        by_offset = self._vertices_by_offset(u)
        span = [measure_along(u, w) for w in self._generatrix.vertices]
        low = whole.low - max(span) - self._longest[u]
        high = whole.high - min(span)
        first = bisect_left(paths, low, key=lambda item: item[0].low)
        last = bisect_right(paths, high, key=lambda item: item[0].low)
        for path, k in paths[first:last]:
            ends = by_offset.get(whole.offset - path.offset, ())
            for i in ends:
                w = self._generatrix.vertices[i]
                position = Feature("edge", k)
                if self._generatrix.after[i] in ends:
                    own = make_segment(self._generatrix.edge(i), u)
                    total = Segment(u, whole.offset, path.low + own.low, path.high + own.high)
                    yield total, Trace(position, Feature("edge", i))
                else:
                    yield path.moved(w), Trace(position, Feature("vertex", i))

    def _vertices_by_offset(self, u: Vector) -> defaultdict[Rational, list[int]]:
        if u not in self._g_by_offset:
            self._g_by_offset[u] = defaultdict(list)
            for i, w in enumerate(self._generatrix.vertices):
                self._g_by_offset[u][find_offset(u, w)].append(i)
        return self._g_by_offset[u]

    def _at_all(self, whole: Segment) -> Iterator[tuple[Segment, Trace]]:
        u = whole.direction
        if u not in self._g_edges:
            return
        by_offset = self._positions_by_offset(u)
        for i, _, own in self._g_edges[u]:
            positions = by_offset.get(whole.offset - own.offset, [])
            first = bisect_right(positions, whole.low - own.high, key=itemgetter(0))
            last = bisect_left(positions, whole.high - own.low, key=itemgetter(0))
            for _, k in positions[first:last]:
                moved = own.moved(self._path.vertices[k])
                yield moved, Trace(Feature("vertex", k), Feature("edge", i))

    def _positions_by_offset(self, u: Vector) -> defaultdict[Rational, list[tuple[Rational, int]]]:
        """The vertices of the trajectory by their lines in a direction, in order along these."""
        if u not in self._t_by_offset:
            found = self._t_by_offset[u] = defaultdict(list)
            for k, t in enumerate(self._path.vertices):
                found[find_offset(u, t)].append((measure_along(u, t), k))
            for positions in found.values():
                positions.sort()
        return self._t_by_offset[u]


def _at(p: Vertex, q: Vertex, coordinate: Rational, u: Vector) -> Vertex:
    """The point of the line p q with a coordinate along it."""
    share = Fraction(coordinate - measure_along(u, p)) / (measure_along(u, q) - measure_along(u, p))
    return p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])
