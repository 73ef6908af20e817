"""Meetings of the boundaries of two shapes, and the sides of their interiors there."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cmp_to_key
from typing import NamedTuple

from exactsweep.check.cone import Cone, Ray, cross, dot, find_cones, is_between, subtract
from exactsweep.check.shape import LatticeShape, list_edges
from exactsweep.numbers.point import Vertex


class _StatusEdge(NamedTuple):
    """An edge from its lexicographically lesser end to the greater one."""

    left: Vertex
    right: Vertex
    along: Vertex  # right minus left
    sense: int  # 1 if the counter-clockwise walk goes from left to right, else -1
    owner: int

    def side(self, point: Vertex) -> int | Fraction:
        """Negative where the point is above the edge (left of it), 0 on it, positive below."""
        (x, y), (dx, dy) = self.left, self.along
        return dy * (point[0] - x) - dx * (point[1] - y)

    @property
    def rays(self) -> tuple[Ray, Ray]:
        """The edge as seen from a point inside it."""
        x, y = self.along
        return Ray((x, y), self.sense > 0), Ray((-x, -y), self.sense < 0)


Cones = list[Cone]


def list_meetings(
    shapes: tuple[LatticeShape, LatticeShape],
) -> Iterator[tuple[Vertex, tuple[Cones, Cones]]]:
    """Common boundary points in the order of the sweep, each with the cones of both shapes.

    Complete as long as no cones met so far; past that, the order of the status is not kept.
    """
    corners: dict[Vertex, dict[int, list[Ray]]] = defaultdict(dict)
    starting: dict[Vertex, list[_StatusEdge]] = defaultdict(list)
    for owner, shape in enumerate(shapes):
        for ring in shape:
            for k, p in enumerate(ring):
                corners[p].setdefault(owner, []).extend(find_rays(ring, k))
                left, right = sorted((ring[k - 1], p))
                sense = 1 if right == p else -1
                starting[left].append(_StatusEdge(left, right, subtract(right, left), sense, owner))
    # The status: the edges over the current event from below to above. At equal x the lower
    # event comes first, as if the plane were tilted a little; so a vertical edge is the steepest.
    status: list[_StatusEdge] = []
    for point in sorted(corners):
        low = bisect_left(status, True, key=lambda edge: edge.side(point) >= 0)
        high = bisect_left(status, True, lo=low, key=lambda edge: edge.side(point) > 0)
        through = [edge for edge in status[low:high] if edge.right != point]
        rays = corners[point]
        for edge in through:
            rays.setdefault(edge.owner, []).extend(edge.rays)
        if len(rays) == 2:
            yield point, (find_cones(rays[0]), find_cones(rays[1]))
        # Edges that run on together share one line: either order of them is right until the
        # first one ends, at an event that lies on both.
        onward = through + starting[point]
        onward.sort(key=_BY_SLOPE)
        status[low:high] = onward
        for k in {low, low + len(onward)}:
            if 0 < k < len(status) and (crossing := _find_crossing(status[k - 1], status[k])):
                a, b = sorted(status[k - 1 : k + 1], key=lambda edge: edge.owner)
                yield crossing, (find_cones(a.rays), find_cones(b.rays))


def _find_crossing(e: _StatusEdge, f: _StatusEdge) -> Vertex | None:
    """The point inside both edges in which they cross; touching is left to the events."""
    if e.owner == f.owner:
        return None
    from_left, from_right = e.side(f.left), e.side(f.right)
    if from_left * from_right >= 0 or f.side(e.left) * f.side(e.right) >= 0:
        return None
    share = Fraction(from_left) / (from_left - from_right)
    return f.left[0] + share * f.along[0], f.left[1] + share * f.along[1]


def _compare_slopes(e: _StatusEdge, f: _StatusEdge) -> int:
    turn = cross(f.along, e.along)
    return (turn > 0) - (turn < 0)


_BY_SLOPE = cmp_to_key(_compare_slopes)


def find_rays(ring: Sequence[Vertex], k: int) -> tuple[Ray, Ray]:
    """The rays of a ring at its vertex k."""
    p = ring[k]
    ahead, back = subtract(ring[(k + 1) % len(ring)], p), subtract(ring[k - 1], p)
    return Ray(ahead, True), Ray(back, False)


def split_where_touching(shape: LatticeShape) -> LatticeShape:
    """Make vertices of rings that lie inside edges of others vertices of those, too.

    Cost: O(n) for one ring, O(n**2) at worst for several.
    """
    if len(shape) == 1:
        return shape
    corners = sorted({p for ring in shape for p in ring})
    rings = []
    for ring in shape:
        points: list[Vertex] = []
        for a, b in list_edges([ring]):
            way = subtract(b, a)
            low, high = min(a, b), max(a, b)
            between = corners[bisect_right(corners, low) : bisect_left(corners, high)]
            inside = [p for p in between if is_between(p, a, b)]
            points += [a, *sorted(inside, key=lambda p: dot(subtract(p, a), way))]
        rings.append(tuple(points))
    return tuple(rings)


def find_cones_of(shape: LatticeShape) -> dict[Vertex, Cones]:
    """The cones of a shape at each of its vertices; its rings touch in vertices only."""
    rays: dict[Vertex, list[Ray]] = defaultdict(list)
    for ring in shape:
        for k, p in enumerate(ring):
            rays[p].extend(find_rays(ring, k))
    return {p: find_cones(found) for p, found in rays.items()}
