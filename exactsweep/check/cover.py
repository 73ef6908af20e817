"""Every edge of a loop is drawn: covered by sums of features, one of each of two loops.

Such a sum, a point, segment or parallelogram, draws an edge if it is a segment on the line of the
edge and has more than a point in common with it.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction

from exactsweep.check.certificate import KeyPath, ListedDrawing, ListedFeature, flaw
from exactsweep.check.chain import Line, Node, add_nodes
from exactsweep.check.loop import MonotoneLoop, NodeFrame
from exactsweep.numbers.point import Rational

# A segment on a known line, by its least and greatest x, or y if the line is vertical; ints where
# they are ints, for Fractions take ten times as long.
LineInterval = tuple[Rational, Rational]


def share_a_part(one: LineInterval, other: LineInterval) -> bool:
    """Decide whether two segments on a line have a part of positive length in common."""
    return max(one[0], other[0]) < min(one[1], other[1])


def find_edge_extent(loop: MonotoneLoop, k: int) -> LineInterval:
    """The extent of an edge on its own line."""
    axis = 0 if loop.lines[k][1] else 1
    one, other = (_ratio(node[axis], node[2]) for node in _ends(loop, ("edge", k)))
    return (one, other) if one < other else (other, one)


def find_sum_extent(
    first: MonotoneLoop,
    feature: ListedFeature,
    second: MonotoneLoop,
    other: ListedFeature,
    line: Line,
) -> LineInterval | None:
    """The extent on a line of the sum of two features, or None if it is not all on the line."""
    a, b, c = line
    along = []
    for x, y, w in _ends(first, feature):
        for node in _ends(second, other):
            u, v, z = add_nodes((x, y, w), node)
            if a * u + b * v + c * z:
                return None
            along.append(_ratio(u if b else v, z))
    return min(along), max(along)


def find_middle(extent: LineInterval, line: Line) -> Node:
    """The point of a line half-way along an extent."""
    a, b, c = line
    along = Fraction(extent[0] + extent[1], 2)
    n, w = along.numerator, along.denominator
    return (n * b, -a * n - c * w, w * b) if b else (-c * w, n * a, w * a)


def check_covered(
    place: KeyPath,
    edge: LineInterval,
    pieces: Collection[LineInterval],
    line: Line,
    frame: NodeFrame,
) -> None:
    """Raise CertificateError if pieces of a line leave a gap on an edge."""
    reach, end = edge
    for low, high in sorted(pieces):
        if low > reach:
            break
        reach = max(reach, high)
    if reach < end:
        # To the next piece, or to the end if there is no piece beyond.
        gap = reach, min([end, *(low for low, _ in pieces if low > reach)])
        witness = frame.leave(find_middle(gap, line))
        raise flaw(place, "nothing that is listed draws all of the edge", witness)


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
        line, edge = loop.lines[k], find_edge_extent(loop, k)
        pieces = []
        for drawing in drawings:
            position, feature = drawing
            piece = find_sum_extent(trajectory, position, generatrix, feature, line)
            if piece is None:
                raise flaw((name, k), f"{_name(drawing)} is not on the line of the edge")
            if not share_a_part(piece, edge):
                raise flaw((name, k), f"{_name(drawing)} draws no part of the edge")
            pieces.append(piece)
        check_covered((name, k), edge, pieces, line, frame)


def _ends(loop: MonotoneLoop, feature: ListedFeature) -> list[Node]:
    kind, k = feature
    if kind == "vertex":
        return [loop.nodes[k]]
    # Edge k ends in node k + 1, the last one in node 0.
    return [loop.nodes[k], loop.nodes[k + 1 - len(loop.nodes)]]


def _name(drawing: ListedDrawing) -> str:
    (where, k), (what, i) = drawing
    return f"generatrix {what} {i} at trajectory {where} {k}"


def _ratio(n: int, d: int) -> Rational:
    return n if d == 1 else Fraction(n, d)
