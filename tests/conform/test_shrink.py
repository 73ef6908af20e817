"""Failing cases are reduced to smaller ones with the same fault."""

from collections import Counter
from fractions import Fraction
from typing import Any

import pytest

from exactsweep import Polygon
from exactsweep.conform.judge.compare import compare
from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.runner import conform
from exactsweep.conform.run.shrink import ShrinkError, shrink
from exactsweep.corpus import Case, find_case
from exactsweep.numbers.number import ORIGIN


def sign_wrong(case: Case) -> Verdict:
    return compare(case, {"trajectory": case.trajectory.reflected().vertices}).verdict


def overflowing(case: Case) -> Verdict:
    """Return a verdict that depends only on the size of numbers."""
    largest = max(abs(c) for point in case.directrix_ring for c in point)
    return Verdict.WRONG if largest > 2**20 else Verdict.EXACT


def test_a_lost_fit_is_shrunk_to_a_slot() -> None:
    def loses_fits(case: Case) -> Verdict:
        return compare(case, {"trajectory": case.trajectory.vertices}).verdict

    case = find_case("gen-fits-1-2")
    assert loses_fits(case) is Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS
    small = shrink(case, loses_fits)
    assert len(small.exact_fits) == 1
    assert small.size <= 12


def test_both_polygons_are_moved_to_the_origin_at_once() -> None:
    d, g = [(100, 200), (104, 200), (100, 205)], [(300, 500), (303, 500), (300, 504)]
    small = shrink(Case.of("far", "", d, g, (7, 9)), lambda case: "wrong", tries=3)
    assert (small.id, small.title) == ("far-shrunk", "shrunk: ")
    assert small.directrix == Polygon([(0, 0), (4, 0), (0, 5)])
    assert (small.generatrix, small.reference) == (Polygon([(0, 0), (3, 0), (0, 4)]), ORIGIN)


def test_numbers_are_shortened_as_far_as_the_failure_allows() -> None:
    case = Case.of(
        "large", "", [(0, 0), (10**9, 1), (10**9, 10**9), (7, 10**9)], [(3, 3), (5, 3), (4, 9)]
    )
    small = shrink(case, overflowing)
    assert small.size == 6
    largest = max(abs(c) for point in small.directrix_ring for c in point)
    assert 2**20 < largest <= 2**21
    assert sorted(abs(c) for point in small.directrix_ring for c in point)[-2] <= 1


def test_fractions_and_the_reference_point_are_removed() -> None:
    case = Case.of(
        "fractions",
        "",
        [("1/3", 0), ("22/7", "1/2"), (3, "17/5"), ("-1/9", 4)],
        [(0, 0), ("5/3", 0), (0, "9/7")],
        reference=("1/2", 7),
    )
    assert sign_wrong(case) is Verdict.WRONG
    small = shrink(case, sign_wrong)
    assert sign_wrong(small) is Verdict.WRONG
    assert small.integer_scale == 1
    assert small.size == 6
    assert small.reference == ORIGIN


def test_shrinking_adds_no_flag() -> None:
    """A program that loses long edges also fails on repeated vertices, which is another fault."""

    def loses_long_rings(case: Case) -> Verdict:
        fails = len(case.directrix) > 4 or "repeated-vertex" in case.flags
        return Verdict.WRONG if fails else Verdict.EXACT

    case = find_case("gen-monotone-1-0")
    small = shrink(case, loses_long_rings)
    assert len(small.directrix) == 5
    assert set(small.flags) <= set(case.flags)


def test_the_fault_is_preserved() -> None:
    """A case with one crash must not become a case with another crash."""
    case = find_case("gen-monotone-1-0")

    def crash(directrix: Any, generatrix: Any, reference: Any) -> Any:
        if len(directrix) + len(generatrix) > 8:
            raise IndexError(f"vertex {len(directrix)} of {len(generatrix)}")
        raise IndexError("no such chain")

    run = conform(crash, [case], name="crashes", made_smaller=1)
    small = run.shrunk[case.id]
    assert small.fault.startswith("crash: IndexError: vertex # of #; test_shrink.py line ")
    assert small.case is not None
    assert len(small.case["directrix"]) + len(small.case["generatrix"]) == 9


def test_an_irrelevant_hole_is_removed() -> None:
    plate, hole, part = [(0, 0), (9, 0), (9, 9)], [(5, 1), (7, 1), (7, 3)], [(0, 0), (1, 0), (1, 1)]
    case = Case.of("plate", "", plate, part, directrix_holes=[hole])
    assert len(shrink(case, lambda _: "wrong").directrix_rings) == 1


def test_the_search_stays_within_its_budget() -> None:
    asked: Counter[str] = Counter()

    def judge(case: Case) -> Verdict:
        asked[case.id] += 1
        return Verdict.CRASH

    shrink(find_case("gen-monotone-1-0"), judge, tries=7)
    assert asked.total() == 7
    shrink(find_case("gen-monotone-1-0"), judge, seconds=0)
    assert asked.total() == 8


def test_a_minimal_pair_is_unchanged() -> None:
    case = Case.of("tiny", "", [(0, 0), (1, 0), (0, 1)], [(0, 0), (1, 0), (0, 1)])
    same = shrink(case, lambda _: Verdict.CRASH)
    assert Polygon(same.directrix_ring).area == Fraction(1, 2)
    assert same.size == 6


def test_a_case_that_does_not_fail_is_rejected() -> None:
    with pytest.raises(ShrinkError, match="case fits-square does not fail: exact"):
        shrink(find_case("fits-square"), lambda _: Verdict.EXACT)
