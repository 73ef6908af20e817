"""Canonical rings: conversion or rejection of closed polygonal lines; area and centroid."""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any, NamedTuple, cast

from exactsweep.geometry.simplicity import find_conflict
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Point, Vertex
from exactsweep.numbers.unreduced import unreduced_points


class PolygonError(ExactSweepError):
    """Vertices that do not bound a simple polygon; the message names indices in the input."""


class CanonicalRing(NamedTuple):
    """A canonical ring: counter-clockwise, only corners, lexicographically least vertex first.

    `vertex_index` and `edge_index` map its vertices and edges to input indices; `monotone`
    refers to the X axis.
    """

    points: tuple[Vertex, ...]
    vertex_index: tuple[int, ...]
    edge_index: tuple[int, ...]
    convex: bool
    monotone: bool


def canonicalize_ring(points: Sequence[Vertex]) -> CanonicalRing:
    """Convert a closed polygonal line of lattice points to canonical form.

    Either orientation, equal neighbors and collinear vertices are allowed. Raises PolygonError for
    fewer than three distinct points, zero area, a spike, or a line that touches or crosses itself.
    Cost: O(n) for a convex ring, otherwise as for `find_conflict`.

    >>> ring = canonicalize_ring([(2, 2), (2, 0), (1, 0), (0, 0), (2, 2)])
    >>> ring.points, ring.vertex_index, ring.edge_index
    (((0, 0), (2, 0), (2, 2)), (3, 1, 0), (1, 0, 3))
    """
    is_long = any(isinstance(c, Fraction) for p in points[:1] for c in p)
    # The code below only subtracts, multiplies and compares coordinates.
    compared = cast(Sequence[Vertex], unreduced_points(points)) if is_long else points
    ring, vertices, edges = _join_equal(compared)
    turns = find_turns(ring)
    if not any(turns):
        distinct = len(set(points))
        raise PolygonError(
            "zero area: all vertices lie on one line"
            if distinct > 2
            else f"fewer than three distinct vertices: {distinct} among the {len(points)} given"
        )
    _refuse_spikes(ring, turns, vertices)
    # Without spikes, a vertex without a turn lies inside a straight edge.
    corners = [i for i, turn in enumerate(turns) if turn]
    least = min(range(len(corners)), key=lambda k: ring[corners[k]])
    # The turn at the least vertex of a simple polygon gives its orientation.
    if turns[corners[least]] > 0:
        corners = starts = [*corners[least:], *corners[:least]]
    else:
        corners = [*corners[least::-1], *corners[:least:-1]]
        # In reverse order, the edge from corner k to corner k + 1 starts at corner k + 1.
        starts = [*corners[1:], corners[0]]
    convex = len({turns[i] > 0 for i in corners}) == 1
    monotone = are_chains_monotone([ring[i] for i in corners])
    # A ring with only left turns is simple if x increases along just one run of its edges.
    if not (convex and monotone):
        _refuse_conflicts(ring, vertices, edges)
    numbers = tuple(vertices[i] for i in corners)
    found = tuple(points[i] for i in numbers)
    return CanonicalRing(found, numbers, tuple(edges[i] for i in starts), convex, monotone)


def are_chains_monotone(ring: Sequence[Vertex]) -> bool:
    """Decide whether x never decreases up to the greatest vertex and never increases after it."""
    right = ring.index(max(ring))
    xs = [x for x, _ in ring]
    forth, back = xs[: right + 1], xs[right:]
    return forth == sorted(forth) and back == sorted(back, reverse=True)


def _join_equal(
    points: Sequence[Vertex],
) -> tuple[Sequence[Vertex], Sequence[int], Sequence[int]]:
    """Merge cyclic runs of equal vertices; return one of each run, its least and its last index."""
    starts = [i for i, point in enumerate(points) if point != points[i - 1]]
    edges = [(i - 1) % len(points) for i in (*starts[1:], *starts[:1])]
    vertices = starts if starts[:1] == [0] else [*starts[:-1], 0]
    return [points[i] for i in starts], vertices, edges


def find_turns(ring: Sequence[Vertex]) -> list[int | Fraction]:
    """Return the cross product of the edges before and after each vertex."""
    after = [*ring[1:], *ring[:1]]
    steps = [(qx - px, qy - py) for (px, py), (qx, qy) in zip(ring, after, strict=True)]
    before = [*steps[-1:], *steps[:-1]]
    return [ax * by - ay * bx for (ax, ay), (bx, by) in zip(before, steps, strict=True)]


def _refuse_spikes(
    ring: Sequence[Vertex], turns: Sequence[int | Fraction], names: Sequence[int]
) -> None:
    for i, turn in enumerate(turns):
        if turn == 0:
            (ax, ay), (bx, by), (cx, cy) = ring[i - 1], ring[i], ring[(i + 1) % len(ring)]
            if (bx - ax) * (cx - bx) < (by - ay) * (by - cy):
                raise PolygonError(f"spike at vertex {names[i]}: the boundary reverses direction")


def _refuse_conflicts(
    ring: Sequence[Vertex], vertices: Sequence[int], edges: Sequence[int]
) -> None:
    conflict = find_conflict(ring)
    if conflict is None:
        return
    kind, i, j = conflict
    if kind == "vertex touches edge":
        what = f"touches itself: vertex {vertices[i]} lies on edge {edges[j]}"
    else:
        names = edges if kind == "edges cross" else vertices
        low, high = sorted((names[i], names[j]))
        what = (
            f"crosses itself: edges {low} and {high} cross"
            if kind == "edges cross"
            else f"touches itself: vertices {low} and {high} coincide"
        )
    raise PolygonError(f"the boundary {what}")


def find_doubled_area(ring: Sequence[Vertex]) -> int | Fraction:
    """Return twice the signed area, positive for a counter-clockwise ring.

    Cost: O(n) for ints; for Fractions, as for `add_up`.
    """
    is_integral = all(type(part) is int for point in ring for part in point)
    points: Any = ring if is_integral else unreduced_points(ring)
    after = (*points[1:], points[0])
    terms = [ax * by - ay * bx for (ax, ay), (bx, by) in zip(points, after, strict=True)]
    return sum(terms) if is_integral else add_up(Fraction(term.n, term.d) for term in terms)


def find_centroid(ring: Sequence[Point]) -> Point:
    """Find the centroid of a ring; the first point if the area is zero.

    >>> from exactsweep import Polygon
    >>> print(*find_centroid(Polygon([(0, 0), (3, 0), (0, 6)]).vertices))
    1 2
    """
    edges = [*zip(ring, (*ring[1:], ring[0]), strict=True)]
    weights = [p.x * q.y - p.y * q.x for p, q in edges]
    double = add_up(weights)
    if not double:
        return ring[0]
    x, y = (
        add_up((p[k] + q[k]) * weight for (p, q), weight in zip(edges, weights, strict=True))
        for k in (0, 1)
    )
    return Point(x / (3 * double), y / (3 * double))
