"""From a closed line as it was written down to a canonical ring, or a refusal that says where."""

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from exactsweep.geometry.error import ExactSweepError
from exactsweep.geometry.point import LatticePoint
from exactsweep.geometry.simplicity import find_conflict


class PolygonError(ExactSweepError):
    """Vertices that do not bound a simple polygon; the message names indices in the input."""


class Ring(NamedTuple):
    """A canonical ring: counter-clockwise, only corners, lexicographically least vertex first.

    `vertex_index` and `edge_index` lead from its vertices and edges back to those of the input.
    """

    points: tuple[LatticePoint, ...]
    vertex_index: tuple[int, ...]
    edge_index: tuple[int, ...]


def canonical_ring(points: Sequence[LatticePoint]) -> Ring:
    """Bring a closed line of integer points into canonical form.

    Args:
        points: in either orientation; neighbours may be equal, the last and the first too, and
            vertices may lie inside straight edges.

    Returns:
        The same polygon as a Ring.

    Raises:
        PolygonError: fewer than three distinct points, all on one line, a spike, or a line that
            touches or crosses itself.

    Cost: that of `find_conflict`.

    Example:
        >>> canonical_ring([(2, 2), (2, 0), (1, 0), (0, 0), (2, 2)])
        Ring(points=((0, 0), (2, 0), (2, 2)), vertex_index=(3, 1, 0), edge_index=(1, 0, 3))
    """
    distinct = len(set(points))
    if distinct < 3:
        raise PolygonError(
            f"fewer than three distinct vertices: {distinct} among the {len(points)} given"
        )
    # Runs of equal neighbours, round the end: the vertex is called by the least index of its run,
    # its edge starts at the last.
    starts = [i for i, point in enumerate(points) if point != points[i - 1]]
    ring = [points[i] for i in starts]
    edges = [(i - 1) % len(points) for i in (*starts[1:], starts[0])]
    vertices = starts if starts[0] == 0 else [*starts[:-1], 0]

    turns = turn_products(ring)
    if not any(turns):
        raise PolygonError("zero area: all vertices lie on one line")
    _refuse_spikes(ring, turns, vertices)
    _refuse_conflicts(ring, vertices, edges)

    # Spikes are gone, so a vertex without a turn lies inside a straight edge.
    corners = [i for i, turn in enumerate(turns) if turn]
    if doubled_area(ring) < 0:
        corners.reverse()
        # Read backwards, the edge from corner k to corner k + 1 starts at the latter.
        edge_starts = [*corners[1:], corners[0]]
    else:
        edge_starts = corners
    least = min(range(len(corners)), key=lambda k: ring[corners[k]])
    corners = corners[least:] + corners[:least]
    edge_starts = edge_starts[least:] + edge_starts[:least]
    return Ring(
        tuple(ring[i] for i in corners),
        tuple(vertices[i] for i in corners),
        tuple(edges[i] for i in edge_starts),
    )


def turn_products(ring: Sequence[LatticePoint]) -> list[int | Fraction]:
    """Return at each vertex the cross product of the edges before and after it. Cost: O(n)."""
    turns = []
    (ax, ay), (bx, by) = ring[-2], ring[-1]
    ux, uy = bx - ax, by - ay
    for cx, cy in ring:
        vx, vy = cx - bx, cy - by
        turns.append(ux * vy - uy * vx)
        bx, by, ux, uy = cx, cy, vx, vy
    # The first turn met belongs to the last vertex.
    return turns[1:] + turns[:1]


def _refuse_spikes(
    ring: Sequence[LatticePoint], turns: Sequence[int | Fraction], names: Sequence[int]
) -> None:
    n = len(ring)
    for i, turn in enumerate(turns):
        if turn == 0:
            (ax, ay), (bx, by), (cx, cy) = ring[i - 1], ring[i], ring[(i + 1) % n]
            if (bx - ax) * (cx - bx) + (by - ay) * (cy - by) < 0:
                raise PolygonError(f"spike at vertex {names[i]}: the boundary turns straight back")


def _refuse_conflicts(
    ring: Sequence[LatticePoint], vertices: Sequence[int], edges: Sequence[int]
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


def doubled_area(ring: Sequence[LatticePoint]) -> int | Fraction:
    """Return twice the signed area, positive for a counter-clockwise ring. Cost: O(n)."""
    return sum(
        ax * by - ay * bx for (ax, ay), (bx, by) in zip(ring, (*ring[1:], ring[0]), strict=True)
    )
