"""From the boundary of a union of open sets to loops and exact fits.

The boundary comes as pieces of lines and single points. Split wherever they meet, each edge has
one neighbour on either side: the union or free space. An edge with free space on one side belongs
to a loop; one with the union on both sides is part of an exact fit; none is free on both sides.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from math import ceil, floor
from typing import NamedTuple

from exactsweep.check.boxes import BoxTree, Rectangle
from exactsweep.check.cone import by_turn, divide, subtract
from exactsweep.check.standalone import Work
from exactsweep.check.uncovered import LinePiece, OpenSets, find_axis
from exactsweep.geometry.canonical import canonicalize_ring, find_doubled_area
from exactsweep.numbers.number import Edge, Rational, Vertex


class WalkedLoop(NamedTuple):
    """A simple loop in walking order, with free space on its left, and a point inside an edge.

    No other loop passes through that point.
    """

    points: tuple[Vertex, ...]
    beside: Vertex

    @property
    def is_hole(self) -> bool:
        """Decide whether the free side is inside: the loop is walked counter-clockwise."""
        return find_doubled_area(self.points) > 0


class Boundary(NamedTuple):
    """Loops, and exact fits as pairs of points, the end that hangs on a loop first."""

    loops: list[WalkedLoop]
    fits: list[Edge]


def canonicalize(points: Sequence[Vertex]) -> tuple[Vertex, ...]:
    """The canonical form of a simple loop."""
    return canonicalize_ring(points).points


def assemble(
    pieces: Sequence[LinePiece], points: Iterable[Vertex], sets: OpenSets, budget: Work
) -> Boundary:
    """Assemble loops and fits.

    Args:
        pieces: of lines, those on one line apart from each other.
        points: single points; those that are on a piece are left out.
        sets: the open sets, which all pieces and points are free of.
        budget: the steps that it may take.

    Returns:
        Boundary. Loops are simple and may touch in vertices.

    Cost: O(p**2) for p pieces at worst, and the number of sets near each edge; by those that meet.
    """
    boxes = [piece.box for piece in pieces]
    tree = BoxTree(boxes, budget)
    cuts = _find_cuts(pieces, boxes, tree, 2 * sets.bits, budget)
    ahead: dict[Vertex, list[Vertex]] = defaultdict(list)
    slits: list[list[Edge]] = []
    for piece, at in zip(pieces, cuts, strict=True):
        slits.append([])
        for low, high in pairwise(sorted(at)):
            middle = divide(low + high, 2)
            left, right = (not sets.is_beside(piece.line, middle, side) for side in (1, -1))
            p, q = at[low], at[high]
            if left:
                ahead[p].append(q)
            elif right:
                ahead[q].append(p)
            else:
                slits[-1].append((p, q))
    on_loops = set(ahead)
    fits = [fit for edges in slits for fit in _join(edges, on_loops)]
    for x, y in points:
        near = tree.near((floor(x), ceil(x), floor(y), ceil(y)))
        if not any(_is_on((x, y), pieces[k]) for k in near):
            fits.append(((x, y), (x, y)))
    # At a vertex through which many loops pass, all of them are sorted for each.
    budget.take(sum(4 * len(ends) ** 2 for ends in ahead.values() if len(ends) > 1))
    return Boundary(_walk_loops(ahead), fits)


def _is_on(p: Vertex, piece: LinePiece) -> bool:
    a, b, c = piece.line
    return a * p[0] + b * p[1] + c == 0 and piece.holds(p)


def _find_cuts(
    pieces: Sequence[LinePiece],
    boxes: Sequence[Rectangle],
    tree: BoxTree,
    bits: int,
    budget: Work,
) -> list[dict[Rational, Vertex]]:
    """On each piece its ends and where others meet it, each by its coordinate on the line."""
    cuts = [{piece.low: piece.ends[0], piece.high: piece.ends[1]} for piece in pieces]
    for k, box in enumerate(boxes):
        for j in tree.near(box):
            if j >= k:
                break
            budget.take(4, bits)
            if (p := _find_common_point(pieces[j], pieces[k])) is not None:
                for i in (j, k):
                    cuts[i][p[find_axis(pieces[i].line)]] = p
    return cuts


def _find_common_point(one: LinePiece, other: LinePiece) -> Vertex | None:
    """Find the point where two pieces of different lines meet."""
    (a, b, c), (k, m, n) = one.line, other.line
    turn = a * m - b * k
    if turn == 0:
        return None
    p = divide(b * n - c * m, turn), divide(c * k - a * n, turn)
    return p if one.holds(p) and other.holds(p) else None


def _join(edges: Iterable[Edge], on_loops: set[Vertex]) -> Iterator[Edge]:
    """Join edges that follow each other on a line, except where a loop passes."""
    joined: list[Edge] = []
    for p, q in edges:
        if joined and joined[-1][1] == p and p not in on_loops:
            joined[-1] = joined[-1][0], q
        else:
            joined.append((p, q))
    for p, q in joined:
        yield (q, p) if q in on_loops and p not in on_loops else (p, q)


def _walk_loops(ahead: dict[Vertex, list[Vertex]]) -> list[WalkedLoop]:
    """Walk with free space on the left; cut the walk where it visits a point again."""
    loops = []
    left = {(p, q) for p, ends in ahead.items() for q in ends}
    for start in sorted(left):
        if start not in left:
            continue
        p, q = start
        walk, places = [p], {p: 0}
        while True:
            left.discard((p, q))
            if (k := places.get(q)) is not None:
                (ax, ay), (bx, by) = walk[k : k + 2]
                loops.append(WalkedLoop(tuple(walk[k:]), (divide(ax + bx, 2), divide(ay + by, 2))))
                # The rest of the loop is not met again: around one face no two points alternate.
                del walk[k + 1 :]
            else:
                places[q] = len(walk)
                walk.append(q)
            p, q = q, _choose_next(p, q, ahead[q])
            if (p, q) == start:
                break
    return loops


def _choose_next(p: Vertex, q: Vertex, ends: Sequence[Vertex]) -> Vertex:
    """Choose the next edge around free space: the first one clockwise from the way back."""
    if len(ends) == 1:
        return ends[0]
    back = subtract(p, q)
    turned = sorted((subtract(end, q) for end in ends), key=by_turn)
    before = [way for way in turned if by_turn(way) < by_turn(back)]
    dx, dy = (before or turned)[-1]
    return q[0] + dx, q[1] + dy
