"""The proved slack of valid layouts: shrinking containers, growing parts."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exactsweep import Point
from exactsweep.check.standalone import prove
from exactsweep.layout import Layout, judge_layout
from exactsweep.layout.slack import ProvedSlack, find_slack

TILE = {"id": "tile", "exterior": [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]]}
DISC = {"id": "disc", "pieces": [{"points": [["0", "0"]], "radius": "1"}]}


def square(side: Any) -> dict[str, Any]:
    return {"exterior": [["0", "0"], [str(side), "0"], [str(side), str(side)], ["0", str(side)]]}


def shrink(part: Any, moves: list[Any], container: Any, **more: Any) -> ProvedSlack | None:
    placed = [{"part": part["id"], "move": [*map(str, move)]} for move in moves]
    data = {"container": container, "parts": [part], "placements": placed, **more}
    return find_slack(judge_layout(Layout.from_json(data)))


def test_a_square_shrinks_to_its_parts() -> None:
    found = shrink(TILE, [(0, 0), ("5/2", "1/2")], square(7), margin="0")
    assert found is not None
    assert (found.scale, found.growth) == (Fraction(1, 2), Fraction(3, 4))
    assert found.center == Point(Fraction(0), Fraction(0))


def test_margin_and_spacing_are_kept() -> None:
    found = shrink(TILE, [(1, 1), (4, 1)], square(12), margin="1", spacing="1")
    assert found is not None
    assert (found.scale, found.growth) == (Fraction(1, 2), Fraction(1, 2))


def test_a_disc_shrinks_about_its_center() -> None:
    container = {"pieces": [{"points": [["0", "0"]], "radius": "12"}]}
    found = shrink(DISC, [(3, 4), (-3, 0)], container)
    assert found is not None
    assert found.scale == Fraction(1, 2)


@given(st.fractions(min_value=0, max_value=3), st.fractions(min_value=0, max_value=3))
def test_the_shrunk_layout_is_valid_and_cannot_shrink(x: Fraction, y: Fraction) -> None:
    container = {"exterior": [["0", "0"], ["9", "0"], ["12", "9"], ["0", "12"]]}
    found = shrink(DISC, [(x + 1, y + 1)], container)
    assert found is not None
    judgement = judge_layout(found.layout)
    assert judgement.valid
    assert prove(judgement.certificate())
    again = find_slack(judgement)
    assert again is not None
    assert 1 - again.scale < Fraction(1, 10**25)


@pytest.mark.parametrize("turn", ["30", "77.7"])
def test_irrational_rotations_reduce_the_slack(turn: str) -> None:
    placed = [{"part": "tile", "turn": turn, "move": ["3", "3"]}]
    data = {"container": square(9), "parts": [TILE], "placements": placed}
    found = find_slack(judge_layout(Layout.from_json(data)))
    assert found is not None
    assert judge_layout(found.layout).valid


@pytest.mark.parametrize(
    ("container", "moves"),
    [
        (None, [(0, 0)]),
        (square(9), [(0, 0), (0, 0)]),
        ({"exterior": [["0", "0"], ["9", "0"], ["9", "9"], ["8", "1"]]}, [(7, 0)]),
        ({**square(9), "holes": [[["7", "7"], ["8", "7"], ["8", "8"]]]}, [(0, 0)]),
    ],
)
def test_other_layouts_have_no_slack(container: Any, moves: list[Any]) -> None:
    assert shrink(TILE, moves, container) is None
