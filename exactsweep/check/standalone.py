"""Checker of certificates, version 3: one readable file that needs only the standard library.

`python standalone.py FILE` prints "proved: ..." or "not proved: ..."; CERTIFICATES.md defines the
format. A point (x, y, w) of integers, w > 0, is (x/w, y/w); it is left of a line (a, b, c) if
a x + b y + c w > 0.

1. Shapes. The winding number of rings at z counts the edges strictly right of z, upward ones as 1,
   downward ones as -1; an edge contains its lower end, but not its upper one. It is the same at
   z + (d, d^2) for all small d > 0. A shape is the set of points of winding number 1. So two shapes
   have a common point if and only if they overlap: their interiors have one.
2. Pieces, convex and counter-clockwise, make up a shape if on every line, at every point, starts
   minus ends of edges are equal for pieces and rings (`cancel`), and any two pieces lie on opposite
   sides of a line (`apart`). Then the edges of pieces and of rings right of any z have the same
   count, so the winding number at z is the number of pieces that contain z, at most one.
3. The lemma. Let O be a union of open convex polygons, the sums; U the union of the listed ones; L
   the edges of closed loops, O on their left, and fits, which are segments or points; W the winding
   number of all loops. Suppose (`boundary`) that
   (a) no sum has a point of L;
   (b) the sides of listed sums, with their ends, are in U or L;
   (c) sides of listed sums run along the left of each edge of a loop and along both sides of each
       fit, with their sums on that side; a fit of one point is on a side of a listed sum;
   (d) W is 1 at one point of every sum;
   (e) two edges or fits have at most one common point.
   Then O = U, L is the boundary of O, and off L, W is 1 on O and 0 elsewhere.
   Proof. By (a), W is constant on each sum, so by (d) it is 1 on O. Let t be in neither U nor L,
   whose union is closed by (b). Perturb t so that the horizontal ray to its right avoids ends and
   crossings. If the ray misses L, W is 0 at t. Else let y be its first point of L, on e. Before y
   the ray misses U: the first limit point of U on it would be on a side, so in U or L by (b), but
   is in neither. So e is not a fit and does not go up: by (c), a sum would be on its left. So e
   goes down, W is 1 just behind it by (c), and 0 at t. As W is 1 on O, O is in U or L, by (a) in
   U. Points of L are limits of O by (c), not in O by (a); all other limits of U are in U.
4. `no_fit`: by 1 and 2, D and G + t overlap if and only if t is in a sum, the interior of D_i +
   H_j, for pieces D_i of D and H_j of H = -G. If D_1 and D_2 have a common vertex p, D_1 + H_j and
   D_2 + H_j have p + int H_j in common, so (d) is checked once for pieces connected by vertices.
   `sweep`: along T, G covers, up to closure, the sums of edges of T and pieces of G; those of one
   piece are connected. Slits are fits outside the answer. `sum`: the same for any path.
5. `inner_fit`: D is a frame minus the container, B the rectangle of all t at which G + t is in the
   frame. L is in B; the half-planes around B count as listed sums, with an edge of B as their side.
   In the proof, read W + 1 for W; every ray meets a half-plane, and so L before it. Two loops of a
   region meet at most once: they do not cross. Its own W is 0 just inside a hole, at two points of
   an edge; each other loop misses one of them. So a hole is in the exterior and in no other hole.
6. `layout`: a rounded piece is the set of points within distance r of a convex hull; r = 0 for the
   pieces of 2. For vertices a and b of two pieces, a normal n with gap = min n.b - max n.a >= 0 and
   gap^2 >= (s + r_a + r_b)^2 |n|^2 proves that they are s apart and do not overlap. Errors add to
   s; a rotation with error d displaces a point at distance r from the origin by at most d r. The
   container, as a frame minus the container, and defects are shapes like parts; in a rounded
   container, depth is concave, so vertices decide. A point deeper in two bodies than their errors
   proves that they overlap; a point within (s - errors) / 2 of both, that they are too close.
"""

from __future__ import annotations

import json
import re
import sys
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from decimal import Context, Decimal
from fractions import Fraction
from functools import lru_cache, reduce
from itertools import accumulate, chain, pairwise, product
from math import gcd, lcm
from pathlib import Path
from typing import Any, NamedTuple

FORMAT, VERSION, HEAD = "exactsweep certificate", 3, "format version claim"
MAX_DIGITS, MAX_STEPS, STEPS_PER_BYTE = 10**5, 10**7, 100
NUMBER = re.compile("-?(0|[1-9][0-9]*)(/[1-9][0-9]*)?")
DEFAULTS: Any = {"holes": [], "defects": [], "turn": "0", "radius": "0", "error": "0"}
FORM, RULES = "exterior holes pieces error", "demand turns mirrored mirrored_turns"
AXES, NOWHERE = ((1, 0), (0, 1), (-1, 0), (0, -1)), ((0, 0, 0, 0), -1, 0)
PI = "3.1415926535897932384626433832795028841971693993751058209749445923078164062862089986280348"

Rational = int | Fraction
Point = tuple[int, int, int]
Ring = list[Point]
Edge = tuple[Point, Point, Point]
Span = tuple[Rational, bool, Rational]


# --- Reading --------------------------------------------------------------------------------------


class Refused(Exception):  # noqa: N818
    """The first reason why a certificate is not proved, with a point if available."""

    def __init__(self, reason: str, *points: Point) -> None:
        self.witness = place(points[0]) if points else None
        for *p, w in points[:1]:
            reason += ", at ({:.12g}, {:.12g})".format(*(Context(traps=[]).divide(n, w) for n in p))
        super().__init__(reason)


def need(condition: Any, reason: str, *points: Point) -> None:
    """Refuse the certificate unless a condition holds."""
    if not condition:
        raise Refused(reason, *points)


