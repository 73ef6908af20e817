"""The clearance of two solids, at least one of them rounded: their distance, or minus the depth.

It is the minimum of d - r - s over pairs of pieces, by (1) and (2) of `rounded`; polygonal pieces
have radius 0. The squared distance of hulls is rational, so all comparisons are exact.
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple, Self

from exactsweep.geometry.distance import SquaredDistance
from exactsweep.geometry.overlap import Relation
from exactsweep.geometry.vectors import orientation
from exactsweep.layout.pieces import bound_piece, clip, find_common_point
from exactsweep.layout.rounded import HullDistance, bound_root, measure_hulls, sign_square
from exactsweep.layout.solid import OutsideForm, Solid, meet
from exactsweep.numbers.number import Point, Rational, Vertex

_BITS, _MAX_HALVINGS = 64, 1024


class Clearance(NamedTuple):
    """The clearance d - r of two pieces: negative if they overlap, 0 if they touch."""

    square: Fraction  # d^2, or -d^2 if d is negative
    radius: Fraction  # r, the sum of both radii; their difference for the outside of a container
    hulls: HullDistance  # on the lattice
    pieces: tuple[int, int]  # their indices

    def is_below(self, length: Fraction) -> bool:
        return self.square < sign_square(self.radius + length)

    def is_at_most(self, length: Fraction) -> bool:
        return self.square <= sign_square(self.radius + length)

    def is_less(self, other: Self) -> bool:
        """Return whether the clearance is less than another clearance.

        For signed roots d and e, and the difference r of the radii, d - r < e is decided by signs
        or by squares: (d - r)^2 = d^2 + r^2 - 2 r d contains only one square root.

        >>> one, two = (Clearance(*map(Fraction, pair), None, (0, 0)) for pair in ((2, 0), (8, 1)))
        >>> one.is_less(two), two.is_less(one), one.is_less(one)
        (True, False, False)
        """
        r = self.radius - other.radius
        if not r:
            return self.square < other.square
        below = sign_square(r)
        sign, goal = (self.square > below) - (self.square < below), other.square
        goal_sign = (goal > 0) - (goal < 0)
        if sign != goal_sign or not sign:
            return sign < goal_sign
        # Compare the signed squares of 2 r d and d^2 + r^2 - e^2.
        known = abs(self.square) + r * r - abs(goal)
        root = 4 * below * abs(self.square) * (-1 if self.square < 0 else 1)
        difference = sign_square(known)
        return difference < root if sign > 0 else difference > root

    def bound(self, *, up: bool, bits: int = _BITS) -> Fraction:
        """Return the clearance, exact if rational, else rounded with relative error below 2**-bits.

        >>> Clearance(Fraction(25, 4), Fraction(1), None, (0, 0)).bound(up=True)
        Fraction(3, 2)
        """
        sign, more = (-1 if self.square < 0 else 1), bits
        while True:
            low, high = (sign * end - self.radius for end in bound_root(abs(self.square), more))
            low, high = min(low, high), max(low, high)
            if low == high or (high - low) * 2**bits <= min(abs(low), abs(high)):
                return high if up else low
            more *= 2


def is_rounded(*solids: Solid) -> bool:
    return any(solid.form.is_rounded for solid in solids)


def list_clearances(a: Solid, b: Solid, within: Fraction | None) -> Iterator[Clearance]:
    """Yield the clearances of at most `within` between the pieces of solids on one lattice."""
    scale = a.scale
    reach: Rational | None = None if within is None else within * scale
    if reach is not None and reach.denominator == 1:
        reach = int(reach)
    if isinstance(b.form, OutsideForm):
        yield from _list_outside(a, b, reach)
        return
    others = [(bound_piece(*piece), *piece) for piece in b.rounded]
    for i, piece in enumerate(a.rounded):
        (left, right, low, high), (hull, radius) = bound_piece(*piece), piece
        for j, ((west, east, south, north), other, further) in enumerate(others):
            if reach is not None and (
                max(west - right, left - east, south - high, low - north) > reach
            ):
                continue
            found = measure_hulls(hull, other)
            radii = radius + further
            if reach is None or found.n <= sign_square(radii + reach) * found.d:
                yield _make_clearance(found, radii, scale, (i, j))


def _list_outside(a: Solid, b: Solid, reach: Rational | None) -> Iterator[Clearance]:
    """Yield the clearances between pieces and the outside of a rounded container, by (3)."""
    ((hull, radius),) = b.rounded
    for i, (points, own) in enumerate(a.rounded):
        radii = own - radius
        for point in points:
            n, d, ends, (x, y) = measure_hulls([point], hull)
            found = HullDistance(-n, d, (point, ends[1] if ends else point), (x, y))
            if reach is None or -n <= sign_square(radii + reach) * d:
                yield _make_clearance(found, radii, a.scale, (i, 0))


def _make_clearance(
    found: HullDistance, radii: Rational, scale: int, pieces: tuple[int, int]
) -> Clearance:
    square = Fraction(found.n) / (found.d * scale * scale)
    return Clearance(square, Fraction(radii) / scale, found, pieces)


def find_clearance(a: Solid, b: Solid, within: Fraction | None = None) -> Clearance | None:
    best: Clearance | None = None
    for one in list_clearances(a, b, within):
        if best is None or one.is_less(best):
            best = one
    return best


def find_rounded_witness(a: Solid, b: Solid) -> Point | None:
    """Find a point deeper in both solids than their slacks; None if not found."""
    slack = a.slack + b.slack
    for one in list_clearances(a, b, -slack):
        if one.is_below(-slack):
            point = (_find_outside if isinstance(b.form, OutsideForm) else _find_inside)(a, b, one)
            if point is not None:
                return a.to_point(*point)
    return None


def _find_inside(a: Solid, b: Solid, found: Clearance) -> Vertex | None:
    (i, j), scale = found.pieces, a.scale
    (hull, radius), (other, further) = a.rounded[i], b.rounded[j]
    room, room_beyond = radius - a.slack * scale, further - b.slack * scale
    points = found.hulls.points or (_find_common_center(hull, other),) * 2
    if room > 0 and room_beyond > 0:
        share = Fraction(room) / (room + room_beyond)
        return _interpolate(points[0], points[1], share)
    if room <= 0 and room_beyond <= 0:
        common = find_common_point(hull, other)
        ends: Iterator[Vertex] = iter([common] if common else [])
    elif room <= 0:
        ends = _approach(points[0], _find_middle(hull))
    else:
        ends = _approach(points[1], _find_middle(other))
    return next(
        (z for z in ends if _is_deep(z, hull, room) and _is_deep(z, other, room_beyond)), None
    )


def _find_outside(a: Solid, b: Solid, found: Clearance) -> Vertex | None:
    """Find a point deep in a piece and outside a rounded container.

    Walk from a vertex v, at signed distance s from the hull of the container, straight away from
    the hull in direction w: at distance t from v the signed distance is s + t.
    """
    (i, _), scale, ((hull, further),) = found.pieces, a.scale, b.rounded
    points, radius = a.rounded[i]
    room, least = radius - a.slack * scale, further + b.slack * scale
    for v in points:
        n, d, _, (x, y) = measure_hulls([v], hull)
        if room <= 0:
            ends = _approach(v, _find_middle(points))
        else:
            ends = _walk(v, (-x, -y), Fraction(n) / d, least, room)
        for z in ends:
            is_beyond = _measure_point(z, hull) > sign_square(least)
            if is_beyond and _is_deep(z, points, room):
                return z
    return None


def _walk(
    v: Vertex, way: Vertex, square: Fraction, least: Rational, room: Rational
) -> Iterator[Vertex]:
    """Yield a point v + t w / |w| with t between least - s and room; `square` is s |s|."""
    (x, y), bits = way, 8
    length = Fraction(x * x + y * y)
    while bits <= 2**13:
        s = bound_root(abs(square), bits)[0 if square >= 0 else 1] * (1 if square >= 0 else -1)
        longest, shortest = bound_root(length, bits)[::-1]
        low, high = max(Fraction(0), least - s) / shortest, Fraction(room) / longest
        if low < high:
            share = (low + high) / 2
            yield v[0] + share * x, v[1] + share * y
            return
        bits *= 2


def _approach(start: Vertex, goal: Vertex) -> Iterator[Vertex]:
    share = Fraction(1)
    for _ in range(_MAX_HALVINGS):
        yield _interpolate(start, goal, share)
        share /= 2


def _interpolate(start: Vertex, goal: Vertex, share: Fraction) -> Vertex:
    return (
        start[0] + share * (goal[0] - start[0]),
        start[1] + share * (goal[1] - start[1]),
    )


def _measure_point(z: Vertex, hull: Sequence[Vertex]) -> Fraction:
    found = measure_hulls([z], hull)
    return Fraction(found.n) / found.d


def _is_deep(z: Vertex, hull: Sequence[Vertex], room: Rational) -> bool:
    return _measure_point(z, hull) < sign_square(room)


def _find_middle(hull: Sequence[Vertex]) -> Vertex:
    xs, ys = zip(*hull, strict=True)
    return Fraction(sum(xs)) / len(xs), Fraction(sum(ys)) / len(ys)


def _find_common_center(one: Sequence[Vertex], other: Sequence[Vertex]) -> Vertex:
    if len(one) > len(other):
        one, other = other, one
    if len(other) == 2:
        (p, q), (a, b) = one, other
        before, after = orientation(a, b, p), orientation(a, b, q)
        return _interpolate(p, q, Fraction(before) / (before - after))
    common: list[Vertex] = [*one]
    for a, b in zip(other, (*other[1:], other[0]), strict=True):
        common = [*clip(common, [orientation(a, b, p) for p in common])]
    return _find_middle(common)


def measure_gap(a: Solid, b: Solid, found: Clearance) -> SquaredDistance:
    """Return the squared distance of disjoint solids, rounded up by 2^-64, and nearest points."""
    (i, j), (x, y) = found.pieces, found.hulls.normal
    length = found.bound(up=True)
    p, q = found.hulls.points or (a.rounded[i][0][0], b.rounded[j][0][0])
    unit = bound_root(Fraction(x * x + y * y), _BITS)[0]
    own: Rational = a.rounded[i][1]
    near = Point(p[0] + x * own / unit, p[1] + y * own / unit)
    if isinstance(b.form, OutsideForm):
        own += length * a.scale
        far = Point(p[0] - x * own / unit, p[1] - y * own / unit)
        near = Point(2 * p[0] - near.x, 2 * p[1] - near.y)
    else:
        own = b.rounded[j][1]
        far = Point(q[0] - x * own / unit, q[1] - y * own / unit)
    return SquaredDistance(length * length, (a.to_point(*near), a.to_point(*far)))


def relate(a: Solid, b: Solid) -> Relation:
    if not is_rounded(a, b):
        return meet(a, b)
    found = find_clearance(a, b, Fraction(0))
    if found is None:
        return Relation.APART
    return Relation.OVERLAP if found.is_below(Fraction(0)) else Relation.CONTACT
