"""X-monotone chains, their convex parts, and the reverse and inverse operators.

Sections 1 and 3, Definitions 3.1 and 5.1. A polygon that is monotone to the X axis falls into
a bottom chain and a top chain (Figure 2). Both are kept counter-clockwise, as the paper has
them: a bottom chain runs from left to right, a top chain from right to left. Vertical edges may
stand anywhere in a chain (weak monotonicity).

Errata. The paper calls a chain convex when closing it by a straight edge gives a convex polygon;
that holds for a chain that bulges to either side, and Lemma 3.1 needs the side: here a convex
chain turns left at every vertex. Its slope, "measured clockwise", is meant counter-clockwise.
"""

from __future__ import annotations

from collections.abc import Container, Sequence
from itertools import pairwise
from typing import TypeVar

from exactsweep.geometry.error import ExactSweepError
from exactsweep.geometry.number import negate
from exactsweep.geometry.point import Edge, Vertex

T = TypeVar("T")


class ChainError(ExactSweepError):
    """A sequence of points that is not an X-monotone chain."""


def inverse(chain: Sequence[Vertex]) -> list[Vertex]:
    """Mirror a chain about the origin, in the same order (Definition 5.1).

    The bottom chain of a polygon becomes the top chain of its inverse, and the other way round;
    both keep running counter-clockwise. Cost: O(n).

    >>> inverse([(2, 0), (1, 3), (0, 0)])
    [(-2, 0), (-1, -3), (0, 0)]
    """
    return [
        (-x, -y) if type(x) is int and type(y) is int else (negate(x), negate(y)) for x, y in chain
    ]


def reverse(edges: Sequence[tuple[T, T]]) -> list[tuple[T, T]]:
    """Turn every directed edge round and leave the edges in their order (Definition 3.1).

    Laid end to end, the reversed edges of a chain are the edges of its `inverse`. Cost: O(n).

    >>> reverse([((2, 0), (1, 3)), ((1, 3), (0, 0))])
    [((1, 3), (2, 0)), ((0, 0), (1, 3))]
    """
    return [(end, start) for start, end in edges]


def complement(chain: Sequence[Vertex]) -> list[Vertex]:
    """The same chain as the boundary of the other side (Definition 5.2).

    The interior of a polygon lies left of its boundary; the complement's lies left of the boundary
    walked the other way. Cost: O(n).

    >>> complement([(0, 0), (1, -1), (2, 0)])
    [(2, 0), (1, -1), (0, 0)]
    """
    return list(reversed(chain))


def find_convex_parts(chain: Sequence[Vertex]) -> list[list[Vertex]]:
    """Split a bottom chain at its reflex vertices into convex chains without vertical edges.

    Adjacent parts share the reflex vertex (Section 4, step 1). Collinear edges become one, and
    repeated points are passed over.

    Args:
        chain: Points from left to right; x must not decrease.

    Returns:
        list of lists of points, each strictly convex and strictly increasing in x.

    Raises:
        ChainError: x decreases, or never increases.

    Cost: O(m).

    >>> find_convex_parts([(0, 0), (1, -2), (2, -1), (3, -3), (3, -4), (5, -4)])
    [[(0, 0), (1, -2), (2, -1)], [(2, -1), (3, -3)], [(3, -4), (5, -4)]]
    """
    if not chain:
        raise ChainError("a chain without points")
    parts: list[list[Vertex]] = []
    part: list[Vertex] = [chain[0]]
    for index in range(1, len(chain)):
        x, y = vertex = chain[index]
        px, py = part[-1]
        dx = x - px
        if dx <= 0:
            if dx < 0:
                raise ChainError(
                    f"point {index} lies left of point {index - 1}: not an X-monotone chain"
                )
            if y == py:
                continue
            # A vertical edge bounds its neighbours from the side only: as functions of x they
            # jump there, and what the sweep sees of the edge follows from their closed ends.
            if len(part) > 1:
                parts.append(part)
            part = [vertex]
            continue
        if len(part) > 1:
            qx, qy = part[-2]
            turn = (px - qx) * (y - py) - (py - qy) * dx
            if turn == 0:
                part[-1] = vertex
                continue
            if turn < 0:
                parts.append(part)
                part = [part[-1]]
        part.append(vertex)
    if len(part) > 1:
        parts.append(part)
    if not parts:
        raise ChainError("a chain of no width: all of its edges are vertical")
    return parts


