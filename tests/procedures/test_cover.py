"""Grid squares proved to be overlapped, and the remaining segments."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st
from polyominoes import Cells, polyominoes
from pruned import Overlaps, pruning, rings
from tiers import examples

from exactsweep import Polygon
from exactsweep.check import point_in_polygon
from exactsweep.geometry.edges import Rings
from exactsweep.numbers.number import Point, Vertex
from exactsweep.procedures.cover import add_squares, find_squares, leave_out_covered
from exactsweep.procedures.positions import reflect
from exactsweep.procedures.segments import ContactSegment, find_contact_segments

MATRICES = st.sampled_from([(7, 0, 0, 7), (5, 3, -2, 9), (8, 8, 0, 4), (6, -1, 6, 5)])
Squares = tuple[int, int, list[int]]


def list_corners(squares: Squares, side: int) -> Iterator[Point]:
    """Yield the corners of all squares of a set."""
    left, low, columns = squares
    for k, bits in enumerate(columns, left):
        for row in range(bits.bit_length()):
            if bits >> row & 1:
                for i, j in product((0, 1), (0, 1)):
                    yield Point(Fraction((k + i) * side), Fraction((low + row + j) * side))


@given(polyominoes(9, 4), polyominoes(7, 3), MATRICES, st.integers(1, 9))
@examples(60)
def test_each_corner_of_a_covered_square_is_overlapped(
    d: Cells, g: Cells, matrix: tuple[int, int, int, int], side: int
) -> None:
    stationary, orbiting = rings(d, matrix), rings(g, matrix)
    squares = add_squares(stationary, reflect(orbiting), side)
    assert all(map(Overlaps(stationary, orbiting).at, list_corners(squares, side)))


def test_a_large_square_is_covered_except_for_its_border() -> None:
    square: Rings = [[(0, 0), (64, 0), (64, 64), (0, 64)]]
    _, _, columns = add_squares(square, reflect(square), 4)
    # The 32 x 32 squares in O, except for one to three rows on each side.
    assert 26 * 26 <= sum(map(int.bit_count, columns)) <= 30 * 30


def test_segments_in_covered_squares_are_dropped() -> None:
    """O is a square around (64, 64); diagonals well inside are dropped, others are kept."""
    square: Rings = [[(0, 0), (64, 0), (64, 64), (0, 64)]]
    segments = [
        ContactSegment((1, slope, y - slope * x), x, x + 4, (True, False))
        for x, y in product(range(4, 122, 6), repeat=2)
        for slope in (1, -1)
    ]
    with pruning(thin=False, wide=True):
        kept = {id(segment) for segment in leave_out_covered(segments, [square], [square])}
    for segment in segments:
        left, right, low, high = segment.box
        farthest = max(abs(left - 64), abs(right - 64), abs(low - 64), abs(high - 64))
        assert id(segment) not in kept or farthest > 55
    assert kept


@given(polyominoes(9, 4), MATRICES, st.integers(1, 8), st.integers(-60, 60), st.booleans())
@examples(30)
def test_squares_match_the_definition(
    cells: Cells, matrix: tuple[int, int, int, int], side: int, moved: int, is_off: bool
) -> None:
    aside = Fraction(1, 3) if is_off else 0
    shape: list[list[Vertex]] = [
        [(x + moved + aside, y - moved) for x, y in ring] for ring in rings(cells, matrix)
    ]
    left, low, near, inside = find_squares(shape, side)
    exterior, *holes = map(Polygon, shape)
    edges = [edge for ring in shape for edge in zip([ring[-1], *ring], ring, strict=False)]
    for k, (some, others) in enumerate(zip(near, inside, strict=True), left):
        for row in range(max(some.bit_length(), others.bit_length()) + 1):
            box = k * side, (k + 1) * side, (low + row) * side, (low + row + 1) * side
            is_near = any(meets(edge, box) for edge in edges)
            assert (some >> row & 1) == is_near
            if not is_near:
                middle = Point(Fraction(box[0] + box[1], 2), Fraction(box[2] + box[3], 2))
                is_inside = point_in_polygon(middle, exterior) > 0 and all(
                    point_in_polygon(middle, hole) < 0 for hole in holes
                )
                assert (others >> row & 1) == is_inside


def meets(edge: tuple[Vertex, Vertex], box: tuple[int, int, int, int]) -> bool:
    """Decide whether a closed segment meets a closed square."""
    ((px, py), (qx, qy)), (left, right, bottom, top) = edge, box
    if max(px, qx) < left or min(px, qx) > right or max(py, qy) < bottom or min(py, qy) > top:
        return False
    sides = [
        (qx - px) * (y - py) - (qy - py) * (x - px) for x in (left, right) for y in (bottom, top)
    ]
    return min(sides) <= 0 <= max(sides)


def ring_of(size: int, x: int, y: int) -> list[Vertex]:
    """Return a convex polygon of steps that turn from (1, 0) upwards, closed by straight edges."""
    points = [(x, y)]
    for k in range(size):
        points.append((points[-1][0] + size - k, points[-1][1] + k))
    return [*points, (x, points[-1][1])]


@pytest.mark.parametrize("far", [-(10**7), -1000, 0, 1000, 10**7])
def test_squares_are_used_only_for_many_likely_crossings(far: int) -> None:
    """At any position of the shapes: if segments are about as many as edges, crossings are few."""
    moved: tuple[Rings, Rings] = [ring_of(300, far, -far)], reflect([ring_of(20, far, far)])
    few = find_contact_segments(*moved)
    assert len(few) > 300
    assert leave_out_covered(few, [moved[0]], [moved[1]]) is few
    bar: list[Vertex] = [(0, 0), (400, 0), (400, 40), (0, 40)]
    teeth: list[Vertex] = [(2 * k, 40 + 30 * (k % 2)) for k in range(200)]
    comb: Rings = [[(x + far, y - far) for x, y in [*bar[:2], *teeth[::-1]]]]
    crossed: Rings = [[(y, -x) for x, y in comb[0]]]
    many = find_contact_segments(comb, crossed)
    left = leave_out_covered(many, [comb], [crossed])
    assert left is not many
    assert len(left) < len(many) / 2
