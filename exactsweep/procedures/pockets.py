"""Pockets between the inner boundary of a lower sweep and D_b (Section 4, Figure 7)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from exactsweep.numbers.point import Edge, Rational, Vertex
from exactsweep.procedures.chain import list_graph_edges, take_corners
from exactsweep.procedures.envelope import find_point_on


class Pocket(NamedTuple):
    """An undercut of the lower sweep as two chains from left to right with common x-range."""

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
    low, high = list_graph_edges(inner), list_graph_edges(directrix)
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
        Pocket(_close([*bottom, b1, end]), _close([*top, a1, end]))
        for (bottom, top), (b1, a1, end) in zip(found, ends, strict=True)
    ]


def _close(chain: list[Vertex]) -> list[Vertex]:
    """Drop points that are not corners from a chain whose cut ends may repeat a point."""
    return take_corners(chain, {0, 1, len(chain) - 2, len(chain) - 1})


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
    return find_point_on(edge, x.as_integer_ratio())
