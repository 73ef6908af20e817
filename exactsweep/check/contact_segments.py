"""Contact segments: where a translate can touch a shape, a vertex of one on an edge of the other.

Left out are segments along which the two overlap beside the contact itself: the cones there have a
direction in common. Where two vertices meet, the position is an end of a segment that is left in:
of two angles without a common direction, one lies beyond a side of the other. But where rings touch
there are several angles at a vertex. Such positions are points of their own: two links of a chain
may hold each other by such vertices and nothing else.
"""

from __future__ import annotations

from exactsweep.check.cone import Cone, find_common_direction, reduce_way, subtract
from exactsweep.check.meeting import Cones, find_cones_of, split_where_touching
from exactsweep.check.shape import LatticeRing, LatticeShape, list_edges
from exactsweep.numbers.number import Edge, Vertex


def find_contacts_of_shapes(d: LatticeShape, g: LatticeShape) -> tuple[list[Edge], set[Vertex]]:
    """Translations t at which a vertex of D or G + t is on an edge, or a vertex, of the other.

    Args:
        d: the rings of D, its interior on their left.
        g: those of G.

    Returns:
        Segments and points that hold all positions of contact without overlap.

    Cost: O(mn) for m and n edges.
    """
    d, g = split_where_touching(d), split_where_touching(g)
    d_cones, g_cones = _find_angles(d), _find_angles(g)
    segments = []
    for walls, angles in ((g, d_cones), (d, g_cones)):
        convex = _leave_out_wide(angles)
        for a, b in list_edges(walls):
            wall = [_half_plane(reduce_way(subtract(b, a)))]
            free = [v for v, cones in convex.items() if not find_common_direction(cones, wall)]
            ends = [(subtract(v, a), subtract(v, b)) for v in free]
            segments += ends if walls is g else [(_back(p), _back(q)) for p, q in ends]
    points = {
        subtract(v, w)
        for v, cones in d_cones.items()
        for w, others in g_cones.items()
        if (len(cones) > 1 or len(others) > 1) and not find_common_direction(cones, others)
    }
    return segments, points


def find_contacts_of_curve(curve: LatticeRing, g: LatticeShape) -> list[Edge]:
    """Points p at which p - G touches a closed curve with a vertex of either on an edge.

    Args:
        curve: a ring, of which the line itself counts, not the inside.
        g: the rings of G, its interior on their left.

    Returns:
        Segments that hold all points p where the curve meets p - G but not its interior.

    Cost: O(tn) for t and n edges.
    """
    g = split_where_touching(g)
    segments = []
    ways = [reduce_way(subtract(b, a)) for a, b in list_edges([curve])]
    for a, b in list_edges(g):
        inverse = _half_plane(_back(reduce_way(subtract(b, a))))
        for k, (vx, vy) in enumerate(curve):
            if not any(map(inverse.surrounds, (_back(ways[k - 1]), ways[k]))):
                segments.append(((vx + a[0], vy + a[1]), (vx + b[0], vy + b[1])))
    for w, cones in _find_angles(g).items():
        inverses = [Cone(_back(cone.start), _back(cone.end)) for cone in cones]
        for (a, b), way in zip(list_edges([curve]), ways, strict=True):
            if not any(c.surrounds(along) for c in inverses for along in (way, _back(way))):
                segments.append(((a[0] + w[0], a[1] + w[1]), (b[0] + w[0], b[1] + w[1])))
    return segments


def _find_angles(shape: LatticeShape) -> dict[Vertex, Cones]:
    """The cones of a shape, in short ints."""
    return {
        p: [Cone(reduce_way(cone.start), reduce_way(cone.end)) for cone in cones]
        for p, cones in find_cones_of(shape).items()
    }


def _leave_out_wide(angles: dict[Vertex, Cones]) -> dict[Vertex, Cones]:
    """Vertices without a wide angle, which has a direction in common with every half-plane."""
    return {p: cones for p, cones in angles.items() if not any(cone.is_wide for cone in cones)}


def _half_plane(way: Vertex) -> Cone:
    return Cone(way, _back(way))


def _back(way: Vertex) -> Vertex:
    return -way[0], -way[1]
