"""Whether interiors meet, where boundaries do no more than touch."""

from fractions import Fraction
from itertools import permutations, product

import pytest

from exactsweep import Point, Region
from exactsweep.geometry.overlap import Overlap, touch
from exactsweep.geometry.point import Vertex

ORIGIN = Point(Fraction(0), Fraction(0))
SQUARE = [[(0, 0), (4, 0), (4, 4), (0, 4)]]


def test_triangle_hangs_in_a_square_by_its_first_vertex() -> None:
    triangle = [[(0, 2), (3, 1), (3, 3)]]
    assert Overlap(triangle, SQUARE).at(ORIGIN)
    assert Overlap(SQUARE, triangle).at(ORIGIN)


def test_tips_of_holes_touch_the_middles_of_all_edges() -> None:
    """The inside of a square is overlapped, though no middle of its edges is."""
    tips = [
        [(2, 0), (1, -2), (3, -2)],
        [(4, 2), (6, 1), (6, 3)],
        [(2, 4), (3, 6), (1, 6)],
        [(0, 2), (-2, 3), (-2, 1)],
    ]
    plate = Region([(-9, -9), (13, -9), (13, 13), (-9, 13)], tips).lattice()[1]
    assert Overlap(SQUARE, plate).at(ORIGIN)
    assert Overlap(plate, SQUARE).at(ORIGIN)


@pytest.mark.parametrize("end", [(1, 2), (1, -2)])
def test_edges_that_touch_with_one_end(end: Vertex) -> None:
    long, short = ((0, 0), (2, 0)), ((1, 0), end)
    for one, other in permutations((long, short)):
        for first, second in product((one, one[::-1]), (other, other[::-1])):
            assert touch(*first, *second) == [(1, 0)]
