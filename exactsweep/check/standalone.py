"""Checker of certificates, version 3: `python standalone.py FILE` prints "proved" or "not proved".

CERTIFICATES.md defines the format. A point (x, y, w) of integers, w > 0, is (x/w, y/w); it is left
of a line (a, b, c) if a x + b y + c w > 0.

1. Shapes. The winding number of rings at z counts the edges strictly right of z, upward ones as 1,
   downward ones as -1; an edge contains its lower end, but not its upper one. It is the same at
   z + (d, d^2) for all small d > 0. A shape is the set of points of winding number 1. So two shapes
   have a common point if and only if they overlap: their interiors have one.
2. Pieces, convex and counter-clockwise, make up a shape (`solid`) if on every line, at every point,
   starts minus ends of edges are equal for pieces and rings, and any two pieces lie on opposite
   sides of a line. Then the edges of pieces and of rings right of any z have the same count, so
   the winding number at z is the number of pieces that contain z, at most one.
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
   D_2 + H_j have p + int H_j in common, so (d) need not be checked for a piece with a vertex of a
   piece before it. `sweep`: along T, G covers, up to closure, the sums of edges of T and pieces of
   G; those of one piece are connected. Slits are fits that the answer omits. `sum`: for any path.
5. `inner_fit`: D is a frame minus the container, inside it by 2; B, all t with G + t in the frame,
   is a rectangle. L is in B; the half-planes around B are listed sums, with an edge of B as side;
   others have the rest of the line. In the proof, read W + 1 for W; each ray meets a half-plane,
   and L before it. Loops of a region meet at most once: they do not cross. Their W is 0 at two
   points just inside a hole; each other loop misses one. So it is in the exterior, not in another.
6. `layout`: a rounded piece is the set of points within distance r of a convex hull; r = 0 for the
   pieces of 2. For vertices a and b of two pieces, a normal n with gap = min n.b - max n.a >= 0 and
   gap^2 >= (s + r_a + r_b)^2 |n|^2 proves that they are s apart and do not overlap; so do disjoint
   boxes, enlarged. Errors add to s; a rotation with error d displaces a point at distance r from
   the origin by at most d r. A frame minus a container, and defects, are shapes like parts; in a
   rounded container, depth is concave, so vertices decide. A point deeper in two bodies than their
   errors proves that they overlap; one within (s - errors) / 2 of both, that they are too close, if
   shapes have winding numbers 0 and 1; others have no pieces, so no layout with them is valid.
"""

import json
import re
import sys
from collections import Counter, defaultdict, namedtuple
from collections.abc import Iterable, Iterator, Sequence
from contextvars import ContextVar
from decimal import Context, Decimal
from fractions import Fraction
from functools import lru_cache, partial, reduce
from itertools import accumulate, chain, pairwise, product
from math import gcd, lcm
from pathlib import Path
from types import SimpleNamespace
from typing import Any

FORMAT, VERSION = "exactsweep certificate", 3
MAX_DIGITS, MAX_STEPS, STEPS_PER_BYTE, UNITS = 10**5, 10**7, 100, 2**120
NUMBER = re.compile("0|-?[1-9][0-9]*(/[1-9][0-9]*)?")
AXES, ORIGIN = ((1, 0), (0, 1), (-1, 0), (0, -1)), [(0, 0, 0, 0)]
WORK = ContextVar[list[float]]("the remaining steps, of a microsecond, and the price of one")
PI = "3.1415926535897932384626433832795028841971693993751058209749445923078164062862089986280348"
Rational = int | Fraction
Point = tuple[int, int, int]
Ring = list[Point]
Rings = list[Ring]
Edge = tuple[Point, Point, Point]
Span = tuple[Rational, bool, Rational] | None
Known = namedtuple("Known", "start end line loop name region")  # an edge; a fit has no loop


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


def spend(steps: float) -> None:
    """Subtract steps, which cost more with long numbers."""
    work = WORK.get()
    work[0] -= steps * work[1]
    if work[0] < 0:
        raise Refused("too large: exceeds the step limit for its size")


def node(x: Rational, y: Rational) -> Point:
    """Return the point with the given coordinates."""
    w = lcm(x.denominator, y.denominator)
    return int(x * w), int(y * w), w


def place(p: Point) -> tuple[Fraction, Fraction]:
    """Return the coordinates of a point."""
    return Fraction(p[0], p[2]), Fraction(p[1], p[2])


def add(p: Point, q: Point) -> Point:
    """Return the sum of two points."""
    return p[0] * q[2] + q[0] * p[2], p[1] * q[2] + q[1] * p[2], p[2] * q[2]


def side(line: Point, p: Point) -> int:
    """Return a number whose sign is 1 left of a line, 0 on it, -1 right of it."""
    return line[0] * p[0] + line[1] * p[1] + line[2] * p[2]


