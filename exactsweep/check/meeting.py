"""Where the boundaries of two polygons meet, and how their interiors lie there."""

from __future__ import annotations

from bisect import bisect_left
from collections import defaultdict
from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cmp_to_key
from typing import NamedTuple

from exactsweep.check.location import Coordinates

Pair = Coordinates
Loop = Sequence[Pair]


class _Edge(NamedTuple):
    """An edge from its lexicographically lesser end to the greater one."""

    left: Pair
    right: Pair
    along: Pair  # right minus left
    sense: int  # 1 if the counter-clockwise walk goes from left to right, else -1
    owner: int

    def side(self, point: Pair) -> int | Fraction:
        """Negative where the point is above the edge (left of it), 0 on it, positive below."""
        (x, y), (dx, dy) = self.left, self.along
        return dy * (point[0] - x) - dx * (point[1] - y)


class Cone(NamedTuple):
    """The directions into a polygon at a boundary point: counter-clockwise from start to end."""

    start: Pair
    end: Pair

    def holds(self, d: Pair) -> bool:
        """Whether a direction is in the cone, its start included and its end not."""
        if _cross(self.start, d) == 0 and dot(self.start, d) > 0:
            return True
        if _cross(self.end, d) == 0 and dot(self.end, d) > 0:
            return False
        if _cross(self.start, self.end) > 0:
            return _cross(self.start, d) > 0 and _cross(d, self.end) > 0
        return _cross(self.start, d) > 0 or _cross(d, self.end) > 0


def meetings(loops: tuple[Loop, Loop]) -> Iterator[tuple[Coordinates, tuple[Cone, Cone]]]:
    """Common boundary points in the order of the sweep, each with the cones of both polygons.

    Complete as long as no cones met so far; past that, the order of the status is not kept.
    """
    corners: dict[Pair, dict[int, Cone]] = defaultdict(dict)
    starting: dict[Pair, list[_Edge]] = defaultdict(list)
    for owner, loop in enumerate(loops):
        for k, p in enumerate(loop):
            corners[p][owner] = corner(loop, k)
            left, right = sorted((loop[k - 1], p))
            sense = 1 if right == p else -1
            starting[left].append(_Edge(left, right, _minus(right, left), sense, owner))
    # The status: the edges over the current event from below to above. At equal x the lower
    # event comes first, as if the plane were tilted a little; so a vertical edge is the steepest.
    status: list[_Edge] = []
    for point in sorted(corners):
        low = bisect_left(status, True, key=lambda edge: edge.side(point) >= 0)
        high = bisect_left(status, True, lo=low, key=lambda edge: edge.side(point) > 0)
        through = status[low:high]
        cones = corners[point]
        for edge in through:
            if edge.owner not in cones:
                cones[edge.owner] = _half_plane(edge)
        if len(cones) == 2:
            yield point, (cones[0], cones[1])
        # Edges that run on together share one line: either order of them is right until the
        # first one ends, at an event that lies on both.
        onward = [edge for edge in through if edge.right != point] + starting[point]
        onward.sort(key=_BY_SLOPE)
        status[low:high] = onward
        for k in {low, low + len(onward)}:
            if 0 < k < len(status) and (crossing := _crossing(status[k - 1], status[k])):
                a, b = sorted(status[k - 1 : k + 1], key=lambda edge: edge.owner)
                yield crossing, (_half_plane(a), _half_plane(b))


def _crossing(e: _Edge, f: _Edge) -> Coordinates | None:
    """The point inside both edges in which they cross; touching is left to the events."""
    if e.owner == f.owner:
        return None
    from_left, from_right = e.side(f.left), e.side(f.right)
    if from_left * from_right >= 0 or f.side(e.left) * f.side(e.right) >= 0:
        return None
    share = Fraction(from_left) / (from_left - from_right)
    return f.left[0] + share * f.along[0], f.left[1] + share * f.along[1]


def _compare_slopes(e: _Edge, f: _Edge) -> int:
    turn = _cross(f.along, e.along)
    return (turn > 0) - (turn < 0)


_BY_SLOPE = cmp_to_key(_compare_slopes)


def corner(loop: Loop, k: int) -> Cone:
    """Cone of a counter-clockwise loop at its vertex k."""
    p = loop[k]
    return Cone(_minus(loop[(k + 1) % len(loop)], p), _minus(loop[k - 1], p))


def _half_plane(edge: _Edge) -> Cone:
    x, y = edge.along
    ahead, back = (x, y), (-x, -y)
    return Cone(ahead, back) if edge.sense > 0 else Cone(back, ahead)


def common_direction(one: Cone, other: Cone) -> Pair | None:
    """A direction strictly inside both cones. If there is any, one cone begins in the other."""
    for a, b in ((one, other), (other, one)):
        if a.holds(b.start):
            end = a.end if b.holds(a.end) else b.end
            return direction_inside(Cone(b.start, end))
    return None


def direction_inside(cone: Cone) -> Pair:
    """A direction strictly inside: between the two sides, or square to one if the cone is wide."""
    (x, y), (end_x, end_y) = cone
    return (x + end_x, y + end_y) if _cross(*cone) > 0 else (-y, x)


def _minus(p: Pair, q: Pair) -> Pair:
    return p[0] - q[0], p[1] - q[1]


def _cross(p: Pair, q: Pair) -> int | Fraction:
    return p[0] * q[1] - p[1] * q[0]


def dot(p: Pair, q: Pair) -> int | Fraction:
    """Scalar product of two directions."""
    return p[0] * q[0] + p[1] * q[1]
