"""Checker of certificates: one file that needs Python's standard library alone, to be read.

`CERTIFICATES.md` says what is read. A checker adds up; it never searches. Points are homogeneous,
ints (x, y, w) for (x/w, y/w) with w > 0; left of a line (a, b, c) is a x + b y + c w > 0.

1. Pieces. Convex rings make up a shape if their edges cancel to those of its rings, holes
   clockwise. Then their indicators add up to the winding number of the rings, almost everywhere,
   which so is never below 0. If each ring is simple, this says that holes are inside the exterior
   and apart from each other, and that the pieces are the shape and do not overlap.
2. Layouts. Two shapes are s apart if for any two pieces a, b of them there is a normal n with
   gap = min n.b - max n.a >= 0 and gap^2 >= s^2 |n|^2. The container is a shape, too: what a frame
   has outside it. A turn by an irrational angle is a rational one that is off by e, which moves a
   point at r by at most e r; so much is added to s.
3. Positions. O, the positions t at which the interiors of D and G + t meet, is the union of the
   open sums D_i + I(G_j) of their pieces: interiors that meet have an open set in common, and the
   cuts between pieces hold none. Let L be all claimed loops, with O on their left, and fits.
   (a) No sum has a point of an edge of L.
   (b) The boundary of O is in L. There D and G + t touch, and their interiors do not meet: so a
       vertex with a convex angle is on an edge, its angle on the other side of it; or it is one of
       two points at which rings touch, each with angles in gaps of the other. Each such segment
       of positions is covered, end to end, by sums and edges of L.
   (c) Sums that have a side along an edge of L cover all of its left but points, and nothing of
       its right if it is of a loop, all of it if it is a fit. No edge of L is along another.
   Crossing L anywhere but at some points, the indicator of O and the sum of the winding numbers of
   the loops change alike. Far away both are 0 (in 4 the first is 1), so off L they are equal.
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
from itertools import chain, pairwise
from math import gcd, lcm
from pathlib import Path
from typing import Any, NamedTuple

FORMAT, VERSION, MAX_DIGITS, MAX_STEPS = "exactsweep certificate", 2, 20_000, 10**8
PI = Fraction(  # cut off after 99 decimals
    31415926535897932384626433832795028841971693993751 * 10**50
    + 5820974944592307816406286208998628034825342117067,
    10**99,
)
BOX = (1, 0), (0, 1), (-1, 0), (0, -1)
NONE, ALL = Fraction(0), (Fraction(-1), Fraction(2))

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
        """Choose a scale for shapes like these."""
        xs = [Fraction(x, w) for points in rings for x, _, w in points]
        self.scale = int(2**30 / (max(xs) - min(xs) or 1)) + 1


def need(condition: bool, reason: str) -> None:
    """Refuse the certificate unless a condition holds."""
    if not condition:
        raise Refused(reason)


def fields(item: Any, names: str, optional: str = "") -> list[Any]:
    """Take an object apart by its keys; those that may be left out come as None."""
    known, keys = f"{names} {optional}".split(), {*item} if type(item) is dict else {None}
    need({*names.split()} <= keys <= {*known}, f"not an object with {names}")
    return [item.get(name) for name in known]


def items(item: Any, length: int | None = None) -> list[Any]:
    """Require a list, of a length if one is given."""
    need(type(item) is list and length in (None, len(item)), "not a list of the right length")
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


def read_fits(item: Any) -> list[Edge]:
    """Read pairs of points."""
    return [(point(p), point(q)) for p, q in (items(fit, 2) for fit in items(item))]


def ring(item: Any) -> Ring:
    """Read at least three points; those that are repeated one after the other count once."""
    read = [point(entry) for entry in items(item)]
    found = [p for k, p in enumerate(read) if p != read[k - 1]]
    need(len(found) > 2, "a ring of fewer than three points")
    return found


def shape(item: Any, optional: str = "") -> list[Ring]:
    """Read the rings of a shape, its interior on their left."""
    exterior, holes = fields(item, "exterior", f"holes {optional}")[:2]
    rings = [ring(exterior), *map(ring, [] if holes is None else items(holes))]
    return [one[::-1] if (double_area(one) > 0) == bool(k) else one for k, one in enumerate(rings)]


def line(p: Node, q: Node) -> Node:
    """Return the line from one point to another, in short ints."""
    a, b, c = p[1] * q[2] - q[1] * p[2], q[0] * p[2] - p[0] * q[2], p[0] * q[1] - q[0] * p[1]
    d = gcd(a, b, c) or 1
    return a // d, b // d, c // d


def side(of: Node, p: Node) -> int:
    """Return a number above 0 left of a line, 0 on it, below 0 right of it."""
    return of[0] * p[0] + of[1] * p[1] + of[2] * p[2]


def place(p: Node) -> tuple[Fraction, Fraction]:
    """Return the coordinates of a point."""
    return Fraction(p[0], p[2]), Fraction(p[1], p[2])


def add(p: Node, q: Node) -> Node:
    """Return the sum of two points."""
    return p[0] * q[2] + q[0] * p[2], p[1] * q[2] + q[1] * p[2], p[2] * q[2]


def turn(points: Sequence[Node]) -> Ring:
    """Turn points by half a turn about the origin."""
    return [(-x, -y, w) for x, y, w in points]


def edges(points: Ring) -> list[Edge]:
    """Return the edges of a ring."""
    return list(zip(points, [*points[1:], *points[:1]], strict=True))


def ways(points: Ring) -> list[tuple[int, int]]:
    """Return the directions of the edges of a ring."""
    return [(q[0] * p[2] - p[0] * q[2], q[1] * p[2] - p[1] * q[2]) for p, q in edges(points)]


def double_area(points: Ring) -> Fraction:
    """Return twice the area of a ring, below 0 if it is clockwise."""
    return sum((Fraction(p[0] * q[1] - q[0] * p[1], p[2] * q[2]) for p, q in edges(points)), NONE)


def is_convex(points: Ring) -> bool:
    """Return whether a ring turns left at every vertex, and once around in all."""
    at, count = ways(points), len(points)
    turns = all(at[k - 1][0] * at[k][1] > at[k - 1][1] * at[k][0] for k in range(count))
    # Each time around the ways go down once after they went up.
    down = [y < 0 or (y == 0 and x < 0) for x, y in at]
    return turns and sum(down[k] and not down[k - 1] for k in range(count)) == 1


def lies(p: Node, a: Node, b: Node) -> bool:
    """Return whether a point is on a closed segment."""
    x, (y, z) = place(p), sorted((place(a), place(b)))
    return side(line(a, b), p) == 0 and y <= x <= z


def do_clash(p: Node, q: Node, r: Node, s: Node, apart: int, count: int) -> bool:
    """Return whether two edges of a ring, so many apart, keep it from being simple."""
    if apart in (1, count - 1):  # neighbours: one must not go back along the other
        (a, b), c = ((p, q), s) if q == r else ((r, s), q)
        return lies(c, a, b) or lies(a, b, c)
    one, other = line(p, q), line(r, s)
    crossed = side(one, r) * side(one, s) < 0 and side(other, p) * side(other, q) < 0
    return crossed or lies(p, r, s) or lies(q, r, s) or lies(r, p, q) or lies(s, p, q)


def grid_box(points: Sequence[Node], scale: int) -> Grid:
    """Return the box of points times a scale: left, right, lower, upper end, rounded outwards."""
    xs, ys = ([(p[k] * scale, p[2]) for p in points] for k in (0, 1))
    low, high = ((min(n // w for n, w in at), max(-(-n // w) for n, w in at)) for at in (xs, ys))
    return low + high


def add_boxes(one: Grid, other: Grid) -> Grid:
    """Return the box of the sum of two sets."""
    return one[0] + other[0], one[1] + other[1], one[2] + other[2], one[3] + other[3]


def are_near(one: Grid, other: Grid, reach: int = 0) -> bool:
    """Return whether boxes are no more than a reach apart, in x and in y."""
    in_x = one[0] <= other[1] + reach and other[0] <= one[1] + reach
    return in_x and one[2] <= other[3] + reach and other[2] <= one[3] + reach


def check_simple(points: Ring, work: Work) -> None:
    """Refuse a ring that is not simple."""
    boxed = sorted((grid_box(e, work.scale), k, e) for k, e in enumerate(edges(points)))
    for i, (box, k, one) in enumerate(boxed):
        for against, m, other in boxed[i + 1 :]:
            work.take(1)
            if against[0] > box[1]:
                break
            clash = are_near(box, against) and do_clash(
                *one, *other, (m - k) % len(points), len(points)
            )
            need(not clash, "a ring is not simple")


def loop(item: Any, work: Work) -> Ring:
    """Read a simple ring, counter-clockwise, without straight angles, its least point first."""
    points = ring(item)
    check_simple(points, work)
    bent = all(side(line(p, q), points[k - 1]) for k, (p, q) in enumerate(edges(points)))
    canonical = bent and min(map(place, points)) == place(points[0]) and double_area(points) > 0
    need(canonical, "a loop is not canonical")
    return points


def touching(rings: list[Ring], work: Work) -> list[tuple[Node, list[int]]]:
    """List the points at which rings touch, with these."""
    found, corners = [], {p for points in rings for p in points} if len(rings) > 1 else []
    for p in sorted(corners):
        work.take(sum(map(len, rings)))
        of = [k for k, points in enumerate(rings) if any(lies(p, *e) for e in edges(points))]
        found += [(p, of)] if len(of) > 1 else []
    return found


class Solid(NamedTuple):
    """A shape: its rings, its pieces, and half-planes that belong to it."""

    rings: list[Ring]
    pieces: list[Ring]
    beyond: list[Node]

    def turned(self) -> Solid:
        """Turn it by half a turn about the origin."""
        rings, pieces = ([*map(turn, listed)] for listed in self[:2])
        return Solid(rings, pieces, [])


def solid(rings: list[Ring], item: Any, work: Work, frame: Ring | None = None) -> Solid:
    """Read the pieces of a shape, by (1), or with a frame of all that is outside, by (4)."""
    pieces = [ring(piece) for piece in items(item)]
    need(all(map(is_convex, pieces)), "a piece is not convex")
    target = [frame, *(one[::-1] for one in rings)] if frame else rings
    left: Counter[Edge] = Counter()
    for sign, listed in ((1, pieces), (-1, target)):
        for p, q in chain.from_iterable(map(edges, listed)):
            of = max(line(p, q), line(q, p))
            left[of, p] += sign
            left[of, q] -= sign
    need(not any(left.values()), "the edges of pieces do not cancel to those of their shape")
    parts = list(range(len(rings)))
    for points in rings:
        check_simple(points, work)
    for _, of_rings in touching(rings, work):
        met = [parts[k] for k in of_rings]
        need(len({*met}) == len(met), "the interior of a shape falls apart")
        parts = [met[0] if part in met else part for part in parts]
    return Solid(target[bool(frame) :], pieces, [line(q, p) for p, q in edges(frame or [])])


def add_convex(one: Ring, other: Ring) -> list[Node]:
    """Return the sides of the sum of two convex rings: their edges, by direction."""
    a, b = (
        points[k:] + points[:k]
        for points in (one, other)
        for k in [min(range(len(points)), key=lambda k: place(points[k])[::-1])]
    )
    u, v, i, j, found = ways(a), ways(b), 0, 0, []
    while i < len(a) or j < len(b):
        found.append(add(a[i % len(a)], b[j % len(b)]))
        last = (i == len(a)) - (j == len(b))
        left = -last or u[i][0] * v[j][1] - u[i][1] * v[j][0]
        i, j = i + (left >= 0), j + (left <= 0)
    return [line(*edge) for edge in edges(found)]


def sum_sides(d: Solid, h: Solid, k: int) -> list[Node]:
    """Return the sides of sum k: of pieces of both, in order, or of a half-plane and the second."""
    i, j = divmod(k, len(h.pieces))
    if i < len(d.pieces):
        return add_convex(d.pieces[i], h.pieces[j])
    a, b, c = d.beyond[k - len(d.pieces) * len(h.pieces)]
    at = min(Fraction(a * x + b * y, w) for piece in h.pieces for x, y, w in piece)
    return [(a * at.denominator, b * at.denominator, c * at.denominator - at.numerator)]


def clip(sides: list[Node], a: Node, b: Node) -> Span | None:
    """Return the shares of a segment inside open half-planes, from -1 or to 2 if beyond an end."""
    low, high = ALL
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
        return ALL if lies(a, p, q) else None
    if at_p == at_q == 0:
        k = int(a[0] * b[2] == b[0] * a[2])
        s, t, u = (place(e)[k] - place(a)[k] for e in (p, q, b))
        return min(s / u, t / u), max(s / u, t / u)
    if at_p * at_q > 0 or at_a * at_b > 0 or at_a == at_b:
        return None
    return (Fraction(at_a, at_a - at_b),) * 2


def is_covered(spans: list[Span]) -> bool:
    """Return whether spans cover all from 0 to 1 but for points."""
    reach = NONE
    for low, high in sorted(spans):
        reach = max(reach, high) if low <= reach else reach
    return reach >= 1


def list_contacts(d: Solid, h: Solid, work: Work) -> Iterator[Edge]:
    """List, by (3b), sums of a vertex of one and an edge of the other, and where rings touch."""
    for one, other in ((d.rings, h.rings), (h.rings, d.rings)):
        found = [pair for points in other for pair in zip(edges(points), ways(points), strict=True)]
        for points in one:
            out = ways(points)
            for k, v in enumerate(points):
                (x, y), (z, w) = out[k - 1], out[k]
                work.take(len(found) if x * w >= y * z else 1)
                for (p, q), (s, t) in found if x * w >= y * z else []:
                    if s * w >= t * z and t * x >= s * y:
                        yield add(v, p), add(v, q)
    both = touching(d.rings, work), touching(h.rings, work)
    yield from ((add(p, q), add(p, q)) for p, _ in both[0] for q, _ in both[1])


def list_near(d: Solid, h: Solid, known: list[Edge], work: Work) -> Iterator[list[int]]:
    """List for each edge the sums whose boxes meet its own."""
    ones, others = ([grid_box(e, work.scale) for e in pieces] for pieces in (d.pieces, h.pieces))
    whole, width = grid_box([p for piece in h.pieces for p in piece], work.scale), len(others)
    far = [k + len(ones) * width for k in range(len(d.beyond))]
    for edge in known:
        box = grid_box(edge, work.scale)
        rows = [(i, one) for i, one in enumerate(ones) if are_near(box, add_boxes(one, whole))]
        work.take(len(ones) + len(rows) * width)
        near = [
            i * width + j
            for i, one in rows
            for j, other in enumerate(others)
            if are_near(box, add_boxes(one, other))
        ]
        yield near + far


def prove_positions(
    d: Solid, h: Solid, loops: list[Ring], fits: list[Edge], chains: Any, work: Work
) -> None:
    """Prove by (3) that loops, O on their left, and fits are the boundary of O = D + H."""
    known = [*chain.from_iterable(map(edges, loops)), *fits]
    sides = cache(lambda k: sum_sides(d, h, k))
    along: dict[Node, list[list[tuple[Fraction, Fraction]]]] = {}
    for p, q in known:
        ends = sorted((place(p), place(q)))
        along.setdefault(max(line(p, q), line(q, p)), []).append(ends)
    for found in along.values():
        need(all(e[1] <= f[0] for e, f in pairwise(sorted(found))), "edges overlap")

    for n, near in enumerate(list_near(d, h, known, work)):
        (a, b), on = known[n], line(*known[n])
        spans: tuple[list[Span], list[Span]] = [], []
        for k in near:
            work.take(len(sides(k)))
            touch = next((of for of in sides(k) if side(of, a) <= 0 >= side(of, b)), None)
            if touch is None:
                need(clip(sides(k), a, b) is None, "an edge of a loop or a fit is overlapped")
            elif side(touch, a) == 0 == side(touch, b):
                rest = [of for of in sides(k) if of != touch]
                if a == b and all(side(of, a) >= 0 for of in rest):
                    spans = [ALL], [ALL]
                elif a != b and (span := clip(rest, a, b)):
                    spans[touch[0] * on[0] + touch[1] * on[1] < 0].append(span)
        right = is_covered(spans[1]) if n >= len(known) - len(fits) else not spans[1]
        need(is_covered(spans[0]) and right, "a loop or a fit does not part what it should")
        alone = a != b or not any(lies(a, *e) for k, e in enumerate(known) if k != n)
        need(alone, "a fit of one point is on a loop or another fit")

    contacts = list(list_contacts(d, h, work))
    count = len(d.pieces) * len(h.pieces) + len(d.beyond)
    for (a, b), listed in zip(contacts, items(chains, len(contacts)), strict=True):
        reach, closed = NONE, False
        for n in items(listed):
            work.take(8)
            on_edge = integer(n, -len(known), count) < 0
            low, high = (share(a, b, *known[-1 - n]) if on_edge else clip(sides(n), a, b)) or (1, 0)
            meets = low < reach or (low == reach and (on_edge or closed))
            need(meets and low <= high, "chains: a gap")
            if high > reach or (high == reach and on_edge):
                reach, closed = Fraction(high), on_edge
        need(reach > 1 or (closed and reach == 1), "chains: one does not reach the end")


def count(rings: list[Ring]) -> int:
    """Count vertices."""
    return sum(map(len, rings))


def read_frame(item: Any) -> Ring:
    """Read the left, lower, right and upper end of a rectangle."""
    left, low, right, high = map(number, items(item, 4))
    need(left < right and low < high, "frame: not the ends of a rectangle")
    return [node(left, low), node(right, low), node(right, high), node(left, high)]


def check_kind(kind: Any, d: Ring, g: Ring, direction: list[Any]) -> None:
    """Refuse a wrong kind, or a direction to which the two are not monotone."""
    convex = is_convex(g) + (is_convex(g) and is_convex(d))
    x, y = (number(str(n) if type(n) is int else n) for n in direction)
    need(kind == ("MM", "CM", "CC")[convex], "kind: another one")
    for points in (d, g):
        signs = [s > 0 for s in (x * u + y * v for u, v in ways(points)) if s]
        need(sum(signs[k - 1] != one for k, one in enumerate(signs)) == 2, "direction: not shared")


def winds(points: Ring, p: Node) -> bool:
    """Return whether a ring winds around a point, which is not on it."""
    sides = [
        (place(a)[1] <= place(p)[1], place(b)[1] <= place(p)[1], line(a, b))
        for a, b in edges(points)
    ]
    return sum(up != to and (side(of, p) > 0) == up for up, to, of in sides) % 2 == 1


def prove_no_fit(c: dict[str, Any], work: Work) -> str:
    """Prove a no-fit polygon by (3)."""
    head = "directrix generatrix exterior holes exact_fits proof"
    d, g, exterior, holes, fits, proof = fields(c, head, "format version claim")[:6]
    (first, second, chains), d, g = fields(proof, "directrix generatrix chains"), shape(d), shape(g)
    work.fit(d + g)
    loops = [loop(exterior, work), *(loop(hole, work)[::-1] for hole in items(holes))]
    stationary, moving = solid(d, first, work), solid(g, second, work).turned()
    prove_positions(stationary, moving, loops, read_fits(fits), chains, work)
    answer = f"{count(loops)} in {len(loops)} loops, {len(fits)} exact fits"
    return f"no-fit polygon of {count(g)} around {count(d)} vertices, {answer}"


def prove_inner_fit(c: dict[str, Any], work: Work) -> str:
    """Prove an inner fit by (4)."""
    head = "container part regions exact_fits proof"
    d, g, regions, fits, proof = fields(c, head, "format version claim")[:5]
    frame, first, second, chains = fields(proof, "frame outside part chains")
    d, g, loops = shape(d), shape(g), []
    work.fit(d + g)
    for exterior, holes in (fields(region, "exterior holes") for region in items(regions)):
        around, inside = loop(exterior, work), [loop(hole, work) for hole in items(holes)]
        for one in inside:
            middles = [(x, y, 2 * w) for x, y, w in (add(p, q) for p, q in edges(one))]
            free = [p for p in middles if not any(lies(p, *e) for e in edges(around))]
            need(any(winds(around, p) for p in free), "a hole is not in its region")
        loops += [around[::-1], *inside]
    outside, moving = solid(d, first, work, read_frame(frame)), solid(g, second, work).turned()
    prove_positions(outside, moving, loops, read_fits(fits), chains, work)
    answer = f"{count(loops)} in {len(loops)} loops, {len(fits)} exact fits"
    return f"inner fit of {count(g)} in {count(d)} vertices, {answer}"


def prove_sweep(c: dict[str, Any], work: Work) -> str:
    """Prove a sweep by (5)."""
    head, kind, at = "inner outer area exact_fits proof", c.get("kind"), (0, 0, 1)
    if "claim" in c:
        names = f"directrix generatrix exterior holes unswept {head}"
        d, g, t, holes, unswept, *rest = fields(c, names, "format version claim kind")
        d, g = shape(d), shape(g)
        need(kind == "SS", "kind: not SS")
    else:
        names = f"directrix generatrix trajectory reference direction {head}"
        lists = "contacts inner_drawn outer_drawn"
        d, g, t, reference, direction, *rest = fields(c, names, f"format version kind {lists}")
        d, g, at, holes, unswept = [ring(d)], [ring(g)], turn([point(reference)])[0], [], []
        check_kind(kind, d[0], g[0], items(direction, 2))
    inner, outer, area, fits, proof = rest[:5]
    keys = "frame directrix generatrix trajectory outside slits within chains"
    frame, *cut, slits, within, chains = fields(proof, keys)
    work.fit(d + g)
    t, inner, outer = (loop(e, work) for e in (t, inner, outer))
    t = [node(*place(add(p, at))) for p in t]
    fits = [(add(p, at), add(q, at)) for p, q in read_fits(fits)]
    holes, unswept = ([loop(hole, work)[::-1] for hole in items(e)] for e in (holes, unswept))
    inside = [integer(k, 0, len(unswept)) for k in items(within)]
    between, beside = map(read_fits, items(slits, 2))
    first, second, third = items(chains, 3)
    still, moving = solid(d, cut[0], work), solid(g, cut[1], work)
    prove_positions(still, moving.turned(), [t, *holes], fits, first, work)
    loops = [outer, *(hole for k, hole in enumerate(unswept) if k not in inside)]
    prove_positions(solid([t], cut[2], work), moving, loops, between, second, work)
    loops = [inner[::-1], *(hole for k, hole in enumerate(unswept) if k in inside)]
    prove_positions(solid([t], cut[3], work, read_frame(frame)), moving, loops, beside, third, work)
    p, q, r = still.pieces[0][:3]
    x, y, w = add(add(p, q), r)
    need(winds(inner, (x, y, 3 * w)), "inner: not the loop around the directrix")
    swept = double_area(outer) - double_area(inner) + sum(map(double_area, unswept))
    need(swept == 2 * number(area), "area: not that between the loops")
    answer = f"trajectory {len(t)}, inner {len(inner)}, outer {len(outer)}, area {area}"
    return f"{kind} sweep of {count(g)} around {count(d)} vertices, {answer}"


class Placed(NamedTuple):
    """Pieces where they are, all their points, boxes, and how far off points may be."""

    pieces: list[Ring]
    points: Ring
    boxes: list[Grid]
    box: Grid
    error: Fraction

    def holds(self, k: Any, p: Node, error: Fraction | None) -> bool:
        """Return whether a point is in a piece, or so far inside that an error does not matter."""
        sides = [line(*e) for e in edges(self.pieces[integer(k, 0, len(self.pieces))])]
        found = [(Fraction(side(of, p), p[2]), of[0] ** 2 + of[1] ** 2) for of in sides]
        if error is None:
            return all(h >= 0 for h, _ in found)
        return all(h > 0 and h**2 > error**2 * square for h, square in found)


def move_ring(points: Ring, turn: Span, mirrored: bool, move: Node) -> Ring:
    """Mirror, turn and move a ring; mirrored it would go around the other way."""
    r = lcm(turn[0].denominator, turn[1].denominator)
    c, s = int(turn[0] * r), int(turn[1] * r)
    found = [(-x, y, w) for x, y, w in points[::-1]] if mirrored else points
    return [add((c * x - s * y, s * x + c * y, r * w), move) for x, y, w in found]


def read_turn(item: Any) -> Any:
    """Read a turn: cosine and sine, or degrees where these are irrational."""
    if type(item) is list:
        cosine, sine = place(point(item))
        need(cosine**2 + sine**2 == 1, "a turn of another length than 1")
        return cosine, sine
    degrees = number(item) % 360
    return degrees if degrees % 90 else tuple(map(Fraction, BOX[int(degrees) // 90]))


def turn_error(to: Span, degrees: Fraction) -> Fraction:
    """Bound how far a turn is from one by degrees, by the power series in steps of 1e-110."""
    unit = 10**110
    angle, sums, term, k = int(PI * degrees / 180 * unit), [0, 0, 0, 0], unit, 0
    while term:
        sums[k % 4] += term
        k += 1
        term = term * angle // (unit * k)
    cosine, sine = Fraction(sums[0] - sums[2], unit), Fraction(sums[1] - sums[3], unit)
    return abs(to[0] - cosine) + abs(to[1] - sine) + Fraction(1, 10**95)


def are_apart(one: Ring, other: Ring, way: tuple[int, int], distance: Fraction) -> bool:
    """Return whether a normal shows that points are at a distance from others, to its side."""
    x, y = way
    high = max(Fraction(x * p[0] + y * p[1], p[2]) for p in one)
    gap = min(Fraction(x * p[0] + y * p[1], p[2]) for p in other) - high
    return (x, y) != (0, 0) and gap >= 0 and gap**2 >= distance**2 * (x * x + y * y)


class Layout:
    """A layout as its certificate has it: valid, by (2), or with faults."""

    def __init__(self, c: dict[str, Any], work: Work) -> None:
        head = "layout valid turns frame pieces outside apart faults"
        layout, self.valid, turns, frame, cut, outside, *lists = fields(
            c, head, "format version kind"
        )[:8]
        keys = "container parts placements", "spacing margin"
        container, parts, placements, *gaps = fields(layout, *keys)
        self.spacing, self.margin = (NONE if gap is None else number(gap) for gap in gaps)
        self.work, self.frame, (self.apart, self.faults) = (
            work,
            read_frame(frame),
            map(items, lists),
        )
        need(type(self.valid) is bool, "valid: neither true nor false")
        need(not self.valid or None not in (outside, *items(cut)), "pieces: some are missing")
        need(self.spacing >= 0 <= self.margin, "a spacing or a margin below 0")
        work.fit([self.frame])

        rules = "demand turns mirrored"
        self.parts = [fields(part, "id exterior", f"holes {rules}") for part in items(parts)]
        self.ids = [part[0] for part in self.parts]
        unique = {*map(type, self.ids)} <= {str} and len({*self.ids}) == len(self.ids)
        need(unique, "parts: ids are strings, each of one part")
        self.rings = [shape(part, f"id {rules}") for part in parts]
        both = zip(items(cut, len(parts)), self.rings, strict=True)
        pieces = [[] if e is None else solid(rings, e, work).pieces for e, rings in both]
        self.facts: list[tuple[int, Any, bool]] = []
        self.placed: list[Placed] = []
        for item, rational in zip(items(placements), items(turns, len(placements)), strict=True):
            name, asked, move, mirrored = fields(item, "part turn move", "mirrored")
            need(type(name) is str and name in self.ids, "placements: of no part")
            need(type(mirrored) in (type(None), bool), "mirrored: neither true nor false")
            k, turn, to = self.ids.index(name), read_turn(asked), read_turn(items(rational))
            far = max(sum(map(abs, place(p)), NONE) for points in self.rings[k] for p in points)
            error = NONE if type(turn) is tuple else far * turn_error(to, turn)
            need(error > 0 or turn == to, "turns: not the turn of the placement")
            self.facts.append((k, turn, bool(mirrored)))
            self.put([move_ring(e, to, bool(mirrored), point(move)) for e in pieces[k]], error)
        # All that is outside comes last, for its number is -1.
        within = shape(container)
        self.put([] if outside is None else solid(within, outside, work, self.frame).pieces, NONE)

    def put(self, pieces: list[Ring], error: Fraction) -> None:
        """Put pieces where they are."""
        points = list(chain.from_iterable(pieces)) or [(0, 0, 1)]
        boxes = [grid_box(piece, self.work.scale) for piece in pieces]
        self.placed.append(Placed(pieces, points, boxes, grid_box(points, self.work.scale), error))

    def prove(self) -> str:
        """Prove what is claimed, and say what that is."""
        found = f"layout of {len(self.facts)} placements of {len(self.ids)} parts"
        if not self.valid:
            need(self.faults != [] == self.apart, "faults: none, or normals beside them")
            for fault in self.faults:
                self.prove_fault(fault)
            return f"{found}, not valid: {len(self.faults)} faults"
        need(self.faults == [], "faults: of a valid layout")
        for k in range(len(self.ids)):
            broken = [kind for kind, holds in self.check_rules(k).items() if holds]
            need(broken == [], f"a part breaks rules: {broken}")
        self.prove_apart()
        return f"{found}, valid, spacing {self.spacing}, margin {self.margin}"

    def check_rules(self, k: int) -> dict[str, bool]:
        """Return which rules the placements of part k break."""
        demand, turns, mirrored = self.parts[k][3:]
        need(type(mirrored) in (type(None), bool), "mirrored: neither true nor false")
        found = [fact for fact in self.facts if fact[0] == k]
        allowed = None if turns is None else [read_turn(turn) for turn in items(turns)]
        asked = len(found) if demand is None else integer(demand, 0, 10**9)
        return {
            "missing": len(found) < asked,
            "surplus": len(found) > asked,
            "turn": allowed is not None and any(turn not in allowed for _, turn, _ in found),
            "mirror": mirrored is False and any(flag for _, _, flag in found),
        }

    def prove_apart(self) -> None:
        """Prove that parts are inside the frame, and apart from each other and the container."""
        normals = {
            tuple(integer(k, -1, 10**9) for k in items(e, 6)[:4]): point(e[4:])[:2]
            for e in self.apart
        }
        need(len(normals) == len(self.apart), "apart: a pair is there twice")
        for one, p, way in (
            (e, *pair) for e in self.placed[:-1] for pair in zip(self.frame, BOX, strict=True)
        ):
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
        self.work.take(len(one.points) + len(other.points))
        if (a, -1, b, -1) in normals:
            whole = are_apart(one.points, other.points, normals[a, -1, b, -1], distance)
            need(whole, f"{a} and {b}: no normal that parts them")
            return
        near = [(j, box) for j, box in enumerate(other.boxes) if are_near(box, one.box, reach)]
        for i, piece in enumerate(one.pieces):
            for j in [j for j, box in near if are_near(box, one.boxes[i], reach)]:
                self.work.take(len(piece) + len(other.pieces[j]))
                ways = [normals[a, i, b, j]] if (a, i, b, j) in normals else BOX
                apart = any(are_apart(piece, other.pieces[j], way, distance) for way in ways)
                need(apart, f"piece {i} of {a} and piece {j} of {b}: no normal that parts them")

    def prove_fault(self, fault: Any) -> None:
        """Prove one fault by its witness."""
        kind = fault.get("kind") if type(fault) is dict else None
        if kind in ("overlap", "outside", "too close"):
            self.prove_near(kind, *fields(fault, "kind placements pieces points")[1:])
            return
        name, both = fields(fault, "kind part", "edges")[1:]
        need(type(name) is str and name in self.ids, "faults: of no part")
        k = self.ids.index(name)
        if kind != "shape":
            need(self.check_rules(k).get(str(kind), False), f"faults: {kind}")
            return
        (m, i), (n, j) = ([integer(e, 0, 10**9) for e in items(edge, 2)] for edge in items(both, 2))
        rings = [edges(ring(e)) for e in (self.parts[k][1], *(self.parts[k][2] or []))]
        need(m < len(rings) > n and i < len(rings[m]) and j < len(rings[n]), "edges: not there")
        (p, q), (r, s), size = rings[m][i], rings[n][j], len(rings[m])
        one, other = line(p, q), line(r, s)
        crossed = side(one, r) * side(one, s) < 0 and side(other, p) * side(other, q) < 0
        clash = crossed if m != n else i != j and do_clash(p, q, r, s, (j - i) % size, size)
        need(clash, "faults: the edges do not clash")

    def prove_near(self, kind: str, of: Any, numbers: Any, points: Any) -> None:
        """Prove that a point is inside two shapes, or that points of them are too close."""
        a, *others = [integer(n, 0, len(self.facts)) for n in items(of)]
        need(len(others) < 2 and a not in others, "faults: not of one placement or of two")
        need(kind == "too close" or (kind == "overlap") == bool(others), f"faults: {kind} of what")
        one, other = self.placed[a], self.placed[(others or [-1])[0]]
        (i, j), (p, q) = items(numbers, 2), (point(end) for end in items(points, 2))
        room = (self.spacing if others else self.margin) - one.error - other.error
        square = sum((c - d) ** 2 for c, d in zip(place(p), place(q), strict=True))
        if kind == "too close":
            near = (
                room > 0 and square < room**2 and one.holds(i, p, None) and other.holds(j, q, None)
            )
        else:
            near = p == q and one.holds(i, p, one.error) and other.holds(j, q, other.error)
        need(near, f"faults: the points do not show {kind}")


def outline(points: Ring) -> Ring:
    """Return a ring as loops are written, without straight angles."""
    around = points if double_area(points) > 0 else points[::-1]
    size = len(around)
    bent = [p for k, p in enumerate(around) if side(line(around[k - 1], p), around[(k + 1) % size])]
    least = bent.index(min(bent, key=place)) if bent else 0
    return bent[least:] + bent[:least]


def check_given(certificate: Any, key: str, rings: list[Ring]) -> None:
    """Refuse a certificate that is about another shape than the one given."""
    need(key in certificate, f"{key}: there is none in the certificate")
    item = certificate[key]
    listed = [ring(item)] if type(item) is list else shape(item)
    (one, *holes), (other, *others) = ([*map(outline, found)] for found in (listed, rings))
    same = one == other and sorted(holes) == sorted(others)
    need(same, f"{key}: not the polygon that is given")


def read_given(text: str) -> list[Ring]:
    """Read a shape or a ring from JSON, its numbers exactly as they are written."""
    need(not re.search("[eE][-+]?0*[1-9][0-9]{4}", text), "a number with too large an exponent")
    item = json.loads(text, parse_float=str, parse_int=str, parse_constant=str)
    rings = [item] if type(item) is list else [item["exterior"], *item.get("holes", [])]
    return [[node(*map(Fraction, items(p, 2))) for p in points] for points in rings]


def prove(certificate: Any, max_steps: int = MAX_STEPS) -> str:
    """Prove a certificate, as `json.loads` gives it, and say what is proved.

    Raises:
        Refused: it is not proved; the first reason.
    """
    work = Work(max_steps)
    need(type(certificate) is dict, "a certificate is an object")
    kind, claim, version = (certificate.get(key) for key in ("kind", "claim", "version"))
    need(certificate.get("format") == FORMAT, f"format: not {FORMAT!r}")
    need(type(max_steps) is int, "max_steps: not an int")
    need(type(version) is int and version == VERSION, f"version: not {VERSION}")
    if kind == "layout":
        return Layout(certificate, work).prove()
    provers = {"no_fit": prove_no_fit, "inner_fit": prove_inner_fit, "sweep": prove_sweep}
    need(claim in provers if type(claim) is str else "claim" not in certificate, "claim: unknown")
    return provers[claim or "sweep"](certificate, work)


def load(text: str) -> Any:
    """Read JSON in which no object has one key twice."""

    def once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        need(len(dict(pairs)) == len(pairs), "a key is there twice")
        return dict(pairs)

    return json.loads(text, object_pairs_hook=once)


def main(arguments: list[str]) -> int:
    """Print what a certificate proves, of the shapes G and D if given; return the exit code."""
    try:
        text, *given = (Path(name).read_text(encoding="utf-8") for name in arguments)
        certificate = load(text)
        proved = prove(certificate)
        keys = ("part", "container") if "part" in certificate else ("generatrix", "directrix")
        for key, shape_text in zip(keys, given, strict=False):
            check_given(certificate, key, read_given(shape_text))
        print(f"proved: {proved}")
    except (Refused, ValueError, TypeError, KeyError, RecursionError) as error:
        print(f"not proved: {error}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
