"""Intersecting boxes, found by rows and compared with all pairs."""

from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep.geometry import near
from exactsweep.geometry.near import Bounds, BoxRows, find_near

# On so small a grid many ends coincide with the borders of rows.
ends = st.tuples(st.integers(-4, 9), st.integers(0, 3)).map(lambda end: (end[0], end[0] + end[1]))
box = st.builds(lambda x, y: (*x, *y), ends, ends)
boxes = st.lists(box, max_size=30)


def meet(one: Bounds, other: Bounds, reach: int = 0) -> bool:
    return all(max(one[i], other[i]) <= min(one[i + 1], other[i + 1]) + reach for i in (0, 2))


@examples(200)
@given(boxes, st.integers(0, 2), st.integers(1, 4))
def test_pairs_within_reach_are_found_once(given_boxes: list[Bounds], reach: int, few: int) -> None:
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(near, "PER_ROW", few)
        found = sorted(find_near(given_boxes, reach))
    assert found == [
        (k, j)
        for (k, one), (j, other) in combinations(enumerate(given_boxes), 2)
        if meet(one, other, reach)
    ]


@examples(200)
@given(boxes, box, st.integers(1, 4))
def test_boxes_that_meet_another_one_are_found_once(
    given_boxes: list[Bounds], other: Bounds, few: int
) -> None:
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(near, "PER_ROW", few)
        rows = BoxRows(given_boxes)
    assert sorted(rows.find(other)) == [k for k, one in enumerate(given_boxes) if meet(one, other)]


def test_boxes_far_away_are_found() -> None:
    """There are no rows below or above the boxes, so a search there finds nothing."""
    rows = BoxRows([(0, 1, 5 * k, 5 * k + 1) for k in range(100)])
    assert [*rows.find((0, 9, -9, -1))] == [*rows.find((0, 9, 497, 999))] == []
    assert [*rows.find((1, 1, 10, 10))] == [2]
    assert len([*rows.find((-9, 9, -9, 999))]) == 100


def test_a_search_examines_few_of_many_boxes() -> None:
    """All rows of a grid of 100 by 100 boxes have about equally many entries."""
    side = 100
    grid = [(2 * x, 2 * x + 1, 2 * y, 2 * y + 1) for x in range(side) for y in range(side)]
    rows = BoxRows(grid)
    assert max(map(len, rows._rows)) <= 3 * side
    assert len(list(find_near(grid, 1))) == 2 * side * (side - 1) + 2 * (side - 1) ** 2


@examples(200)
@given(boxes, boxes, box, st.integers(1, 4))
def test_boxes_added_later_are_found(
    given_boxes: list[Bounds], later: list[Bounds], other: Bounds, few: int
) -> None:
    whole = (-9, 20, -9, 20)
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(near, "PER_ROW", few)
        rows = BoxRows([whole, *given_boxes])
    for number, one in enumerate(later, len(given_boxes) + 1):
        rows.add(one, number)
    everything = [whole, *given_boxes, *later]
    assert sorted(rows.find(other)) == [k for k, one in enumerate(everything) if meet(one, other)]
