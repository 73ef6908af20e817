"""Functions that change an exact answer into a wrong one.

Each maps a case, as the program gets it, and its exact answer, rings by part, to a wrong answer, or
to None if it does not apply.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from exactsweep import Point, Polygon, inner_fit_polygon, no_fit_polygon
from exactsweep.check import point_in_polygon
from exactsweep.conform.judge.rounding import grant_rounding
from exactsweep.conform.judge.verdict import read_loop
from exactsweep.conform.judge.witness import list_exact_rings
from exactsweep.corpus import Case
from exactsweep.numbers.number import ORIGIN

Ring = list[Any]
Answer = dict[str, Any]
Change = Callable[[Case, Answer], Answer | None]

LOOPS = ("trajectory", "inner", "outer")
FITS_OF = {"trajectory": "exact_fits", "no_fit": "exact_fits", "inner_fit": "inner_exact_fits"}
PARTS = {part: (part, FITS_OF[part]) for part in ("no_fit", "inner_fit")} | {
    "trajectory": (*LOOPS, "exact_fits")
}
"""The parts of an answer, by the one that holds positions."""


def answer_exactly(case: Case, part: str) -> Answer:
    """Return the exact answer of a case."""
    return {name: [list(ring) for ring in list_exact_rings(case, name)] for name in PARTS[part]}


# Changes of an answer.


def on(part: str, change: Callable[[Ring], Any]) -> Change:
    """Change each ring of a part."""
    return lambda case, answer: {**answer, part: [change(ring) for ring in answer[part]]}


def on_all(part: str, change: Callable[[list[Ring]], Any]) -> Change:
    """Change all rings of a part, or its exact fits, if there are any."""
    return lambda case, answer: answer[part] and {**answer, part: change(answer[part])}


def put(part: str, rings: Callable[[Case], Any]) -> Change:
    """Replace the rings of a part."""
    return lambda case, answer: {**answer, part: rings(case)}


def add(part: str, ring: Callable[[Case], Any]) -> Change:
    """Add a ring or an exact fit."""
    return lambda case, answer: (found := ring(case)) and {**answer, part: [*answer[part], found]}


def map_points(part: str, mapping: Callable[[Case], Callable[[Any, Any], Any]]) -> Change:
    """Map all positions by a function."""

    def change(case: Case, answer: Answer) -> Answer | None:
        if not answer[part]:
            return None
        image = mapping(case)
        names = part, FITS_OF[part]
        return answer | {
            name: [[Point(*image(*p)) for p in ring] for ring in answer[name]] for name in names
        }

    return change


def refer_to(part: str, point: Callable[[Case], Sequence[Any]]) -> Change:
    """Return the path of another point of G."""

    def mapping(case: Case) -> Callable[[Any, Any], Any]:
        dx, dy = (a - b for a, b in zip(point(case), case.reference, strict=True))
        return lambda x, y: (x + dx, y + dy)

    return map_points(part, mapping)


def turn(part: str, a: int, b: int, c: int, d: int) -> Change:
    """Apply a matrix to the positions of G's origin, about the reference point."""

    def mapping(case: Case) -> Callable[[Any, Any], Any]:
        u, v = case.reference
        return lambda x, y: (a * (x - u) + b * (y - v) + u, c * (x - u) + d * (y - v) + v)

    return map_points(part, mapping)


def scale(part: str, factor: Fraction) -> Change:
    return map_points(part, lambda case: lambda x, y: (x * factor, y * factor))


def add_generatrix(part: str) -> Change:
    """Return the sum of D and G: G is not reflected."""

    def rings(case: Case) -> list[Ring]:
        found = no_fit_polygon(case.directrix, case.generatrix.reflected())
        loops = (found.exterior, *(found.holes if part == "no_fit" else ()))
        (x, y) = ORIGIN if part == "outer" else case.reference
        return [[Point(p.x + x, p.y + y) for p in loop.vertices] for loop in loops]

    return put(part, rings)


def leave_open(case: Case, answer: Answer) -> Answer:
    """Return the sum of the boundaries if G fits inside D."""
    inside = inner_fit_polygon(case.directrix, case.generatrix, reference=case.reference)
    rings = (ring for region in inside.regions for ring in region.rings)
    return {**answer, "no_fit": [*answer["no_fit"], *rings]}


