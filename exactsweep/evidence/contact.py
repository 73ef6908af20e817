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
from collections.abc import Iterable, Iterator, Sequence
from itertools import accumulate, pairwise
from math import inf, lcm
from typing import Literal, NamedTuple

from exactsweep.geometry.direction import Vector
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.region import AnyPolygon
from exactsweep.geometry.segment import Segment, find_direction, lay_point, make_segment
from exactsweep.geometry.vectors import cross
from exactsweep.numbers.number import Edge, Rational, Vertex

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
    lines: defaultdict[tuple[Vector, Rational], list[tuple[Rational, int, Segment]]]
    lines = defaultdict(list)
    for k, piece in enumerate(map(make_segment, edges)):
        lines[piece.direction, piece.offset].append((piece.low, k, piece))
    reaches = {}
    for line, pieces in lines.items():
        pieces.sort()
        reaches[line] = list(accumulate((piece.high for _, _, piece in pieces), max))
    directions = {u for u, _ in lines}
    found: list[set[Contact]] = [set() for _ in edges]

    def note(event: Event, i: int, j: int, mine: Segment, theirs: Segment) -> None:
        """Note a contact of two parallel features for all edges along which it lasts."""
        line = mine.direction, theirs.offset - mine.offset
        if line in reaches:
            touching, pieces = theirs.minus(mine), lines[line]
            for number in range(bisect_right(reaches[line], touching.low), len(pieces)):
                low, k, piece = pieces[number]
                if low >= touching.high:
                    break
                if touching.shares_piece(piece):
                    found[k].add(Contact(event, i, j))

    ours, theirs = (
        [k for k, piece in enumerate(shape.pieces) if piece.direction in directions]
        for shape in (generatrix, directrix)
    )
    for i, vertex in find_facing(generatrix, directrix, ours):
        for j in directrix.twins(vertex):
            mine = generatrix.pieces[i]
            note("EV", i, j, mine, lay_point(directrix.vertices[j], mine.direction))
    for j, vertex in find_facing(directrix, generatrix, theirs):
        for i in generatrix.twins(vertex):
            other = directrix.pieces[j]
            note("VE", i, j, lay_point(generatrix.vertices[i], other.direction), other)
    # Both run with their shape on the left, so facing edges have opposite orientations.
    parallel: defaultdict[tuple[Vector, bool], list[int]] = defaultdict(list)
    for j in theirs:
        parallel[directrix.pieces[j].direction, directrix.backward[j]].append(j)
    for i in ours:
        mine = generatrix.pieces[i]
        u = mine.direction
        for j in parallel[u, not generatrix.backward[i]]:
            other = directrix.pieces[j]
            note("EE", i, j, mine, other)
            # Where rings touch, a vertex may lie inside an edge.
            for k in directrix.vertices_inside(j):
                note("EV", i, k, mine, lay_point(directrix.vertices[k], u))
            for k in generatrix.vertices_inside(i):
                note("VE", k, j, lay_point(generatrix.vertices[k], u), other)
    return [sorted(_without_parts(at, generatrix, directrix)) for at in found]


def find_translations(contact: Contact, generatrix: Outline, directrix: Outline) -> Segment:
    """Return the translations at which an EV, VE or EE contact lasts. Cost: O(1)."""
    event, i, j = contact
    ours, theirs = generatrix.edge(i), directrix.edge(j)
    u = find_direction(ours if event[0] == "E" else theirs)
    mine = make_segment(ours, u) if event[0] == "E" else lay_point(ours[0], u)
    return (make_segment(theirs, u) if event[1] == "E" else lay_point(theirs[0], u)).minus(mine)


def _without_parts(contacts: set[Contact], g: Outline, d: Outline) -> set[Contact]:
    """Drop each EV and VE contact whose vertex is an end of an edge in an EE contact."""
    implied = set()
    for event, i, j in contacts:
        if event == "EE":
            implied |= {Contact("EV", i, j), Contact("EV", i, d.after[j])}
            implied |= {Contact("VE", i, j), Contact("VE", g.after[i], j)}
    return contacts - implied


