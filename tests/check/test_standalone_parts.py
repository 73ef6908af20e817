"""Parts of the checker that stands alone: shares and clips of edges, sums of convex rings."""

import tracemalloc
from fractions import Fraction

import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st
from tiers import examples

from exactsweep.check import standalone
from exactsweep.check.standalone import Node

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
HOUSE = [(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)]

_points = st.tuples(st.integers(0, 4), st.integers(0, 4), st.integers(1, 2))


@examples(100)
@given(_points, _points, _points, _points)
@example((0, 0, 1), (2, 0, 1), (1, 1, 1), (1, 2, 1))
@example((0, 0, 1), (4, 0, 1), (1, 1, 1), (3, 1, 2))
@example((0, 0, 1), (0, 2, 1), (0, 1, 1), (0, 1, 1))
def test_a_share_is_what_two_edges_have_in_common(a: Node, b: Node, p: Node, q: Node) -> None:
    """Up to 4 and by halves, segments meet at shares with denominators below 128."""
    (ax, ay), (bx, by) = map(standalone.place, (a, b))
    assume((ax, ay) != (bx, by))
    low, high = standalone.share(a, b, p, q) or standalone.NOWHERE
    shares = {low, high, (low + high) / 2, *(Fraction(n, 24) for n in range(25))}
    for k in (k for k in shares if 0 <= k <= 1):
        at = standalone.node(ax + k * (bx - ax), ay + k * (by - ay))
        assert standalone.lies(at, p, q) == (low <= k <= high)


_lines = st.tuples(st.integers(-2, 2), st.integers(-2, 2), st.integers(-4, 4))


@examples(200)
@given(st.lists(_lines, min_size=1, max_size=3), _points, _points)
def test_a_clipped_edge_is_what_is_inside_all_half_planes(
    lines: list[Node], a: Node, b: Node
) -> None:
    """Both ends count, which an open half-plane that ends there does not hold."""
    low, high = standalone.clip(lines, a, b) or standalone.NOWHERE
    (ax, ay), (bx, by) = map(standalone.place, (a, b))
    for k in {low, high, (low + high) / 2, *(Fraction(n, 24) for n in range(25))}:
        if 0 <= k <= 1:
            at = standalone.node(ax + k * (bx - ax), ay + k * (by - ay))
            assert all(standalone.side(of, at) > 0 for of in lines) == (low < k < high)


def test_sums_beyond_the_memory_there_is_are_found_again() -> None:
    ring = standalone.ring([["0", "0"], ["1", "0"], ["0", "1"]])
    work = standalone.Work(10**6)
    sums = standalone.Sums([ring] * 10, [ring] * 10, work, [])
    sums.room = 30
    assert len({str(sums.get(k)) for k in range(100)}) == 1
    assert len(sums.known) == 10
    before = work.left
    sums.get(9)
    assert work.left == before
    sums.get(10)
    assert work.left < before


def test_sums_are_kept_in_some_500_megabytes() -> None:
    """The sides of as many sums as are kept, by the memory that a few thousand of them take."""
    d, h = ([(97 * x + 1, 89 * y + 3, 101) for x, y in ring] for ring in (HOUSE, SQUARE))
    sums = standalone.Sums([d] * 30, [h] * 30, standalone.Work(10**6), [])
    room = sums.room
    tracemalloc.start()
    try:
        for k in range(900):
            sums.get(k)
        kept = tracemalloc.get_traced_memory()[0]
    finally:
        tracemalloc.stop()
    assert 3e8 < kept * room / (room - sums.room) < 7e8


@pytest.mark.parametrize("shift", range(5))
def test_a_sum_begins_with_its_lowest_point_the_left_one_of_two(shift: int) -> None:
    rings = [[(x, y, 1) for x, y in ring[shift:] + ring[:shift]] for ring in (HOUSE, SQUARE)]
    one, other = map(standalone.from_lowest, rings)
    assert (one[0], other[0]) == ((0, 0, 1), (0, 0, 1))
    expected = [(0, 0), (3, 0), (3, 2), (2, 3), (1, 3), (0, 2)]
    assert standalone.add_convex(one, other) == [(x, y, 1) for x, y in expected]
