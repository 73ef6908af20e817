"""Parts of an envelope: what it keeps over x-ranges, where its edges are found, and its points."""

from fractions import Fraction
from itertools import product

import pytest
from tiers import examples

from exactsweep.numbers.number import Vertex
from exactsweep.paper.counting import make_counted, watch_operations
from exactsweep.procedures.chain import take_corners
from exactsweep.procedures.envelope import GAP, Envelope, find_crossing, find_point_on, value
from exactsweep.procedures.lower_envelope import lower_envelope_mm

Chain = list[Vertex]
usually = examples(100)
half, third = Fraction(1, 2), Fraction(1, 3)


def test_of_an_envelope_that_reaches_no_x_range_nothing_is_kept() -> None:
    e = Envelope.of([(0, 0), (2, 2)])
    assert e.keep([((2, 1), (3, 1)), ((4, 1), (5, 1))]) is None
    kept = e.keep([((-1, 1), (1, 2)), ((3, 2), (9, 1))])
    assert kept is not None
    assert kept.pieces[1] == GAP
    assert [value(at) for at in kept.breaks] == [0, half, 3 * half, 2]


def test_an_envelope_of_a_convex_chain_is_that_of_its_source() -> None:
    chain = [(0, 1), (1, 0), (3, 0), (4, 2)]
    for source in (0, 5):
        found = Envelope.of_convex(chain, source)
        assert list(found) == chain
        assert {piece[4] for piece in found.pieces} == {source}
    assert Envelope.of_convex(chain).pieces == Envelope.of_convex(chain, 0).pieces


@pytest.mark.parametrize("place", [0, 500, 999])
def test_an_x_range_is_found_among_many_in_logarithmic_time(place: int) -> None:
    """All of them were looked at once, which made the inner loops of long zigzags quadratic."""
    counted = make_counted([(4 * k, 4 * k + 2) for k in range(1000)])
    spans = [((left, 1), (right, 1)) for left, right in counted]
    chain = make_counted([(4 * place - 1, 0), (4 * place + 3, 1)])
    with watch_operations() as tally:
        kept = Envelope.of_convex(chain).keep(spans)
    assert kept is not None
    assert [value(at) for at in kept.breaks] == [4 * place, 4 * place + 2]
    assert tally.total < 120


def test_pieces_are_found_before_and_after_each_break() -> None:
    e = Envelope.of([(0, 0), (1, 2), (3, 1), (4, 5)])
    for twice in range(-1, 10):
        at = twice, 2
        starts = [x for x, _ in e.breaks]
        assert e.edge_before(at) == sum(2 * x < twice for x in starts) - 1
        assert e.edge_after(at) == sum(2 * x <= twice for x in starts) - 1


def test_x_ranges_side_by_side_leave_no_gap() -> None:
    kept = Envelope.of([(0, 0), (6, 6)]).keep(
        [((1, 1), (2, 1)), ((4, 2), (3, 1)), ((3, 1), (7, 2)), ((4, 1), (5, 1))]
    )
    assert kept is not None
    assert [value(at) for at in kept.breaks] == [1, 2, 3, 7 * half, 4, 5]
    assert [piece == GAP for piece in kept.pieces] == [False, False, False, True, False]


def test_an_envelope_is_cut_to_an_x_range() -> None:
    e = Envelope.of([(0, 0), (2, 4), (6, 0)])
    for (start, end), points in [
        ((1, 5), [(1, 2), (2, 4), (5, 1)]),
        ((-1, 1), [(0, 0), (1, 2)]),
    ]:
        kept = e.keep([((start, 1), (end, 1))])
        assert kept is not None
        assert [*kept] == points


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
