"""Words and numbers of reports that depend on one value: a direction, holes, a root."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from layouts import box

from exactsweep import Polygon, Region, sweep
from exactsweep.text.explanation import tell
from exactsweep.text.report import take_root
from exactsweep.text.results import write_json_value

SQUARE = box(0, 0, 1, 1)
SLOT = [(0, 0), (3, 0), (3, 5), (2, 5), (2, 1), (1, 1), (1, 3), (0, 3)]


@pytest.mark.parametrize("direction", [(1, 0), (1, 1), (2, 1), (0, 1)])
def test_a_direction_is_told_unless_it_points_right(direction: tuple[int, int]) -> None:
    s = sweep(SQUARE, box(0, 0, 3, 2), direction=direction)
    told = "\n".join(tell(s))
    assert ("Both polygons are monotone to" in told) == (direction != (1, 0))


def test_both_walls_of_a_slot_are_told_all_along_an_exact_fit() -> None:
    told = "\n".join(tell(sweep(SQUARE, SLOT)))
    fit = told[told.index("-- Exact fit 0") :]
    assert fit.splitlines()[1:3] == [
        "  EE: edge 1 of G, (1,0)-(1,1), slides along edge 3 of D, (2,5)-(2,1)",
        "  EE: edge 3 of G, (0,1)-(0,0), slides along edge 5 of D, (1,1)-(1,3)",
    ]


@given(st.fractions(min_value=0), st.integers(0, 900), st.sampled_from([1, -1]))
def test_a_root_has_60_bits_however_large_the_number_is(
    value: Fraction, power: int, sense: int
) -> None:
    square = value * Fraction(10) ** (sense * power)
    root = take_root(square)
    assert square <= root**2 <= square * (1 + Fraction(1, 2**56))


def test_a_region_without_holes_is_written_as_its_vertices() -> None:
    hole = box(1, 1, 2, 2)
    assert write_json_value(Polygon(SQUARE)) == Polygon(SQUARE).vertices
    assert write_json_value(Region(SQUARE)) == Polygon(SQUARE).vertices
    assert isinstance(write_json_value(Region(box(0, 0, 3, 3), [hole])), dict)
