"""Judged layouts, with answers worked out by hand."""

from dataclasses import replace
from fractions import Fraction
from math import isqrt
from typing import Any

import pytest
from known_layouts import FAULTY, SHEET, TILE, TRIANGLE, VALID
from layouts import box, image, lay, put

from exactsweep import Point
from exactsweep.corpus import layout_cases
from exactsweep.layout import Judgement, judge_layout
from exactsweep.layout.verdict import judge_pair


def kinds(judgement: Judgement) -> list[tuple[str, tuple[int, ...]]]:
    return [(fault.kind, fault.placements) for fault in judgement.faults]


def point(x: Any, y: Any) -> Point:
    return Point(Fraction(x), Fraction(y))


LAYOUTS = VALID | {name: layout for name, (layout, _) in FAULTY.items()}
LAYOUTS |= {case.id: case.layout for case in layout_cases() if len(case.layout.placements) < 20}


# Parts left of the origin and below it. With numbers as long as the last one they share no lattice.
@pytest.mark.parametrize("factor", [Fraction(1, 3), Fraction(9, 7**400)], ids=["third", "tiny"])
@pytest.mark.parametrize("name", LAYOUTS)
def test_a_layout_scaled_and_moved_as_a_whole_has_the_same_faults(
    name: str, factor: Fraction
) -> None:
    one = judge_layout(LAYOUTS[name])
    other = judge_layout(image(LAYOUTS[name], factor, -1000 * factor, Fraction(-777, 2) * factor))
    assert kinds(other) == kinds(one)
    assert other.contacts == one.contacts
    densities = [judgement.density or Fraction(0) for judgement in (one, other)]
    assert abs(densities[0] - densities[1]) <= one.density_error + other.density_error


def test_an_overlap_is_proved_and_measured() -> None:
    layout = lay(SHEET, {"t": TRIANGLE}, put("t", (1, 1)), put("t", (5, 3), 180))
    (fault,) = judge_layout(layout).faults
    # Both hypotenuses have the direction (4, -3): the second one lies 4/5 inside the first one.
    assert fault.move == point("12/25", "16/25")
    assert fault.depth_squared == Fraction(16, 25)
    (inside,) = fault.points
    first = layout.parts[0].region
    assert first is not None
    assert first.translated((1, 1)).contains(inside, strictly=True)
    assert first.rotated(180).translated((5, 3)).contains(inside, strictly=True)


def test_equal_faults_compare_equal() -> None:
    tile = {"t": box(0, 0, 2, 2)}
    (fault,) = judge_layout(lay(SHEET, tile, put("t", (2, 2)), put("t", (3, 3)))).faults
    assert replace(fault, _bits=7, wall=1, _board=None) == fault
    assert replace(fault, placements=(1, 0)) != fault


def test_a_part_as_wide_as_the_container_is_moved_onto_an_exact_fit() -> None:
    (fault,) = judge_layout(lay(SHEET, {"t": box(0, 0, 10, 1)}, put("t", ("0.1", 4)))).faults
    assert fault.move == point("-1/10", 0)


@pytest.mark.parametrize("digits", [3, 9, 20, 30, 50, 60])
def test_rotated_corners_that_nearly_touch_are_decided(digits: int) -> None:
    # Unit squares standing on a corner are sqrt(2) wide.
    unit = 10**digits
    for gap, kind in ((0, "overlap"), (1, "too close")):
        for k, found in ((0, [(kind, (0, 1))]), (1, [])):
            apart = gap + Fraction(isqrt(2 * unit * unit) + k, unit)
            turned = put("t", (3, 3), 45), put("t", (3 + apart, 3), 45)
            layout = lay(SHEET, {"t": box(0, 0, 1, 1)}, *turned, spacing=gap)
            assert kinds(judge_layout(layout)) == found


@pytest.mark.parametrize("place", [(1, 4), (17, 4), (4, 1), (4, 13)])
def test_a_part_keeps_the_margin_on_every_side(place: tuple[int, int]) -> None:
    sheet, part = box(0, 0, 20, 16), box(0, 0, 2, 2)
    (fault,) = judge_layout(lay(sheet, {"t": part}, put("t", place), margin="3/2")).faults
    assert fault.kind == "too close"
    assert fault.distance_squared == 1
    assert judge_layout(lay(sheet, {"t": part}, put("t", place), margin="1")).valid


def test_faults_as_json() -> None:
    layout = lay(
        SHEET,
        {"t": {"exterior": TILE, "demand": 3}, "bow": [(0, 0), (1, 1), (1, 0), (0, 1)]},
        put("t"),
        put("t", ("1/2", 0)),
    )
    overlap, missing, shape = (fault.to_json() for fault in judge_layout(layout).faults)
    assert overlap == {
        "kind": "overlap",
        "placements": [0, 1],
        "points": [["3/4", "1/2"]],
        "depth_squared": "1/4",
        "move": ["1/2", "0"],
    }
    assert missing == {"kind": "missing", "placements": [0, 1], "part": "t", "number": 1}
    assert shape["part"] == "bow"
    assert "edges 0 and 2 cross" in shape["reason"]


def test_defects_far_from_a_part_take_no_time(monkeypatch: pytest.MonkeyPatch) -> None:
    # 100 parts, each next to one of 100 defects, in a container that is not a box.
    asked = 0

    def judge_and_count(*pair: Any) -> Any:
        nonlocal asked
        asked += 1
        return judge_pair(*pair)

    monkeypatch.setattr("exactsweep.layout.judge.judge_pair", judge_and_count)
    sheet = [(0, 0), (400, 0), (400, 9), (399, 10), (0, 10)]
    defects = [box(4 * k + 2, 1, 4 * k + 3, 2) for k in range(100)]
    placed = [put("tile", (4 * k, k % 2)) for k in range(100)]
    assert judge_layout(lay(sheet, {"tile": box(0, 0, 2, 2)}, *placed, defects=defects)).valid
    assert asked <= 200
