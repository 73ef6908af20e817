"""Checker of certificates: one file that needs Python's standard library alone, to be read.

`CERTIFICATES.md` says what is read. A checker adds up; it never searches. Points are homogeneous,
ints (x, y, w) for (x/w, y/w) with w > 0; left of a line (a, b, c) is a x + b y + c w > 0.

1. Pieces. Convex rings make up a shape if their edges cancel to those of its rings, holes
   clockwise. Then their indicators add up to the winding number of the rings almost everywhere,
   which is never below 0; if each ring is simple, then so the holes are inside the exterior and
   apart from each other, and the pieces are the shape, each point but those of edges once.
2. Layouts. Two shapes are s apart if for any two pieces a, b of them there is a normal n with
   gap = min n.b - max n.a >= 0 and gap^2 >= s^2 |n|^2. Those whose boxes are s apart need none. A
   turn by an irrational angle is a rational one that is off by e, which moves a point at r by at
   most e r; so much is added to s. The container is a shape, too: what a frame has outside it.
3. Positions. O, the positions t at which the interiors of D and G + t meet, is the union of the
   open sums D_i + I(G_j) of their pieces: interiors that meet have an open set in common, and the
   cuts between pieces hold none. Let L be all claimed loops, with O on their left, and fits.
   (a) No sum has a point of an edge of L: a side of it, or the line of the edge, parts them.
   (b) The boundary of O is in L. There D and G touch and their interiors do not meet, so a vertex
       with a convex angle is on an edge, the angle on the edge's other side (where rings touch,
       each angle is in one gap of the other, unless rings of both touch there, which is refused).
       Each such segment of positions is covered, end to end, by sums and edges of L.
   (c) Sums that have a side along an edge of L cover the left of each edge of a loop and nothing of
       its right, but both sides of each fit. No two edges of L are along one another.
   Crossing L anywhere, the indicator of O and the sum of the winding numbers of the loops change
   alike, both are 0 far away (for inner fits 1): off L they are equal.
4. Inner fits are 3 with D all that is outside the container: pieces of a frame without it, and the
   four half-planes beyond the frame, whose sums are half-planes.
5. Sweeps. P, inside the trajectory T, is the exterior of 3. A point p is in T + int G if p - int G,
   which is connected, meets T: if it meets both int P and what is outside. So T + G is P + G
   (3, for P and -G; holes there are unswept) without the inner fit of -G in P (4; the region
   around D is the inner loop, others are unswept), but for slits, which are the fits of both.
"""

from __future__ import annotations

import json
import re
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from decimal import Decimal
from fractions import Fraction
from functools import cache
from math import gcd, lcm
from pathlib import Path
from typing import Any, NamedTuple

RULES = ("missing", "surplus", "turn", "mirror")
EVERY = Fraction(-1), Fraction(2)
FORMAT, VERSION, MAX_DIGITS, MAX_STEPS = "exactsweep certificate", 2, 100_000, 10**8
PI = Fraction(  # cut off after 99 decimals
    31415926535897932384626433832795028841971693993751 * 10**50
    + 5820974944592307816406286208998628034825342117067,
    10**99,
)
BOX = (1, 0), (0, 1), (-1, 0), (0, -1)

Node = tuple[int, int, int]
Grid = tuple[int, int, int, int]
Ring = list[Node]
Edge = tuple[Node, Node]
Span = tuple[Fraction, Fraction]


class Refused(Exception):  # noqa: N818
    """The first reason for which a certificate is not proved."""


class Work:
    """Steps that may be taken yet, and the scale of the boxes."""

    def __init__(self, steps: int) -> None:
        self.left, self.scale = steps, 1

    def take(self, steps: int) -> None:
        """Take steps, or refuse the certificate."""
        self.left -= steps
        need(self.left >= 0, "too large: to check it would take too many steps")

    def fit(self, rings: list[Ring]) -> None:
        """Choose a scale for points like these."""
        xs = [Fraction(x, w) for points in rings for x, _, w in points]
        self.scale = int(2**30 / (max(xs) - min(xs) or 1)) + 1


def need(condition: bool, reason: str) -> None:
    """Refuse the certificate unless a condition holds."""
    if not condition:
        raise Refused(reason)


def fields(item: Any, names: str, optional: str = "") -> list[Any]:
    """Take an object apart by its keys; those that may be left out come as None."""
    known, keys = f"{names} {optional}".split(), item.keys() if type(item) is dict else {}
    need({*names.split()} <= {*keys} <= {*known}, f"not an object with {names}")
    return [item.get(name) for name in known]


def items(item: Any, length: int | None = None) -> list[Any]:
    """Require a list, of a length if one is given."""
    need(type(item) is list and length in (None, len(item)), f"not a list of {length or 'any'}")
    return list(item)


def integer(item: Any, low: int, end: int) -> int:
    """Require an int from low on and below end."""
    need(type(item) is int and low <= item < end, f"not an int from {low} on and below {end}")
    return int(item)


