"""Boxes near a place: none is missed, and far ones are not looked at."""

from collections.abc import Iterator, Sequence
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exactsweep.check import reference_no_fit, uncovered
from exactsweep.check.columns import BoxColumns, Rectangle
from exactsweep.geometry.point import Rational, Vertex

WIDTHS = st.integers(0, 3) | st.integers(0, 400)
BOXES = st.builds(lambda left, width: (left, left + width, 0, 1), st.integers(-200, 200), WIDTHS)
RANGES = st.tuples(st.integers(-1300, 1300), st.integers(0, 3) | st.integers(0, 2000)).map(
    lambda pair: (Fraction(pair[0], 3), Fraction(pair[0] + pair[1], 3))
)


@given(st.lists(BOXES, max_size=80), RANGES)
def test_no_box_that_meets_a_range_is_missed(
    boxes: list[Rectangle], near: tuple[Fraction, Fraction]
) -> None:
    left, right = near
    found = list(BoxColumns(boxes).near(left, right))
    assert len(found) == len(set(found))
    meet = {k for k, box in enumerate(boxes) if box[0] <= right and box[1] >= left}
    assert meet <= set(found) <= set(range(len(boxes)))


def test_far_boxes_are_left_out() -> None:
    # Columns are 10 wide: 1000 // 101 + 1. The last box meets all of them.
    boxes = [*((10 * k, 10 * k + 9, 0, 1) for k in range(99)), (0, 1000, 0, 1)]
    columns = BoxColumns(boxes)
    assert list(columns.near(500, 509)) == [99, 50]
    assert list(columns.near(Fraction(1019, 2), 510)) == [99, 50, 51]
    assert list(columns.near(-50, -40)) == [99]
    assert list(columns.near(200, 509)) == [99, *range(20, 51)]
    assert list(columns.near(200, 510)) == [*range(100)]


def test_a_box_of_30_columns_is_known_by_them() -> None:
    boxes = [*((10 * k, 10 * k, 0, 1) for k in range(98)), (0, 300, 0, 1), (0, 310, 0, 1)]
    columns = BoxColumns(boxes)
    assert list(columns.near(900, 900)) == [99, 90]
    assert list(columns.near(300, 300)) == [99, 30, 98]


def test_of_a_saw_the_sets_near_a_line_are_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    # A tooth touches the sums of teeth near it with pieces of the hook, not all sums.
    hook = [(0, 0), (6, 0), (6, 6), (1, 6), (1, 3), (2, 3), (2, 5), (5, 5), (5, 1), (0, 1)]
    teeth: list[Vertex] = [(2 * i, 900 + 9 * (i % 2) + i * 37 % 5) for i in range(120)]
    asked: list[int] = []
    sets: list[int] = []

    class Counted(BoxColumns):
        def __init__(self, boxes: Sequence[Rectangle]) -> None:
            super().__init__(boxes)
            sets.append(len(boxes))

        def near(self, left: Rational, right: Rational) -> Iterator[int]:
            asked.append(0)
            for k in super().near(left, right):
                asked[-1] += 1
                yield k

    monkeypatch.setattr(uncovered, "BoxColumns", Counted)
    assert reference_no_fit([(0, 0), (238, 0), *teeth[::-1]], hook).exterior
    assert len(sets) == 1
    assert sets[0] > 200
    assert sum(asked) < len(asked) * sets[0] / 4