def require_convex(chain: Sequence[Vertex]) -> list[Vertex]:
    """Return a bottom chain that has but one convex part.

    Raises ChainError when it is not convex, or has a vertical edge between others. Cost: O(n).

    >>> require_convex([(0, 0), (1, -1), (2, -2), (3, 0)])
    [(0, 0), (2, -2), (3, 0)]
    """
    parts = find_convex_parts(chain)
    if len(parts) > 1:
        x, y = parts[1][0]
        raise ChainError(f"the chain is not convex: it is reflex, or has a wall, at ({x}, {y})")
    return parts[0]


def list_graph_edges(chain: Sequence[Vertex]) -> list[Edge]:
    """The edges of a chain that are not vertical. Cost: O(n).

    >>> list_graph_edges([(0, 0), (1, 0), (1, 2), (2, 2)])
    [((0, 0), (1, 0)), ((1, 2), (2, 2))]
    """
    return [(p, q) for p, q in pairwise(chain) if p[0] != q[0]]


def take_corners(chain: Sequence[Vertex], suspects: Container[int] | None = None) -> list[Vertex]:
    """Leave out repeated points, and those that lie straight between their neighbours.

    Args:
        chain: points in order; the line never turns back on itself.
        suspects: the numbers of the points that may lie straight or be repeated, or repeat the
            one before; all if left out.

    Cost: O(n).

    >>> take_corners([(0, 0), (1, 1), (1, 1), (2, 2), (3, 0)])
    [(0, 0), (2, 2), (3, 0)]
    """
    kept: list[Vertex] = []
    before = False
    for k, point in enumerate(chain):
        suspect = suspects is None or k in suspects
        if kept and (before or suspect) and kept[-1] == point:
            before = True
            continue
        if before and len(kept) > 1 and _straight(kept[-2], kept[-1], point):
            kept.pop()
        kept.append(point)
        before = suspect
    return kept


def _straight(p: Vertex, q: Vertex, r: Vertex) -> bool:
    """Whether three points lie on one line: a difference of Fractions would first be reduced."""
    if all(type(c) is int for c in (*p, *q, *r)):
        return (q[0] - p[0]) * (r[1] - q[1]) == (q[1] - p[1]) * (r[0] - q[0])
    (px, pd), (qx, qd), (rx, rd) = (x.as_integer_ratio() for x, _ in (p, q, r))
    (py, pe), (qy, qe), (ry, re) = (y.as_integer_ratio() for _, y in (p, q, r))
    first, second = (
        (qx * pd - px * qd) * (ry * qe - qy * re),
        (qy * pe - py * qe) * (rx * qd - qx * rd),
    )
    return first * pe * rd == second * pd * re


def split(loop: Sequence[Vertex]) -> tuple[list[Vertex], list[Vertex]]:
    """Split an X-monotone polygon into its bottom and its top chain (Section 2, Figure 2).

    Vertical edges at the left and at the right extreme belong to neither.

    Args:
        loop: Vertices, counter-clockwise, not closed, starting anywhere.

    Returns:
        (bottom, left to right; top, right to left).

    Raises:
        ChainError: when the polygon is not monotone to the X axis.

    Cost: O(n).

    >>> split([(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)])
    ([(0, 0), (2, 0)], [(2, 1), (1, 2), (0, 1)])
    """
    start, highest = loop.index(min(loop)), max(loop)
    ring = [*loop[start:], *loop[:start]]
    end = ring.index(highest)
    # Up to its greatest vertex, the upper end of a vertical edge on the right, if there is one.
    bottom, top = ring[: end + 1], ring[end:]
    while bottom[-2][0] == highest[0]:
        bottom.pop()
    if top[-1][0] != bottom[0][0]:
        top.append(ring[0])
    forth, back = [x for x, _ in bottom], [x for x, _ in top]
    if forth != sorted(forth) or back != sorted(back, reverse=True):
        raise ChainError("the polygon is not monotone to the X axis")
    return bottom, top
