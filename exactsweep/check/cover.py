"""Every edge of a loop is drawn: covered by sums of features, one of each of two loops.

Such a sum, a point, segment or parallelogram, draws an edge if it is a segment on the line of the
edge and has more than a point in common with it.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction
from typing import NamedTuple

from exactsweep.check.certificate import CertificateError, Drawing, Feature
from exactsweep.check.chain import Line, Node
from exactsweep.check.loop import Frame, Loop
from exactsweep.geometry.point import Rational


class Extent(NamedTuple):
    """A segment on a known line, by its least and greatest x, or y if the line is vertical."""

    low: Rational
    high: Rational

    def common(self, other: Extent) -> Extent:
        """The part of both; its low is not below its high if there is none of positive length."""
        return Extent(max(self.low, other.low), min(self.high, other.high))


def edge_extent(loop: Loop, k: int) -> Extent:
    """The extent of an edge on its own line."""
    return _extent(_ends(loop, Feature("edge", k)), loop.lines[k])


def sum_extent(
    first: Loop, feature: Feature, second: Loop, other: Feature, line: Line
) -> Extent | None:
    """The extent on a line of the sum of two features, or None if it is not all on the line.

    The nodes of the second loop are on the lattice.
    """
    a, b, c = line
    ends = [
        (x + dx * w, y + dy * w, w)
        for x, y, w in _ends(first, feature)
        for dx, dy, _ in _ends(second, other)
    ]
    for x, y, w in ends:
        if a * x + b * y + c * w:
            return None
    return _extent(ends, line)


def middle(extent: Extent, line: Line) -> Node:
    """The point of a line half-way along an extent."""
    a, b, c = line
    along = Fraction(extent.low + extent.high, 2)
    n, w = along.numerator, along.denominator
    return (n * b, -a * n - c * w, w * b) if b else (-c * w, n * a, w * a)


def check_covered(
    place: str, edge: Extent, pieces: Collection[Extent], line: Line, frame: Frame
) -> None:
    """Raise CertificateError if pieces of a line leave a gap on an edge."""
    reach = edge.low
    for low, high in sorted(pieces):
        if low > reach:
            break
        reach = max(reach, high)
    if reach < edge.high:
        # To the next piece, or to the end if there is no piece beyond.
        gap = Extent(reach, min([edge.high, *(low for low, _ in pieces if low > reach)]))
        witness = frame.leave(middle(gap, line))
        raise CertificateError(f"{place}: nothing that is listed draws all of the edge", witness)


def check_drawings(
    name: str,
    loop: Loop,
    trajectory: Loop,
    generatrix: Loop,
    listed: Sequence[Sequence[Drawing]],
    frame: Frame,
) -> None:
    """Check that the listed features of G, at their positions, draw each edge, all of it.

    Args:
        name: of the list.
        loop: the inner or the outer one.
        trajectory: the loop.
        generatrix: G.
        listed: for each edge of the loop its drawings.
        frame: to name witnesses in the plane.

    Raises:
        CertificateError: one does not, or they leave a part out.

    Cost: O(d log d) for d drawings of one edge, summed over the edges.
    """
    for k, drawings in enumerate(listed):
        line, edge = loop.lines[k], edge_extent(loop, k)
        pieces = []
        for drawing in drawings:
            position, feature = drawing
            piece = sum_extent(trajectory, position, generatrix, feature, line)
            if piece is None:
                raise CertificateError(f"{name}[{k}]: {drawing} is not on the line of the edge")
            low, high = piece.common(edge)
            if low >= high:
                raise CertificateError(f"{name}[{k}]: {drawing} draws no part of the edge")
            pieces.append(piece)
        check_covered(f"{name}[{k}]", edge, pieces, line, frame)


def _ends(loop: Loop, feature: Feature) -> list[Node]:
    kind, k = feature
    if kind == "vertex":
        return [loop.nodes[k]]
    # Edge k ends in node k + 1, the last one in node 0.
    return [loop.nodes[k], loop.nodes[k + 1 - len(loop.nodes)]]


def _extent(nodes: Sequence[Node], line: Line) -> Extent:
    axis = 0 if line[1] else 1
    # Ints where they are: Fractions take ten times as long.
    along = [node[axis] if node[2] == 1 else Fraction(node[axis], node[2]) for node in nodes]
    return Extent(min(along), max(along))
