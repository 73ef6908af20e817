"""Contact events: which features of G and D touch (Table 1, Lemma A.1).

An edge of the trajectory is a piece of a segment of translations at which two features touch: EV
(edge e of G on vertex v of D): v - e; VE (vertex w of G on edge d of D): d - w; EE (parallel
edges): d - e. All of the trajectory is free of overlap. So two features are in contact along the
edge if their segment shares a piece with it. Look-ups of lines find all pairs that can touch
without overlap (see `find_facing`), without regard to how the trajectory was computed.

An edge e touches a vertex v from outside only if both edges at v run on the other side of the line
through e. Then v is convex, and the direction of the reversed e lies between those of the two
edges. For two convex polygons this leaves one vertex for each edge, or two if edges are parallel.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from math import lcm
from typing import Any, Literal, NamedTuple

from exactsweep.geometry.direction import Vector, angle_key
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.region import AnyPolygon
from exactsweep.geometry.segment import Segment, find_direction, find_offset, make_segment
from exactsweep.geometry.vectors import is_between, minus
from exactsweep.numbers.point import Edge, Rational, Vertex

Event = Literal["EE", "EV", "VE", "VV"]


class Contact(NamedTuple):
    """Two features that touch.

    Attributes:
        event: "EV", "VE", "EE" or "VV", with the feature of the generatrix first (Table 1).
        generatrix: the index of the vertex of G, or of the first vertex of the edge of G.
        directrix: the same for D.
    """

    event: Event
    generatrix: int
    directrix: int


def number_as_given(shape: AnyPolygon, outline: Outline, k: int, *, of_edge: bool) -> int:
    """Return the index in the caller's input of feature k of an outline.

    Args:
        shape: a shape.
        outline: the features of the shape, with holes clockwise.
        k: the number of a vertex or of an edge.
        of_edge: whether k is an edge.
    """
    if k >= len(shape.exterior):
        # Vertex 0 of a hole is the same in both orientations; its edge k ends where the input edge
        # starts.
        ring = bisect_right(outline.starts, k)
        first, size = outline.starts[ring - 1], len(shape.holes[ring - 2])
        k = first + (first - (outline.after[k] if of_edge else k)) % size
    return shape.edge_index(k) if of_edge else shape.vertex_index(k)


def list_edges(loop: Sequence[Vertex]) -> list[Edge]:
    """List the edges of a loop, edge k from vertex k to vertex k + 1."""
    return list(pairwise([*loop, *loop[:1]]))


def find_edge_contacts(
    edges: Sequence[Edge], generatrix: Outline, directrix: Outline
) -> list[list[Contact]]:
    """Find all contacts along each edge of a trajectory or another loop of free translations.

    Args:
        edges: the edges, in the order of travel.
        generatrix: the features of G.
        directrix: the features of D.

    Returns:
        For each edge, the sorted contacts that last along a piece of positive length. The list
        omits an EV or VE contact that is part of an EE contact.

    Cost: O((t + m + n) log(t + m + n)) for t edges, plus a look-up in O(log t) for each pair that
    can touch without overlap. Convex polygons have O(m + n) such pairs, others O(m n).
    """
    lines: defaultdict[tuple[Vector, Rational], list[tuple[Segment, int]]] = defaultdict(list)
    for k, edge in enumerate(edges):
        piece = make_segment(edge)
        lines[piece.direction, piece.offset].append((piece, k))
    for line in lines.values():
        line.sort(key=_low)
    longest = {key: max(p.high - p.low for p, _ in line) for key, line in lines.items()}
    found: list[set[Contact]] = [set() for _ in edges]

    def note(event: Event, i: int, j: int, u: Vector, first: Vertex, last: Vertex) -> None:
        key = u, find_offset(u, first)
        if key not in lines:
            return
        touching = make_segment((first, last), u)
        # If a line has many pieces, test only those nearby.
        line = lines[key]
        start = bisect_left(line, touching.low - longest[key], key=_low)
        for piece, k in line[start : bisect_right(line, touching.high, key=_low)]:
            if touching.shares_piece(piece):
                found[k].add(Contact(event, i, j))

    directions = {direction for direction, _ in lines}
    g_along, d_along = (
        {k: u for k, edge in enumerate(shape.edges) if (u := find_direction(edge)) in directions}
        for shape in (generatrix, directrix)
    )
    g_edges, d_edges = (
        {k: shape.edge(k) for k in along_edge}
        for shape, along_edge in ((generatrix, g_along), (directrix, d_along))
    )
    parallel: defaultdict[Vector, list[int]] = defaultdict(list)
    for j, u in d_along.items():
        parallel[u].append(j)
    for i, (p, q) in g_edges.items():
        for j in parallel[g_along[i]]:
            r, s = d_edges[j]
            # Both run with their shape on the left, so facing edges have opposite directions.
            if (p < q) != (r < s):
                note("EE", i, j, g_along[i], minus(r, p), minus(s, q))
                # Where rings touch, a vertex may lie inside an edge.
                for k in directrix.vertices_inside(j):
                    v = directrix.vertices[k]
                    note("EV", i, k, g_along[i], minus(v, p), minus(v, q))
                for k in generatrix.vertices_inside(i):
                    w = generatrix.vertices[k]
                    note("VE", k, j, g_along[i], minus(r, w), minus(s, w))
    for i, j in find_facing(g_edges, directrix):
        (p, q), v = g_edges[i], directrix.vertices[j]
        for k in directrix.vertices_at(v):
            note("EV", i, k, g_along[i], minus(v, p), minus(v, q))
    for j, i in find_facing(d_edges, generatrix):
        (r, s), w = d_edges[j], generatrix.vertices[i]
        for k in generatrix.vertices_at(w):
            note("VE", k, j, d_along[j], minus(r, w), minus(s, w))
    return [sorted(_without_parts(c, generatrix, directrix)) for c in found]


def _low(item: tuple[Segment, int]) -> Rational:
    return item[0].low


def _without_parts(contacts: set[Contact], g: Outline, d: Outline) -> set[Contact]:
    """Drop each EV and VE contact whose vertex is an end of an edge in an EE contact."""
    implied = set()
    for event, i, j in contacts:
        if event == "EE":
            implied |= {Contact("EV", i, j), Contact("EV", i, d.after[j])}
            implied |= {Contact("VE", i, j), Contact("VE", g.after[i], j)}
    return contacts - implied


class MonotoneOutline(Outline):
    """The outline of an X-monotone polygon, with fast look-ups of features at a point.

    Args:
        loop: vertices, counter-clockwise; they number the features.
    """

    def __init__(self, loop: Sequence[Vertex]) -> None:
        super().__init__([loop])
        size = len(loop)
        left, right = min(range(size), key=loop.__getitem__), max(range(size), key=loop.__getitem__)
        self._chains = []
        for start, end, sign in (left, right, 1), (right, left, -1):
            numbers = [k % size for k in range(start, start + (end - start) % size)]
            self._chains.append((sign, [sign * loop[k][0] for k in numbers], numbers))

    def scaled(self, factor: int) -> MonotoneOutline:
        """Return the boundary enlarged by a positive factor. Cost: O(n)."""
        return MonotoneOutline([(factor * x, factor * y) for x, y in self.vertices])

    def edges_through(self, point: Vertex) -> Iterator[int]:
        """Find the numbers of the edges with a point in their interior. Cost: O(log n)."""
        for sign, xs, numbers in self._chains:
            x = sign * point[0]
            first = max(bisect_left(xs, x) - 1, 0)
            for k in numbers[first : bisect_right(xs, x)]:
                if is_between(point, *self.edge(k)):
                    yield k


def find_contacts(generatrix: Outline, directrix: Outline, t: Vertex) -> list[Contact]:
    """Find all contacts of G + t with D, VV among them.

    Args:
        generatrix: the features of G.
        directrix: the features of D.
        t: a translation.

    Returns:
        Sorted contacts: VV of equal vertices; EV and VE of a vertex inside an edge; EE of edges
        that overlap in positive length.

    Cost: O((m + n) log(m + n)) for two MonotoneOutlines, O(m n) for others.
    """
    scale = lcm(t[0].denominator, t[1].denominator)
    if scale > 1:
        # On a lattice with the translation all numbers are ints, which is ten times as fast.
        generatrix, directrix = generatrix.scaled(scale), directrix.scaled(scale)
    t = int(scale * t[0]), int(scale * t[1])
    found: set[Contact] = set()
    for i, w in enumerate(generatrix.vertices):
        point = w[0] + t[0], w[1] + t[1]
        # Where rings touch, a point may be a vertex of one and inside an edge of another.
        found.update(Contact("VV", i, j) for j in directrix.vertices_at(point))
        found.update(Contact("VE", i, j) for j in directrix.edges_through(point))
    for j, v in enumerate(directrix.vertices):
        found.update(Contact("EV", i, j) for i in generatrix.edges_through(minus(v, t)))
    # The common part of two edges has an end towards the start of G's edge. It is that start or an
    # end of D's edge, so one of the contacts above.
    for event, i, j in list(found):
        piece = make_segment(generatrix.edge(i))
        for d in [j] if event == "VE" else [j, directrix.before[j]]:
            other = make_segment(directrix.edge(d))
            if piece.direction == other.direction:
                moved = piece.moved(t)
                if moved.offset == other.offset and moved.shares_piece(other):
                    found.add(Contact("EE", i, d))
    return sorted(found)


def find_facing(edges: Mapping[int, Edge], outline: Outline) -> Iterator[tuple[int, int]]:
    """Find the pairs of an edge and a vertex that can touch without overlap.

    Args:
        edges: the edges of a polygon by number, with the interior on the left.
        outline: the other polygon, no three neighbours collinear.

    Returns:
        (number of the edge, index of the vertex).

    Cost: O((m + n) log n + pairs) for n edges and m vertices.

    >>> square = Outline([[(0, 0), (1, 0), (1, 1), (0, 1)]])
    >>> sorted(find_facing({0: ((0, 0), (1, 0)), 1: ((1, 0), (0, 1))}, square))
    [(0, 2), (0, 3), (1, 0)]
    """
    order = sorted((_angle((q, p)), i) for i, (p, q) in edges.items())
    angles = [angle for angle, _ in order]
    for j, v in enumerate(outline.vertices):
        before, after = outline.vertices[outline.before[j]], outline.vertices[outline.after[j]]
        if (v[0] - before[0]) * (after[1] - v[1]) <= (v[1] - before[1]) * (after[0] - v[0]):
            continue
        first, last = _angle((before, v)), _angle((v, after))
        start, end = bisect_left(angles, first), bisect_right(angles, last)
        found = order[start:end] if first <= last else order[start:] + order[:end]
        for _, i in found:
            yield i, j


def _angle(edge: Edge) -> tuple[bool, Any]:
    """Return a key that orders directed edges by angle, from -90 degrees, exclusive."""
    (px, py), (qx, qy) = edge
    backward = qx < px or (qx == px and qy < py)
    return backward, angle_key(find_direction(edge))
