"""Checker of certificates: one file that needs Python's standard library alone, to be read.

`CERTIFICATES.md` says what is read. A checker adds up; it never searches. Points are homogeneous,
ints (x, y, w) for (x/w, y/w) with w > 0; left of a line (a, b, c) is a x + b y + c w > 0. Layouts,
positions and sweeps with a shared direction have a section each. Read one of these and the sections
"Reading" and "Points, lines and rings"; the first two need "Shapes and pieces", too, and the last
two "Areas and answers".

1. Pieces. The rings of a shape are simple and do not cross, holes are inside the exterior and in no
   other hole, and a circle of rings that touch, which would part the interior, is refused: so the
   winding number of the rings, holes clockwise, is 1 in its interior, which is connected, and 0
   outside. Convex rings make it up if their edges cancel to those of its rings. Then their
   indicators add up to that winding number almost everywhere: they are the shape, without overlap.
2. Layouts. Two shapes are s apart if for any two pieces a, b of them there is a normal n with
   gap = min n.b - max n.a >= 0 and gap^2 >= s^2 |n|^2. The container is a shape, too: what a frame
   has outside it. A turn by an irrational angle is a rational one that is off by e, which moves a
   point at r by at most e r; so much is added to s.
3. Positions. O, the positions t at which the interiors of D and G + t meet, is the union of the
   open sums D_i + H_j of their pieces, H = -G: interiors that meet have an open set in common, and
   the cuts between pieces hold none. The interiors of D and H are connected, and so is O. Let L be
   all loops, walked with O on their left, and fits; let U be the union of the sums that are listed.
   (a) No sum has a point of an edge of L.
   (b) The sides of listed sums are covered, end to end, by listed sums and edges of L. So all of
       the boundary of U is in L: a component of the plane without L is in U or apart from U.
   (c) Listed sums have a side along the left of each loop, and along both sides of each fit, but
       for points. No edge of L is along another. A fit of one point is on a side, and on no other
       edge of L: all around it is U.
   O is connected and avoids L, so O is U. Let W be the sum of the winding numbers of all loops. It
   is the same on all of O, and one less right of each loop, where O is not. A point far away is not
   in U, so it is right of a loop; there W is 0, and it is 1 on O. Each component of the plane
   without L is beside an edge of L: in U, or right of a loop. So off L, O is where W is 1. As O is
   connected, its loops meet like the rings of a cactus, and are simple in one way only.
4. Inner fits are 3 with D all that is outside the container. A frame holds it; B are the positions
   at which G is in the frame. Beyond B there is O, and its four half-planes are listed as well; (b)
   is asked of the edges of B, too, and L is in B. O may have components, the sums of H and of what
   is connected in D. So W, which is 0 far away, has to be 0 at one point of D_i + H for every i,
   which is connected; then it is 0 on O and left of each loop, -1 right of it: off L, O is where W
   is 0. Each region is a shape by (1), and no loop passes its interior, where its own rings make W
   -1: so regions are the components of the rest, and are written in one way only.
5. Sweeps of any shape. T, the trajectory, is the exterior of 3. T + G is the closure of the sums of
   the edges of T and pieces of G. The union of these is connected: T + G_j is, and along a cut of G
   two of them meet, at an edge of T that is not parallel to the cut. So 3 serves again, with the
   edges of T for the pieces of D, and slits, positions between sums, for fits. The inner loop is
   the one around D.
6. Sweeps with a shared direction, turned to be x. P = D + H is bounded by the trajectory T, P + G
   by the outer loop, E, the points p with p + H in P, by the inner loop. All five loops are simple
   and weakly monotone to x: each line square to x meets a loop's region in one piece. It meets P
   and P + G in one piece, for sections of sums are sums of sections, and E, for E is common to all
   P - h. A loop is simple if its lower chain is below its upper one, from both sides of each jump.
   (a) T is in P: its edges are covered by contacts, sums of a feature of D and one of H. So its
       region is in P, and P is in its region by (e).
   (b) The outer loop is the same with T and G for D and H. For T + G is P + G less the inside of E,
       the swept area: p is in T + G if p + H, which is connected, meets T, so unless p + H avoids P
       or is inside P.
   (c) The region Q of the inner loop is in E, for Q + H is in P by (e). Its edges are covered by
       sums t + g with t on T. None is inside E, or t would be inside P. E holds D and is no wider,
       so its inside is connected: each section leads to D. It meets Q, as Q is in E, but not the
       edges of Q, so it is in Q.
   (d) Contacts are listed, all of them: of each edge of T the sums of two edges, or of an edge and
       a corner between whose edges its way is, that have more than a point of it. There the least
       sum in (e) is attained, so they are among the edges of sums of parts. Two vertical edges of
       one way, of a lower and of an upper chain, are no contact, for their sum is inside P: let a
       point of the lower chain move up, and one of the upper as far down, to the other side; to
       the left or to the right, both get inside.
   (e) A + B is in Q, for regions of loops. The lower chain of A + B at x is the least sum A(u) +
       B(x - u), with the lower ends of jumps. Where it is attained, A at u and B at x - u have a
       slope in common, or to move u would make it less: a left turn has all slopes from the one
       before to the one after it, without bound at jumps and ends; beside a right turn the other
       chain has both its slopes. So cut both chains at right turns into convex parts. The chain of
       A + B is on sums of two parts: their edges by slope, of the slopes that both have. A + B is
       in Q if Q is as wide as these, and its lower chain is nowhere above them: at both ends of all
       x along which edges of both are straight. Upper chains are turned by half a turn.
   (f) Exact fits. The lower chains of D and H leave G free to slide up at x as far as the least
       A(u) + B(x - u) inside intervals, past both one-sided limits of s, which is T, at x. Where A
       and B both jump, each limit of s counts one pair of values more: after both fell, or before
       both rise. To be less, each needs such a pair: so x is a sum of two falls and of two rises,
       ends included.
"""

from __future__ import annotations

import json
import re
import sys
from bisect import bisect_left, bisect_right
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import chain, pairwise, product
from math import gcd, inf, isqrt, lcm
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

FORMAT, VERSION, MAX_DIGITS, MAX_STEPS = "exactsweep certificate", 2, 10**6, 10**8
PI = Fraction(  # cut off after 99 decimals
    31415926535897932384626433832795028841971693993751 * 10**50
    + 5820974944592307816406286208998628034825342117067,
    10**99,
)
UNREAD = {"contacts", "inner_drawn", "outer_drawn", "area"}
BOX = (1, 0), (0, 1), (-1, 0), (0, -1)
NUMBER = re.compile("-?(0|[1-9][0-9]*)(/[1-9][0-9]*)?")
NONE, ALL, NOWHERE = Fraction(0), (Fraction(-1), Fraction(2)), (Fraction(2), Fraction(-1))

Rational = Fraction | int
Node = tuple[int, int, int]
Grid = tuple[int, int, int, int]
Ring = list[Node]
Edge = tuple[Node, Node]
Span = tuple[Fraction, Fraction]
Extent = tuple[Rational, Rational]
Contact = tuple[str, int, int]
Side = tuple[Any, Node, Node, Node]
Tree = tuple[Grid, int, Any]
T = TypeVar("T")


# --- Reading --------------------------------------------------------------------------------------


class Refused(Exception):  # noqa: N818
    """The first reason for which a certificate is not proved, and perhaps a point that shows it."""

    def __init__(self, reason: str, witness: Span | None = None) -> None:
        super().__init__(reason)
        self.witness = witness


