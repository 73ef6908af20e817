"""Programs with one mistake each in no-fit polygons with holes, and in inner fits."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from mistakes import BROKEN, DIFFERS, FALSE
from spoiling import REFERENCE, move

from exactsweep import Point, Polygon, inner_fit_polygon, no_fit_polygon
from exactsweep.conform.judge.witness import list_exact_rings
from exactsweep.corpus import Case
from exactsweep.geometry.canonical import PolygonError

Rings = list[Any]
FITS_OF = {"no_fit": "exact_fits", "inner_fit": "inner_exact_fits"}
ELSE = "|exact for|itself|hull|bounding box|lacks|exact rings"


class RingMistake(NamedTuple):
    """A mistake.

    Attributes:
        part: "no_fit" or "inner_fit".
        change: makes it, of the case and the exact rings; None where it cannot be made.
        verdicts: that wrong answers may get.
        says: a regular expression that matches a message on each wrong answer.
        fits: makes one in the exact fits instead.
    """

    part: str
    change: Callable[[Case, Rings], Rings | None]
    verdicts: tuple[str, ...] = DIFFERS
    says: str = "."
    fits: Callable[[Case, Rings], Rings | None] = lambda case, fits: fits


def refer(point: Callable[[Case], Sequence[Any]]) -> Callable[[Case, Rings], Rings]:
    def change(case: Case, rings: Rings) -> Rings:
        x, y = point(case)
        return [move(ring, (x - case.reference.x, y - case.reference.y)) for ring in rings]

    return change


def turn(a: int, b: int, c: int, d: int) -> Callable[[Case, Rings], Rings]:
    """The positions of G's origin in other axes, about the reference point."""

    def change(case: Case, rings: Rings) -> Rings:
        u, v = case.reference
        return [
            [Point(a * (x - u) + b * (y - v) + u, c * (x - u) + d * (y - v) + v) for x, y in ring]
            for ring in rings
        ]

    return change


def scale(factor: Fraction) -> Callable[[Case, Rings], Rings]:
    return lambda case, rings: [[Point(x * factor, y * factor) for x, y in r] for r in rings]


def shrink(ring: Any) -> Rings:
    """A ring at half its size, about its first vertex."""
    a = ring[0]
    return [Point((a.x + p.x) / 2, (a.y + p.y) / 2) for p in ring]


def island(case: Case, rings: Rings) -> Rings:
    reach = 9 + 9 * max(abs(c) for ring in (*rings, case.directrix_ring) for p in ring for c in p)
    return [*rings, [(reach, reach), (reach + 1, reach), (reach, reach + 1)]]


def bow_tie(case: Case, rings: Rings) -> Rings:
    *rest, ((x, y), *_) = island(case, rings)
    return [*rest, [(x, y), (x + 1, y + 1), (x + 1, y), (x, y + 1)]]


def spike(case: Case, rings: Rings) -> Rings | None:
    if not rings:
        return None
    first, *rest = rings
    low, _ = Polygon(first).bounding_box
    return [[first[0], Point(low.x - 5, low.y - 7), *first], *rest]


def leave_open(case: Case, rings: Rings) -> Rings | None:
    inside = inner_fit_polygon(case.directrix, case.generatrix, reference=case.reference)
    return [*rings, *(ring for region in inside.regions for ring in region.rings)]


def add_generatrix(case: Case, rings: Rings) -> Rings:
    found = no_fit_polygon(case.directrix, case.generatrix.reflected())
    return [move(list(loop.vertices), case.reference) for loop in (found.exterior, *found.holes)]


def without(k: int) -> Callable[[Case, Rings], Rings | None]:
    """One ring is lost; not the only one."""
    return lambda case, rings: [r for r in rings if r is not rings[k]] if len(rings) > 1 else None


def beyond(case: Case, fits: Rings) -> Rings:
    (low, high) = case.outer.bounding_box
    far = Point(2 * high.x - low.x + 1, high.y)
    return [*fits, (far, Point(far.x + 3, far.y))]


def along(name: str) -> Callable[[Case, Rings], Rings | None]:
    """Half of an edge of the first ring, or of the last one."""

    def change(case: Case, fits: Rings) -> Rings | None:
        rings = list_exact_rings(case, name)
        if not rings:
            return None
        a, b = rings[-1][:2]
        return [*fits, (a, Point((a.x + b.x) / 2, (a.y + b.y) / 2))]

    return change


