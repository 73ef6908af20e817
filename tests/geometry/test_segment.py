"""Segments on one line, and covers of a segment by others."""

from fractions import Fraction
from itertools import combinations
from random import Random

from exactsweep.geometry.segment import Segment, choose_cover, lay_point, make_segment
from exactsweep.numbers.number import Vertex

X_AXIS = (1, 0)


def test_a_cover_has_the_minimum_number_of_pieces() -> None:
    """Compare with all subsets of pieces with small ends, at one point between adjacent ends."""
    rng = Random(3)
    some = 0
    for _ in range(400):
        low = rng.randint(0, 3)
        whole = Segment(X_AXIS, 0, low, low + rng.randint(1, 5))
        ends = [sorted(rng.sample(range(9), 2)) for _ in range(rng.randint(0, 6))]
        pieces = [(Segment(X_AXIS, 0, a, b), k) for k, (a, b) in enumerate(ends)]
        halves = [Fraction(k, 2) for k in range(17) if whole.low < Fraction(k, 2) < whole.high]
        choices = [
            chosen
            for n in range(len(ends) + 1)
            for chosen in combinations(ends, n)
            if all(any(a <= x <= b for a, b in chosen) for x in halves)
        ]
        found = choose_cover(whole, pieces)
        if found is None:
            assert not choices
        else:
            some += 1
            assert len(found) == len(choices[0])
            assert tuple(ends[k] for k in sorted(found)) in choices
    assert 100 < some < 300


def test_ties_of_reach_go_to_the_first_piece() -> None:
    whole = Segment(X_AXIS, 0, 0, 3)
    ends = [(0, 3, 4), (-1, 3, 7), (-1, 2, 5), (1, 3, 6)]
    pieces = [(Segment(X_AXIS, 0, low, high), k) for low, high, k in ends]
    assert choose_cover(whole, pieces) == choose_cover(whole, pieces[::-1]) == [7]
    assert choose_cover(whole, pieces[2:]) == [5, 6]


def test_lines_have_int_keys_if_possible() -> None:
    half = Fraction(1, 2)
    points: list[Vertex] = [(half, Fraction(2)), (4 * half, half), (3, 1)]
    for point, offset in zip(points, (2, half, 1), strict=True):
        found = lay_point(point, X_AXIS).offset
        assert found == offset
        assert type(found) is type(offset)


def test_segments_share_a_piece_of_positive_length() -> None:
    whole = make_segment(((4, 2), (0, 0)))
    assert whole == Segment((2, 1), 0, 0, 4)
    for low, high, shares in [(-1, 0, False), (-1, 1, True), (1, 2, True), (4, 6, False)]:
        piece = Segment((2, 1), 0, low, high)
        assert piece.shares_piece(whole) == whole.shares_piece(piece) == shares


def test_differences_of_segments_contain_those_of_their_points() -> None:
    for direction, moved in [((0, 1), (5, 2)), ((2, 1), (2, 4)), ((1, -3), (0, 0))]:
        a, b = direction
        one = make_segment(((3, 1), (3 + 2 * a, 1 + 2 * b)))
        other = make_segment((moved, (moved[0] - a, moved[1] - b)))
        between = one.minus(other)
        assert (one.direction, one.point(one.low)) == (direction, (3, 1))
        assert between.point(between.low) == (3 - moved[0], 1 - moved[1])
        assert between.high - between.low == 3 * (a or b)
