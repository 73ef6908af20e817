"""Verdicts: each by hand, and by laws on answers that are changed in known ways."""

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
from exactsweep.conform.judge.verdict import AnswerError, Comparison, PartComparison, Verdict
from exactsweep.conform.judge.witness import WitnessError, is_inside
from exactsweep.corpus import Case, find_case

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
BLOCK = [(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (1, 1), (1, 3), (0, 3)]
# The slot is two wide: the square goes in. Its trajectory has vertices at integers only.
CASE = Case.of("slot", "", BLOCK, SQUARE)
FIT = Case.of("fit", "", BLOCK, [(0, 0), (2, 0), (2, 1), (0, 1)])
# A trajectory that has a vertex at thirds.
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
    """Check the promises of the docstrings about witnesses, by independent means."""
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
def test_another_way_to_give_the_set_is_equivalent(case: Case, k: int) -> None:
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
def test_a_changed_loop_is_judged_by_the_sets(case: Case, name: str, data: st.DataObject) -> None:
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
    assert 0 < found.distance_squared[0] <= found.distance_squared[1]
    check_witnesses(case, name, loop, found)


@pytest.mark.parametrize(
    ("loop", "verdict", "permitted", "forbidden"),
    [
        # The slot filled: two positions wide, two deep.
        ([(-1, -1), (4, -1), (4, 3), (-1, 3)], "conservative", "0", "2"),
        # A corner cut off.
        (
            [(0, -1), (4, -1), (4, 3), (2, 3), (2, 1), (1, 1), (1, 3), (-1, 3), (-1, 0)],
            "unsound",
            "1/2",
            "0",
        ),
        # The reference point wrong.
        ([(x + 1, y) for x, y in CASE.trajectory.vertices], "wrong", "6", "6"),
        # The sign of G wrong.
        ([(0, 0), (5, 0), (5, 4), (4, 4), (4, 1), (2, 1), (2, 4), (0, 4)], "wrong", "12", "8"),
    ],
)
def test_known_answers(loop: Loop, verdict: str, permitted: str, forbidden: str) -> None:
    found = part(CASE, loop)
    assert found.verdict == verdict
    assert (str(found.permitted), str(found.forbidden)) == (permitted, forbidden)
    check_witnesses(CASE, "trajectory", loop, found)


def test_a_hole_is_conservative_or_unsound_like_any_other_difference() -> None:
    outer = list(CASE.trajectory.vertices)
    hole = [[0, 0], [1, 0], [0, "1/2"]]
    found = part(CASE, [outer, hole])
    assert found.verdict is Verdict.UNSOUND
    assert found.permitted == Fraction(1, 4)
    # The boundary of the hole counts for the distance, which the area alone would hide.
    assert found.distance_squared is not None
    assert found.distance_squared[0] >= Fraction(1, 2)


def test_two_rings_that_touch_may_be_the_set() -> None:
    left = [[-1, -1], [0, -1], [0, 3], [-1, 3]]
    right = [[0, -1], [4, -1], [4, 3], [2, 3], [2, 1], [1, 1], [1, 3], [0, 3]]
    assert part(CASE, [left, right]).verdict is Verdict.EQUIVALENT


@pytest.mark.parametrize(
    ("loop", "says"),
    [
        ([], "$.trajectory is empty"),
        ([[]], "$.trajectory[0] is empty"),
        (None, "$.trajectory is None, not a list of vertices"),
        ("POLYGON", "$.trajectory is 'POLYGON', not a list of vertices"),
        ([[0, 0], [1]], "$.trajectory[1] has 1 coordinates, not 2"),
        ([[0, 0], [1, float("nan")]], "$.trajectory[1]: nan is not a finite number"),
        ([[0, 0], [1, "Infinity"]], "$.trajectory[1]: 'Infinity' is not a number such as"),
        ([[0, 0], [1, True]], "$.trajectory[1]: True is a truth value, not a number"),
        ([[0, 0], [1, None]], "$.trajectory[1]: None is not a rational number"),
        ([[0, 0], {"x": 1}], "$.trajectory[1] is an object, not a pair of numbers"),
        ([[0, 0], [1, 1]], "$.trajectory: fewer than three"),
        ([[0, 0], [1, 1], [2, 2]], "$.trajectory: "),
        ([[0, 0], [2, 2], [2, 0], [0, 2]], "$.trajectory: the boundary crosses itself"),
        (
            [[[0, 0], [2, 0], [0, 2]], [[1, 0], [3, 0], [1, 2]]],
            "$.trajectory: rings 0 and 1 overlap",
        ),
        ([SQUARE, SQUARE], "$.trajectory: rings 0 and 1 overlap"),
        ([[0, 0]] * (2**20 + 1), "$.trajectory has more than 1,048,576 vertices (max_mib)"),
        ([[0, "1e9999"], [1, 1]], "$.trajectory[0]: '1e9999' has more than 4300 digits"),
    ],
)
def test_what_is_no_loop_is_malformed(loop: object, says: str) -> None:
    found = part(CASE, loop)
    assert found.verdict is Verdict.MALFORMED
    assert found.reason.startswith(says)


def test_a_loop_that_crosses_itself_is_measured_all_the_same() -> None:
    found = part(CASE, [[0, 0], [2, 2], [2, 0], [0, 2]])
    assert found.verdict is Verdict.MALFORMED
    # Two triangles of area one, of which (1, 1) to (2, 1) cuts off the corner of the slot.
    assert found.permitted == CASE.trajectory.area - 2 + Fraction(1, 2)
    assert found.forbidden == Fraction(1, 2)
    assert found.unsound is not None


def test_a_loop_that_crosses_itself_without_end_is_not_measured() -> None:
    zigzag = [[x, (x * 7919) % 1009] for x in [*range(400), *range(400, 0, -1)]]
    found = part(CASE, zigzag)
    assert found.verdict is Verdict.MALFORMED


def test_rounding_is_what_is_declared_before_what_is_guessed() -> None:
    third = THIRDS.trajectory.vertices
    rounded = [[str(round(c * 100) / Fraction(100)) for c in vertex] for vertex in third]
    assert part(THIRDS, rounded).verdict is not Verdict.WITHIN
    assert part(THIRDS, rounded, rounding=Fraction(1, 100)).verdict is Verdict.WITHIN
    result = {"trajectory": rounded, "rounding": "1/100"}
    assert compare(THIRDS, result).verdict is Verdict.WITHIN
    assert compare(THIRDS, {**result, "rounding": "x"}).verdict is Verdict.MALFORMED


def test_integers_need_no_rounding_where_the_exact_loop_has_none() -> None:
    loop = [[-1, -1], [4, -1], [4, 3], [2, 3], [2, 1], [1, 1], [1, 3], [-1, 3]]
    assert part(CASE, loop).verdict is Verdict.EXACT
    near = [[3, -1], *loop[1:], [-1, 0]]
    assert part(CASE, near).verdict is not Verdict.WITHIN


def test_exact_fits_are_a_part_of_their_own() -> None:
    right = answer(FIT)
    fits = right.pop("exact_fits")
    dropped = compare(FIT, right)
    assert dropped.verdict is Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS
    assert dropped.reason == "1 exact fit missing"
    assert dropped.witness is not None
    assert dropped.witness.classified == "CONTACT"
    turned = [[q, p] for p, q in fits]
    assert compare(FIT, {**right, "exact_fits": turned}).verdict is Verdict.EXACT
    assert compare(FIT, {"inner": right["inner"]}).verdict is Verdict.EXACT


def test_the_worst_part_decides() -> None:
    result = {**answer(CASE), "inner": BLOCK, "outer": [[0, 0], [1, 1]]}
    found = compare(CASE, result)
    assert [p.verdict for p in found.parts] == ["exact", "exact", "malformed", "exact"]
    assert found.verdict is Verdict.MALFORMED
    assert found.worst is found.parts[2]


def test_what_is_missing_is_unsupported_unless_promised() -> None:
    assert compare(CASE, {}).verdict is Verdict.UNSUPPORTED
    found = compare(CASE, {"inner": BLOCK}, promised=("inner", "outer"))
    assert found.verdict is Verdict.MALFORMED
    assert found.reason == "$.outer is missing"


@pytest.mark.parametrize("result", [None, [], "exact", 3, [[0, 0]]])
def test_an_answer_that_is_no_object_is_malformed(result: object) -> None:
    assert compare(CASE, result).verdict is Verdict.MALFORMED


def test_the_answer_of_another_case_is_refused() -> None:
    with pytest.raises(AnswerError, match="the answer is that of 'other', not of 'slot'"):
        compare(CASE, {"id": "other"})


def test_a_case_that_is_wrong_itself_is_found_out() -> None:
    lying = replace(CASE, trajectory=CASE.trajectory.translated((1, 0)))
    with pytest.raises(WitnessError, match="case slot: its trajectory is refuted near"):
        compare(lying, {"trajectory": CASE.trajectory.vertices})


def test_a_comparison_is_plain_data() -> None:
    data = compare(CASE, {"trajectory": points((-1, -1), (4, -1), (4, 3), (-1, 3))}).to_json()
    assert data["verdict"] == "conservative"
    assert data["parts"][0]["forbidden"] == "2"
    assert data["parts"][0]["conservative"]["classified"] == "FREE"


def test_verdicts_are_ordered_from_best_to_worst() -> None:
    assert [verdict.severity for verdict in Verdict] == list(range(len(Verdict)))
    assert Comparison("a", Verdict.TIMEOUT).worst is None
