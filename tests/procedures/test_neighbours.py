"""Parts of contact segments that the edges beside them overlap: without them nothing changes."""

from fractions import Fraction
from unittest.mock import patch

import pytest
from covered import find_free, rings
from hypothesis import example, given
from hypothesis import strategies as st
from polyominoes import Cells, polyominoes
from strategies import Ring, simple_rings
from tiers import examples

from exactsweep import Polygon
from exactsweep.geometry.overlap import Overlap, Rings
from exactsweep.numbers.number import Point, Vertex
from exactsweep.procedures import contact_lines
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.contact_lines import Stretch, find_contact_stretches
from exactsweep.procedures.obstacles import Obstacles
from exactsweep.procedures.ss import no_fit_ss

SCALES = st.sampled_from([Fraction(1), Fraction(7, 3), Fraction(10**30), Fraction(1, 10)])


def zigzag(size: int) -> list[Vertex]:
    """A thin strip up and down."""
    up = [(2 * i, 400 if i % 2 else 0) for i in range(size // 2)]
    return [*up, *((x, y + 3) for x, y in reversed(up))]


def saw(size: int) -> list[Vertex]:
    """A saw with high teeth, which fill half of its bounds."""
    teeth = [(x, 100 if x % 2 else 3) for x in range(size)]
    return [(0, 0), (size - 1, 0), *reversed(teeth)]


def find_left(stationary: Rings, moving: Rings, looks: bool) -> list[Stretch]:
    with patch.object(contact_lines, "_MANY", 0 if looks else 10**9):
        return find_contact_stretches(stationary, moving)


def check(stationary: Rings, orbiting: Rings) -> None:
    moving = [inverse(ring) for ring in orbiting]
    overlap = Overlap(stationary, orbiting)
    whole, left = (find_left(stationary, moving, looks) for looks in (False, True))
    assert find_free(whole, overlap) == find_free(left, overlap)


# The second edge crosses the line of the segment one unit ahead of the vertex.
@example([(2, 1), (3, 0), (5, 4)], [(2, 4), (4, 3), (3, 5), (3, 4)], Fraction(1))
@given(simple_rings(), simple_rings(), SCALES)
@examples(60)
def test_overlapped_parts_do_not_matter(d: Ring, g: Ring, scale: Fraction) -> None:
    stationary, orbiting = (
        [[(x * scale, y * scale) for x, y in Polygon(ring).vertices]] for ring in (d, g)
    )
    check(stationary, orbiting)


@given(polyominoes(9, 4), polyominoes(7, 3), st.sampled_from([(7, 0, 0, 7), (5, 3, -2, 9)]))
@examples(40)
def test_parallel_edges_and_holes(d: Cells, g: Cells, matrix: tuple[int, int, int, int]) -> None:
    check(rings(d, matrix), rings(g, matrix))


def test_the_same_shape_may_be_placed_twice() -> None:
    strip, unit = zigzag(20), [[(0, 0), (1, 0), (0, 1)]]
    moving = [inverse(ring) for ring in unit]
    at = Obstacles([], [[strip], [strip]], unit).at
    once, twice = (find_left([strip] * count, moving, True) for count in (1, 2))
    assert [(s.low, s.high) for s in once] == [(s.low, s.high) for s in twice]
    assert at(Point(Fraction(0), Fraction(1)))


# Two rows of 40 teeth each way and what is between them; of saws an octagon, as tips are in line.
@pytest.mark.parametrize(
    ("ring", "contacts", "few", "corners"), [(zigzag(80), 3200, 236, 236), (saw(81), 3284, 164, 8)]
)
def test_spikes_across_spikes_leave_about_the_edges_of_the_answer(
    ring: list[Vertex], contacts: int, few: int, corners: int
) -> None:
    moving = [[(y, -x) for x, y in ring]]
    whole, left = (find_left([ring], moving, looks) for looks in (False, True))
    assert (len(whole), len(left)) == (contacts, few)
    found = no_fit_ss([ring], [inverse(moving[0])])
    assert ([len(loop) for loop in found.around], found.within, found.fits) == ([corners], [], [])


def test_overlap_is_just_inside_each_cut() -> None:
    strips = [zigzag(40)]
    orbiting = [[(-y, x) for x, y in strips[0]]]
    moving = [inverse(ring) for ring in orbiting]
    overlap = Overlap(strips, orbiting)
    whole, left = (find_left(strips, moving, looks) for looks in (False, True))
    natural = {(s.dx, s.dy, s.c, end) for s in whole for end in (s.low, s.high)}
    cut = [
        Point(Fraction(n, d), Fraction(m, e))
        for stretch in left
        for place in (stretch.low, stretch.high)
        if (stretch.dx, stretch.dy, stretch.c, place) not in natural
        for n, d, m, e in [stretch.vertex(place)]
    ]
    assert len(cut) > 10
    assert all(map(overlap.at, cut))
