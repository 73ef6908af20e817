"""Directions into a shape at a point of its boundary."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cmp_to_key
from typing import NamedTuple

from exactsweep.numbers.number import Rational, Vertex


class Ray(NamedTuple):
    """An edge as seen from a point on it: the direction, and whether the walk goes that way."""

    along: Vertex
    outgoing: bool


class Cone(NamedTuple):
    """An angle at a boundary point that a shape fills: counter-clockwise from start to end."""

    start: Vertex
    end: Vertex

    @property
    def is_wide(self) -> bool:
        """Decide whether it is more than a half turn."""
        return cross(self.start, self.end) < 0

    def holds(self, d: Vertex) -> bool:
        """Decide whether a direction is in the cone, its start included and its end not."""
        if cross(self.start, d) == 0 and dot(self.start, d) > 0:
            return True
        return self.surrounds(d)

    def surrounds(self, d: Vertex) -> bool:
        """Decide whether a direction is strictly inside the cone."""
        if cross(self.start, self.end) > 0:
            return cross(self.start, d) > 0 and cross(d, self.end) > 0
        return cross(self.start, d) > 0 or cross(d, self.end) > 0


def find_cones(rays: Sequence[Ray]) -> list[Cone]:
    """The cones of a shape at a point, from the rays of the boundary there.

    With the interior on the left of every edge, an outgoing ray opens a cone and the next ray
    counter-clockwise, an incoming one, closes it. Where rings touch there are several.
    """
    turned = sorted(rays, key=lambda ray: by_turn(ray.along))
    following = zip(turned, turned[1:] + turned[:1], strict=True)
    return [Cone(ray.along, after.along) for ray, after in following if ray.outgoing]


def find_common_direction(some: Iterable[Cone], others: Sequence[Cone]) -> Vertex | None:
    """A direction strictly inside a cone of each. Of two that meet, one begins in the other."""
    for one in some:
        for other in others:
            for a, b in ((one, other), (other, one)):
                if a.holds(b.start):
                    end = a.end if b.holds(a.end) else b.end
                    return find_direction_inside(Cone(b.start, end))
    return None


def find_direction_inside(cone: Cone) -> Vertex:
    """A direction strictly inside: between the two sides, or square to one if the cone is wide."""
    (x, y), (end_x, end_y) = cone
    return (x + end_x, y + end_y) if cross(*cone) > 0 else (-y, x)


def subtract(p: Vertex, q: Vertex) -> Vertex:
    """The way from q to p."""
    return p[0] - q[0], p[1] - q[1]


def cross(p: Vertex, q: Vertex) -> Rational:
    """Cross product of two directions, positive where the second is to the left of the first."""
    return p[0] * q[1] - p[1] * q[0]


def dot(p: Vertex, q: Vertex) -> Rational:
    """Scalar product of two directions."""
    return p[0] * q[0] + p[1] * q[1]


def divide(n: Rational, d: Rational) -> Rational:
    """Divide, to an int if the quotient is one; ints are divided without Fractions."""
    if type(n) is int and type(d) is int:
        quotient, rest = divmod(n, d)
        return Fraction(n, d) if rest else quotient
    exact = Fraction(n) / d
    return exact.numerator if exact.denominator == 1 else exact


def is_between(p: Vertex, a: Vertex, b: Vertex) -> bool:
    """Decide whether p lies on the segment from a to b, the ends included."""
    return min(a, b) <= p <= max(a, b) and cross(subtract(b, a), subtract(p, a)) == 0


def _compare_turns(p: Vertex, q: Vertex) -> int:
    lower_p, lower_q = (y < 0 or (y == 0 and x < 0) for x, y in (p, q))
    if lower_p != lower_q:
        return lower_p - lower_q
    turn = cross(p, q)
    return (turn < 0) - (turn > 0)


by_turn = cmp_to_key(_compare_turns)
