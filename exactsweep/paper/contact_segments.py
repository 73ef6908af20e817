"""Contact segments: positions at which a vertex of one shape touches an edge of the other.

Each is the sum of a vertex of D or of H = -G and an edge of the other shape. A segment is dropped
if D and G + t overlap next to the contact: an angle at the vertex reaches to the right of the edge.
A position at which two vertices meet is an end of a remaining segment: if two angles have no common
direction, one of them lies beyond a side of the other. Where rings touch, a vertex has several
angles; these positions need not lie on a segment, and are returned as points.
"""

from bisect import bisect_left, bisect_right
from collections.abc import Iterator
from itertools import chain, product

from exactsweep.check.cone import Cone, by_turn, find_common_direction, subtract
from exactsweep.check.meeting import Cones, find_cones_of, split_where_touching
from exactsweep.check.shape import LatticeShape, list_edges
from exactsweep.numbers.number import Edge, Vertex

_Angles = dict[Vertex, Cones]


def find_contacts(d: LatticeShape, h: LatticeShape) -> tuple[list[Edge], set[Vertex]]:
    """Find segments and points that contain all positions of contact without overlap.

    Cost: O((m + n) log(m + n)) for m and n edges, and O(1) per segment.
    """
    shapes = split_where_touching(d), split_where_touching(h)
    one, other = map(find_cones_of, shapes)
    segments = [*_list_sums(one, shapes[1]), *_list_sums(other, shapes[0])]
    pinched_d, pinched_h = ([(p, c) for p, c in of.items() if len(c) > 1] for of in (one, other))
    points = {
        _add(p, q)
        for (p, cones), (q, others) in chain(
            product(pinched_d, other.items()), product(one.items(), pinched_h)
        )
        if not find_common_direction(
            cones, [Cone(_negate(c.start), _negate(c.end)) for c in others]
        )
    }
    return segments, points


def _list_sums(angles: _Angles, walls: LatticeShape) -> Iterator[Edge]:
    """Yield the sums of a vertex and an edge with no angle that reaches to the edge's right."""
    directions = sorted((by_turn(subtract(b, a)), (a, b)) for a, b in list_edges(walls))
    keys = [key for key, _ in directions]
    for v, (cone, *others) in angles.items():
        if not cone.is_wide:
            start, end = by_turn(_negate(cone.end)), by_turn(cone.start)
            k, j = bisect_left(keys, start), bisect_right(keys, end)
            for _, (a, b) in directions[k:j] if start <= end else directions[k:] + directions[:j]:
                right = [Cone(subtract(a, b), subtract(b, a))] if others else []
                if not find_common_direction(others, right):
                    yield _add(v, a), _add(v, b)


def _negate(p: Vertex) -> Vertex:
    return -p[0], -p[1]


def _add(p: Vertex, q: Vertex) -> Vertex:
    return p[0] + q[0], p[1] + q[1]
