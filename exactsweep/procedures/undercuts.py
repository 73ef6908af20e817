"""Undercuts: the regions between D and the inner loop (Section 4, Figure 7).

Both boundaries are cut where they meet. The boundary of an undercut contains one piece of the loop,
its bottom chain; the rest belongs to D, traversed backwards. There is only one such piece, because
D is connected.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from exactsweep.geometry.edges import EdgeIndex
from exactsweep.geometry.vectors import touch
from exactsweep.numbers.number import Edge, Vertex
from exactsweep.procedures.chain import take_corners


class UndercutChains(NamedTuple):
    """The chains of an undercut, with common ends; the region lies left of the bottom chain."""

    bottom: list[Vertex]
    top: list[Vertex]


def find_undercuts(loop: Sequence[Vertex], directrix: Sequence[Vertex]) -> list[UndercutChains]:
    """Find the regions between D and the inner loop around it, both counter-clockwise.

    They follow the order of their bottom chains along the loop. Regions that share only a point or
    a vertical edge are separate. Cost: one `EdgeIndex.near` per edge of the loop.

    >>> roof = [(0, 0), (3, 0), (3, 3), (2, 1), (1, 3), (0, 3)]
    >>> find_undercuts([(0, 0), (3, 0), (3, 3), (0, 3)], roof)
    [UndercutChains(bottom=[(3, 3), (1, 3)], top=[(3, 3), (2, 1), (1, 3)])]
    """
    index = EdgeIndex([directrix])
    shared: defaultdict[Edge, set[Vertex]] = defaultdict(set)
    along: set[tuple[Vertex, ...]] = set()
    for a, b in _list_edges(loop):
        (left, right), (low, high) = (sorted(pair) for pair in zip(a, b, strict=True))
        for _, _, _, _, p, q, _, _ in index.near((left, right, low, high)):
            # An edge reversed relative to the other touches it without overlap.
            points = touch(a, b, q, p) or []
            shared[a, b].update(points)
            shared[p, q].update(points)
            along |= {tuple(points), tuple(points[::-1])}

    def cut(ring: Sequence[Vertex]) -> Iterator[Edge]:
        """Yield the pieces of a boundary that do not run along the other."""
        for p, q in _list_edges(ring):
            points = sorted({p, q, *shared[p, q]}, reverse=q < p)
            yield from (piece for piece in pairwise(points) if piece not in along)

    ahead, back = dict(cut(loop)), {q: p for p, q in cut(directrix)}
    touching = {point for edge in _list_edges(directrix) for point in (edge[0], *shared[edge])}
    # D's exterior is simple, so one piece leaves each vertex.
    return [
        UndercutChains(keep_corners(bottom), keep_corners(_walk(bottom[-1], back, {start})[::-1]))
        for start in ahead
        if start in touching
        for bottom in [_walk(start, ahead, touching)]
    ]


def _list_edges(ring: Sequence[Vertex]) -> Iterator[Edge]:
    return pairwise([*ring, ring[0]])


def _walk(start: Vertex, following: dict[Vertex, Vertex], ends: set[Vertex]) -> list[Vertex]:
    """Walk from a vertex to the next one in `ends`."""
    walk = [start, following[start]]
    while walk[-1] not in ends:
        walk.append(following[walk[-1]])
    return walk


def keep_corners(chain: Iterable[Vertex]) -> list[Vertex]:
    """Drop repeated points, and points on the segment between their neighbors."""
    return [(x, y) for x, y, _ in take_corners((x, y, 1) for x, y in chain)]
