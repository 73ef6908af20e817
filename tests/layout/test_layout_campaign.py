"""The campaign over layouts: a few trials have no mismatch, and wrong answers are detected."""

from types import SimpleNamespace
from typing import Any

import campaign
import pytest
from known_layouts import SHEET, TILE
from layout_reference import find_difference, find_wrong_move
from layouts import lay, put

from exactsweep import Point
from exactsweep.layout import Fault, judge_layout
from exactsweep.numbers.number import to_fraction

LATER = range(1000, 1100, 25)


@pytest.mark.parametrize(
    "numbers", [range(4), *(pytest.param(range(k, k + 25), marks=pytest.mark.long) for k in LATER)]
)
def test_random_layouts_are_judged_as_by_the_definition(numbers: range) -> None:
    assert campaign.find_failures("layouts", 7, numbers) == []


LAYOUT = lay(SHEET, {"t": TILE}, put("t"), put("t", ("1/2", 0)), put("t", (3, 0)), put("t", (4, 0)))


def changed(**changes: Any) -> Any:
    judgement = judge_layout(LAYOUT)
    names = ("faults", "contacts", "valid", "density", "distance")
    return SimpleNamespace(**{name: getattr(judgement, name) for name in names} | changes)


@pytest.mark.parametrize(
    ("changes", "difference"),
    [
        ({}, ""),
        ({"faults": ()}, "faults: {} and not {('overlap', (0, 1)): 1}"),
        ({"contacts": ()}, "contacts: {(2, 3)}"),
        ({"valid": True}, "valid"),
        ({"density": 1}, "density"),
        ({"distance": None}, "distance: None, not 0"),
        (
            {"faults": (Fault("undecided", (0, 2)),)},
            "(0, 2) undecided",
        ),
    ],
)
def test_wrong_judgements_are_detected(changes: dict[str, Any], difference: str) -> None:
    assert find_difference(LAYOUT, changed(**changes)) == difference


def test_wrong_moves_are_detected() -> None:
    assert find_wrong_move(LAYOUT, judge_layout(LAYOUT), 1) == ""
    for move, wrong in (
        ((1, 0), "a shorter move frees it"),
        (("1/4", 0), "the move does not free"),
    ):
        fault = SimpleNamespace(
            kind="overlap",
            placements=(0, 1),
            bound=0,
            move=Point(*map(to_fraction, move)),
            depth_squared=None,
        )
        judgement: Any = SimpleNamespace(faults=(fault,))
        assert wrong in find_wrong_move(LAYOUT, judgement, 1)
