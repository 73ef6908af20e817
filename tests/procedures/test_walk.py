"""Walks around free regions, and the loop around all overlap, which needs no overlap test."""

from collections.abc import Sequence
from fractions import Fraction
from functools import partial
from itertools import pairwise, product

import pytest
from hypothesis import strategies as st

from exactsweep import Polygon
from exactsweep.geometry.direction import find_monotone_directions
from exactsweep.geometry.edges import Rings
from exactsweep.geometry.frame import HomogeneousPoint, find_shared_direction
from exactsweep.numbers.number import Point
from exactsweep.procedures import crossings, walk
from exactsweep.procedures.crossings import OneSidedPiece, Pieces
from exactsweep.procedures.positions import reflect
from exactsweep.procedures.segments import find_contact_segments
from exactsweep.procedures.walk import find_free

MATRICES = st.sampled_from([(1, 0, 0, 1), (5, 3, -2, 9), (8, 8, 0, 4), (0, 1, -1, 0)])


def cut(stationary: Rings, orbiting: Rings) -> Pieces:
    return crossings.cut(find_contact_segments(stationary, reflect(orbiting)))


def test_a_pair_without_cavities_takes_one_test() -> None:
    star = [(0, 0), (9, 4), (20, 0), (16, 9), (20, 20), (9, 16), (0, 20), (4, 9)]
    asked: list[HomogeneousPoint] = []

    def overlaps(position: HomogeneousPoint) -> bool:
        asked.append(position)
        return False

    found = find_free(cut([star], [star]), overlaps)
    assert ([len(loop) for loop in found.around], found.within, found.fits) == ([16], [], [])
    assert len(asked) == 1


COMPASS = [(1, 0), (2, 1), (1, 1), (0, 1), (-1, 1), (-1, 0), (-2, -1), (-1, -1), (0, -1), (1, -1)]


@pytest.mark.parametrize("turns", [1, -1])
def test_the_next_piece_is_the_first_counter_clockwise_from_the_reverse(turns: int) -> None:
    """Never the reverse itself if there is another piece."""
    for back, first, second in product(range(10), repeat=3):
        if first == second:
            continue
        (x, y), *directions = (COMPASS[k] for k in (back, first, second))
        here = (0, 0, 1)
        arriving: OneSidedPiece = (here, here, -x, -y)
        leaving: list[OneSidedPiece] = [(here, here, dx, dy) for dx, dy in directions]
        found = walk._follow(arriving, {here: leaving[::turns]})
        expected = min((0, 1), key=lambda k: ((first, second)[k] - back - 1) % 10)
        assert found == leaving[expected]


def test_a_walk_is_split_where_it_revisits_a_point() -> None:
    """Two triangles around overlap touch at (0, 0), inside the boundary of a free region."""
    triangles = [(0, 0), (2, 0), (1, 1)], [(0, 0), (-2, 0), (-1, -1)]
    square = [(4, 4), (4, -4), (-4, -4), (-4, 4)]
    for free in product((True, False), repeat=3):
        pieces: list[OneSidedPiece] = [
            ((*p, 1), (*q, 1), q[0] - p[0], q[1] - p[1])
            for ring in (*triangles, square)
            for p, q in pairwise([*ring, ring[0]])
        ]
        found = find_free(Pieces(pieces, [], set()), partial(is_overlapped, free))
        assert (len(found.around), len(found.within)) == (sum(free[:2]), free[2])


def is_overlapped(free: Sequence[bool], position: HomogeneousPoint) -> bool:
    """Decide whether a ring bounds overlap: the right or left triangle, or the square."""
    x, y, w = position
    return not free[2 if max(abs(x), abs(y)) == 4 * w else x < 0]


def test_a_single_end_on_a_loop_comes_first() -> None:
    p, q = (0, 0, 1), (2, 3, 2)
    near, far = Point(Fraction(0), Fraction(0)), Point(Fraction(1, 5), Fraction(3, 10))
    line = 2, 3, 0
    loops: dict[HomogeneousPoint, list[OneSidedPiece]] = {
        start: [
            (start, (8, 8, 1), 1, 2),
            ((8, 8, 1), (8, 9, 1), 0, 1),
            ((8, 9, 1), start, -2, -3),
        ]
        for start in (p, q)
    }
    for bounding, expected in (
        ([p], (near, far)),
        ([q], (far, near)),
        ([], (near, far)),
    ):
        one_sided = [piece for start in bounding for piece in loops[start]]
        found = find_free(Pieces(one_sided, [(line, p, q)], set()), lambda _: False, 5)
        assert found.fits == [expected]


def test_directions_are_found_once() -> None:
    tips = [(0, 10), (-10, 3), (-6, -8), (6, -8), (10, 3)]
    dents = [(-2, 3), (-4, -1), (0, -4), (4, -1), (2, 3)]
    spikes = Polygon([p for pair in zip(tips, dents, strict=True) for p in pair])
    box = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    found = find_monotone_directions(spikes)
    assert not found
    assert find_monotone_directions(spikes) is found
    # A copy keeps the cached result; an image computes its own.
    assert find_monotone_directions(Polygon(spikes)) is found
    assert find_monotone_directions(spikes.translated((1, 0))) == found
    assert find_shared_direction(spikes, box) is None
    assert find_shared_direction(box, spikes) is None
