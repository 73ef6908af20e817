"""Canonical rings: conversion or rejection of closed lines; area and centroid."""

from collections.abc import Sequence
from fractions import Fraction
from operator import eq, floordiv
from typing import NamedTuple, cast

from exactsweep.geometry.simplicity import find_conflict
from exactsweep.numbers.addition import add_ratios, add_up
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.lazy_number import lazy_points
from exactsweep.numbers.number import Point, Vertex, split_ratios


class PolygonError(ExactSweepError):
    """Vertices that do not bound a simple polygon; the message names indices in the input."""


class CanonicalRing(NamedTuple):
    """A canonical ring: counter-clockwise, only corners, lexicographically least vertex first.

    `vertex_index` and `edge_index` map its vertices and edges to those of the input; `monotone`
    refers to the X axis.
    """

    points: tuple[Vertex, ...]
    vertex_index: tuple[int, ...]
    edge_index: tuple[int, ...]
    convex: bool
    monotone: bool


def canonicalize_ring(points: Sequence[Vertex]) -> CanonicalRing:
    """Bring a closed line of lattice points into canonical form.

    The orientation is free; equal neighbours and collinear vertices are allowed. Raises
    PolygonError for fewer than three distinct points, collinear points only, a spike, or a line
    that touches or crosses itself. Cost: O(n) for a ring that is monotone to the X axis, otherwise
    that of `find_conflict`.

    >>> ring = canonicalize_ring([(2, 2), (2, 0), (1, 0), (0, 0), (2, 2)])
    >>> ring.points, ring.vertex_index, ring.edge_index
    (((0, 0), (2, 0), (2, 2)), (3, 1, 0), (1, 0, 3))
    """
    is_long = any(isinstance(c, Fraction) for p in points[:1] for c in p)
    # They are compared, subtracted and multiplied below, and nothing else.
    compared = cast(Sequence[Vertex], lazy_points(points)) if is_long else points
    ring, vertices, edges = _join_equal(compared)
    turns = find_turns(ring) if len(ring) > 2 else []
    if is_long:
        # Only the signs are used.
        turns = [(turn > 0) - (turn < 0) for turn in turns]
    corners: Sequence[int] = range(len(ring))
    if not all(turns) or not turns:
        _refuse_flat(points, turns)
        _refuse_spikes(ring, turns, vertices)
        # Spikes are gone, so a vertex without a turn lies inside a straight edge.
        corners = [i for i, turn in enumerate(turns) if turn]
        turns = [turn for turn in turns if turn]
    found = ring if len(corners) == len(ring) else [ring[i] for i in corners]
    least = found.index(min(found))
    starts = corners
    # A simple polygon turns at its least vertex in the direction of its orientation.
    if turns[least] < 0:
        corners = [*corners[least::-1], *corners[:least:-1]]
        # In reverse order, the edge from corner k to corner k + 1 starts at corner k + 1.
        starts = [*corners[1:], corners[0]]
        found = [*found[least::-1], *found[:least:-1]]
    elif least:
        corners = starts = [*corners[least:], *corners[:least]]
        found = [*found[least:], *found[:least]]
    convex = (min(turns) > 0) == (max(turns) > 0)
    monotone = is_simple_monotone(found, convex=convex)
    if not monotone:
        _refuse_conflicts(ring, vertices, edges)
    if len(ring) != len(points):
        corners, starts = [vertices[i] for i in corners], [edges[i] for i in starts]
    if is_long:
        found = [points[i] for i in corners]
    return CanonicalRing(tuple(found), tuple(corners), tuple(starts), convex, monotone)


# Let a canonical ring be weakly monotone to the X axis. Its bottom chain runs from the least vertex
# p to the greatest vertex q, its top chain from q back to p. At each x in [p.x, q.x] each chain is
# an interval. Between consecutive vertex abscissas the interval endpoints are linear in x. So
#
#     (1)  the ring is simple if, at the x of each vertex except p and q, the whole interval of the
#          bottom chain lies below that of the top chain;
#     (2)  at x in (p.x, q.x), an end of either interval is a vertex or lies inside an edge that is
#          not vertical. So it suffices that each vertex of one chain lies strictly on its side of
#          the edge of the other chain above or below it, and of the other chain's vertices at the
#          same x, of which there are two at most, the ends of a wall;
#     (3)  at p.x the bottom chain has p alone, because the ring turns left there. A vertex of the
#          top chain at q.x is not above the last edge of the bottom chain, so (2) rejects it.


def is_simple_monotone(ring: Sequence[Vertex], *, convex: bool) -> bool:
    """Decide whether a ring is both simple and weakly monotone to the X axis.

    The ring begins with its least vertex, where it turns left, and has corners only. If all turns
    are left turns (`convex`), monotonicity suffices: such a boundary winds around once for each run
    to the right. Cost: O(n), two products a vertex; for a convex ring comparisons of x alone.

    >>> is_simple_monotone([(0, 0), (2, 1), (4, 0), (2, 2)], convex=False)
    True
    >>> is_simple_monotone([(0, 0), (2, 2), (4, 0), (2, 1)], convex=False)
    False
    """
    if not are_chains_monotone(ring):
        return False
    if convex:
        return True
    right = ring.index(max(ring))
    top = [ring[0], *ring[: right - 1 : -1]]
    k = 1
    (ax, ay), (bx, by), (px, py) = top[0], top[1], ring[0]
    for x, y in ring[1:right]:
        while bx < x:
            if (x - px) * (by - py) <= (y - py) * (bx - px):
                return False
            ax, ay = bx, by
            k += 1
            bx, by = top[k]
        if (bx - ax) * (y - ay) >= (by - ay) * (x - ax):
            return False
        # The walk has passed the vertex at the near end of a wall, but not that at its far end.
        if bx == x and k + 1 < len(top) and top[k + 1][0] == x and top[k + 1][1] <= y:
            return False
        px, py = x, y
    x, y = ring[right]
    return all((x - px) * (v - py) > (y - py) * (u - px) for u, v in top[k:-1])


