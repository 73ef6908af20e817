"""Certificates of rounded pieces, written by hand, and their exact distances."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import pairwise, product
from random import Random
from typing import Any, NamedTuple

Certificate = dict[str, Any]
Vertex = tuple[Fraction, Fraction]
TRIPLES = (3, 4, 5), (5, 12, 13), (8, 15, 17), (0, 1, 1), (20, -21, 29), (-3, -4, 5)
HULLS = (
    [(0, 0)],
    [(0, 0), (4, 0)],
    [(0, 0), (5, -12)],
    [(0, 0), (4, 0), (4, 2), (0, 2)],
    [(0, 0), (4, 3), (-3, 4)],
)


class Rounded(NamedTuple):
    """The points at a distance up to a radius from a convex hull."""

    hull: list[Vertex]
    radius: Fraction

    def written(self) -> dict[str, Any]:
        return {"points": write(self.hull), "radius": str(self.radius)}

    def moved(self, by: Vertex) -> Rounded:
        return self._replace(hull=[(x + by[0], y + by[1]) for x, y in self.hull])


def write(points: Iterable[Sequence[Any]]) -> list[list[str]]:
    return [[str(x), str(y)] for x, y in points]


def draw_piece(rng: Random) -> Rounded:
    hull = [(Fraction(x), Fraction(y)) for x, y in rng.choice(HULLS)]
    return Rounded(hull, Fraction(rng.randrange(1, 8), rng.choice([1, 2, 3])))


def find_nearest(one: Rounded, other: Rounded) -> tuple[Vertex, Vertex]:
    """The nearest points of two hulls that are apart."""
    found = [(p, nearest_on(other.hull, p)) for p in one.hull]
    found += [(nearest_on(one.hull, q), q) for q in other.hull]
    return min(found, key=lambda pair: square(*pair))


def nearest_on(hull: list[Vertex], p: Vertex) -> Vertex:
    feet = [foot(a, b, p) for a, b in pairwise([*hull, hull[0]])]
    return min(feet, key=lambda q: square(p, q))


def foot(a: Vertex, b: Vertex, p: Vertex) -> Vertex:
    u, v = b[0] - a[0], b[1] - a[1]
    length = u * u + v * v
    share = ((p[0] - a[0]) * u + (p[1] - a[1]) * v) / length if length else Fraction(0)
    share = min(max(share, Fraction(0)), Fraction(1))
    return a[0] + share * u, a[1] + share * v


def square(p: Vertex, q: Vertex) -> Fraction:
    return (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2


def are_disjoint(one: Rounded, other: Rounded) -> bool:
    """Return whether two hulls have no point in common; edges and joins give the normals."""
    normals = [(q[0] - p[0], q[1] - p[1]) for p, q in product(one.hull, other.hull)]
    for hull in (one.hull, other.hull):
        normals += [(b[1] - a[1], a[0] - b[0]) for a, b in pairwise([*hull, hull[0]])]
    normals += [(-x, -y) for x, y in normals]
    return any(
        max(x * px + y * py for px, py in one.hull) < min(x * px + y * py for px, py in other.hull)
        for x, y in normals
    )


def draw_pair(rng: Random, room: Fraction) -> tuple[Rounded, Rounded]:
    """Draw two pieces with disjoint hulls, at or near a distance."""
    while True:
        one, other = draw_piece(rng), draw_piece(rng)
        x, y, length = rng.choice(TRIPLES)
        off = rng.choice([Fraction(0), Fraction(0), Fraction(1, 10**9), -Fraction(1, 10**9)])
        share = (one.radius + other.radius + room + off) / length
        start, end = rng.choice(one.hull), rng.choice(other.hull)
        by = start[0] + share * x - end[0], start[1] + share * y - end[1]
        if are_disjoint(one, other.moved(by)):
            return one, other.moved(by)


def rounded_layout(
    bodies: Sequence[Any],
    container: Any = None,
    apart: Sequence[Any] = (),
    **more: Any,
) -> Certificate:
    """The certificate of parts placed as they are, each with rounded pieces."""
    parts = [{"id": str(k), "pieces": pieces} for k, pieces in enumerate(bodies)]
    placed = [{"part": part["id"], "move": ["0", "0"]} for part in parts]
    given = {"container": container, "parts": parts, "placements": placed, **more}
    proof = {
        "outside": [None] * (1 + len(more.get("defects", ()))),
        "pieces": [None] * len(parts),
        "apart": [*apart],
    }
    return {
        "format": "exactsweep certificate",
        "version": 3,
        "claim": "layout",
        "layout": {key: value for key, value in given.items() if value is not None},
        "valid": True,
        "turns": [["1", "0"]] * len(parts),
        "proof": proof,
    }


def of_pair(one: Rounded, other: Rounded, room: Fraction) -> tuple[Certificate, bool]:
    """The certificate of two pieces whose hulls are disjoint, and whether it is true."""
    (a, b), (c, d) = find_nearest(one, other)
    normal = [0, 0, 1, 0, str(c - a), str(d - b)]
    found = rounded_layout([[one.written()], [other.written()]], apart=[normal], spacing=str(room))
    total = one.radius + other.radius + room
    return found, square((a, b), (c, d)) >= total * total
