"""Verdicts worked out by hand, and laws on changed answers."""

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from strategies import points
from tiers import examples

from exactsweep import Point
from exactsweep.check import classify, point_in_polygon
from exactsweep.conform.judge.compare import compare
from exactsweep.conform.judge.verdict import Comparison, PartComparison, Verdict
from exactsweep.conform.judge.witness import WitnessError, is_inside
from exactsweep.corpus import Case, find_case

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
BLOCK = [(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (1, 1), (1, 3), (0, 3)]
# The slot has width two: the square fits. Its trajectory has only integer vertices.
CASE = Case.of("slot", "", BLOCK, SQUARE)
FIT = Case.of("fit", "", BLOCK, [(0, 0), (2, 0), (2, 1), (0, 1)])
# A trajectory with a vertex at thirds.
THIRDS = Case.of("thirds", "", [(0, 0), (3, 0), (3, 4), ("2/3", 1), (0, 1)], SQUARE)
LOOPS = ("trajectory", "inner", "outer")
FAMILIES = ["convex", "notched", "grid", "rectilinear", "turned", "rounded-crossings"]

Loop = Sequence[Sequence[object]]


def drawn_cases() -> st.SearchStrategy[Case]:
    ids = st.builds("gen-{}-3-{}".format, st.sampled_from(FAMILIES), st.integers(0, 40))
    return ids.map(find_case)


def answer(case: Case) -> dict[str, Any]:
    return {
        **{name: getattr(case, name).vertices for name in LOOPS},
        "exact_fits": case.exact_fits,
    }


def part(case: Case, loop: object, name: str = "trajectory", **options: Any) -> PartComparison:
    return compare(case, {name: loop}, **options).parts[0]


def check_witnesses(case: Case, name: str, loop: Loop, found: PartComparison) -> None:
    """Check the documented properties of witnesses by independent means."""
    assert found.permitted is not None
    assert found.forbidden is not None
    assert (found.permitted > 0) == (found.unsound is not None)
    assert (found.forbidden > 0) == (found.conservative is not None)
    exact = getattr(case, name)
    for witness, inside in ((found.unsound, True), (found.conservative, False)):
        if witness is None:
            continue
        t = witness.translation
        if t is not None:
            verdict = classify(case.directrix, case.generatrix, t).verdict
            assert witness.classified == verdict
        if name == "trajectory":
            assert t is not None
            place = Point(t.x + case.reference.x, t.y + case.reference.y)
            assert witness.classified == ("OVERLAP" if inside else "FREE")
            if inside:
                assert witness.point is not None
                moved = case.generatrix.translated(t)
                assert point_in_polygon(witness.point, case.directrix) == 1
                assert point_in_polygon(witness.point, moved) == 1
        else:
            assert witness.point is not None
            place = witness.point
            if t is not None:
                assert point_in_polygon(place, case.generatrix.translated(t)) >= 0
        assert point_in_polygon(place, exact) == (1 if inside else -1)
        assert is_inside(place, [points(*((x, y) for x, y in loop))]) is not inside


@examples(50)
@given(drawn_cases(), st.integers(0, 99))
def test_other_notations_are_equivalent(case: Case, k: int) -> None:
    result = answer(case)
    for name in LOOPS:
        loop = list(result[name])
        at = k % len(loop)
        (ax, ay), (bx, by) = loop[at - 1], loop[at]
        respelled = [
            loop[::-1],
            [*loop[:at], loop[at], *loop[at:]],
            [*loop[:at], ((ax + bx) / 2, (ay + by) / 2), *loop[at:]] if at else loop[::-1],
        ][k % 3]
        assert part(case, respelled, name).verdict is Verdict.EQUIVALENT


@examples(60)
@given(drawn_cases(), st.sampled_from(LOOPS), st.data())
def test_changed_loops_are_judged_by_their_regions(
    case: Case, name: str, data: st.DataObject
) -> None:
    loop: list[Any] = list(getattr(case, name).vertices)
    k = data.draw(st.integers(0, len(loop) - 1))
    by = st.fractions(-2, 2, max_denominator=3)
    if len(loop) > 3 and data.draw(st.booleans()):
        del loop[k]
    else:
        loop[k] = Point(loop[k].x + data.draw(by), loop[k].y + data.draw(by))
    found = part(case, loop, name, rounding=Fraction(0))
    if found.permitted is None or not found.area:
        return
    if found.verdict is not Verdict.MALFORMED:
        sides = found.permitted > 0, found.forbidden != 0
        assert (
            found.verdict
            is {
                (True, False): Verdict.UNSOUND,
                (False, True): Verdict.CONSERVATIVE,
                (True, True): Verdict.WRONG,
            }[sides]
        )
    assert found.distance_squared is not None
    check_witnesses(case, name, loop, found)


def test_a_loop_with_too_many_crossings_is_not_measured() -> None:
    zigzag = [[x, (x * 7919) % 1009] for x in [*range(400), *range(400, 0, -1)]]
    found = part(CASE, zigzag)
    assert found.verdict is Verdict.MALFORMED


def test_the_worst_part_decides() -> None:
    result = {**answer(CASE), "inner": BLOCK, "outer": [[0, 0], [1, 1]]}
    found = compare(CASE, result)
    assert [p.verdict for p in found.parts] == ["exact", "exact", "malformed", "exact"]
    assert found.verdict is Verdict.MALFORMED
    assert found.worst is found.parts[2]


def test_missing_parts_are_unsupported_unless_promised() -> None:
    assert compare(CASE, {}).verdict is Verdict.UNSUPPORTED
    found = compare(CASE, {"inner": BLOCK}, promised=("inner", "outer"))
    assert found.verdict is Verdict.MALFORMED
    assert found.reason == "$.outer is missing"


def test_a_wrong_case_is_detected() -> None:
    lying = replace(CASE, trajectory=CASE.trajectory.translated((1, 0)))
    with pytest.raises(
        WitnessError, match="case slot: the definition contradicts its trajectory near"
    ):
        compare(lying, {"trajectory": CASE.trajectory.vertices})


def test_verdicts_are_ordered_from_best_to_worst() -> None:
    assert [verdict.severity for verdict in Verdict] == list(range(len(Verdict)))
    assert Comparison("a", Verdict.TIMEOUT).worst is None
