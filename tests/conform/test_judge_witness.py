"""Witnesses for points of loops, worked out by hand."""

import pytest

from exactsweep.conform.judge.compare import compare
from exactsweep.corpus import Case

Ring = list[tuple[int, int]]


def box(side: int, low: int = 0) -> Ring:
    high = low + side
    return [(low, low), (high, low), (high, high), (low, high)]


@pytest.mark.parametrize(
    ("directrix", "hole", "side", "place"),
    [
        (10, [], 1, "D"),
        # G does not fit into the hole that contains the witness.
        (10, [box(8, 1)], 9, "the inner loop"),
    ],
)
def test_an_unreachable_point_is_enclosed_by_the_sweep(
    directrix: int, hole: list[Ring], side: int, place: str
) -> None:
    case = Case.of("enclosed", "", box(directrix), box(side), directrix_holes=hole)
    low, high = -side, 10 + side
    angle = [(low, low), (high, low), (high, 0), (0, 0), (0, high), (low, high)]
    (found,) = compare(case, {"outer": angle}).parts
    assert found.unsound is not None
    assert found.unsound.translation is None
    x, y = found.unsound.point or (0, 0)
    assert 1 < x < 9
    assert 1 < y < 9
    assert found.unsound.says == f"({x},{y}) is in {place}; it is outside the answered outer loop"


def test_a_position_in_a_hole_of_the_no_fit_polygon_is_free() -> None:
    case = Case.of("caught", "", box(10), box(1), directrix_holes=[box(8, 1)])
    around, _ = compare(case, {"no_fit": [box(11, -1)]}).parts
    assert around.conservative is not None
    assert around.conservative.says == (
        "at (4,4) G does not touch D; it is inside the answered no-fit polygon"
    )