class Work:
    """The remaining steps; a step takes a microsecond, and long numbers cost several."""

    def __init__(self, certificate: Any, max_steps: float | None) -> None:
        try:
            text = json.dumps(certificate)
        except (TypeError, ValueError, RecursionError) as error:
            raise Refused(f"not JSON: {error}") from None
        self.left, self.price = max_steps or max(MAX_STEPS, STEPS_PER_BYTE * len(text)), 1.0
        self.measure([10 ** max(map(len, re.findall("[0-9]+", text)), default=0)])

    def measure(self, numbers: Iterable[int]) -> None:
        """Raise the cost of steps for the longest number, as measured."""
        bits = max(0, max(map(int.bit_length, numbers)) - 60)
        self.price = max(self.price, 1 + bits / 40 + bits**2 / 10**6)

    def spend(self, steps: float) -> None:
        """Subtract steps."""
        self.left -= steps * self.price
        need(self.left >= 0, "too large: exceeds the step limit for its size")


def fields(name: str, item: Any, names: str, optional: str = "") -> list[Any]:
    """Return the values of an object; missing or null optional values become defaults or None."""
    known = f"{names} {optional}".split()
    right = type(item) is dict and item.keys() <= {*known}
    right = right and all(item.get(key) is not None for key in names.split())
    need(right, f"{name}: not an object with keys {names}{optional and '; optional '}{optional}")
    return [DEFAULTS.get(key) if item.get(key) is None else item[key] for key in known]


def items(name: str, item: Any, size: int | None = None) -> list[Any]:
    """Require a list, optionally of a given size."""
    right = type(item) is list and size in (None, len(item))
    need(right, f"{name}: not a list{'' if size is None else f' of {size} entries'}")
    return list(item)


def integer(name: str, item: Any, low: int, end: int) -> int:
    """Require an integer in a range."""
    need(type(item) is int and low <= item < end, f"{name}: not an integer from {low} to {end - 1}")
    return int(item)


def number(name: str, item: Any, is_signed: bool = True) -> Rational:
    """Read a rational in lowest terms."""
    right = type(item) is str and len(item) <= MAX_DIGITS and NUMBER.fullmatch(item)
    need(right and item != "-0", f"{name}: not a number in a string, such as -3 or 5/7")
    n, m = (int(Decimal(part)) for part in f"{item}/1".split("/")[:2])  # int takes 4,300 digits
    need("/" not in item or gcd(n, m) == 1 < m, f"{name}: not in lowest terms")
    need(is_signed or n >= 0, f"{name}: below 0")
    return n if m == 1 else Fraction(n, m)


def node(x: Rational, y: Rational) -> Point:
    """Return the point with the given coordinates."""
    w = lcm(x.denominator, y.denominator)
    return int(x * w), int(y * w), w


def read_points(name: str, item: Any, size: int | None = None) -> Ring:
    """Read a list of points."""
    return [node(*(number(name, n) for n in items(name, p, 2))) for p in items(name, item, size)]


def ring(name: str, item: Any) -> Ring:
    """Read a ring; consecutive equal points count once."""
    points = read_points(name, item)
    points = [p for k, p in enumerate(points) if p != points[k - 1]]
    need(len(points) > 2, f"{name}: a ring of fewer than three points")
    return points


def shape(name: str, item: Any) -> list[Ring]:
    """Read the rings of a shape, the exterior counter-clockwise, holes clockwise."""
    exterior, holes = fields(name, item, "exterior", "holes")
    listed = [exterior, *items(f"{name}, holes", holes)]
    rings = [ring(f"{name}, ring {k}", entry) for k, entry in enumerate(listed)]
    return [e[::-1] if (area(edges(e)) > 0) == bool(k) else e for k, e in enumerate(rings)]


def rectangle(name: str, ends: list[Rational]) -> Ring:
    """Return the corners of a rectangle, starting at the lower left."""
    left, low, right, high = ends
    need(left < right and low < high, f"{name}: not left, bottom, right, top of a rectangle")
    return [node(left, low), node(right, low), node(right, high), node(left, high)]


# --- Points, lines and boxes ----------------------------------------------------------------------


def edges(points: Sequence[Point]) -> list[Edge]:
    """Return the edges of a ring, each with its line."""
    found, ends = list[Edge](), zip(points, [*points[1:], *points[:1]], strict=True)
    for (x, y, w), (u, v, z) in ends:
        found.append(((x, y, w), (u, v, z), (y * z - v * w, u * w - x * z, x * v - u * y)))
    return found


def side(line: Point, p: Point) -> int:
    """Return a number whose sign is 1 left of a line, 0 on it, -1 right of it."""
    return line[0] * p[0] + line[1] * p[1] + line[2] * p[2]


def place(p: Point) -> tuple[Fraction, Fraction]:
    """Return the coordinates of a point."""
    return Fraction(p[0], p[2]), Fraction(p[1], p[2])


def add(p: Point, q: Point) -> Point:
    """Return the sum of two points."""
    return p[0] * q[2] + q[0] * p[2], p[1] * q[2] + q[1] * p[2], p[2] * q[2]


