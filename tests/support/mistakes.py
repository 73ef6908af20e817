"""Programs with one mistake each, and what the judge has to say of them."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import NamedTuple

from spoiling import (
    REFERENCE,
    Change,
    Stale,
    add_generatrix,
    beside,
    box,
    drop_corner,
    drop_notch,
    each,
    far,
    has,
    inside,
    map_positions,
    on,
    on_fits,
    on_trajectory,
    one_unit_too_far,
    push,
    push_first,
    put,
    refer_to,
    stretch,
    to_float32,
    where,
    wrap,
)

from exactsweep import Point, sweep
from exactsweep.conform.run.protocol import Numbers
from exactsweep.geometry.hull import find_hull

# Verdicts, by what they say.
DIFFERS = ("conservative", "unsound", "wrong")
LARGER = ("conservative", "wrong")
SMALLER = ("unsound", "wrong")
FITS = ("equivalent except for exact fits",)
FALSE = ("false exact fits",)
BROKEN = ("malformed",)


class Mistake(NamedTuple):
    """A mistake.

    Attributes:
        change: makes it; answers that it leaves as they are are right.
        verdicts: that wrong answers may get.
        says: a regular expression that matches a message on each wrong answer.
        numbers: what the program says that it reads.
    """

    change: Change
    verdicts: tuple[str, ...]
    says: str
    numbers: Numbers = "rational"


# The message on a wrong loop that happens to be exact for something else.
OR_ELSE = "|exact for|itself|hull|bounding box"
MORE, LESS = "more than the exact", "part of the exact"
NEITHER = "neither holds"
ANY = f"{MORE}|{LESS}|{NEITHER}{OR_ELSE}"
ONE_OFF = "one vertex is off"
LACKS = "lacks one vertex|lacks vertices"


MISTAKES: dict[str, Mistake] = {
    **{
        f"the path of {name}": Mistake(refer_to(point), DIFFERS, words)
        for name, (words, point) in REFERENCE.items()
    },
    "exchanged roles": Mistake(map_positions(-1, 0, 0, -1), DIFFERS, "exchanged roles"),
    "D + G": Mistake(add_generatrix, DIFFERS, "D \\+ G, G not reflected"),
    "y downwards": Mistake(map_positions(1, 0, 0, -1), DIFFERS, "y is negated"),
    "x to the left": Mistake(map_positions(-1, 0, 0, 1), DIFFERS, "x is negated"),
    "x and y exchanged": Mistake(map_positions(0, 1, 1, 0), DIFFERS, "x and y are exchanged"),
    "a turn to the left": Mistake(map_positions(0, -1, 1, 0), DIFFERS, "a turn to the left"),
    "a turn to the right": Mistake(map_positions(0, 1, -1, 0), DIFFERS, "a turn to the right"),
    "twice as large": Mistake(
        on_trajectory(lambda loop: [(2 * x, 2 * y) for x, y in loop]), DIFFERS, "2 times as large"
    ),
    "inches": Mistake(
        on_trajectory(lambda loop: [(x * 5 / 127, y * 5 / 127) for x, y in loop]),
        DIFFERS,
        "another scale",
    ),
    # The answer to another question.
    "D for the trajectory": Mistake(
        put("trajectory", lambda c: c.directrix_ring), DIFFERS, "D itself"
    ),
    "G for the trajectory": Mistake(
        put("trajectory", lambda c: c.generatrix_ring), DIFFERS, "G itself"
    ),
    "the inner loop for the trajectory": Mistake(
        put("trajectory", lambda c: c.inner.vertices), DIFFERS, "exact for the inner loop instead"
    ),
    "the outer loop for the trajectory": Mistake(
        put("trajectory", lambda c: c.outer.vertices), DIFFERS, "exact for the outer loop instead"
    ),
    "the hull of the trajectory": Mistake(
        put("trajectory", lambda c: find_hull(c.trajectory.vertices)), LARGER, "the convex hull"
    ),
    "the box of the trajectory": Mistake(
        put("trajectory", lambda c: box(c.trajectory.vertices)), LARGER, "the bounding box"
    ),
    "D for the inner loop": Mistake(put("inner", lambda c: c.directrix_ring), SMALLER, "D itself"),
    "the trajectory for the inner loop": Mistake(
        put("inner", lambda c: c.trajectory.vertices), DIFFERS, "exact for the trajectory instead"
    ),
    "the outer for the inner loop": Mistake(
        put("inner", lambda c: c.outer.vertices), DIFFERS, "exact for the outer loop instead"
    ),
    "the hull of the inner loop": Mistake(
        put("inner", lambda c: find_hull(c.inner.vertices)), LARGER, "the convex hull"
    ),
    "the trajectory for the outer loop": Mistake(
        put("outer", lambda c: c.trajectory.vertices), DIFFERS, "exact for the trajectory instead"
    ),
    "the inner for the outer loop": Mistake(
        put("outer", lambda c: c.inner.vertices), DIFFERS, "exact for the inner loop instead"
    ),
    "the hull of the outer loop": Mistake(
        put("outer", lambda c: find_hull(c.outer.vertices)), LARGER, "the convex hull"
    ),
    "the box of the outer loop": Mistake(
        put("outer", lambda c: box(c.outer.vertices)), LARGER, "the bounding box"
    ),
    "D + G for the outer loop": Mistake(
        put("outer", lambda c: sweep(c.generatrix.reflected(), c.directrix).trajectory.vertices),
        DIFFERS,
        r"D \+ G" + OR_ELSE,
    ),
    # One place is wrong.
    "loses the first notch": Mistake(
        on_trajectory(drop_notch(lambda k, sizes: k[0])), LARGER, LACKS + OR_ELSE
    ),
    "loses the last notch": Mistake(
        on_trajectory(drop_notch(lambda k, sizes: k[-1])), LARGER, LACKS + OR_ELSE
    ),
    "loses the smallest notch": Mistake(
        on_trajectory(drop_notch(lambda k, sizes: max(k, key=lambda j: sizes[j]))),
        LARGER,
        LACKS + OR_ELSE,
    ),
    "loses a corner": Mistake(
        on_trajectory(drop_corner(lambda k, sizes: k[0])), SMALLER, LACKS + OR_ELSE
    ),
    "loses the smallest corner": Mistake(
        on_trajectory(drop_corner(lambda k, sizes: min(k, key=lambda j: sizes[j]))),
        SMALLER,
        LACKS + OR_ELSE,
    ),
    "loses an undercut": Mistake(
        on("inner", drop_notch(lambda k, s: k[0])), LARGER, LACKS + OR_ELSE
    ),
    "loses a notch of the outer loop": Mistake(
        on("outer", drop_notch(lambda k, s: k[0])), LARGER, LACKS + OR_ELSE
    ),
    "a corner pushed out": Mistake(on_trajectory(push_first(1, "1/10")), LARGER, ONE_OFF),
    "a corner pushed in": Mistake(on_trajectory(push_first(1, "-1/10")), SMALLER, ONE_OFF),
    "a notch pushed out": Mistake(on_trajectory(push_first(-1, "-1/10")), LARGER, ONE_OFF),
    "a notch pushed in": Mistake(on_trajectory(push_first(-1, "1/10")), SMALLER, ONE_OFF),
    "a corner pushed out by 1e-30": Mistake(on_trajectory(push_first(1, "1e-30")), LARGER, ONE_OFF),
    "a corner pushed in by 1e-30": Mistake(
        on_trajectory(push_first(1, "-1e-30")), SMALLER, ONE_OFF
    ),
    "a corner of the inner loop pushed in": Mistake(
        on("inner", push_first(1, "-1/9")), SMALLER, ONE_OFF
    ),
    "a corner of the outer loop pushed out": Mistake(
        on("outer", push_first(1, "1/9")), LARGER, ONE_OFF
    ),
    "a bump on an edge": Mistake(
        on_trajectory(
            lambda loop: push(
                [*loop, Point((loop[-1].x + loop[0].x) / 2, (loop[-1].y + loop[0].y) / 2 - 1)],
                len(loop),
                0,
            )
        ),
        (*DIFFERS, *BROKEN),
        "has more vertices|spike|touch|cross|edges",
    ),
    "a needle on an edge": Mistake(
        on_trajectory(
            lambda loop: [
                *loop,
                Point(loop[0].x - 1, loop[0].y + Fraction(1, 10**6)),
                Point(loop[0].x, loop[0].y + Fraction(2, 10**6)),
            ]
        ),
        (*LARGER, *BROKEN),
        "has more vertices|spike|touch|cross|edges",
    ),
    # Only some input brings it out.
    "wrong beyond 256 vertices": Mistake(
        where(lambda c: c.size > 256, on_trajectory(drop_corner(lambda k, s: k[-1]))),
        SMALLER,
        LACKS,
    ),
    "wrong beyond 40 vertices of G": Mistake(
        where(lambda c: len(c.generatrix_ring) > 40, on_trajectory(push_first(1, "1/1000"))),
        LARGER,
        ONE_OFF,
    ),
    "wrong for clockwise input": Mistake(
        where(has("clockwise"), map_positions(-1, 0, 0, -1)), DIFFERS, "exchanged roles"
    ),
    "wrong if a vertex repeats": Mistake(
        where(has("repeated-vertex"), on_trajectory(drop_corner(lambda k, s: k[0]))),
        SMALLER,
        LACKS + OR_ELSE,
    ),
    "wrong if vertices are collinear": Mistake(
        where(has("collinear-vertex"), on_trajectory(drop_corner(lambda k, s: k[-1]))),
        SMALLER,
        LACKS + OR_ELSE,
    ),
    "wrong for parallel edges": Mistake(
        where(has("parallel-edges"), on_trajectory(push_first(1, "1/4"))), LARGER, ONE_OFF
    ),
    "wrong for vertical edges": Mistake(
        where(has("vertical-edge"), on_trajectory(push_first(1, "-1/4"))), SMALLER, ONE_OFF
    ),
    "wrong for a polygon around itself": Mistake(
        where(has("identical"), on_trajectory(push_first(1, "1/7"))), LARGER, ONE_OFF
    ),
    "wrong for fractions": Mistake(
        where(has("fractional-input"), each(lambda c: Fraction(math.floor(c)))),
        (*DIFFERS, *BROKEN),
        "rounded down to integers",
    ),
    "wrong where the reference point is not the origin": Mistake(
        where(has("reference-point"), refer_to(lambda c: (0, 0))),
        DIFFERS,
        "G's origin as reference",
    ),
    "wrong where D and G touch as given": Mistake(
        where(has("touching"), on_trajectory(drop_corner(lambda k, s: k[0]))),
        SMALLER,
        LACKS + OR_ELSE,
    ),
    "wrong in other directions": Mistake(
        where(has("turned"), put("trajectory", lambda c: find_hull(c.trajectory.vertices))),
        LARGER,
        "hull",
    ),
    "wrong every third time": Mistake(
        where(lambda c: sum(map(ord, c.id)) % 3 == 0, on_trajectory(push_first(1, "1/5"))),
        LARGER,
        ONE_OFF,
    ),
    "int32 that wraps around": Mistake(
        each(wrap(32)), (*DIFFERS, *BROKEN), "wraps around at 32 bits"
    ),
    "int16 that wraps around": Mistake(
        each(wrap(16)), (*DIFFERS, *BROKEN), "wraps around at 16 bits"
    ),
    # Numbers.
    "float32": Mistake(
        each(to_float32), (*DIFFERS, *BROKEN), "rounded to single precision", "binary64"
    ),
    "six digits": Mistake(
        each(lambda c: float(f"{float(c):.6g}")),
        (*DIFFERS, *BROKEN),
        "rounded to 6 digits",
        "binary64",
    ),
    "three decimals": Mistake(
        each(lambda c: float(f"{float(c):.3f}")),
        (*DIFFERS, *BROKEN),
        "rounded to 3 decimals",
        "binary64",
    ),
    "one unit too far off": Mistake(
        one_unit_too_far,
        DIFFERS,
        "except for 4 times the rounding|" + ONE_OFF,
        "binary64",
    ),
    "a claim that is too large": Mistake(
        where(
            lambda c: not {"sliver", "near-parallel"} & {*c.flags},
            lambda case, answer: {
                **answer,
                "trajectory": box(answer["trajectory"]),
                "rounding": 10**9,
            },
        ),
        LARGER,
        "the bounding box|the convex hull",
    ),
    "integers, one off by two": Mistake(
        on_trajectory(
            lambda loop: [
                (round(loop[0].x) - 2, round(loop[0].y)),
                *((round(x), round(y)) for x, y in loop[1:]),
            ]
        ),
        (*DIFFERS, *BROKEN),
        ".",
    ),
    # Exact fits.
    "no exact fits": Mistake(on_fits(lambda fits, case: []), FITS, "missing"),
    "one fit of several lost": Mistake(
        on_fits(lambda fits, case: fits[:-1] if len(fits) > 1 else fits), FITS, "missing"
    ),
    "fits too short": Mistake(
        on_fits(lambda fits, case: [stretch(fits[0], Fraction(-1, 9)), *fits[1:]]),
        FITS,
        "too short",
    ),
    "fits too long": Mistake(
        on_fits(lambda fits, case: [stretch(fits[0], Fraction(1, 9)), *fits[1:]]),
        (*FITS, "unsound"),
        "too long",
    ),
    "ends of fits only": Mistake(
        on_fits(lambda fits, case: [(p, p) for fit in fits for p in fit]),
        FITS,
        "missing|too short|invented",
    ),
    "fits moved aside": Mistake(
        on_fits(
            lambda fits, case: [
                tuple(Point(x + Fraction(1, 10**6), y - Fraction(1, 10**6)) for x, y in fit)
                for fit in fits
            ]
        ),
        (*FALSE, "unsound"),
        "missing, invented|too long",
    ),
    "fits about the origin": Mistake(
        where(
            has("reference-point"),
            on_fits(
                lambda fits, case: [
                    tuple(Point(x - case.reference.x, y - case.reference.y) for x, y in fit)
                    for fit in fits
                ]
            ),
        ),
        (*FALSE, "unsound"),
        "invented|too",
    ),
    "a fit invented": Mistake(
        lambda case, answer: {
            **answer,
            "exact_fits": [*answer["exact_fits"], tuple(inside(case)[:2])],
        },
        ("unsound",),
        "invented|too",
    ),
    # Rings.
    "a spike": Mistake(
        on_trajectory(
            lambda loop: [*loop, loop[0], Point(2 * loop[0].x - loop[1].x - 1, loop[0].y - 1)]
        ),
        BROKEN,
        "crosses itself|spike|touches|folds|overlap|edge",
    ),
    "two vertices exchanged": Mistake(
        on_trajectory(lambda loop: [loop[1], loop[0], *loop[2:]] if len(loop) > 3 else loop),
        (*BROKEN, *DIFFERS),
        ".",
    ),
    "a bow tie besides": Mistake(
        beside(lambda c: far(c, (0, 0), (1, 1), (1, 0), (0, 1))), BROKEN, "crosses itself"
    ),
    "a point besides": Mistake(beside(lambda c: far(c, (0, 0))), BROKEN, "fewer than three"),
    "a line besides": Mistake(
        beside(lambda c: far(c, (0, 0), (1, 0), (2, 0))), BROKEN, "zero area"
    ),
    "the loop twice": Mistake(
        beside(lambda c: c.trajectory.vertices), BROKEN, "rings 0 and 1 overlap"
    ),
    "an island": Mistake(beside(lambda c: far(c, (0, 0), (1, 0), (0, 1))), ("conservative",), MORE),
    "a hole": Mistake(beside(inside), ("unsound",), LESS),
    "two vertices only": Mistake(on_trajectory(lambda loop: loop[:2]), BROKEN, "fewer than three"),
    "an empty loop": Mistake(on_trajectory(lambda loop: []), BROKEN, "is empty"),
    "not a number": Mistake(on_trajectory(lambda loop: [(math.nan, 0), *loop[1:]]), BROKEN, "nan"),
    "infinity": Mistake(on_trajectory(lambda loop: [(math.inf, 0), *loop[1:]]), BROKEN, "inf"),
    "three coordinates": Mistake(
        on_trajectory(lambda loop: [(*p, 0) for p in loop]), BROKEN, "3 coordinates"
    ),
    "text": Mistake(on_trajectory(lambda loop: "POLYGON ((0 0, 1 0, 0 1))"), BROKEN, "not a list"),
    "no outer loop": Mistake(
        lambda case, answer: {k: v for k, v in answer.items() if k != "outer"}, BROKEN, "missing"
    ),
    # Whole answers.
    "the answer of the case before": Mistake(Stale(), (*DIFFERS, *BROKEN), "."),
    "always the same": Mistake(
        on_trajectory(
            lambda loop: [Point(Fraction(x), Fraction(y)) for x, y in ((0, 0), (1, 0), (1, 1))]
        ),
        DIFFERS,
        ANY,
    ),
}
