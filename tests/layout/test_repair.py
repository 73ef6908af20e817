"""Repairs: moving a placement by `Fault.move` removes the fault."""

from dataclasses import replace
from fractions import Fraction
from random import Random
from typing import Any

import pytest
from layouts import box, lay, put

from exactsweep.layout import Fault, Layout, judge_layout
from exactsweep.layout.repair import enlarge
from exactsweep.numbers.number import Point

SHEET = box(0, 0, 40, 30)
PARTS: dict[str, Any] = {
    "plate": {"exterior": box(0, 0, 9, 6), "holes": [box(3, 2, 6, 4)]},
    "ell": [(0, 0), (7, 0), (7, 2), (2, 2), (2, 5), (0, 5)],
    "kite": [(0, 0), (3, -2), (8, 0), (3, 2)],
}
GAPS = {
    "none": {},
    "spacing": {"spacing": "0.5"},
    "margin": {"margin": "1/3"},
    "both": {"spacing": "0.25", "margin": "0.5"},
}
DEFECTS = [box(18, 12, 22, 16), box(38, 20, 44, 24)]


def move_last(layout: Layout, fault: Fault) -> Layout:
    """Return the layout with only the placements of a fault, the last one repaired."""
    assert fault.move is not None
    placements = [layout.placements[k] for k in fault.placements]
    (x, y), (dx, dy) = placements[-1].move, fault.move
    placements[-1] = replace(placements[-1], move=Point(x + dx, y + dy))
    if len(placements) > 1:
        # Only the pair: the container and other parts are ignored.
        return replace(layout, container=None, defects=(), placements=tuple(placements))
    return replace(layout, placements=tuple(placements))


@pytest.mark.parametrize("gaps", GAPS)
@pytest.mark.parametrize("turns", [(0, 90, 180), (0, 37, "12.5")], ids=["right angles", "any"])
def test_repaired_placements_are_free(gaps: str, turns: tuple[Any, ...]) -> None:
    rng = Random(gaps)
    repaired = 0
    for _ in range(4):
        placements = [
            put(
                rng.choice([*PARTS]),
                (rng.randrange(-1, 38), rng.randrange(-1, 28)),
                rng.choice(turns),
                mirrored=rng.random() < 0.5,
            )
            for _ in range(6)
        ]
        layout = lay(SHEET, PARTS, *placements, defects=DEFECTS, **GAPS[gaps])
        assert len(layout.defects) == 2
        for fault in judge_layout(layout).faults:
            repaired += 1
            assert judge_layout(move_last(layout, fault)).valid, fault
    assert repaired > 10


def test_a_repair_keeps_the_margin() -> None:
    layout = lay(box(0, 0, 10, 10), {"t": box(0, 0, 1, 1)}, put("t", (5, "9.5")), margin="0.5")
    (fault,) = judge_layout(layout).faults
    assert (fault.kind, fault.depth_squared) == ("outside", Fraction(1, 4))
    assert fault.move == Point(Fraction(0), Fraction(-1))


def test_repairs_add_the_missing_distance() -> None:
    layout = lay(
        box(0, 0, 10, 10), {"t": box(0, 0, 1, 1)}, put("t"), put("t", ("1.25", 0)), spacing=1
    )
    (fault,) = judge_layout(layout).faults
    assert fault.kind == "too close"
    assert fault.required == 1
    assert fault.move is not None
    assert 0 <= fault.move.x - Fraction(3, 4) <= Fraction(1, 10**8)
    assert fault.move.y == 0


def test_a_repair_of_corners_is_nearly_the_shortest() -> None:
    # The required diagonal distance is 1, which needs sqrt(1/2) - 1/10 in x and in y.
    tiles = put("t"), put("t", ("1.1", "1.1"))
    layout = lay(box(0, 0, 10, 10), {"t": box(0, 0, 1, 1)}, *tiles, spacing=1)
    (fault,) = judge_layout(layout).faults
    assert fault.move is not None
    length = float(fault.move.x**2 + fault.move.y**2) ** 0.5
    assert 0.99999 < (length + 0.02**0.5) < 1.005


def test_parts_without_a_fit_have_no_repair() -> None:
    layout = lay(box(0, 0, 10, 2), {"t": box(0, 0, 1, 1)}, put("t", (3, 0)), margin="0.6")
    (fault,) = judge_layout(layout).faults
    assert (fault.kind, fault.move) == ("too close", None)


def test_a_tight_fit_with_margins_is_found() -> None:
    layout = lay(box(0, 0, 10, 2), {"t": box(0, 0, 1, 1)}, put("t", (3, 0)), margin="0.5")
    (fault,) = judge_layout(layout).faults
    assert fault.move == Point(Fraction(0), Fraction(1, 2))


@pytest.mark.parametrize("radius", [Fraction(1, 10**9), Fraction(1, 2), Fraction(7, 3)])
def test_an_enlarged_part_keeps_the_distance(radius: Fraction) -> None:
    part = judge_layout(lay(SHEET, PARTS, put("plate", (9, 9)))).layout.part_by_id["plate"].region
    assert part is not None
    grown = enlarge(part, radius)
    low, high = grown.bounding_box
    assert (low, high) == ((-radius, -radius), (9 + radius, 6 + radius))
    assert len(grown.holes) == (radius < 1)


def test_faults_are_accepted_by_depth() -> None:
    tiles = {"t": box(0, 0, 1, 1)}
    deep = lay(SHEET, tiles, put("t", (3, 3)), put("t", ("3.999", 3)))
    (fault,) = judge_layout(deep).faults
    assert fault.is_within(Fraction(1, 1000))
    assert not fault.is_within(Fraction(999, 10**6))
    close = lay(SHEET, tiles, put("t", (3, 3)), put("t", ("4.999", 3)), spacing=1)
    (fault,) = judge_layout(close).faults
    assert fault.is_within(Fraction(1, 1000))
    assert not fault.is_within(Fraction(999, 10**6))
    missing = lay(SHEET, {"t": {"exterior": box(0, 0, 1, 1), "demand": 1}})
    (fault,) = judge_layout(missing).faults
    assert not fault.is_within(Fraction(10**9))


def test_undecided_pairs_are_accepted_by_their_bound() -> None:
    part = {"exterior": box(0, 0, 1, 1), "error": "1/100"}
    layout = lay(SHEET, {"t": part}, put("t", (3, 3)), put("t", ("3.999", 3)))
    (fault,) = judge_layout(layout).faults
    assert (fault.kind, fault.bound) == ("undecided", Fraction(1, 50))
    assert fault.is_within(Fraction(21, 1000))
    assert not fault.is_within(Fraction(20, 1000))
