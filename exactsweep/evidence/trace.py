"""Search for the features of G that draw the edges of the loops, and their positions.

G draws both loops as it moves along the trajectory T. An edge of a loop is a piece of an edge of G
at a vertex of T, of the path of a vertex of G along an edge of T, or of the path of an edge of G
along a parallel edge of T. One edge of a loop may need several features: one vertex of G after the
other may touch the same edge of D.

If the path of a vertex of G is on a loop, the vertex is convex, and G near it lies on one side of
the path, because G stays inside the outer loop and outside the inner one. For two convex polygons
this leaves two or four vertices for each direction of T.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import ceil, floor
from typing import Literal, NamedTuple

from exactsweep.evidence.contact import find_facing
from exactsweep.geometry.direction import Vector
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.segment import (
    Segment,
    choose_cover,
    find_offset,
    make_segment,
    measure_along,
)
from exactsweep.geometry.vectors import minus
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.point import ORIGIN, Edge, Rational, Vertex

FeatureKind = Literal["vertex", "edge"]


class Feature(NamedTuple):
    """A vertex or an edge of a loop, by number; edge k runs from vertex k to vertex k + 1."""

    kind: FeatureKind
    number: int


class Trace(NamedTuple):
    """A feature of G, and the vertex or edge of the trajectory along which it draws."""

    position: Feature
    feature: Feature


class Tracer:
    """A finder of the features that draw the loops of one sweep.

    Args:
        path: the trajectory of G's origin.
        generatrix: the features of G.
    """

    def __init__(self, path: Outline, generatrix: Outline) -> None:
        self._path = path
        self._generatrix = generatrix
        self._g_edges: defaultdict[Vector, list[tuple[int, Edge, Segment]]] = defaultdict(list)
        self._g_lines: defaultdict[tuple[Vector, Rational], list[Segment]] = defaultdict(list)
        self._g_corners: defaultdict[frozenset[Vector], list[int]] = defaultdict(list)
        segments = [make_segment(edge) for edge in generatrix.edges]
        for i, (edge, own) in enumerate(zip(generatrix.edges, segments, strict=True)):
            self._g_edges[own.direction].append((i, edge, own))
            self._g_lines[own.direction, own.offset].append(own)
            corner = frozenset((segments[generatrix.before[i]].direction, own.direction))
            self._g_corners[corner].append(i)
        # The key is the direction, and the fractional part of the offset of the line. If G is on
        # the lattice, a move along a line only reaches lines at distances of whole units.
        self._is_on_lattice = all(type(c) is int for w in generatrix.vertices for c in w)
        self._path_residues = {(x % 1, y % 1) for x, y in path.vertices}
        self._paths: defaultdict[tuple[Vector, Rational], list[_PathPiece]] = defaultdict(list)
        self._lines: defaultdict[tuple[Vector, Rational], list[_PathPiece]] = defaultdict(list)
        pieces = [(make_segment(edge), k) for k, edge in enumerate(path.edges)]
        # The edges of a simple loop on one line follow each other.
        for piece, k in sorted(pieces, key=lambda item: item[0].low):
            path_piece = _PathPiece(piece, k, floor(piece.low), ceil(piece.high))
            self._paths[self._path_key(piece)].append(path_piece)
            self._lines[piece.direction, piece.offset].append(path_piece)
        self._longest = {key: max(s.high - s.low for s, *_ in p) for key, p in self._paths.items()}
        self._g_vertices: dict[Vector, _LinedVertices] = {}
        self._g_facing: defaultdict[Vector, set[int]] = defaultdict(set)
        directions = list({direction for direction, _ in self._paths})
        both_ways: list[Edge] = [edge for u in directions for edge in ((ORIGIN, u), (u, ORIGIN))]
        for way, i in find_facing(dict(enumerate(both_ways)), generatrix):
            self._g_facing[directions[way // 2]].add(i)

    def trace(self, edge: Edge) -> list[Trace]:
        """Return features that together draw an edge of the inner or of the outer loop.

        The search tries, in this order, until it has covered the edge: edges of G with an end in
        common; vertices and edges of G along edges of the trajectory; edges of G at all vertices of
        the trajectory.

        Raises ValueError if nothing draws the edge, because it does not belong to this sweep.
        """
        whole = make_segment(edge)
        pieces: list[tuple[Segment, int]] = []
        traces: list[Trace] = []
        # All pieces found lie on the line of the edge.
        for source in (self._from_ends(edge, whole), self._paths_of(whole), self._at_all(whole)):
            for piece, trace in source:
                if piece.shares_piece(whole):
                    if piece.low <= whole.low and whole.high <= piece.high:
                        return [trace]
                    pieces.append((piece, len(traces)))
                    traces.append(trace)
            chosen = choose_cover(whole, pieces)
            if chosen is not None:
                return [traces[k] for k in chosen]
        raise ExactSweepError("no feature of the generatrix draws this edge")

    def ends_of(self, position: Feature) -> list[Vertex]:
        """Return the translation of a vertex of the trajectory, or the two ends of an edge."""
        k = position.number
        if position.kind == "edge":
            return list(self._path.edge(k))
        return [self._path.vertices[k]]

    def closing_range(self, edge: Edge) -> tuple[Vertex, Vertex] | None:
        """Find where on an edge of the trajectory an edge of G covers a straight bottom chain.

        Returns the two ends of the longest such piece, which may be equal; None if there is no
        piece.
        """
        whole = make_segment(edge)
        u = whole.direction
        closed_in: Vertex | None = None
        for _, _, own in self._g_edges.get(u, ()):
            low, high = whole.high - own.high, whole.low - own.low
            paths = self._lines.get((u, whole.offset - own.offset), [])
            # The trajectory may touch the range in an end, and return into it.
            nearest = bisect_left(paths, low, key=_high)
            for path, k, _, _ in paths[nearest : nearest + 2]:
                first, last = max(low, path.low), min(high, path.high)
                if first <= last:
                    p, q = self._path.edge(k)
                    if first < last:
                        return _at(p, q, first, u), _at(p, q, last, u)
                    closed_in = closed_in or _at(p, q, first, u)
        return closed_in and (closed_in, closed_in)

    def covering_position(self, chain: Sequence[Vertex]) -> Vertex | None:
        """Find a translation on the trajectory at which G's boundary covers a chain, if any.

        At this translation each corner of the chain is a vertex of G between edges of the same
        directions, and the chain follows the boundary of G from corner to corner.

        Cost: O(s) for s edges of the chain and each such vertex, and O(t) to find a translation on
        the trajectory.
        """
        first, second, last = (make_segment((chain[k], chain[k + 1])) for k in (0, 1, -2))
        for i in self._g_corners.get(frozenset((first.direction, second.direction)), ()):
            t = minus(chain[1], self._generatrix.vertices[i])
            if (
                self._follows(i, chain)
                and self._covers(first, t)
                and self._covers(last, t)
                and self._passes(t)
            ):
                return t
        return None

    def _follows(self, i: int, chain: Sequence[Vertex]) -> bool:
        """Compare the corners of a chain with the vertices of G from vertex i on."""
        (first_x, first_y), *others = chain[1:-1]
        (x, d), (y, e) = first_x.as_integer_ratio(), first_y.as_integer_ratio()
        vertices = self._generatrix.vertices
        gx, gy = vertices[i]
        for neighbour in (self._generatrix.after, self._generatrix.before):
            k = i
            for u, v in others:
                k = neighbour[k]
                wx, wy = vertices[k]
                (u, a), (v, b) = u.as_integer_ratio(), v.as_integer_ratio()
                if u * d - x * a != (wx - gx) * a * d or v * e - y * b != (wy - gy) * b * e:
                    break
            else:
                return True
        return False

    def _covers(self, whole: Segment, t: Vertex) -> bool:
        line = whole.direction, whole.offset - find_offset(whole.direction, t)
        own = self._g_lines.get(line, ())
        return choose_cover(whole, [(piece.moved(t), 0) for piece in own]) is not None

    def _passes(self, t: Vertex) -> bool:
        return t in self._path.numbers or any(True for _ in self._path.edges_through(t))

    def _from_ends(self, edge: Edge, whole: Segment) -> Iterator[tuple[Segment, Trace]]:
        ends_of_edge: Sequence[Vertex] = edge
        if self._is_on_lattice:
            # G reaches an end only from a vertex of the trajectory that is whole units away.
            ends_of_edge = [(x, y) for x, y in edge if (x % 1, y % 1) in self._path_residues]
            if not ends_of_edge:
                return
        for i, ends, own in self._g_edges.get(whole.direction, ()):
            for p in ends_of_edge:
                for q in ends:
                    t = minus(p, q)
                    k = self._path.numbers.get(t)
                    if k is not None:
                        yield own.moved(t), Trace(Feature("vertex", k), Feature("edge", i))

    def _paths_of(self, whole: Segment) -> Iterator[tuple[Segment, Trace]]:
        u, key = whole.direction, self._path_key(whole)
        if key not in self._paths:
            return
        vertices = self._vertices_along(u)
        whole_low, whole_high = floor(whole.low), ceil(whole.high)
        for path, k, path_low, path_high in self._paths_near(whole, key, vertices):
            ends = vertices.by_offset.get(whole.offset - path.offset)
            if ends is None:
                continue
            # Ints decide quickly which of the moves along the line come near the edge.
            low, high = whole_low - path_high, whole_high - path_low
            for i, start in ends.items():
                end = ends.get(self._generatrix.after[i])
                feature: FeatureKind = "vertex" if end is None else "edge"
                if end is None:
                    end = start
                elif end < start:
                    start, end = end, start
                if start < high and low < end:
                    total = Segment(u, whole.offset, path.low + start, path.high + end)
                    yield total, Trace(Feature("edge", k), Feature(feature, i))

    def _paths_near(
        self, whole: Segment, key: tuple[Vector, Rational], vertices: _LinedVertices
    ) -> Sequence[_PathPiece]:
        """Find the edges of the trajectory along which a vertex may reach an edge, left to right.

        The search looks on each line from which a vertex of G draws the edge, or on all parallel
        lines if these are fewer. On parallel lines, one long edge makes all edges seem near.
        """
        low, high = whole.low - vertices.high, whole.high - vertices.low
        paths = self._paths[key]
        first = bisect_left(paths, low - self._longest[key], key=_low)
        last = bisect_right(paths, high, key=_low)
        if last - first <= len(vertices.by_offset):
            return paths[first:last]
        near: list[_PathPiece] = []
        for offset in vertices.by_offset:
            line = self._lines.get((whole.direction, whole.offset - offset), [])
            near += line[bisect_left(line, low, key=_high) : bisect_right(line, high, key=_low)]
        return sorted(near, key=lambda path: (path.piece.low, path.number))

    def _path_key(self, piece: Segment) -> tuple[Vector, Rational]:
        return piece.direction, piece.offset % 1 if self._is_on_lattice else 0

    def _vertices_along(self, u: Vector) -> _LinedVertices:
        if u not in self._g_vertices:
            by_offset: defaultdict[Rational, dict[int, Rational]] = defaultdict(dict)
            ends = {k for i, *_ in self._g_edges.get(u, ()) for k in (i, self._generatrix.after[i])}
            for i in sorted(ends | self._g_facing[u]):
                w = self._generatrix.vertices[i]
                by_offset[find_offset(u, w)][i] = measure_along(u, w)
            places = [place for ends in by_offset.values() for place in ends.values()]
            self._g_vertices[u] = _LinedVertices(by_offset, min(places), max(places))
        return self._g_vertices[u]

    def _at_all(self, whole: Segment) -> Iterator[tuple[Segment, Trace]]:
        u = whole.direction
        for i, _, own in self._g_edges.get(u, ()):
            line = whole.offset - own.offset
            low, high = whole.low - own.high, whole.high - own.low
            # A vertical line has one x, that of its points times -1.
            near = self._path.vertices_between(*((low, high) if u[0] else (-line, -line)))
            positions = []
            for k in near:
                t = self._path.vertices[k]
                if find_offset(u, t) == line and low < measure_along(u, t) < high:
                    positions.append((measure_along(u, t), k))
            for _, k in sorted(positions):
                moved = own.moved(self._path.vertices[k])
                yield moved, Trace(Feature("vertex", k), Feature("edge", i))


class _LinedVertices(NamedTuple):
    """The vertices that may draw, by their lines in one direction; by number, their places."""

    by_offset: Mapping[Rational, dict[int, Rational]]
    low: Rational
    high: Rational


class _PathPiece(NamedTuple):
    """An edge of the trajectory, its number, and int bounds of its low and its high end."""

    piece: Segment
    number: int
    floor: int
    ceiling: int


def _low(path: _PathPiece) -> Rational:
    return path.piece.low


def _high(path: _PathPiece) -> Rational:
    return path.piece.high


def _at(p: Vertex, q: Vertex, coordinate: Rational, u: Vector) -> Vertex:
    """Return the point of the line p q with a given coordinate along it."""
    share = Fraction(coordinate - measure_along(u, p)) / (measure_along(u, q) - measure_along(u, p))
    return p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])
