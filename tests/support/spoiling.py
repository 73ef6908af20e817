"""Ways to spoil an exact answer.

Each is a function of a case, as it is put to the program, and of its exact answer.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from exactsweep import Point, Polygon, sweep
from exactsweep.check import point_in_polygon
from exactsweep.conform.judge.rounding import grant_rounding
from exactsweep.conform.judge.verdict import read_loop
from exactsweep.corpus import Case
from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.numbers.point import ORIGIN

Loop = list[Any]
Answer = dict[str, Any]
Change = Callable[[Case, Answer], Answer]

LOOPS = ("trajectory", "inner", "outer")


def answer_exactly(case: Case) -> Answer:
    """The exact answer of a case."""
    loops = {name: list(getattr(case, name).vertices) for name in LOOPS}
    return {**loops, "exact_fits": list(case.exact_fits)}


# Ways to change an answer.


def on(name: str, change: Callable[[Loop], Any]) -> Change:
    return lambda case, answer: {**answer, name: change(answer[name])}


def on_trajectory(change: Callable[[Loop], Any]) -> Change:
    return on("trajectory", change)


def move(loop: Loop, by: Sequence[Any]) -> Loop:
    return [Point(x + by[0], y + by[1]) for x, y in loop]


def refer_to(point: Callable[[Case], Sequence[Any]]) -> Change:
    """The path of another point of G."""

    def change(case: Case, answer: Answer) -> Answer:
        x, y = point(case)
        by = (x - case.reference.x, y - case.reference.y)
        fits = [tuple(move(list(fit), by)) for fit in answer["exact_fits"]]
        return {**answer, "trajectory": move(answer["trajectory"], by), "exact_fits": fits}

    return change


def map_positions(a: int, b: int, c: int, d: int) -> Change:
    """The positions of G's origin in other axes, about the reference point."""

    def change(case: Case, answer: Answer) -> Answer:
        r = case.reference
        loop = [
            Point(a * (x - r.x) + b * (y - r.y) + r.x, c * (x - r.x) + d * (y - r.y) + r.y)
            for x, y in answer["trajectory"]
        ]
        return {**answer, "trajectory": loop if a * d > b * c else loop[::-1], "exact_fits": []}

    return change


def add_generatrix(case: Case, answer: Answer) -> Answer:
    """The sum of D and G: G is not reflected."""
    sum_ = sweep(case.generatrix.reflected(), case.directrix, reference=ORIGIN).trajectory
    return {**answer, "trajectory": move(list(sum_.vertices), case.reference), "exact_fits": []}


def put(name: str, ring: Callable[[Case], Any]) -> Change:
    """Another loop in the place of one."""
    return lambda case, answer: {**answer, name: ring(case)}


def box(loop: Sequence[Point]) -> Loop:
    (low, high) = Polygon(loop).bounding_box
    return [low, Point(high.x, low.y), high, Point(low.x, high.y)]


def turns(loop: Loop) -> list[Any]:
    """Twice the signed area of each vertex's triangle with its neighbours."""
    found = []
    for k, (x, y) in enumerate(loop):
        (px, py), (qx, qy) = loop[k - 1], loop[(k + 1) % len(loop)]
        found.append((x - px) * (qy - y) - (y - py) * (qx - x))
    return found


def drop(loop: Loop, k: int) -> Loop:
    rest = loop[:k] + loop[k + 1 :]
    return rest if len(rest) > 2 and is_simple(rest) else loop


def is_simple(loop: Loop) -> bool:
    try:
        Polygon(loop)
    except ValueError:
        return False
    return True


def drop_notch(choose: Callable[[list[int], list[Any]], int]) -> Callable[[Loop], Loop]:
    """Lose one reflex vertex, and with it a place to slide into."""

    def change(loop: Loop) -> Loop:
        sizes = turns(loop)
        notches = [k for k, size in enumerate(sizes) if size < 0]
        return drop(loop, choose(notches, sizes)) if notches else loop

    return change


def drop_corner(choose: Callable[[list[int], list[Any]], int]) -> Callable[[Loop], Loop]:
    """Lose one convex vertex."""

    def change(loop: Loop) -> Loop:
        sizes = turns(loop)
        corners = [k for k, size in enumerate(sizes) if size > 0]
        return drop(loop, choose(corners, sizes)) if len(loop) > 3 else loop

    return change


def push(loop: Loop, k: int, share: Any) -> Loop:
    """Move a vertex along the way from the middle of its neighbours, by a share of it."""
    (x, y), (px, py), (qx, qy) = loop[k], loop[k - 1], loop[(k + 1) % len(loop)]
    share = Fraction(str(share))
    moved = Point(x + share * (x - (px + qx) / 2), y + share * (y - (py + qy) / 2))
    found = [*loop[:k], moved, *loop[k + 1 :]]
    return found if is_simple(found) else loop


def push_first(sign: int, share: str) -> Callable[[Loop], Loop]:
    """Move the first vertex that turns to a side."""

    def change(loop: Loop) -> Loop:
        places = [k for k, size in enumerate(turns(loop)) if size * sign > 0]
        return push(loop, places[0], share) if places else loop

    return change


def where(condition: Callable[[Case], bool], change: Change) -> Change:
    """A mistake that only some input brings out."""
    return lambda case, answer: change(case, answer) if condition(case) else answer


def has(flag: str) -> Callable[[Case], bool]:
    return lambda case: flag in case.flags


def each(change: Callable[[Any], Any]) -> Change:
    """A change of all numbers of the loops."""
    return lambda case, answer: {
        **{name: [(change(x), change(y)) for x, y in answer[name]] for name in LOOPS},
        "exact_fits": answer["exact_fits"],
    }


