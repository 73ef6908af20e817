"""X-monotone chains, their convex parts, and the reverse and inverse operators.

Sections 1 and 3, Definitions 3.1 and 5.1. A polygon that is monotone to the X axis falls into
a bottom chain and a top chain (Figure 2). Both run counter-clockwise, as in the paper: a bottom
chain from left to right, a top chain from right to left. Vertical edges may stand anywhere in a
chain (weak monotonicity).

Errata. The paper calls a chain convex if a straight edge closes it to a convex polygon. This holds
for chains that bulge to either side, but Lemma 3.1 needs one side. Here a convex chain turns left
at every vertex. The paper measures slopes "clockwise" and means counter-clockwise.
"""

from __future__ import annotations

from collections.abc import Container, Sequence
from itertools import chain as link
from itertools import pairwise
from typing import Any, TypeVar

from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Edge, Rational, Vertex, divide_exactly, negate
from exactsweep.procedures.solution import made_once

T = TypeVar("T")

SlopedPart = tuple[list[Vertex], list[Rational], list[Vertex]]
"""A convex part: its points, and of each edge its slope and the vector (dx, dy)."""


class ChainError(ExactSweepError):
    """A sequence of points that is not an X-monotone chain."""


class KeptChain(list[Vertex]):
    """A chain with a cache, for polygons that are swept many times.

    The chain must not change. `inverse`, `measure_width` and `split_chain` of `convex_part` compute
    their results for it once.

    Attributes:
        parts: the unit of the slopes, and the parts of the last split.
    """

    parts: tuple[Rational | None, list[Any]] | None = None

    @made_once
    def inverted(self) -> KeptChain:
        """The inverse of the chain."""
        return KeptChain(inverse(list(self)))

    @made_once
    def width(self) -> Rational | None:
        """The width of the chain, as `measure_width` returns it."""
        return measure_width(list(self))


def inverse(chain: Sequence[Vertex]) -> list[Vertex]:
    """Mirror a chain about the origin, in the same order (Definition 5.1).

    The bottom chain of a polygon becomes the top chain of its inverse, and the other way round;
    both keep running counter-clockwise. Cost: O(n).

    >>> inverse([(2, 0), (1, 3), (0, 0)])
    [(-2, 0), (-1, -3), (0, 0)]
    """
    if type(chain) is KeptChain:
        return chain.inverted
    return [
        (-x, -y) if type(x) is int and type(y) is int else (negate(x), negate(y)) for x, y in chain
    ]


def reverse(edges: Sequence[tuple[T, T]]) -> list[tuple[T, T]]:
    """Reverse every directed edge and keep the order of the edges (Definition 3.1).

    Laid end to end, the reversed edges of a chain are the edges of its `inverse`. Cost: O(n).

    >>> reverse([((2, 0), (1, 3)), ((1, 3), (0, 0))])
    [((1, 3), (2, 0)), ((0, 0), (1, 3))]
    """
    return [(end, start) for start, end in edges]


def complement(chain: Sequence[Vertex]) -> list[Vertex]:
    """Return the same chain as the boundary of the other side (Definition 5.2).

    The interior of a polygon lies left of its boundary; the complement's lies left of the boundary
    walked the other way. Cost: O(n).

    >>> complement([(0, 0), (1, -1), (2, 0)])
    [(2, 0), (1, -1), (0, 0)]
    """
    return list(reversed(chain))


def measure_width(chain: Sequence[Vertex]) -> Rational | None:
    """Return the width of a chain from left to right, if all coordinates are ints. Cost: O(n).

    >>> measure_width([(0, 0), (2, 1), (3, 0)])
    3
    """
    if type(chain) is KeptChain:
        return chain.width
    if chain and all(issubclass(kind, int) for kind in set(map(type, link.from_iterable(chain)))):
        return chain[-1][0] - chain[0][0]
    return None


