"""Undercuts: the regions between D and the inner loop, out of G's reach (Section 4, Figure 7).

A piece of D bounds an undercut on one side; its bottom chain, a piece of the inner loop, bounds it
on the other. They meet at the extreme contact points. For a convex G, the bottom chain is a piece
of G in one position (Figure 7a), or a piece of an edge of G that can slide along itself while it
touches both points (Figure 7b). A monotone G may need several positions.

G traces the bottom chain as it moves along the trajectory T. An edge of the chain is a piece of an
edge of G at a vertex of T, or of the path of a vertex or an edge of G along a parallel edge of T.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise, product
from typing import Literal, NamedTuple

from exactsweep.geometry.direction import Vector
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.segment import (
    Segment,
    choose_cover,
    lay_point,
    make_segment,
    measure_along,
)
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Point, Vertex

Intersection = Literal["point", "segment"]


class Undercut(NamedTuple):
    """A region between D and the inner loop.

    Attributes:
        polygon: the region.
        extremes: the two extreme contact points, the ends of the bottom chain.
        bottom: the bottom chain, a tuple of Point; the region lies left of it.
        intersection: "segment" if an edge of G touches both extreme points while it slides along
            itself, so that the subtrajectories share a segment; else "point".
        positions: tuple of Points on the trajectory at which G closes the undercut: one for a point
            intersection, the two ends for a segment, or more in the order of the bottom chain if no
            single position closes all of it.
    """

    polygon: Polygon
    extremes: tuple[Point, Point]
    bottom: tuple[Point, ...]
    intersection: Literal["point", "segment"]
    positions: tuple[Point, ...]


class TracedPiece(NamedTuple):
    """A segment that G traces at a vertex or along an edge of T, with its positions."""

    positions: tuple[Vertex, ...]
    piece: Segment

    def covers(self, whole: Segment) -> bool:
        """Decide whether the piece covers a segment on its line."""
        return self.piece.low <= whole.low and whole.high <= self.piece.high


class Tracer(NamedTuple):
    """The trajectory T and the generatrix G, which moves along it."""

    path: Outline
    generatrix: Outline

    def _list_slides(self, u: Vector) -> list[tuple[int, Segment]]:
        """List the edges of T in a direction, sorted by their low ends."""
        slides = [(k, s) for k, s in enumerate(self.path.pieces) if s.direction == u]
        return sorted(slides, key=lambda slide: slide[1].low)

    def find_slide(self, whole: Segment) -> list[Vertex]:
        """Find the positions along an edge of T at which an edge of G covers an edge of the chain.

        Returns the ends of the first piece of positive length, or else the first single position.
        """
        single: list[Vertex] = []
        slides = self._list_slides(whole.direction)
        for own in self._list_edges(whole):
            low, high = whole.high - own.high, whole.low - own.low
            for _, slide in slides:
                first, last = max(low, slide.low), min(high, slide.high)
                if slide.offset == whole.offset - own.offset and first <= last:
                    if first < last:
                        return [slide.point(first), slide.point(last)]
                    single = single or [slide.point(first)]
        return single

    def _list_edges(self, whole: Segment) -> list[Segment]:
        return [own for own in self.generatrix.pieces if own.direction == whole.direction]

    def choose(self, whole: Segment) -> list[TracedPiece]:
        """Choose a few traced pieces that cover an edge; raise ExactSweepError if there are none.

        The search tries edges of G that share an end with it; then vertices and edges of G along
        edges of T; then other edges of G.
        """
        tried: list[TracedPiece] = []
        stopped = list(self.draw_at(whole))
        at_ends = [d for d in stopped if d.piece.low == whole.low or d.piece.high == whole.high]
        for draw in at_ends, self.draw_along(whole), stopped:
            for drawing in draw:
                if drawing.covers(whole):
                    return [drawing]
                if drawing.piece.shares_piece(whole):
                    tried.append(drawing)
            chosen = choose_cover(whole, [(d.piece, k) for k, d in enumerate(tried)])
            if chosen is not None:
                return [tried[k] for k in chosen]
        raise ExactSweepError("no feature of the generatrix traces this edge")

    def draw_along(self, whole: Segment) -> Iterator[TracedPiece]:
        """Yield the pieces that vertices and edges of G trace along edges of T."""
        u = whole.direction
        pens = [
            own if own.direction == u else lay_point(vertex, u)
            for vertex, own in zip(self.generatrix.vertices, self.generatrix.pieces, strict=True)
        ]
        for (k, slide), pen in product(self._list_slides(u), pens):
            if slide.offset + pen.offset == whole.offset:
                low, high = slide.low + pen.low, slide.high + pen.high
                yield TracedPiece(self.path.edge(k), whole._replace(low=low, high=high))

    def draw_at(self, whole: Segment) -> Iterator[TracedPiece]:
        """Yield the pieces that edges of G trace at vertices of T."""
        stops = sorted(self.path.vertices, key=lambda t: measure_along(whole.direction, t))
        for own, t in product(self._list_edges(whole), stops):
            drawing = _draw_at(t, own)
            if drawing.piece.offset == whole.offset and drawing.piece.shares_piece(whole):
                yield drawing

    def covers_at(self, t: Vertex, whole: Segment) -> bool:
        """Decide whether an edge of G covers an edge of the chain at a vertex of T."""
        drawn = (_draw_at(t, own) for own in self._list_edges(whole))
        return any(d.piece.offset == whole.offset and d.covers(whole) for d in drawn)


def find_closing_positions(
    bottom: Sequence[Vertex], tracer: Tracer
) -> tuple[Intersection, list[Vertex]]:
    """Find `intersection` and `positions` of an undercut from its bottom chain, in the frame.

    Raises ExactSweepError if the chain belongs to another sweep. Cost: O(t n) for each edge, for t
    edges of T and n of G.
    """
    whole, *others = edges = list(map(make_segment, pairwise(bottom)))
    if not others and (closing := tracer.find_slide(whole)):
        return "point" if len(closing) == 1 else "segment", closing
    # Inside an edge of T, only a parallel edge of G traces one. So G closes a bent chain at a
    # vertex of T, with a vertex of G at each bend.
    for drawing in tracer.draw_at(whole):
        (t,) = drawing.positions
        if drawing.covers(whole) and all(tracer.covers_at(t, edge) for edge in others):
            return "point", [t]
    positions = (t for edge in edges for one in tracer.choose(edge) for t in one.positions)
    return "point", list(dict.fromkeys(positions))


def _draw_at(t: Vertex, own: Segment) -> TracedPiece:
    place = lay_point(t, own.direction)
    low, high = own.low + place.low, own.high + place.low
    return TracedPiece((t,), Segment(own.direction, own.offset + place.offset, low, high))