def find_contacts(generatrix: Outline, directrix: Outline, t: Vertex) -> list[Contact]:
    """Find all contacts of G + t with D, VV among them.

    Args:
        generatrix: the features of G.
        directrix: the features of D.
        t: a translation.

    Returns:
        Sorted contacts: VV of equal vertices; EV and VE of a vertex inside an edge; EE of edges
        that overlap in positive length.

    Cost: O((m + n) log(m + n)) where few edges are near each vertex, O(m n) at worst.
    """
    # On a lattice with the translation all numbers are ints, which is ten times as fast.
    scale = lcm(t[0].denominator, t[1].denominator)
    tx, ty = int(scale * t[0]), int(scale * t[1])
    found: set[Contact] = set()
    for i, (x, y) in enumerate(generatrix.vertices):
        point = x * scale + tx, y * scale + ty
        # Where rings touch, a point may be a vertex of one and inside an edge of another.
        found.update(Contact("VV", i, j) for j in directrix.vertices_at(point, scale))
        found.update(Contact("VE", i, j) for j in directrix.edges_through(point, scale))
    for j, (x, y) in enumerate(directrix.vertices):
        point = x * scale - tx, y * scale - ty
        found.update(Contact("EV", i, j) for i in generatrix.edges_through(point, scale))
    # The common part of two edges has an end towards the start of G's edge. It is that start or an
    # end of D's edge, so one of the contacts above.
    for event, i, j in list(found):
        piece = make_segment(generatrix.edge(i))
        for d in [j] if event == "VE" else [j, directrix.before[j]]:
            other = make_segment(directrix.edge(d))
            if piece.direction == other.direction:
                touching, place = other.minus(piece), lay_point(t, piece.direction)
                if touching.offset == place.offset and touching.shares_piece(place):
                    found.add(Contact("EE", i, d))
    return sorted(found)


def find_facing(
    shape: Outline, outline: Outline, numbers: Iterable[int]
) -> Iterator[tuple[int, int]]:
    """Find the pairs of an edge and a vertex that can touch without overlap.

    Args:
        shape: the features of a polygon.
        outline: those of the other polygon, no three neighbours collinear.
        numbers: the numbers of the edges of the first polygon.

    Returns:
        (number of the edge, number of the vertex).

    Cost: O((m + n) log n + pairs) for n edges and m vertices.

    >>> square, steep = Outline([[(0, 0), (1, 0), (1, 1), (0, 1)]]), Outline([[(1, 0), (0, 1)]])
    >>> sorted(find_facing(square, square, [0])), sorted(find_facing(steep, square, [0]))
    ([(0, 2), (0, 3)], [(0, 0)])
    """
    # Slopes of edges no wider than 2**n differ by 4**-n, so ints in that unit have their order.
    widths = [piece.direction[0] for o in (shape, outline) for piece in o.pieces]
    bits = 2 * max(widths).bit_length()

    def angle(o: Outline, k: int, *, turned: bool) -> tuple[bool, float]:
        """Return a key that orders directed edges by angle, from -90 degrees, exclusive."""
        a, b = o.pieces[k].direction
        return o.backward[k] != turned, (b << bits) // a if a else inf

    order = sorted((angle(shape, i, turned=True), i) for i in numbers)
    angles = [key for key, _ in order]
    ways = [angle(outline, k, turned=False) for k in range(len(outline.vertices))]
    for j, into in enumerate(outline.before):
        first, last = ways[into], ways[j]
        if (cross(outline.pieces[into].direction, outline.pieces[j].direction) > 0) == (
            first[0] == last[0]
        ):
            start, end = bisect_left(angles, first), bisect_right(angles, last)
            found = order[start:end] if first <= last else order[start:] + order[:end]
            for _, i in found:
                yield i, j
