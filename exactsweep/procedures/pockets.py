"""Undercuts: the regions between D and the inner loop (Section 4, Figure 7).

Along the chains of a lower sweep one walk from left to right finds them. For shapes of any kind
both boundaries are cut where they meet. The pieces of the loop off D, and the pieces of D off the
loop, the latter reversed, bound the regions between, which lie on the left. The boundary of an
undercut has one piece of the loop, its bottom chain; the rest belongs to D. It has only one such
piece, since D is connected.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from exactsweep.geometry.edges import touch
from exactsweep.numbers.number import Edge, Rational, Vertex
from exactsweep.procedures.chain import take_corners
from exactsweep.procedures.exact_fit import evaluate, list_edges


class Pocket(NamedTuple):
    """An undercut as two chains with common ends; the region lies left of the bottom chain."""

    bottom: list[Vertex]
    top: list[Vertex]


def find_pockets(inner: Sequence[Vertex], directrix: Sequence[Vertex]) -> list[Pocket]:
    """Find the regions between the inner boundary and D_b.

    Args:
        inner: the inner boundary, from left to right, nowhere above D_b.
        directrix: D_b, from left to right, with the same ends; both have corners only.

    Returns:
        Pockets from left to right. Regions that share only a point or a wall are separate pockets.

    Cost: O(m + size of inner).

    Example:
        >>> found = find_pockets([(0, 0), (3, 0)], [(0, 0), (1, 0), (1, 1), (2, 0), (3, 0)])
        >>> found == [Pocket(bottom=[(1, 0), (2, 0)], top=[(1, 0), (1, 1), (2, 0)])]
        True
    """
    found: list[Pocket] = []
    ends: list[tuple[Vertex, Vertex, Vertex]] = []
    low, high = list_edges(inner), list_edges(directrix)
    i = j = 0
    b1 = a1 = directrix[0]
    while i < len(low):
        below, above = low[i], high[j]
        left, right = max(below[0][0], above[0][0]), min(below[1][0], above[1][0])
        # Along an edge, a slice begins where the last one ended.
        last_b, last_a = b1, a1
        b0 = below[0] if below[0][0] == left else last_b
        a0 = above[0] if above[0][0] == left else last_a
        b1, a1 = _point(below, right), _point(above, right)
        if b0 != a0 or b1 != a1:
            # A pocket goes on if the slices at its last x and here overlap.
            if max(b0[1], last_b[1]) >= min(a0[1], last_a[1]):
                outside = a0 if above[0][0] < left else high[j - 1][1] if j > 0 else None
                start = left, _contact_height(b0, a0, outside)
                found.append(Pocket([start, b0], [start, a0]))
                ends.append((b1, a1, start))
            for chain, edge in zip(found[-1], (below, above), strict=True):
                if edge[0][0] == left and edge[0] != chain[-1]:
                    chain.append(edge[0])
                if edge[1][0] == right:
                    chain.append(edge[1])
            outside = a1 if right < above[1][0] else high[j + 1][0] if j + 1 < len(high) else None
            ends[-1] = b1, a1, (right, _contact_height(b1, a1, outside))
        i += below[1][0] == right
        j += above[1][0] == right
    return [
        Pocket(keep_corners([*bottom, b1, end]), keep_corners([*top, a1, end]))
        for (bottom, top), (b1, a1, end) in zip(found, ends, strict=True)
    ]


def keep_corners(chain: Iterable[Vertex]) -> list[Vertex]:
    """Drop repeated points, and points on the segment between their neighbours."""
    return [(x, y) for x, y, _ in take_corners((x, y, 1) for x, y in chain)]


def _contact_height(below: Vertex, above: Vertex, outside: Vertex | None) -> Rational:
    """Find where at the end of a pocket the bottom chain meets D.

    A wall may join the two chains. It belongs to the inner loop up to the height at which D arrives
    from outside the pocket, and to D above.
    """
    if outside is None:
        return below[1]
    return max(below[1], min(outside[1], above[1]))


def _point(edge: Edge, x: Rational) -> Vertex:
    for end in edge:
        if end[0] == x:
            return end
    return x, evaluate(edge, x)


def find_mouths(loop: Sequence[Vertex], directrix: Sequence[Vertex]) -> list[Pocket]:
    """Find the regions between D and a loop around it.

    Args:
        loop: the inner loop, counter-clockwise.
        directrix: the exterior of D, counter-clockwise, inside the loop or on it.

    Returns:
        The undercuts, in the order of their bottom chains along the loop.

    Cost: O(s m) for s edges of the loop and m of D.

    >>> roof = [(0, 0), (3, 0), (3, 3), (2, 1), (1, 3), (0, 3)]
    >>> (mouth,) = find_mouths([(0, 0), (3, 0), (3, 3), (0, 3)], roof)
    >>> mouth.bottom, mouth.top
    ([(3, 3), (1, 3)], [(3, 3), (2, 1), (1, 3)])
    """
    edges, others = list(_edges(loop)), list(_edges(directrix))
    shared: list[list[set[Vertex]]] = [[set(e) for e in edges], [set(e) for e in others]]
    along: set[Edge] = set()
    for i, (a, b) in enumerate(edges):
        for j, (p, q) in enumerate(others):
            # A reversed edge that runs along the other one touches it and does not overlap it.
            points = touch(a, b, q, p) or []
            shared[0][i].update(points)
            shared[1][j].update(points)
            if len(set(points)) == 2:
                along.update((tuple(points), tuple(reversed(points))))  # type: ignore[arg-type]
    pieces = [
        [
            piece
            for edge, points in zip(own, cut, strict=True)
            for piece in pairwise(sorted(points, reverse=edge[1] < edge[0]))
            if piece not in along
        ]
        for own, cut in zip((edges, others), shared, strict=True)
    ]
    leaving = {q: p for p, q in pieces[1]}
    return [
        Pocket(keep_corners(bottom), keep_corners(_way(bottom, leaving)[::-1]))
        for bottom in _chains(pieces[0], {p for edge in others for p in edge}, shared[1])
    ]


def _edges(ring: Sequence[Vertex]) -> Iterator[Edge]:
    return pairwise([*ring, ring[0]])


def _chains(
    pieces: Sequence[Edge], vertices: set[Vertex], on_directrix: Sequence[set[Vertex]]
) -> Iterator[list[Vertex]]:
    """Join the pieces of the loop off D to chains from D to D."""
    touching = vertices.union(*on_directrix)
    ahead = dict(pieces)
    for start, _ in pieces:
        if start in touching:
            chain = [start, ahead[start]]
            while chain[-1] not in touching:
                chain.append(ahead[chain[-1]])
            yield chain


def _way(bottom: Sequence[Vertex], leaving: dict[Vertex, Vertex]) -> list[Vertex]:
    """Walk back along D from the end of a bottom chain to its start, the region on the left."""
    way = [bottom[-1]]
    while way[-1] != bottom[0]:
        # D's exterior is simple, so one piece leaves each vertex.
        way.append(leaving[way[-1]])
    return way
