"""Regions: accepted and rejected input, messages, and equality of equal sets."""

import pickle
from fractions import Fraction
from functools import partial

import pytest
from hypothesis import given
from hypothesis import strategies as st
from linear import count_calls
from polyominoes import Cells, polyominoes, region, rings

from exactsweep import Point, Polygon, PolygonError, Region
from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.outline import number_features
from exactsweep.geometry.region import share_lattice
from exactsweep.geometry.vectors import touch
from exactsweep.numbers.number import Vertex

SQUARE = [(0, 0), (9, 0), (9, 9), (0, 9)]
SMALL = [(1, 1), (3, 1), (3, 3), (1, 3)]
OTHER = [(5, 5), (7, 5), (6, 7)]


def test_equal_sets_are_equal() -> None:
    one = Region(SQUARE, [SMALL, OTHER])
    two = Region(SQUARE[::-1], [OTHER[1:] + OTHER[:1], [*SMALL, (1, 1)]])
    assert one == two
    assert hash(one) == hash(two)
    assert one.holes == (Polygon(SMALL), Polygon(OTHER))
    assert one.area == 81 - 4 - 2
    assert one != Region(SQUARE, [SMALL])


def test_polylines_are_immutable_and_can_be_pickled() -> None:
    one = Region(SQUARE, [SMALL])
    with pytest.raises(AttributeError, match="immutable"):
        one.holes = ()
    assert pickle.loads(pickle.dumps(one)) == one
    assert repr(one) == (
        "Region([(0, 0), (9, 0), (9, 9), (0, 9)], [[(1, 1), (3, 1), (3, 3), (1, 3)]])"
    )


def test_the_interior_is_on_the_left_on_the_lattice() -> None:
    scale, (outer, hole) = Region(SQUARE, [[("1/2", 1), (1, 1), (1, "3/2")]]).lattice()
    assert scale == 2
    assert outer == ((0, 0), (18, 0), (18, 18), (0, 18))
    assert hole == ((1, 2), (2, 3), (2, 2))


def test_indices_follow_the_rings_of_the_input() -> None:
    # The second hole is first in canonical order, and clockwise in the input.
    one = Region(SQUARE, [OTHER, SMALL[::-1]])
    assert one.holes == (Polygon(SMALL), Polygon(OTHER))
    given_vertices = SQUARE + OTHER + SMALL[::-1]
    for k, vertex in enumerate(one.vertices):
        x, y = given_vertices[one.vertex_index(k)]
        assert Point(Fraction(x), Fraction(y)) == vertex
    # Canonical edge 4 runs from (1, 1) to (3, 1), in the input from (3, 1) to (1, 1).
    assert one.edge_index(4) == 4 + 3 + 2
    moved = one.translated((100, 0)).reflected()
    for k, vertex in enumerate(moved.vertices):
        x, y = given_vertices[moved.vertex_index(k)]
        assert Point(Fraction(-100 - x), Fraction(-y)) == vertex


def refusal(*holes: list[Vertex]) -> str:
    with pytest.raises(PolygonError) as caught:
        Region(SQUARE, holes)
    return str(caught.value)


def turned(ring: list[Vertex], turns: int, width: int) -> list[Vertex]:
    """Rotate by k quarter turns about the center of a square of that width."""
    for _ in range(turns):
        ring = [(width - y, x) for x, y in ring]
    return ring


@pytest.mark.parametrize("turns", range(4))
def test_a_hole_that_touches_a_wall_twice(turns: int) -> None:
    """From inside, the hole cuts a piece off; otherwise it crosses the wall at the two points."""
    within = turned([(4, 4), (9, 3), (8, 4), (9, 5)], turns, 9)
    assert refusal(within) in {
        f"the interior is disconnected: the exterior and hole 0 touch at ({x},{y}) and elsewhere"
        for x, y in (within[1], within[3])
    }
    out = turned([(4, 4), (9, 3), (11, 4), (9, 5)], turns, 9)
    assert refusal(out) == "hole 0 is not inside the exterior"


@pytest.mark.parametrize("walls", range(16))
def test_a_hole_in_a_hole_may_touch_any_of_its_walls(walls: int) -> None:
    square: list[Vertex] = [(1, 1), (7, 1), (7, 7), (1, 7)]
    left, low, right, high = (walls >> k & 1 for k in range(4))
    inner: list[Vertex] = [(1 + left, 4), (4, 1 + low), (7 - right, 4), (4, 7 - high)]
    assert refusal(square, inner) == "hole 1 is inside hole 0"
    assert refusal(inner, square) == "hole 0 is inside hole 1"