def level(points: Ring, work: Work) -> Ring:
    """Bring points to a common denominator."""
    unit = lcm(*(w for *_, w in points))
    found = [(x * (unit // w), y * (unit // w), unit) for x, y, w in points]
    work.measure(chain(*found))
    return found


def reflect(pieces: list[Ring]) -> list[Ring]:
    """Reflect pieces in the origin."""
    return [[(-x, -y, w) for x, y, w in piece] for piece in pieces]


def area(around: Iterable[Edge]) -> Fraction:
    """Return the signed area within edges."""
    terms = [(line[2], 2 * p[2] * q[2]) for p, q, line in around]
    unit = lcm(*(w for _, w in terms))
    return Fraction(sum(n * (unit // w) for n, w in terms), unit)


def winding(around: Iterable[Edge], z: Point) -> int:
    """Return the winding number: upward minus downward edges strictly right of a point."""
    found = 0
    for p, q, line in around:
        up = (p[1] * z[2] <= z[1] * p[2]) - (q[1] * z[2] <= z[1] * q[2])
        found += up if up and up * side(line, z) > 0 else 0
    return found


def scale_of(points: Iterable[Point]) -> int:
    """Return the number of units of boxes per unit of length."""
    xs, ys = zip(*([*map(place, points)] or [(Fraction(0),) * 2]), strict=True)
    return int(2**30 / (max(max(xs) - min(xs), max(ys) - min(ys)) or 1)) + 1


def box(points: Sequence[Point], scale: int, reach: Rational = 0) -> tuple[int, ...]:
    """Return left, -right, bottom, -top of a box, in units, rounded down so that it only grows."""
    at = ((x * scale, y * scale, w) for x, y, w in points)
    ends = zip(*((x // w, -x // w, y // w, -y // w) for x, y, w in at), strict=True)
    return tuple(min(end) - -(-reach * scale // 1) for end in ends)


def tree(boxes: list[tuple[Any, Any]]) -> Any:
    """Build a tree of boxes with items: (box, size, two subtrees or an item)."""
    if len(boxes) < 2:
        return (boxes[0][0], -1, boxes[0][1]) if boxes else None
    around, half = tuple(map(min, zip(*(e for e, _ in boxes), strict=True))), len(boxes) // 2
    k = 0 if sum(around[:2]) < sum(around[2:]) else 2
    boxes = sorted(boxes, key=lambda entry: entry[0][k] - entry[0][k + 1])
    return around, -sum(around), (tree(boxes[:half]), tree(boxes[half:]))


def index(lists: Iterable[Sequence[Point]], scale: int) -> Any:
    """Build a tree of the boxes of lists of points, with their numbers as items."""
    return tree([(box(points, scale), k) for k, points in enumerate(lists)])


def near(work: Work, a: Any, b: Any, c: Any = NOWHERE, touch: int = 0) -> Iterator[Any]:
    """Yield items whose boxes have a sum around the origin, or with `touch`, through it."""
    stack = [(a, b, c)] if a and b and c else []
    while stack:
        found = a, b, c = stack.pop()
        work.spend(2)
        at = 0 if a[1] >= b[1] and a[1] >= c[1] else 1 if b[1] >= c[1] else 2
        if found[at][1] < 0:
            yield a[2], b[2], c[2]
            continue
        before, after = found[:at], found[at + 1 :]
        (h, i, j, k), (p, q, r, s) = (others[0] for others in before + after)
        for half in found[at][2]:
            d, e, f, g = half[0]
            if d + h + p < touch and e + i + q < touch and f + j + r < touch and g + k + s < touch:
                stack.append((*before, half, *after))


# --- Shapes and pieces ----------------------------------------------------------------------------


def is_convex(points: Ring) -> bool:
    """Decide whether a ring turns left at every vertex, and once in total."""
    normals = [line[:2] for *_, line in edges(points)]
    pairs = list(zip([normals[-1], *normals[:-1]], normals, strict=True))
    turns_left = all(a * d > b * c for (a, b), (c, d) in pairs)
    return turns_left and sum(one > (0, 0) > other for one, other in pairs) == 1


def canonical(line: Point) -> Point:
    """Return a line in lowest terms, regardless of its direction."""
    a, b, c = line
    d = gcd(a, b, c) * (1 if (a, b) > (0, 0) else -1) or 1
    return a // d, b // d, c // d


def cancel(name: str, pieces: list[Ring], rings: list[Ring]) -> None:
    """Require that starts minus ends of edges agree for pieces and rings on every line."""
    left = Counter[tuple[Point, Point]]()
    for p, q, line in chain(*map(edges, pieces + [points[::-1] for points in rings])):
        left.update({(canonical(line), p): 1, (canonical(line), q): -1})
    wrong = [p for (_, p), times in left.items() if times][:1]
    need(not wrong, f"{name}: edges of the pieces do not cancel to its rings", *wrong)


def apart(one: list[Edge], other: list[Edge]) -> bool:
    """Decide whether an edge of one of two pieces has no point of the other on its left."""
    lines = [(line, b) for a, b in ((one, other), (other, one)) for *_, line in a]
    return any(all(side(line, p) <= 0 for p, *_ in b) for line, b in lines)


def solid(name: str, rings: list[Ring], item: Any, work: Work) -> list[Ring]:
    """Read the pieces that make up a shape."""
    pieces = [ring(f"{name}, piece {k}", entry) for k, entry in enumerate(items(name, item))]
    for k, points in enumerate(pieces):
        need(is_convex(points), f"{name}, piece {k}: not convex, counter-clockwise", points[0])
    cancel(name, pieces, rings)
    around, scale = [*map(edges, pieces)], scale_of(chain(*rings))
    for k, j, _ in near(work, index(pieces, scale), index(reflect(pieces), scale)):
        work.spend(len(pieces[k]) * len(pieces[j]))
        is_apart = k >= j or apart(around[k], around[j])
        need(is_apart, f"{name}: pieces {k} and {j} are not apart", pieces[k][0])
    return pieces


def inner_point(piece: Ring) -> Point:
    """Return a point inside a piece or a segment: the mean of at most three vertices."""
    x, y, w = reduce(add, piece[:3])
    return x, y, w * len(piece[:3])


def groups(pieces: list[Ring], work: Work) -> list[Point]:
    """Return a point inside a piece of each group connected by common vertices."""
    found = list[set[Point]]()
    for piece in pieces:
        met = [group for group in found if not group.isdisjoint(piece)] or [set[Point]()]
        work.spend(len(found) / 2 + sum(map(len, met[1:])) / 10)
        met[0].update(piece, *met[1:])
        found = [group for group in found if group not in met] + met[:1]
    return [inner_point(next(e for e in pieces if e[0] in group)) for group in found]


# --- Sums and the lemma ---------------------------------------------------------------------------


class Known(NamedTuple):
    """A known edge: of a loop, perhaps of a region of an inner fit, or a fit, without a loop."""

    start: Point
    end: Point
    line: Point
    loop: str
    name: str
    region: str = ""


def loop(name: str, item: Any, step: int = 1, region: str = "") -> list[Known]:
    """Read a counter-clockwise loop; reverse it if the step is -1."""
    points = read_points(name, item)
    around = edges(points[::step])
    is_loop = len({*points}) == len(points) and area(around) * step > 0
    need(is_loop, f"{name}: a repeated point, or not counter-clockwise", *points[:1])
    return [Known(*e, name, f"{name}, edge {k}", region) for k, e in enumerate(around)]


def loops(name: str, item: Any) -> list[Known]:
    """Read a list of loops and reverse them."""
    return [*chain(*(loop(f"{name}[{k}]", e, -1) for k, e in enumerate(items(name, item))))]


def fits(name: str, item: Any) -> list[Known]:
    """Read a list of fits; a single point gets a horizontal line."""
    found = list[Known]()
    for k, fit in enumerate(items(name, item)):
        p, q, line = edges(read_points(name, fit, 2))[0]
        found.append(Known(p, q, (0, p[2], -p[1]) if p == q else line, "", f"{name}[{k}]"))
    return found


class Sums:
    """The interiors of D_i + H_j, numbered i n + j for n pieces H_j, followed by half-planes."""

    def __init__(self, name: str, d: list[Ring], h: list[Ring], work: Work, beyond: Any = ()):
        self.work, self.count, self.columns, self.beyond = work, len(d) * len(h), len(h), beyond
        self.name, self.scale = name, scale_of(chain(*d, *h))
        self.pieces, self.trees = (d, h), (index(d, self.scale), index(h, self.scale))
        self.d, self.h = ([from_lowest(e, work) for e in of] for of in (d, h))
        self.get = lru_cache(10**5 // max(map(len, chain(d, h, [()]))) + 1)(self.find)

    def find(self, k: int) -> list[Edge]:
        """Return the sides of a sum or a half-plane; `get` caches them."""
        if k >= self.count:
            return [self.beyond[k - self.count]]
        one, other = self.d[k // self.columns], self.h[k % self.columns]
        self.work.spend(3 * (len(one) + len(other)))
        return add_pieces(one, other)

    def clip(self, k: int, edge: Sequence[Any]) -> Span | None:
        """Return the interval of an edge that is in a sum or a half-plane."""
        sides = self.get(k)
        self.work.spend(4 + len(sides))
        return clip(sides, edge[0], edge[1])


def from_lowest(piece: Ring, work: Work) -> list[Edge]:
    """Return the edges of a piece, starting at its leftmost lowest vertex."""
    points = level(piece, work)
    work.spend(len(points))
    k = points.index(min(points, key=lambda p: (p[1], p[0])))
    return edges(points[k:] + points[:k])


def add_pieces(one: list[Edge], other: list[Edge]) -> list[Edge]:
    """Merge the edges of two pieces, starting at their lowest points, by direction."""
    i, j, found, lines = 0, 0, list[Point](), list[Point]()
    while i < len(one) or j < len(other):
        (p, _, (a, b, _)), (q, _, (c, d, _)) = one[i % len(one)], other[j % len(other)]
        x, y, w = add(p, q)
        found.append((x, y, w))
        turn = (j == len(other)) - (i == len(one)) or a * d - b * c
        i, j = i + (turn >= 0), j + (turn <= 0)
        a, b = (a, b) if turn >= 0 else (c, d)
        lines.append((a * w, b * w, -a * x - b * y))
    return [*zip(found, found[1:] + found[:1], lines, strict=True)]


def clip(sides: Iterable[Any], a: Point, b: Point, closed: bool = False) -> Span | None:
    """Return the interval of parameters, 0 at a and 1 at b, left of all sides, or None.

    An open interval that contains 0 or 1 extends to -1 or 2; a closed one does not.
    """
    (x, y, w), (u, v, z), least = a, b, 1 - closed
    if w != z:
        x, y, w, u, v = x * z, y * z, w * z, u * w, v * w
    low, high = ((0, 1), (1, 1)) if closed else ((-1, 1), (2, 1))
    for _, _, (k, m, n) in sides:
        at_a, at_b = k * x + m * y + n * w, k * u + m * v + n * w
        if at_a < least:
            if at_b < least:
                return None
            if -at_a * low[1] > low[0] * (at_b - at_a):
                low = -at_a, at_b - at_a
        elif at_b < least and at_a * high[1] < high[0] * (at_a - at_b):
            high = at_a, at_a - at_b
    start, end = (n if m == 1 else Fraction(n, m) for n, m in (low, high))
    return (start, not closed, end) if start < end + closed and start <= end else None


def clip_on(edge: Sequence[Any], a: Point, b: Point) -> Span | None:
    """Return the closed interval of a segment that is on an edge, which may be a point, or None."""
    (x, y, w), (u, v, z), (k, m, n) = edge[:3]
    ends = (m * w, -k * w, k * y - m * x), (-m * z, k * z, m * u - k * v)
    return clip([(a, b, line) for line in ((k, m, n), (-k, -m, -n), *ends)], a, b, closed=True)


def covers(spans: Iterable[Span | None]) -> bool:
    """Decide whether open and closed intervals cover all parameters from 0 to 1."""
    reach: tuple[Rational, bool] = (0, False)
    for low, is_open, high in sorted(filter(None, spans)):
        if low < reach[0] or (low == reach[0] and (reach[1] or not is_open)):
            reach = max(reach, (high, not is_open))
    return reach >= (1, True)


def boundary(sums: Sums, known: list[Known], listed: Any, wanted: int = 1, *around: Any) -> None:
    """Prove (a) to (e) of the lemma."""
    work, ends = sums.work, [[e.start, e.end] for e in known]
    at, meetings = index(reflect(ends), sums.scale), dict[Any, Any]()
    for k, j, _ in near(work, at, index(ends, sums.scale), touch=1):
        one, other = known[k], known[j]
        span = k < j and clip_on(other, one.start, one.end)
        is_point = one.start == one.end or other.start == other.end
        is_end = one.loop != other.loop or one.end == other.start or one.start == other.end
        is_distinct = not span or (span[0] == span[2] and not is_point and (is_end or not one.loop))
        work.spend(12)
        if span and one.region and one.region == other.region and one.loop != other.loop:
            (x, y), (u, v) = place(one.start), place(one.end)
            x, y = x + span[0] * (u - x), y + span[0] * (v - y)
            is_distinct &= meetings.setdefault((one.loop, other.loop), (x, y)) == (x, y)
        need(is_distinct, f"{one.name}: meets {other.name}", one.start)
    for k, i, j in near(work, at, *sums.trees):
        is_clear, edge = sums.clip(i * sums.columns + j, known[k]) is None, known[k]
        need(is_clear, f"{edge.name}: inside the sum of pieces {i} and {j}", edge.start)
    cover_sides(sums, known, items(sums.name, listed), around)
    d, h = sums.pieces
    inner = [*map(inner_point, h)] if d and len(d[0]) == 2 else groups(h, work)
    wind(sums.name, known, (add(p, q) for p in groups(d, work) for q in inner), wanted, work)


def cover_sides(sums: Sums, known: list[Known], listed: list[Any], around: Iterable[Any]) -> None:
    """Prove (b) and (c)."""
    name, along = sums.name, defaultdict[Any, list[Span | None]](list)
    for n, entry in enumerate(listed):
        integer(f"{name}[{n}]", [*items(f"{name}[{n}]", entry), None][0], 0, sums.count)
    entries = listed + [[sums.count + n, found] for n, found in enumerate(around)]
    for n, (k, *chains) in enumerate(entries):
        at, sides = f"{name}[{n}]", sums.get(k)
        for one, found in zip(sides, items(at, chains, len(sides)), strict=True):
            spans = list[Span | None]()
            for m in [found] if type(found) is int else items(at, found):
                if integer(at, m, -len(known), len(entries)) >= 0:
                    spans.append(sums.clip(entries[m][0], one))
                    continue
                edge, (x, y, _) = known[-1 - m], one[2]
                sums.work.spend(20)
                spans.append(clip_on(edge, *one[:2]))
                is_point, (a, b, _) = edge.start == edge.end, edge.line
                if is_point or a * y == b * x:
                    left = is_point or a * x + b * y > 0
                    along[-1 - m, left].append(clip_on(one, edge.start, edge.end))
            need(covers(spans), f"{at}: a side of it is not covered", one[0])
    for n, edge in enumerate(known):
        for left in (True,) if edge.loop or edge.start == edge.end else (True, False):
            reason = f"{edge.name}: {name} are not along all of its {'left' if left else 'right'}"
            need(covers(along[n, left]), reason, edge.start)


def wind(name: str, known: list[Known], points: Iterable[Point], wanted: int, work: Work) -> None:
    """Require that loops have the wanted winding number at points."""
    around = [edge[:3] for edge in known if edge.loop]
    for z in points:
        work.spend(len(around) / 2)
        times = winding(around, z)
        need(times == wanted, f"{name}: winding number {times}, expected {wanted}", z)


# --- Positions ------------------------------------------------------------------------------------


def no_fit(c: Any, work: Work) -> str:
    """Prove a no-fit polygon, and the swept area of a sweep."""
    more, lists = ("inner outer unswept area", "swept slits") if c["claim"] == "sweep" else ("", "")
    names = f"directrix generatrix exterior holes exact_fits proof {more} {HEAD}"
    first, second, exterior, holes, exact, proof, *answer = fields("certificate", c, names)
    cut, others, listed, *swept = fields("proof", proof, f"directrix generatrix sums {lists}")
    d = solid("directrix", shape("directrix", first), cut, work)
    g = solid("generatrix", shape("generatrix", second), others, work)
    t = loop("exterior", exterior)
    known = [*t, *loops("holes", holes), *fits("exact_fits", exact)]
    boundary(Sums("sums", d, reflect(g), work), known, listed)
    found = f"no-fit polygon of {len(known)} edges and exact fits"
    if swept:
        walked, segments = loop("inner", answer[0], -1), [[e.start, e.end] for e in t]
        known = [*loop("outer", answer[1]), *walked, *loops("unswept", answer[2])]
        boundary(Sums("swept", segments, g, work), known + fits("slits", swept[1]), swept[0])
        wind("inner, at the directrix", walked, [inner_point(d[0])], -1, work)
        need(number("area", answer[3]) == area(e[:3] for e in known), "area: differs")
        found = f"sweep of {len(known)} edges; {found}"
    return found


def path_sum(c: Any, work: Work) -> str:
    """Prove the sum of a shape and a path."""
    names = f"shape path exterior holes proof {HEAD}"
    given, path, exterior, holes, proof = fields("certificate", c, names)[:5]
    cut, listed, slits = fields("proof", proof, "shape sums slits")
    h = solid("shape", shape("shape", given), cut, work)
    d = [[p, q] for p, q in pairwise(read_points("path", path)) if p != q]
    known = [*loop("exterior", exterior), *loops("holes", holes), *fits("slits", slits)]
    boundary(Sums("sums", d, h, work), known, listed)
    return f"sum of a shape and a path of {len(d)} segments: {len(known)} edges and slits"


def inner_fit(c: Any, work: Work) -> str:
    """Prove an inner fit."""
    names = f"container part regions exact_fits proof {HEAD}"
    first, second, regions, exact, proof = fields("certificate", c, names)[:5]
    ends, cut, others, listed, around = fields("proof", proof, "frame outside part sums around")
    sides, known = [number("frame", n) for n in items("frame", ends, 4)], list[Known]()
    rings = [rectangle("frame", sides), *(e[::-1] for e in shape("container", first))]
    d = solid("outside", rings, cut, work)
    h = reflect(solid("part", shape("part", second), others, work))
    need(h, "proof: no pieces of the part")
    for k, region in enumerate(items("regions", regions)):
        known += read_region(f"regions[{k}]", region, work)
    known += fits("exact_fits", exact)
    xs, ys = zip(*map(place, chain(*h)), strict=True)
    ends = [sides[0] + max(xs), sides[1] + max(ys), sides[2] + min(xs), sides[3] + min(ys)]
    within = edges(rectangle("frame, for the part", ends))
    beyond = [(q, p, (-a, -b, -c)) for p, q, (a, b, c) in within]
    for edge, (*_, line) in product(known, within):
        is_within = side(line, edge.start) >= 0 <= side(line, edge.end)
        need(is_within, f"{edge.name}: the part leaves the frame", edge.start)
    boundary(Sums("sums", d, h, work, beyond), known, listed, 0, *items("around", around, 4))
    return f"inner fit of {len(known)} edges and exact fits in {len(regions)} regions"


def read_region(name: str, item: Any, work: Work) -> list[Known]:
    """Read a region, its interior on the right; require that its holes are in its exterior."""
    exterior, holes = fields(name, item, "exterior holes")
    inner = [loop(f"{name}, hole {k}", e, 1, name) for k, e in enumerate(items(name, holes))]
    own = [*loop(f"{name}, exterior", exterior, -1, name), *chain(*inner)]
    for hole in inner:  # a point on a downward edge counts as inside
        p, q = next(e[:2] for e in hole if e.line[0] > 0)
        wind(hole[0].loop, own, map(inner_point, ([p, q], [p, p, q])), 0, work)
    return own


# --- Layouts --------------------------------------------------------------------------------------


class Body(NamedTuple):
    """A part or an obstacle, its error, its distance from parts, its winding number inside.

    A solid is a piece, one ring with a radius (negative for a complement), or all rings of a shape.
    """

    name: str
    solids: list[tuple[list[Ring], Rational]]
    error: Rational
    distance: Rational
    inside: int

    def points(self) -> Ring:
        """Return the points of all rings."""
        return [*chain(*(chain(*rings) for rings, _ in self.solids))]


def read_rotation(name: str, item: Any) -> Any:
    """Read a rotation: cosine and sine, or degrees if these are irrational."""
    if type(item) is list:
        found = place(read_points(name, [item])[0])
        need(sum(n * n for n in found) == 1, f"{name}: cosine and sine not on the unit circle")
        return found
    degrees = number(name, item) % 360
    return degrees if degrees % 90 else AXES[int(degrees) // 90]


def rotation_error(to: Any, degrees: Rational) -> Rational:
    """Bound |cos - cos'| + |sin - sin'| for a rotation and an angle by the power series."""
    unit, sums, term, k = 10**110, [0, 0, 0, 0], 10**110, 0
    angle = int(Fraction(PI) * degrees / 180 * unit)
    while term:
        sums[k % 4], k, term = sums[k % 4] + term, k + 1, term * angle // (unit * (k + 1))
    cosine, sine = Fraction(sums[0] - sums[2], unit), Fraction(sums[1] - sums[3], unit)
    return abs(Fraction(to[0]) - cosine) + abs(Fraction(to[1]) - sine) + Fraction(1, 10**88)


def move(points: Ring, to: Any, mirrored: bool, by: Point) -> Ring:
    """Mirror, rotate and move a ring."""
    (u, v, z), (c, s, r), found = by, node(*to), list[Point]()
    for x, y, w in ((x * (-1) ** mirrored, y, w * r) for x, y, w in points):
        found.append(((c * x - s * y) * z + u * w, (s * x + c * y) * z + v * w, w * z))
    return found[::-1] if mirrored else found


def gap(work: Work, one: Ring, other: Ring, normal: Sequence[int], distance: Rational) -> bool:
    """Decide whether a normal proves that two pieces are a distance apart."""
    (x, y), w, v, (n, m) = normal, one[0][2], other[0][2], distance.as_integer_ratio()
    work.spend(7 + len(one) + len(other))
    found = min(x * s + y * t for s, t, _ in other) * w - max(x * s + y * t for s, t, _ in one) * v
    is_far = found >= 0 and (found * m) ** 2 >= (n * w * v) ** 2 * (x * x + y * y)
    return is_far and (x, y) != (0, 0)


def outline(around: Sequence[Edge]) -> list[Any]:
    """Cancel opposite edges; return the remaining segments, or all edges if none remain."""
    sides, found = defaultdict[Any, Counter[Any]](Counter), list[Any]()
    for p, q, line in around:
        sides[canonical(line)].update({place(p): 1, place(q): -1})
    for at in sides.values():
        times = accumulate(at[p] for p in sorted(at))
        found += [e for e, n in zip(pairwise(sorted(at)), times, strict=False) if n]
    return found or [(place(p), place(q)) for p, q, _ in around]


def is_inside(work: Work, body: Body, p: Point, depth: Rational) -> bool:
    """Decide whether a point is deeper in a body than a depth, which may be negative."""
    found, (x, y) = False, place(p)
    for rings, radius in body.solids:
        around, squared, more = [*chain(*map(edges, rings))], list[Rational](), depth - radius
        work.spend(60 * len(around))
        for (a, b), (c, d) in outline(around):
            u, v, along = c - a, d - b, (c - a) * (x - a) + (d - b) * (y - b)
            at = min(along / (u * u + v * v), Fraction(1)) if along > 0 else 0
            squared.append((a + at * u - x) ** 2 + (b + at * v - y) ** 2)
        limit = more**2 if more > 0 else -(more**2)
        found |= (1 if winding(around, p) == body.inside else -1) * min(squared) > limit
    return found


class Layout:
    """A layout and its evidence: parts by id, with their rules and the rotations used; and bodies.

    Bodies are placements, followed by obstacles in reverse order: -1 is the container.
    """

    def __init__(self, c: Any, work: Work) -> None:
        names = f"layout turns valid {HEAD}"
        given, turns, valid, *_, proof, faults = fields("certificate", c, names, "proof faults")
        is_known = [valid is True, valid is False] == [proof is not None, faults is not None]
        need(is_known, "valid: neither true with a proof nor false with faults")
        more = "container defects spacing margin"
        parts, placed, container, defects, *gaps = fields("layout", given, "parts placements", more)
        self.work, self.valid, self.faults = work, valid, faults
        gaps = ["0" if n is None else n for n in gaps]
        self.spacing, margin = (number("spacing, margin", n, False) for n in gaps)
        solids = [{"pieces": []} if container is None else container, *items("defects", defects)]
        cut, outside, ends = [None] * len(items("parts", parts)), [None] * len(solids), None
        if valid:
            names = "outside pieces apart"
            outside, cut, self.normals, ends = fields("proof", proof, names, "frame")
        sides = [number("frame", n) for n in items("frame", ends, 4)] if ends is not None else []
        self.frame = [rectangle("frame", sides)] if sides else []
        self.parts = dict[str, tuple[Body, list[Any], list[Any]]]()
        for k, own in enumerate(items("pieces", cut, len(parts))):
            name = f"parts[{k}]"
            key, *rules = fields(name, parts[k], "id", f"{RULES} {FORM}")
            need(type(key) is str and key not in self.parts, f"{name}: id missing or not unique")
            self.parts[key] = self.read_body(name, rules[4:], own, self.spacing), rules[:4], []
        self.bodies, self.count = list[Body](), len(items("placements", placed))
        for k, to in enumerate(items("turns", turns, self.count)):
            self.bodies.append(self.read_placement(f"placements[{k}]", placed[k], to))
        for k, own in reversed([*enumerate(items("outside", outside, len(solids)))]):
            name, more = (f"defects[{k - 1}]", f"{FORM} spacing") if k else ("container", FORM)
            *form, distance = [*fields(name, solids[k], "", more), None][:5]
            far = margin if distance is None else number(f"{name}, spacing", distance, False)
            self.bodies.append(self.read_body(name, form, own, far))

    def read_body(self, name: str, form: list[Any], cut: Any, distance: Rational) -> Body:
        """Read a shape or rounded pieces, or the complement of a container."""
        exterior, holes, given, error = form
        is_outside, found = name == "container", list[tuple[list[Ring], Rational]]()
        if given is None:
            rings = shape(name, {"exterior": exterior, "holes": holes})
            if is_outside:
                need(self.frame or not self.valid, "frame: none")
                rings = self.frame + [points[::-1] for points in rings]
            found = [(rings, 0)]
            if self.valid:
                found = [([level(e, self.work)], 0) for e in solid(name, rings, cut, self.work)]
        else:
            is_one = not is_outside or (len(items(name, given)) < 2 and not self.frame)
            is_alone = is_one and cut is exterior is None and holes == []
            need(is_alone, f"{name}: not rounded pieces alone")
            for k, item in enumerate(items(name, given)):
                at = f"{name}, piece {k}"
                points, radius = fields(at, item, "points", "radius")
                piece = read_points(at, points)
                is_piece = is_convex(piece) if len(piece) > 2 else piece
                need(is_piece, f"{at}: not convex, counter-clockwise")
                length = number(f"{at}, radius", radius, False)
                found.append(([level(piece, self.work)], -length if is_outside else length))
        need(found or is_outside, f"{name}: no pieces")
        return Body(name, found, number(f"{name}, error", error, False), distance, 1 - is_outside)

    def read_placement(self, name: str, item: Any, rational: Any) -> Body:
        """Read a placement; return its placed part."""
        key, by, turn, flag = fields(name, item, "part move", "turn mirrored")
        need(type(key) is str and key in self.parts, f"{name}: unknown part")
        need(flag is None or type(flag) is bool, f"{name}, mirrored: neither true nor false")
        asked, to = read_rotation(name, turn), read_rotation(name, items(name, rational))
        body, _, used = self.parts[key]
        error, points, by = body.error, body.points(), read_points(name, [by])[0]
        self.work.spend(20 + 20 * len(points))
        if asked != to:
            need(type(asked) is not tuple, f"{name}: its entry in turns is a different rotation")
            error += max(sum(map(abs, place(p))) for p in points) * rotation_error(to, asked)
        used.append((asked, flag is True))
        moved = [([move(e, to, flag is True, by) for e in rings], r) for rings, r in body.solids]
        return Body(f"{name} of {key[:40]!a}", moved, error, self.spacing, 1)

    def find_broken(self) -> Iterator[tuple[str, str]]:
        """Yield the violated rules, each with the id of a part."""
        for key, (_, (demand, turns, may, mirrored), used) in self.parts.items():
            name, others = f"part {key[:40]!a}", turns if mirrored is None else mirrored
            need(may is None or type(may) is bool, f"{name}, mirrored: neither true nor false")
            asked = len(used) if demand is None else integer(f"{name}, demand", demand, 0, 10**9)
            yield from [("missing", key)] * (len(used) < asked)
            yield from [("surplus", key)] * (len(used) > asked)
            yield from [("mirror", key)] * (may is False and any(flag for _, flag in used))
            for listed, at in ((turns, False), (others, True)):
                own = {turn for turn, flag in used if flag is at and listed is not None}
                given = [] if listed is None else items(f"{name}, turns", listed)
                allowed = {read_rotation(name, e) for e in given}
                yield from [("turn", key)] * (not own <= allowed)

    def prove_valid(self) -> None:
        """Prove that placements are in the container, and apart from each other and obstacles."""
        normals, boxes, least = dict[Any, Any](), list[Any](), self.count - len(self.bodies)
        work, beyond = self.work, self.bodies[-1]
        reach = max(e.distance for e in self.bodies) / Fraction(2)
        for n, entry in enumerate(items("apart", self.normals)):
            at, (*given, x, y) = f"apart[{n}]", items(f"apart[{n}]", entry, 6)
            key = tuple(integer(at, k, least, 10**9) for k in given)
            need(key not in normals, f"{at}: duplicate normal for these pieces")
            normals[key] = read_points(at, [[x, y]])[0][:2]
        for one in self.bodies[: self.count]:
            for (points,), radius in one.solids:
                room = beyond.distance + one.error + beyond.error + radius
                sides = zip(*self.frame, AXES, strict=True) if self.frame else ()
                is_out = not all(gap(work, [p], points, way, room) for p, way in sides)
                is_out |= any(is_inside(work, beyond, p, -room) for p in points if not self.frame)
                need(not is_out, f"{one.name}: not in the container", points[0])
        scale = scale_of(p for one in self.bodies[: self.count] for p in one.points())
        for a, one in ((a, self.bodies[a]) for a in range(least, self.count)):
            for i, ((points,), radius) in enumerate(one.solids if a != -1 or self.frame else ()):
                boxes.append((box(points, scale, reach + one.error + radius), (a, i)))
                work.spend(10)
        mirrored = [((q, p, s, r), item) for (p, q, r, s), item in boxes]
        for (a, i), (b, j), _ in near(work, tree(boxes), tree(mirrored)):
            if a < b and b >= 0:
                one, other = self.bodies[a], self.bodies[b]
                ((points,), r), ((others,), s) = one.solids[i], other.solids[j]
                far = r + s + one.error + other.error + one.distance
                known = normals.get((a, i, b, j)) or normals.get((a, -1, b, -1)) or AXES[0]
                is_apart = any(gap(work, points, others, n, far) for n in (known, *AXES))
                reason = f"{one.name}, piece {i}: not apart from {other.name}, piece {j}"
                need(is_apart, reason, others[0])

    def prove_fault(self, name: str, fault: Any, broken: set[tuple[str, str]]) -> Any:
        """Prove a fault; return its part or its bodies."""
        kind, key, on, at = fields(name, fault, "kind", "part placements point")
        points, least = read_points(name, [] if at is None else [at]), self.count - len(self.bodies)
        is_one = type(kind) is str and (on is None) != (key is None) and None not in fault.values()
        need(is_one, f"{name}: needs either part or placements")
        if on is None:
            need(type(key) is str and key in self.parts, f"{name}: unknown part")
            is_broken, body = (kind, key) in broken, self.parts[key][0]
            if points:
                self.work.spend(4 * len(body.points()))
                found = [winding(chain(*map(edges, e)), points[0]) for e, _ in body.solids]
                is_broken = kind == "shape" and not {*found} <= {0, 1}
            need(is_broken, f"{name}: the part has no such fault", *points)
            return kind, key
        a, b = (integer(name, k, least, self.count) for k in items(name, on, 2))
        is_close, one, other = kind == "too close", self.bodies[a], self.bodies[b]
        is_kind = is_close or kind == ("outside" if b < 0 else "overlap")
        need(is_kind and a >= 0 and a != b and points, f"{name}: not {kind} of two bodies")
        room = other.distance - one.error - other.error
        need(room > 0 or not is_close, f"{name}: the errors leave no room", *points)
        for body in (one, other):
            depth = -room / Fraction(2) if is_close else body.error
            is_there = is_inside(self.work, body, points[0], depth)
            need(is_there, f"{name}: not inside {body.name}, or not near enough", *points)
        return frozenset((a, b))


def layout(c: Any, work: Work) -> str:
    """Prove that a layout is valid or has faults."""
    found = Layout(c, work)
    broken, name = {*found.find_broken()}, f"layout of {found.count} placements"
    if found.valid:
        need(not broken, f"valid, but rules are violated: {sorted(broken)[:3]!a}")
        found.prove_valid()
        return f"{name}, valid"
    faults = items("faults", found.faults)
    proved = {found.prove_fault(f"faults[{k}]", fault, broken) for k, fault in enumerate(faults)}
    need(len(proved) == len(faults) > 0, "faults: empty or duplicate")
    return f"{name}, not valid: {len(faults)} faults"


# --- Questions ------------------------------------------------------------------------------------


PROVERS = {"no_fit": no_fit, "sweep": no_fit, "sum": path_sum}
PROVERS |= {"inner_fit": inner_fit, "layout": layout}


def prove(certificate: Any, max_steps: float | None = None) -> str:
    """Prove a certificate that `load` returns and describe it, or raise Refused."""
    need(type(certificate) is dict, "not an object")
    form, version, claim = (certificate.get(key) for key in HEAD.split())
    need(type(form) is str and form == FORMAT, f"format: not {FORMAT!r}")
    need(type(version) is int and version == VERSION, f"version: not {VERSION}")
    need(type(claim) is str and claim in PROVERS, f"claim: none of {', '.join(PROVERS)}")
    return PROVERS[claim](certificate, Work({**certificate, "area": None}, max_steps))


def load(text: str) -> Any:
    """Read JSON without duplicate keys."""

    def once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        need(len(dict(pairs)) == len(pairs), "duplicate key")
        return dict(pairs)

    return json.loads(text, object_pairs_hook=once)


def main(arguments: list[str]) -> int:
    """Print what a certificate proves; return the exit code."""
    try:
        print(f"proved: {prove(load(Path(*arguments).read_text(encoding='utf-8-sig')))}")
    except Exception as error:  # a crash proves nothing
        print(f"not proved: {error}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
