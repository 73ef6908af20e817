"""Directions in which polygons are monotone.

A polygon is monotone in direction u if its intersection with every line perpendicular to u is
connected: one chain of its edges runs forward along u, the other backward. It is strictly
monotone if no edge is perpendicular to u. Monotonicity changes only at directions perpendicular to
an edge, so one rotation of u finds all directions.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cmp_to_key
from itertools import groupby
from math import gcd

from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import read_point
from exactsweep.geometry.vectors import minus
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Vertex, find_simplest_fraction
from exactsweep.words import write_degrees, write_vector

Vector = tuple[int, int]

X_AXIS: Vector = (1, 0)
Y_AXIS: Vector = (0, 1)


class DirectionError(ExactSweepError):
    """Polygons that are not monotone in a shared direction, or not in the requested one."""


@dataclass(frozen=True)
class Directions:
    """The directions in which one polygon, or both of a pair, are monotone; u and -u are the same.

    Attributes:
        critical: the directions perpendicular to an edge, as primitive integer vectors, by angle
            from -90 degrees, exclusive, to 90 degrees.
        at: whether the polygons are monotone, at least weakly, in critical direction k.
        after: whether they are strictly monotone in the directions between critical directions k
            and k + 1, or k and the first one after a half turn if k is the last.

    >>> print(find_monotone_directions(Polygon([(0, 0), (2, 1), (4, 0), (4, 3), (0, 3)])))
    all from (1, -2) to (1, 2), -63.4 to 63.4 degrees
    """

    critical: tuple[Vector, ...]
    at: tuple[bool, ...]
    after: tuple[bool, ...]

    def __contains__(self, direction: Vector) -> bool:
        """Decide whether the polygons are monotone, at least weakly. Cost: O(log n)."""
        k = self._last_up_to(direction)
        return self.at[k] if self.critical[k] == reduce_direction(direction) else self.after[k]

    def __bool__(self) -> bool:
        return any(self.at)

    def __and__(self, other: Directions) -> Directions:
        """Intersect two sets of directions. Cost: O(n), a cross product for each critical one."""
        critical = sorted({*self.critical, *other.critical}, key=slope_key)
        states = zip(self._follow(critical), other._follow(critical), strict=True)
        found = [(at and is_at, after and is_after) for (at, after), (is_at, is_after) in states]
        at, after = zip(*found, strict=True)
        return Directions(tuple(critical), at, after)

    def _follow(self, critical: Iterable[Vector]) -> Iterator[tuple[bool, bool]]:
        """Yield `at` and `after` for sorted directions that include all critical ones."""
        # The state before the first critical direction equals the state after the last one.
        k, places = -1, {u: k for k, u in enumerate(self.critical)}
        for u in critical:
            k = places.get(u, k)
            yield (self.at if u in places else self.after)[k], self.after[k]

    def arcs(self) -> tuple[tuple[Vector, Vector], ...]:
        """Return the maximal closed arcs as pairs (first, last), counter-clockwise.

        An isolated direction u is the arc (u, u). For a polygon that is monotone in all directions,
        such as a convex one, the result is also one arc (u, u).
        """
        n = len(self.critical)
        if all(self.after):
            return ((self.critical[0], self.critical[0]),)
        starts = [k for k in range(n) if self.at[k] and not self.after[k - 1]]
        found = []
        for k in starts:
            last = k
            while self.after[last % n]:
                last += 1
            p, q = self.critical[last % n]
            found.append((self.critical[k], (p, q) if last < n else (-p, -q)))
        return tuple(found)

    def simplest(self) -> Vector:
        """Choose the X axis if possible, else the shortest strict direction, else any.

        The result is a primitive integer vector. Raises DirectionError if there is no direction.
        Cost: O(n log c) for components up to c.

        >>> find_monotone_directions(Polygon([(0, 0), (1, 2), (0, 4), (3, 4), (3, 0)])).simplest()
        (1, -1)
        """
        if X_AXIS in self:
            return X_AXIS
        first = self.critical[0]
        ends = [*self.critical[1:], (-first[0], -first[1])]
        candidates = [
            _find_simplest_between(u, v)
            for u, v, strict in zip(self.critical, ends, self.after, strict=True)
            if strict
        ] or [u for u, weak in zip(self.critical, self.at, strict=True) if weak]
        if not candidates:
            raise DirectionError("not monotone in any direction")
        return min(candidates, key=lambda u: (u[0] * u[0] + u[1] * u[1], u))

    def __str__(self) -> str:
        if all(self.after):
            return "all directions"
        arcs = [
            f"all from {write_vector(u)} to {write_vector(v)}, "
            f"{write_degrees(u)} to {write_degrees(v)} degrees"
            if u != v
            else f"only {write_vector(u)}, {write_degrees(u)} degrees"
            for u, v in self.arcs()
        ]
        return " and ".join(arcs) or "no direction"

    def _last_up_to(self, direction: Vector) -> int:
        """Return the index of the last critical direction up to this one, or -1 if none."""
        key = slope_key(reduce_direction(direction))
        return bisect_right(self.critical, key, key=slope_key) - 1


def reduce_direction(direction: Vertex) -> Vector:
    """Reduce a direction to coprime ints (a, b), with a > 0 or equal to (0, 1)."""
    (p, a), (q, b) = direction[0].as_integer_ratio(), direction[1].as_integer_ratio()
    if a != 1 or b != 1:
        p, q = p * b, q * a
    divisor = gcd(p, q)
    if p < 0 or (p == 0 and q < 0):
        divisor = -divisor
    return p // divisor, q // divisor


def read_direction(direction: Iterable[object]) -> Vector:
    """Read a pair of exact numbers other than (0, 0) as a primitive vector."""
    try:
        p, q = read_point(direction, "direction")
    except ExactSweepError as error:
        raise DirectionError(str(error)) from None
    if p == 0 == q:
        raise DirectionError("(0, 0) is not a direction")
    return reduce_direction((p, q))


def find_monotone_directions(polygon: Polygon) -> Directions:
    """Find all directions in which a polygon is monotone; cached by the polygon.

    A polygon is monotone in direction u if its edges, in order, switch between forward and backward
    exactly twice. The search rotates u and counts the switches. Cost: O(n log n).

    >>> square = find_monotone_directions(Polygon([(0, 0), (1, 0), (1, 1), (0, 1)]))
    >>> (1, 0) in square, square.after
    (True, (True, True))
    """
    found: Directions | None = polygon._directions
    if found is None:
        found = polygon._directions = _rotate_through(polygon.lattice()[1])
    return found


def _rotate_through(ring: Sequence[Vertex]) -> Directions:
    edges = [minus(p, ring[k - 1]) for k, p in enumerate(ring)]
    n = len(edges)
    # Start just past -90 degrees: u = (e, -1) with an infinitesimal e > 0.
    forward = [dy < 0 or (dy == 0 and dx > 0) for dx, dy in edges]
    changes = sum(forward[k] != forward[k - 1] for k in range(n))

    def local(k: int) -> int:
        return (forward[k] != forward[k - 1]) + (forward[k] != forward[(k + 1) % n])

    normals = [reduce_direction((-dy, dx)) for dx, dy in edges]
    order = sorted(range(n), key=lambda k: slope_key(normals[k]))
    critical, at, after = [], [], []
    for u, group in groupby(order, key=normals.__getitem__):
        weak = changes
        for k in group:
            # Neighbors are not parallel, so the neighbors of an edge perpendicular to u are not
            # perpendicular to u. So the pairs counted here are disjoint, and removing the edge
            # joins its two neighbors.
            before = local(k)
            weak += (forward[k - 1] != forward[(k + 1) % n]) - before
            forward[k] = not forward[k]
            changes += local(k) - before
        critical.append(u)
        at.append(weak == 2)
        after.append(changes == 2)
    return Directions(tuple(critical), tuple(at), tuple(after))


def _compare_slopes(u: Vector, v: Vector) -> int:
    # As results of `reduce_direction`, u and v lie in one half-plane.
    return u[1] * v[0] - u[0] * v[1]


slope_key = cmp_to_key(_compare_slopes)


def _find_simplest_between(u: Vector, v: Vector) -> Vector:
    """Find the simplest direction strictly between u and v, v less than a half turn after u."""
    if u[0] > 0 > v[0]:
        return Y_AXIS
    if u == Y_AXIS:
        u, v = (0, -1), (-v[0], -v[1])
    if u[1] < 0:
        # u and v are on one side of the X axis; otherwise the X axis would be the simplest.
        p, q = find_simplest_fraction(-v[1], v[0], -u[1], u[0])
        return p, -q
    return find_simplest_fraction(u[1], u[0], v[1], v[0])
