"""Programs with one mistake each, and the required verdicts."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any, NamedTuple

from spoiling import (
    AXES,
    FITS_OF,
    LOOPS,
    REFERENCE,
    Change,
    add,
    add_generatrix,
    along,
    box,
    each,
    far,
    go_stale,
    has,
    if_simple,
    inside,
    leave_open,
    lengthen,
    lose,
    on,
    on_all,
    one_unit_too_far,
    push,
    put,
    refer_to,
    scale,
    to_float32,
    turn,
    where,
    within,
    wrap,
)

from exactsweep import Point
from exactsweep.conform.run.protocol import Hello, Numbers
from exactsweep.corpus import Case
from exactsweep.geometry.vectors import find_hull

# Verdicts by message.
DIFFERS = ("conservative", "unsound", "wrong")
LARGER = ("conservative", "wrong")
SMALLER = ("unsound", "wrong")
FITS = ("equivalent except for exact fits",)
FALSE = ("false exact fits",)
BROKEN = ("malformed",)
ANY = (*DIFFERS, *BROKEN)

# The message if a wrong loop is the exact answer to another question.
OR_ELSE = "|exact for|itself|hull|bounding box"
ONE_OFF = "one vertex is wrong"
LACKS = f"lacks one vertex|lacks vertices{OR_ELSE}"
LOST = "lacks|lacks the holes"


class Mistake(NamedTuple):
    """A mistake.

    Attributes:
        change: makes it; unchanged answers are right.
        verdicts: the allowed verdicts on wrong answers.
        says: a regular expression that matches a message on each wrong answer.
        part: the part of the answer that has positions.
        numbers: the numbers in the program's hello.
    """

    change: Change
    verdicts: tuple[str, ...] = DIFFERS
    says: str = "."
    part: str = "trajectory"
    numbers: Numbers = "rational"

    @property
    def hello(self) -> Hello:
        """Return the hello of the program."""
        if self.part == "trajectory":
            return Hello("mistaken", LOOPS, self.numbers)
        return Hello("mistaken", (), self.numbers, questions=(self.part,), shapes="any")  # type: ignore[arg-type]


def without(k: int) -> Callable[[list[Any]], Any]:
    """Drop one of several rings."""
    return lambda rings: [r for r in rings if r is not rings[k]] if len(rings) > 1 else rings


def list_of_positions(part: str) -> Iterator[tuple[str, Mistake]]:
    """Yield the mistakes in positions."""
    fits, is_loop, is_inner = FITS_OF[part], part == "trajectory", part == "inner_fit"
    other = OR_ELSE + ("" if is_loop else "|lacks|exact rings")

    def row(
        name: str, change: Change, verdicts: tuple[str, ...] = DIFFERS, says: str = "."
    ) -> tuple[str, Mistake]:
        return f"{part.replace('_', ' ')}: {name}", Mistake(change, verdicts, says, part)

    for words, point in REFERENCE.items():
        says = words if is_loop else words + other
        yield row(words.removesuffix(" as reference"), refer_to(part, point), says=says)
    for words, matrix in AXES.items():
        says = words if is_loop else words + other
        yield row(words, turn(part, *matrix), says=says)
    yield row("twice as large", scale(part, Fraction(2)), says="2 times as large" + other)
    yield row("inches", scale(part, Fraction(5, 127)), says="another scale" + other)
    if not is_inner:
        yield row("D + G", add_generatrix(part), says="not reflected" + other)
    island = "more than the exact|all exact rings, and 1 more"
    yield row("an island", add(part, far((0, 0), (1, 0), (0, 1))), DIFFERS, island)
    bow_tie = far((0, 0), (1, 1), (1, 0), (0, 1))
    yield row("a bow tie besides", add(part, bow_tie), BROKEN, "crosses itself")
    yield row("a point besides", add(part, far((0, 0))), BROKEN, "fewer than three")
    line = far((0, 0), (1, 0), (2, 0))
    yield row("a line besides", add(part, line), BROKEN, "zero area")
    yield row("the last ring twice", on_all(part, lambda r: [*r, r[-1]]), BROKEN, "overlap")
    spike = "touches|spike|cross|turns|fold|overlap|edge|vert"
    yield row("a spike", on_all(part, add_spike), BROKEN, spike)
    yield row("a point far away", add(fits, far((0, 0), (0, 0))), away(part), "invented")
    yield row("a fit far away", add(fits, far((0, 0), (1, 0))), away(part), "invented")
    yield row("a fit on an edge", add(fits, along(part)), FALSE, "invented|long")
    if is_loop:
        return
    yield row("a fit with play", add(fits, within(part)), FALSE, "invented|long")
    for name, lost in (("last", without(-1)), ("second", without(1))):
        yield row(f"the {name} ring lost", on_all(part, lost), says=LOST)
    yield row("only the first ring", on_all(part, lambda rings: rings[:1]), says=LOST)
    first = f"{LOST}|neither|more|part"
    yield row("the first ring lost", on_all(part, without(0)), says=first)
    yield row("the last ring shrunk", on_all(part, lambda r: [*r[:-1], shrink(r[-1])]))
    yield row("the last ring moved by 1e-9", on_all(part, lambda r: [*r[:-1], shift(r[-1])]))


def away(part: str) -> tuple[str, ...]:
    """Return the verdict on distant positions: free for D, outside for a container."""
    return ("unsound",) if part == "inner_fit" else FALSE


def add_spike(rings: list[Any]) -> Any:
    first, *rest = rings
    x, y = (min(p[axis] for p in first) for axis in (0, 1))
    return [[first[0], Point(x - 5, y - 7), *first], *rest]


def shrink(ring: Any) -> Any:
    """Shrink a ring by half about its first vertex."""
    return [Point((ring[0].x + p.x) / 2, (ring[0].y + p.y) / 2) for p in ring]


def shift(ring: Any) -> Any:
    return [Point(p.x + Fraction(1, 10**9), p.y) for p in ring]


# Loops, and vertices of loops.

INSTEAD: dict[str, Callable[[Case], Any]] = {
    "D itself": lambda c: c.directrix_ring,
    "G itself": lambda c: c.generatrix_ring,
    "exact for the trajectory instead": lambda c: c.trajectory.vertices,
    "exact for the inner loop instead": lambda c: c.inner.vertices,
    "exact for the outer loop instead": lambda c: c.outer.vertices,
}
CHOICES: dict[str, Callable[[list[int], list[Any]], int]] = {
    "first": lambda k, sizes: k[0],
    "last": lambda k, sizes: k[-1],
    "smallest": lambda k, sizes: min(k, key=lambda j: abs(sizes[j])),
}
SIDES = {-1: ("notch", LARGER), 1: ("corner", SMALLER)}


def list_of_loops(part: str) -> Iterator[tuple[str, Mistake]]:
    """Yield the mistakes in loops of sweeps."""
    for words, ring in INSTEAD.items():
        if f" {part} " in words:
            continue
        change = put(part, lambda case, ring=ring: [ring(case)])  # type: ignore[misc]
        yield f"{part}: {words}", Mistake(change, DIFFERS, words)
    yield f"{part}: its hull", Mistake(on(part, find_hull), LARGER, "the convex hull")
    yield f"{part}: its box", Mistake(on(part, box), LARGER, "the bounding box")
    for sign, (thing, verdicts) in SIDES.items():
        for which, choose in CHOICES.items():
            lost = Mistake(on(part, lose(sign, choose)), verdicts, LACKS)
            yield f"{part}: loses the {which} {thing}", lost
        for share in ("1/10", "-1/10", "1e-30", "-1e-30"):
            is_out = sign * Fraction(share) > 0
            pushed = Mistake(on(part, push(sign, share)), LARGER if is_out else SMALLER, ONE_OFF)
            yield f"{part}: a {thing} pushed by {share}", pushed


def add_bump(loop: Any) -> Any:
    (ax, ay), (bx, by) = loop[-1], loop[0]
    return if_simple([*loop, Point((ax + bx) / 2, (ay + by) / 2 - 1)], loop)


def add_needle(loop: Any) -> Any:
    x, y = loop[0]
    e = Fraction(1, 10**6)
    return [*loop, Point(x - 1, y + e), Point(x, y + 2 * e)]


FLAGS = (
    *("clockwise", "repeated-vertex", "collinear-vertex", "parallel-edges", "vertical-edge"),
    *("identical", "fractional-input", "reference-point", "touching", "turned"),
)
"""The flags of input that only some programs are wrong for."""
CONDITIONS: dict[str, Callable[[Case], bool]] = {
    **{flag: has(flag) for flag in FLAGS},
    "256 vertices": lambda c: c.size > 256,
    "40 vertices of G": lambda c: len(c.generatrix_ring) > 40,
    "every third time": lambda c: sum(map(ord, c.id)) % 3 == 0,
}


def ring_of(*pairs: tuple[Any, ...]) -> Change:
    """Replace the first vertices of the trajectory."""
    return on("trajectory", lambda loop: [*pairs, *loop[len(pairs) :]])


def exchange(loop: Any) -> Any:
    return [loop[1], loop[0], *loop[2:]] if len(loop) > 3 else loop


def round_but_one(loop: Any) -> Any:
    (x, y), *rest = ((round(x), round(y)) for x, y in loop)
    return [(x - 2, y), *rest]


def claim_all(case: Case, answer: Any) -> Any:
    if {"sliver", "near-parallel"} & {*case.flags}:
        return None
    return {**answer, "trajectory": [box(answer["trajectory"][0])], "rounding": 10**9}


def move_aside(fits: Any) -> Any:
    e = Fraction(1, 10**6)
    return [[Point(x + e, y - e) for x, y in fit] for fit in fits]


LOOP, FIT = "trajectory", "exact_fits"
BUMPED = "has all exact vertices|spike|touch|cross|edges"
CONSTANT = [Point(Fraction(x), Fraction(y)) for x, y in ((0, 0), (1, 0), (1, 1))]
DOUBLES: dict[str, Callable[[Any], Any]] = {
    "rounded to single precision": to_float32,
    "rounded to 6 digits": lambda c: float(f"{float(c):.6g}"),
    "rounded to 3 decimals": lambda c: float(f"{float(c):.3f}"),
}
OTHERS: dict[str, tuple[Change, tuple[str, ...], str]] = {
    "D + G for the outer loop": (add_generatrix("outer"), DIFFERS, r"D \+ G" + OR_ELSE),
    "a bump on an edge": (on(LOOP, add_bump), ANY, BUMPED),
    "a needle on an edge": (on(LOOP, add_needle), (*LARGER, *BROKEN), BUMPED),
    "a claim that is too large": (claim_all, LARGER, "the bounding box|the convex hull"),
    "integers, one off by two": (on(LOOP, round_but_one), ANY, "."),
    "rounded down": (each(lambda c: Fraction(math.floor(c))), ANY, "rounded down to integers"),
    "int32 that wraps around": (each(wrap(32)), ANY, "wraps around at 32 bits"),
    "int16 that wraps around": (each(wrap(16)), ANY, "wraps around at 16 bits"),
    # Exact fits.
    "no exact fits": (on_all(FIT, lambda fits: []), FITS, "missing"),
    "one fit of several lost": (on_all(FIT, without(-1)), FITS, "missing"),
    "fits too short": (on_all(FIT, lengthen(Fraction(-1, 9))), FITS, "too short"),
    "fits too long": (on_all(FIT, lengthen(Fraction(1, 9))), (*FITS, "unsound"), "too long"),
    "ends of fits only": (
        on_all(FIT, lambda fits: [(p, p) for fit in fits for p in fit]),
        FITS,
        "missing|too short|invented",
    ),
    "fits moved aside": (on_all(FIT, move_aside), (*FALSE, "unsound"), "missing, inv|too long"),
    "a fit invented": (add(FIT, lambda c: inside(c)[:2]), ("unsound",), "invented|too"),
    # Rings.
    "two vertices exchanged": (on(LOOP, exchange), ANY, "."),
    "a hole": (add(LOOP, inside), ("unsound",), "part of the exact"),
    "two vertices only": (on(LOOP, lambda loop: loop[:2]), BROKEN, "fewer than three"),
    "an empty loop": (on(LOOP, lambda loop: []), BROKEN, "is empty"),
    "not a number": (ring_of((math.nan, 0)), BROKEN, "nan"),
    "infinity": (ring_of((math.inf, 0)), BROKEN, "inf"),
    "three coordinates": (ring_of((0, 0, 0)), BROKEN, "3 coordinates"),
    "text": (put(LOOP, lambda c: "POLYGON ((0 0, 1 0, 0 1))"), BROKEN, "not a list"),
    "no outer loop": (lambda c, a: {k: a[k] for k in a if k != "outer"}, BROKEN, "missing"),
    # Whole answers.
    "the answer of the previous case": (go_stale({}), ANY, "."),
    "always the same": (
        put(LOOP, lambda c: [CONSTANT]),
        DIFFERS,
        f"more than the exact|part of the exact|neither contains{OR_ELSE}",
    ),
}

MISTAKES: dict[str, Mistake] = {
    **{name: one for part in FITS_OF for name, one in list_of_positions(part)},
    **{name: one for part in LOOPS for name, one in list_of_loops(part)},
    **{
        f"wrong for {name}": Mistake(where(condition, on(LOOP, push(1, "1/7"))), LARGER, ONE_OFF)
        for name, condition in CONDITIONS.items()
    },
    **{name: Mistake(*row) for name, row in OTHERS.items()},
    **{words: Mistake(each(to), ANY, words, numbers="binary64") for words, to in DOUBLES.items()},
    "one unit too far off": Mistake(
        one_unit_too_far, says=f"except for 4 times the rounding|{ONE_OFF}", numbers="binary64"
    ),
    "no fit: the sum of boundaries": Mistake(
        leave_open, says=re.escape("the sum of the boundaries"), part="no_fit"
    ),
}
