"""Rules in the files of nesting programs are read, or listed as not judged."""

import json
from fractions import Fraction
from typing import Any

import pytest

from exactsweep.formats import FormatError
from exactsweep.formats.layouts import parse_layouts
from exactsweep.layout import Layout, judge_layout

TRIANGLE = {"type": "simple_polygon", "data": [[0, 0], [4, 0], [0, 3]]}


def solve(orientation: Any, *motions: dict[str, Any], **rest: Any) -> str:
    item = {"id": 7, "demand": len(motions), "orientation": orientation, "shape": TRIANGLE}
    placed = [{"item_id": 7, "transformation": motion} for motion in motions]
    layout = {"container_id": 0, "placed_items": placed, "density": 0.1}
    solution = {"strip_width": 60, "layout": layout}
    return json.dumps(
        {"name": "x", "items": [item], "strip_height": 40, "solution": solution, **rest}
    )


def at(x: float, y: float, turn: float = 0, **reflected: bool) -> dict[str, Any]:
    return {"rotation": turn, "translation": [x, y], **reflected}


def judge(text: str) -> list[str]:
    (found,) = parse_layouts(text)
    return [fault.kind for fault in judge_layout(Layout.from_json(found.data)).faults]


FIXED = {"rotation": {"mode": "discrete", "angles": [0]}}
STEPPED = {"rotation": {"mode": "stepped", "step": 90}}
FREE = {"rotation": {"mode": "continuous"}}


@pytest.mark.parametrize(
    ("orientation", "motion", "faults"),
    [
        (FIXED, at(20, 20), []),
        (FIXED, at(20, 20, 360), []),
        (FIXED, at(20, 20, 90), ["turn"]),
        (FIXED, at(20, 20, 180, reflected=True), ["mirror"]),
        (FIXED, at(20, 20, 0, reflected=True), ["turn", "mirror"]),
        (STEPPED, at(20, 20, 270), []),
        (STEPPED, at(20, 20, 45), ["turn"]),
        (FREE, at(20, 20, 45), []),
        (FREE, at(20, 20, 0, reflected=True), ["mirror"]),
        # Mirroring in the Y axis is mirroring in the X axis and rotating by 180 degrees.
        ({**FIXED, "reflection_axes": [90]}, at(20, 20, 180, reflected=True), []),
        ({**FIXED, "reflection_axes": [90]}, at(20, 20, 0, reflected=True), ["turn"]),
        ({**FIXED, "reflection_axes": [0]}, at(20, 20, 0, reflected=True), []),
        ({**FIXED, "reflection_axes": [45]}, at(20, 20, 90.00001, reflected=True), []),
        ({**FIXED, "reflection_axes": [0]}, at(20, 20, 180), ["turn"]),
        ({**STEPPED, "reflection_axes": [0]}, at(20, 20, 90, reflected=True), []),
        ({**FREE, "reflection_axes": [12]}, at(20, 20, 1, reflected=True), []),
    ],
)
def test_orientations_are_rules(orientation: Any, motion: Any, faults: list[str]) -> None:
    assert judge(solve(orientation, motion)) == faults


def test_reflected_items_are_mirrored_in_the_x_axis() -> None:
    text = solve({**FREE, "reflection_axes": [0]}, at(20, 20, 90, reflected=True))
    (found,) = parse_layouts(text)
    layout = Layout.from_json(found.data)
    a, b, c, d = layout.placements[0].rows()
    # (4, 0) is unchanged by mirroring, then rotates to (0, 4); (0, 3) goes to (0, -3), then (3, 0).
    assert (a, c, b, d) == (Fraction(0), Fraction(1), Fraction(1), Fraction(0))


@pytest.mark.parametrize(
    ("x", "gap", "faults"),
    [(6.25, 0.25, []), (6.25, 0.5, ["too close"]), (6.25, "1/4", [])],
)
def test_separation_applies_between_items(x: float, gap: Any, faults: list[str]) -> None:
    text = solve(FIXED, at(2, 2), at(x, 2), min_item_separation=gap)
    assert judge(text) == faults


def test_separation_also_applies_to_the_container() -> None:
    assert judge(solve(FIXED, at(1, 2), min_item_separation=1)) == []
    assert judge(solve(FIXED, at(0.5, 2), min_item_separation=1)) == ["too close"]


@pytest.mark.parametrize(
    ("orientation", "message"),
    [
        ({"rotation": {"mode": "stepped", "step": 70}}, "does not divide 360 degrees"),
        ({"rotation": {"mode": "stepped", "step": 0}}, "does not divide 360 degrees"),
        ({"rotation": {"mode": "any"}}, "'any' is not a rotation mode"),
        ({}, "has no 'rotation'"),
    ],
)
def test_invalid_orientations_are_rejected(orientation: Any, message: str) -> None:
    with pytest.raises(FormatError, match=message):
        parse_layouts(solve(orientation, at(2, 2)))


def test_unknown_fields_are_named() -> None:
    text = solve({**FIXED, "tilt": 3}, at(2, 2), curfew=1)
    (found,) = parse_layouts(text)
    assert found.unchecked == (
        "the unknown field 'curfew'",
        "the unknown field 'items.orientation.tilt'",
    )


def test_a_defect_keeps_its_own_spacing() -> None:
    square = {"type": "rectangle", "width": 2, "height": 2}
    instance = {
        "parameters": {"item_item_minimum_spacing": 0},
        "item_types": [{**square, "copies": 1}],
        "bin_types": [
            {
                "type": "rectangle",
                "width": 10,
                "height": 10,
                # It crosses the edge of the sheet.
                "defects": [{**square, "x": 9, "y": 0, "item_defect_minimum_spacing": 3}],
            }
        ],
    }
    for x, faults in ((4, []), (4.5, ["too close"])):
        placed = {"id": 0, "x": x, "y": 0, "angle": 0}
        solution = {"bins": [{"id": 0, "copies": 1, "items": [placed]}]}
        (found,) = parse_layouts(json.dumps(solution), instance=json.dumps(instance))
        assert found.unchecked == ()
        judged = judge_layout(Layout.from_json(found.data))
        assert [fault.kind for fault in judged.faults] == faults
