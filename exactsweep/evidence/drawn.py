"""The features of G that draw the edges of the loops, and their positions on the trajectory.

G draws both loops as it moves along the trajectory T, the boundary of P = D + I(G) (Lemma 5.3):

(1) The outer loop is the boundary of P + G. It is to T and I(G) what the trajectory is to D and G.
(2) The inner loop bounds the points p for which I(G) + p lies in P. It is the same to I(G) and the
    outside of P, whose boundary is T in the other direction.

So a contact of I(G) with T, at a point of a loop, is a feature of G that draws the loop: EV is an
edge of G at a vertex of T, VE the path of a vertex of G along an edge of T, and EE the path of an
edge of G along a parallel edge of T. One edge of a loop may need several of them: one vertex of G
after the other may touch the same edge of D.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, NamedTuple

from exactsweep.evidence.contact import Contact, find_touching
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.segment import Segment, choose_cover, make_segment, measure_along
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.point import Edge


class Feature(NamedTuple):
    """A vertex or an edge of a loop, by number; edge k runs from vertex k to vertex k + 1."""

    kind: Literal["vertex", "edge"]
    number: int


class DrawnPiece(NamedTuple):
    """A piece of a loop's edge that a feature of G draws.

    Attributes:
        position: the vertex or the edge of the trajectory along which it draws.
        feature: the feature of G.
        piece: the drawn piece, on the line of the edge.
    """

    position: Feature
    feature: Feature
    piece: Segment


class DrawnEdge:
    """An edge of a loop, and all features of G that draw pieces of it.

    Attributes:
        edge: its ends.
        whole: the edge as a piece of its line.
        at_vertices: the DrawnPieces by edges of G at vertices of the trajectory.
        along: the DrawnPieces by vertices and edges of G along edges of the trajectory.
    """

    def __init__(self, edge: Edge, whole: Segment, path: Outline) -> None:
        self._path = path
        self.edge = edge
        self.whole = whole
        self.at_vertices: list[DrawnPiece] = []
        self.along: list[DrawnPiece] = []

    def covers(self, drawn: DrawnPiece) -> bool:
        """Decide whether a piece is all of the edge."""
        _, _, low, high = drawn.piece
        return low <= self.whole.low and self.whole.high <= high

    def choose(self) -> list[DrawnPiece]:
        """Choose few pieces that together cover the edge.

        The search tries, in this order, until it has covered the edge: edges of G with an end in
        common; vertices and edges of G along edges of the trajectory; other edges of G.

        Raises ExactSweepError if nothing draws the edge, because it does not belong to the sweep.
        """
        ends = [measure_along(self.whole.direction, end) for end in self.edge]

        def find_end(drawn: DrawnPiece) -> int | None:
            return next((k for k, end in enumerate(ends) if end in drawn.piece[2:]), None)

        def by_end(drawn: DrawnPiece) -> tuple[Any, ...]:
            return drawn.feature.number, find_end(drawn)

        def by_path(drawn: DrawnPiece) -> tuple[Any, ...]:
            k = drawn.position.number
            return self._path.pieces[k].low, k, drawn.feature.number

        def by_place(drawn: DrawnPiece) -> tuple[Any, ...]:
            return drawn.feature.number, drawn.piece, drawn.position

        tried: list[DrawnPiece] = []
        from_ends = [drawn for drawn in self.at_vertices if find_end(drawn) is not None]
        for group, order in (
            (from_ends, by_end),
            (self.along, by_path),
            (self.at_vertices, by_place),
        ):
            covering = list(filter(self.covers, group))
            if covering:
                return [min(covering, key=order)]
            tried += sorted(group, key=order)
            chosen = choose_cover(self.whole, [(d.piece, k) for k, d in enumerate(tried)])
            if chosen is not None:
                return [tried[k] for k in chosen]
        raise ExactSweepError("no feature of the generatrix draws this edge")


def find_drawn_edges(
    edges: Sequence[Edge], path: Outline, generatrix: Outline, *, inside: bool
) -> list[DrawnEdge]:
    """Find all features of G that draw edges of a loop.

    Args:
        edges: edges of the outer loop or of the inner one, or pieces of them.
        path: the trajectory of G's origin.
        generatrix: the features of G.
        inside: whether the edges belong to the inner loop.

    Cost: that of `find_edge_contacts` for the trajectory and G.
    """
    around = path.complement() if inside else path
    drawn = [DrawnEdge(edge, make_segment(edge), path) for edge in edges]
    found = find_touching([edge.whole for edge in drawn], generatrix.scaled(-1), around)
    for edge, touching in zip(drawn, found, strict=True):
        for (event, i, k), piece in touching.items():
            feature = Feature("edge" if event[0] == "E" else "vertex", i)
            if event == "EV":
                edge.at_vertices.append(DrawnPiece(Feature("vertex", k), feature, piece))
            # An edge of G draws all that its first vertex draws.
            elif event == "EE" or Contact("EE", i, k) not in touching:
                edge.along.append(DrawnPiece(Feature("edge", k), feature, piece))
    return drawn