def box(loop: Sequence[Point]) -> Ring:
    (low, high) = Polygon(loop).bounding_box
    return [low, Point(high.x, low.y), high, Point(low.x, high.y)]


def turns(loop: Ring) -> list[Any]:
    """Return twice the signed area of each vertex's triangle with its neighbors."""
    found = []
    for k, (x, y) in enumerate(loop):
        (px, py), (qx, qy) = loop[k - 1], loop[(k + 1) % len(loop)]
        found.append((x - px) * (qy - y) - (y - py) * (qx - x))
    return found


def if_simple(found: Ring, loop: Ring) -> Ring:
    """Return the changed loop if it is simple, else the original one."""
    try:
        Polygon(found)
    except ValueError:
        return loop
    return found


def lose(sign: int, choose: Callable[[list[int], list[Any]], int]) -> Callable[[Ring], Ring]:
    """Drop a vertex with a turn to one side; for -1, a notch into which G can slide."""

    def change(loop: Ring) -> Ring:
        sizes = turns(loop)
        if not (places := [k for k, size in enumerate(sizes) if size * sign > 0]):
            return loop
        k = choose(places, sizes)
        return if_simple(loop[:k] + loop[k + 1 :], loop)

    return change


def push(sign: int, share: str) -> Callable[[Ring], Ring]:
    """Move the first vertex with a turn to one side away from the midpoint of its neighbors."""

    def change(loop: Ring) -> Ring:
        k = next((k for k, size in enumerate(turns(loop)) if size * sign > 0), None)
        if k is None:
            return loop
        (x, y), (px, py), (qx, qy) = loop[k], loop[k - 1], loop[(k + 1) % len(loop)]
        s = Fraction(share)
        moved = Point(x + s * (x - (px + qx) / 2), y + s * (y - (py + qy) / 2))
        return if_simple([*loop[:k], moved, *loop[k + 1 :]], loop)

    return change


def where(condition: Callable[[Case], bool], change: Change) -> Change:
    """Apply a mistake to some inputs only."""
    return lambda case, answer: change(case, answer) if condition(case) else None


def has(flag: str) -> Callable[[Case], bool]:
    return lambda case: flag in case.flags


def each(change: Callable[[Any], Any]) -> Change:
    """Change all numbers of the loops."""
    return lambda case, answer: (
        answer
        | {
            name: [[(change(x), change(y)) for x, y in ring] for ring in answer[name]]
            for name in LOOPS
        }
    )


def wrap(bits: int) -> Callable[[Any], Any]:
    """Return the value of a number in an integer type."""
    half = 2 ** (bits - 1)
    return lambda c: (int(c) + half) % (2 * half) - half if c.denominator == 1 else c


def to_float32(c: Any) -> float:
    return float(struct.unpack("f", struct.pack("f", float(c)))[0])


def one_unit_too_far(case: Case, answer: Answer) -> Answer:
    """Return floats whose first vertex exceeds the permitted error by one ulp."""
    (exact,) = answer["trajectory"]
    loop = [(float(x), float(y)) for x, y in exact]
    granted = grant_rounding(case, "trajectory", read_loop(loop, ""), "binary64")
    x = loop[0][0]
    while abs(Fraction(x) - exact[0].x) <= granted:
        nearer = float(Fraction(x) - granted / 4)
        x = nearer if nearer != x else math.nextafter(x, -math.inf)
    return {**answer, "trajectory": [[(x, loop[0][1]), *loop[1:]]]}


def far(*places: tuple[int, int]) -> Callable[[Case], Ring]:
    """Return points far to the right of all polygons."""

    def find(case: Case) -> Ring:
        low, high = case.outer.bounding_box
        size = high.x - low.x
        return [Point(high.x + size * (2 + x), high.y + size * y) for x, y in places]

    return find


def inside(case: Case) -> Ring:
    """Return a small triangle inside the trajectory, at one of its ears."""
    ring = case.trajectory.vertices
    for k, b in enumerate(ring):
        a, c = ring[k - 1], ring[(k + 1) % len(ring)]
        ear = [a, b, c]
        if turns(ear)[0] <= 0:
            continue
        x, y = (a.x + 2 * b.x + c.x) / 4, (a.y + 2 * b.y + c.y) / 4
        if all(point_in_polygon(p, Polygon(ear)) < 0 for p in ring if p not in ear):
            return [Point(x + (p.x - x) / 64, y + (p.y - y) / 64) for p in ear]
    raise ValueError("no ear")


