"""Every edge of a loop is drawn: covered by sums of features, one of each of two loops.

Such a sum, a point, segment or parallelogram, draws an edge if it is a segment on the line of the
edge and has more than a point in common with it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from fractions import Fraction
from typing import NamedTuple

from exactsweep.check.certificate import CertificateError, ListedDrawing, ListedFeature
from exactsweep.check.chain import Line, Node
from exactsweep.check.loop import MonotoneLoop, NodeFrame


class LineInterval(NamedTuple):
    """A segment on a known line, by its least and greatest x, or y if the line is vertical."""

    low: Fraction
    high: Fraction

    def common(self, other: LineInterval) -> LineInterval:
        """The part of both; its low is not below its high if there is none of positive length."""
        return LineInterval(max(self.low, other.low), min(self.high, other.high))


def edge_extent(loop: MonotoneLoop, k: int) -> LineInterval:
    """The extent of an edge on its own line."""
    return _extent(_ends(loop, ListedFeature("edge", k)), loop.lines[k])


def sum_extent(
    first: MonotoneLoop,
    feature: ListedFeature,
    second: MonotoneLoop,
    other: ListedFeature,
    line: Line,
) -> LineInterval | None:
    """The extent on a line of the sum of two features, or None if it is not all on the line.

    The nodes of the second loop are on the lattice.
    """
    a, b, c = line
    ends = [
        (x + dx * w, y + dy * w, w)
        for x, y, w in _ends(first, feature)
        for dx, dy, _ in _ends(second, other)
    ]
    if any(a * x + b * y + c * w for x, y, w in ends):
        return None
    return _extent(ends, line)


def middle(extent: LineInterval, line: Line) -> Node:
    """The point of a line half-way along an extent."""
    a, b, c = line
    along = (extent.low + extent.high) / 2
    n, w = along.numerator, along.denominator
    return (n * b, -a * n - c * w, w * b) if b else (-c * w, n * a, w * a)


def check_covered(
    place: str, edge: LineInterval, pieces: Collection[LineInterval], line: Line, frame: NodeFrame
) -> None:
    """Raise CertificateError if pieces of a line leave a gap on an edge."""
    reach = edge.low
    for low, high in sorted(pieces):
        if low > reach:
            break
        reach = max(reach, high)
    if reach < edge.high:
        # To the next piece, or to the end if there is no piece beyond.
        gap = LineInterval(reach, min([edge.high, *(low for low, _ in pieces if low > reach)]))
        witness = frame.leave(middle(gap, line))
        raise CertificateError(f"{place}: nothing that is listed draws all of the edge", witness)


def check_drawings(
    name: str,
    loop: MonotoneLoop,
    trajectory: MonotoneLoop,
    generatrix: MonotoneLoop,
    listed: Sequence[Sequence[ListedDrawing]],
    frame: NodeFrame,
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


def _ends(loop: MonotoneLoop, feature: ListedFeature) -> list[Node]:
    kind, k = feature
    # Edge k ends in node k + 1, the last one in node 0.
    ends = [loop.nodes[k], loop.nodes[k + 1 - len(loop.nodes)]]
    return ends[:1] if kind == "vertex" else ends


def _extent(nodes: Iterable[Node], line: Line) -> LineInterval:
    axis = 0 if line[1] else 1
    along = [Fraction(node[axis], node[2]) for node in nodes]
    return LineInterval(min(along), max(along))
