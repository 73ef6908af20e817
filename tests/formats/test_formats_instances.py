"""Rules in nesting instances are checked or reported as unchecked."""

from __future__ import annotations

import json
from typing import Any

import nests
import pytest

from exactsweep.formats import FormatError
from exactsweep.formats.layouts import FoundLayout, parse_layouts
from exactsweep.layout import Layout, judge_layout

BOX = {"type": "rectangle", "data": {"x_min": 0, "y_min": 0, "width": 9, "height": 9}}
WIDE = {"type": "rectangle", "data": {"x_min": 0, "y_min": 0, "width": 10, "height": 9}}
EMPTY: Any = {"container": {}, "parts": [], "placements": []}
TRIANGLE = {"type": "simple_polygon", "data": [[0, 0], [2, 0], [0, 1]]}


def read(solution: Any, instance: Any) -> list[FoundLayout]:
    return parse_layouts(json.dumps(solution), instance=json.dumps(instance))


def kinds(found: FoundLayout) -> list[str]:
    return [fault.kind for fault in judge_layout(Layout.from_json(found.data)).faults]


def read_jagua(*turns: float, **changes: Any) -> list[FoundLayout]:
    """Read a solution of jagua-rs with one sheet for each rotation."""
    item = {"id": 0, "demand": len(turns), "shape": TRIANGLE, "allowed_orientations": [0, 30]}
    layouts = [
        {
            "container_id": 0,
            "placed_items": [
                {"item_id": 0, "transformation": {"rotation": turn, "translation": [5, 5]}}
            ],
        }
        for turn in turns
    ]
    containers = changes.pop("containers", [])
    sheets: dict[str, Any] = changes or {"bins": [{"id": 0, "stock": 2, "shape": BOX}]}
    return read({"layouts": layouts, "containers": containers}, {"items": [item], **sheets})


@pytest.mark.parametrize("turn", [30.000002, 30.000001907348633])
def test_rotations_rounded_by_jagua_are_allowed(turn: float) -> None:
    (found,) = read_jagua(turn)
    assert kinds(found) == []
    assert found.data["placements"][0]["turn"] == str(turn)
    assert found.notes == (f"item 0: the rotation {turn} is 30 in single precision",)


def test_rotations_rounded_by_jagua_are_noted_once() -> None:
    (note,) = read_jagua(30.000002)[0].notes
    for found in read_jagua(30.000002, 0, 30.000002):
        assert (found.notes, found.unchecked) == ((note,), ("container 0: 3 used, 2 in stock",))
        assert found.data["parts"][0]["turns"] == ["0", "30", "30.000002"]


@pytest.mark.parametrize("turn", [30.00001, 29.999998, 60])
def test_other_rotations_are_not_allowed(turn: float) -> None:
    assert kinds(read_jagua(turn)[0]) == ["turn"]


@pytest.mark.parametrize("turn", [30, 390, -330, 0, 360])
def test_a_full_rotation_changes_nothing(turn: float) -> None:
    (found,) = read_jagua(turn)
    assert (kinds(found), found.notes) == ([], ())


def test_more_containers_than_in_stock_are_noted() -> None:
    assert {found.unchecked for found in read_jagua(0, 0)} == {()}
    (note,) = {found.unchecked for found in read_jagua(0, 0, 0)}
    assert note == ("container 0: 3 used, 2 in stock",)


def test_a_solution_does_not_change_the_bins_of_its_instance() -> None:
    (found,) = read_jagua(0, containers=[{"id": 0, "shape": WIDE}])
    assert ["10", "9"] not in found.data["container"]["exterior"]


@pytest.mark.parametrize(
    ("height", "width", "reason"), [(9, 10, ""), (9, 9.9, "wider"), (8, 10, "taller")]
)
def test_sheets_are_no_larger_than_the_strip(height: float, width: float, reason: str) -> None:
    strips = {"height": height, "max_width": width}
    empty = {"id": 0, "shape": {"type": "simple_polygon", "data": []}}
    assert read_jagua(0, strips=strips, containers=[empty])[0].data["container"]["exterior"] == []
    # The position of a sheet is irrelevant.
    place: dict[str, Any] = {"x_min": 70, "y_min": -30, "width": 10, "height": 9}
    sheets = [{"id": 0, "shape": {"type": "rectangle", "data": place}}]
    if not reason:
        (found,) = read_jagua(0, strips=strips, containers=sheets)
        assert ["80", "-21"] in found.data["container"]["exterior"]
        return
    with pytest.raises(FormatError, match=rf"containers\[0\] is {reason} than the strip"):
        read_jagua(0, strips=strips, containers=sheets)


