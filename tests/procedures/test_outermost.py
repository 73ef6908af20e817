"""The loop around all overlap is found without a question, and so are directions a second time."""

from fractions import Fraction

import pytest
from covered import rings
from hypothesis import given
from hypothesis import strategies as st
from polyominoes import Cells, polyominoes
from strategies import Ring, simple_rings
from tiers import examples

from exactsweep import Polygon
from exactsweep.geometry.direction import find_monotone_directions
from exactsweep.geometry.frame import find_shared_direction
from exactsweep.geometry.overlap import Overlap, Rings
from exactsweep.numbers.number import Point, Vertex
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.contact_lines import Stretch, find_contact_stretches
from exactsweep.procedures.crossings import cut_at_crossings
from exactsweep.procedures.free_positions import find_free_positions

MATRICES = st.sampled_from([(1, 0, 0, 1), (5, 3, -2, 9), (8, 8, 0, 4), (0, 1, -1, 0)])


def cut(stationary: Rings, orbiting: Rings) -> list[Stretch]:
    stretches = find_contact_stretches(stationary, [inverse(ring) for ring in orbiting])
    cut_at_crossings(stretches)
    return stretches


def find_least(stationary: Rings, orbiting: Rings) -> Vertex:
    """Find the least point at which the shapes touch."""
    (ax, ay), (bx, by) = min(stationary[0]), max(orbiting[0])
    return ax - bx, ay - by


def require_the_same(stationary: Rings, orbiting: Rings) -> None:
    """Compare what is known of the outermost loop with the answer to a question."""
    stretches, overlap = cut(stationary, orbiting), Overlap(stationary, orbiting)
    asked = find_free_positions(stretches, overlap.at, 1)
    known = find_free_positions(stretches, overlap.at, 1, find_least(stationary, orbiting))
    assert known.around == asked.around
    assert sorted(known.within) == sorted(asked.within)
    assert known.fits == asked.fits


@given(polyominoes(9, 4), polyominoes(7, 3), MATRICES)
@examples(60)
def test_polyominoes_have_the_same_loops(
    d: Cells, g: Cells, matrix: tuple[int, int, int, int]
) -> None:
    require_the_same(rings(d, matrix), rings(g, matrix))


@given(simple_rings(), simple_rings())
@examples(60)
def test_polygons_have_the_same_loops(d: Ring, g: Ring) -> None:
    require_the_same([Polygon(d).lattice()[1]], [Polygon(g).lattice()[1]])


@pytest.mark.parametrize("shear", [0, 8, -8])
def test_the_outermost_of_several_pieces_is_known(shear: int) -> None:
    # A hole touches the least vertex of D, so two pieces leave the least point. A segment on the
    # line of the wrong one, y = x / 5, comes first in the order of lines.
    d, h = (
        [[(x, y + shear * x) for x, y in ring] for ring in rings]
        for rings in (
            [[(0, 0), (10, -60), (10, 60)], [(0, 0), (5, 1), (5, -1)]],
            [[(0, 0), (100, 30), (100, 100), (15, 100), (20, 66), (25, 67), (50, 20)]],
        )
    )
    turned = [inverse(ring) for ring in h]
    stretches = cut(d, turned)
    meeting = [(s.dx, s.dy) for s in stretches if not s.c and (0, 1) in (s.low, s.high)]
    slopes = [(5, 1 + 5 * shear), (1, 6 + shear), (1, shear - 6)]
    assert meeting == slopes if shear == 0 else {*meeting} == {*slopes}
    found = find_free_positions(stretches, lambda _: True, 1, find_least(d, turned))
    assert [loop[0] for loop in found.around] == [Point(Fraction(0), Fraction(0))]


def test_a_pair_without_caves_takes_no_question() -> None:
    star = [(0, 0), (9, 4), (20, 0), (16, 9), (20, 20), (9, 16), (0, 20), (4, 9)]
    asked: list[Point] = []
    stretches = cut([star], [star])

    def overlap(t: Point) -> bool:
        asked.append(t)
        return True

    found = find_free_positions(stretches, overlap, 1, find_least([star], [star]))
    assert ([len(loop) for loop in found.around], found.within, found.fits) == ([16], [], [])
    assert not asked


def test_directions_are_found_once() -> None:
    tips = [(0, 10), (-10, 3), (-6, -8), (6, -8), (10, 3)]
    dents = [(-2, 3), (-4, -1), (0, -4), (4, -1), (2, 3)]
    spikes = Polygon([p for pair in zip(tips, dents, strict=True) for p in pair])
    box = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    found = find_monotone_directions(spikes)
    assert not found
    assert find_monotone_directions(spikes) is found
    # A copy knows as much; an image is asked for itself.
    assert find_monotone_directions(Polygon(spikes)) is found
    assert find_monotone_directions(spikes.translated((1, 0))) == found
    assert find_shared_direction(spikes, box) is None
    assert find_shared_direction(box, spikes) is None
