"""The campaign over layouts: a few without mismatch, and what is wrong is noticed."""

import random
from types import SimpleNamespace
from typing import Any

import pytest
from known_layouts import SHEET, TILE
from layout_campaign import try_layout
from layout_reference import find_difference, find_wrong_move
from layouts import lay, put
from random_layouts import draw_layout

from exactsweep import Point
from exactsweep.layout import Fault, judge_layout
from exactsweep.numbers.number import to_fraction


@pytest.mark.parametrize("first", range(0, 9, 3))
def test_random_layouts_are_judged_as_by_the_definition(first: int) -> None:
    for number in range(first, first + 3):
        assert try_layout(7, number).failure == ""


@pytest.mark.long
@pytest.mark.parametrize("first", range(1000, 1100, 25))
def test_more_random_layouts(first: int) -> None:
    for number in range(first, first + 25):
        assert try_layout(7, number).failure == ""


def test_layouts_are_known_by_their_seed() -> None:
    first, second = (draw_layout(random.Random("1:7")) for _ in range(2))
    assert first == second


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
def test_wrong_judgements_are_noticed(changes: dict[str, Any], difference: str) -> None:
    assert find_difference(LAYOUT, changed(**changes)) == difference


def test_wrong_moves_are_noticed() -> None:
    assert find_wrong_move(LAYOUT, judge_layout(LAYOUT), 1) == ""
    for move, wrong in (
        ((1, 0), "a shorter move frees it"),
        (("1/4", 0), "the move does not free"),
    ):
        fault = SimpleNamespace(
            kind="overlap", placements=(0, 1), bound=0, move=Point(*map(to_fraction, move))
        )
        judgement: Any = SimpleNamespace(faults=(fault,))
        assert wrong in find_wrong_move(LAYOUT, judgement, 1)