def wrap(bits: int) -> Callable[[Any], Any]:
    """Return the value of a number in an integer type."""
    half = 2 ** (bits - 1)
    return lambda c: (int(c) + half) % (2 * half) - half if c.denominator == 1 else c


def to_float32(c: Any) -> float:
    return float(struct.unpack("f", struct.pack("f", float(c)))[0])


def one_unit_too_far(case: Case, answer: Answer) -> Answer:
    """Floats, the first vertex further off than is granted, by one unit in the last place."""
    loop = [(float(x), float(y)) for x, y in answer["trajectory"]]
    granted = grant_rounding(case, "trajectory", read_loop(loop, ""), "binary64")
    x = loop[0][0]
    while abs(Fraction(x) - answer["trajectory"][0].x) <= granted:
        x = (
            float(Fraction(x) - granted / 4)
            if Fraction(x) - granted / 4 != x
            else math.nextafter(x, -math.inf)
        )
    return {**answer, "trajectory": [(x, loop[0][1]), *loop[1:]]}


def beside(ring: Callable[[Case], Any]) -> Change:
    """One ring more."""
    return lambda case, answer: {**answer, "trajectory": [answer["trajectory"], ring(case)]}


def far(case: Case, *places: tuple[int, int]) -> Loop:
    """Points far to the right of everything."""
    low, high = case.trajectory.bounding_box
    size = high.x - low.x
    return [Point(high.x + size * (2 + x), high.y + size * y) for x, y in places]


def inside(case: Case) -> Loop:
    """A small triangle inside the trajectory, at an ear of it."""
    ring = case.trajectory.vertices
    for k, b in enumerate(ring):
        a, c = ring[k - 1], ring[(k + 1) % len(ring)]
        ear = [a, b, c]
        if find_doubled_area(ear) <= 0:
            continue
        middle = Point((a.x + 2 * b.x + c.x) / 4, (a.y + 2 * b.y + c.y) / 4)
        small = [
            Point(middle.x + (p.x - middle.x) / 64, middle.y + (p.y - middle.y) / 64) for p in ear
        ]
        if all(point_in_polygon(p, Polygon(ear)) < 0 for p in ring if p not in ear):
            return small
    raise ValueError("no ear")


def on_fits(change: Callable[[list[Any], Case], list[Any]]) -> Change:
    """A mistake in exact fits, where there are any."""

    def changed(case: Case, answer: Answer) -> Answer:
        fits = [fit for fit in answer["exact_fits"] if fit[0] != fit[1]]
        return {**answer, "exact_fits": change(fits, case)} if fits else answer

    return changed


def stretch(fit: Any, share: Fraction) -> Any:
    """Move the second end of a segment along it."""
    (p, q) = fit
    return (p, Point(q.x + share * (q.x - p.x), q.y + share * (q.y - p.y)))


class Stale:
    """A program that keeps the answer of the case before."""

    def __init__(self) -> None:
        self.last: Answer | None = None

    def __call__(self, case: Case, answer: Answer) -> Answer:
        last, self.last = self.last, answer
        return last or answer


REFERENCE: dict[str, tuple[str, Callable[[Case], Sequence[Any]]]] = {
    "G's origin": ("G's origin as reference", lambda c: ORIGIN),
    "G's first vertex": ("G's first vertex as reference", lambda c: c.generatrix_ring[0]),
    "G's last vertex": ("G's last vertex as reference", lambda c: c.generatrix_ring[-1]),
    "a corner of G's box": (
        "lower left corner of G's box as reference",
        lambda c: c.generatrix.bounding_box[0],
    ),
    "the centre of G's box": (
        "centre of G's box as reference",
        lambda c: [sum(side) / 2 for side in zip(*c.generatrix.bounding_box, strict=True)],
    ),
    "the mean of G's vertices": (
        "mean of G's vertices as reference",
        lambda c: [
            sum(side) / len(c.generatrix_ring) for side in zip(*c.generatrix_ring, strict=True)
        ],
    ),
    "G's leftmost vertex": ("G's leftmost vertex as ref", lambda c: min(c.generatrix_ring)),
    "G's rightmost vertex": ("G's rightmost vertex as ref", lambda c: max(c.generatrix_ring)),
    "G's lowest vertex": (
        "G's lowest vertex as reference",
        lambda c: min(c.generatrix_ring, key=lambda p: (p.y, p.x)),
    ),
    "G's highest vertex": (
        "G's highest vertex as reference",
        lambda c: max(c.generatrix_ring, key=lambda p: (p.y, p.x)),
    ),
    "the reference point negated": (
        "the reference point negated",
        lambda c: (-c.reference.x, -c.reference.y),
    ),
    "D's first vertex": (
        "relative to D's first vertex",
        lambda c: [r - b for r, b in zip(c.reference, c.directrix_ring[0], strict=True)],
    ),
    "both first vertices": (
        "G's first vertex as reference, relative to D's first",
        lambda c: [g - d for g, d in zip(c.generatrix_ring[0], c.directrix_ring[0], strict=True)],
    ),
    "the corners of both boxes": (
        "relative to the lower left corner of D's box",
        lambda c: [
            g - d
            for g, d in zip(c.generatrix.bounding_box[0], c.directrix.bounding_box[0], strict=True)
        ],
    ),
    "a point far away": (
        r"another reference point: all is moved by \(1001,-777\)",
        lambda c: (c.reference.x + 1001, c.reference.y - 777),
    ),
}
"""Points mistaken for the reference point, with the messages on them."""
