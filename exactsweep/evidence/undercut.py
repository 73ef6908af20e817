"""Undercuts: the regions between D and the inner loop, out of G's reach (Section 4, Figure 7).

A piece of D bounds an undercut on one side. Its bottom chain, a piece of the inner loop, bounds it
on the other. The two meet in the extreme contact points. For a convex G the bottom chain is a piece
of G in one position (Figure 7a), or a piece of one edge of G that can slide along itself while it
touches both points (Figure 7b). A monotone G may need several positions.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

from exactsweep.evidence.drawn import DrawnEdge
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.number import Point, Vertex

Intersection = Literal["point", "segment"]


class Undercut(NamedTuple):
    """A region between D and the inner loop.

    Attributes:
        polygon: the region.
        extremes: the two extreme contact points, the ends of the bottom chain.
        bottom: the bottom chain, a tuple of Point; the region lies left of it as it runs.
        intersection: "segment" if one edge of G touches both extreme points while it slides along
            itself, so that the sub-trajectories share a segment; else "point".
        positions: tuple of Point on the trajectory, at which G closes the undercut: one for a point
            intersection, the two ends for a segment. If no single position closes all of it, there
            are more, in the order of the bottom chain.
    """

    polygon: Polygon
    extremes: tuple[Point, Point]
    bottom: tuple[Point, ...]
    intersection: Literal["point", "segment"]
    positions: tuple[Point, ...]


def find_closing_positions(bottom: Sequence[DrawnEdge]) -> tuple[Intersection, list[Vertex]]:
    """Find the positions at which G closes an undercut, and the kind of their intersection.

    Args:
        bottom: the edges of the bottom chain.

    Returns:
        `intersection` and `positions` of `Undercut`, with positions on the lattice.
    """
    first, *others = bottom
    whole, tracer = first.whole, first.tracer
    # At an inner point of an edge of the trajectory, only a parallel edge of G draws. So G closes a
    # bent chain at a vertex of the trajectory, where a vertex of G is at each bend.
    if others:
        found = tracer.from_ends(whole, first.edge[1:])
    else:
        closing = tracer.find_slide(whole)
        if closing:
            return "point" if len(closing) == 1 else "segment", closing
        found = tracer.at_vertices(whole)
    for (_, k), *_ in filter(first.covers, found):
        if all(tracer.is_covered_at(edge.whole, k) for edge in others):
            return "point", [tracer.path.vertices[k]]
    positions: dict[Vertex, None] = {}
    for edge in bottom:
        for (kind, k), *_ in edge.choose():
            positions.update(dict.fromkeys(tracer.path.edge(k)[: 1 + (kind == "edge")]))
    return "point", list(positions)