@pytest.mark.parametrize("turns", range(4))
def test_a_hole_that_crosses_another_at_two_points(turns: int) -> None:
    """It enters a notch and ends there, or continues through the mouth of the notch."""
    notched = turned([(1, 1), (7, 1), (4, 4), (7, 7), (1, 7)], turns, 8)
    in_bounds = turned([(2, 4), (5, 3), (6, 4), (5, 5)], turns, 8)
    assert refusal(notched, in_bounds) == "hole 1 is inside hole 0"
    assert refusal(in_bounds, notched) == "hole 0 is inside hole 1"
    for first in (1, 2):
        beyond = turned([(first, 4), (5, 3), (8, 4), (5, 5)], turns, 8)
        for holes in ((notched, beyond), (beyond, notched)):
            assert refusal(*holes).startswith(
                "the interior is disconnected: hole 0 and hole 1 touch at ("
            )


def test_touching_points_are_reported_in_input_coordinates() -> None:
    half = Fraction(1, 2)
    assert refusal([(4, 4), (half, 0), (4, 1), (9 - half, 0)]) in {
        f"the interior is disconnected: the exterior and hole 0 touch at ({x},0) and elsewhere"
        for x in ("1/2", "17/2")
    }
    assert refusal([(4, 4), (9, half), (8, 4), (9, 9 - half)]) in {
        f"the interior is disconnected: the exterior and hole 0 touch at (9,{y}) and elsewhere"
        for y in ("1/2", "17/2")
    }


def test_rings_that_touch_are_reported_in_order() -> None:
    """The first and the last of eight holes."""
    tiny: list[list[Vertex]] = [[(k, 7), (k + 1, 7), (k + 1, 8)] for k in range(1, 7)]
    first: list[Vertex] = [(1, 1), (5, 1), (3, 3)]
    last: list[Vertex] = [(5, 1), (6, 3), (3, 3), (5, 2)]
    assert refusal(first, *tiny, last).startswith(
        "the interior is disconnected: hole 0 and hole 7 touch at ("
    )


@given(polyominoes(14, 5))
def test_polyominoes_with_holes(cells: Cells) -> None:
    made = region(cells)
    assert made.area == len(cells)
    assert len(made.holes) == len(rings(cells)) - 1
    assert Region(made.exterior, [hole.vertices[::-1] for hole in made.holes[::-1]]) == made
    assert made.translated((3, Fraction(1, 2))).reflected((0, 0)).area == made.area


@given(st.integers(0, 8), st.integers(0, 8), polyominoes(10, 4))
def test_two_holes_that_share_a_square_are_rejected(x: int, y: int, cells: Cells) -> None:
    loops = rings(cells)
    moved = [(u + x, v + y) for u, v in loops[0]]
    frame = [(-5, -5), (30, -5), (30, 30), (-5, 30)]
    shares = any((u - x, v - y) in cells for u, v in cells)
    if shares:
        with pytest.raises(PolygonError):
            Region(frame, [loops[0], moved])


def test_few_pairs_of_edges_of_a_region_are_compared(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The teeth below and the holes above lie at different heights."""
    tried = 0

    def count(*ends: Vertex) -> list[Vertex] | None:
        nonlocal tried
        tried += 1
        return touch(*ends)

    monkeypatch.setattr("exactsweep.geometry.region.touch", count)
    teeth = [(k, k % 2) for k in range(101)]
    holes = [[(k, 3), (k + 1, 3), (k, 4)] for k in range(2, 90, 2)]
    assert len(Region([*teeth, (100, 9), (0, 9)], holes)) == 3 * len(holes) + 103
    assert tried < 3 * len(holes)


def plate(count: int) -> Region:
    """Return a plate with a row of holes, listed from right to left."""
    holes = [[(3 * k + 1, 1), (3 * k + 3, 1), (3 * k + 1, 2)] for k in reversed(range(count))]
    return Region([(0, 0), (3 * count + 1, 0), (3 * count + 1, 3), (0, 3)], holes)


def test_numbering_features_takes_linear_time() -> None:
    few, many = (count_calls(partial(number_features, plate(n))) for n in (100, 400))
    assert few < many < 5 * few


def test_a_region_is_convex_without_holes_and_notches() -> None:
    notched = [*SQUARE[:3], (5, 4)]
    found = [Region(*shape).is_convex for shape in ((SQUARE,), (SQUARE, [SMALL]), (notched,))]
    assert found == [True, False, False]


def test_a_region_of_a_region_keeps_its_numbering() -> None:
    one = Region(SQUARE, [OTHER, SMALL[::-1]])
    again, more = Region(one), Region(one, [[(7, 1), (8, 1), (8, 2)]])
    for k in range(len(one)):
        assert again.vertex_index(k) == one.vertex_index(k)
        assert again.edge_index(k) == one.edge_index(k)
    assert number_features(one)[0].items() < number_features(more)[0].items()


def test_rings_of_long_numbers_rebuild_their_region() -> None:
    long = Fraction(1, 3**700)
    region = Region(SQUARE, [[*SMALL[:2], (3, 3 + long), (1, 3)], OTHER])
    found, [(exterior, *holes)] = share_lattice([region])
    assert found == 1
    assert [find_doubled_area(hole) < 0 for hole in holes] == [True, True]
    back = [[(x / found, y / found) for x, y in ring] for ring in (exterior, *holes)]
    assert Region(back[0], back[1:]) == region