def number(item: Any) -> Fraction:
    """Read a rational in lowest terms from a string; Decimal reads what is too long for int."""
    need(type(item) is str and len(item) <= MAX_DIGITS, "not a number in a string, or a long one")
    written = re.fullmatch("-?(0|[1-9][0-9]*)(/[1-9][0-9]*)?", item) and item != "-0"
    need(bool(written), f"not a number: {item[:40]!r}")
    above, below = (int(Decimal(text)) for text in [*item.split("/"), "1"][:2])
    need(gcd(above, below) == 1 and not item.endswith("/1"), "a number not in lowest terms")
    return Fraction(above, below)


def node(x: Fraction, y: Fraction) -> Node:
    """Return a point, in short ints."""
    w = lcm(x.denominator, y.denominator)
    return x.numerator * (w // x.denominator), y.numerator * (w // y.denominator), w


def point(item: Any) -> Node:
    """Read a point."""
    return node(*map(number, items(item, 2)))


def ring(item: Any) -> Ring:
    """Read at least three points; those that are repeated one after the other count once."""
    read = [point(entry) for entry in items(item)]
    found = [p for k, p in enumerate(read) if p != read[k - 1]]
    need(len(found) > 2, "a ring of fewer than three points")
    return found


def line(p: Node, q: Node) -> Node:
    """Return the line from one point to another, in short ints."""
    a, b, c = p[1] * q[2] - q[1] * p[2], q[0] * p[2] - p[0] * q[2], p[0] * q[1] - q[0] * p[1]
    d = gcd(a, b, c) or 1
    return a // d, b // d, c // d


def side(of: Node, p: Node) -> int:
    """Return a number above 0 left of a line, 0 on it, below 0 right of it."""
    return of[0] * p[0] + of[1] * p[1] + of[2] * p[2]


def edges(points: Ring) -> list[Edge]:
    """Return the edges of a ring."""
    return list(zip(points, [*points[1:], points[0]], strict=True))


def is_convex(points: Ring) -> bool:
    """Return whether a ring turns left at every vertex, and once around in all."""
    lines = [line(*edge) for edge in edges(points)]
    turns = all(side(lines[k - 1], points[(k + 1) % len(points)]) > 0 for k in range(len(points)))
    # Left of an edge is (a, b): each time around it comes up once from below.
    below = [b < 0 or (b == 0 and a < 0) for a, b, _ in lines]
    return turns and sum(below[k - 1] and not now for k, now in enumerate(below)) == 1


def double_area(points: Ring) -> Fraction:
    """Return twice the area of a ring, below 0 if it is clockwise."""
    parts = (Fraction(p[0] * q[1] - q[0] * p[1], p[2] * q[2]) for p, q in edges(points))
    return sum(parts, Fraction())


def do_clash(p: Node, q: Node, r: Node, s: Node, apart: int, count: int) -> bool:
    """Return whether two edges of a ring, so many apart, keep it from being simple."""
    if apart in (1, count - 1):  # neighbours; one must not go back along the other
        a, b, c = (p, q, s) if q == r else (r, s, q)
        (x, y), (u, v) = ((e[0] * b[2] - b[0] * e[2], e[1] * b[2] - b[1] * e[2]) for e in (a, c))
        return side(line(a, b), c) == 0 and x * u + y * v > 0
    one, other = line(p, q), line(r, s)
    if side(one, r) == side(one, s) == 0:
        ends = [
            sorted((Fraction(e[0], e[2]), Fraction(e[1], e[2])) for e in f)
            for f in ((p, q), (r, s))
        ]
        return max(ends[0][0], ends[1][0]) <= min(ends[0][1], ends[1][1])
    return side(one, r) * side(one, s) <= 0 and side(other, p) * side(other, q) <= 0


def grid_box(points: Sequence[Node], scale: int) -> Grid:
    """Return the box of points times a scale: left, right, lower, upper end, rounded outwards."""
    xs, ys = ([(p[k] * scale, p[2]) for p in points] for k in (0, 1))
    low, high = ([-max(-n // w for n, w in at), max(-(-n // w) for n, w in at)] for at in (xs, ys))
    return low[0], low[1], high[0], high[1]


def add_boxes(one: Grid, other: Grid) -> Grid:
    """Return the box of the sum of two sets."""
    return one[0] + other[0], one[1] + other[1], one[2] + other[2], one[3] + other[3]


def are_near(one: Grid, other: Grid, reach: int = 0) -> bool:
    """Return whether boxes overlap or touch, or are less than a reach apart in x and y."""
    return (
        one[0] <= other[1] + reach
        and other[0] <= one[1] + reach
        and one[2] <= other[3] + reach
        and other[2] <= one[3] + reach
    )


def lies(p: Node, a: Node, b: Node) -> bool:
    """Return whether a point is on a closed segment."""
    x, y, z = ((Fraction(e[0], e[2]), Fraction(e[1], e[2])) for e in (p, a, b))
    return side(line(a, b), p) == 0 and min(y, z) <= x <= max(y, z)


def check_simple(points: Ring, work: Work) -> None:
    """Refuse a ring that is not simple."""
    boxed = sorted((grid_box(e, work.scale), k, e) for k, e in enumerate(edges(points)))
    for i, (box, k, one) in enumerate(boxed):
        for against, m, other in boxed[i + 1 :]:
            work.take(1)
            if against[0] > box[1]:
                break
            if are_near(box, against):
                clash = do_clash(*one, *other, (m - k) % len(points), len(points))
                need(not clash, "a ring is not simple")


def read_pieces(item: Any, target: list[Ring], rings: list[Ring], work: Work) -> list[Ring]:
    """Read pieces that make up a target, by (1); the rings in question must be simple."""
    pieces = [ring(piece) for piece in items(item)]
    need(all(map(is_convex, pieces)), "a piece is not convex")
    left: Counter[Edge] = Counter()
    for points, sign in [*((piece, 1) for piece in pieces), *((one, -1) for one in target)]:
        for p, q in edges(points):
            of = max(line(p, q), line(q, p))
            left[of, p] += sign
            left[of, q] -= sign
    need(not any(left.values()), "the edges of pieces do not cancel to those of their shape")
    for points in rings:
        check_simple(points, work)
    return pieces


def shape(item: Any, optional: str = "") -> list[Ring]:
    """Read the rings of a shape, its interior on their left."""
    exterior, holes = fields(item, "exterior", f"holes {optional}")[:2]
    rings = [ring(exterior), *map(ring, [] if holes is None else items(holes))]
    return [one[::-1] if (double_area(one) > 0) == bool(k) else one for k, one in enumerate(rings)]


def loop(item: Any, work: Work) -> Ring:
    """Read a simple ring, counter-clockwise, without straight angles, its least point first."""
    points = ring(item)
    check_simple(points, work)
    bent = all(side(line(p, q), points[k - 1]) for k, (p, q) in enumerate(edges(points)))
    least = min(points, key=lambda p: (Fraction(p[0], p[2]), Fraction(p[1], p[2])))
    need(bent and least == points[0] and double_area(points) > 0, "a loop is not canonical")
    return points


class Solid(NamedTuple):
    """A shape: its rings, its pieces, and the half-planes that belong to it."""

    rings: list[Ring]
    pieces: list[Ring]
    beyond: list[Node]


# Positions, by (3).


def add(p: Node, q: Node) -> Node:
    """Return the sum of two points."""
    return p[0] * q[2] + q[0] * p[2], p[1] * q[2] + q[1] * p[2], p[2] * q[2]


def ways(points: Ring) -> list[tuple[int, int]]:
    """Return the directions of the edges of a ring."""
    return [(q[0] * p[2] - p[0] * q[2], q[1] * p[2] - p[1] * q[2]) for p, q in edges(points)]


def add_convex(one: Ring, other: Ring) -> list[Node]:
    """Return the sides of the sum of two convex rings: their edges, by direction."""
    found, starts = [], []
    for points in (one, other):
        k = min(
            range(len(points)),
            key=lambda k: (
                Fraction(points[k][1], points[k][2]),
                Fraction(points[k][0], points[k][2]),
            ),
        )
        starts.append(points[k:] + points[:k])
    a, b = starts
    u, v, i, j = ways(a), ways(b), 0, 0
    while i < len(a) or j < len(b):
        found.append(add(a[i % len(a)], b[j % len(b)]))
        turn = -1 if i == len(a) else 1 if j == len(b) else u[i][0] * v[j][1] - u[i][1] * v[j][0]
        i, j = i + (turn >= 0), j + (turn <= 0)
    return [line(*edge) for edge in edges(found)]


def clip(sides: Sequence[Node], a: Node, b: Node) -> Span | None:
    """Return the shares of a segment inside open half-planes, from -1 or to 2 if beyond an end."""
    low, high = Fraction(-1), Fraction(2)
    for of in sides:
        at_a, at_b = side(of, a) * b[2], side(of, b) * a[2]
        if at_a <= 0 and at_b <= 0:
            return None
        if at_a <= 0:
            low = max(low, Fraction(at_a, at_a - at_b))
        elif at_b <= 0:
            high = min(high, Fraction(at_a, at_a - at_b))
    return (low, high) if low < high else None


def share(a: Node, b: Node, p: Node, q: Node) -> Span | None:
    """Return the shares of a segment from a to b that are on an edge from p to q."""
    on, other = line(a, b), line(p, q)
    at_p, at_q, at_a, at_b = side(on, p), side(on, q), side(other, a) * b[2], side(other, b) * a[2]
    if a == b:
        return (Fraction(0), Fraction(1)) if lies(a, p, q) else None
    if at_p == at_q == 0:
        k = int(a[0] * b[2] == b[0] * a[2])
        s, t, u = (Fraction(e[k] * a[2] - a[k] * e[2], e[2] * a[2]) for e in (p, q, b))
        return min(s / u, t / u), max(s / u, t / u)
    if at_p * at_q > 0 or at_a * at_b > 0 or at_a == at_b:
        return None
    return (Fraction(at_a, at_a - at_b),) * 2


def is_covered(spans: list[Span]) -> bool:
    """Return whether spans cover all from 0 to 1 but for points."""
    reach = Fraction(0)
    for low, high in sorted(spans):
        if low > reach:
            return False
        reach = max(reach, high)
    return reach >= 1


def turned(of: Solid) -> Solid:
    """Turn a shape by half a turn about the origin."""
    rings, pieces = ([[(-x, -y, w) for x, y, w in e] for e in listed] for listed in of[:2])
    return Solid(rings, pieces, [])


def winds(points: Ring, p: Node) -> bool:
    """Return whether a ring winds around a point, which is not on it."""
    crossed = 0
    for a, b in edges(points):
        up, to = a[1] * p[2] <= p[1] * a[2], b[1] * p[2] <= p[1] * b[2]
        crossed += up != to and (side(line(a, b), p) > 0) == up
    return crossed % 2 == 1


def count(rings: list[Ring]) -> int:
    """Count vertices."""
    return sum(map(len, rings))


def list_contacts(d: list[Ring], h: list[Ring]) -> Iterator[Edge]:
    """List, by (3b), sums of a vertex of one and an edge of the other, and where rings touch."""
    for one, other in ((d, h), (h, d)):
        sides = [pair for points in other for pair in zip(edges(points), ways(points), strict=True)]
        for points in one:
            out = ways(points)
            for k, v in enumerate(points):
                (x, y), (z, w) = out[k - 1], out[k]
                if x * w >= y * z:
                    for (p, q), (s, t) in sides:
                        if s * w >= t * z and t * x >= s * y:
                            yield add(v, p), add(v, q)
    touching = [
        [
            p
            for a in rings
            for b in rings
            for p in a
            if a is not b and any(lies(p, *e) for e in edges(b))
        ]
        for rings in (d, h)
    ]
    yield from ((add(p, q), add(p, q)) for p in touching[0] for q in touching[1])


def read_frame(item: Any) -> Ring:
    """Read the left, lower, right and upper end of a rectangle."""
    left, low, right, high = map(number, items(item, 4))
    need(left < right and low < high, "frame: no rectangle")
    return [node(left, low), node(right, low), node(right, high), node(left, high)]


def solid(rings: list[Ring], pieces: Any, work: Work) -> Solid:
    """Read the pieces of a shape."""
    return Solid(rings, read_pieces(pieces, rings, rings, work), [])


def outside(rings: list[Ring], frame: Any, pieces: Any, work: Work) -> Solid:
    """Read what is outside a shape, within a frame and beyond it."""
    around, turned = read_frame(frame), [one[::-1] for one in rings]
    found = read_pieces(pieces, [around, *turned], rings, work)
    return Solid(turned, found, [line(q, p) for p, q in edges(around)])


def sum_sides(d: Solid, h: Solid, k: int) -> list[Node]:
    """Return the sides of sum k: of pieces of both, in order, or of a half-plane and the second."""
    i, j = divmod(k, len(h.pieces))
    if i < len(d.pieces):
        return add_convex(d.pieces[i], h.pieces[j])
    a, b, c = d.beyond[k - len(d.pieces) * len(h.pieces)]
    at = min(Fraction(a * x + b * y, w) for piece in h.pieces for x, y, w in piece)
    return [(a * at.denominator, b * at.denominator, c * at.denominator - at.numerator)]


def check_positions(
    d: Solid, h: Solid, loops: list[Ring], fits: list[Edge], chains: Any, work: Work
) -> None:
    """Prove by (3) that loops, O on their left, and fits are the boundary of O = D + H."""
    width, count = len(h.pieces), len(d.pieces) * len(h.pieces)
    sides = cache(lambda k: sum_sides(d, h, k))
    known = [e for points in loops for e in edges(points)] + fits
    along: dict[Node, list[list[tuple[Fraction, Fraction]]]] = {}
    for p, q in known:
        ends = sorted((Fraction(e[0], e[2]), Fraction(e[1], e[2])) for e in (p, q))
        along.setdefault(max(line(p, q), line(q, p)), []).append(ends)
    for found in along.values():
        found.sort()
        need(all(found[k][1] <= found[k + 1][0] for k in range(len(found) - 1)), "edges overlap")

    boxes, others = ([grid_box(e, work.scale) for e in pieces] for pieces in (d.pieces, h.pieces))
    whole = grid_box([p for piece in h.pieces for p in piece], work.scale)
    for n, (a, b) in enumerate(known):
        box, on, left, right = grid_box((a, b), work.scale), line(a, b), [], []
        near = [*range(count, count + len(d.beyond))]
        for i, one in enumerate(boxes):
            work.take(1)
            if are_near(box, add_boxes(one, whole)):
                work.take(width)
                for j, other in enumerate(others):
                    if are_near(box, add_boxes(one, other)):
                        near.append(i * width + j)
        for k in near:
            work.take(len(sides(k)))
            touch = next((of for of in sides(k) if side(of, a) <= 0 >= side(of, b)), None)
            if touch is None:
                need(clip(sides(k), a, b) is None, "an edge of a loop or a fit is overlapped")
            elif side(touch, a) == 0 == side(touch, b):
                rest = [of for of in sides(k) if of != touch]
                if a == b and all(side(of, a) >= 0 for of in rest):
                    left, right = [EVERY], [EVERY]
                elif a != b and (span := clip(rest, a, b)):
                    same = touch[0] * on[0] + touch[1] * on[1] > 0
                    (left if same else right).append(span)
        is_fit = n >= len(known) - len(fits)
        need(is_covered(left), "an edge of a loop or a fit is not along the overlap")
        need(is_covered(right) if is_fit else not right, "a loop is a fit, or a fit a loop")
        alone = a != b or not any(lies(a, *e) for k, e in enumerate(known) if k != n)
        need(alone, "a fit of one point is on a loop or another fit")

    contacts = list(list_contacts(d.rings, h.rings))
    for (a, b), chain in zip(contacts, items(chains, len(contacts)), strict=True):
        reach, closed = Fraction(0), False
        for n in items(chain):
            work.take(8)
            n = integer(n, -len(known), count + len(d.beyond))
            span = share(a, b, *known[-1 - n]) if n < 0 else clip(sides(n), a, b)
            need(span is not None, "chains: what does not meet its segment")
            assert span is not None
            need(span[0] < reach or ((n < 0 or closed) and span[0] == reach), "chains: a gap")
            if span[1] > reach or (n < 0 and span[1] == reach):
                reach, closed = span[1], n < 0
        need(reach > 1 or (closed and reach == 1), "chains: one does not reach the end")


def read_fits(item: Any) -> list[Edge]:
    """Read pairs of points."""
    return [(point(p), point(q)) for p, q in (items(fit, 2) for fit in items(item))]


def prove_no_fit(c: dict[str, Any], work: Work) -> str:
    """Prove a no-fit polygon by (3)."""
    head = "format version claim directrix generatrix exterior holes exact_fits proof"
    _, _, _, d, g, exterior, holes, fits, proof = fields(c, head)
    (first, second, chains), d, g = fields(proof, "directrix generatrix chains"), shape(d), shape(g)
    work.fit(d + g)
    loops = [loop(exterior, work), *(loop(hole, work)[::-1] for hole in items(holes))]
    stationary, moving = solid(d, first, work), turned(solid(g, second, work))
    check_positions(stationary, moving, loops, read_fits(fits), chains, work)
    return f"no-fit polygon of {count(d)} and {count(g)} vertices, with {count(loops)}"


def prove_inner_fit(c: dict[str, Any], work: Work) -> str:
    """Prove an inner fit by (4)."""
    head = "format version claim container part regions exact_fits proof"
    _, _, _, d, g, regions, fits, proof = fields(c, head)
    frame, first, second, chains = fields(proof, "frame outside part chains")
    d, g, loops = shape(d), shape(g), []
    work.fit(d + g)
    for exterior, holes in (fields(region, "exterior holes") for region in items(regions)):
        loops += [loop(exterior, work)[::-1], *(loop(hole, work) for hole in items(holes))]
    stationary, moving = outside(d, frame, first, work), turned(solid(g, second, work))
    check_positions(stationary, moving, loops, read_fits(fits), chains, work)
    return f"inner fit of {count(g)} vertices in {count(d)}, with {count(loops)}"


def prove_sweep(c: dict[str, Any], work: Work) -> str:
    """Prove a sweep by (5)."""
    if "claim" in c:
        head = "kind directrix generatrix exterior holes exact_fits inner outer unswept area proof"
        kind, d, g, t, holes, fits, inner, outer, unswept, area, proof = fields(
            c, head, "format version claim"
        )[:11]
        need(kind == "SS", "kind: not SS")
        at = (0, 0, 1)
        d, g = shape(d), shape(g)
    else:
        head = "kind directrix generatrix trajectory exact_fits inner outer area proof"
        head += " reference direction"
        kind, d, g, t, fits, inner, outer, area, proof, reference, direction = fields(
            c, head, "format version contacts inner_drawn outer_drawn"
        )[:11]
        d, g, holes, unswept, at = [ring(d)], [ring(g)], [], [], point(reference)
        check_kind(kind, d[0], g[0], items(direction, 2))
    frame, *cut, slits, within, chains = fields(
        proof, "frame directrix generatrix trajectory outside slits within chains"
    )
    work.fit(d + g)
    x, y, w = at
    t = [add(p, (-x, -y, w)) for p in loop(t, work)]
    fits = [(add(p, (-x, -y, w)), add(q, (-x, -y, w))) for p, q in read_fits(fits)]
    inner, outer = loop(inner, work), loop(outer, work)
    holes, unswept = ([loop(hole, work)[::-1] for hole in items(e)] for e in (holes, unswept))
    inside = [integer(k, 0, len(unswept)) for k in items(within)]
    between, beside = (read_fits(listed) for listed in items(slits, 2))
    first, second, third = items(chains, 3)
    still, moving = solid(d, cut[0], work), solid(g, cut[1], work)
    check_positions(still, turned(moving), [t, *holes], fits, first, work)
    loops = [outer, *(hole for k, hole in enumerate(unswept) if k not in inside)]
    check_positions(solid([t], cut[2], work), moving, loops, between, second, work)
    loops = [inner[::-1], *(hole for k, hole in enumerate(unswept) if k in inside)]
    check_positions(outside([t], frame, cut[3], work), moving, loops, beside, third, work)
    p, q, r = still.pieces[0][:3]
    x, y, w = add(add(p, q), r)
    need(winds(inner, (x, y, 3 * w)), "inner: not the loop around the directrix")
    rest = double_area(outer) - double_area(inner) + sum(map(double_area, unswept))
    need(rest == 2 * number(area), "area: not that between the loops")
    return f"{kind} sweep of {count(g)} around {count(d)} vertices, with {len(t)}"


def check_kind(kind: Any, d: Ring, g: Ring, direction: list[Any]) -> None:
    """Refuse a wrong kind, or a direction to which the two are not monotone."""
    convex = is_convex(g) + (is_convex(g) and is_convex(d))
    need(kind == ("MM", "CM", "CC")[convex], "kind: another one")
    x, y = (
        integer(int(n) if type(n) is str else n, -(10**MAX_DIGITS), 10**MAX_DIGITS)
        for n in direction
    )
    for points in (d, g):
        signs = [s > 0 for s in (x * u + y * v for u, v in ways(points)) if s]
        need(sum(signs[k - 1] != one for k, one in enumerate(signs)) == 2, "direction: not shared")


# Layouts, by (2).


class Placed(NamedTuple):
    """Pieces where they are, all their points, the error of these, and boxes times a scale."""

    pieces: list[Ring]
    points: Ring
    error: Fraction
    boxes: list[Grid]
    box: Grid


def read_turn(item: Any) -> Any:
    """Read a turn: cosine and sine, or degrees where these are irrational."""
    if type(item) is list:
        cosine, sine = map(number, items(item, 2))
        need(cosine**2 + sine**2 == 1, "a turn of another length than 1")
        return cosine, sine
    degrees = number(item) % 360
    quarter = BOX[int(degrees) // 90]
    return degrees if degrees % 90 else (Fraction(quarter[0]), Fraction(quarter[1]))


def turn_error(turn: tuple[Fraction, Fraction], degrees: Fraction) -> Fraction:
    """Bound how far a turn is from one by degrees, by the power series in steps of 1e-110."""
    unit = 10**110
    angle = int(PI * degrees / 180 * unit)
    sums, term, k = [0, 0, 0, 0], unit, 0
    while term:
        sums[k % 4] += term
        k += 1
        term = term * angle // (unit * k)
    cosine, sine = Fraction(sums[0] - sums[2], unit), Fraction(sums[1] - sums[3], unit)
    return abs(turn[0] - cosine) + abs(turn[1] - sine) + Fraction(1, 10**95)


def place(points: Ring, turn: tuple[Fraction, Fraction], mirrored: bool, move: Node) -> Ring:
    """Mirror, turn and move a ring; mirrored it would go around the other way."""
    r = lcm(turn[0].denominator, turn[1].denominator)
    c, s = int(turn[0] * r), int(turn[1] * r)
    found = [(-x, y, w) for x, y, w in points[::-1]] if mirrored else points
    return [add((c * x - s * y, s * x + c * y, r * w), move) for x, y, w in found]


def are_apart(one: Ring, other: Ring, way: tuple[int, int], distance: Fraction) -> bool:
    """Return whether a normal shows that points are at a distance from others, to its side."""
    x, y = way
    high = max(Fraction(x * p[0] + y * p[1], p[2]) for p in one)
    gap = min(Fraction(x * p[0] + y * p[1], p[2]) for p in other) - high
    return (x, y) != (0, 0) and gap >= 0 and gap**2 >= distance**2 * (x * x + y * y)


def holds(piece: Ring, p: Node, error: Fraction | None) -> bool:
    """Return whether a point is in a piece: inside, whatever the error of its place, or closed."""
    found = [(of, Fraction(side(of, p), p[2])) for of in (line(*e) for e in edges(piece))]
    if error is None:
        return all(h >= 0 for _, h in found)
    return all(h > 0 and h**2 > error**2 * (a * a + b * b) for (a, b, _), h in found)


class Layout:
    """A layout as its certificate has it: valid, by (2), or with faults."""

    def __init__(self, c: dict[str, Any], work: Work) -> None:
        head = "format version kind layout valid turns frame pieces outside apart faults"
        _, _, _, layout, self.valid, turns, frame, cut, beyond, apart, faults = fields(c, head)
        self.work, self.apart, self.faults = work, items(apart), items(faults)
        need(type(self.valid) is bool, "valid: neither true nor false")
        need(not self.valid or None not in (beyond, *items(cut)), "pieces: some are missing")
        container, parts, places, *gaps = fields(
            layout, "container parts placements", "spacing margin"
        )
        self.spacing, self.margin = (Fraction(0) if gap is None else number(gap) for gap in gaps)
        need(self.spacing >= 0 <= self.margin, "a spacing or a margin below 0")
        self.corners = read_frame(frame)
        work.fit([self.corners])

        keys = "holes demand turns mirrored"
        self.parts = [fields(part, "id exterior", keys) for part in items(parts)]
        self.ids = [part[0] for part in self.parts]
        need({*map(type, self.ids)} <= {str} and len({*self.ids}) == len(self.ids), "parts: ids")
        self.rings = [shape(part, "id demand turns mirrored") for part in parts]
        pieces = [
            [] if listed is None else solid(rings, listed, work).pieces
            for listed, rings in zip(items(cut, len(parts)), self.rings, strict=True)
        ]
        self.facts: list[tuple[int, Any, bool]] = []
        self.placed: list[Placed] = []
        for item, turned in zip(items(places), items(turns, len(places)), strict=True):
            name, asked, move, mirrored = fields(item, "part turn move", "mirrored")
            need(type(mirrored) in (type(None), bool), "mirrored: neither true nor false")
            need(type(name) is str and name in self.ids, "placements: of no part")
            k, turn, rational = self.ids.index(name), read_turn(asked), read_turn(items(turned))
            error = Fraction(0)
            if isinstance(turn, Fraction):
                far = max(Fraction(abs(x) + abs(y), w) for one in self.rings[k] for x, y, w in one)
                error = far * turn_error(rational, turn)
            need(error > 0 or turn == rational, "turns: not the turn of the placement")
            self.facts.append((k, turn, bool(mirrored)))
            to = rational, bool(mirrored), point(move)
            self.placed.append(self.put([place(piece, *to) for piece in pieces[k]], error))
        # All that is outside comes last, for its number is -1.
        outer = shape(container)
        found = [] if beyond is None else outside(outer, frame, beyond, work).pieces
        self.placed.append(self.put(found, Fraction(0)))

    def put(self, pieces: list[Ring], error: Fraction) -> Placed:
        """Put pieces where they are."""
        every = [p for piece in pieces for p in piece] or [(0, 0, 1)]
        boxes = [grid_box(piece, self.work.scale) for piece in pieces]
        return Placed(pieces, every, error, boxes, grid_box(every, self.work.scale))

    def prove(self) -> str:
        """Prove what is claimed, and say what that is."""
        found = f"layout: {len(self.facts)} placements of {len(self.ids)} parts"
        if not self.valid:
            need(self.faults != [] == self.apart, "faults: none, or normals beside them")
            for fault in self.faults:
                self.prove_fault(fault)
            return f"{found}, not valid: {len(self.faults)} faults"
        need(self.faults == [], "faults: of a valid layout")
        for kind in RULES:
            need(not any(self.breaks(kind, k) for k in range(len(self.ids))), f"valid: {kind}")
        self.prove_apart()
        return f"{found}, valid, spacing {self.spacing}, margin {self.margin}"

    def breaks(self, kind: str, k: int) -> bool:
        """Return whether placements of part k break a rule."""
        demand, turns, mirrored = self.parts[k][3:]
        need(type(mirrored) in (type(None), bool), "mirrored: neither true nor false")
        found = [fact for fact in self.facts if fact[0] == k]
        if kind == "turn":
            allowed = None if turns is None else [read_turn(turn) for turn in items(turns)]
            return allowed is not None and not all(turn in allowed for _, turn, _ in found)
        if kind == "mirror":
            return mirrored is False and any(fact[2] for fact in found)
        asked = len(found) if demand is None else integer(demand, 0, 10**9)
        return len(found) < asked if kind == "missing" else len(found) > asked

    def prove_apart(self) -> None:
        """Prove that parts are inside the frame, and apart from each other and the container."""
        normals: dict[tuple[int, ...], tuple[int, int]] = {}
        for entry in self.apart:
            key = tuple(integer(k, -1, 10**9) for k in items(entry, 6)[:4])
            need(key not in normals, "apart: a pair is there twice")
            normals[key] = point(entry[4:])[:2]
        for one in self.placed[:-1]:
            for p, way in zip(self.corners, BOX, strict=True):
                inside = are_apart([p], one.points, way, self.margin + one.error)
                need(inside, "a part reaches beyond the frame")
        widest = max(self.spacing, self.margin) + 2 * max(one.error for one in self.placed)
        reach = -int(-widest * self.work.scale // 1)
        order = sorted(range(-1, len(self.facts)), key=lambda a: self.placed[a].box)
        for n, a in enumerate(order):
            for b in order[n + 1 :]:
                self.work.take(1)
                if self.placed[b].box[0] > self.placed[a].box[1] + reach:
                    break
                if are_near(self.placed[a].box, self.placed[b].box, reach):
                    self.prove_pair(min(a, b), max(a, b), reach, normals)

    def prove_pair(self, a: int, b: int, reach: int, normals: dict[Any, tuple[int, int]]) -> None:
        """Prove that two shapes are apart: by one normal of both, or for all pairs of pieces."""
        one, other = self.placed[a], self.placed[b]
        distance = (self.margin if a < 0 else self.spacing) + one.error + other.error
        if way := normals.get((a, -1, b, -1)):
            self.work.take(len(one.points) + len(other.points))
            need(are_apart(one.points, other.points, way, distance), f"{a} and {b}: not apart")
            return
        for i, (piece, box) in enumerate(zip(one.pieces, one.boxes, strict=True)):
            if not are_near(box, other.box, reach):
                continue
            for j, (against, around) in enumerate(zip(other.pieces, other.boxes, strict=True)):
                if are_near(box, around, reach):
                    self.work.take(len(piece) + len(against))
                    ways = [normals[a, i, b, j]] if (a, i, b, j) in normals else BOX
                    apart = any(are_apart(piece, against, way, distance) for way in ways)
                    need(apart, f"piece {i} of {a} and piece {j} of {b}: no normal that parts them")

    def prove_fault(self, fault: Any) -> None:
        """Prove one fault by its witness."""
        kind = fault.get("kind") if type(fault) is dict else None
        if kind in ("overlap", "outside", "too close"):
            self.prove_near(kind, *fields(fault, "kind placements pieces points")[1:])
            return
        name, both = fields(fault, "kind part", "edges")[1:]
        need(type(name) is str and name in self.ids, "faults: of no part")
        if kind != "shape":
            need(kind in RULES and self.breaks(kind, self.ids.index(name)), f"faults: {kind}")
            return
        rings = self.rings[self.ids.index(name)]
        (m, i), (n, j) = ([integer(k, 0, 10**9) for k in items(e, 2)] for e in items(both, 2))
        need(m < len(rings) > n and i < len(rings[m]) and j < len(rings[n]), "edges: not there")
        (p, q), (r, s), count = edges(rings[m])[i], edges(rings[n])[j], len(rings[m])
        clash = do_clash(p, q, r, s, (j - i) % count, count) and i != j
        if m != n:
            clash = side(line(p, q), r) * side(line(p, q), s) < 0
            clash = clash and side(line(r, s), p) * side(line(r, s), q) < 0
        need(clash, "faults: the edges do not clash")

    def prove_near(self, kind: str, of: Any, numbers: Any, points: Any) -> None:
        """Prove that a point is inside two shapes, or that points of them are too close."""
        a, *others = [integer(n, 0, len(self.facts)) for n in items(of)]
        need(len(others) < 2 and a not in others, "faults: not of one placement or of two")
        need(kind == "too close" or (kind == "overlap") == bool(others), f"faults: {kind} of what")
        room, ends, found = self.spacing if others else self.margin, [], []
        both = zip((a, *(others or [-1])), items(numbers, 2), items(points, 2), strict=True)
        for n, i, end in both:
            piece = self.placed[n].pieces[integer(i, 0, len(self.placed[n].pieces))]
            error = self.placed[n].error
            room -= error
            ends.append(point(end))
            found.append(holds(piece, ends[-1], error if kind != "too close" else None))
        (x, y, w), (u, v, z) = ends
        square = Fraction((x * z - u * w) ** 2 + (y * z - v * w) ** 2, (w * z) ** 2)
        near = room > 0 and square < room**2 if kind == "too close" else square == 0
        need(near and all(found), f"faults: the points do not show {kind}")


def prove(certificate: Any, max_steps: int = MAX_STEPS) -> str:
    """Prove a certificate, as `json.loads` gives it, and say what is proved.

    Raises:
        Refused: it is not proved; the first reason.
    """
    work = Work(max_steps)
    need(type(certificate) is dict, "a certificate is an object")
    need(certificate.get("format") == FORMAT, f"format: not {FORMAT!r}")
    version = certificate.get("version")
    need(type(version) is int and version == VERSION, f"version: not {VERSION}")
    if certificate.get("kind") == "layout":
        return Layout(certificate, work).prove()
    claim = certificate.get("claim", "sweep")
    need(claim in ("no_fit", "inner_fit", "sweep"), "claim: unknown")
    return {"no_fit": prove_no_fit, "inner_fit": prove_inner_fit, "sweep": prove_sweep}[claim](
        certificate, work
    )


def load(text: str) -> Any:
    """Read JSON in which no object has one key twice."""

    def once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        need(len(dict(pairs)) == len(pairs), "a key is there twice")
        return dict(pairs)

    return json.loads(text, object_pairs_hook=once)


def main(arguments: list[str]) -> int:
    """Print what a certificate proves, or why it does not; return the exit code."""
    try:
        print(f"proved: {prove(load(Path(arguments[0]).read_text(encoding='utf-8')))}")
    except (Refused, ValueError, RecursionError) as error:
        print(f"not proved: {error}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