def split_by_slope(chain: Sequence[Vertex], unit: Rational | None) -> list[SlopedPart]:
    """Split a bottom chain at its reflex vertices into convex parts, with the slopes of edges.

    The parts are those of `find_convex_parts`. Two different slopes of edges no wider than w differ
    by at least 1 / w^2. So slopes rounded down to multiples of 1 / w^2 keep their order, and are
    equal only if the slopes are. They are stored as ints, in that unit.

    Args:
        chain: points from left to right; x must not decrease.
        unit: the number of units in slope 1: w^2 if all coordinates are ints; or None, for slopes
            that are Fractions.

    Raises:
        ChainError: x decreases, or never increases.

    Cost: O(m).

    >>> split_by_slope([(0, 0), (1, -2), (2, -1)], 4)
    [([(0, 0), (1, -2), (2, -1)], [-8, 4], [(1, -2), (1, 1)])]
    """
    if not chain:
        raise ChainError("a chain without points")
    parts: list[SlopedPart] = []
    points: list[Vertex] = [chain[0]]
    slopes: list[Rational] = []
    edges: list[Vertex] = []
    px, py = chain[0]
    for vertex in chain:
        x, y = vertex
        dx, dy = x - px, y - py
        if dx <= 0:
            if dx < 0:
                index = next(k for k in range(1, len(chain)) if chain[k][0] < chain[k - 1][0])
                raise ChainError(
                    f"point {index} lies left of point {index - 1}: not an X-monotone chain"
                )
            if dy == 0:
                continue
            # A vertical edge bounds its neighbours from the side only. As functions of x they
            # jump there, and their closed ends determine the contacts with the edge.
            if edges:
                parts.append((points, slopes, edges))
            points, slopes, edges = [vertex], [], []
            px, py = vertex
            continue
        slope = divide_exactly(dy, dx) if unit is None else dy * unit // dx
        if slopes and slope <= slopes[-1]:
            if slope == slopes[-1]:
                slopes.pop()
                points.pop()
                along, rise = edges.pop()
                dx, dy = dx + along, dy + rise
            else:
                parts.append((points, slopes, edges))
                points, slopes, edges = [points[-1]], [], []
        slopes.append(slope)
        edges.append((dx, dy))
        points.append(vertex)
        px, py = x, y
    if edges:
        parts.append((points, slopes, edges))
    if not parts:
        raise ChainError("a chain of no width: all of its edges are vertical")
    return parts


def find_convex_parts(chain: Sequence[Vertex]) -> list[list[Vertex]]:
    """Split a bottom chain at its reflex vertices into convex chains without vertical edges.

    Adjacent parts share the reflex vertex (Section 4, step 1). Collinear edges become one edge, and
    repeated points become one point.

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
    width = measure_width(chain)
    return [points for points, _, _ in split_by_slope(chain, width and width * width)]


def require_convex(chain: Sequence[Vertex]) -> list[Vertex]:
    """Return the corners of a convex bottom chain.

    Raises ChainError if the chain is not convex or has a vertical edge inside. Cost: O(n).

    >>> require_convex([(0, 0), (1, -1), (2, -2), (3, 0)])
    [(0, 0), (2, -2), (3, 0)]
    """
    parts = find_convex_parts(chain)
    if len(parts) > 1:
        x, y = parts[1][0]
        raise ChainError(f"the chain is not convex: it is reflex, or has a wall, at ({x}, {y})")
    return parts[0]


def list_graph_edges(chain: Sequence[Vertex]) -> list[Edge]:
    """List the edges of a chain that are not vertical. Cost: O(n).

    >>> list_graph_edges([(0, 0), (1, 0), (1, 2), (2, 2)])
    [((0, 0), (1, 0)), ((1, 2), (2, 2))]
    """
    return [(p, q) for p, q in pairwise(chain) if p[0] != q[0]]


def take_corners(chain: Sequence[Vertex], suspects: Container[int] | None = None) -> list[Vertex]:
    """Drop repeated points, and points on the segment between their neighbours.

    Args:
        chain: points in order; the line never turns back on itself.
        suspects: the indices of points that may have to be dropped, or that may repeat the point
            before; all points by default.

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
    """Decide whether three points are collinear, without differences of Fractions."""
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

    Vertical edges at the left and at the right extreme belong to neither chain.

    Args:
        loop: vertices, counter-clockwise, not closed, starting anywhere.

    Returns:
        (bottom, left to right; top, right to left).

    Raises:
        ChainError: the polygon is not monotone to the X axis.

    Cost: O(n).

    >>> split([(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)])
    ([(0, 0), (2, 0)], [(2, 1), (1, 2), (0, 1)])
    """
    start, highest = loop.index(min(loop)), max(loop)
    ring = [*loop[start:], *loop[:start]]
    end = ring.index(highest)
    # The bottom chain runs to the greatest vertex, the upper end of a vertical edge on the right.
    bottom, top = ring[: end + 1], ring[end:]
    while bottom[-2][0] == highest[0]:
        bottom.pop()
    if top[-1][0] != bottom[0][0]:
        top.append(ring[0])
    forth, back = [x for x, _ in bottom], [x for x, _ in top]
    if forth != sorted(forth) or back != sorted(back, reverse=True):
        raise ChainError("the polygon is not monotone to the X axis")
    return bottom, top
