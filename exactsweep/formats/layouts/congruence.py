"""Rigid maps between congruent regions."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

from exactsweep.formats.rounded import RoundedOutline
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.geometry.vectors import minus
from exactsweep.numbers.number import Point

_SHARE = 1e-6
_EdgeShape = tuple[Fraction, Fraction, Fraction]


class Congruence(NamedTuple):
    """A map of a part: mirroring (x to -x), then rotation about the origin, then translation."""

    mirrored: bool
    turn: tuple[Fraction, Fraction]  # cosine and sine
    move: Point
    exact: bool  # else vertices differ by at most a millionth of the size of the part


def find_congruence(part: Region, drawn: Region) -> Congruence | None:
    """Find a map from a part to a region, preferably exact. Cost: O(n^2), usually O(n)."""
    if len(part.exterior) != len(drawn.exterior) or len(part.holes) != len(drawn.holes):
        return None
    nearly = None
    for mirrored in (False, True):
        for found in _list_maps(part, drawn, mirrored=mirrored):
            if found.exact:
                return found
            nearly = nearly or found
    return nearly


def find_rounded_congruence(part: RoundedOutline, drawn: RoundedOutline) -> Congruence | None:
    """Find a map between rounded outlines, exact if both are."""
    if part.radius != drawn.radius or len(part.points) != len(drawn.points):
        return None
    exact = not (part.error or drawn.error)
    if len(part.points) > 2:
        found = find_congruence(Region(part.points), Region(drawn.points))
        return found._replace(exact=exact) if found is not None and found.exact else None
    (a, *others), (p, *rest) = part.points, drawn.points
    c, s = Fraction(1), Fraction(0)
    if others:
        (x, y), (u, v) = minus(others[0], a), minus(rest[0], p)
        length = x * x + y * y
        if length != u * u + v * v:
            return None
        c, s = Fraction(x * u + y * v) / length, Fraction(x * v - y * u) / length
    move = Point(p.x - c * a.x + s * a.y, p.y - s * a.x - c * a.y)
    return Congruence(False, (c, s), move, exact=exact)


def _list_maps(part: Region, drawn: Region, *, mirrored: bool) -> Iterator[Congruence]:
    ring = part.exterior.vertices
    if mirrored:
        ring = tuple(Point(-x, y) for x, y in reversed(ring))
    goal = drawn.exterior.vertices
    corners, goals = _list_corners(ring), _list_corners(goal)
    tolerance = _SHARE * float(max(length for length, _, _ in corners)) ** 0.5
    for shift in range(len(goal)):
        others = goals[shift:] + goals[:shift]
        is_same = corners == others
        if not is_same and not all(map(_is_near, corners, others)):
            continue
        (ax, ay), (bx, by) = _edge(ring, 0), _edge(goal, shift)
        square = ax * ax + ay * ay
        c, s = (ax * bx + ay * by) / square, (ax * by - ay * bx) / square
        (x, y), (u, v) = ring[0], goal[shift]
        move = Point(u - c * x + s * y, v - s * x - c * y)
        found = Congruence(mirrored, (c, s), move, is_same)
        holes = [[_apply(found, p) for p in hole.vertices] for hole in part.holes]
        if is_same and {Polygon(hole) for hole in holes} == {*drawn.holes}:
            yield found
        elif all(any(_follows(hole, other, tolerance) for other in drawn.holes) for hole in holes):
            yield found._replace(exact=False)


def _follows(ring: Sequence[Point], other: Polygon, tolerance: float) -> bool:
    """Return whether each vertex of a ring is close to one of the other, of the same length."""
    if len(ring) != len(other):
        return False
    return all(
        any(abs(float(p.x - q.x)) + abs(float(p.y - q.y)) <= tolerance for q in other.vertices)
        for p in ring
    )


def _is_near(one: _EdgeShape, other: _EdgeShape) -> bool:
    tolerance = _SHARE * float(max(one[0], other[0]) + abs(one[1]) + abs(one[2]))
    return all(abs(float(a - b)) <= tolerance for a, b in zip(one, other, strict=True))


def _edge(ring: Sequence[Point], k: int) -> tuple[Fraction, Fraction]:
    (ax, ay), (bx, by) = ring[k], ring[(k + 1) % len(ring)]
    return bx - ax, by - ay


def _list_corners(ring: Sequence[Point]) -> list[_EdgeShape]:
    """List the squared length of each edge, and its dot and cross product with the next one."""
    edges = [_edge(ring, k) for k in range(len(ring))]
    return [
        (x * x + y * y, x * u + y * v, x * v - y * u)
        for (x, y), (u, v) in zip(edges, edges[1:] + edges[:1], strict=True)
    ]


def _apply(found: Congruence, point: Point) -> Point:
    x, y = -point.x if found.mirrored else point.x, point.y
    (cosine, sine), move = found.turn, found.move
    return Point(cosine * x - sine * y + move.x, sine * x + cosine * y + move.y)
