"""Parts of an envelope: where its edges are found, and its points."""

from fractions import Fraction
from itertools import product

import pytest
from tiers import examples

from exactsweep.numbers.number import Vertex
from exactsweep.procedures.chain import take_corners
from exactsweep.procedures.envelope import Envelope, find_crossing, find_point_on
from exactsweep.procedures.lower_envelope import lower_envelope_mm

Chain = list[Vertex]
usually = examples(100)
half, third = Fraction(1, 2), Fraction(1, 3)


def test_an_envelope_of_a_chain_is_that_of_its_source() -> None:
    chain = [(0, 1), (1, 0), (3, 0), (4, 2)]
    for source in (0, 5):
        found = Envelope.of(chain, source)
        assert list(found) == chain
        assert {piece[4] for piece in found.pieces} == {source}
    assert Envelope.of(chain).pieces == Envelope.of(chain, 0).pieces


def test_an_envelope_is_cut_to_an_x_range() -> None:
    e = Envelope.of([(0, 0), (2, 4), (6, 0)])
    for start, end, points in [
        (1, 5, [(1, 2), (2, 4), (5, 1)]),
        (2, 6, [(2, 4), (6, 0)]),
        (0, 1, [(0, 0), (1, 2)]),
        (3, 3, []),
    ]:
        taken = Envelope([(start, 1)], [])
        taken.take_between(e, (2 * start, 2), (3 * end, 3))
        assert ([*taken] if points else taken.pieces) == points


def test_pieces_are_found_before_and_after_each_break() -> None:
    e = Envelope.of([(0, 0), (1, 2), (3, 1), (4, 5)])
    for twice in range(-1, 10):
        at = twice, 2
        starts = [x for x, _ in e.breaks]
        assert e.edge_before(at) == sum(2 * x < twice for x in starts) - 1
        assert e.edge_after(at) == sum(2 * x <= twice for x in starts) - 1


@pytest.mark.parametrize("shift", range(-3, 4))
def test_walls_of_any_length_at_any_height_stay(shift: int) -> None:
    for end in range(-4, 5):
        chain = [(0, shift), (2, shift - 1), (2, end), (4, end + 3)]
        assert [*Envelope.of(chain)] == take_corners(chain)


def test_an_edge_that_began_further_left_comes_back() -> None:
    """Its start is as far left of the edge between as that one's end is right, and as high."""
    chains = [Envelope.of([(2, 0), (4, 2)]), Envelope.of([(0, 2), (6, -1)])]
    found = [*lower_envelope_mm(chains)]
    assert found == [(0, 2), (2, 1), (2, 0), (8 * third, 2 * third), (6, -1)]


def test_points_of_an_edge_at_any_break() -> None:
    for px, py, width, qy, n, d in product(
        (-1, 0), (-1, 2), (1, 3), range(-2, 4), range(-4, 8), (1, 2)
    ):
        edge = (px, py), (px + width, qy)
        x = Fraction(n, d)
        assert find_point_on(edge, (n, d)) == (x, py + (qy - py) * (x - px) / width)


def test_lines_cross_where_their_difference_is_nothing() -> None:
    for u, v in product((-3, -1, 1, 2), range(-3, 4)):
        n, d = find_crossing(u, v)
        assert d > 0
        assert u * n + v * d == 0
