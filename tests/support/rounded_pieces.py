"""Certificates of rounded pieces, written by hand, and their exact distances."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import combinations, pairwise, product
from math import isqrt
from random import Random
from typing import Any, NamedTuple

Certificate = dict[str, Any]
Vertex = tuple[Fraction, Fraction]
TRIPLES = (3, 4, 5), (5, 12, 13), (8, 15, 17), (0, 1, 1), (20, -21, 29), (-3, -4, 5)
ORIGIN = Fraction(0), Fraction(0)
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
    """Return the nearest points of two disjoint hulls."""
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
    """Decide whether two hulls are disjoint, by the normals of edges and of joins."""
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
    """Return the certificate of parts at their original positions, each with rounded pieces."""
    parts = [{"id": str(k), "pieces": pieces} for k, pieces in enumerate(bodies)]
    placed = [{"part": part["id"], "move": ["0", "0"]} for part in parts]
    given = {"container": container, "parts": parts, "placements": placed, **more}
    pieces = [None] * (len(parts) + 1 + len(more.get("defects", ())))
    return {
        "format": "exactsweep certificate",
        "version": 3,
        "claim": "layout",
        "layout": {key: value for key, value in given.items() if value is not None},
        "valid": True,
        "turns": [["1", "0"]] * len(parts),
        "proof": {"pieces": pieces, "apart": [*apart]},
    }


def of_pair(one: Rounded, other: Rounded, room: Fraction) -> tuple[Certificate, bool]:
    """Return the certificate of two pieces with disjoint hulls, and whether it is true."""
    (a, b), (c, d) = find_nearest(one, other)
    normal = [0, 0, 1, 0, str(c - a), str(d - b)]
    found = rounded_layout([[one.written()], [other.written()]], apart=[normal], spacing=str(room))
    total = one.radius + other.radius + room
    return found, square((a, b), (c, d)) >= total * total


# --- Layouts of rounded pieces, compared with their certificates --------------------------------


def draw_rounded(rng: Random) -> Iterator[Certificate]:
    """Draw certificates of layouts that differ by a tiny move, in a disc or without container."""
    spacing = Fraction(rng.choice([0, 0, 1]), rng.choice([1, 3]))
    one, other = draw_pair(rng, spacing)
    far = one.moved((Fraction(rng.randrange(-40, -20)), Fraction(rng.randrange(30))))
    for off in (Fraction(0), Fraction(rng.choice([-1, 1]), 10 ** rng.randrange(1, 12))):
        bodies = [one, other.moved((off, -off)), far]
        disc = None
        if rng.random() < 0.5:
            reach = max(square(ORIGIN, p) for body in bodies for p in body.hull)
            radius = isqrt(int(reach)) + rng.choice([0, 1]) + max(b.radius for b in bodies)
            disc = {"pieces": [{"points": [["0", "0"]], "radius": str(radius)}]}
        yield certify(bodies, disc, spacing)


def certify(
    bodies: Sequence[Rounded], disc: Any, spacing: Fraction, is_valid: bool | None = None
) -> Certificate:
    """Write a certificate with the normals, or the faults, of bodies of one piece each."""
    apart, faults = [], []
    for (i, one), (j, other) in combinations(enumerate(bodies), 2):
        (a, b), (c, d) = find_nearest(one, other)
        apart.append([i, 0, j, 0, str(c - a), str(d - b)])
        for kind, room in (("overlap", Fraction(0)), ("too close", spacing)):
            total = one.radius + other.radius + room
            if square((a, b), (c, d)) < total**2:
                share = (one.radius + room / 2) / total
                point = [str(a + share * (c - a)), str(b + share * (d - b))]
                faults.append({"kind": kind, "placements": [i, j], "point": point})
                break
    for i, one in enumerate(bodies if disc else ()):
        if not is_in_disc(one, disc):
            point = write([find_beyond(one, read_piece(disc["pieces"][0])[1])])[0]
            faults.append({"kind": "outside", "placements": [i, -1], "point": point})
    found = rounded_layout([[b.written()] for b in bodies], disc, apart, spacing=str(spacing))
    if not faults if is_valid is None else is_valid:
        return found
    kept = {key: value for key, value in found.items() if key != "proof"}
    return {**kept, "valid": False, "faults": faults}


def find_beyond(body: Rounded, radius: Fraction) -> Vertex:
    """Find a point inside a body that is farther from the origin than a radius."""
    x, y = max(body.hull, key=lambda p: square(ORIGIN, p))
    low, high = Fraction(1), radius + body.radius + 1
    while True:
        middle = (low + high) / 2
        point = x * middle, y * middle
        if square(ORIGIN, point) <= radius**2:
            low = middle
        elif square((x, y), point) < body.radius**2:
            return point
        else:
            high = middle


def claim_valid(certificate: Certificate, rng: Random) -> tuple[str, Certificate]:
    """Move a body a little, and claim that the layout is valid."""
    given = certificate["layout"]
    bodies = [Rounded(*read_piece(part["pieces"][0])) for part in given["parts"]]
    k = rng.randrange(len(bodies))
    by = [Fraction(rng.randrange(-3, 4), 10 ** rng.randrange(1, 14)) for _ in "xy"]
    bodies[k] = bodies[k].moved((by[0], by[1]))
    spacing = Fraction(given["spacing"])
    return "claimed to be valid", certify(bodies, given.get("container"), spacing, is_valid=True)


def read_piece(item: Any) -> tuple[list[Vertex], Fraction]:
    points = [(Fraction(x), Fraction(y)) for x, y in item["points"]]
    return points, Fraction(item.get("radius") or 0)


def is_in_disc(body: Rounded, disc: Any) -> bool:
    (center, *_), radius = read_piece(disc["pieces"][0])
    room = radius - body.radius
    return room >= 0 and all(square(center, p) <= room**2 for p in body.hull)


def is_true_rounded(certificate: Certificate, _: object) -> bool:
    """Decide by distances whether a layout is valid, or has all listed faults."""
    given = certificate["layout"]
    if given.get("defects") or Fraction(given.get("margin") or 0):
        return False
    parts = {part["id"]: part for part in given["parts"]}
    placed = [place_pieces(parts[item["part"]], item) for item in given["placements"]]
    errors = [Fraction(parts[item["part"]].get("error") or 0) for item in given["placements"]]
    spacing, disc = Fraction(given.get("spacing") or 0), given.get("container")
    wrong = set[Any]()
    for (i, ones), (j, others) in combinations(enumerate(placed), 2):
        for one, other in product(ones, others):
            total = one.radius + other.radius + errors[i] + errors[j]
            reach = square(*find_nearest(one, other)) if are_disjoint(one, other) else Fraction(-1)
            wrong |= {("overlap", i, j)} if reach < total**2 else set()
            wrong |= {("too close", i, j)} if reach < (total + spacing) ** 2 else set()
    for i, ones in enumerate(placed if disc and disc["pieces"] else ()):
        grown = [one._replace(radius=one.radius + errors[i]) for one in ones]
        wrong |= set() if all(is_in_disc(one, disc) for one in grown) else {("outside", -1, i)}
    if certificate["valid"]:
        return not wrong
    claimed = {(fault["kind"], *sorted(fault["placements"])) for fault in certificate["faults"]}
    return claimed <= wrong


def place_pieces(part: Any, item: Any) -> list[Rounded]:
    turn, flag = item.get("turn") or "0", -1 if item.get("mirrored") else 1
    c, s = map(Fraction, ("1", "0") if turn == "0" else turn)
    found, (u, v) = [], map(Fraction, item["move"])
    for points, radius in map(read_piece, part["pieces"]):
        at = [(c * flag * x - s * y + u, s * flag * x + c * y + v) for x, y in points]
        found.append(Rounded(at[::flag], radius))
    return found
