"""Shapes cut into convex pieces, and what open convex sets leave of segments."""

from fractions import Fraction
from typing import Any
from unittest.mock import patch

import pytest
from cells import Holed, grid
from exactsweep.check.arrangement import WalkedLoop
from exactsweep.check.convex import cut_to_convex
from exactsweep.check.no_fit import UNLIMITED
from exactsweep.check.uncovered import LinePiece, OpenSets
from hypothesis import example, given
from hypothesis import strategies as st
from shapes import shape_pairs
from strategies import simple_polygons
from tiers import examples

from exactsweep import Polygon
from exactsweep.check import convex
from exactsweep.check.shape import bring_to_integers
from exactsweep.check.standalone import node
from exactsweep.geometry import convex as kernel_convex
from exactsweep.geometry.canonical import find_doubled_area, find_turns
from exactsweep.numbers.number import Vertex

WEDGE = Polygon([(0, -3), (3, 0), (9, 1), (6, 6), (-6, 6), (0, 3), (-2, 1)])
STEPS = grid("##.", ".##").exterior


def _check_pieces(*rings: Polygon) -> int:
    """Check that pieces are convex, make up the shape, and do not overlap, by their areas."""
    _, (shape,) = bring_to_integers([tuple(ring.vertices for ring in rings)])
    pieces = cut_to_convex(shape, UNLIMITED)
    with patch.object(convex, "_NEAR", 0):  # all vertices are tried
        found = cut_to_convex(shape, UNLIMITED)
    whole: Any = shape
    others = kernel_convex.cut_to_convex(whole)
    for cut in found, others:
        assert sum(map(find_doubled_area, cut)) == sum(map(find_doubled_area, shape))
    for piece in (*pieces, *found, *others):
        assert min(find_turns(piece)) > 0
        assert len({*piece}) == len(piece)
        assert {*piece} <= {p for ring in shape for p in ring}
    assert sum(map(find_doubled_area, pieces)) == sum(map(find_doubled_area, shape))
    return len(pieces)


@examples(60)
@given(simple_polygons())
@example(WEDGE)
def test_convex_pieces_make_up_a_polygon(polygon: Polygon) -> None:
    assert _check_pieces(polygon) <= len(polygon) - 2


@pytest.mark.parametrize(
    "hole",
    [
        [(4, 0), (6, 2), (2, 2)],  # a vertex of the hole on an edge around it
        [(2, 2), (10, 2), (10, 4), (2, 4)],  # a vertex of the exterior on an edge of the hole
        [(2, 2), (6, 2), (6, 4), (2, 4)],  # vertex on vertex
    ],
)
def test_convex_pieces_make_up_a_shape_whose_only_hole_touches_its_exterior(
    hole: list[tuple[int, int]],
) -> None:
    exterior = [(0, 0), (12, 0), (12, 9), (8, 9), (6, 4), (4, 9), (0, 9)]
    _check_pieces(Polygon(exterior), Polygon(hole))


@examples(60)
@given(shape_pairs())
def test_convex_pieces_make_up_a_shape_with_holes(pair: tuple[Holed, Holed]) -> None:
    for shape in pair:
        _check_pieces(shape.exterior, *shape.holes)


@pytest.mark.parametrize("turns", range(4))
def test_a_diagonal_does_not_pass_by_a_corner_that_touches_it(turns: int) -> None:
    """From (0, 0) to (0, 8), which are corners of holes, a corner of a third one is between."""
    holes = [
        [(0, 0), (-1, -1), (1, -1)],
        [(0, 8), (1, 9), (-1, 9)],
    ]
    for touching in ([(0, 4), (1, 3), (1, 5)], [(0, 4), (-1, 5), (-1, 3)]):
        rings = [[(-2, -3), (2, -3), (2, 11), (-2, 11)], *holes, touching]
        for _ in range(turns):
            rings = [[(-y, x) for x, y in ring] for ring in rings]
        _check_pieces(*map(Polygon, rings))


def test_one_diagonal_serves_two_wide_angles() -> None:
    """Straight angles are not wide: two steps are two bars, and a cross is three."""
    assert _check_pieces(STEPS) == 2
    assert _check_pieces(grid(".#.", "###", ".#.").exterior) == 3
    assert _check_pieces(grid("#..", "##.", "###").exterior) == 3


ORIGIN = [(0, 0)]
SQUARE = ((0, 0), (4, 0), (4, 4), (0, 4))


def leave_uncovered(sets: OpenSets, segments: Any) -> tuple[list[LinePiece], set[Vertex]]:
    return sets.uncovered((node(*p), node(*q)) for p, q in segments)


