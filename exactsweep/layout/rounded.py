"""Rounded pieces: all points within a radius of a convex hull.

The hull is a point for a disc, a segment for a slot, and a rectangle for a rounded rectangle. Let A
and B be hulls with radii r and s, r + s > 0, and let d be their distance.

(1) The interiors of the pieces are disjoint if and only if d >= r + s; then their distance is
    d - r - s. The square of d is rational, so every comparison with a rational is exact.
(2) If the hulls overlap, let -d be the length of the shortest move that separates them: the
    distance of the origin from the boundary of the convex set A - B. Then the shortest move that
    separates the pieces always has length r + s - d.
(3) A piece is inside a container with hull C and radius R if and only if the signed distance of
    each of its vertices from C, negative inside, is at most R - r.
"""

from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from itertools import pairwise
from math import isqrt, lcm, pi, tan
from typing import Any, NamedTuple, Self

from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.distance import find_foot, measure_to_edge
from exactsweep.geometry.region import Region
from exactsweep.geometry.turn import from_half_tangent
from exactsweep.geometry.vectors import find_hull
from exactsweep.layout.reading import LayoutError, read_gap, read_list, read_object, read_ring
from exactsweep.numbers.number import ORIGIN, Edge, Loop, Point, Rational, Vertex, find_root

_LEAST = 3
_SIDES, _AREA_BITS = 32, 64


class RoundedPiece(NamedTuple):
    """All points at distance at most `radius` from the convex hull of some points."""

    points: Loop  # the corners, counter-clockwise; one or two for a degenerate hull
    radius: Fraction  # at least 0, and positive for a degenerate hull

    @classmethod
    def from_json(cls, data: object, path: str) -> Self:
        found = read_object(data, path, ("points",), ("radius",))
        points = read_ring(found["points"], f"{path}.points")
        radius = read_gap(found.get("radius", 0), f"{path}.radius")
        hull = tuple(find_hull(points)) or points[:1]
        if not hull:
            raise LayoutError(f"{path}.points is empty")
        if not radius and len(hull) < _LEAST:
            raise LayoutError(
                f"{path} has no interior: its radius is 0 and its points are collinear"
            )
        return cls(hull, radius)

    def to_json(self) -> dict[str, Any]:
        return {"points": self.points, "radius": self.radius}

    @property
    def bounding_box(self) -> tuple[Point, Point]:
        xs, ys = zip(*self.points, strict=True)
        r = self.radius
        return Point(min(xs) - r, min(ys) - r), Point(max(xs) + r, max(ys) + r)

    @property
    def denominator(self) -> int:
        return lcm(self.radius.denominator, *(c.denominator for p in self.points for c in p))

    def bound_area(self, bits: int) -> tuple[Fraction, Fraction]:
        """Bound the area from below and above, with a relative error of about 2**-bits."""
        r = self.radius
        area = abs(Fraction(find_doubled_area(self.points))) / 2 if len(self.points) > 2 else 0
        if not r:
            return Fraction(area), Fraction(area)
        # A segment has two sides.
        edges = pairwise((*self.points, self.points[0])) if len(self.points) > 1 else ()
        sides = [bound_root((q.x - p.x) ** 2 + (q.y - p.y) ** 2, bits) for p, q in edges]
        least, most = (
            area + r * sum(side[end] for side in sides) + r * r * bound
            for end, bound in enumerate(bound_pi(bits))
        )
        return least, most


BodyShape = Region | tuple[RoundedPiece, ...]  # the shape of a part or a defect


def read_pieces(data: object, path: str) -> tuple[RoundedPiece, ...]:
    pieces = read_list(data, path, RoundedPiece.from_json)
    if not pieces:
        raise LayoutError(f"{path} is empty")
    return pieces


