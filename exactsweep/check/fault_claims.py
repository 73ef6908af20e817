"""Faults of layouts as claims for the checker in Coq, with points of both bodies as evidence."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import chain
from math import isqrt
from typing import Any

from exactsweep.check.figures import Figure
from exactsweep.check.standalone import Edge, edges, node, outline, side, winding
from exactsweep.check.terms import Constructor, Nat, RationalPoint, TheoremError

KINDS = {
    "missing": (0, "Missing"),
    "surplus": (1, "Surplus"),
    "mirror": (2, "Mirrored"),
    "turn": (3, "Rotated"),
    "shape": (4, "Not_simple"),
    "overlap": (5, "Overlapping"),
    "outside": (5, "Overlapping"),
    "too close": (6, "Too_close"),
}
STEPS = 10  # the smallest displacement of a point of evidence is 2^-1024 units
Body = tuple[Figure, Fraction]
PointPair = tuple[RationalPoint, RationalPoint]


def claim_fault(
    fault: Any, index: dict[str, int], bodies: list[Body | None]
) -> tuple[Constructor, PointPair]:
    """Return a fault as a term, and two points as evidence.

    `index` maps the ids of parts to numbers, and `bodies` the numbers in the certificate to figures
    and distances. Raises LookupError for an unknown part, body or kind of fault, and TheoremError
    if the kind does not fit the bodies, or if all edges of a body near the point of a fault "too
    close" cancel or separate winding numbers other than 1.
    """
    kind, at = fault["kind"], fault.get("point")
    point = (Fraction(at[0]), Fraction(at[1])) if at is not None else (Fraction(0), Fraction(0))
    if kind not in ("overlap", "outside", "too close"):
        return _case(*KINDS[kind], Nat(index[fault["part"]])), (point, point)
    a, b = fault["placements"]
    if kind != "too close" and (kind == "outside") != (b < 0):
        raise TheoremError("a fault of kind 'overlap' with an obstacle, or 'outside' without one")
    one, other = bodies[a], bodies[b]
    term = _case(*KINDS[kind], Nat(a), _body(b))
    if kind != "too close" or one is None or other is None:
        return term, (point, point)
    room = other[1] - one[0].error - other[0].error
    pairs = zip(_points(one[0], point, False), _points(other[0], point, b == -1), strict=True)
    reach = max(room, Fraction(0)) / 2
    for p, q in pairs:
        if p and q and max(_squared(p, point), _squared(q, point)) < reach**2:
            return term, (p, q)
    raise TheoremError("no points of both bodies near the point of a fault")


def _case(number: int, name: str, *arguments: Any) -> Constructor:
    return Constructor(number, f"Statements.{name}", arguments)


def _body(number: int) -> Constructor:
    if number >= 0:
        return _case(0, "Part", Nat(number))
    return _case(1, "Beyond") if number == -1 else _case(2, "Obstacle", Nat(-2 - number))


def _squared(p: RationalPoint, q: RationalPoint) -> Fraction:
    return (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2


def _points(
    figure: Figure, z: RationalPoint, is_complement: bool
) -> Iterator[RationalPoint | None]:
    """Yield points of a figure or its complement that converge to the point nearest to z."""
    around = [*chain(*(edges([node(*p) for p in ring]) for ring in figure.outline))]
    segments = outline(around)
    for k in range(STEPS):
        step = Fraction(1, 2 ** (2**k))
        found = [_rounded_point(*piece, z, is_complement, step) for piece in figure.rounded]
        if around:
            found += _ring_point(around, segments, z, is_complement, step)
        yield min(found, key=lambda p: _squared(p, z), default=None)


def _ring_point(
    around: list[Edge],
    segments: list[PointPair],
    z: RationalPoint,
    is_complement: bool,
    step: Fraction,
) -> list[RationalPoint]:
    def is_wanted(p: RationalPoint) -> bool:
        return winding(around, node(*p)) == 1 - is_complement

    if is_wanted(z):
        return [z]
    feet = [(_foot(p, q, z), p, q) for p, q in segments]
    least = min(_squared(foot, z) for foot, *_ in feet)
    for (x, y), p, q in feet:
        if _squared((x, y), z) == least:
            u, v = q[0] - p[0], q[1] - p[1]
            for along in (step, -step):
                for left in (step**2, -(step**2)):
                    near = x + along * u - left * v, y + along * v + left * u
                    if is_wanted(near):
                        return [near]
    return []


def _foot(p: RationalPoint, q: RationalPoint, z: RationalPoint) -> RationalPoint:
    """Return the nearest point of a segment."""
    u, v = q[0] - p[0], q[1] - p[1]
    square = u * u + v * v
    at = (u * (z[0] - p[0]) + v * (z[1] - p[1])) / square if square else Fraction(0)
    at = min(max(at, Fraction(0)), Fraction(1))
    return p[0] + at * u, p[1] + at * v


def _rounded_point(
    points: list[RationalPoint],
    radius: Fraction,
    z: RationalPoint,
    is_complement: bool,
    step: Fraction,
) -> RationalPoint:
    """Return a point of a rounded piece or its complement on the ray from its hull to z."""
    sides = [*zip(points, points[1:] + points[:1], strict=True)]
    lines = [line for *_, line in edges([node(*p) for p in points])]
    is_in_hull = len(points) > 2 and all(side(line, node(*z)) >= 0 for line in lines)
    found = [(_foot(p, q, z), p, q) for p, q in sides]
    foot, p, q = min(found, key=lambda entry: _squared(entry[0], z))
    away = z[0] - foot[0], z[1] - foot[1]
    square = away[0] ** 2 + away[1] ** 2
    if not is_complement and (is_in_hull or square <= radius**2):
        return z
    if is_complement and not is_in_hull and square > radius**2:
        return z
    if is_in_hull or not square:
        away = (q[1] - p[1], p[0] - q[0]) if p != q else (Fraction(1), Fraction(0))
        square = away[0] ** 2 + away[1] ** 2
    unit = step.denominator
    at = Fraction(isqrt(int(radius**2 / square * unit**2)) + is_complement * 2, unit)
    return foot[0] + at * away[0], foot[1] + at * away[1]
