"""Cases are made, written, read and rejected."""

import copy
import json
from functools import reduce
from operator import getitem
from pathlib import Path
from typing import Any

import pytest
import strategies as own
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import Draft202012Validator
from tiers import examples

from exactsweep import Point, Polygon, sweep
from exactsweep.corpus import Case, CaseError, case_from_json, case_to_json, find_case
from exactsweep.corpus.export import cases_to_svg
from exactsweep.corpus.shipped import read_schema

A_CASE = Draft202012Validator(json.loads(read_schema()))
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
SLOT = [(0, 0), (3, 0), (3, "5/2"), (2, "5/2"), (2, 1), (1, 1), (1, "5/2"), (0, "5/2")]
DATA = case_to_json(Case.of("mine-1", "a slot", SLOT, SQUARE, (0, "1/3"), ["part"]))

SPOILT = json.loads(Path(__file__).with_name("spoilt.json").read_text(encoding="utf-8"))

any_pair = own.pairs("CC") | own.pairs("CM") | own.pairs("MM")


@given(any_pair, own.translations(), st.data())
@examples(30)
def test_json_round_trips(
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


@pytest.mark.parametrize("row", SPOILT, ids=lambda row: "-".join(map(str, row["path"])))
def test_errors_state_the_path_and_agree_with_the_schema(row: dict[str, Any]) -> None:
    """A row has a path, its replacement, the error, and whether the schema accepts the result."""
    data = copy.deepcopy(DATA)
    *path, last = row["path"]
    spoilt: Any = reduce(getitem, path, data)
    if "to" in row:
        spoilt[last] = row["to"]
    else:
        del spoilt[last]
    assert (refusal(data), A_CASE.is_valid(data)) == (row["message"], row["valid"])


def refusal(data: object) -> str | None:
    try:
        case_from_json(data)
    except CaseError as error:
        return str(error)
    return None


def test_long_numbers_are_rejected() -> None:
    ring = [["0", "0"], ["9" * 10**6, "0"], ["0", "1"]]
    with pytest.raises(CaseError, match="more than 137607 digits"):
        case_from_json(DATA | {"directrix": ring})


@pytest.mark.parametrize("data", [None, [], "x", 7, {}, {"id": {}}])
def test_invalid_cases_are_rejected(data: Any) -> None:
    with pytest.raises(CaseError, match=r"^\$"):
        case_from_json(data)


@pytest.mark.parametrize(
    ("count", "columns", "rows"),
    [(0, 1, 0), (1, 1, 1), (4, 2, 2), (5, 3, 2), (10, 4, 3)],
)
def test_pictures_are_arranged_in_a_square(count: int, columns: int, rows: int) -> None:
    head, *_ = cases_to_svg([find_case("fits-square")] * count)
    assert f'viewBox="0 0 {columns * 440} {rows * 370}"' in head
