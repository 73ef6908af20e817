"""Regions: what is taken, what is refused and how, and that equal sets are equal."""

import pickle
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from polyominoes import Cells, polyominoes, region, rings

from exactsweep import NumberError, Point, Polygon, PolygonError, Region
from exactsweep.geometry.overlap import touch
from exactsweep.geometry.point import Vertex

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


def test_it_cannot_be_changed_and_can_be_kept() -> None:
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


def test_indices_count_through_the_rings_as_given() -> None:
    # The second hole comes first in canonical order, and is given clockwise.
    one = Region(SQUARE, [OTHER, SMALL[::-1]])
    assert one.holes == (Polygon(SMALL), Polygon(OTHER))
    given_vertices = SQUARE + OTHER + SMALL[::-1]
    for k, vertex in enumerate(one.vertices):
        x, y = given_vertices[one.vertex_index(k)]
        assert Point(Fraction(x), Fraction(y)) == vertex
    # Canonical edge 4 runs from (1, 1) to (3, 1); given, from (3, 1) to (1, 1).
    assert one.edge_index(4) == 4 + 3 + 2
    moved = one.translated((100, 0)).reflected()
    for k, vertex in enumerate(moved.vertices):
        x, y = given_vertices[moved.vertex_index(k)]
        assert Point(Fraction(-100 - x), Fraction(-y)) == vertex


@pytest.mark.parametrize(
    ("holes", "message"),
    [
        ([[(8, 8), (12, 8), (8, 12)]], "^hole 0, edge ., and the exterior, edge . cross$"),
        ([[(20, 20), (21, 20), (20, 21)]], "^hole 0 is not inside the exterior$"),
        ([SMALL, [(0, 0), (9, 0), (9, 9), (0, 9)]], "^hole 1, edge 3, and the exterior, edge 3"),
        ([[(0, 1), (2, 1), (2, 2), (0, 2)]], "edge 3.*the exterior, edge 3 run along each other$"),
        ([SMALL, [(2, 2), (4, 2), (4, 4), (2, 4)]], "^hole [01], edge .*, and hole [01],.* cross$"),
        ([SMALL, [(3, 1), (4, 1), (4, 3), (3, 3)]], "run along each other$"),
        ([[(2, 1), (6, 3), (4, 4)], [(4, 2), (5, 1), (8, 4)]], "run along each other$"),
        ([SMALL, SMALL], "run along each other$"),
        ([[(1, 1), (5, 1), (5, 5), (1, 5)], [(2, 2), (3, 2), (2, 3)]], "^hole 1 is inside hole 0$"),
        ([[(2, 2), (3, 2), (2, 3)], [(1, 1), (5, 1), (5, 5), (1, 5)]], "^hole 0 is inside hole 1$"),
        # Of equal bounds, touching in points only.
        (
            [[(3, 1), (5, 3), (3, 5), (1, 3)], [(1, 3), (2, 1), (4, 1), (5, 3), (4, 5), (2, 5)]],
            "hole",
        ),
        (
            [[(1, 3), (2, 1), (4, 1), (5, 3), (4, 5), (2, 5)], [(3, 2), (5, 3), (3, 4), (1, 3)]],
            "hole",
        ),
        ([[(0, 4), (4, 0), (9, 5)]], "^the interior falls apart: the exterior and hole 0 touch at"),
        (
            [[(1, 1), (4, 4), (1, 5)], [(1, 1), (5, 1), (4, 4)]],
            "run along each other|^the interior falls apart",
        ),
        (
            [[(1, 1), (4, 4), (1, 5)], [(1, 5), (4, 8), (1, 8)], [(4, 4), (4, 8), (6, 6)]],
            "^the interior falls apart: hole",
        ),
        ([[(1, 1), (2, 2), (3, 3)]], "^hole 0: zero area"),
        ([SMALL, [(5, 5), (6, 6), (5, 6), (6, 5)]], "^hole 1: the boundary crosses itself"),
        (7, "^int is not a sequence of holes$"),
    ],
)
def test_refusals_name_rings_and_indices(holes: list[list[tuple[int, int]]], message: str) -> None:
    with pytest.raises(PolygonError, match=message):
        Region(SQUARE, holes)


def test_refusals_of_the_exterior_and_of_numbers() -> None:
    with pytest.raises(PolygonError, match=r"^exterior: fewer than three"):
        Region([(0, 0), (1, 0)])
    with pytest.raises(NumberError, match=r"^hole 0: vertex 1: nan"):
        Region(SQUARE, [[(1, 1), (float("nan"), 1), (1, 2)]])


def test_rings_may_touch_in_single_points() -> None:
    touching = Region(SQUARE, [[(0, 4), (2, 3), (2, 5)], [(2, 5), (4, 5), (4, 7)]])
    assert touching.area == 81 - 2 - 2
    three = Region(
        SQUARE, [[(4, 4), (6, 4), (6, 5)], [(4, 4), (4, 6), (3, 6)], [(4, 4), (2, 4), (2, 3)]]
    )
    assert len(three.holes) == 3


def test_a_hole_between_touching_points_may_lie_outside() -> None:
    """Its vertices are all on the exterior or in it, and it is outside between two of them."""
    notched = [(0, 0), (9, 0), (9, 9), (6, 9), (5, 4), (4, 9), (0, 9)]
    with pytest.raises(PolygonError):
        Region(notched, [[(4, 9), (5, 4), (6, 9)]])


@given(polyominoes(14, 5))
def test_polyominoes_with_holes(cells: Cells) -> None:
    made = region(cells)
    assert made.area == len(cells)
    assert len(made.holes) == len(rings(cells)) - 1
    assert Region(made.exterior, [hole.vertices[::-1] for hole in made.holes[::-1]]) == made
    assert made.translated((3, Fraction(1, 2))).reflected((0, 0)).area == made.area


@given(st.integers(0, 8), st.integers(0, 8), polyominoes(10, 4))
def test_two_holes_that_share_a_square_are_refused(x: int, y: int, cells: Cells) -> None:
    loops = rings(cells)
    moved = [(u + x, v + y) for u, v in loops[0]]
    frame = [(-5, -5), (30, -5), (30, 30), (-5, 30)]
    shares = any((u - x, v - y) in cells for u, v in cells)
    if shares:
        with pytest.raises(PolygonError):
            Region(frame, [loops[0], moved])


def test_only_a_region_without_holes_may_be_convex() -> None:
    box = [(0, 0), (9, 0), (9, 9), (0, 9)]
    assert Region(box).is_convex
    assert not Region(box, [[(1, 1), (2, 1), (1, 2)]]).is_convex
    assert not Region([*box, (1, 5)]).is_convex


def test_few_edges_of_a_region_are_tried_against_each_other(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Those of the teeth below and of the holes above lie at other heights."""
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