@pytest.mark.parametrize(
    ("segments", "pieces", "points"),
    [
        ([((0, 2), (4, 2))], [], [(0, 2), (4, 2)]),
        ([((0, 2), (3, 2))], [], [(0, 2)]),
        ([((1, 2), (4, 2))], [], [(4, 2)]),
        ([((1, 2), (3, 2))], [], []),
        ([((-2, 2), (4, 2))], [((-2, 2), (0, 2))], [(4, 2)]),
        ([((0, 2), (9, 2))], [((4, 2), (9, 2))], [(0, 2)]),
        ([((5, 2), (9, 2)), ((4, 2), (5, 2))], [((4, 2), (9, 2))], []),
        ([((0, 0), (9, 9))], [((4, 4), (9, 9))], [(0, 0)]),
        ([((2, 6), (2, 0))], [((2, 4), (2, 6))], [(2, 0)]),
        ([((0, 0), (4, 0)), ((3, 0), (6, 0))], [((0, 0), (6, 0))], []),
        ([((0, 0), (-3, 3))], [((-3, 3), (0, 0))], []),
    ],
)
def test_what_an_open_square_leaves_of_segments(segments: Any, pieces: Any, points: Any) -> None:
    """The border is not in it, and an end on the border is left as a point."""
    found, single = leave_uncovered(OpenSets([SQUARE], [ORIGIN], UNLIMITED), segments)
    assert [piece.ends for piece in found] == pieces
    assert single == {*points}


def test_points_beside_a_line_are_in_the_union_or_not() -> None:
    """Near (4, 2), right of the square; and up along a border nothing is inside."""
    sets = OpenSets([SQUARE], [ORIGIN], UNLIMITED)
    upwards, level = (-1, 0, 4), (0, 1, 0)
    assert sets.is_beside(upwards, 2, 1)
    assert not sets.is_beside(upwards, 2, -1)
    assert not sets.is_beside(level, 0, 1)
    assert not sets.is_beside(level, 4, 1)
    assert sets.is_beside(level, Fraction(1, 3), 1)
    assert not sets.holds((4, 2))
    assert sets.holds((Fraction(1, 3), Fraction(1, 2)))


def test_a_loop_of_the_least_triangle_has_its_sense() -> None:
    around = ((0, 0), (1, 0), (0, 1))
    assert WalkedLoop(around, (0, 0)).is_hole
    assert not WalkedLoop(around[::-1], (0, 0)).is_hole


def test_pieces_of_lines_go_from_left_to_right() -> None:
    assert LinePiece((-2, 1, -4), 0, 2).ends == ((0, 4), (2, 8))


def test_a_diagonal_is_found_among_vertices_far_away() -> None:
    """Above a ceiling there are seventy vertices nearer in x, none of which can be seen; and
    between the two holes that touch at a corner there is one below it that can."""
    teeth = [(35 - k, 1000 - 500 * (k % 2)) for k in range(71)]
    plate = [(-9999, 0), (0, -9), (9999, 0), (9999, 1000), *teeth, (-9999, 1000)]
    ceiling = [(-9000, 200), (9000, 200), (9000, 300), (-9000, 300)]
    feet = [[(0, 100), (-90, 10), (-40, 10)], [(0, 100), (40, 10), (90, 10)]]
    _check_pieces(*map(Polygon, (plate, ceiling, *feet)))


@pytest.mark.parametrize("upright", [False, True])
@pytest.mark.parametrize("y", [1000, -1000])
def test_segments_of_one_line_far_apart_meet_the_squares_near_them(y: int, upright: bool) -> None:
    """Of forty squares in a row, ten apart, the first and the last, which is first."""
    corners = [(10 * k + dx, y + dy) for k in reversed(range(40)) for dx, dy in SQUARE]
    ends = [(x, y + 1) for x in (0, 4, 390, 394)]
    if upright:
        corners, ends = ([(-y, x) for x, y in points] for points in (corners, ends))
    sets = OpenSets([corners[k : k + 4] for k in range(0, 160, 4)], [ORIGIN], UNLIMITED)
    pieces, points = leave_uncovered(sets, [(ends[2], ends[3]), (ends[0], ends[1])])
    assert pieces == []
    assert points == {*ends}


COORDINATES = st.fractions(-5, 5, max_denominator=9)
SEGMENTS = st.tuples(*[st.tuples(COORDINATES, COORDINATES)] * 2).filter(
    lambda ends: len({*ends}) > 1
)


@examples(40)
@given(COORDINATES, COORDINATES, st.lists(SEGMENTS, min_size=1, max_size=6))
def test_lattices_of_their_own_change_nothing(x: Fraction, y: Fraction, segments: Any) -> None:
    """Sums of sevenths and thirds, and the same 2,520 * 21 times as large, which all are ints."""
    first = [[(x, y), (x + 4, y), (x + 4, y + 3), (x, y + 1)], [(x - 3, y), (x, y - 2), (x, y)]]
    second: list[Any] = [[(Fraction(1, 7), 0), (2, Fraction(1, 3)), (1, 1)], [(0, 0), (1, 0)]]
    times = 2520 * 21

    def stretch(item: Any) -> Any:
        return tuple(map(stretch, item)) if isinstance(item, (list, tuple)) else int(item * times)

    pieces, points = leave_uncovered(OpenSets(first, second, UNLIMITED), segments)
    sets = OpenSets(stretch(first), stretch(second), UNLIMITED)
    more_pieces, more_points = leave_uncovered(sets, stretch(segments))
    found, expected = ({part.ends for part in parts} for parts in (pieces, more_pieces))

    def times_all(p: Vertex) -> Vertex:
        return p[0] * times, p[1] * times

    assert {(times_all(a), times_all(b)) for a, b in found} == expected
    assert set(map(times_all, points)) == more_points
    for p in (*points, *(end for piece in pieces for end in piece.ends)):
        assert not OpenSets(first, second, UNLIMITED).holds(p)
