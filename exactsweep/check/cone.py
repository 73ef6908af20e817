"""Directions into a shape at a point of its boundary."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cmp_to_key
from typing import NamedTuple

from exactsweep.numbers.number import Rational, Vertex


class Ray(NamedTuple):
    """The direction of an edge from a point on it, and whether it is outgoing."""

    along: Vertex
    outgoing: bool


class Cone(NamedTuple):
    """An angle that a shape fills at a boundary point, counter-clockwise from start to end."""

    start: Vertex
    end: Vertex

    @property
    def is_wide(self) -> bool:
        """Decide whether the angle is more than a half turn."""
        return cross(self.start, self.end) < 0

    def holds(self, d: Vertex) -> bool:
        """Decide whether a direction is in the half-open cone, which includes its start."""
        if cross(self.start, d) == 0 and dot(self.start, d) > 0:
            return True
        return self.surrounds(d)

    def surrounds(self, d: Vertex) -> bool:
        """Decide whether a direction is strictly inside the cone."""
        if cross(self.start, self.end) > 0:
            return cross(self.start, d) > 0 and cross(d, self.end) > 0
        return cross(self.start, d) > 0 or cross(d, self.end) > 0


def find_cones(rays: Sequence[Ray]) -> list[Cone]:
    """Return the cones of a shape at a point, given the rays of its boundary.

    With the interior on the left of every edge, an outgoing ray starts a cone, and the next ray
    counter-clockwise, an incoming one, ends it.
    """
    turned = sorted(rays, key=lambda ray: by_turn(ray.along))
    following = zip(turned, turned[1:] + turned[:1], strict=True)
    return [Cone(ray.along, after.along) for ray, after in following if ray.outgoing]


def find_common_direction(some: Iterable[Cone], others: Sequence[Cone]) -> Vertex | None:
    """Return a common interior direction: if two cones meet, one of them starts in the other."""
    for one in some:
        for other in others:
            for a, b in ((one, other), (other, one)):
                if a.holds(b.start):
                    end = a.end if b.holds(a.end) else b.end
                    return find_direction_inside(Cone(b.start, end))
    return None


def find_direction_inside(cone: Cone) -> Vertex:
    """Return a direction strictly inside: the sum of the sides, or perpendicular to one."""
    (x, y), (end_x, end_y) = cone
    return (x + end_x, y + end_y) if cross(*cone) > 0 else (-y, x)


def subtract(p: Vertex, q: Vertex) -> Vertex:
    """Return the vector from q to p."""
    return p[0] - q[0], p[1] - q[1]


def cross(p: Vertex, q: Vertex) -> Rational:
    """Return the cross product, positive if the second direction is left of the first."""
    return p[0] * q[1] - p[1] * q[0]


def dot(p: Vertex, q: Vertex) -> Rational:
    """Return the scalar product."""
    return p[0] * q[0] + p[1] * q[1]


def divide(n: Rational, d: Rational) -> Rational:
    """Return a quotient, as an int if possible."""
    if type(n) is int and type(d) is int:
        quotient, rest = divmod(n, d)
        return Fraction(n, d) if rest else quotient
    exact = Fraction(n) / d
    return exact.numerator if exact.denominator == 1 else exact


def is_between(p: Vertex, a: Vertex, b: Vertex) -> bool:
    """Decide whether p is on the closed segment from a to b."""
    return min(a, b) <= p <= max(a, b) and cross(subtract(b, a), subtract(p, a)) == 0


def _compare_turns(p: Vertex, q: Vertex) -> int:
    lower_p, lower_q = (y < 0 or (y == 0 and x < 0) for x, y in (p, q))
    if lower_p != lower_q:
        return lower_p - lower_q
    turn = cross(p, q)
    return (turn < 0) - (turn > 0)


by_turn = cmp_to_key(_compare_turns)
