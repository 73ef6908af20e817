"""Which edges of one polygon can rest on which vertices of another one.

An edge e touches a vertex v from outside only if both edges at v run on the other side of the line
through e: v is convex, and e reversed has its place between them in the order of directions.  For
two convex polygons that leaves one vertex for each edge, or two where edges are parallel.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from exactsweep.chain import Edge, Vertex
from exactsweep.direction import angle_key
from exactsweep.line import direction_of


def facing(edges: Mapping[int, Edge], loop: Sequence[Vertex]) -> Iterator[tuple[int, int]]:
    """Pairs of an edge and a vertex that can touch without overlap.

    Args:
        edges: edges of a polygon that has its interior on their left, by number.
        loop: the other polygon, counter-clockwise, no three neighbours collinear.

    Returns:
        (number of the edge, index of the vertex).

    Cost: O((m + n) log n + pairs) for n edges and m vertices.

    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> sorted(facing({0: ((0, 0), (1, 0)), 1: ((1, 0), (0, 1))}, square))
    [(0, 2), (0, 3), (1, 0)]
    """
    order = sorted((_angle((q, p)), i) for i, (p, q) in edges.items())
    angles = [angle for angle, _ in order]
    size = len(loop)
    for j, v in enumerate(loop):
        before, after = loop[j - 1], loop[(j + 1) % size]
        if (v[0] - before[0]) * (after[1] - v[1]) <= (v[1] - before[1]) * (after[0] - v[0]):
            continue
        first, last = _angle((before, v)), _angle((v, after))
        start, end = bisect_left(angles, first), bisect_right(angles, last)
        found = order[start:end] if first <= last else order[start:] + order[:end]
        for _, i in found:
            yield i, j


def _angle(edge: Edge) -> tuple[bool, Any]:
    """A key that orders directed edges by angle, from -90 degrees, exclusive, all round."""
    (px, py), (qx, qy) = edge
    backward = qx < px or (qx == px and qy < py)
    return backward, angle_key(direction_of(edge))