def within(name: str) -> Callable[[Case, Rings], Rings | None]:
    """A segment well inside a hole, or inside a region with play."""

    def change(case: Case, fits: Rings) -> Rings | None:
        rings = list_exact_rings(case, name)
        rings = rings[1:] if name == "no_fit" else rings
        for (a, b, c, *_), whole in ((ring, Polygon(ring)) for ring in rings):
            if whole.is_convex:
                middle = Point((a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3)
                return [*fits, (middle, Point((a.x + middle.x) / 2, (a.y + middle.y) / 2))]
        return None

    return change


def unchanged(case: Case, rings: Rings) -> Rings:
    return rings


def point_far(case: Case, fits: Rings) -> Rings:
    *rest, (far, _) = beyond(case, fits)
    return [*rest, (far, far)]


AXES = {
    "exchanged roles": (-1, 0, 0, -1),
    "y is negated": (1, 0, 0, -1),
    "x is negated": (-1, 0, 0, 1),
    "x and y are exchanged": (0, 1, 1, 0),
    "a turn to the left": (0, -1, 1, 0),
    "a turn to the right": (0, 1, -1, 0),
}


def list_mistakes(part: str) -> Iterator[tuple[str, RingMistake]]:
    for name, (words, point) in REFERENCE.items():
        yield f"about {name}", RingMistake(part, refer(point), says=words + ELSE)
    for words, matrix in AXES.items():
        yield words, RingMistake(part, turn(*matrix), says=words + ELSE)
    yield "twice as large", RingMistake(part, scale(Fraction(2)), says="2 times as large" + ELSE)
    lost = "lacks|lacks the holes"
    yield "the last ring lost", RingMistake(part, without(-1), says=lost)
    yield "the second ring lost", RingMistake(part, without(1), says=lost)
    yield (
        "only the first ring",
        RingMistake(part, lambda case, rings: rings[:1] if len(rings) > 1 else None, says=lost),
    )
    yield "the first ring lost", RingMistake(part, without(0), says=lost + "|neither|more|part")
    yield (
        "the last ring shrunk",
        RingMistake(part, lambda case, rings: [*rings[:-1], shrink(rings[-1])] if rings else None),
    )
    yield (
        "the last ring moved by 1e-9",
        RingMistake(
            part,
            lambda case, rings: (
                [*rings[:-1], move(rings[-1], (Fraction(1, 10**9), 0))] if rings else None
            ),
        ),
    )
    yield "an island", RingMistake(part, island, says="all exact rings, and 1 more|more than")
    yield "a bow tie besides", RingMistake(part, bow_tie, BROKEN, "crosses itself")
    yield "a spike", RingMistake(part, spike, BROKEN, "touches|spike|cross|turns|vert")
    yield (
        "the last ring twice",
        RingMistake(
            part, lambda case, rings: [*rings, rings[-1]] if rings else None, BROKEN, "overlap"
        ),
    )
    # Far away G is free of D, and out of a container.
    away = FALSE if part == "no_fit" else ("unsound",)
    yield "a fit far away", RingMistake(part, unchanged, away, "invented", beyond)
    yield "a point far away", RingMistake(part, unchanged, away, "invented", point_far)
    yield "a fit on an edge", RingMistake(part, unchanged, FALSE, "invented|long", along(part))
    yield "a fit with play", RingMistake(part, unchanged, FALSE, "invented|long", within(part))


RING_MISTAKES: dict[str, RingMistake] = {
    f"{part.replace('_', ' ')}: {name}": mistake
    for part in FITS_OF
    for name, mistake in list_mistakes(part)
}
RING_MISTAKES["no fit: the sum of boundaries"] = RingMistake(
    "no_fit", leave_open, says="the sum of the boundaries"
)
RING_MISTAKES["no fit: D + G"] = RingMistake("no_fit", add_generatrix, says="not reflected" + ELSE)


def spoil_rings(mistake: RingMistake, case: Case) -> dict[str, Rings] | None:
    """Return what a mistake makes of the exact answer, or None where that is no mistake."""
    part, listed = mistake.part, FITS_OF[mistake.part]
    if part == "inner_fit" and case.inner_regions is None:
        return None
    exact = [list(ring) for ring in list_exact_rings(case, part)]
    known = list(getattr(case, listed))
    rings, fits = mistake.change(case, exact), mistake.fits(case, known)
    if rings is None or fits is None or (_is_same(rings, exact) and fits == known):
        return None
    return {part: rings, listed: fits}


def _is_same(rings: Rings, exact: Rings) -> bool:
    try:
        one, other = (sorted(Polygon(r).vertices for r in given) for given in (rings, exact))
    except PolygonError:
        return False
    return one == other