@cache
def bound_pi(bits: int) -> tuple[Fraction, Fraction]:
    """Bound pi by Machin's formula, pi/4 = 4 arctan(1/5) - arctan(1/239).

    >>> low, high = bound_pi(20)
    >>> float(low) < 3.14159266 and float(high) > 3.14159265, high - low < Fraction(1, 2**20)
    (True, True)
    """
    unit = 1 << (bits + 16)

    def arctan(n: int) -> int:
        total, power, k = 0, unit // n, 0
        while power:
            total += (-1) ** k * (power // (2 * k + 1))
            power //= n * n
            k += 1
        return total

    near = 4 * (4 * arctan(5) - arctan(239))
    # Either series has fewer than `bits` terms, each with an error below two units.
    room = 64 * (bits + 16)
    assert room < 1 << 15
    return Fraction(near - room, unit), Fraction(near + room, unit)


def bound_root(square: Fraction, bits: int) -> tuple[Fraction, Fraction]:
    """Bound a square root with relative error 2**-bits; both bounds are equal if it is rational.

    >>> bound_root(Fraction(9, 4), 8), bound_root(Fraction(2), 2)
    ((Fraction(3, 2), Fraction(3, 2)), (Fraction(11, 8), Fraction(3, 2)))
    """
    exact = find_root(square)
    if exact is not None:
        return exact, exact
    n, d = square.as_integer_ratio()
    shift = max(0, bits + 1 + (d.bit_length() - n.bit_length()) // 2 + 1)
    low = isqrt((n << (2 * shift)) // d)
    return Fraction(low, 1 << shift), Fraction(low + 1, 1 << shift)


def sign_square(length: Rational) -> Rational:
    return length * length if length >= 0 else -length * length


def surround(pieces: Sequence[RoundedPiece]) -> Region:
    """Circumscribe a convex polygon about rounded pieces, with at most 32 sides for each corner."""
    corners = [
        Point(x + u * radius, y + v * radius)
        for points, radius in pieces
        for x, y in points
        for u, v in (list_disc(_SIDES) if radius else [ORIGIN])
    ]
    return Region(find_hull(corners))


def to_region(shape: BodyShape) -> Region:
    """Return a Region unchanged; replace rounded pieces by a circumscribed polygon."""
    return shape if isinstance(shape, Region) else surround(shape)


def inscribe(piece: RoundedPiece) -> Region:
    """Inscribe a polygon in a rounded piece, with at most 32 vertices for each corner."""
    around = _list_normals(_SIDES) if piece.radius else [ORIGIN]
    r = piece.radius
    corners = (Point(x + u * r, y + v * r) for x, y in piece.points for u, v in around)
    return Region(find_hull(corners))


@cache
def list_disc(sides: int) -> tuple[Point, ...]:
    """List the corners of a symmetric polygon circumscribed about the unit disc."""
    normals = _list_normals(sides)
    corners = []
    for (a, b), (c, d) in pairwise((*normals, normals[0])):
        share = 1 + a * c + b * d
        corners.append(Point((a + c) / share, (b + d) / share))
    return tuple(corners)


@cache
def _list_normals(sides: int) -> list[Point]:
    tangents = [Fraction(tan(pi * k / sides)).limit_denominator(50) for k in range(sides // 4)]
    return [from_half_tangent(t, quarters) for quarters in range(4) for t in tangents]


def bound_area(shape: BodyShape | None) -> tuple[Fraction, Fraction] | None:
    """Bound the area of a shape, in O(n^2); None without a shape, or if rounded pieces overlap."""
    if shape is None:
        return None
    if isinstance(shape, Region):
        return shape.area, shape.area
    for k, one in enumerate(shape):
        for other in shape[:k]:
            found = measure_hulls(one.points, other.points)
            if found.n < sign_square(one.radius + other.radius) * found.d:
                return None
    least, most = zip(*(piece.bound_area(_AREA_BITS) for piece in shape), strict=True)
    return sum(least, Fraction(0)), sum(most, Fraction(0))


class HullDistance(NamedTuple):
    """The signed squared distance n / d between two hulls, negative if they overlap; see (2)."""

    n: Rational
    d: Rational
    points: tuple[Vertex, Vertex] | None  # the nearest points, equal if the hulls touch
    normal: Vertex  # the direction of the shortest move of the second hull to contact


def measure_hulls(one: Sequence[Vertex], other: Sequence[Vertex]) -> HullDistance:
    """Measure the distance between two convex hulls, in O(m n).

    Corners are counter-clockwise; a degenerate hull has one or two. The edges of A - B are those of
    A and of -B.

    >>> square = [(0, 0), (2, 0), (2, 2), (0, 2)]
    >>> found = measure_hulls(square, [(4, 1)]), measure_hulls(square, [(1, 1), (9, 1)])
    >>> [Fraction(one.n, one.d) for one in found]
    [Fraction(4, 1), Fraction(-1, 1)]
    """
    if len(one) == len(other) == 1:
        (ax, ay), (bx, by) = one[0], other[0]
        x, y = bx - ax, by - ay
        return HullDistance(x * x + y * y, 1, (one[0], other[0]), (x, y) if x or y else (1, 0))
    edges, others = _list_edges(one), _list_edges(other)
    exit_n: Rational | None = None
    exit_d: Rational = 1
    exit_normal: Vertex = (1, 0)
    for ours, theirs, sign in ((edges, other, 1), (others, one, -1)):
        for (px, py), (qx, qy) in ours:
            x, y = qy - py, px - qx
            if not (x or y):
                continue
            depth = x * px + y * py - min(x * a + y * b for a, b in theirs)
            if exit_n is None or depth < 0 or depth * depth * exit_d < exit_n * (x * x + y * y):
                exit_n, exit_d = sign_square(depth), x * x + y * y
                exit_normal = (sign * x, sign * y)
            if depth < 0:
                break
        else:
            continue
        break
    assert exit_n is not None
    if exit_n > 0:
        return HullDistance(-exit_n, exit_d, None, exit_normal)
    best: tuple[Rational, Rational, Vertex, Edge, bool] | None = None
    for points, sides, is_first in ((one, others, True), (other, edges, False)):
        for point in points:
            for edge in sides:
                n, d = measure_to_edge(point, edge)
                if best is None or n * best[1] < best[0] * d:
                    best = n, d, point, edge, is_first
    assert best is not None
    n, d, point, edge, is_first = best
    foot: Vertex = find_foot(point, edge)
    p, q = (point, foot) if is_first else (foot, point)
    return HullDistance(n, d, (p, q), (q[0] - p[0], q[1] - p[1]) if n else exit_normal)


def _list_edges(hull: Sequence[Vertex]) -> list[Edge]:
    """List the edges; a segment has two, a point has one of length 0."""
    return [*pairwise((*hull, hull[0]))]
