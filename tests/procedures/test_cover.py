"""Squares known to be overlapped: they are, and leaving out what lies in them changes nothing."""

from fractions import Fraction
from itertools import product

import pytest
from covered import find_free, list_corners, rings
from hypothesis import given
from hypothesis import strategies as st
from polyominoes import Cells, polyominoes
from tiers import examples

from exactsweep import Polygon
from exactsweep.check import point_in_polygon
from exactsweep.geometry.overlap import Overlap, Rings
from exactsweep.numbers.number import Point
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.contact_lines import Stretch, find_contact_stretches
from exactsweep.procedures.cover import Cover, leave_out_covered
from exactsweep.procedures.squares import _stack, find_points_in

MATRICES = st.sampled_from([(7, 0, 0, 7), (5, 3, -2, 9), (8, 8, 0, 4), (6, -1, 6, 5)])


@given(polyominoes(9, 4), polyominoes(7, 3), MATRICES, st.integers(2, 20))
@examples(60)
def test_each_corner_of_a_square_that_is_covered_is_overlapped(
    d: Cells, g: Cells, matrix: tuple[int, int, int, int], columns: int
) -> None:
    stationary, orbiting = rings(d, matrix), rings(g, matrix)
    cover = Cover(stationary, [inverse(ring) for ring in orbiting], columns)
    overlap = Overlap(stationary, orbiting)
    assert all(map(overlap.at, list_corners(cover)))


@given(polyominoes(9, 4), polyominoes(7, 3), MATRICES, st.integers(2, 20))
@examples(60)
def test_what_is_covered_does_not_matter(
    d: Cells, g: Cells, matrix: tuple[int, int, int, int], columns: int
) -> None:
    stationary, orbiting = rings(d, matrix), rings(g, matrix)
    moving: Rings = [inverse(ring) for ring in orbiting]
    overlap = Overlap(stationary, orbiting)
    whole = find_contact_stretches(stationary, moving)
    cover = Cover(stationary, moving, columns)
    left = [piece for stretch in whole for piece in cover.uncovered(stretch)]
    assert find_free(whole, overlap) == find_free(left, overlap)


def test_a_large_square_is_covered_but_for_its_border() -> None:
    square = [[(0, 0), (64, 0), (64, 64), (0, 64)]]
    cover = Cover(square, [inverse(ring) for ring in square], 16)
    assert cover.side == 4
    covered = sum(bits.bit_count() for bits in cover.columns)
    # Of 32 x 32 squares of O those that do not touch its boundary, less a row each way.
    assert 28 * 28 <= covered <= 30 * 30
    for dx, dy in [(1, 0), (0, 1), (1, 1), (3, -2)]:
        assert not [*cover.uncovered(Stretch((dx, dy, 1), -30, 30, True, True))]
    (left,) = cover.uncovered(Stretch((1, 0, 0), -64, 30, True, True))
    assert left.low[0] == -64
    assert -60 <= left.high[0] <= -56


def test_columns_are_asked_about_in_blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    square = [[(0, 0), (2**12, 0), (2**12, 2**12), (0, 2**12)]]
    cover = Cover(square, [inverse(ring) for ring in square], 2**10)
    asked: list[int] = []
    covers = Cover._covers

    def ask(cover: Cover, *block: int) -> bool:
        asked.append(block[0])
        return covers(cover, *block)

    monkeypatch.setattr(Cover, "_covers", ask)
    assert not [*cover.uncovered(Stretch((1, 0, 0), -4000, 4000, True, True))]
    # Of 2,000 columns, three blocks of each width at most, on the way up and down.
    assert len(asked) <= 3 * 11
    assert max(asked) >= 9


@given(polyominoes(9, 4), MATRICES, st.integers(1, 8), st.integers(-60, 60))
@examples(15)
def test_points_are_all_of_the_interior(
    cells: Cells, matrix: tuple[int, int, int, int], side: int, moved: int
) -> None:
    """Points on the boundary are left out, on vertical edges, too."""
    check_points([[(x + moved, y - moved) for x, y in ring] for ring in rings(cells, matrix)], side)


@pytest.mark.parametrize("side", [2, 3, 5, 8])
def test_points_beyond_upright_edges_are_of_the_interior(side: int) -> None:
    """Also of those that end at or between two points of the grid, above and below."""
    for start, end, way in product(range(-3, 3), range(1, 9, 2), (1, -1)):
        notch = [(0, start), (8, start), (8, start + end), (24, start + end), (24, 40), (0, 40)]
        check_points([[(x, way * y) for x, y in notch[::way]]], side)


def check_points(shape: Rings, side: int) -> None:
    exterior, *holes = map(Polygon, shape)
    left, low, columns = find_points_in(shape, side)
    xs = [x for x, _ in shape[0]]
    assert len(columns) <= (max(xs) - min(xs)) // side + 4
    for k, bits in enumerate(columns):
        for row in range(bits.bit_length() + 2):
            point = Point(Fraction((left + k) * side), Fraction((low + row) * side))
            is_inside = point_in_polygon(point, exterior) > 0 and all(
                point_in_polygon(point, hole) < 0 for hole in holes
            )
            assert (bits >> row & 1) == is_inside


@pytest.mark.parametrize(("line", "low"), [((1, 0, 0), 900), ((1, 0, 900), 0), ((0, 1, -900), 0)])
def test_nothing_is_covered_beyond_the_squares(line: tuple[int, int, int], low: int) -> None:
    square = [[(0, 0), (64, 0), (64, 64), (0, 64)]]
    cover = Cover(square, [inverse(ring) for ring in square], 16)
    for sign in (1, -1):
        dx, dy, c = line
        begin, end = sorted((sign * low, sign * low + 20 * sign))
        stretch = Stretch((dx, dy, sign * c), begin, end, True, True)
        (left,) = cover.uncovered(stretch)
        assert (left.low, left.high) == (stretch.low, stretch.high)
    for column, row in [(-1, 2), (len(cover.columns), 2), (2, -1), (2, 40)]:
        assert not cover._covers(0, column, row, row)


@pytest.mark.parametrize("length", range(1, 40))
def test_bits_are_moved_by_every_place(length: int) -> None:
    assert _stack({1: 0b1}, length) == 2**length - 1
    assert _stack({1: 0b1001}, length) == (2**length - 1) | (2**length - 1) << 3


def ring_of(size: int, x: int, y: int) -> list[tuple[int, int]]:
    """A convex polygon of steps that turn from (1, 0) upwards, and back on straight ways."""
    steps = [(size - k, k) for k in range(size)]
    points = [(x, y)]
    for dx, dy in steps:
        points.append((points[-1][0] + dx, points[-1][1] + dy))
    return [*points, (x, points[-1][1])]


@pytest.mark.parametrize("far", [-(10**7), -1000, 0, 1000, 10**7])
def test_a_cover_is_laid_only_over_many_likely_crossings(far: int) -> None:
    """Wherever the shapes are: about as many segments as edges have few crossings."""
    moved = [ring_of(300, far, -far)], [inverse(ring_of(20, far, far))]
    few = find_contact_stretches(*moved)
    assert len(few) > 300
    assert leave_out_covered(few, *moved) is few
    teeth = [(2 * k + far, 400 * (k % 2) - far) for k in range(200)]
    strips = [*teeth, *((x, y + 3) for x, y in teeth[::-1])]
    crossed = [strips], [[(y, -x) for x, y in strips]]
    many = find_contact_stretches(*crossed)
    assert leave_out_covered(many, *crossed) is not many