def edges(points: Sequence[Point]) -> list[Edge]:
    """Return the edges of a ring, each with its line."""
    found, ends = list[Edge](), zip(points, [*points[1:], *points[:1]], strict=True)
    for (x, y, w), (u, v, z) in ends:
        found.append(((x, y, w), (u, v, z), (y * z - v * w, u * w - x * z, x * v - u * y)))
    return found


def level(points: Ring) -> Ring:
    """Bring points to a common denominator; long numbers raise the cost of steps."""
    unit, work = lcm(*(w for *_, w in points)), WORK.get()
    found = [(x * (unit // w), y * (unit // w), unit) for x, y, w in points]
    bits = max(0, max(map(int.bit_length, chain(*found))) - 60)
    work[1] = max(work[1], 1 + bits / 40 + bits**2 / 10**6)
    spend(len(found))
    return found


def area(around: Iterable[Edge]) -> Fraction:
    """Return the signed area within edges."""
    terms = [(line[2], 2 * p[2] * q[2]) for p, q, line, *_ in around]
    unit = lcm(*(w for _, w in terms))
    return Fraction(sum(n * (unit // w) for n, w in terms), unit)


def winding(around: Iterable[Edge], z: Point) -> int:
    """Return the winding number: upward minus downward edges strictly right of a point."""
    ups = [((p[1] * z[2] <= z[1] * p[2]) - (q[1] * z[2] <= z[1] * q[2]), n) for p, q, n in around]
    return sum(up for up, line in ups if up and up * side(line, z) > 0)


def is_convex(points: Ring) -> bool:
    """Decide whether a ring turns left at every vertex, and once in total."""
    normals = [line[:2] for *_, line in edges(points)]
    pairs = [*pairwise([normals[-1], *normals])]
    turns_left = all(a * d > b * c for (a, b), (c, d) in pairs)
    return turns_left and sum(one > (0, 0) > other for one, other in pairs) == 1


# --- Reading --------------------------------------------------------------------------------------
def read(name: str, item: Any, form: Any) -> Any:
    """Read by a form: (form, default) if optional, [form], {key: form}, a type, or a function."""
    if isinstance(form, type):
        is_right = type(item) is form and (type(item) is not int or abs(item) < 10**9)
        need(is_right, f"{name}: not of type {form.__name__}{' below 10^9' * (form is int)}")
        return item
    if isinstance(form, tuple):
        item = form[1] if item is None else item
        return None if item is None else read(name, item, form[0])
    need(item is not None, f"{name}: missing")
    if isinstance(form, list):
        is_list = type(item) is list and len(form) in (1, len(item))
        need(is_list, f"{name}: not a list" + f" of {len(form)} entries" * (len(form) > 1))
        entries = zip(item, form * len(item) if len(form) == 1 else form, strict=True)
        return [read(f"{name}[{k}]", *entry) for k, entry in enumerate(entries)]
    if isinstance(form, dict):
        is_object = type(item) is dict and item.keys() <= form.keys()
        need(is_object, f"{name or 'certificate'}: not an object with keys {' '.join(form)}")
        keys = ((key, f"{name}.{key}".lstrip("."), own) for key, own in form.items())
        return SimpleNamespace(name=name, **{k: read(at, item.get(k), own) for k, at, own in keys})
    return form(name, item)


def number(name: str, item: Any, is_signed: bool = True) -> Rational:
    """Read a rational in lowest terms."""
    right = type(item) is str and len(item) <= MAX_DIGITS and NUMBER.fullmatch(item)
    need(right, f"{name}: not a number in a string, such as -3 or 5/7")
    n, m = (int(Decimal(part)) for part in f"{item}/1".split("/")[:2])  # int takes 4,300 digits
    need("/" not in item or gcd(n, m) == 1 < m, f"{name}: not in lowest terms")
    need(is_signed or n >= 0, f"{name}: below 0")
    return n if m == 1 else Fraction(n, m)


def point(name: str, item: Any) -> Point:
    """Read a point."""
    return node(*read(name, item, [number, number]))


def ring(name: str, item: Any) -> Ring:
    """Read a ring; consecutive equal points count once."""
    points = read(name, item, [point])
    points = [p for k, p in enumerate(points) if p != points[k - 1]]
    need(len(points) > 2, f"{name}: a ring of fewer than three points")
    return points


def rings_of(shape: Any, frame: Ring | None = None) -> Rings:
    """Return the rings of a shape, inside on their left, or in a frame those of its complement."""
    rings = enumerate([shape.exterior, *shape.holes])
    found = [e[::-1] if (area(edges(e)) > 0) == bool(k) else e for k, e in rings]
    return found if frame is None else [frame, *(e[::-1] for e in found)]


def loop(name: str, item: Any, step: int = 1) -> list[Known]:
    """Read a counter-clockwise loop; return its edges, its interior on their left."""
    points = read(name, item, [point])
    around, region = edges(points[::step]), name.rpartition(".")[0]
    is_loop = len({*points}) == len(points) and area(around) * step > 0
    need(is_loop, f"{name}: a repeated point, or not counter-clockwise", *points[:1])
    return [Known(*e, name, f"{name}, edge {k}", region) for k, e in enumerate(around)]


def fit(name: str, item: Any) -> Known:
    """Read a fit; a single point gets a horizontal line."""
    p, q, line = edges(read(name, item, [point, point]))[0]
    return Known(p, q, (0, p[2], -p[1]) if p == q else line, "", name, "")


def corners(name: str, left: Rational, low: Rational, right: Rational, high: Rational) -> Ring:
    """Return the corners of a rectangle, starting at the lower left."""
    need(left < right and low < high, f"{name}: not left, bottom, right, top of a rectangle")
    return [node(left, low), node(right, low), node(right, high), node(left, high)]


def rotation(name: str, item: Any) -> Any:
    """Read a rotation: cosine and sine, or degrees if these are irrational."""
    if type(item) is list:
        found = place(point(name, item))
        need(sum(n * n for n in found) == 1, f"{name}: cosine and sine not on the unit circle")
        return found
    degrees = number(name, item) % 360
    return degrees if degrees % 90 else AXES[int(degrees) // 90]


def read_fault(name: str, item: Any) -> Any:
    """Read a fault, by its kind."""
    kind = read(name, item, dict).get("kind")
    need(type(kind) is str and kind in FAULTS, f"{name}.kind: none of {', '.join(FAULTS)}")
    return read(name, item, FAULTS[kind])


length, hole, FRAME = partial(number, is_signed=False), partial(loop, step=-1), [number] * 4
SIZE, RINGS, TURNS = (length, "0"), ([ring], list[Any]()), ([rotation], None)
SHAPE, SUMS = {"exterior": ring, "holes": RINGS}, [[int, [[int]]]]
HEAD: Any = {"format": str, "version": int, "claim": str}
LOOPS: Any = HEAD | {"exterior": loop, "holes": [hole]}
CUT: Any = {"directrix": [ring], "generatrix": [ring], "sums": SUMS}
NO_FIT = LOOPS | {"directrix": SHAPE, "generatrix": SHAPE, "exact_fits": [fit], "proof": CUT}
SWEEP = NO_FIT | {"outer": loop, "inner": hole, "unswept": [hole], "area": number}
SWEEP |= {"proof": CUT | {"swept": SUMS, "slits": [fit]}}
SUM = LOOPS | {"shape": SHAPE, "path": [point]}
SUM |= {"proof": {"shape": [ring], "sums": SUMS, "slits": [fit]}}
FRAMED = {"frame": FRAME, "outside": [ring], "part": [ring], "sums": SUMS, "around": [[int]] * 4}
INNER_FIT = HEAD | {"container": SHAPE, "part": SHAPE, "exact_fits": [fit], "proof": FRAMED}
INNER_FIT |= {"regions": [{"exterior": hole, "holes": [loop]}]}
PIECE: Any = {"points": [point], "radius": SIZE}
BODY: Any = {"exterior": (ring, None), "holes": RINGS, "pieces": ([PIECE], None), "error": SIZE}
PART = BODY | {"id": str, "demand": (int, None), "turns": TURNS, "mirrored_turns": TURNS}
PLACEMENT = {"part": str, "move": point, "turn": (rotation, "0"), "mirrored": (bool, False)}
LAYOUT: Any = {"parts": [PART | {"mirrored": (bool, True)}], "placements": [PLACEMENT]}
LAYOUT |= {"container": (BODY, {"pieces": []}), "spacing": SIZE, "margin": SIZE}
LAYOUT |= {"defects": ([BODY | {"spacing": (length, None)}], [])}
APART = {"frame": (FRAME, None), "pieces": [RINGS], "apart": [[int] * 4 + [number] * 2]}
JUDGED = HEAD | {"layout": LAYOUT, "turns": [point], "valid": bool, "proof": (APART, None)}
JUDGED |= {"faults": ([read_fault], None)}
OF_PART, OF_TWO = {"kind": str, "part": str}, {"kind": str, "placements": [int] * 2, "point": point}
FAULTS: Any = dict.fromkeys(("missing", "surplus", "mirror", "turn"), OF_PART)
FAULTS |= dict.fromkeys(("overlap", "outside", "too close"), OF_TWO)
FAULTS |= {"shape": OF_PART | {"point": point}}


def box(points: Sequence[Point], reach: Rational = 0) -> tuple[int, ...]:
    """Return left, -right, bottom, -top of a box, in units, rounded down so that it only grows."""
    at = ((x * UNITS, y * UNITS, w) for x, y, w in points)
    ends = zip(*((x // w, -x // w, y // w, -y // w) for x, y, w in at), strict=True)
    return tuple(min(end) - -(-reach * UNITS // 1) for end in ends)


def tree(boxes: list[Any], numbers: Sequence[int]) -> Any:
    """Build a tree of boxes with these numbers: (box, size, two subtrees or a number), or None."""
    around = tuple(map(min, zip(*(boxes[n] for n in numbers), strict=True)))
    if len(numbers) < 2:
        return (around, -1, numbers[0]) if numbers else None
    k, half = 0 if sum(around[:2]) < sum(around[2:]) else 2, len(numbers) // 2
    numbers = sorted(numbers, key=lambda n: boxes[n][k] - boxes[n][k + 1])
    return around, -sum(around), (tree(boxes, numbers[:half]), tree(boxes, numbers[half:]))


def near(one: Any, other: Any, more: Any = ORIGIN, touch: int = 0) -> Iterator[Any]:
    """Yield indices of boxes; the first overlaps (or touches) the sum of the other two."""
    trees = tuple(tree(boxes, range(len(boxes))) for boxes in (one, other, more))
    stack = [trees] if all(trees) else []
    while stack:
        found = ((a, b, c, d), m, x), ((f, e, h, g), n, y), ((q, p, s, r), o, z) = stack.pop()
        if a + e + p < touch and b + f + q < touch and c + g + r < touch and d + h + s < touch:
            k = 0 if m >= n and m >= o else 1 if n >= o else 2
            if found[k][1] < 0:
                yield x, y, z
            else:
                spend(2)
                stack += [(*found[:k], half, *found[k + 1 :]) for half in found[k][2]]


def canonical(line: Point) -> Point:
    """Return a line in lowest terms, regardless of its direction."""
    d = gcd(*line) * (1 if line[:2] > (0, 0) else -1) or 1
    return line[0] // d, line[1] // d, line[2] // d


def solid(name: str, rings: Rings, pieces: Rings, least: int = 1) -> Rings:
    """Require that pieces make up the shape of rings; return them."""
    need(len(pieces) >= least, f"{name}: no pieces")
    around, boxes, left = [*map(edges, pieces)], [*map(box, pieces)], Counter[Any]()
    for k, points in enumerate(pieces):
        need(is_convex(points), f"{name}, piece {k}: not convex and counter-clockwise", points[0])
    for p, q, line in chain(*around, *(edges(points[::-1]) for points in rings)):
        left.update({(canonical(line), p): 1, (canonical(line), q): -1})
    wrong = [p for (_, p), times in left.items() if times][:1]
    need(not wrong, f"{name}: edges of the pieces do not cancel to its rings", *wrong)
    for k, j, _ in near(boxes, boxes):
        spend(len(pieces[k]) * len(pieces[j]))
        lines = [(line, b) for a, b in ((k, j), (j, k)) for *_, line in around[a]]
        is_apart = k >= j or any(all(side(n, p) <= 0 for p in pieces[b]) for n, b in lines)
        need(is_apart, f"{name}: pieces {k} and {j} are not apart", pieces[k][0])
    return pieces


def inner_point(piece: Ring) -> Point:
    """Return a point inside a piece or a segment: the mean of at most three vertices."""
    x, y, w = reduce(add, piece[:3])
    return x, y, w * len(piece[:3])


def connect(pieces: Rings) -> list[Point]:
    """Return a point inside each piece that has no vertex in common with a piece before it."""
    seen, found = set[Point](), list[Point]()
    for piece in pieces:
        found += [inner_point(piece)] if seen.isdisjoint(piece) else []
        seen.update(piece)
    return found


# --- Shapes, sums and the lemma -------------------------------------------------------------------
def from_lowest(piece: Ring) -> list[Edge]:
    """Return the edges of a piece, starting at its leftmost lowest vertex."""
    points = level(piece)
    k = points.index(min(points, key=lambda p: (p[1], p[0])))
    return edges(points[k:] + points[:k])


def add_pieces(one: list[Edge], other: list[Edge]) -> list[Edge]:
    """Merge the edges of two pieces, starting at their lowest points, by direction."""
    i, j, found, lines = 0, 0, list[Point](), list[Point]()
    spend(3 * (len(one) + len(other)))
    while i < len(one) or j < len(other):
        (p, _, (a, b, _)), (q, _, (c, d, _)) = one[i % len(one)], other[j % len(other)]
        x, y, w = add(p, q)
        found.append((x, y, w))
        turn = (j == len(other)) - (i == len(one)) or a * d - b * c
        i, j = i + (turn >= 0), j + (turn <= 0)
        a, b = (a, b) if turn >= 0 else (c, d)
        lines.append((a * w, b * w, -a * x - b * y))
    return [*zip(found, found[1:] + found[:1], lines, strict=True)]


def clip(sides: Sequence[Any], a: Point, b: Point, closed: bool = False) -> Span:
    """Return the interval of parameters, 0 at a and 1 at b, left of all sides, or None."""
    (x, y, w), (u, v, z), least = a, b, 1 - closed
    # An open interval that contains 0 or 1 extends to -1 or 2.
    low, high = ((0, 1), (1, 1)) if closed else ((-1, 1), (2, 1))
    spend(4 + len(sides))
    x, y, u, v, w = x * z, y * z, u * w, v * w, w * z
    for _, _, (k, m, n) in sides:
        at_a, at_b = k * x + m * y + n * w, k * u + m * v + n * w
        if at_a < least:
            if at_b < least:
                return None
            if -at_a * low[1] > low[0] * (at_b - at_a):
                low = -at_a, at_b - at_a
        elif at_b < least and at_a * high[1] < high[0] * (at_a - at_b):
            high = at_a, at_a - at_b
    start, end = [n if m == 1 else Fraction(n, m) for n, m in (low, high)]
    return (start, not closed, end) if start < end + closed and start <= end else None


def clip_on(edge: Sequence[Any], a: Point, b: Point) -> Span:
    """Return the closed interval of a segment that is on an edge, which may be a point, or None."""
    (x, y, w), (u, v, z), (k, m, n) = edge[:3]
    ends = (m * w, -k * w, k * y - m * x), (-m * z, k * z, m * u - k * v)
    return clip([(a, b, line) for line in ((k, m, n), (-k, -m, -n), *ends)], a, b, closed=True)


def covers(spans: Iterable[Span]) -> bool:
    """Decide whether open and closed intervals cover all parameters from 0 to 1."""
    reach: tuple[Rational, bool] = (0, False)
    for low, is_open, high in sorted(filter(None, spans)):
        if low < reach[0] or (low == reach[0] and (reach[1] or not is_open)):
            reach = max(reach, (high, not is_open))
    return reach >= (1, True)


def cover_sides(name: str, sides: Any, known: list[Known], listed: Any) -> None:
    """Prove (b) and (c)."""
    along = defaultdict[Any, list[Span]](list)
    for n, (k, chains) in enumerate(listed):
        need(len(chains) == len(sides(k)), f"{name}[{n}]: not a chain for each side")
        for one, found in zip(sides(k), chains, strict=True):
            spans = list[Span]()
            for m in found:
                need(-len(known) <= m < len(listed), f"{name}[{n}]: {m} is no sum or known edge")
                if m >= 0:
                    spans.append(clip(sides(listed[m][0]), *one[:2]))
                    continue
                edge = known[-1 - m]
                spans.append(clip_on(edge, *one[:2]))
                is_left = edge.line[0] * one[2][0] + edge.line[1] * one[2][1] > 0
                way = "left" if is_left or edge.start == edge.end else "right"
                along[-1 - m, way].append(clip_on(one, *edge[:2]))
            need(covers(spans), f"{name}[{n}]: a side of it is not covered", one[0])
    for n, edge in enumerate(known):
        for way in ("left",) if edge.loop or edge.start == edge.end else ("left", "right"):
            need(covers(along[n, way]), f"{edge.name}: {name} are not along its {way}", edge.start)


def wind(name: str, known: list[Known], points: Iterable[Point], wanted: int) -> None:
    """Require that loops have the wanted winding number at points."""
    around = [edge[:3] for edge in known if edge.loop]
    for z in points:
        spend(len(around) / 2)
        times = winding(around, z)
        need(times == wanted, f"{name}: winding number {times}, expected {wanted}", z)


def boundary(name: str, d: Rings, h: Rings, known: Any, listed: Any, *beyond: Any) -> None:
    """Prove (a) to (e) of the lemma; beyond a frame are half-planes, each with its chain."""
    boxes, n = [box(edge[:2]) for edge in known], len(h)
    one, other = ([from_lowest(piece) for piece in pieces] for pieces in (d, h))

    @lru_cache(10**5 // max(map(len, d + h)) + 1)
    def sides(k: Any) -> list[Edge]:  # a half-plane, given as k, is its only side
        need(type(k) is tuple or 0 <= k < len(d) * n, f"{name}: there is no sum {k}")
        return [k] if type(k) is tuple else add_pieces(one[k // n], other[k % n])

    meetings = dict[Any, Any]()
    for k, j, _ in near(boxes, boxes, touch=1):
        e, f = known[k], known[j]
        if k != j and (k < j or e.start == e.end) and (span := clip_on(f, *e[:2])):  # points first
            is_end = e.loop != f.loop or not e.loop or e.end == f.start or e.start == f.end
            is_once = span[0] == span[2] and is_end
            if e.loop != f.loop and e.region and e.region == f.region:
                (x, y), (u, v) = place(e.start), place(e.end)
                met = x + span[0] * (u - x), y + span[0] * (v - y)
                is_once &= meetings.setdefault((e.loop, f.loop), met) == met
            need(is_once, f"{e.name}: meets {f.name}", e.start)
    for k, i, j in near(boxes, [*map(box, d)], [*map(box, h)]):
        if clip(sides(i * n + j), *known[k][:2]):
            raise Refused(f"{known[k].name}: inside the sum of pieces {i} and {j}", known[k].start)
    around = [(edge, [found]) for edge, found in beyond]
    cover_sides(name, sides, known, listed + around)
    inner = [*map(inner_point, h)] if d and len(d[0]) == 2 else connect(h)
    wind(name, known, (add(p, q) for p, q in product(connect(d), inner)), 0 if beyond else 1)


# --- Claims ---------------------------------------------------------------------------------------
def no_fit(c: Any) -> str:
    """Prove a no-fit polygon."""
    d = solid("directrix", rings_of(c.directrix), c.proof.directrix)
    g = solid("generatrix", rings_of(c.generatrix), c.proof.generatrix)
    known = [*c.exterior, *chain(*c.holes), *c.exact_fits]
    boundary("sums", d, [[(-x, -y, w) for x, y, w in e] for e in g], known, c.proof.sums)
    return f"no-fit polygon of {len(known)} edges and exact fits"


def sweep(c: Any) -> str:
    """Prove the no-fit polygon and the swept area of a sweep."""
    found, segments = no_fit(c), [[*e[:2]] for e in c.exterior]
    loops = [*c.outer, *c.inner, *chain(*c.unswept)]
    boundary("swept", segments, c.proof.generatrix, loops + c.proof.slits, c.proof.swept)
    wind("inner, at the directrix", c.inner, [inner_point(c.proof.directrix[0])], -1)
    need(c.area == area(loops), "area: differs")
    return f"sweep of {len(loops)} edges; {found}"


def path_sum(c: Any) -> str:
    """Prove the sum of a shape and a path."""
    h = solid("shape", rings_of(c.shape), c.proof.shape)
    segments = [[p, q] for p, q in pairwise(c.path) if p != q]
    known = [*c.exterior, *chain(*c.holes), *c.proof.slits]
    boundary("sums", segments, h, known, c.proof.sums)
    return f"sum of a shape and a path of {len(segments)} segments: {len(known)} edges and slits"


def inner_fit(c: Any) -> str:
    """Prove an inner fit."""
    proof, ends, known = c.proof, c.proof.frame, list[Known]()
    d = solid("outside", rings_of(c.container, corners("frame", *ends)), proof.outside, 0)
    h = [[(-x, -y, w) for x, y, w in e] for e in solid("part", rings_of(c.part), proof.part)]
    for region in c.regions:
        own = [*region.exterior, *chain(*region.holes)]
        for hole in region.holes:  # a point on a downward edge counts as inside
            p, q = next(e[:2] for e in hole if e.line[0] > 0)
            wind(hole[0].loop, own, map(inner_point, ([p, q], [p, p, q])), 0)
        known += own
    known += c.exact_fits
    xs, ys = zip(*map(place, chain(*h)), strict=True)
    room = [n + f(of) for n, f, of in zip(ends, (max, max, min, min), (xs, ys) * 2, strict=True)]
    beyond = [(q, p, (-a, -b, -c)) for p, q, (a, b, c) in edges(corners("frame, part", *room))]
    for edge, out in product(known, beyond):
        need(not clip([out], *edge[:2]), f"{edge.name}: the part leaves the frame", edge.start)
    boundary("sums", d, h, known, proof.sums, *zip(beyond, proof.around, strict=True))
    return f"inner fit of {len(known)} edges and exact fits in {len(c.regions)} regions"


# A solid is (rings, radius): a convex piece, or the rings of a shape. Inside is a winding number.
Body = namedtuple("Body", "name solids error distance inside")


def find_body(given: Any, cut: Rings, distance: Rational, frame: Ring | None) -> Body:
    """Return a part, a defect, or the complement of a container, in pieces if there is a frame."""
    name, is_part, rounded = given.name, given.name != "layout.container", given.pieces or []
    is_count = rounded if is_part else len(rounded) < 2
    is_alone = is_count and not (given.exterior or given.holes or cut)
    is_body = given.exterior if given.pieces is None else is_alone
    need(is_body, f"{name}: neither a shape nor rounded pieces alone, one for a container")
    for e in rounded:
        is_piece = is_convex(e.points) if len(e.points) > 2 else e.points
        need(is_piece, f"{e.name}: not convex and counter-clockwise", *e.points[:1])
    solids = [([level(e.points)], e.radius if is_part else -e.radius) for e in rounded]
    if given.exterior:
        solids = [(rings_of(given, None if is_part else frame or []), 0)]
        if frame is not None:
            solids = [([level(e)], 0) for e in solid(name, solids[0][0], cut, is_part)]
    return Body(name, solids, given.error, distance, int(is_part))


def rotation_error(to: Any, degrees: Rational) -> Rational:
    """Bound |cos - cos'| + |sin - sin'| for a rotation and an angle by the power series."""
    unit = 10**110
    angle = int(Fraction(PI) * degrees / 180 * unit)
    terms = [*accumulate(range(1, 300), lambda e, k: e * angle // (unit * k), initial=unit)]
    near_to = [Fraction(sum(terms[k::4]) - sum(terms[k + 2 :: 4]), unit) for k in (0, 1)]
    return sum((abs(n - m) for n, m in zip(to, near_to, strict=True)), Fraction(1, 10**88))


def put(part: Body, to: Any, rotation: Any) -> Body:
    """Return a placed part: mirrored, rotated and translated."""
    points, error = [*chain(*chain(*(rings for rings, _ in part.solids)))], part.error
    flip, (c, s, r), (u, v, z) = (-1) ** to.mirrored, node(*rotation), to.move
    spend(20 + 20 * len(points))
    if rotation != to.turn:
        is_near = type(to.turn) is not tuple and sum(n * n for n in rotation) == 1
        need(is_near, f"{to.name}: its entry in turns is a different rotation")
        error += max(sum(map(abs, place(p))) for p in points) * rotation_error(rotation, to.turn)

    def move(points: Ring) -> Ring:
        at = ((flip * x * z, y * z, w * r) for x, y, w in points[::flip])
        return [(c * x - s * y + u * w, s * x + c * y + v * w, w * z) for x, y, w in at]

    solids = [([*map(move, rings)], radius) for rings, radius in part.solids]
    return part._replace(name=f"{to.name} of {to.part[:40]!a}", error=error, solids=solids)


def find_broken(part: Any, used: list[tuple[Any, bool]]) -> Iterator[str]:
    """Yield the rules of a part that its rotations and mirrorings violate."""
    demand, other = len(used) if part.demand is None else part.demand, part.mirrored_turns
    need(demand >= 0, f"{part.name}.demand: below 0")
    yield from ["missing"] * (len(used) < demand) + ["surplus"] * (len(used) > demand)
    yield from ["mirror"] * (not part.mirrored and any(flag for _, flag in used))
    for flag, allowed in ((False, part.turns), (True, part.turns if other is None else other)):
        asked = {turn for turn, is_mirrored in used if is_mirrored is flag}
        yield from ["turn"] * (allowed is not None and not asked <= {*allowed})


def gap(one: Ring, other: Ring, normal: Sequence[int], distance: Rational) -> bool:
    """Decide whether a normal proves that two pieces are at least `distance` apart."""
    (x, y), w, v, (n, m) = normal, one[0][2], other[0][2], distance.as_integer_ratio()
    spend(7 + len(one) + len(other))
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


def is_inside(body: Body, p: Point, depth: Rational) -> bool:
    """Decide whether a point is deeper in a body than a depth, which may be negative."""
    found, (x, y) = False, place(p)
    for rings, radius in body.solids:
        around, squared, more = [*chain(*map(edges, rings))], list[Rational](), depth - radius
        spend(60 * len(around))
        for (a, b), (c, d) in outline(around):
            u, v, along = c - a, d - b, (c - a) * (x - a) + (d - b) * (y - b)
            at = min(along / (u * u + v * v), Fraction(1)) if along > 0 else 0
            squared.append((a + at * u - x) ** 2 + (b + at * v - y) ** 2)
        sign = 1 if winding(around, p) == body.inside else -1
        found |= sign * min(squared) > more * abs(more)
    return found


def prove_valid(bodies: dict[int, Body], frame: Ring, normals: dict[Any, Any]) -> None:
    """Prove that placements are in the container, and apart from each other and obstacles."""
    listed = [(a, one) for a, one in bodies.items() if a != -1 or frame]
    found = [(a, i, one, *rings, r) for a, one in listed for i, (rings, r) in enumerate(one.solids)]
    beyond, reach = bodies[-1], max(one.distance for one in bodies.values()) / Fraction(2)
    for _, _, one, points, radius in (e for e in found if e[0] >= 0):
        room = beyond.distance + one.error + beyond.error + radius
        is_in = all(gap([p], points, n, room) for p, n in zip(frame, AXES, strict=False))
        is_out = not frame and any(is_inside(beyond, p, -room) for p in points)
        need(is_in and not is_out, f"{one.name}: not in the container", points[0])
    boxes = [box(points, reach + one.error + radius) for _, _, one, points, radius in found]
    for k, m, _ in near(boxes, boxes):
        (a, i, one, points, r), (b, j, other, others, s) = found[k], found[m]
        if a < b and b >= 0:
            far = r + s + one.error + other.error + one.distance
            known = normals.get((a, i, b, j)) or normals.get((a, -1, b, -1)) or AXES[0]
            is_apart = any(gap(points, others, n, far) for n in (known, *AXES))
            reason = f"{one.name}, piece {i}: not apart from {other.name}, piece {j}"
            need(is_apart, reason, others[0])


def prove_fault(fault: Any, parts: Any, broken: Any, bodies: dict[int, Body]) -> None:
    """Prove a fault of a part or of two bodies."""
    name, kind, is_close = fault.name, fault.kind, fault.kind == "too close"
    if "part" in FAULTS[kind]:
        need(fault.part in parts, f"{name}: unknown part")
        is_broken = (kind, fault.part) in broken
        if kind == "shape":
            solids = [[*chain(*map(edges, rings))] for rings, _ in parts[fault.part].solids]
            spend(4 * sum(map(len, solids)))
            is_broken = any(winding(around, fault.point) not in (0, 1) for around in solids)
        need(is_broken, f"{name}: the part has no such fault")
        return
    (a, b), point = fault.placements, fault.point
    is_kind = is_close or kind == ("outside" if b < 0 else "overlap")
    are_bodies = is_kind and a >= 0 and a != b and {a, b} <= bodies.keys()
    need(are_bodies, f"{name}: not {kind} of two bodies")
    room = bodies[b].distance - bodies[a].error - bodies[b].error
    need(room > 0 or not is_close, f"{name}: the errors leave no room", point)
    for body in (bodies[a], bodies[b]):
        is_there = is_inside(body, point, -room / Fraction(2) if is_close else body.error)
        need(is_there, f"{name}: not inside {body.name}, or not near enough", point)


def find_bodies(c: Any) -> tuple[dict[str, Body], dict[int, Body], Ring | None]:
    """Return the parts, all bodies, and the frame of a layout; in a proof, parts are in pieces."""
    given, proof, count = c.layout, c.proof, len(c.layout.parts)
    shapes = [*given.parts, given.container, *given.defects]
    cut, frame = [Rings()] * len(shapes), None
    if proof:
        cut, frame = proof.pieces, corners("frame", *proof.frame) if proof.frame else Ring()
        need(bool(frame) == (given.container.pieces is None), "frame: missing or superfluous")
    need(len(cut) == len(shapes), f"proof.pieces: not a list of {len(shapes)} entries")
    need(len(c.turns) == len(given.placements), "turns: not one for each placement")
    far = [given.spacing] * count + [given.margin]
    far += [given.margin if e.spacing is None else e.spacing for e in given.defects]
    made = [find_body(*e, frame) for e in zip(shapes, cut, far, strict=True)]
    parts = {e.id: body for e, body in zip(given.parts, made[:count], strict=True)}
    need(len(parts) == count, "parts: ids are not unique")
    bodies = {-1 - k: body for k, body in enumerate(made[count:])}
    for k, (to, turn) in enumerate(zip(given.placements, c.turns, strict=True)):
        need(to.part in parts, f"{to.name}: unknown part")
        bodies[k] = put(parts[to.part], to, place(turn))
    return parts, bodies, frame


def layout(c: Any) -> str:
    """Prove that a layout is valid or has faults."""
    used, name = defaultdict[str, Any](list), f"layout of {len(c.turns)} placements"
    is_known = [c.valid, not c.valid] == [c.proof is not None, c.faults is not None]
    need(is_known and c.faults != [], "valid: neither true with a proof nor false with faults")
    parts, bodies, frame = find_bodies(c)
    for to in c.layout.placements:
        used[to.part].append((to.turn, to.mirrored))
    broken = {(rule, e.id) for e in c.layout.parts for rule in find_broken(e, used[e.id])}
    if c.valid:
        need(not broken, f"valid, but rules are violated: {sorted(broken)[:3]!a}")
        normals = {tuple(key): node(x, y)[:2] for *key, x, y in c.proof.apart}
        prove_valid(bodies, frame or [], normals)
        return f"{name}, valid"
    for fault in c.faults:
        prove_fault(fault, parts, broken, bodies)
    return f"{name}, not valid: {len(c.faults)} faults"


PROVERS: Any = {"no_fit": (NO_FIT, no_fit), "sweep": (SWEEP, sweep), "sum": (SUM, path_sum)}
PROVERS |= {"inner_fit": (INNER_FIT, inner_fit), "layout": (JUDGED, layout)}


def prove(certificate: Any, max_steps: float | None = None) -> str:
    """Prove a certificate that `load` returns and describe it, or raise Refused."""
    need(type(certificate) is dict, "not an object")
    name, version, claim = (certificate.get(key) for key in HEAD)
    need(type(name) is str and name == FORMAT, f"format: not {FORMAT!r}")
    need(type(version) is int and version == VERSION, f"version: not {VERSION}")
    need(type(claim) is str and claim in PROVERS, f"claim: none of {', '.join(PROVERS)}")
    form, prover = PROVERS[claim]
    found = read("", certificate, form)
    text = json.dumps({**certificate, "area": None}, ensure_ascii=False)  # escapes are longer
    WORK.set([max_steps or max(MAX_STEPS, STEPS_PER_BYTE * len(text)), 1.0])
    level([(10 ** max(map(len, re.findall("[0-9]+", text))), 0, 1)])
    return str(prover(found))


def load(text: str) -> Any:
    """Read JSON without duplicate keys."""

    def once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        need(len(dict(pairs)) == len(pairs), "duplicate key")
        return dict(pairs)

    return json.loads(text, object_pairs_hook=once)


def main(arguments: list[str]) -> int:
    """Print what a certificate proves; return the exit code."""
    try:
        [file] = arguments
        print(f"proved: {prove(load(Path(file).read_text(encoding='utf-8-sig')))}")
    except Exception as error:  # a crash proves nothing
        print(f"not proved: {error}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
