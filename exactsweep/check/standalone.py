"""Checker of certificates, version 3: one file that needs the standard library alone, to be read.

`python standalone.py FILE` prints "proved: ..." or "not proved: ..."; the exit code is 0 or 1. The
page CERTIFICATES.md defines what is read. Points are homogeneous: integers (x, y, w), w > 0, are
(x/w, y/w). A point is left of a line (a, b, c) if a x + b y + c w > 0. Sections 1 to 3 prove the
claims on positions, 4 to 6; layouts, 7, need only 1 and 2.

1. Shapes. The winding number of rings at a point z is the number of edges strictly right of z, upward
   ones as +1, downward ones as -1; an edge owns its lower end, but not its upper one. The number at
   z is also that at z + (d, d^2) for all small d > 0. A shape is the set in which the winding number
   of its rings is 1; so two shapes have a common point if and only if their interiors have one.
2. Pieces are convex and counter-clockwise. They make up a shape if (`cancel`) on every line, at every
   point, as many of their edges start less end as edges of the rings: then the numbers of edges right
   of z agree, and the winding numbers of the pieces, their indicators, add up to that of the rings;
   and if (`apart`) any two of them are on two sides of a line: then that sum is 0 or 1. So every
   point of the shape is in exactly one piece. That is all we need: rings may even cross themselves.
3. The lemma. O is the union of open convex polygons, the sums. L is the union of edges of closed loops
   and of fits, which are segments or points. U is the union of some of the sums, which are listed. W
   is the winding number of all loops together. Suppose (`boundary`) that
   (a) no sum has a point of L;
   (b) every side of a listed sum, with its ends, is contained in the union of U and L;
   (c) every edge of a loop has listed sums along its left side, but for single points, and every fit
       has them along both sides; a fit that is a point is on the boundary of a listed sum;
   (d) W is 1 at one point of each sum;
   (e) two edges of L have at most a point in common.
   Then O = U; off L, W is 1 on O and 0 elsewhere; and L is the boundary of O.
   Proof. By (a), W is constant on each sum, so by (d) it is 1 on O. Let t be neither in U nor on L.
   Both are closed to small moves: by (b) the boundary of U is on L, so all points near t are in
   neither. Move t a little, so that no end of a segment is level with t, and no two segments meet
   where its level line does. Look right from t. If there is nothing of L, W is 0 at t. Else let y be
   the first point of L, on the edge e. No point before y is in U: the leftmost point of a sum there
   would be on one of its sides, hence by (b) in U or on L, farther left. If e is a fit or an upward
   edge, by (c) a listed sum is along its left side, that from which we look: impossible. So e goes
   down, and just behind y there is a listed sum, by (c), where W is 1. So W is 0 before y, and at t.
   Hence no point off U and L is in O, where W is 1, and no point of L by (a): O = U. Points of L are
   limits of O by (c), and are not in O; all other limits of U are in U, by (b).
4. `no_fit`. D and G + t overlap if and only if t is in the interior of D_i + H_j for a piece D_i of D
   and one H_j of H = -G: by 1 and 2 they overlap if and only if two pieces do. These are the sums.
   For (d) one point is enough for pieces D_i connected by common vertices, and H_j likewise: if D_1
   and D_2 have p in common, D_1 + H_j and D_2 + H_j have p + the interior of H_j, so W is the same.
5. `sweep`. T is the exterior of the no-fit polygon. The points that G covers on its way along T are the
   closure of the sums of an edge of T and a piece of G, and 3 serves again. T + the interior of G_j is
   connected: (d) takes one point for each G_j. The fits are slits, segments between two sums whose
   pieces have a cut parallel to an edge of T; they are no part of the answer.
6. `inner_fit`. D is the frame, a rectangle, without the container, and B the rectangle of all t at which
   G + t is in the frame. The open half-planes around B count as listed sums, with the edges of B for
   sides, and L is in B. Loops are walked so that W is 0 on O, -1 elsewhere: use W + 1 in the proof,
   in which t now sees a half-plane at least, and therefore a point of L before it.
7. `layout`. A piece is the set of points no farther than a radius r from a convex polygon, r = 0 for
   those of 2. Two pieces are at distance s or more, and do not overlap, if there is a normal n with
   gap = min n.b - max n.a >= 0 and gap^2 >= (s + r_a + r_b)^2 |n|^2 over their vertices a and b. If
   shapes are known up to errors e_a and e_b, add these to s. The complement of the container in a
   frame, and every defect, are shapes, too. A rotation by an irrational angle is written as a rational
   one; if that is off by d, it moves a point at distance r from the origin by no more than d r, which
   is an error. Faults of a layout are proved by points: one that is in two shapes, deeper than their
   errors; two that are too near; or one around which rings wind neither 0 times nor once.
"""

from __future__ import annotations

import json
import re
import sys
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from decimal import Decimal
from fractions import Fraction
from functools import lru_cache
from itertools import chain, product
from math import gcd, inf, lcm
from pathlib import Path
from typing import Any, NamedTuple

FORMAT, VERSION, HEAD = "exactsweep certificate", 3, "format version claim"
MAX_DIGITS, MAX_ITEMS, MAX_STEPS, STEPS_PER_BYTE = 10**5, 2 * 10**7, 5 * 10**7, 500
NUMBER = re.compile("-?(0|[1-9][0-9]*)(/[1-9][0-9]*)?")
ORIGIN, AXES = ((0, 0, 0, 0), -1, 0), ((1, 0), (0, 1), (-1, 0), (0, -1))
DIGITS_OF_PI = (
    "3141592653589793238462643383279502884197169399375105"
    "820974944592307816406286208998628034825342117067"
)

Rational = int | Fraction
Point = Line = tuple[int, int, int]
Ring = list[Point]
Edge = tuple[Point, Point, Line]
Span = tuple[Fraction, Fraction]
Box = tuple[int, ...]


# --- Reading --------------------------------------------------------------------------------------


class Refused(Exception):  # noqa: N818
    """The first reason why a certificate is not proved, and a point to see it by, if there is one."""

    def __init__(self, reason: str, *points: Point) -> None:
        super().__init__(f"{reason}{', at ' * bool(points)}{' to '.join(map(describe, points))}")
        self.witness = place(points[0]) if points else None


def need(condition: Any, reason: str, *points: Point) -> None:
    """Refuse the certificate unless a condition holds."""
    if not condition:
        raise Refused(reason, *points)


