"""Shipped layouts: the judge agrees with answers worked out by hand."""

from __future__ import annotations

import json
from fractions import Fraction
from importlib.resources import files
from typing import Any

import pytest
from command import refusal, run
from jsonschema import Draft202012Validator

from exactsweep.check import standalone, verify
from exactsweep.corpus import LayoutCase, find_layout_case, layout_cases
from exactsweep.layout import Fault, Layout, judge_layout
from exactsweep.layout.reading import LayoutError

CASES = {case.id: case for case in layout_cases()}
# No certificate proves these: a self-touching ring, and an undecided fault.
UNPROVED = ["layouts-pinched", "layouts-angle-45-undecided"]
SCHEMA = Draft202012Validator(
    json.loads(files("exactsweep.layout").joinpath("layout.schema.json").read_text("utf-8"))
)


def test_there_are_valid_and_invalid_layouts() -> None:
    valid = [case.expected["valid"] for case in CASES.values()]
    assert len(CASES) >= 40
    assert min(valid.count(True), valid.count(False)) >= 20
    kinds = {fault["kind"] for case in CASES.values() for fault in case.expected["faults"]}
    assert kinds == {
        *("overlap", "outside", "too close", "missing", "surplus"),
        *("turn", "mirror", "shape", "undecided"),
    }


@pytest.mark.parametrize("id", CASES)
def test_verdicts_equal_answers_worked_out_by_hand(id: str) -> None:
    case = CASES[id]
    SCHEMA.validate(case.data)
    judgement = judge_layout(case.layout)
    expected = case.expected
    assert judgement.valid == expected["valid"] == (not expected["faults"])
    wanted = {(f["kind"], tuple(f["placements"])): f for f in expected["faults"]}
    found = {(fault.kind, fault.placements): fault for fault in judgement.faults}
    assert found.keys() == wanted.keys()
    assert len(found) == len(judgement.faults)
    for key, fault in found.items():
        assert tell(fault, case) == wanted[key]
    assert [list(pair) for pair in judgement.contacts] == expected["contacts"]
    if "density" in expected:
        assert judgement.density == Fraction(expected["density"])
    if "distance_squared" in expected:
        assert judgement.distance is not None
        assert judgement.distance.square == Fraction(expected["distance_squared"])


@pytest.mark.parametrize("id", [id for id in CASES if id not in UNPROVED])
def test_both_checkers_prove_its_certificate(id: str) -> None:
    case = CASES[id]
    text = json.dumps(judge_layout(case.layout).certificate())
    found = verify(json.loads(text))
    assert found.proved, found.reason
    valid = "valid" if case.expected["valid"] else "not valid"
    assert f", {valid}" in standalone.prove(standalone.load(text))


@pytest.mark.parametrize("id", UNPROVED)
def test_some_faults_have_no_proof(id: str) -> None:
    with pytest.raises(LayoutError, match="no certificate"):
        judge_layout(CASES[id].layout).certificate()


def is_irrational(fault: Fault, case: LayoutCase) -> bool:
    """Return whether a placement of a fault has an irrational rotation."""
    return any(case.layout.placements[k].turn.exact is None for k in fault.placements)


def tell(fault: Fault, case: LayoutCase) -> dict[str, Any]:
    """Return a fault in the format of a case."""
    data: dict[str, Any] = {"kind": fault.kind, "placements": list(fault.placements)}
    if fault.kind in ("overlap", "outside"):
        depth = None if is_irrational(fault, case) else fault.depth_squared
        data["move_squared"] = None if depth is None else str(depth)
    if fault.distance_squared is not None:
        data["distance_squared"] = str(fault.distance_squared)
    if fault.part is not None:
        data["part"] = fault.part
    if fault.number:
        data["number"] = fault.number
    return data


@pytest.mark.parametrize("id", CASES)
def test_moves_repair_overlaps_and_parts_outside(id: str) -> None:
    case = CASES[id]
    for fault in judge_layout(case.layout).faults:
        if fault.move is None or is_irrational(fault, case):
            continue
        # Only the pair, so that no other part interferes.
        data = {**case.data, "spacing": "0", "margin": "0"}
        numbers = list(fault.placements)
        data["placements"] = [dict(case.data["placements"][k]) for k in numbers]
        moved = data["placements"][-1]
        moved["move"] = [
            str(Fraction(a) + b) for a, b in zip(moved["move"], fault.move, strict=True)
        ]
        left = {other.kind for other in judge_layout(Layout.from_json(data)).faults}
        assert fault.kind not in left


def test_the_command_lists_and_writes_layouts() -> None:
    listed = run("corpus", "layouts").stdout.splitlines()
    assert [line.split()[0] for line in listed] == [*CASES]
    assert listed[0].split(maxsplit=2)[1:] == ["valid", "Six tiles fill a box"]
    lines = run("corpus", "layouts", "--json").stdout.splitlines()
    assert [json.loads(line)["id"] for line in lines] == [*CASES]
    written = run("corpus", "layouts", "layouts-slot").stdout
    assert json.loads(written) == find_layout_case("layouts-slot").data
    said = refusal(run("corpus", "layouts", "layouts-slut"))
    assert said.endswith("did you mean 'layouts-slot'?")