def are_chains_monotone(ring: Sequence[Vertex]) -> bool:
    """Decide whether x never decreases to the greatest vertex and never increases on the way back.

    The ring begins at its least vertex. Cost: O(n).
    """
    right = ring.index(max(ring))
    xs = [x for x, _ in ring]
    forth, back = xs[: right + 1], xs[right:]
    return forth == sorted(forth) and back == sorted(back, reverse=True)


def _join_equal(
    points: Sequence[Vertex],
) -> tuple[Sequence[Vertex], Sequence[int], Sequence[int]]:
    """Replace each run of equal neighbours, cyclically, by one vertex.

    Returns the vertices, the least index of each run, and its last index, where its edge starts.
    """
    size = len(points)
    if points[:1] != points[-1:] and not any(map(eq, points, points[1:])):
        return points, range(size), range(size)
    starts = [i for i, point in enumerate(points) if point != points[i - 1]]
    edges = [(i - 1) % size for i in (*starts[1:], *starts[:1])]
    vertices = starts if starts[:1] == [0] else [*starts[:-1], 0]
    return [points[i] for i in starts], vertices, edges


def find_turns(ring: Sequence[Vertex]) -> list[int | Fraction]:
    """Return at each vertex the cross product of the edges before and after it."""
    turns = []
    (ax, ay), (bx, by) = ring[-2], ring[-1]
    ux, uy = bx - ax, by - ay
    for cx, cy in ring:
        vx, vy = cx - bx, cy - by
        turns.append(ux * vy - uy * vx)
        bx, by, ux, uy = cx, cy, vx, vy
    # The first turn belongs to the last vertex.
    return turns[1:] + turns[:1]


def _refuse_flat(points: Sequence[Vertex], turns: Sequence[int | Fraction]) -> None:
    if not any(turns):
        distinct = len(set(points))
        if distinct < 3:
            raise PolygonError(
                f"fewer than three distinct vertices: {distinct} among the {len(points)} given"
            )
        raise PolygonError("zero area: all vertices lie on one line")


def _refuse_spikes(
    ring: Sequence[Vertex], turns: Sequence[int | Fraction], names: Sequence[int]
) -> None:
    n = len(ring)
    for i, turn in enumerate(turns):
        if turn == 0:
            (ax, ay), (bx, by), (cx, cy) = ring[i - 1], ring[i], ring[(i + 1) % n]
            if (bx - ax) * (cx - bx) < (by - ay) * (by - cy):
                raise PolygonError(f"spike at vertex {names[i]}: the boundary reverses direction")


def _refuse_conflicts(
    ring: Sequence[Vertex], vertices: Sequence[int], edges: Sequence[int]
) -> None:
    conflict = find_conflict(ring)
    if conflict is None:
        return
    kind, first, second = conflict
    if kind == "vertices coincide":
        low, high = sorted((vertices[first], vertices[second]))
        raise PolygonError(f"the boundary touches itself: vertices {low} and {high} coincide")
    if kind == "vertex touches edge":
        raise PolygonError(
            f"the boundary touches itself: vertex {vertices[first]} lies on edge {edges[second]}"
        )
    low, high = sorted((edges[first], edges[second]))
    raise PolygonError(f"the boundary crosses itself: edges {low} and {high} cross")


def find_least(points: Sequence[Point]) -> int:
    """Return the index of the lexicographically least point, the first of equal ones.

    Fractions are compared only if their floors are equal, which is rare.
    """
    floors = [*map(floordiv, *split_ratios([x for x, _ in points]))]
    least = min(floors)
    return min((k for k, floor in enumerate(floors) if floor == least), key=points.__getitem__)


def find_doubled_area(ring: Sequence[Vertex]) -> int | Fraction:
    """Return twice the signed area, positive for a counter-clockwise ring.

    Cost: O(n) for ints, that of `add_up` for Fractions.
    """
    after = (*ring[1:], ring[0])
    if all(type(part) is int for point in ring for part in point):
        return sum(ax * by - ay * bx for (ax, ay), (bx, by) in zip(ring, after, strict=True))
    terms = []
    for p, q in zip(ring, after, strict=True):
        (a, b), (c, d), (e, f), (g, h) = (part.as_integer_ratio() for part in (*p, *q))
        terms.append((a * g * d * f - c * e * b * h, b * d * f * h))
    return add_ratios(terms)


def find_centroid(ring: Sequence[Point]) -> Point:
    """Find the center of mass of the area in a ring; the first point of a ring without area.

    >>> from exactsweep import Polygon
    >>> print(*find_centroid(Polygon([(0, 0), (3, 0), (0, 6)]).vertices))
    1 2
    """
    double = Fraction(find_doubled_area(ring))
    if not double:
        return ring[0]
    edges = [*zip(ring, (*ring[1:], ring[0]), strict=True)]
    weights = [p.x * q.y - p.y * q.x for p, q in edges]
    x, y = (
        add_up((p[k] + q[k]) * weight for (p, q), weight in zip(edges, weights, strict=True))
        for k in (0, 1)
    )
    return Point(x / (3 * double), y / (3 * double))