class Work:
    """The steps that are left, of at most a microsecond with short numbers, more with long ones."""

    def __init__(self, certificate: Any, max_steps: float | None) -> None:
        stack, count, size, longest = [certificate], 0, 0, 1
        while stack:
            item = stack.pop()
            stack += item.values() if type(item) is dict else item if type(item) is list else ()
            length = len(item) if type(item) is str else 0
            count, size, longest = count + 1, size + length + 4, max(longest, length)
            need(count + len(stack) <= MAX_ITEMS, "too large: more entries than can be read")
        self.weight = 1 + longest / 20 + longest**2 / 8000
        self.left = max_steps or max(MAX_STEPS, STEPS_PER_BYTE * size)
        self.spend(count)

    def spend(self, steps: float) -> None:
        """Take steps from those that are left."""
        self.left -= steps * self.weight
        need(self.left >= 0, "too large: to check it takes more steps than a file of its size may")


def fields(name: str, item: Any, names: str, optional: str = "") -> list[Any]:
    """Take an object apart by its keys; optional ones that are left out come as None."""
    required, known = {*names.split()}, [*names.split(), *optional.split()]
    need(
        type(item) is dict and required <= item.keys() <= {*known},
        f"{name}: not an object of {names}{', perhaps ' * bool(optional)}{optional}",
    )
    return [item.get(key) for key in known]


def items(name: str, item: Any, least: int = 0, most: float = inf) -> list[Any]:
    """Require a list with a length in a range."""
    need(
        type(item) is list and least <= len(item) <= most,
        f"{name}: not a list of {least} to {most} entries",
    )
    return item  # type: ignore[no-any-return]


def integer(name: str, item: Any, low: int, end: int) -> int:
    """Require an integer in a range."""
    need(type(item) is int and low <= item < end, f"{name}: not an integer from {low} to {end - 1}")
    return item  # type: ignore[no-any-return]


def boolean(name: str, item: Any) -> bool:
    """Require true or false; null is false."""
    need(item is None or type(item) is bool, f"{name}: neither true nor false")
    return bool(item)


def number(name: str, item: Any, least: float = -inf) -> Rational:
    """Read a rational in lowest terms."""
    right = type(item) is str and len(item) <= MAX_DIGITS and NUMBER.fullmatch(item)
    need(right and item != "-0", f"{name}: not a number in a string, such as -3 or 5/7")
    n, m = (int(Decimal(part)) for part in f"{item}/1".split("/")[:2])  # int stops at 4,300 digits
    need("/" not in item or (m > 1 and gcd(n, m) == 1), f"{name}: not in lowest terms")
    need(n >= least * m, f"{name}: below {least}")
    return n if m == 1 else Fraction(n, m)


def point(name: str, item: Any) -> Point:
    """Read a point."""
    x, y = (number(name, n) for n in items(name, item, 2, 2))
    w = lcm(x.denominator, y.denominator)
    return int(x * w), int(y * w), w


def ring(name: str, item: Any) -> Ring:
    """Read a ring; a point that repeats the one before it counts once."""
    points = [point(name, entry) for entry in items(name, item)]
    points = [p for k, p in enumerate(points) if p != points[k - 1]]
    need(len(points) > 2, f"{name}: a ring of fewer than three points")
    return points


def shape(name: str, item: Any, optional: str = "") -> list[Ring]:
    """Read the rings of a shape, the exterior counter-clockwise, holes clockwise."""
    exterior, holes = fields(name, item, "exterior", f"holes {optional}")[:2]
    listed = [exterior, *items(f"{name}, holes", [] if holes is None else holes)]
    rings = [
        ring(f"{name}, {f'hole {k - 1}' if k else 'exterior'}", e) for k, e in enumerate(listed)
    ]
    return [e[::-1] if (area(edges(e)) > 0) == bool(k) else e for k, e in enumerate(rings)]


def rectangle(name: str, left: Rational, low: Rational, right: Rational, high: Rational) -> Ring:
    """Return a rectangle, from its lower left corner on."""
    need(left < right and low < high, f"{name}: not left, bottom, right, top of a rectangle")
    w = lcm(*(n.denominator for n in (left, low, right, high)))
    a, b, c, d = (int(n * w) for n in (left, low, right, high))
    return [reduce(x, y, w) for x, y in ((a, b), (c, b), (c, d), (a, d))]


def read_frame(item: Any) -> Ring:
    """Read the frame."""
    return rectangle("frame", *(number("frame", n) for n in items("frame", item, 4, 4)))


# --- Points, lines and boxes ----------------------------------------------------------------------


