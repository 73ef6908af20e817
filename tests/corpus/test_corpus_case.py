"""A case: made, written, read, and refused."""

import copy
import json
from collections.abc import Callable
from typing import Any

import pytest
import strategies as own
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import Draft202012Validator
from tiers import examples

from exactsweep import Point, Polygon, sweep
from exactsweep.corpus import Case, CaseError, case_from_json, case_to_json
from exactsweep.corpus.shipped import read_schema

A_CASE = Draft202012Validator(json.loads(read_schema()))
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
SLOT = [(0, 0), (3, 0), (3, "5/2"), (2, "5/2"), (2, 1), (1, 1), (1, "5/2"), (0, "5/2")]
DATA = case_to_json(Case.of("mine-1", "a slot", SLOT, SQUARE, (0, "1/3"), ["part"]))

any_pair = own.pairs("CC") | own.pairs("CM") | own.pairs("MM")


@given(any_pair, own.translations(), st.data())
@examples(30)
def test_json_keeps_everything(
    pair: tuple[Polygon, Polygon], reference: Any, data: st.DataObject
) -> None:
    generatrix, directrix = (data.draw(own.spellings(polygon)) for polygon in pair)
    case = Case.of("mine-1", "drawn", directrix, generatrix, reference)
    text = json.dumps(case_to_json(case))
    again = case_from_json(json.loads(text))
    assert again == case
    assert json.dumps(case_to_json(again)) == text
    A_CASE.validate(json.loads(text))


@given(any_pair, own.translations())
@examples(40)
def test_answers_are_those_of_the_sweep(pair: tuple[Polygon, Polygon], reference: Any) -> None:
    generatrix, directrix = pair
    case = Case.of("mine-1", "drawn", directrix, generatrix, reference)
    s = sweep(generatrix, directrix, reference=reference)
    assert (case.trajectory, case.inner, case.outer) == (s.trajectory, s.inner, s.outer)
    assert (case.exact_fits, case.area, case.kind) == (s.exact_fits, s.area, s.kind)
    assert (case.directrix, case.generatrix) == (directrix, generatrix)
    assert case.size == len(directrix) + len(generatrix)


def test_rings_are_kept_as_given() -> None:
    clockwise = [(0, 1), (1, 1), (1, 1), (1, 0), ("1/2", 0), (0, 0), (0, 1)]
    case = Case.of("mine-1", "as given", clockwise, SQUARE)
    assert case.directrix_ring == own.points(*clockwise[:-1])
    assert case.directrix == Polygon(SQUARE)
    assert {"clockwise", "collinear-vertex", "repeated-vertex"} <= set(case.flags)
    assert case.integer_scale == 2


def test_scale_counts_the_reference_point() -> None:
    case = Case.of("mine-1", "thirds", SQUARE, SQUARE, ("1/3", 0))
    assert case.reference == Point(*own.points(("1/3", 0))[0])
    assert case.integer_scale == 3
    assert sorted(case.representable) == ["int32", "int64"]


def change(*path: Any, to: Any) -> Callable[[Any], None]:
    def apply(data: Any) -> None:
        for step in path[:-1]:
            data = data[step]
        data[path[-1]] = to

    return apply


@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (lambda data: data.pop("title"), r"^\$ has no 'title'$"),
        (lambda data: data["expected"].pop("area"), r"^\$\.expected has no 'area'$"),
        (change("id", to=7), r"^\$\.id is 7, not a string$"),
        (change("class", to="MC"), r"^\$\.class is 'MC', not one of CC, CM, MM, SS$"),
        (change("flags", to="part"), r"^\$\.flags is 'part', not a list$"),
        (change("flags", to=[1]), r"^\$\.flags\[0\] is 1, not a string$"),
        (change("directrix", to=None), r"^\$\.directrix is null, not a list of"),
        (change("directrix", 1, to=["0"]), r"^\$\.directrix\[1\] has 1 coordinates, not 2$"),
        (change("directrix", 1, 0, to=0.5), r"^\$\.directrix\[1\]\[0\] is 0.5, not a number$"),
        (change("directrix", 2, 1, to="2.5"), r"^\$\.directrix\[2\]\[1\] is not '5/2'$"),
        (change("directrix", 2, 1, to="10/4"), r"^\$\.directrix\[2\]\[1\] is not '5/2'$"),
        (change("directrix", 1, 0, to="4/1"), r"^\$\.directrix\[1\]\[0\] is not '4'$"),
        (change("reference", 0, to="-0"), r"^\$\.reference\[0\] is not '0'$"),
        (change("directrix", 1, 0, to="1/0"), "has a zero denominator"),
        (change("directrix", 1, 0, to="9" * 10**6), "more than 137607 digits"),
        (change("directrix", 1, to=["3", "9"]), r"^\$\.directrix: the boundary crosses itself"),
        (change("directrix", to=[["0", "0"]]), r"^\$\.directrix: fewer than three"),
        (change("reference", to=[]), r"^\$\.reference has 0 coordinates, not 2$"),
        (change("representable", to=["int32"]), r"^\$\.representable is not .*int64"),
        (change("integer_scale", to="12"), r"^\$\.integer_scale is not '6'$"),
        (change("expected", to=[]), r"^\$\.expected is a list, not an object$"),
        (
            lambda data: data["expected"]["inner"].reverse(),
            r"^\$\.expected\.inner\[0\]\[1\] is not ",
        ),
        (change("expected", "outer", to=[["0", "0"]] * 3), r"^\$\.expected\.outer: fewer than"),
        (change("expected", "exact_fits", 0, to=[]), r"exact_fits\[0\] has 0 ends, not 2$"),
        (change("expected", "counts", "inner", to=5), r"^\$\.expected\.counts\.inner is not 4$"),
        (change("expected", "representable", to=[]), r"^\$\.expected\.representable is not"),
    ],
)
def test_refusals_say_where(spoil: Callable[[Any], object], message: str) -> None:
    data = copy.deepcopy(DATA)
    assert case_from_json(data).exact_fits
    spoil(data)
    with pytest.raises(CaseError, match=message):
        case_from_json(data)


@pytest.mark.parametrize("data", [None, [], "x", 7, {}, {"id": {}}])
def test_what_is_no_case_is_refused(data: Any) -> None:
    with pytest.raises(CaseError, match=r"^\$"):
        case_from_json(data)