class Work:
    """The budget of steps that is left, how many one takes, and the scale of the boxes."""

    def __init__(self, steps: float) -> None:
        self.left, self.weight, self.scale, self.numbers = steps, 1, 1, 0
        self.reason = f"too large: to check it would take more than {steps} steps"

    def take(self, steps: int, bits: int = 0) -> None:
        """Take steps, on numbers of so many bits if these are given, or refuse the certificate."""
        self.left -= steps * (weight(bits) if bits else self.weight)
        need(self.left >= 0, self.reason)

    def read(self, item: Any, levels: int = 7) -> int:
        """Take the steps of reading an object or a list; return its longest number's digits."""
        self.take(1 + len(item) // 8)
        longest = 0
        for part in item.values() if type(item) is dict else item:
            kind, digits = type(part), 0
            if kind is str:
                self.numbers += 1
                digits = len(part)
            elif kind is int:
                digits = part.bit_length() // 3
            elif kind in (dict, list) and levels:
                longest = max(longest, self.read(part, levels - 1))
            if digits > 99:  # to parse it, and to see that it is in lowest terms
                self.take(digits * isqrt(digits) // 1000 + digits**2 // 400_000)
            longest = max(longest, digits)
        return longest

    def fit(self, rings: list[Ring]) -> None:
        """Choose a scale for shapes like these."""
        xs = [Fraction(x, w) for points in rings for x, _, w in points]
        self.scale = int(2**30 / (max(xs) - min(xs) or 1)) + 1


def weight(bits: int) -> int:
    """Return how many steps one on numbers of so many bits takes."""
    words = 1 + bits // 64
    return words + words * words // 1000


def need(condition: bool, reason: str) -> None:
    """Refuse the certificate unless a condition holds."""
    if not condition:
        raise Refused(reason)


def fields(item: Any, names: str, optional: str = "") -> list[Any]:
    """Take an object apart by its keys; those that may be left out come as None."""
    need(type(item) is dict, f"not an object with {names}")
    known, missing = f"{names} {optional}".split(), sorted({*names.split()} - item.keys())
    need(not missing, f"keys are missing: {', '.join(missing)}")
    need(item.keys() <= {*known}, "there are unknown keys")
    return [item.get(name) for name in known]


def items(item: Any, length: int | None = None) -> list[Any]:
    """Require a list, of a length if one is given."""
    need(type(item) is list and length in (None, len(item)), "not a list of the right length")
    return list(item)


def under(name: str, read: Callable[..., T], *given: Any) -> T:
    """Read what is under a key, or name that in the reason."""
    try:
        return read(*given)
    except Refused as refused:
        raise Refused(f"{name}: {refused}") from None


def integer(item: Any, low: int, end: float = inf) -> int:
    """Require an int from low on, and below an end if one is given."""
    need(type(item) is int and low <= item < end, "not an int in its range")
    return int(item)


def number(item: Any) -> Rational:
    """Read a rational in lowest terms from a string."""
    is_short = type(item) is str and len(item) <= MAX_DIGITS
    need(is_short and item != "-0" and bool(NUMBER.fullmatch(item)), "not a number in a string")
    if "/" not in item:
        return whole(item)
    above, below = map(whole, item.split("/"))
    need(gcd(above, below) == 1 < below, "a number not in lowest terms")
    return Fraction(above, below)


def whole(digits: str) -> int:
    """Read an int, by halves if it is too long for int."""
    half = len(digits) // 2
    if half < 1000:
        return int(digits)
    high: int = whole(digits[:-half]) * 10**half
    return high - whole(digits[-half:]) if digits[0] == "-" else high + whole(digits[-half:])


def node(x: Rational, y: Rational) -> Node:
    """Return a point, in short ints."""
    w = lcm(x.denominator, y.denominator)
    return x.numerator * (w // x.denominator), y.numerator * (w // y.denominator), w


def point(item: Any) -> Node:
    """Read a point."""
    return node(*map(number, items(item, 2)))


def read_fits(item: Any) -> list[Edge]:
    """Read pairs of points."""
    return [(point(p), point(q)) for p, q in (items(fit, 2) for fit in items(item))]


def least_first(item: Any) -> Ring:
    """Read a list of at least three points, the least one first."""
    points = [*map(point, items(item))]
    need(len(points) > 2, "fewer than three points")
    x, y, w = points[0]
    least = all((x * v, y * v) <= (s * w, t * w) for s, t, v in points)
    need(least, "not canonical, the least point is not the first")
    return points


def drop_repeated(points: Ring) -> Ring:
    """Return a ring in which points that are repeated one after the other count once."""
    found = [p for k, p in enumerate(points) if p != points[k - 1]]
    need(len(found) > 2, "a ring of fewer than three points")
    return found


def ring(item: Any) -> Ring:
    """Read a ring."""
    return drop_repeated([point(entry) for entry in items(item)])


def shape(item: Any, optional: str = "") -> list[Ring]:
    """Read the rings of a shape, its interior on their left."""
    exterior, holes = fields(item, "exterior", f"holes {optional}")[:2]
    rings = [ring(exterior), *map(ring, [] if holes is None else items(holes))]
    return [one[::-1] if (double_area(one) > 0) == bool(k) else one for k, one in enumerate(rings)]


# --- Points, lines and rings ----------------------------------------------------------------------


def reduce(a: int, b: int, c: int) -> Node:
    """Return a line, or a point, in short ints."""
    d = gcd(c, a, b) or 1
    return a // d, b // d, c // d


def line(p: Node, q: Node) -> Node:
    """Return the line from one point to another, in short ints."""
    a, b, c = p[1] * q[2] - q[1] * p[2], q[0] * p[2] - p[0] * q[2], p[0] * q[1] - q[0] * p[1]
    return reduce(a, b, c)


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


def edges(points: Sequence[Node]) -> list[Edge]:
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
    return side(line(a, b), p) == 0 and sorted(map(place, (a, p, b)))[1] == place(p)


def winding(known: list[Edge], p: Node) -> int:
    """Return how many times edges of rings go around a point, which is on none of them."""
    found = 0
    for a, b in known:
        is_up, ends = a[1] * p[2] <= p[1] * a[2], b[1] * p[2] <= p[1] * b[2]
        if is_up != ends:
            at = side(line(a, b), p)
            found += is_up * (at > 0) - ends * (at < 0)
    return found


def by_way(u: Sequence[int], v: Sequence[int]) -> int:
    """Return a number above 0 if a way, or that of a line, is before another, 0 if both are one.

    Both are in one half-turn. It may be closed for lines, which then go from down to up.
    """
    return u[0] * v[1] - u[1] * v[0] or (u[0] > 0 > v[0]) - (v[0] > 0 > u[0])


def merge(u: Sequence[Any], v: Sequence[Any]) -> list[tuple[int, int]]:
    """Return how many of each of two lists of ways, by angle, are before each of both, and all."""
    i, j, found = 0, 0, [(0, 0)]
    while i < len(u) or j < len(v):
        left = (j == len(v)) - (i == len(u)) or by_way(u[i], v[j])
        i, j = i + (left >= 0), j + (left <= 0)
        found.append((i, j))
    return found


def tell(listed: Sequence[Any], what: str) -> str:
    """Tell how many there are."""
    return f"{len(listed)} {what}{'s' * (len(listed) != 1)}"


def count(rings: Sequence[Sequence[Any]]) -> int:
    """Count the entries of lists."""
    return sum(map(len, rings))


def grid_box(points: Sequence[Node], scale: int) -> Grid:
    """Return the box of points times a scale: left, right, lower, upper end, rounded outwards."""
    xs, ys = ([(p[k] * scale, p[2]) for p in points] for k in (0, 1))
    low, high = ((min(n // w for n, w in at), max(-(-n // w) for n, w in at)) for at in (xs, ys))
    return low + high


def are_near(one: Grid, other: Grid, reach: int = 0) -> bool:
    """Return whether boxes are no more than a reach apart, in x and in y."""
    in_x = one[0] <= other[1] + reach and other[0] <= one[1] + reach
    return in_x and one[2] <= other[3] + reach and other[2] <= one[3] + reach


def list_near(boxes: list[Grid], reach: int, work: Work) -> Iterator[tuple[int, int]]:
    """List pairs of boxes no more than a reach apart, the lower number first."""
    ends = [*zip(*boxes, strict=True)] or [(0,)] * 4
    low = 2 * (max(ends[3]) - min(ends[2]) > max(ends[1]) - min(ends[0]))  # along the longer side
    order = sorted(range(len(boxes)), key=lambda k: boxes[k][low:])
    for n, a in enumerate(order):
        for b in order[n + 1 :]:
            work.take(1)
            if boxes[b][low] > boxes[a][low + 1] + reach:
                break
            if are_near(boxes[a], boxes[b], reach):
                yield min(a, b), max(a, b)


# --- Shapes and pieces, by (1) --------------------------------------------------------------------


def do_cross(p: Node, q: Node, r: Node, s: Node) -> bool:
    """Return whether two edges cross in their middles."""
    one, other = line(p, q), line(r, s)
    return side(one, r) * side(one, s) < 0 and side(other, p) * side(other, q) < 0


def do_clash(p: Node, q: Node, r: Node, s: Node, apart: int, count: int) -> bool:
    """Return whether two edges of a ring, so many apart, keep it from being simple."""
    if apart in (1, count - 1):  # neighbours: one must not go back along the other
        (a, b), c = ((p, q), s) if q == r else ((r, s), q)
        return lies(c, a, b) or lies(a, b, c)
    touch = lies(p, r, s) or lies(q, r, s) or lies(r, p, q) or lies(s, p, q)
    return touch or do_cross(p, q, r, s)


def solid(rings: list[Ring], item: Any, work: Work, frame: Ring | None = None) -> list[Ring]:
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
    check_shape(rings, work)
    return pieces


def check_shape(rings: list[Ring], work: Work) -> None:
    """Refuse rings unless they are simple, an exterior and holes, the interior in one piece."""
    around = [(k, n, e) for k, points in enumerate(rings) for n, e in enumerate(edges(points))]
    meetings: dict[Node, set[int]] = {}
    for a, b in list_near([grid_box(e, work.scale) for *_, e in around], 0, work):
        (k, n, one), (j, m, other) = around[a], around[b]
        clash = k == j and do_clash(*one, *other, m - n, len(rings[k]))
        need(not clash, "a ring is not simple")
        need(k == j or not do_cross(*one, *other), "rings of a shape cross")
        work.take(8 * (k != j))
        for p in (*one, *other) if k != j else ():
            if lies(p, *one) and lies(p, *other):
                meetings.setdefault(p, set()).update((k, j))
    parts = list(range(len(rings)))
    for on in meetings.values():
        work.take(len(rings))
        met = [parts[k] for k in on]
        need(len({*met}) == len(met), "the interior of a shape falls apart")
        parts = [met[0] if part in met else part for part in parts]
    # Two rings have at most one point in common by now, so that any other tells.
    near = [*list_near([grid_box(points, work.scale) for points in rings], 0, work)]
    within = [(k, 0) for k in range(1, len(rings))]
    for k, j in (*within, *((k, j) for pair in near if pair[0] for k, j in (pair, pair[::-1]))):
        work.take(len(rings[j]))
        of = edges(rings[j])
        free = next(p for p in rings[k] if not any(lies(p, *e) for e in of))
        need((winding(of, free) != 0) == (j == 0), "a hole is not in its exterior, or in another")


def frame(left: Rational, low: Rational, right: Rational, high: Rational) -> Ring:
    """Return a rectangle."""
    need(left < right and low < high, "frame: not the ends of a rectangle")
    return [node(left, low), node(right, low), node(right, high), node(left, high)]


# --- Layouts, by (2) ------------------------------------------------------------------------------


class Placed(NamedTuple):
    """Pieces where they are, all their points, boxes of both, and how far off points may be."""

    pieces: list[Ring]
    points: Ring
    boxes: list[Grid]
    error: Fraction

    def holds(self, k: Any, p: Node, closed: bool) -> bool:
        """Return whether a point is in a piece, or so far inside that the error does not matter."""
        sides = [line(*e) for e in edges(self.pieces[integer(k, 0, len(self.pieces))])]
        found = [(Fraction(side(of, p), p[2]), of[0] ** 2 + of[1] ** 2) for of in sides]
        if closed:
            return all(h >= 0 for h, _ in found)
        return all(h > 0 and h**2 > self.error**2 * square for h, square in found)


def move_ring(points: Ring, turn: Span, mirrored: bool, move: Node) -> Ring:
    """Mirror, turn and move a ring; mirrored it would go around the other way."""
    r = turn[0].denominator  # of both, since the squares add up to 1
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
        values = fields(c, head, "format version kind")[:8]
        layout, self.valid, turns, ends, cut, outside, *lists = values
        keys = "container parts placements", "spacing margin"
        container, parts, placements, *gaps = fields(layout, *keys)
        self.gaps = ["0" if gap is None else gap for gap in gaps]
        self.spacing, self.margin = map(number, self.gaps)
        self.work, (self.apart, self.faults) = work, map(items, lists)
        self.frame = frame(*map(number, items(ends, 4)))
        need(type(self.valid) is bool, "valid: neither true nor false")
        need(not self.valid or None not in (outside, *items(cut)), "pieces: some are missing")
        need(self.spacing >= 0 <= self.margin, "a spacing or a margin below 0")
        work.fit([self.frame])

        rules = "demand turns mirrored"
        self.parts = [fields(part, "id exterior", f"holes {rules}") for part in items(parts)]
        self.ids = [part[0] for part in self.parts]
        need({*map(type, self.ids)} <= {str}, "parts: ids are strings, each of one part")
        self.numbers = {name: k for k, name in enumerate(self.ids)}
        need(len(self.numbers) == len(self.ids), "parts: ids are strings, each of one part")
        self.rings = [shape(part, f"id {rules}") for part in parts]
        both = zip(items(cut, len(parts)), self.rings, strict=True)  # pragma: no mutate: as long
        pieces = [[] if e is None else solid(rings, e, work) for e, rings in both]
        self.facts: list[list[tuple[Any, bool]]] = [[] for _ in self.ids]
        self.placed: list[Placed] = []
        for item, rational in zip(items(placements), items(turns, len(placements)), strict=True):
            name, asked, move, mirrored = fields(item, "part turn move", "mirrored")
            need(type(name) is str and name in self.numbers, "placements: of no part")
            need(type(mirrored) in (type(None), bool), "mirrored: neither true nor false")
            k, turn, to = self.numbers[name], read_turn(asked), read_turn(items(rational))
            work.take(1 + 4 * (count(self.rings[k]) + count(pieces[k])))
            far = max(sum(map(abs, place(p)), NONE) for points in self.rings[k] for p in points)
            error = NONE if type(turn) is tuple else far * turn_error(to, turn)
            need(error > 0 or turn == to, "turns: not the turn of the placement")
            self.facts[k].append((turn, bool(mirrored)))
            by = point(move)
            self.put([move_ring(e, to, bool(mirrored), by) for e in pieces[k]], error)
        # All that is outside comes last, for its number is -1.
        within = shape(container)
        if outside is None:
            check_shape(within, work)
        self.put([] if outside is None else solid(within, outside, work, self.frame), NONE)

    def put(self, pieces: list[Ring], error: Fraction) -> None:
        """Put pieces where they are."""
        points = list(chain.from_iterable(pieces))
        boxes = [grid_box(of, self.work.scale) for of in (*pieces, points) if of]
        self.placed.append(Placed(pieces, points, boxes, error))

    def prove(self) -> str:
        """Prove the claim, and describe it."""
        found = f"layout of {tell(self.placed[1:], 'placement')} of {tell(self.ids, 'part')}"
        rules = chain.from_iterable(self.check_rules(k).items() for k in range(len(self.ids)))
        broken = [kind for kind, holds in rules if holds]
        if not self.valid:
            need(self.faults != [] == self.apart, "faults: none, or normals beside them")
            proved = {self.prove_fault(fault) for fault in self.faults}
            need(len(proved) == len(self.faults), "faults: one is there twice")
            return f"{found}, not valid: {tell(self.faults, 'fault')}"
        need(self.faults == [], "faults: of a valid layout")
        need(broken == [], f"a part breaks rules: {broken}")
        self.prove_apart()
        # As written: str refuses long ints.
        return f"{found}, valid, spacing {self.gaps[0]}, margin {self.gaps[1]}"

    def check_rules(self, k: int) -> dict[str, bool]:
        """Return which rules the placements of part k break."""
        demand, turns, mirrored = self.parts[k][3:]
        need(type(mirrored) in (type(None), bool), "mirrored: neither true nor false")
        found = self.facts[k]
        listed = [] if turns is None else items(turns)
        self.work.take((1 + len(listed)) * (1 + len(found)))
        allowed = [*map(read_turn, listed)]
        asked = len(found) if demand is None else integer(demand, 0)
        return {
            "missing": len(found) < asked,
            "surplus": len(found) > asked,
            "turn": turns is not None and any(turn not in allowed for turn, _ in found),
            "mirror": mirrored is False and any(flag for _, flag in found),
        }

    def prove_apart(self) -> None:
        """Prove that parts are inside the frame, and apart from each other and the container."""
        normals = {
            tuple(integer(k, -1) for k in items(e, 6)[:4]): point(e[4:])[:2] for e in self.apart
        }
        need(len(normals) == len(self.apart), "apart: a pair is there twice")
        for one in self.placed[:-1]:
            for p, way in zip(self.frame, BOX, strict=True):
                inside = are_apart([p], one.points, way, self.margin + one.error)
                need(inside, "a part reaches beyond the frame")
        widest = max(self.spacing, self.margin) + 2 * max(one.error for one in self.placed)
        reach = -int(-widest * self.work.scale // 1)
        boxes = [one.boxes[-1] for one in (self.placed[-1], *self.placed[:-1])]
        for a, b in list_near(boxes, reach, self.work):
            self.prove_pair(a - 1, b - 1, reach, normals)

    def prove_pair(self, a: int, b: int, reach: int, normals: dict[Any, tuple[int, int]]) -> None:
        """Prove that two shapes are apart: by one normal of both, or for all pairs of pieces."""
        one, other = self.placed[a], self.placed[b]
        distance = (self.margin if a < 0 else self.spacing) + one.error + other.error
        self.work.take(len(one.points) + len(other.points))
        if (a, -1, b, -1) in normals:
            whole = are_apart(one.points, other.points, normals[a, -1, b, -1], distance)
            need(whole, f"{a} and {b}: no normal that parts them")
            return
        parts = enumerate(other.boxes[:-1])
        near = [(j, box) for j, box in parts if are_near(box, one.boxes[-1], reach)]
        self.work.take(len(one.pieces) * len(near) // 4)  # pragma: no mutate: steps alone
        for i, piece in enumerate(one.pieces):
            for j in [j for j, box in near if are_near(box, one.boxes[i], reach)]:
                self.work.take(len(piece) + len(other.pieces[j]))
                ways = [normals[a, i, b, j]] if (a, i, b, j) in normals else BOX
                apart = any(are_apart(piece, other.pieces[j], way, distance) for way in ways)
                need(apart, f"piece {i} of {a} and piece {j} of {b}: no normal that parts them")

    def prove_fault(self, fault: Any) -> tuple[Any, ...]:
        """Prove one fault by its witness; return what has it."""
        kind = fault.get("kind") if type(fault) is dict else None
        if kind in ("overlap", "outside", "too close"):
            self.prove_near(kind, *fields(fault, "kind placements pieces points")[1:])
            return tuple(sorted(fault["placements"]))
        name, both = fields(fault, "kind part", "edges")[1:]
        need(type(name) is str and name in self.numbers, "faults: of no part")
        k = self.numbers[name]
        self.work.take(count(self.rings[k]))
        if kind != "shape":
            need(self.check_rules(k).get(str(kind), False), "faults: a rule that is not broken")
            return kind, name
        written = self.parts[k][1], *(self.parts[k][2] or [])
        self.work.take(2 * count(written))
        rings = [edges(ring(e)) for e in written]
        (m, i), (n, j) = (items(edge, 2) for edge in items(both, 2))
        for r, e in ((m, i), (n, j)):
            under("edges", integer, e, 0, len(rings[under("edges", integer, r, 0, len(rings))]))
        (p, q), (r, s), size = rings[m][i], rings[n][j], len(rings[m])
        clash = i != j and do_clash(p, q, r, s, (j - i) % size, size)
        need(clash if m == n else do_cross(p, q, r, s), "faults: the edges do not clash")
        return kind, name

    def prove_near(self, kind: str, of: Any, numbers: Any, points: Any) -> None:
        """Prove that a point is inside two shapes, or that points of them are too close."""
        a, *others = [integer(n, 0, len(self.placed) - 1) for n in items(of)]
        need(len(others) < 2 and a not in others, "faults: not of one placement or of two")
        need(kind == "too close" or (kind == "overlap") == bool(others), f"faults: {kind} of what")
        one, other = self.placed[a], self.placed[(others or [-1])[0]]
        self.work.take(len(one.points) + len(other.points))
        (i, j), (p, q) = items(numbers, 2), (point(end) for end in items(points, 2))
        room = (self.spacing if others else self.margin) - one.error - other.error
        (x, y), (u, v) = place(p), place(q)
        closed = kind == "too close"
        met = room > 0 and (x - u) ** 2 + (y - v) ** 2 < room**2 if closed else p == q
        there = one.holds(i, p, closed) and other.holds(j, q, closed)
        need(met and there, f"faults: the points do not show {kind}")


# --- Areas and answers ----------------------------------------------------------------------------


def describe(kind: str, g: int, d: int, t: Ring, inner: Ring, outer: Ring, area: str) -> str:
    """Describe a sweep that is proved; the area as written, for str refuses long ints."""
    answer = f"trajectory {len(t)}, inner {len(inner)}, outer {len(outer)}, area {area}"
    return f"{kind} sweep of {g} around {d} vertices, {answer}"


def check_area(area: Any, loops: list[Ring], work: Work, unit: int = 1) -> None:
    """Refuse an area unless it is that of loops, those that are clockwise counted off."""
    terms: dict[int, int] = defaultdict(int)
    for p, q in chain.from_iterable(map(edges, loops)):
        terms[p[2] * q[2]] += p[0] * q[1] - q[0] * p[1]
    work.weight = weight(sum(w.bit_length() for w in terms))
    work.take(1)
    parts = [*terms.items()]
    while len(parts) > 1:
        both = zip(parts[::2], parts[1::2], strict=False)
        parts = [(v * w, m * w + n * v) for (v, m), (w, n) in both] + parts[len(parts) & ~1 :]
    ((w, n),), found = parts, 2 * unit * under("area", number, area)
    need(n * found.denominator == found.numerator * w, "area: not that between the loops")


# --- Positions, by (3) to (5) ---------------------------------------------------------------------


def loop(item: Any, work: Work) -> Ring:
    """Read a simple ring, counter-clockwise, without straight angles, its least point first."""
    points = least_first(item)
    check_shape([points], work)
    bent = all(side(line(p, q), points[k - 1]) for k, (p, q) in enumerate(edges(points)))
    need(bent and double_area(points) > 0, "a loop is not canonical")
    return points


def from_lowest(points: Ring) -> Ring:
    """Let a ring begin with its lowest point, the left one of two."""
    least = min(range(len(points)), key=lambda k: place(points[k])[::-1])
    return points[least:] + points[:least]


def add_convex(one: Ring, other: Ring) -> Ring:
    """Return the sum of two convex rings that begin with their lowest points."""
    steps = merge(ways(one), ways(other))[:-1]
    return [add(one[i % len(one)], other[j % len(other)]) for i, j in steps]


def clip(sides: list[Node], a: Node, b: Node) -> Span | None:
    """Return the shares of a segment inside open half-planes, from -1 or to 2 if beyond an end."""
    (x, y, w), (u, v, z) = a, b
    low, high = (-1, 1), (2, 1)  # pragma: no mutate: any that are beyond the ends
    for k, m, n in sides:
        at_a, at_b = (k * x + m * y + n * w) * z, (k * u + m * v + n * z) * w
        if at_a <= 0:
            if at_b <= 0:
                return None
            if -at_a * low[1] > low[0] * (at_b - at_a):
                low = -at_a, at_b - at_a
        elif at_b <= 0 and at_a * high[1] < high[0] * (at_a - at_b):
            high = at_a, at_a - at_b
    return (Fraction(*low), Fraction(*high)) if low[0] * high[1] < high[0] * low[1] else None


def share(a: Node, b: Node, p: Node, q: Node) -> Span | None:
    """Return the shares of a segment from a to b that are on an edge from p to q."""
    on = line(a, b)
    at_p, at_q = side(on, p), side(on, q)
    if at_p == at_q == 0:
        k = int(a[0] * b[2] == b[0] * a[2])
        s, t = (
            Fraction((e[k] * a[2] - a[k] * e[2]) * b[2], (b[k] * a[2] - a[k] * b[2]) * e[2])
            for e in (p, q)
        )
        s, t = min(s, t), max(s, t)
        return (s, t) if s <= 1 and t >= 0 else None
    other = line(p, q)
    at_a, at_b = side(other, a) * b[2], side(other, b) * a[2]
    if at_p * at_q > 0 or at_a * at_b > 0 or at_a == at_b:
        return None
    return (Fraction(at_a, at_a - at_b),) * 2


def tree(boxes: list[tuple[Grid, int]]) -> Tree:
    """Halve a list of boxes again and again: into a box, its size, and two trees or a number."""
    need(boxes != [], "there are no pieces")
    if len(boxes) == 1:
        return boxes[0][0], -1, boxes[0][1]
    lefts, rights, lows, highs = zip(*(box for box, _ in boxes), strict=True)
    box = min(lefts), max(rights), min(lows), max(highs)
    wide, high = box[1] - box[0], box[3] - box[2]
    boxes = sorted(boxes, key=lambda of: sum(of[0][:2] if wide > high else of[0][2:]))
    half = len(boxes) // 2
    return box, wide + high, (tree(boxes[:half]), tree(boxes[half:]))


def meet(trees: list[Tree], work: Work) -> Iterator[tuple[int, int, int]]:
    """List numbers of three trees: the first box meets the sum of the others."""
    stack = [tuple(trees)]
    while stack:
        (left, right, low, high), size, of = (found := stack.pop())[0]
        (a, b, c, d), wide, ones = found[1]
        (e, f, g, h), far, others = found[2]
        work.take(1)
        if a + e < right and left < b + f and c + g < high and low < d + h:
            largest = max(size, wide, far)
            if largest < 0:
                yield of, ones, others
            elif size == largest:
                stack += [(part, *found[1:]) for part in of]
            elif wide == largest:
                stack += [(found[0], part, found[2]) for part in ones]
            else:
                stack += [(*found[:2], part) for part in others]


class Sums:
    """The sums of pieces of two shapes, numbered through, and then the half-planes beyond B."""

    def __init__(self, d: list[Ring], h: list[Ring], work: Work, around: Ring) -> None:
        self.d, self.h, self.work = [*map(from_lowest, d)], [*map(from_lowest, h)], work
        boxes = ([(grid_box(e, work.scale), k) for k, e in enumerate(of)] for of in (d, h))
        self.trees, self.count = [*map(tree, boxes)], len(d) * len(h)
        self.room = 2**20
        self.beyond = range(self.count, self.count + len(around))
        sides = zip(self.beyond, edges(around), strict=True)
        self.known = {k: ([line(q, p)], [(q, p)]) for k, (p, q) in sides}

    def get(self, k: int) -> tuple[list[Node], list[Edge]]:
        """Return the lines around a sum and its sides, of a half-plane the one that is B's."""
        if k in self.known:
            return self.known[k]
        i, j = divmod(k, len(self.h))
        self.work.take(2 * (len(self.d[i]) + len(self.h[j])))
        sides = edges(add_convex(self.d[i], self.h[j]))
        found = [line(*e) for e in sides], sides
        # Memory has its bounds, too: some 500 MB.
        if self.room > 0:
            self.room, self.known[k] = self.room - len(sides), found
        return found


def is_chain(spans: list[tuple[Span, bool]]) -> bool:
    """Return whether spans, open or closed ones, cover all from 0 to 1, each from the last on."""
    reach, shut = NONE, False
    for (low, high), closed in spans:
        if low > high or low > reach or (low == reach and not (closed or shut)):
            return False
        if high > reach or (high == reach and closed):
            reach, shut = high, closed
    return reach > 1 or (shut and reach == 1)


def prove_positions(
    sums: Sums, loops: list[Ring], fits: list[Edge], listed: Any, around: Any = ()
) -> None:
    """Prove by (a) to (c) that loops, O on their left, and fits are the boundary of O."""
    known, work = [*chain.from_iterable(map(edges, loops)), *fits], sums.work
    along: dict[Node, list[list[tuple[Fraction, Fraction]]]] = {}
    for p, q in known:
        ends = sorted((place(p), place(q)))
        along.setdefault(max(line(p, q), line(q, p)), []).append(ends)
    for found in along.values():
        need(all(e[1] <= f[0] for e, f in pairwise(sorted(found))), "edges overlap")
    boxes = [(grid_box(e, work.scale), n) for n, e in enumerate(known)]
    far = ((n, 0, k) for n in range(len(known)) for k in sums.beyond)
    for n, i, j in chain(meet([tree(boxes), *sums.trees], work) if boxes else (), far):
        lines = sums.get(i * len(sums.h) + j)[0]
        work.take(len(lines))
        need(clip(lines, *known[n]) is None, "an edge of a loop or a fit is overlapped")
    entries = [(integer([*e, None][0], 0, sums.count), e[1:]) for e in map(items, items(listed))]
    entries += [(k, [found]) for k, found in zip(sums.beyond, around, strict=True)]
    beside: defaultdict[tuple[int, bool], list[tuple[Span, bool]]] = defaultdict(list)
    for k, chains in entries:
        sides = sums.get(k)[1]
        for (a, b), found in zip(sides, items(chains, len(sides)), strict=True):
            spans = []
            for n in [found] if type(found) is int else items(found):
                if integer(n, -len(known), len(entries)) >= 0:
                    lines = sums.get(entries[n][0])[0]
                    work.take(len(lines))
                    spans.append((clip(lines, a, b) or NOWHERE, False))
                    continue
                p, q = known[-1 - n]
                work.take(1)
                low, high = share(a, b, p, q) or NOWHERE
                spans.append(((low, high), True))
                if p == q and 0 <= low <= 1:
                    beside[-1 - n, True] = beside[-1 - n, False] = [(ALL, True)]
                elif low < high:
                    on = share(p, q, a, b) or NOWHERE
                    alike = (place(a) < place(b)) == (place(p) < place(q))
                    beside[-1 - n, alike].append((on, True))
            need(is_chain(spans), "chains: a gap")
    for n, (p, q) in enumerate(known):
        for left in [True] if n < len(known) - len(fits) else [True, False]:
            need(is_chain(sorted(beside[n, left])), "a loop or a fit does not part what it should")
        if p == q:
            work.take(len(known))
            alone = not any(lies(p, *e) for k, e in enumerate(known) if k != n)
            need(alone, "a fit of one point is on a loop or another fit")


def middle(points: Ring) -> Node:
    """Return a point inside a convex ring."""
    x, y, w = add(add(points[0], points[1]), points[2])
    return x, y, 3 * w


def find_positions(outer: Ring, h: list[Ring]) -> Ring:
    """Return the positions at which a part, turned by half a turn, is in a frame."""
    xs, ys = zip(*(place(p) for p in chain.from_iterable(h)), strict=True)
    (left, low), (right, high) = place(outer[0]), place(outer[2])
    return frame(left + max(xs), low + max(ys), right + min(xs), high + min(ys))


def prove_no_fit(c: dict[str, Any], work: Work) -> str:
    """Prove a no-fit polygon by (3)."""
    head = "directrix generatrix exterior holes exact_fits proof"
    d, g, exterior, holes, fits, proof = fields(c, head, "format version claim")[:6]
    (first, second, listed), d, g = fields(proof, "directrix generatrix sums"), shape(d), shape(g)
    work.fit(d + g)
    loops = [loop(exterior, work), *(loop(hole, work)[::-1] for hole in items(holes))]
    still, moving = solid(d, first, work), [*map(turn, solid(g, second, work))]
    prove_positions(Sums(still, moving, work, []), loops, read_fits(fits), listed)
    answer = f"{count(loops)} in {tell(loops, 'loop')}, {tell(fits, 'exact fit')}"
    return f"no-fit polygon of {count(g)} around {count(d)} vertices, {answer}"


def prove_inner_fit(c: dict[str, Any], work: Work) -> str:
    """Prove an inner fit by (4)."""
    head = "container part regions exact_fits proof"
    d, g, regions, fits, proof = fields(c, head, "format version claim")[:5]
    ends, first, second, listed, around = fields(proof, "frame outside part sums around")
    d, g, loops = shape(d), shape(g), []
    work.fit(d + g)
    for exterior, holes in (fields(region, "exterior holes") for region in items(regions)):
        one, *inside = region = [loop(points, work) for points in (exterior, *items(holes))]
        check_shape(region, work)
        loops += [one[::-1], *inside]
    outer = frame(*map(number, items(ends, 4)))
    still, moving = solid(d, first, work, outer), [*map(turn, solid(g, second, work))]
    sums = Sums(still, moving, work, find_positions(outer, moving))
    prove_positions(sums, loops, read_fits(fits), listed, items(around, 4))
    known = [*chain.from_iterable(map(edges, loops))]
    for k in range(0, sums.count, len(moving)):
        work.take(len(known))
        outside = winding(known, middle([p for p, _ in sums.get(k)[1]])) == 0
        need(outside, "a part of the outside is not outside the regions")
    answer = f"{count(loops)} in {tell(loops, 'loop')}, {tell(fits, 'exact fit')}"
    return f"inner fit of {count(g)} in {count(d)} vertices, {answer}"


def prove_sweep(c: dict[str, Any], work: Work) -> str:
    """Prove a sweep by (5), or by (6) if it has a shared direction."""
    if "claim" not in c:
        return Monotone(c, work).prove()
    names = "directrix generatrix exterior holes unswept inner outer area kind exact_fits proof"
    values = fields(c, names, "format version claim")[:11]
    d, g, t, holes, unswept, inner, outer, area, kind, fits, proof = values
    need(kind == "SS", "kind: not SS")
    first, second, listed, swept, slits = fields(proof, "directrix generatrix sums swept slits")
    d, g = shape(d), shape(g)
    work.fit(d + g)
    t, inner, outer = (loop(e, work) for e in (t, inner, outer))
    holes, unswept = ([loop(hole, work)[::-1] for hole in items(e)] for e in (holes, unswept))
    still, moving = solid(d, first, work), solid(g, second, work)
    sums = Sums(still, [*map(turn, moving)], work, [])
    prove_positions(sums, [t, *holes], read_fits(fits), listed)
    loops = [outer, inner[::-1], *unswept]
    sums = Sums([*map(list, edges(t))], moving, work, [])
    prove_positions(sums, loops, read_fits(slits), swept)
    need(winding(edges(inner), middle(still[0])) == 1, "inner: not the loop around the directrix")
    check_area(area, loops, work)
    return describe(kind, count(g), count(d), t, inner, outer, area)


# --- Sweeps with a shared direction, by (6) -------------------------------------------------------


def find_scale(points: Ring) -> int:
    """Return the least common denominator, or 1 if it is of no use, far longer than each."""
    scale, longest = 1, max(w.bit_length() for _, _, w in points)
    for _, _, w in points:
        scale = lcm(scale, w)
        if scale.bit_length() > max(256, 2 * longest):
            return 1
    return scale


class Part(NamedTuple):
    """A convex chain from left to right: its corners, the numbers of its edges, and their lines.

    It has the slopes from the least to the greatest line, straight down and up where loops end.
    """

    points: Ring
    numbers: list[Any]
    lines: list[Node]
    least: Sequence[int] = (1, 0)
    greatest: Sequence[int] = (-1, 0)

    def sides(self) -> list[Side]:
        """Return its edges."""
        return [*zip(self.numbers, self.points, self.points[1:], self.lines, strict=False)]

    def between(self, other: Part) -> Part:
        """Return the part of it that has slopes of another one."""
        start = bisect_left(self.lines, 0, key=lambda of: -by_way(of, other.least))
        end = bisect_right(self.lines, 0, start, key=lambda of: by_way(other.greatest, of))
        return Part(self.points[start:], self.numbers[start:], self.lines[start:end])


class Chain(NamedTuple):
    """A lower chain, from left to right, or an upper one turned by half a turn.

    Its convex parts have the vertical edges at their ends. Its level edges are the others.
    """

    parts: list[Part]
    level: list[Side]

    def list_jumps(self) -> tuple[list[Fraction], list[Fraction]]:
        """List where the chain falls, at last from infinity, and where it rises."""
        falls, rises = [place(self.level[0][1])[0]], [place(self.level[-1][2])[0]]
        for _, p, _, (a, b, _) in chain.from_iterable(part.sides() for part in self.parts):
            if b == 0:
                (falls if a > 0 else rises).append(place(p)[0])
        return falls, rises


Chains = tuple[Chain, Chain]


class MonotoneLoop(NamedTuple):
    """A loop that is monotone to x, its lines, and its two chains."""

    points: Ring
    lines: list[Node]
    chains: Chains
    is_convex: bool

    def feature(self, item: Any) -> Ring:
        """Read a feature: a vertex, or the ends of the edge that begins there."""
        (kind, k), size = items(item, 2), len(self.points)
        need(kind in ("vertex", "edge"), "neither a vertex nor an edge")
        first = self.points[integer(k, 0, size)]
        return [first, self.points[k + 1 - size]] if kind == "edge" else [first]


def lower_chain(points: Ring, lines: list[Node], start: int, end: int) -> Chain:
    """Return the chain from one corner to another, cut at right turns."""
    start -= lines[start - 1][1] == 0
    numbers = [n % len(points) for n in range(start, end + len(points) * (end < start) + 1)]
    turns = [by_way(lines[k], lines[m]) for k, m in pairwise(numbers[:-1])]
    cuts = [0, *(n for n, left in enumerate(turns, 1) if left < 0), len(numbers) - 1]
    parts = []
    for first, last in pairwise(cuts):
        found = numbers[first : last + 1]
        along = [lines[k] for k in found[:-1]]
        least = along[0] if first else (1, 0)
        greatest = along[-1] if last < cuts[-1] else (-1, 0)
        parts.append(Part([points[k] for k in found], found, along, least, greatest))
    return Chain(parts, [e for part in parts for e in part.sides() if e[3][1]])


def add_parts(one: Part, other: Part) -> Part:
    """Return the sum of two parts, its edges numbered by the features that they are sums of."""
    (points, of_one, u, *_), (more, of_other, v, *_) = one, other
    steps, lines, features = merge(u, v), [], []
    for (i, j), (k, m) in pairwise(steps):
        (a, b, c), (x, y, w) = (u[i], more[j]) if k > i else (v[j], points[i])
        of = a * w, b * w, c * w - a * x - b * y
        lines.append(of if w == 1 else reduce(*of))
        features.append(("VE"[m > j] + "VE"[k > i], of_other[j], of_one[i]))
    return Part([add(points[i], more[j]) for i, j in steps], features, lines)


def order(p: Node, q: Node) -> int:
    """Return a number below 0 if a point is left of another, above 0 if it is right of it."""
    return p[0] * q[2] - q[0] * p[2]


def gaps(below: list[Side], above: list[Side], tie: int = 0) -> list[tuple[int, int, Node]]:
    """List how far edges are above others at both ends of all x along which both are straight.

    Each gap is a numerator, a denominator and the end. With the tie 1 what ends above ends later
    than what ends below at the same x, with -1 earlier.
    """
    i = bisect_right(below, 0, key=lambda e: order(e[2], above[0][1]))
    j = bisect_right(above, 0, key=lambda e: order(e[2], below[0][1]))
    found = list[tuple[int, int, Node]]()
    while i < len(below) and j < len(above):
        (_, q, r, one), (_, s, t, other) = below[i], above[j]
        at = order(r, t)
        for is_below, p, z in ((order(q, s) >= 0, q, s), (at <= 0, r, t)):
            if is_below:
                found.append((-side(other, p), other[1] * p[2], p))
            else:
                found.append((side(one, z), one[1] * z[2], z))
        at = at or -tie
        i, j = i + (at <= 0), j + (at >= 0)
    return found


def turn_chain(level: list[Side], x: Fraction) -> list[Side]:
    """Turn edges by half a turn about (x/2, 0)."""
    n, w = x.as_integer_ratio()
    found = []
    for k, *ends, (a, b, c) in reversed(level):
        q, p = ((n * v - x * w, -y * w, v * w) for x, y, v in ends)
        found.append((k, p, q, (a * w, b * w, -a * n - c * w)))
    return found


def extent(of: Node, points: Sequence[Node], others: Sequence[Node] = ((0, 0, 1),)) -> Extent:
    """Return the ends of sums along a line, by x or y; in wrong order if one is off."""
    a, b, c = of
    found = list[Rational]()
    for x, y, w in points:
        for u, v, z in others:
            n, m, unit = x * z + u * w, y * z + v * w, w * z
            if a * n + b * m + c * unit:
                return 1, 0
            at = n if b else m
            found.append(at if unit == 1 else Fraction(at, unit))
    return min(found), max(found)


class Monotone:
    """A sweep of polygons with a shared direction, as its certificate has it, proved by (6).

    Its points are turned so that the direction is x, and multiplied by a common denominator.
    """

    def __init__(self, c: dict[str, Any], work: Work) -> None:
        names = ["generatrix", "directrix", "trajectory", "inner", "outer"]
        head = "contacts inner_drawn outer_drawn exact_fits kind direction reference area"
        values = fields(c, f"{head} {' '.join(names)}", "format version")
        *self.evidence, fits, self.kind, way, reference, self.area = values[:8]
        loops = [under(name, least_first, e) for name, e in zip(names, values[8:13], strict=True)]
        at = turn([under("reference", point, reference)])[0]
        loops[2] = [add(p, at) for p in loops[2]]
        self.fits = [(add(p, at), add(q, at)) for p, q in under("exact_fits", read_fits, fits)]
        x, y = (n if type(n) is int else under("direction", number, n) for n in items(way, 2))
        need(all(type(n) is int or len(n) > 4300 for n in way), "direction: not a pair of ints")
        primitive = x.denominator == 1 == y.denominator and gcd(int(x), int(y)) == 1
        need(primitive and (x > 0 or (x, y) == (0, 1)), "direction: not primitive")
        self.work, self.way, self.scale = work, (int(x), int(y)), find_scale(loops[0] + loops[1])
        loops = [[*map(self.enter, points)] for points in loops]
        work.weight = weight(max(n.bit_length() for n in chain.from_iterable(chain(*loops))))
        self.g, self.d, self.t, self.inner, self.outer = map(self.read, names, loops)

    def enter(self, p: Node) -> Node:
        """Turn and multiply a point."""
        (a, b), (x, y, w), scale = self.way, p, self.scale
        return reduce(scale * (a * x + b * y), scale * (a * y - b * x), w)

    def leave(self, p: Node, sign: int = 1) -> Span:
        """Return where a point is in the plane, or with the sign -1 one of an upper chain."""
        (a, b), (x, y) = self.way, place(p)
        unit = sign * self.scale * (a * a + b * b)
        return (a * x - b * y) / unit, (b * x + a * y) / unit

    def read(self, name: str, points: Ring) -> MonotoneLoop:
        """Return a ring as a loop, unless it has a straight angle, turns back or meets itself."""
        lines = [line(p, q) for p, q in edges(points)]
        self.work.take(len(lines))
        turns = [lines[k - 1][0] * b - lines[k - 1][1] * a for k, (a, b, _) in enumerate(lines)]
        ahead = [(k, b > 0) for k, (_, b, _) in enumerate(lines) if b]
        back = [k for n, (k, is_ahead) in enumerate(ahead) if is_ahead != ahead[n - 1][1]]
        need(0 not in turns, f"{name}: not canonical, a vertex without a turn")
        need(len(back) == 2, f"{name}: not monotone to the direction, it turns back at {back[:9]}")
        start, end = back if lines[back[0]][1] > 0 else back[::-1]
        upper = turn(points), [(-a, -b, c) for a, b, c in lines], end, start
        chains = lower_chain(points, lines, start, end), lower_chain(*upper)
        # Left turns alone go around once, for x turns back only twice.
        is_convex, above = min(turns) > 0, turn_chain(chains[1].level, NONE)
        for tie in () if is_convex else (-1, 1):
            first, *between, last = (n for n, _, _ in gaps(chains[0].level, above, tie))
            apart = min(first, last) >= 0 and min(between, default=1) > 0
            need(apart, f"{name}: not simple and counter-clockwise")
        return MonotoneLoop(points, lines, chains, is_convex)

    def prove(self) -> str:
        """Prove the sweep, and describe it."""
        g, d, t, inner, outer = self.g, self.d, self.t, self.inner, self.outer
        kind = "MM" if not g.is_convex else "CC" if d.is_convex else "CM"
        need(self.kind == kind, f"kind: it is {kind}")
        h, (contacts, inner_drawn, outer_drawn) = g.chains[::-1], self.evidence
        reason = "trajectory: outside it, at the witness or beside it, G overlaps or touches D"
        self.prove_held(t, d.chains, h, reason, under("contacts", items, contacts, len(t.points)))
        self.prove_fits(h)
        self.prove_drawn("outer_drawn", outer, outer_drawn)
        reason = "outer: outside it, at the witness or beside it, is area that is swept"
        self.prove_held(outer, t.chains, g.chains, reason)
        self.prove_drawn("inner_drawn", inner, inner_drawn)
        reason = "inner: at the witness or beside it G is free of D, and cuts into or touches it"
        self.prove_held(t, inner.chains, h, reason)
        unit = self.scale**2 * (self.way[0] ** 2 + self.way[1] ** 2)
        check_area(self.area, [outer.points, inner.points[::-1]], self.work, unit)
        sizes = len(g.points), len(d.points)
        return describe(kind, *sizes, t.points, inner.points, outer.points, self.area)

    def prove_held(
        self, held: MonotoneLoop, one: Chains, other: Chains, reason: str, contacts: Any = None
    ) -> None:
        """Prove by (e) that a loop has a sum within it, and by (d) contacts, if they are listed."""
        for sign, half, ones, others in zip((1, -1), held.chains, one, other, strict=True):
            edges = chain.from_iterable(part.sides() for part in half.parts if contacts)
            along = defaultdict[Node, list[tuple[Side, Extent, dict[Contact, Extent]]]](list)
            for edge in edges:
                along[edge[3]].append((edge, extent(edge[3], edge[1:3]), {}))
            left, right = half.level[0][1], half.level[-1][2]
            self.work.take(len(ones.parts) * len(others.parts))
            for a, b in product(ones.parts, others.parts):
                if by_way(a.greatest, b.least) > 0 or by_way(b.greatest, a.least) > 0:
                    continue
                added = add_parts(a.between(b), b.between(a))
                between = gaps(half.level, [e for e in added.sides() if e[3][1]])
                self.work.take(2 * len(added.points) + len(between) // 2)
                wrong = [p for p in added.points if order(p, left) < 0 or order(p, right) > 0]
                wrong += [p for n, _, p in between if n < 0]
                if wrong:
                    raise Refused(reason, self.leave(wrong[0], sign))
                for contact, p, q, of in added.sides() if along else ():
                    for _, (low, high), found in along.get(of, ()):
                        self.work.take(1)
                        piece = extent(of, [p, q])
                        if piece[0] < high and low < piece[1]:
                            found[contact] = piece
            for (k, start, *_), ends, found in chain.from_iterable(along.values()):
                name, listed, true = f"contacts[{k}]", contacts[k], [[*e] for e in sorted(found)]
                if listed != true or not all(type(n) is int for e in listed for n in e[1:]):
                    raise Refused(f"{name}: not the contacts along the edge, in order: {true[:9]}")
                self.prove_covered(name, ends, [*found.values()], start, sign)

    def prove_drawn(self, name: str, drawn: MonotoneLoop, listed: Any) -> None:
        """Prove that the features listed for each edge of a loop draw it, all of it."""
        lists = under(name, items, listed, len(drawn.lines))
        for k, (of, ends) in enumerate(zip(drawn.lines, edges(drawn.points), strict=True)):
            where = f"{name}[{k}]"
            pairs = [items(entry, 2) for entry in under(where, items, lists[k])]
            self.work.take(len(pairs))
            pieces = [extent(of, self.t.feature(p), self.g.feature(q)) for p, q in pairs]
            once = len(pairs) < 2 or len({*map(str, pairs)}) == len(pairs)
            need(once, f"{where}: a drawing is there twice")
            self.prove_covered(where, extent(of, ends), pieces, ends[0])

    def prove_covered(
        self, where: str, edge: Extent, pieces: list[Extent], start: Node, sign: int = 1
    ) -> None:
        """Prove that pieces of a line, each along a part of an edge, cover it."""
        reach, end = edge
        along = all(edge[0] < high > low < end for low, high in pieces)
        for low, high in sorted(pieces):
            reach = max(reach, high) if low <= reach else reach
        if not along or reach < end:
            reason = "nothing that is listed draws all of" if along else "a drawing is not along"
            raise Refused(f"{where}: {reason} the edge", self.leave(start, sign))

    def prove_fits(self, h: Chains) -> None:
        """Prove that the exact fits are those between sums of jumps, and in their order."""
        found = []
        for sign, t, one, other in zip((1, -1), self.t.chains, self.d.chains, h, strict=True):
            (falls, rises), (others, more) = one.list_jumps(), other.list_jumps()
            self.work.take(len(falls) * len(others) + len(rises) * len(more))
            for x in {a + b for a in falls for b in others} & {a + b for a in rises for b in more}:
                self.work.take(len(t.level) + len(one.level) + len(other.level))
                between = gaps(turn_chain(other.level, x), one.level)
                inside = min(Fraction(n, w) for n, w, _ in between)
                at = x.numerator, 0, x.denominator
                near = [e for _, p, q, e in t.level if order(p, at) <= 0 <= order(q, at)]
                hanging = max(Fraction(-a * at[0] - c * at[2], b * at[2]) for a, b, c in near)
                if hanging < inside:
                    ends = node(x, hanging), node(x, inside)
                    found.append((self.leave(ends[0], sign), self.leave(ends[1], sign)))
        listed = [(place(p), place(q)) for p, q in self.fits]
        wrong = sorted({*found}.symmetric_difference(listed))
        if wrong or listed != sorted(found):
            reason = "exact_fits: not the exact fits, from end to end and sorted"
            raise Refused(reason, wrong[0][1] if wrong else None)


# --- Questions ------------------------------------------------------------------------------------


def outline(points: Ring) -> Ring:
    """Return a ring as loops are written, without straight angles."""
    around = drop_repeated(points if double_area(points) > 0 else points[::-1])
    size = len(around)
    bent = [p for k, p in enumerate(around) if not lies(p, around[k - 1], around[(k + 1) % size])]
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
    item = json.loads(text, parse_float=str, parse_int=str)
    rings = [item] if type(item) is list else [item["exterior"], *(item.get("holes") or [])]
    return [[node(*map(Fraction, items(p, 2))) for p in points] for points in rings]


def check_format(certificate: Any) -> None:
    """Refuse a certificate of another format."""
    need(type(certificate) is dict, "a certificate is an object")
    version = certificate.get("version")
    need(certificate.get("format") == FORMAT, f"format: not {FORMAT!r}")
    need(type(version) is int and version == VERSION, f"version: not {VERSION}")


def prove(certificate: Any, max_steps: int = MAX_STEPS) -> str:
    """Prove a certificate, as `json.loads` gives it, and describe the proved claim.

    Raises:
        Refused: it is not proved; the first reason.
    """
    check_format(certificate)
    need(type(max_steps) is int, "max_steps: not an int")
    work, kind, claim = Work(max_steps), certificate.get("kind"), certificate.get("claim")
    work.read([certificate.get("area")])
    longest = work.read({k: item for k, item in certificate.items() if k not in UNREAD})
    work.weight = weight(longest * 10 // 3)
    work.take(work.numbers)
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
        need(len(arguments) in (1, 3), "give a certificate, and perhaps both shapes, G and D")
        text, *given = (Path(name).read_text(encoding="utf-8-sig") for name in arguments)
        certificate = load(text)
        proved = prove(certificate)
        keys = ("part", "container") if "part" in certificate else ("generatrix", "directrix")
        for key, shape_text in zip(keys, given, strict=False):
            check_given(certificate, key, read_given(shape_text))
        print(f"proved: {proved}")
    except Exception as error:  # whatever a file makes happen, nothing is proved
        print(f"not proved: {error}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
