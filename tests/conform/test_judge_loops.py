"""Loops of answers: all rings count, rounding is granted, mistakes are diagnosed."""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from shipped_cases import shipped_cases
from tiers import examples

from exactsweep import Point
from exactsweep.conform.judge.closeness import are_close, match_rings
from exactsweep.conform.judge.compare import compare
from exactsweep.conform.judge.rounding import name_arithmetic
from exactsweep.conform.judge.verdict import PartComparison, Verdict
from exactsweep.conform.judge.witness import list_exact_rings
from exactsweep.corpus import Case
from exactsweep.geometry.vectors import find_hull, is_on_segment
from exactsweep.numbers.limits import limits

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
BLOCK = [(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (1, 1), (1, 3), (0, 3)]
SLOT = Case.of("slot", "", BLOCK, SQUARE)


def judge(case: Case, loop: object, name: str = "trajectory", **options: Any) -> PartComparison:
    return compare(case, {name: loop}, **options).parts[0]


def test_many_rings_are_judged_like_few() -> None:
    """A sheet with 64 holes; a limit of the judge must not count against the program."""
    holes = [
        [(3 * i + 1, 3 * j + 1), (3 * i + 2, 3 * j + 1), (3 * i + 2, 3 * j + 2)]
        for i in range(8)
        for j in range(8)
    ]
    sheet = Case.of("sheet", "", box(25, 25), box("1/9", "1/9"), directrix_holes=holes)
    rings = list(list_exact_rings(sheet, "no_fit"))
    assert len(rings) == 65
    assert judge(sheet, [ring[::-1] for ring in rings[::-1]], "no_fit").verdict == "equivalent"
    assert judge(sheet, [rings[0], *rings[:0:-1]], "no_fit").verdict == "exact"
    lost = judge(sheet, [*rings[:30], *rings[31:]], "no_fit")
    assert (lost.verdict, lost.diagnosis) == ("conservative", ("lacks 1 of 64 holes",))
    tiny = [[[k, 9], [k + 1, 9], [k, 10]] for k in range(0, 1200, 2)]
    assert judge(SLOT, tiny).verdict is Verdict.WRONG


def test_invalid_rings_are_named() -> None:
    assert judge(SLOT, [[[0, 0]], 7]).reason == "$.trajectory[1] is 7, not a ring"


def test_a_loop_that_is_too_large_is_rejected() -> None:
    with limits(max_mib=0.001):
        found = judge(SLOT, [[k, k * k] for k in range(100)])
    assert found.reason == "$.trajectory has more than 65 vertices (max_mib)"


def box(width: Any, height: Any) -> list[Any]:
    return [(0, 0), (width, 0), (width, height), (0, height)]


def test_a_keyhole_along_an_exact_fit_traces_it() -> None:
    """The loop enters through a slot as wide as G, follows the cavity, and leaves."""
    room = [(0, 0), (9, 0), (9, 9), (5, 9), (5, 8), (8, 8), (8, 1), (1, 1), (1, 8), (4, 8)]
    case = Case.of("door", "", [*room, (4, 9), (0, 9)], SQUARE)
    ((hanging, inside),) = case.exact_fits
    exterior, hole = (list(ring) for ring in list_exact_rings(case, "no_fit"))
    if not any(is_on_segment(hanging, exterior[k - 1], b) for k, b in enumerate(exterior)):
        hanging, inside = inside, hanging
    k = next(k for k, b in enumerate(exterior) if is_on_segment(hanging, exterior[k - 1], b))
    j = next(j for j, b in enumerate(hole) if is_on_segment(inside, hole[j - 1], b))
    around = [inside, *hole[j:], *hole[:j], inside]
    keyholed = [*exterior[:k], hanging, *around, hanging, *exterior[k:]]
    for ring in (keyholed, keyholed[::-1]):
        found = compare(case, {"no_fit": ring})
        assert [(p.verdict, p.kind) for p in found.parts] == [("equivalent", "whisker")] * 2
    doubles = [[float(x), float(y) + 1e-15] for x, y in keyholed]
    assert compare(case, {"no_fit": doubles}).verdict is Verdict.WITHIN
    # A whisker next to the fit is not the fit.
    wrong = [*exterior[:k], hanging, (Fraction(3), Fraction(6)), hanging, *exterior[k:]]
    assert compare(case, {"no_fit": [wrong, hole]}).verdict is Verdict.MALFORMED


def test_a_flat_region_near_a_segment_is_within() -> None:
    case = Case.of("exactly as wide", "", box(4, "1/8"), box(1, "1/8"), inner_fit=True)
    assert case.inner_regions == ()
    thin = [[0.0, 0.0], [3.0, 0.0], [3.0, 4e-16], [0.0, 4e-16]]
    found = compare(case, {"inner_fit": [thin]}, numbers="binary64")
    assert found.verdict is Verdict.WITHIN
    wide = [[x, y * 10**12] for x, y in thin]
    assert compare(case, {"inner_fit": [wide]}, numbers="binary64").verdict == "unsound"


def test_a_loop_smaller_than_its_rounding_is_not_a_fit() -> None:
    """Far from the origin, doubles are integers; the whole loop is near a fit, but is none."""
    far = 2**53
    d = [(x + far, y) for x, y in BLOCK]
    case = Case.of("far fit", "", d, [(0, 0), (2, 0), (2, 1), (0, 1)])
    assert case.exact_fits
    loop = [[float(x), float(y)] for x, y in case.trajectory.vertices]
    loop[0][0] += 2
    found = compare(case, {"trajectory": loop}, numbers="binary64")
    assert found.parts[0].verdict is Verdict.WITHIN


@pytest.mark.parametrize("flat", [[(x, 0) for x in row] for row in ((0, 4, 2, 3), (3, 2, 4, 0))])
def test_rounding_may_flatten_either_loop(flat: list[tuple[int, int]]) -> None:
    e = Fraction(1, 1000)
    rounded = [Point(Fraction(x), Fraction(y)) for x, y in flat]
    thin = [Point(Fraction(x), e * k) for x, k in ((0, 0), (4, 0), (2, 1), (3, 2))]
    assert are_close([thin], [rounded], Fraction(1, 100))
    assert not are_close([thin], [rounded], e)


def test_crossing_combs_with_different_boxes_are_wrong(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The difference has too many crossings to be measured, but the judge detects it."""
    monkeypatch.setattr("exactsweep.conform.judge.region.MAX_WORK", 1000)
    teeth = [(x, 0 if x % 2 else 300) for x in range(61)]
    case = Case.of("comb", "", [*teeth, (60, -9), (0, -9)], [(0, 0), ("1/9", 0), (0, "1/9")])
    turned = [[y, x] for x, y in case.trajectory.vertices]
    assert judge(case, turned[::-1]).verdict is Verdict.WRONG


# Rounding.


def test_a_hull_far_from_the_origin_is_not_rounding() -> None:
    """2^-32 of the largest coordinate is an eighth of these polygons."""
    far = 2**31
    ring = [(x + far, y + far) for x, y in BLOCK]
    case = Case.of("far", "", ring, SQUARE)
    loop = [[float(x), float(y)] for x, y in find_hull(case.trajectory.vertices)]
    found = judge(case, loop)
    assert found.verdict is Verdict.CONSERVATIVE
    assert found.granted is not None
    assert found.granted < Fraction(1, 10**4)
    thick = [[float(x) - 0.01, float(y)] for x, y in case.trajectory.vertices]
    assert judge(case, thick).verdict is Verdict.WRONG


def test_integers_of_a_program_with_doubles_are_doubles() -> None:
    """Two notches at thirds are lost, each by less than the unit granted to integers."""
    notched = [(0, 0), (3, 0), (3, 3), (2, 3), ("5/3", "8/3"), ("4/3", 3), (0, 3)]
    case = Case.of("notched", "", notched, [(0, 0), ("1/9", 0), (0, "1/9")])
    box = [[round(x), round(y)] for x, y in find_hull(case.trajectory.vertices)]
    assert judge(case, box, numbers="binary64").verdict is not Verdict.WITHIN


def sample_small_cases() -> st.SearchStrategy[Case]:
    return st.sampled_from([case for case in shipped_cases() if case.size <= 20])


@examples(30)
@given(st.deferred(sample_small_cases), st.data())
def test_a_vertex_beyond_the_granted_rounding_is_not_within(
    case: Case, data: st.DataObject
) -> None:
    loop: list[Any] = list(case.trajectory.vertices)
    k = data.draw(st.integers(0, len(loop) - 1))
    granted = judge(case, [[x, y] for x, y in loop[::-1]][:-1], numbers="binary64").granted
    assert granted is not None
    low, high = case.trajectory.bounding_box
    outward = high.x - low.x + 2 * granted
    loop[k] = Point(loop[k].x + outward, loop[k].y)
    assert judge(case, loop, numbers="binary64").verdict not in (
        Verdict.EXACT,
        Verdict.EQUIVALENT,
        Verdict.WITHIN,
    )


def test_sets_of_rings_are_matched_one_to_one() -> None:
    def ring(*pairs: tuple[Any, Any]) -> tuple[Point, ...]:
        return tuple(Point(Fraction(x), Fraction(y)) for x, y in pairs)

    outer = ring((0, 0), (9, 0), (9, 9), (0, 9))
    hole, other = ring((1, 1), (3, 1), (3, 3), (1, 3)), ring((5, 5), (7, 5), (7, 7), (5, 7))
    near = tuple(Point(x + Fraction(1, 9), y) for x, y in hole)
    bound = Fraction(1, 8)

    def match(*rings: tuple[Point, ...], bound: Fraction = bound) -> tuple[int, int]:
        left = list[Sequence[Point]](rings)
        return len([*match_rings([outer, hole, other], left, bound)]), len(left)

    assert match(other[::-1], near, outer) == (0, 0)
    assert match(outer, near, near) == (1, 1)
    assert match(outer, near) == (1, 0)
    assert match(outer, near, other, bound=Fraction(1, 10)) == (1, 1)


# Rounding that changes which rings touch.


WALLS = [(-2, -2), (8, -2), (8, 1), (4, 3), (8, 5), (8, 8), (-2, 8), (-2, 5), (2, 3), (-2, 1)]
"""A hole of D with two tips, between which a diamond fits in one position, (3, 3)."""
DIAMOND = [(0, -1), (1, 0), (0, 1), (-1, 0)]
PINCH = Case.of(
    "pinch", "", [(-4, -4), (10, -4), (10, 10), (-4, 10)], DIAMOND, directrix_holes=[WALLS]
)


def split_at(ring: tuple[Point, ...], p: Point) -> list[list[float]]:
    """Return a ring that starts and ends at its vertex p."""
    k = ring.index(p)
    return [[float(c) for c in vertex] for vertex in (*ring[k + 1 :], *ring[:k])]


@pytest.mark.parametrize("off", [2.0**-51, -(2.0**-51)])
def test_a_pinch_changed_by_an_ulp_is_rounding(off: float) -> None:
    exterior, *holes = list_exact_rings(PINCH, "no_fit")
    below, above = (split_at(hole, Point(Fraction(3), Fraction(3))) for hole in holes)
    outer = [[float(c) for c in vertex] for vertex in exterior]
    opened = [outer, [*below, [3.0 + off, 3.0], *above, [3.0, 3.0]]]
    closed = [outer, [*below, [3.0, 3.0 + off]], [*above, [3.0 - off, 3.0]]]
    for answer, said in ((opened, ", the rounding joins two holes at (3,3)"), (closed, "")):
        part = judge(PINCH, answer, "no_fit", numbers="binary64")
        assert (part.verdict, part.reason) == (Verdict.WITHIN, f"rounded{said}")
    exactly = judge(PINCH, opened, "no_fit", rounding=Fraction(0))
    assert exactly.verdict.severity > Verdict.WITHIN.severity
    # A neck wider than the granted rounding is not rounding.
    opened[1] = [*below, [3.001, 3.0], *above, [2.999, 3.0]]
    far = judge(PINCH, opened, "no_fit", numbers="binary64")
    assert far.verdict in (Verdict.UNSOUND, Verdict.WRONG)


def test_a_neck_closed_by_rounding_is_named() -> None:
    thin = Fraction(1, 2**50)
    walls = [(x + thin * (p == (4, 3)), y) for p in WALLS for x, y in [p]]
    case = Case.of("neck", "", PINCH.directrix_ring, DIAMOND, directrix_holes=[walls])
    assert len(case.holes) == 1
    rings = [[[float(c) for c in p] for p in ring] for ring in list_exact_rings(PINCH, "no_fit")]
    part = judge(case, rings, "no_fit", numbers="binary64")
    assert part.verdict is Verdict.WITHIN
    assert part.reason.startswith("rounded, the rounding separates two holes at (")


# Diagnoses.

D = [(0, 0), (7, 1), (9, 6), (4, 3), (1, 8)]
G = [(2, 1), (5, 2), (3, 4)]
CASE = Case.of("odd", "", D, G, ("1/2", 7))


def test_exact_answers_have_no_diagnosis() -> None:
    assert judge(CASE, [[0, 0], [1, 0], [0, 1]]).diagnosis == ()
    moved = [*CASE.trajectory.vertices[1:], Point(Fraction(-9), Fraction(5))]
    assert judge(CASE, moved).diagnosis == ("one vertex is wrong, the others are exact",)


@pytest.mark.parametrize(
    ("words", "x", "change"),
    [
        ("rounded down to integers", "1/7", lambda c: c // 1),
        ("rounded to integers", "1/7", round),
        ("rounded to 1 decimal", "1/7", lambda c: float(f"{float(c):.1f}")),
        ("rounded to 3 digits", "1/7", lambda c: f"{float(c):.3g}"),
        ("wraps around at 8 bits", 1, lambda c: (c + 128) % 256 - 128 if c == int(c) else c),
    ],
)
def test_arithmetic_errors_are_named(words: str, x: Any, change: Any) -> None:
    case = Case.of("far", "", [(3 * x + 117, 70 * y) for x, y in D], G, (x, 5))
    ring = [[change(x), change(y)] for x, y in case.trajectory.vertices]
    assert words in judge(case, ring, numbers="rational").diagnosis
    # With one different coordinate, the diagnosis would be a guess.
    other = [[ring[0][0], "999"], *ring[1:]]
    assert words not in judge(case, other, numbers="rational").diagnosis


def test_numbers_beyond_doubles_are_kept() -> None:
    far = Case.of("beyond", "", [(10**400 * x, y) for x, y in BLOCK], SQUARE)
    flat = [[x if abs(x) < 10**300 else 0, y] for x, y in far.trajectory.vertices]
    assert judge(far, flat, numbers="rational").diagnosis == ()


@pytest.mark.parametrize(("numbers", "verdict"), [("rational", "unsound"), ("integer", "within")])
def test_only_integer_programs_may_round_to_integers(numbers: str, verdict: str) -> None:
    """And not in a case smaller than a unit, where anything would be within the bound."""
    small = [("1/3", 0), ("2/3", 0), ("1/2", "1/3")]
    case = Case.of("small", "", small, small)
    assert judge(case, [[0, 0], [1, 0], [1, 1]], numbers=numbers).verdict != "within"
    third = Case.of("thirds", "", [(0, 0), (4, 0), (0, 4)], [(0, 0), ("4/3", 0), (0, "4/3")])
    rounded = [[round(x), round(y)] for x, y in third.trajectory.vertices]
    found = judge(third, rounded, numbers=numbers)
    assert found.verdict == verdict


@pytest.mark.parametrize("sign", [1, -1])
def test_the_largest_singles_are_rounded_to_single_precision(sign: int) -> None:
    largest, beyond = sign * Fraction(2**128 - 2**104), sign * Fraction(2**128 - 2**103 - 2**74)
    third, rounded = Fraction(1, 3), Fraction(11184811, 2**25)
    exact = [[Point(beyond - sign, third), Point(beyond, third)]]
    theirs = [[Point(largest, rounded), Point(beyond, rounded)]]
    assert name_arithmetic(exact, theirs) == ("rounded to single precision",)
