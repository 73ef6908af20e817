"""Undercuts of a shape: the regions between D and the loop around it, for any shape of D.

Both boundaries are cut where they meet. The pieces of the loop off D, and the pieces of D off the
loop, the latter reversed, bound the regions between, which lie on the left. The boundary of an
undercut has one piece of the loop, its bottom chain; the rest belongs to D. It has only one such
piece, since D is connected.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from exactsweep.geometry.overlap import touch
from exactsweep.numbers.point import Edge, Vertex
from exactsweep.procedures.chain import take_corners


class Mouth(NamedTuple):
    """An undercut: its bottom chain, and the way back along D, its last point the first."""

    bottom: list[Vertex]
    top: list[Vertex]


def find_mouths(loop: Sequence[Vertex], directrix: Sequence[Vertex]) -> list[Mouth]:
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
    ([(3, 3), (1, 3)], [(1, 3), (2, 1), (3, 3)])
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
        Mouth(take_corners(bottom), take_corners(_way(bottom, leaving)))
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