def along(part: str) -> Callable[[Case], Ring | None]:
    """Return half of an edge of the last ring."""

    def find(case: Case) -> Ring | None:
        if not (rings := list_exact_rings(case, part)):
            return None
        a, b = rings[-1][:2]
        return [a, Point((a.x + b.x) / 2, (a.y + b.y) / 2)]

    return find


def within(part: str) -> Callable[[Case], Ring | None]:
    """Return a segment in the interior of a hole or of a region."""

    def find(case: Case) -> Ring | None:
        rings = list_exact_rings(case, part)
        for ring in rings if part == "inner_fit" else rings[1:]:
            if Polygon(ring).is_convex:
                a, b, c = ring[:3]
                middle = Point((a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3)
                return [middle, Point((a.x + middle.x) / 2, (a.y + middle.y) / 2)]
        return None

    return find


def lengthen(share: Fraction) -> Callable[[list[Ring]], list[Ring]]:
    """Move the second end of the first exact fit of positive length along the fit."""

    def change(fits: list[Ring]) -> list[Ring]:
        changed = [[p, q] for p, q in fits]
        for fit in changed:
            if fit[0] != fit[1]:
                p, q = fit
                fit[1] = Point(q.x + share * (q.x - p.x), q.y + share * (q.y - p.y))
                break
        return changed

    return change


def go_stale(last: dict[str, Answer]) -> Change:
    """Simulate a program that repeats its previous answer."""

    def change(case: Case, answer: Answer) -> Answer | None:
        found = last.get("answer")
        last["answer"] = answer
        return found

    return change


def choose_vertex(of: Callable[..., Point], **options: Any) -> Callable[[Case], Point]:
    return lambda case: of(case.generatrix_ring, **options)


def subtract(one: Callable[[Case], Any], other: Callable[[Case], Any]) -> Callable[[Case], Any]:
    return lambda c: [a - b for a, b in zip(one(c), other(c), strict=True)]


def by_height(p: Point) -> Any:
    return p.y, p.x


REFERENCE: dict[str, Callable[[Case], Sequence[Any]]] = {
    "G's origin as reference": lambda c: ORIGIN,
    "G's first vertex as reference": lambda c: c.generatrix_ring[0],
    "G's last vertex as reference": lambda c: c.generatrix_ring[-1],
    "lower left corner of G's box as reference": lambda c: c.generatrix.bounding_box[0],
    "center of G's box as reference": lambda c: [
        sum(side) / 2 for side in zip(*c.generatrix.bounding_box, strict=True)
    ],
    "mean of G's vertices as reference": lambda c: [
        sum(side) / len(c.generatrix_ring) for side in zip(*c.generatrix_ring, strict=True)
    ],
    "G's leftmost vertex as reference": choose_vertex(min),
    "G's rightmost vertex as reference": choose_vertex(max),
    "G's lowest vertex as reference": choose_vertex(min, key=by_height),
    "G's highest vertex as reference": choose_vertex(max, key=by_height),
    "the reference point negated": lambda c: (-c.reference.x, -c.reference.y),
    "relative to D's first vertex": subtract(lambda c: c.reference, lambda c: c.directrix_ring[0]),
    "G's first vertex as reference, relative to D's first": subtract(
        lambda c: c.generatrix_ring[0], lambda c: c.directrix_ring[0]
    ),
    "relative to the lower left corner of D's box": subtract(
        lambda c: c.generatrix.bounding_box[0], lambda c: c.directrix.bounding_box[0]
    ),
    r"another reference point: translated by \(1001,-777\)": lambda c: (
        c.reference.x + 1001,
        c.reference.y - 777,
    ),
}
"""Points mistaken for the reference point, by the messages on them."""

AXES = {
    "exchanged roles": (-1, 0, 0, -1),
    "y is negated": (1, 0, 0, -1),
    "x is negated": (-1, 0, 0, 1),
    "x and y are exchanged": (0, 1, 1, 0),
    "rotated by 90 degrees": (0, -1, 1, 0),
    "rotated by -90 degrees": (0, 1, -1, 0),
}
"""Axes mistaken for others, by the messages on them."""
