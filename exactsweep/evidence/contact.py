"""Contact events: which features of G and D touch (Table 1, Lemma A.1).

Two features touch at a segment of translations: v - e for EV (edge e of G on vertex v of D); d - w
for VE (vertex w of G on edge d of D); d - e for EE (parallel edges). The trajectory is free of
overlap, so two features are in contact along one of its edges if their segment shares a piece with
it, however the trajectory was computed.
"""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterator, Sequence
from itertools import pairwise, product
from math import lcm
from typing import Literal, NamedTuple

from exactsweep.geometry.direction import Vector
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.region import AnyPolygon
from exactsweep.geometry.segment import Segment, lay_point, make_segment
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
    """Return the index of edge or vertex k of an outline in the input."""
    if k >= len(shape.exterior):
        # The outline reverses a hole, but keeps its vertex 0; edge k ends where the input edge
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

    The contacts of an edge are sorted, and each holds along a piece of positive length. EV and VE
    contacts that are part of an EE contact are omitted. Cost: O(t + m n) for t edges.
    """
    lines: defaultdict[tuple[Vector, Rational], list[tuple[int, Segment]]] = defaultdict(list)
    for k, piece in enumerate(map(make_segment, edges)):
        lines[piece.direction, piece.offset].append((k, piece))
    found: list[set[Contact]] = [set() for _ in edges]
    for contact in _list_parallel(generatrix, directrix, {u for u, _ in lines}):
        lasting = find_translations(contact, generatrix, directrix)
        for k, piece in lines.get(lasting[:2], ()):
            if lasting.shares_piece(piece):
                found[k].add(contact)
    return [sorted(_without_parts(at, generatrix, directrix)) for at in found]


def _list_parallel(g: Outline, d: Outline, directions: set[Vector]) -> Iterator[Contact]:
    """Yield the pairs of a vertex and an edge in the given directions, and of parallel edges."""
    ours, theirs = (
        [(k, own.direction) for k, own in enumerate(shape.pieces) if own.direction in directions]
        for shape in (g, d)
    )
    yield from (Contact("EV", i, j) for (i, _), j in product(ours, range(len(d.vertices))))
    yield from (Contact("VE", i, j) for i, (j, _) in product(range(len(g.vertices)), theirs))
    yield from (Contact("EE", i, j) for (i, u), (j, v) in product(ours, theirs) if u == v)


def find_translations(contact: Contact, generatrix: Outline, directrix: Outline) -> Segment:
    """Return the translations at which an EV, VE or EE contact exists."""
    event, i, j = contact
    mine, other = generatrix.pieces[i], directrix.pieces[j]
    if event[0] == "V":
        mine = lay_point(generatrix.vertices[i], other.direction)
    if event[1] == "V":
        other = lay_point(directrix.vertices[j], mine.direction)
    return other.minus(mine)


def _without_parts(contacts: set[Contact], g: Outline, d: Outline) -> set[Contact]:
    """Drop each EV and VE contact whose vertex is an end of an edge in an EE contact."""
    implied = set()
    for event, i, j in contacts:
        if event == "EE":
            implied |= {Contact("EV", i, j), Contact("EV", i, d.after[j])}
            implied |= {Contact("VE", i, j), Contact("VE", g.after[i], j)}
    return contacts - implied


def find_contacts(generatrix: Outline, directrix: Outline, t: Vertex) -> list[Contact]:
    """Find all contacts of G + t with D, sorted.

    VV are equal vertices; EV and VE have a vertex inside an edge; EE are edges that share a
    segment. Cost: O((m + n) log(m + n)) if few edges are near each vertex, O(m n) at worst.
    """
    # On a lattice that contains the translation, all numbers are ints, which is ten times as fast.
    scale = lcm(t[0].denominator, t[1].denominator)
    tx, ty = int(scale * t[0]), int(scale * t[1])
    found: set[Contact] = set()
    for i, (x, y) in enumerate(generatrix.vertices):
        for kind, j in directrix.find_at((x * scale + tx, y * scale + ty), scale):
            found.add(Contact("VV" if kind == "V" else "VE", i, j))
    for j, (x, y) in enumerate(directrix.vertices):
        for kind, i in generatrix.find_at((x * scale - tx, y * scale - ty), scale):
            found.add(Contact("VV" if kind == "V" else "EV", i, j))
    # Follow an overlap back toward the start of G's edge: it ends at that start or at an end of D's
    # edge, so at one of the contacts found above.
    for event, i, j in list(found):
        u = generatrix.pieces[i].direction
        for k in [j] if event == "VE" else [j, directrix.before[j]]:
            contact = Contact("EE", i, k)
            if directrix.pieces[k].direction == u:
                lasting, place = find_translations(contact, generatrix, directrix), lay_point(t, u)
                if lasting.offset == place.offset and lasting.shares_piece(place):
                    found.add(contact)
    return sorted(found)
