"""Undercuts: what lies between D and the inner loop, out of G's reach (Section 4, Figure 7).

An undercut is bounded by a piece of D and, on the other side, by its bottom chain, a piece of the
inner loop; the two meet in the extreme contact points. For a convex G the bottom chain is a piece
of G in one position (Figure 7a), or of one straight edge of G that may slide along itself and
touch both points all the while (Figure 7b). For a monotone G several positions may be needed.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Literal, NamedTuple

from exactsweep.evidence.trace import Tracer
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.point import Edge, Point, Rational, Vertex
from exactsweep.procedures.chain import list_graph_edges, take_corners
from exactsweep.procedures.envelope import find_point_on

Intersection = Literal["point", "segment"]


class Undercut(NamedTuple):
    """A region between D and the inner loop.

    Attributes:
        polygon: the region.
        extremes: the two extreme contact points, the ends of the bottom chain.
        bottom: the bottom chain, a tuple of Point; the region lies left of it as it runs.
        intersection: "segment" if one edge of G touches both extreme points while it slides along
            itself, so that the sub-trajectories share a segment; else "point".
        positions: tuple of Point on the trajectory: where G closes the undercut. One for a point
            intersection, the two ends for a segment; more if no single position closes all of it,
            in the order of the bottom chain.
    """

    polygon: Polygon
    extremes: tuple[Point, Point]
    bottom: tuple[Point, ...]
    intersection: Literal["point", "segment"]
    positions: tuple[Point, ...]


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
        Pockets from left to right. Two that share only a point or a wall are two.

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
        # Along an edge a slice begins where the last one ended.
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
    """Take the corners of a chain that is cut at either end, where points may be there twice."""
    return take_corners(chain, {0, 1, len(chain) - 2, len(chain) - 1})


def _contact_height(below: Vertex, above: Vertex, outside: Vertex | None) -> Rational:
    """Where at the end of a pocket the bottom chain meets D.

    Between the two chains there may be a wall: of the inner loop, up to the height at which D
    arrives from outside the pocket, and of D from there on.
    """
    if outside is None:
        return below[1]
    return max(below[1], min(outside[1], above[1]))


def find_closing_positions(
    bottom: Sequence[Vertex], tracer: Tracer
) -> tuple[Intersection, list[Vertex]]:
    """Find where on the trajectory G closes an undercut, and of which kind that is.

    Args:
        bottom: the bottom chain.
        tracer: of the sweep, on the same lattice.

    Returns:
        As `intersection` and `positions` of `Undercut`, as vertices on the lattice.
    """
    edges = list(pairwise(bottom))
    if len(edges) == 1:
        ends = tracer.closing_range(edges[0])
        if ends is not None:
            closing = list(dict.fromkeys(ends))
            return "point" if len(closing) == 1 else "segment", closing
    else:
        position = tracer.covering_position(bottom)
        if position is not None:
            return "point", [position]
    positions: dict[Vertex, None] = {}
    for edge in edges:
        for trace in tracer.trace(edge):
            positions.update(dict.fromkeys(tracer.ends_of(trace.position)))
    return "point", list(positions)


def _point(edge: Edge, x: Rational) -> Vertex:
    for end in edge:
        if end[0] == x:
            return end
    return find_point_on(edge, x.as_integer_ratio())