def reduce(a: int, b: int, c: int) -> Line:
    """Return a line, or a point, in lowest terms."""
    d = gcd(c, a, b) or 1
    return (a, b, c) if d == 1 else (a // d, b // d, c // d)


def edges(points: Sequence[Point]) -> list[Edge]:
    """Return the edges of a ring, each with its line."""
    return [
        (
            p,
            q,
            reduce(p[1] * q[2] - q[1] * p[2], q[0] * p[2] - p[0] * q[2], p[0] * q[1] - q[0] * p[1]),
        )
        for p, q in zip(points, [*points[1:], *points[:1]], strict=True)
    ]


def side(line: Line, p: Point) -> int:
    """Return a number above 0 left of a line, 0 on it, below 0 right of it."""
    return line[0] * p[0] + line[1] * p[1] + line[2] * p[2]


def place(p: Point) -> tuple[Fraction, Fraction]:
    """Return the coordinates of a point."""
    return Fraction(p[0], p[2]), Fraction(p[1], p[2])


def describe(p: Point) -> str:
    """Write a point in decimals."""
    x, y, w = p
    return f"({x / w:.12g}, {y / w:.12g})" if max(abs(x), abs(y), w) < 10**300 else "a far point"


def add(p: Point, q: Point) -> Point:
    """Return the sum of two points."""
    (x, y, w), (u, v, z) = p, q
    return (x + u, y + v, 1) if w == z == 1 else reduce(x * z + u * w, y * z + v * w, w * z)


def reflect(points: Ring) -> Ring:
    """Reflect points in the origin."""
    return [(-x, -y, w) for x, y, w in points]


def area(around: Iterable[Edge]) -> Fraction:
    """Return the area that edges enclose, clockwise rings counted as negative."""
    terms = [(p[0] * q[1] - q[0] * p[1], 2 * p[2] * q[2]) for p, q, _ in around]
    unit = lcm(*(w for _, w in terms))
    return Fraction(sum(n * (unit // w) for n, w in terms), unit)


def winding(around: Iterable[Edge], z: Point) -> int:
    """Return how often edges of rings wind around a point: upward ones right of it less downward."""
    found = 0
    for p, q, line in around:
        starts_low, ends_low = p[1] * z[2] <= z[1] * p[2], q[1] * z[2] <= z[1] * q[2]
        if starts_low != ends_low:
            at = side(line, z)
            found += (starts_low and at > 0) - (ends_low and at < 0)
    return found


def scale_of(rings: Iterable[Ring]) -> int:
    """Choose the unit of boxes: so many are 1."""
    xs, ys = zip(*(place(p) for points in rings for p in points), (Fraction(0),) * 2, strict=False)
    return int(2**30 / (max(max(xs) - min(xs), max(ys) - min(ys)) or 1)) + 1


def box(points: Sequence[Point], scale: int, reach: Rational = 0) -> Box:
    """Return left, right, lower and upper end of a box around points, in units, rounded outwards."""
    more, at = -(-reach * scale // 1), [(x * scale, y * scale, w) for x, y, w in points]
    left, low = min(x // w for x, _, w in at), min(y // w for _, y, w in at)
    right, high = min(-x // w for x, _, w in at), min(-y // w for _, y, w in at)
    return left - more, more - right, low - more, more - high


def tree(boxes: list[tuple[Box, Any]]) -> Any:
    """Halve a list of boxes, with items, again and again: into (box, size, two trees or an item)."""
    if len(boxes) < 2:
        return (boxes[0][0], -1, boxes[0][1]) if boxes else None
    lefts, rights, lows, highs = zip(*(found for found, _ in boxes), strict=True)
    around = min(lefts), max(rights), min(lows), max(highs)
    wide, high = around[1] - around[0], around[3] - around[2]
    boxes = sorted(boxes, key=lambda entry: sum(entry[0][:2] if wide > high else entry[0][2:]))
    half = len(boxes) // 2
    return around, wide + high, (tree(boxes[:half]), tree(boxes[half:]))


def near(work: Work, *trees: Any, touching: int = 0) -> Iterator[tuple[Any, Any, Any]]:
    """List items of three trees where the first box overlaps the sum of the others, or touches it."""
    stack = [trees] if all(trees) else []
    while stack:
        found = ((left, right, low, high), m, _), ((a, b, c, d), n, _), ((e, f, g, h), o, _) = (
            stack.pop()
        )
        work.spend(1)
        if a + e < right + touching and left < b + f + touching:
            if c + g < high + touching and low < d + h + touching:
                k = 0 if m >= n and m >= o else 1 if n >= o else 2
                if found[k][1] < 0:
                    yield found[0][2], found[1][2], found[2][2]
                else:
                    stack += [(*found[:k], half, *found[k + 1 :]) for half in found[k][2]]


# --- Shapes and pieces ----------------------------------------------------------------------------


def is_convex(points: Ring) -> bool:
    """Return whether a ring turns left at every vertex, and goes once around."""
    normals = [line[:2] for *_, line in edges(points)]
    pairs = list(zip([normals[-1], *normals], normals, strict=False))
    turns_left = all(a * d > b * c for (a, b), (c, d) in pairs)
    # Of directions in order, those below the axis end once each time around.
    is_low = [
        (n < 0 or (n == 0 and m < 0), n_ < 0 or (n_ == 0 and m_ < 0)) for (m, n), (m_, n_) in pairs
    ]
    return turns_left and sum(before and not after for before, after in is_low) == 1


def cancel(name: str, pieces: list[Ring], rings: list[Ring]) -> None:
    """Require that edges of pieces and rings have the same starts less ends on every line."""
    left = Counter[tuple[Line, Point]]()
    for sign, listed in ((1, pieces), (-1, rings)):
        for p, q, (a, b, c) in chain.from_iterable(map(edges, listed)):
            line = max((a, b, c), (-a, -b, -c))
            left[line, p] += sign
            left[line, q] -= sign
    wrong = [p for (_, p), times in left.items() if times]
    need(not wrong, f"{name}: edges of pieces do not cancel to those of its rings", *wrong[:1])


def apart(one: list[Edge], other: list[Edge]) -> bool:
    """Return whether the line of an edge of one of two pieces has the other on its right."""
    lines = [(line, b) for a, b in ((one, other), (other, one)) for *_, line in a]
    return any(all(side(line, p) <= 0 for p, *_ in b) for line, b in lines)


def solid(name: str, rings: list[Ring], item: Any, work: Work) -> list[Ring]:
    """Read the pieces that make up a shape."""
    pieces = [ring(f"{name}, piece {k}", e) for k, e in enumerate(items(name, item))]
    for k, points in enumerate(pieces):
        need(
            is_convex(points), f"{name}, piece {k}: not convex, or not counter-clockwise", points[0]
        )
    cancel(name, pieces, rings)
    around, scale = [*map(edges, pieces)], scale_of(rings)
    boxes = tree([(box(points, scale), k) for k, points in enumerate(pieces)])
    for k, j, _ in near(work, boxes, boxes, ORIGIN):
        work.spend(len(pieces[k]) * len(pieces[j]) / 4)
        is_apart = k >= j or apart(around[k], around[j])
        need(is_apart, f"{name}: pieces {k} and {j} are not apart", pieces[k][0], pieces[j][0])
    return pieces


def inner_point(piece: Ring) -> Point:
    """Return a point inside a piece."""
    x, y, w = add(add(piece[0], piece[1]), piece[2])
    return reduce(x, y, 3 * w)


def groups(pieces: list[Ring]) -> list[Point]:
    """Return a point inside one piece of each group that is connected by common vertices."""
    leader = dict[Point, Point]()

    def find(p: Point) -> Point:
        while leader.setdefault(p, p) != p:
            leader[p] = leader[leader[p]]
            p = leader[p]
        return p

    for piece in pieces:
        for p in piece:
            leader[find(p)] = find(piece[0])
    return [*{find(piece[0]): inner_point(piece) for piece in pieces}.values()]


# --- Sums and the lemma ---------------------------------------------------------------------------


class Known(NamedTuple):
    """A known edge: of a loop, or a fit, which is of none."""

    start: Point
    end: Point
    line: Line
    loop: str
    name: str


def loop(name: str, item: Any, step: int = 1) -> list[Known]:
    """Read a loop: counter-clockwise, no straight angle, the least point first; with step -1, reverse it."""
    points = [point(name, entry) for entry in items(name, item, 3)]
    around = edges(points[::step])
    lines = [line[:2] for *_, line in around]
    bent = all(a * d != b * c for (a, b), (c, d) in zip(lines, [lines[-1], *lines], strict=False))
    need(area(around) * step > 0, f"{name}: not counter-clockwise", points[0])
    need(
        bent and len({*points}) == len(points),
        f"{name}: a straight angle, or a repeated point",
        points[0],
    )
    need(
        points[0] == min(points, key=place), f"{name}: the least point is not the first", points[0]
    )
    return [Known(*e, name, f"{name}, edge {k}") for k, e in enumerate(around)]


def loops(name: str, item: Any) -> list[Known]:
    """Read a list of loops that are walked clockwise."""
    return [e for k, found in enumerate(items(name, item)) for e in loop(f"{name}[{k}]", found, -1)]


def fits(name: str, item: Any) -> list[Known]:
    """Read a list of fits."""
    ends = [[point(name, p) for p in items(name, fit, 2, 2)] for fit in items(name, item)]
    return [Known(*edges(fit)[0], "", f"{name}[{k}]") for k, fit in enumerate(ends)]


class Sums:
    """The interiors of D_i + H_j, of number i n + j for n pieces H_j, and then half-planes."""

    def __init__(
        self, d: list[Ring], h: list[Ring], work: Work, beyond: Sequence[Edge] = ()
    ) -> None:
        self.work, self.count, self.columns, self.beyond = work, len(d) * len(h), len(h), beyond
        self.scale = scale_of(chain(d, h))
        self.trees = [tree([(box(e, self.scale), k) for k, e in enumerate(of)]) for of in (d, h)]
        self.d, self.h = ([edges(from_lowest(e)) for e in of] for of in (d, h))
        longest = max(map(len, chain(d, h)), default=0)
        self.get = lru_cache(10**5 // (longest + 1) + 1)(self.find)

    def find(self, k: int) -> tuple[list[Line], list[Edge]]:
        """Return the lines and the sides of a sum, from its lowest point on, the left one of two."""
        if k >= self.count:
            return [self.beyond[k - self.count][2]], [self.beyond[k - self.count]]
        one, other = self.d[k // self.columns], self.h[k % self.columns]
        self.work.spend(3 * (len(one) + len(other)))
        found = edges(add_pieces(one, other))
        return [line for *_, line in found], found


def from_lowest(points: Ring) -> Ring:
    """Return a ring from its lowest point on, the left one of two."""
    k = min(range(len(points)), key=lambda n: place(points[n])[::-1])
    return points[k:] + points[:k]


def add_pieces(one: list[Edge], other: list[Edge]) -> Ring:
    """Return the sum of two pieces, both from their lowest points on: their edges by direction."""
    i, j, found = 0, 0, []
    while i < len(one) or j < len(other):
        (p, _, (a, b, _)), (q, _, (c, d, _)) = one[i % len(one)], other[j % len(other)]
        found.append(add(p, q))
        turn = (j == len(other)) - (i == len(one)) or a * d - b * c
        i, j = i + (turn >= 0), j + (turn <= 0)
    return found


def clip(lines: list[Line], a: Point, b: Point) -> Span | None:
    """Return the parameters of a segment's points left of all lines, or None.

    The parameter is 0 at a and 1 at b; where an end is inside, -1 or 2 stands for the parameter.
    """
    (x, y, w), (u, v, z), low, high = a, b, (-1, 1), (2, 1)
    for k, m, n in lines:
        at_a, at_b = (k * x + m * y + n * w) * z, (k * u + m * v + n * z) * w
        if at_a <= 0:
            if at_b <= 0:
                return None
            if -at_a * low[1] > low[0] * (at_b - at_a):
                low = -at_a, at_b - at_a
        elif at_b <= 0 and at_a * high[1] < high[0] * (at_a - at_b):
            high = at_a, at_a - at_b
    return (Fraction(*low), Fraction(*high)) if low[0] * high[1] < high[0] * low[1] else None


def share(one: Sequence[Any], other: Sequence[Any]) -> Span | None:
    """Return the parameters of a segment's points, it is no point itself, on another one, or None."""
    (a, b, on), (p, q, of) = one[:3], other[:3]
    at_p, at_q, at_a, at_b = side(on, p), side(on, q), side(of, a) * b[2], side(of, b) * a[2]
    if at_p == at_q == 0:
        k = int(a[0] * b[2] == b[0] * a[2])
        x, y, *ends = (Fraction(e[k], e[2]) for e in (a, b, p, q))
        s, t = sorted((end - x) / (y - x) for end in ends)
        return (s, t) if s <= 1 and t >= 0 else None
    crosses = at_p * at_q <= 0 and at_a * at_b <= 0 and at_a != at_b
    return (Fraction(at_a, at_a - at_b),) * 2 if crosses else None


def covers(spans: list[tuple[Span, bool]]) -> bool:
    """Return whether open and closed intervals, with the flag for closed ones, cover 0 to 1."""
    reach, is_closed = Fraction(0), False
    for (low, high), closed in sorted(spans, key=lambda e: (e[0][0], not e[1])):
        if low < reach or (low == reach and (closed or is_closed)):
            reach, is_closed = max((reach, is_closed), (high, closed))
    return reach > 1 or (reach == 1 and is_closed)


def distinct(one: Known, other: Known) -> bool:
    """Return whether known edges meet in a point at most: in a loop at ends, and fits of a point nowhere."""
    if one.start == one.end:
        one, other = other, one
    if one.start == one.end:
        return one.start != other.start
    low, high = share(one, other) or (Fraction(2), Fraction(0))
    if low > high or one.loop != other.loop or not one.loop:
        return low > high or (other.start != other.end and min(high, 1) <= max(low, 0))
    return min(high, 1) <= max(low, 0) and (one.end == other.start or one.start == other.end)


def boundary(
    name: str, sums: Sums, known: list[Known], listed: Any, around: Sequence[Any] = ()
) -> None:
    """Prove (a), (b), (c) and (e) of the lemma for known edges and listed sums."""
    work, scale = sums.work, sums.scale
    at = tree([(box((e.start, e.end), scale), n) for n, e in enumerate(known)])
    for m, n, _ in near(work, at, at, ORIGIN, touching=1):
        work.spend(4)
        need(
            m >= n or distinct(known[m], known[n]),
            f"{known[m].name}: meets {known[n].name}",
            known[m].start,
            known[m].end,
        )
    for n, i, j in near(work, at, *sums.trees):
        lines, edge = sums.get(i * sums.columns + j)[0], known[n]
        work.spend(len(lines) / 4)
        need(
            clip(lines, edge.start, edge.end) is None,
            f"{edge.name}: inside the sum of pieces {i} and {j}",
            edge.start,
            edge.end,
        )
    beside = prove_sides(name, sums, known, listed, around)
    for n, edge in enumerate(known):
        for is_left in (True, False) if not edge.loop else (True,):
            is_beside = covers(beside[n, is_left])
            where = "left" if is_left else "right"
            need(
                is_beside,
                f"{edge.name}: {name} are not along all of its {where} side",
                edge.start,
                edge.end,
            )


def prove_sides(
    name: str, sums: Sums, known: list[Known], listed: Any, around: Sequence[Any]
) -> dict[Any, Any]:
    """Prove (b); return, for each known edge and side of it, the intervals along which sums are."""
    entries = [
        (f"{name}[{n}]", items(f"{name}[{n}]", e, 1)) for n, e in enumerate(items(name, listed))
    ]
    numbered = [(at, integer(at, k, 0, sums.count), chains) for at, (k, *chains) in entries]
    numbered += [(f"around[{k}]", sums.count + k, [found]) for k, found in enumerate(around)]
    beside = defaultdict[Any, list[tuple[Span, bool]]](list)
    for at, k, chains in numbered:
        sides = sums.get(k)[1]
        for one, found in zip(sides, items(at, chains, len(sides), len(sides)), strict=True):
            spans = list[tuple[Span, bool]]()
            for n in [found] if type(found) is int else items(at, found):
                if integer(at, n, -len(known), len(numbered)) >= 0:
                    lines = sums.get(numbered[n][1])[0]
                    sums.work.spend(len(lines) / 2 + 5)
                    span = clip(lines, *one[:2])
                    spans += [(span, False)] if span else []
                    continue
                edge = known[-1 - n]
                span = share(one, edge)
                sums.work.spend(5)
                if span:
                    spans.append((span, True))
                    if edge.start == edge.end:
                        beside[-1 - n, True] = beside[-1 - n, False] = [
                            ((Fraction(0), Fraction(1)), True)
                        ]
                    elif span[0] < span[1]:
                        is_left = one[2][0] * edge.line[0] + one[2][1] * edge.line[1] > 0
                        beside[-1 - n, is_left].append((share(edge, one) or span, True))
            need(covers(spans), f"{at}: its chain does not cover the side", *one[:2])
    return beside


def prove_winding(
    name: str, known: list[Known], points: Iterable[Point], wanted: int, work: Work
) -> None:
    """Prove (d) of the lemma: require a winding number of the loops at points."""
    around = [e[:3] for e in known if e.loop]
    for z in points:
        work.spend(len(around) / 2)
        times = winding(around, z)
        need(
            times == wanted,
            f"{name}: loops wind {times} times, not {wanted}, around a point of a sum",
            z,
        )


# --- Positions ------------------------------------------------------------------------------------


def no_fit(c: Any, work: Work) -> str:
    """Prove a no-fit polygon."""
    answer = fields("certificate", c, "directrix generatrix exterior holes exact_fits proof", HEAD)
    first, second, listed = fields("proof", answer[5], "directrix generatrix sums")
    known = prove_no_fit(answer, first, second, listed, work)[2]
    return f"no-fit polygon, {len(known) - len(answer[4])} edges, {len(answer[4])} exact fits"


def prove_no_fit(answer: list[Any], first: Any, second: Any, listed: Any, work: Work) -> Any:
    """Prove a no-fit polygon; return the pieces and the known edges."""
    d = solid("directrix", shape("directrix", answer[0]), first, work)
    g = solid("generatrix", shape("generatrix", answer[1]), second, work)
    need(d and g, "directrix, generatrix: no pieces")
    h = [*map(reflect, g)]
    known = [
        *loop("exterior", answer[2]),
        *loops("holes", answer[3]),
        *fits("exact_fits", answer[4]),
    ]
    boundary("sums", Sums(d, h, work), known, listed)
    prove_winding("sums", known, (add(p, q) for p, q in product(groups(d), groups(h))), 1, work)
    return d, g, known


def sweep(c: Any, work: Work) -> str:
    """Prove a no-fit polygon, and the area that the generatrix covers along its exterior."""
    names = "directrix generatrix exterior holes exact_fits inner outer unswept area proof"
    *answer, first_loop, last_loop, unswept, told, proof = fields("certificate", c, names, HEAD)[
        :10
    ]
    first, second, listed, swept, slits = fields(
        "proof", proof, "directrix generatrix sums swept slits"
    )
    d, g, around = prove_no_fit(answer, first, second, listed, work)
    inner = loop("inner", first_loop, -1)
    known = [*loop("outer", last_loop), *inner, *loops("unswept", unswept)]
    t = [[e.start, e.end] for e in around if e.loop == "exterior"]
    boundary("swept", Sums(t, g, work), [*known, *fits("slits", slits)], swept)
    prove_winding("swept", known, (add(t[0][0], inner_point(piece)) for piece in g), 1, work)
    at = inner_point(d[0])
    need(winding([e[:3] for e in inner], at) == -1, "inner: not the loop around the directrix", at)
    total = area(e[:3] for e in known)
    need(number("area", told) == total, "area: not that of outer less inner and unswept")
    return f"sweep, outer {len(known)}"


def inner_fit(c: Any, work: Work) -> str:
    """Prove an inner fit."""
    container, part, regions, positions, proof = fields(
        "certificate", c, "container part regions exact_fits proof", HEAD
    )[:5]
    ends, first, second, listed, around = fields("proof", proof, "frame outside part sums around")
    frame = read_frame(ends)
    outside = [frame, *(e[::-1] for e in shape("container", container))]
    d = solid("outside", outside, first, work)
    h = [*map(reflect, solid("part", shape("part", part), second, work))]
    known = [
        e
        for k, region in enumerate(items("regions", regions))
        for e in read_region(f"regions[{k}]", region, work)
    ]
    known += fits("exact_fits", positions)
    (left, low), (right, high) = place(frame[0]), place(frame[2])
    xs, ys = zip(*map(place, chain.from_iterable(h)), strict=True)
    within = rectangle("frame", left + max(xs), low + max(ys), right + min(xs), high + min(ys))
    beyond = [(q, p, (-a, -b, -c)) for p, q, (a, b, c) in edges(within)]
    for edge, (*_, line) in product(known, beyond):
        need(
            max(side(line, edge.start), side(line, edge.end)) <= 0,
            f"{edge.name}: there the part is beyond the frame",
            edge.start,
        )
    boundary("sums", Sums(d, h, work, beyond), known, listed, items("around", around, 4, 4))
    prove_winding("sums", known, (add(p, q) for p, q in product(groups(d), groups(h))), 0, work)
    return f"inner fit, {len(regions)} regions of {len(known) - len(positions)} edges, {len(positions)} exact fits"


def read_region(name: str, item: Any, work: Work) -> list[Known]:
    """Read a region, its interior on the right; every hole is in the exterior, and in no other hole."""
    exterior, holes = fields(name, item, "exterior holes")
    listed = [loop(f"{name}, hole {k}", e) for k, e in enumerate(items(name, holes))]
    own = [*loop(f"{name}, exterior", exterior, -1), *chain.from_iterable(listed)]
    for hole in listed:  # the middle of an edge that goes down counts as inside
        work.spend(len(own) / 2)
        x, y, w = next(add(e.start, e.end) for e in hole if e.line[0] > 0)
        is_inside = winding([e[:3] for e in own], (x, y, 2 * w)) == 0
        need(is_inside, f"{hole[0].loop}: not in the exterior, or in another hole", hole[0].start)
    return own


# --- Layouts --------------------------------------------------------------------------------------


class Piece(NamedTuple):
    """The points no farther than a radius from the shape of rings; a proof has one convex ring."""

    rings: list[Ring]
    radius: Rational


class Body(NamedTuple):
    """A placed part or an obstacle: pieces where they are, and a bound on their error."""

    name: str
    pieces: list[Piece]
    error: Rational
    inside: int = 1  # the winding number of the rings in it


class Part(NamedTuple):
    """A part, and the rotation of each of its placements, with whether it is mirrored."""

    pieces: list[Piece]
    error: Rational
    edges: list[Edge]
    demand: int | None
    rotations: set[Any] | None
    may_mirror: bool
    placed: list[tuple[Any, bool]]


def read_rounded(name: str, item: Any) -> Piece:
    """Read a rounded piece: a point, a segment or a convex ring, and a radius."""
    listed, radius = fields(name, item, "points radius")
    points = [point(name, p) for p in items(name, listed, 1)]
    right = is_convex(points) if len(points) > 2 else len({*points}) == len(points)
    need(right, f"{name}: neither a point nor a segment nor convex", points[0])
    return Piece([points], number(name, radius, 0))


def read_rotation(name: str, item: Any) -> Any:
    """Read a rotation: cosine and sine, or degrees where these are irrational."""
    if type(item) is list:
        found = place(point(name, item))
        need(
            found[0] ** 2 + found[1] ** 2 == 1, f"{name}: cosine and sine of another length than 1"
        )
        return found
    degrees = number(name, "0" if item is None else item) % 360
    return degrees if degrees % 90 else AXES[int(degrees) // 90]


def rotation_error(to: tuple[Rational, Rational], degrees: Rational) -> Fraction:
    """Bound |cos - cos'| + |sin - sin'| of a rotation and one by degrees, by the power series."""
    unit, sums, term, k = 10**110, [0, 0, 0, 0], 10**110, 0
    angle = int(Fraction(int(DIGITS_OF_PI), 10**99) * degrees / 180 * unit)
    while term:
        sums[k % 4], k, term = sums[k % 4] + term, k + 1, term * angle // (unit * (k + 1))
    true = Fraction(sums[0] - sums[2], unit), Fraction(sums[1] - sums[3], unit)
    return sum((abs(s - t) for s, t in zip(to, true, strict=True)), Fraction(1, 10**95))


def move(points: Ring, rotation: tuple[Rational, Rational], mirrored: bool, by: Point) -> Ring:
    """Mirror, rotate and move a ring; all its points get one denominator."""
    (c, s), unit = rotation, lcm(*(w for *_, w in points))
    r = Fraction(c).denominator  # that of the sine, too
    n, m, w, (u, v, z) = int(c * r), int(s * r), unit * r, by
    level = [((-1) ** mirrored * x * (unit // d), y * (unit // d)) for x, y, d in points]
    found = [((n * x - m * y) * z + u * w, (m * x + n * y) * z + v * w, w * z) for x, y in level]
    return found[::-1] if mirrored else found


def gap(one: Ring, other: Ring, normal: tuple[int, int], distance: Rational) -> bool:
    """Return whether a normal shows that points are at a distance from others, on its side.

    The points of a ring have one denominator.
    """
    (x, y), w, v, (n, m) = normal, one[0][2], other[0][2], distance.as_integer_ratio()
    found = min(x * s + y * t for s, t, _ in other) * w - max(x * s + y * t for s, t, _ in one) * v
    return (
        (x, y) != (0, 0) and found >= 0 and (found * m) ** 2 >= (n * w * v) ** 2 * (x * x + y * y)
    )


def squared_distance(edge: Edge, p: Point) -> Fraction:
    """Return the squared distance of a point from a segment, which may be a point."""
    (a, b), (c, d), (x, y) = map(place, (*edge[:2], p))
    u, v = c - a, d - b
    along = u * (x - a) + v * (y - b)
    share = min(max(along / (u * u + v * v), Fraction(0)), Fraction(1)) if along > 0 else 0
    return (a + share * u - x) ** 2 + (b + share * v - y) ** 2


def is_inside(body: Body, p: Point, closed: bool) -> bool:
    """Return whether a point is in a body, or on its boundary; if not closed, deeper than its error."""
    for rings, radius in body.pieces:
        around, room = [e for points in rings for e in edges(points)], radius - body.error
        squared = min(squared_distance(edge, p) for edge in around)
        is_wound = winding(around, p) == body.inside
        if closed:
            found = is_wound or squared <= radius**2
        elif is_wound:
            found = room > 0 or squared > room**2
        else:
            found = room > 0 and squared < room**2
        if found:
            return True
    return False


class Layout:
    """A layout and its evidence: parts by id, and bodies: placements, and obstacles from -1 down."""

    def __init__(self, c: Any, work: Work) -> None:
        self.work, self.valid = work, c.get("valid") is True
        need(type(c.get("valid")) is bool, "valid: neither true nor false")
        names = f"layout turns valid {'proof' if self.valid else 'faults'}"
        given, turns, _, self.evidence = fields("certificate", c, names, HEAD)[:4]
        keys = "container defects spacing margin"
        parts, placements, container, defects, *gaps = fields(
            "layout", given, "parts placements", keys
        )
        self.spacing, self.margin = (
            number("layout, spacing and margin", optional(n, "0"), 0) for n in gaps
        )
        solids = [container, *items("layout, defects", optional(defects, []))]
        cut, outside, self.frame = list[Any](), list[Any](), None
        if self.valid:
            ends, outside, cut, self.normals = fields(
                "proof", self.evidence, "frame outside pieces apart"
            )
            self.frame = read_frame(ends) if container or ends is not None else None
        need(
            container or not (self.frame or self.margin),
            "layout: a frame or a margin, but no container",
        )
        self.parts, self.bodies = dict[str, Part](), list[Body]()
        for k, (item, found) in enumerate(self.pair("layout, parts", parts, "pieces", cut)):
            self.read_part(f"parts[{k}]", item, found)
        for k, item in enumerate(items("layout, placements", placements)):
            self.read_placement(
                f"placements[{k}]", item, items("turns", turns, len(placements), len(placements))[k]
            )
        self.count = len(self.bodies)
        obstacles = [*enumerate(self.pair("layout, defects", solids, "outside", outside))]
        for k, (item, found) in reversed(obstacles):
            self.read_obstacle(f"defects[{k - 1}]" if k else "container", item, found)

    def pair(self, name: str, listed: Any, key: str, cut: Any) -> list[tuple[Any, Any]]:
        """Pair shapes with their pieces, which only a proof has."""
        size = len(items(name, listed))
        return [
            *zip(listed, items(key, cut, size, size) if self.valid else [None] * size, strict=True)
        ]

    def cut(self, name: str, rings: list[Ring], item: Any) -> list[Piece]:
        """Return a shape's pieces, or for faults its rings as they are."""
        if not self.valid:
            return [Piece(rings, 0)]
        return [Piece([piece], 0) for piece in solid(name, rings, item, self.work)]

    def read_part(self, name: str, item: Any, cut: Any) -> None:
        """Read a part."""
        keys = "exterior holes pieces error demand turns mirrored"
        key, exterior, holes, rounded, error, *rules = fields(name, item, "id", keys)
        need(
            type(key) is str and key not in self.parts, f"{name}: its id is not a string of its own"
        )
        rings = list[Ring]()
        if rounded is None:
            rings = shape(name, {"exterior": exterior, "holes": holes})
            pieces = self.cut(name, rings, cut)
        else:
            need(exterior is holes is cut is None, f"{name}: pieces beside an exterior")
            pieces = [
                read_rounded(f"{name}, piece {k}", e) for k, e in enumerate(items(name, rounded))
            ]
        need(pieces, f"{name}: no pieces")
        demand, turns, mirrored = rules
        self.parts[key] = Part(
            rings,
            pieces,
            number(f"{name}, error", optional(error, "0"), 0),
            None if demand is None else integer(f"{name}, demand", demand, 0, 10**9),
            None
            if turns is None
            else {read_rotation(f"{name}, turns", e) for e in items(name, turns)},
            mirrored is None or boolean(f"{name}, mirrored", mirrored),
            [],
        )

    def read_placement(self, name: str, item: Any, rational: Any) -> None:
        """Read a placement, and place its part."""
        key, by, turn, flag = fields(name, item, "part move", "turn mirrored")
        need(type(key) is str and key in self.parts, f"{name}: of no part")
        part, mirrored, by = self.parts[key], boolean(f"{name}, mirrored", flag), point(name, by)
        asked, to = (
            read_rotation(name, optional(turn, "0")),
            read_rotation("turns", items("turns", rational)),
        )
        points = [p for piece in part.pieces for points in piece.rings for p in points]
        self.work.spend(10 + 4 * len(points))
        error = part.error
        if asked != to:
            need(type(asked) is not tuple, f"{name}: its entry of turns is another rotation")
            error += max(abs(x) + abs(y) for x, y in map(place, points)) * rotation_error(to, asked)
        part.placed.append((asked, mirrored))
        pieces = [Piece([move(e, to, mirrored, by) for e in rings], r) for rings, r in part.pieces]
        self.bodies.append(Body(f"{name} of {key[:40]!a}", pieces, error))

    def read_obstacle(self, name: str, item: Any, cut: Any) -> None:
        """Read a defect, or the container, and put there what is outside it, in the frame."""
        if item is None and name == "container":
            need(not cut, "outside: pieces, but no container")
            self.bodies.append(Body(name, [], 0))
            return
        rings, error = shape(name, item, "error"), number(name, optional(item.get("error"), "0"), 0)
        if name == "container":
            rings = [e[::-1] for e in rings]
        pieces = self.cut(
            name, [self.frame, *rings] if self.frame and name == "container" else rings, cut
        )
        still = [
            Piece([move(e, AXES[0], False, (0, 0, 1)) for e in found], 0) for found, _ in pieces
        ]
        self.bodies.append(Body(name, still, error, int(name != "container")))

    def find_broken(self) -> set[tuple[str, str]]:
        """Return the rules that placements break, each with the part's id."""
        found = set()
        for key, part in self.parts.items():
            demand = len(part.placed) if part.demand is None else part.demand
            turned = part.rotations is not None and {a for a, _ in part.placed} - part.rotations
            mirrored = not part.may_mirror and any(flag for _, flag in part.placed)
            broken = len(part.placed) < demand, len(part.placed) > demand, turned, mirrored
            rules = zip(("missing", "surplus", "turn", "mirror"), broken, strict=True)
            found |= {(kind, key) for kind, is_so in rules if is_so}
        return found

    def prove_valid(self) -> None:
        """Prove that parts are in the frame, and apart from each other and from obstacles."""
        normals, reach, boxes = (
            dict[Any, tuple[int, int]](),
            max(self.spacing, self.margin) / Fraction(2),
            [],
        )
        for n, (*key, x, y) in enumerate(
            items(f"apart[{n}]", e, 6, 6) for n, e in enumerate(items("apart", self.normals))
        ):
            a, i, b, j = (integer(f"apart[{n}]", k, -len(self.bodies), 10**9) for k in key)
            need((a, i, b, j) not in normals, f"apart[{n}]: pieces are there twice")
            normals[a, i, b, j] = point(f"apart[{n}]", [x, y])[:2]
        for one in self.bodies[: self.count]:
            for (p, axis), piece in product(zip(self.frame or [], AXES), one.pieces):
                distance = self.margin + piece.radius + one.error + self.bodies[-1].error
                need(
                    gap([p], piece.rings[0], axis, distance),
                    f"{one.name}: not in the frame",
                    piece.rings[0][0],
                )
        scale = scale_of(e for one in self.bodies for piece in one.pieces for e in piece.rings)
        numbers = [*range(self.count), *range(self.count - len(self.bodies), 0)]
        for a, i, piece in (
            (a, i, piece) for a in numbers for i, piece in enumerate(self.bodies[a].pieces)
        ):
            more = reach + self.bodies[a].error + piece.radius
            boxes.append((box(piece.rings[0], scale, more), (a, i)))
        at = tree(boxes)
        for (a, i), (b, j), _ in near(self.work, at, at, ORIGIN):
            if a < b and b >= 0:
                self.prove_apart(a, i, b, j, normals)

    def prove_apart(
        self, a: int, i: int, b: int, j: int, normals: dict[Any, tuple[int, int]]
    ) -> None:
        """Prove that piece i of body a and piece j of body b are apart, by a normal or by an axis."""
        one, other = self.bodies[a], self.bodies[b]
        ((points,), r), ((others,), q) = one.pieces[i], other.pieces[j]
        self.work.spend(len(points) + len(others))
        distance = (self.margin if a < 0 else self.spacing) + one.error + other.error + r + q
        listed = normals.get((a, i, b, j)) or normals.get((a, -1, b, -1))
        is_apart = any(gap(points, others, n, distance) for n in ([listed] if listed else AXES))
        reason = f"{one.name}, piece {i}, and {other.name}, piece {j}: no normal shows that they are apart"
        need(is_apart, reason, points[0], others[0])

    def prove_fault(self, name: str, fault: Any, broken: set[tuple[str, str]]) -> Any:
        """Prove one fault by its points; return what has it."""
        kind, key, on, defect, listed = fields(name, fault, "kind", "part placements defect points")
        points = [point(name, p) for p in items(name, optional(listed, []))]
        if on is None:
            need(type(key) is str and key in self.parts and defect is None, f"{name}: of no part")
            around = [e for points in self.parts[key].rings for e in edges(points)]
            self.work.spend(len(around))
            if kind == "shape" and len(points) == 1:
                need(winding(around, points[0]) not in (0, 1), f"{name}: not shown", points[0])
            else:
                need((kind, key) in broken and not points, f"{name}: not shown")
            return kind, key
        a, *others = [integer(name, k, 0, self.count) for k in items(name, on, 1, 2)]
        b = (
            others[0]
            if others
            else -1
            if defect is None
            else -2 - integer(name, defect, 0, len(self.bodies) - self.count - 1)
        )
        one, other, is_close = self.bodies[a], self.bodies[b], kind == "too close"
        right = is_close or kind == ("overlap" if others else "outside")
        need(
            right and key is None and a != b and len(points) == 1 + is_close and other.pieces,
            f"{name}: not a fault of this form",
        )
        self.work.spend(
            20 * sum(len(e) for of in (one, other) for piece in of.pieces for e in piece.rings)
        )
        for of, p in ((one, points[0]), (other, points[-1])):
            need(is_inside(of, p, is_close), f"{name}: not in {of.name}, deeper than its error", p)
        if is_close:
            (x, y), (u, v), gap = *map(place, points), self.spacing if others else self.margin
            room = gap - one.error - other.error
            need(
                room > 0 and (x - u) ** 2 + (y - v) ** 2 < room**2,
                f"{name}: not too close",
                *points,
            )
        return frozenset((a, b))


def optional(item: Any, default: Any) -> Any:
    """Return an item, or a default where it is left out or null."""
    return default if item is None else item


def layout(c: Any, work: Work) -> str:
    """Prove a layout: valid, or with faults."""
    found = Layout(c, work)
    broken = found.find_broken()
    told = f"layout of {found.count} placements of {len(found.parts)} parts"
    if found.valid:
        need(not broken, f"valid: but rules are broken: {sorted(broken)[:3]!a}")
        found.prove_valid()
        return f"{told}, valid"
    faults = items("faults", found.evidence, 1)
    proved = {found.prove_fault(f"faults[{k}]", fault, broken) for k, fault in enumerate(faults)}
    need(len(proved) == len(faults), "faults: one is there twice")
    return f"{told}, not valid: {len(faults)} faults"


# --- Questions ------------------------------------------------------------------------------------


PROVERS = {"no_fit": no_fit, "sweep": sweep, "inner_fit": inner_fit, "layout": layout}


def prove(certificate: Any, max_steps: float | None = None) -> str:
    """Prove a certificate, as `load` gives it, and describe what is proved.

    Raises:
        Refused: it is not proved; the first reason.
    """
    need(type(certificate) is dict, "not an object")
    head = [certificate.get(key) for key in ("format", "version", "claim")]
    need(head[0] == FORMAT, f"format: not {FORMAT!r}")
    need(
        type(head[1]) is int and head[1] == VERSION,
        f"version: not {VERSION}; write the certificate again",
    )
    need(type(head[2]) is str and head[2] in PROVERS, f"claim: none of {', '.join(PROVERS)}")
    return PROVERS[head[2]](certificate, Work({**certificate, "area": None}, max_steps))


def load(text: str) -> Any:
    """Read JSON in which no object has one key twice."""

    def once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        need(len(dict(pairs)) == len(pairs), "a key is there twice")
        return dict(pairs)

    return json.loads(text, object_pairs_hook=once)


def main(arguments: list[str]) -> int:
    """Print what a certificate proves; return the exit code."""
    try:
        print(f"proved: {prove(load(Path(*arguments).read_text(encoding='utf-8-sig')))}")
    except Exception as error:  # whatever a file makes happen, nothing is proved
        print(f"not proved: {error}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
