"""Boxes near a place: none is missed, and far ones are not looked at."""

from collections.abc import Iterator, Sequence
from fractions import Fraction

import pytest
from exactsweep.check.boxes import BoxTree, Rectangle, find_box, meet
from exactsweep.check.no_fit import UNLIMITED
from hypothesis import given
from hypothesis import strategies as st

from exactsweep.check import boxes, reference_no_fit, uncovered
from exactsweep.check.standalone import Work
from exactsweep.numbers.number import Rational, Vertex

NUMBERS = st.integers(-20, 20) | st.integers(-900, 900)
SIDES = st.integers(0, 3) | st.integers(0, 400)


@st.composite
def rectangles(draw: st.DrawFn, parts: int = 1) -> Rectangle:
    x, y, width, height = (Fraction(draw(each), parts) for each in (NUMBERS, NUMBERS, SIDES, SIDES))
    return x, x + width, y, y + height


@given(st.lists(rectangles(), max_size=80), rectangles(3))
def test_all_boxes_that_meet_another_one_are_found_in_order(
    known: list[Rectangle], box: Rectangle
) -> None:
    left, right, low, high = box
    expected = [
        k
        for k, (x, more_x, y, more_y) in enumerate(known)
        if max(left, x) <= min(right, more_x) and max(low, y) <= min(high, more_y)
    ]
    assert list(BoxTree(known, UNLIMITED).near(box)) == expected


@given(st.lists(rectangles(), max_size=40), NUMBERS, NUMBERS)
def test_a_box_turned_inside_out_meets_those_that_hold_its_inside(
    known: list[Rectangle], x: int, y: int
) -> None:
    """From x + 1 down to x, and likewise y: boxes that hold the unit square."""
    expected = [k for k, b in enumerate(known) if b[0] <= x < b[1] and b[2] <= y < b[3]]
    assert list(BoxTree(known, UNLIMITED).near((x + 1, x, y + 1, y))) == expected


def test_the_box_around_points() -> None:
    assert find_box([(0, 5), (3, 1), (-2, 4)]) == (-2, 3, 1, 5)


@pytest.mark.parametrize("way", [(9, 0), (0, 9), (9, 9), (9, -9)])
def test_far_boxes_are_not_looked_at(way: tuple[int, int], monkeypatch: pytest.MonkeyPatch) -> None:
    """In a row, a column or aslant: of 4,096, those on the way to the one that is asked for."""
    asked: list[Rectangle] = []

    def count(one: Rectangle, other: Rectangle) -> bool:
        asked.append(one)
        return meet(one, other)

    known = [(way[0] * k, way[0] * k + 2, way[1] * k, way[1] * k + 2) for k in range(4096)]
    tree = BoxTree(known, UNLIMITED)
    monkeypatch.setattr(boxes, "meet", count)
    for k in (0, 1777, 4095):
        asked.clear()
        assert list(tree.near(known[k])) == [k]
        assert len(asked) < 80


def test_what_is_not_asked_for_is_not_looked_for() -> None:
    """Of 4,096 boxes in one place the first comes before most branches are looked at."""
    budget = Work(10**9)
    tree = BoxTree([(0, 1, 0, 1)] * 4096, budget)
    before = budget.left
    assert next(tree.near((0, 1, 0, 1))) == 0
    assert before is not None
    assert budget.left is not None
    assert before - budget.left < 60


def test_of_a_saw_the_sets_near_a_line_are_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    # A tooth touches the sums of teeth near it with pieces of the hook, not all sums.
    hook = [(0, 0), (6, 0), (6, 6), (1, 6), (1, 3), (2, 3), (2, 5), (5, 5), (5, 1), (0, 1)]
    teeth: list[Vertex] = [(2 * i, 900 + 9 * (i % 2) + i * 37 % 5) for i in range(120)]
    asked: list[int] = []
    sets: list[int] = []

    class Counted(BoxTree):
        def __init__(self, known: Sequence[Rectangle], budget: Work) -> None:
            super().__init__(known, budget)
            sets.append(len(known))

        def near(self, box: Sequence[Rational]) -> Iterator[int]:
            asked.append(0)
            for k in super().near(box):
                asked[-1] += 1
                yield k

    monkeypatch.setattr(uncovered, "BoxTree", Counted)
    assert reference_no_fit([(0, 0), (238, 0), *teeth[::-1]], hook).exterior
    assert len(sets) == 1
    assert sets[0] > 200
    assert sum(asked) < len(asked) * sets[0] / 10