def test_a_drawn_container_is_no_taller_than_the_strip() -> None:
    text, instance = nests.FILES["sparrow.svg"]
    assert instance is not None
    height = json.loads(instance)["strip_height"]
    lower = json.dumps({**json.loads(instance), "strip_height": height - 0.001})
    assert len(parse_layouts(text, instance=instance)) == 1
    with pytest.raises(FormatError, match="the container is taller than the strip"):
        parse_layouts(text, instance=lower)


def read_packed(
    mirror: bool | None = False, *, bin: Any = None, item: Any = None, parameters: Any = None
) -> FoundLayout:
    """Read the only bin of a solution of packingsolver."""
    shape = {"type": "polygon", "vertices": [{"x": x, "y": y} for x, y in TRIANGLE["data"]]}
    instance = {
        "parameters": parameters or {},
        "bin_types": [{"type": "rectangle", "width": 9, "height": 9, **(bin or {})}],
        "item_types": [{**shape, **(item or {})}],
    }
    placed = {"id": 0, "x": 5, "y": 5, "angle": 0, "mirror": mirror}
    if mirror is None:
        del placed["mirror"]
    (found,) = read({"bins": [{"id": 0, "copies": 1, "items": [placed]}]}, instance)
    return found


def test_the_margin_of_all_bins_is_kept() -> None:
    margin = {"item_bin_minimum_spacing": 3}
    assert kinds(read_packed(parameters=margin)) == ["too close"]
    assert kinds(read_packed(parameters=margin, bin={"item_bin_minimum_spacing": 2})) == []


@pytest.mark.parametrize(("copies", "notes"), [(-1, []), (0, ["container 0: 1 used, 0 in stock"])])
def test_zero_copies_mean_none_and_negative_ones_any_number(copies: int, notes: list[str]) -> None:
    assert [*read_packed(bin={"copies": copies}).unchecked] == notes


def test_items_are_not_mirrored_by_default() -> None:
    assert kinds(read_packed(None)) == []


def test_rotations_of_mirrored_copies_are_rules() -> None:
    turns = [{"start": 0, "end": 0}, {"start": 180, "end": 180}]
    assert kinds(read_packed(mirror=True, item={"allowed_rotations": turns})) == ["mirror"]
    any_turn = {"allowed_rotations": turns, "allow_mirroring": True}
    found = read_packed(mirror=True, item=any_turn)
    assert (kinds(found), found.notes) == ([], ())
    turns[1]["mirror"] = True
    found = read_packed(mirror=True, item={"allowed_rotations": turns})
    assert found.data["parts"][0]["turns"] == ["0"]
    assert found.data["parts"][0]["mirrored_turns"] == ["180"]
    found = read_packed(mirror=True, item={**any_turn, "allowed_rotations": turns})
    assert found.data["parts"][0]["mirrored_turns"] == ["0", "180"]
    assert found.unchecked == ()


def test_fixed_items_are_not_judged_and_defects_may_have_holes() -> None:
    (note,) = read_packed(bin={"fixed_items": [{"item_type_id": 0}]}).unchecked
    assert note == "whether the fixed items of $.bin_types[0] are placed"
    square = {"type": "rectangle", "width": 2, "height": 2}
    holed = {**square, "holes": [{**square, "width": 1, "height": 1}]}
    (defect,) = read_packed(bin={"defects": [holed]}).data["defects"]
    assert (len(defect["holes"]), defect["spacing"]) == (1, "0")


def test_layout_json_has_its_own_rules() -> None:
    with pytest.raises(FormatError, match="Layout JSON has its own parts and rules"):
        read(EMPTY, {"items": []})


def test_a_unit_requires_a_file_with_units() -> None:
    with pytest.raises(FormatError, match="has no unit"):
        parse_layouts(json.dumps(EMPTY), unit="mm")
