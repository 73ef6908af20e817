"""Chains: lower boundaries of regions, as piecewise linear functions of x on one integer lattice.

A node (x, y, w) is the point (x/w, y/w); w is 1 for points of the lattice, and more where a loop
turns at a crossing, and everywhere if the polygons have no lattice in common that is of use. A line
(a, b, c) is a x + b y + c = 0, positive to the left of its edge; its three numbers are coprime, so
that equal lines are equal tuples.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from itertools import pairwise

Node = tuple[int, int, int]
Line = tuple[int, int, int]


# An edge that is not vertical, from left to right, with its line; b of it is positive.
ChainEdge = tuple[Node, Node, Line]

# A corner, by its number, with the lines of the edges before and after it.
ChainCorner = tuple[int, Node, Line, Line]

# The lines that bound the region above a chain: on its left, going down, and on its right.
_DOWN, _UP = (1, 0, 0), (-1, 0, 0)


class LowerChain:
    """A lower chain, from left to right: a piecewise linear function, and its region above it.

    Two neighbouring edges that do not meet are the two sides of a jump, a vertical edge; the
    function takes the lower value there.

    Attributes:
        edges: list of ChainEdge; each begins at the x where the last one ends.
        jumps: how many vertical edges there are.
        runs: the convex corners, where the region has an angle below two right ones, as lists of
            ChainCorner with no concave corner between them: slopes grow all along a run.
        concave: the other corners, as tuples of vertex number, node, a side (1 right, -1 left) on
            which the chain goes on from the node without a jump, and the next node on that side.
    """

    def __init__(self, corners: Sequence[tuple[int, Node]], lines: Sequence[Line]) -> None:
        """Take the corners from left to right, and the lines between them."""
        self.edges = [
            (left, right, line)
            for ((_, left), (_, right)), line in zip(pairwise(corners), lines, strict=True)
            if line[1]
        ]
        self.jumps = len(lines) - len(self.edges)
        self.runs: list[list[ChainCorner]] = []
        self.concave = []
        before, run = _DOWN, list[ChainCorner]()
        for m, ((number, node), after) in enumerate(zip(corners, (*lines, _UP), strict=True)):
            if turn(before, after) > 0:
                run.append((number, node, before, after))
            else:
                side = 1 if after[1] else -1
                self.concave.append((number, node, side, corners[m + side][1]))
                self.runs.append(run)
                run = []
            before = after
        self.runs = [run for run in (*self.runs, run) if run]
        self._floors = [x // w for _, (x, _, w), _ in self.edges]

    def first_reaching(self, x: int, w: int) -> int:
        """The number of the first edge that ends at x/w or to the right of it.

        Cost: O(log n).
        """
        unit = x // w
        k = bisect_left(self._floors, unit)
        if k == len(self.edges) or self._floors[k] > unit:
            return k
        same = bisect_right(self._floors, unit, k)
        return bisect_left(self.edges, 0, k, same, key=lambda edge: edge[1][0] * w - x * edge[1][2])

    def holds(self, node: Node) -> bool:
        """Decide whether a point is on the chain or above it."""
        x, y, w = node
        k = self.first_reaching(x, w)
        # At the x of a jump one edge ends and the next one begins; the lower one decides.
        for left, _, (a, b, c) in self.edges[k : k + 2]:
            if left[0] * w > x * left[2]:
                break
            if a * x + b * y + c * w >= 0:
                return True
        return False


def add_nodes(one: Node, other: Node) -> Node:
    """The sum of two points, as vectors."""
    (x, y, w), (u, v, z) = one, other
    if z == 1:
        return x + u * w, y + v * w, w
    return x * z + u * w, y * z + v * w, w * z


def turn(one: Line, other: Line) -> int:
    """Positive for a turn to the left, 0 between parallel lines."""
    return one[0] * other[1] - one[1] * other[0]


def put_longer_first(one: LowerChain, other: LowerChain) -> tuple[LowerChain, LowerChain]:
    """Two chains, the one of more edges first: `walk_heights` walks along all of the second."""
    return (other, one) if len(one.edges) < len(other.edges) else (one, other)


def walk_heights(
    first: LowerChain, second: LowerChain, o: Node, side: int
) -> Iterator[tuple[int, int]]:
    """Walk along A(u) + B(x - u) - y for a point o = (x, y), through all u with both defined.

    Between breakpoints this is linear in u; so its limits at breakpoints are given, from left to
    right, and the least one is (A + B)(x) - y. Where both functions jump at once, there are four
    pairs of one-sided limits. Those from inside one interval always count. Of the other two, one
    counts just right of x (`side` 1) and the other one just left of x (-1); side 0 leaves them out.

    Args:
        first: the function A.
        second: the function B.
        o: the point.
        side: where to take x from.

    Returns:
        iterator of pairs, numerator and positive denominator.

    Cost: O(n + k) for n edges of the function that has fewer, and k of the other one over it when
    it is turned about o; O(log) of the others.
    """
    first, second = put_longer_first(first, second)
    ox, oy, ow = o
    # B turned about o runs from left to right, and A + B passes o as A passes the turned B.
    below = [
        (
            (ox * rw - rx * ow, oy * rw - ry * ow, rw * ow),
            (ox * lw - lx * ow, oy * lw - ly * ow, lw * ow),
            (a * ow, b * ow, -a * ox - b * oy - c * ow),
        )
        for (lx, ly, lw), (rx, ry, rw), (a, b, c) in reversed(second.edges)
    ]
    above = first.edges
    i, j = first.first_reaching(below[0][0][0], below[0][0][2]), 0
    # Just right of x, the turned B has been moved to the right a little: an edge of A that ends
    # where an edge of B begins is past, and one of B that ends where one of A begins is not.
    while i < len(above) and _order(above[i][1], below[0][0], -side) <= 0:
        i += 1
    while j < len(below) and _order(below[j][1], above[0][0], side) <= 0:
        j += 1
    if i == len(above) or j == len(below):
        return
    (px, py, pw), (qx, qy, qw), (a, b, c) = above[i]
    (rx, ry, rw), (sx, sy, sw), (d, e, f) = below[j]
    if px * rw >= rx * pw:
        yield d * px + e * py + f * pw, e * pw
    else:
        yield -(a * rx + b * ry + c * rw), b * rw
    while True:
        order = _order((qx, qy, qw), (sx, sy, sw), -side)
        if order > 0:
            yield -(a * sx + b * sy + c * sw), b * sw
            j += 1
            if j == len(below):
                return
            before = sx, sy, sw
            left, (sx, sy, sw), (d, e, f) = below[j]
            if left != before:
                rx, ry, rw = left
                yield -(a * rx + b * ry + c * rw), b * rw
            continue
        yield d * qx + e * qy + f * qw, e * qw
        i += 1
        j += order == 0
        if i == len(above) or j == len(below):
            return
        before = qx, qy, qw
        left, (qx, qy, qw), (a, b, c) = above[i]
        _, (sx, sy, sw), (d, e, f) = below[j]
        if left != before or order == 0:
            px, py, pw = left
            yield d * px + e * py + f * pw, e * pw


def _order(p: Node, q: Node, tie: int) -> int:
    """Negative if p is left of q, positive if it is right of q, and the tie if neither."""
    return p[0] * q[2] - q[0] * p[2] or tie
