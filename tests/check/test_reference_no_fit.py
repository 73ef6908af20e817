"""No-fit polygons by contact segments: by hand, by counting squares, and against `classify`."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import product
from random import Random

import pytest
from cells import Holed, doubled, grid, shape_of, verdict_by_counting
from hypothesis import given
from hypothesis import strategies as st
from shapes import Cells, cell_sets, polyominoes, ringed, shape_pairs
from tiers import examples

from exactsweep import Point, Polygon, no_fit_polygon
from exactsweep.check import (
    ReferenceInnerFit,
    ReferenceNoFit,
    classify,
    point_in_polygon,
    reference_inner_fit,
    reference_no_fit,
    reference_swept,
)
from exactsweep.corpus.generator.cells import move
from exactsweep.numbers.number import ORIGIN

patient = examples(60)
Written = Sequence[tuple[str, str]]


def box(x0: int, y0: int, x1: int, y1: int) -> Polygon:
    return Polygon([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])


def written(points: Sequence[Point]) -> list[tuple[str, str]]:
    return [(str(x), str(y)) for x, y in points]


def on_segment(t: Point, ends: tuple[Point, Point]) -> bool:
    (ax, ay), (bx, by) = ends
    turn = (bx - ax) * (t.y - ay) - (by - ay) * (t.x - ax)
    return turn == 0 and min(ends) <= t <= max(ends)


def verdict_of(answer: ReferenceNoFit, t: Point) -> str:
    """Locate a position in the answer."""
    sides = [point_in_polygon(t, loop) for loop in (answer.exterior, *answer.holes)]
    if 0 in sides or any(on_segment(t, fit) for fit in answer.exact_fits):
        return "CONTACT"
    return "OVERLAP" if sides.count(1) == 1 else "FREE"


def interesting(answer: ReferenceNoFit) -> list[Point]:
    """Vertices, middles of edges and fits, and points between those."""
    rings = [*(answer.exterior, *answer.holes), *answer.exact_fits]
    points = []
    for ring in rings:
        for (ax, ay), (bx, by) in zip(ring, (*ring[1:], ring[0]), strict=True):
            points += [Point(ax, ay), Point((ax + bx) / 2, (ay + by) / 2)]
    return points


C = "####/#..#/#.../#..#/####"
UNIT = box(0, 0, 1, 1)


# The rows of D and of G; holes and exact fits, each as its vertices.
KNOWN = {
    "hole of G's size": ("###/#.#/###", "#", "", "1,1 1,1"),
    "slot in a hole": ("####/#..#/####", "#", "", "1,1 2,1"),
    "room in a hole": ("####/#..#/#..#/####", "#", "1,1 2,1 2,2 1,2", ""),
    "slot from outside": ("#.#/#.#/###", "#", "", "1,3 1,1"),
    "slots that cross": ("#####/##.##/#...#/##.##/#####", "#", "", "1,2 3,2; 2,1 2,3"),
    "cross that reaches into a door from either side": (
        *("#####/#...#/#...#/#...#/##.##", ".#./###/.#."),
        *("", "1,-3 1,-2; 1,0 1,1"),
    ),
    "cave with a door just wide enough": (C, "#", "1,1 2,1 2,3 1,3", "2,2 4,2"),
    "cave with a door that is too low": (C, "#/#", "1,1 2,1 2,2 1,2", ""),
    "ring around a ring": ("###/#.#/###", "#####/#...#/#...#/#...#/#####", "", "-1,-1 -1,-1"),
    "D inside a hole of G": ("#", "####/#..#/#..#/####", "-2,-2 -1,-2 -1,-1 -2,-1", ""),
    "jigsaw: only part of it goes in": ("####/#..#/#.../####", "##/#.", "", "1,1 1,1"),
}


@pytest.mark.parametrize("name", KNOWN)
def test_known_answers(name: str) -> None:
    d, g, holes, fits = KNOWN[name]
    answer = reference_no_fit(grid(*d.split("/")), grid(*g.split("/")))
    for found, expected in ((answer.holes, holes), (answer.exact_fits, fits)):
        assert "; ".join(" ".join(f"{x},{y}" for x, y in points) for points in found) == expected


def test_triangle_wedged_in_a_hole_by_its_vertices_on_edges() -> None:
    """Vertices touch the middles of edges, so that no vertex meets a vertex."""
    d = Holed(box(-1, -1, 9, 9), (Polygon([(0, 0), (4, 0), (0, 4)]),))
    answer = reference_no_fit(d, [(2, 0), (2, 2), (0, 2)])
    assert answer.holes == ()
    assert answer.exact_fits == ((ORIGIN, ORIGIN),)


def test_slot_that_passes_by_the_corner_of_a_room_is_two_exact_fits() -> None:
    """A triangle on its tip fills a corridor, and goes up where there is a funnel above it."""
    funnel = Polygon([(0, 0), (10, 0), (10, 1), (6, 1), (8, 3), (2, 3), (4, 1), (0, 1)])
    answer = reference_no_fit(Holed(box(-1, -1, 11, 4), (funnel,)), [(1, 0), (2, 1), (0, 1)])
    assert [written(hole) for hole in answer.holes] == [[("2", "2"), ("4", "0"), ("6", "2")]]
    assert [written(fit) for fit in answer.exact_fits] == [
        [("4", "0"), ("0", "0")],
        [("4", "0"), ("8", "0")],
    ]


def test_squares() -> None:
    answer = reference_no_fit(UNIT, UNIT)
    assert answer == (box(-1, -1, 1, 1).vertices, (), ())
    swept = reference_swept(UNIT, UNIT)
    assert swept == (box(-1, -1, 2, 2).vertices, UNIT.vertices, ())


def test_inner_loop_keeps_out_of_a_closed_cave() -> None:
    """G cannot enter, so it sweeps around, and what is inside is not swept."""
    swept = reference_swept(grid(*C.split("/")), box(0, 0, 2, 2))
    assert swept.inner == box(0, 0, 4, 5).vertices
    assert swept.unswept == ()


def test_place_that_is_passed_by_is_an_unswept_hole() -> None:
    """In a wide cave a square goes along the walls and leaves the middle out."""
    cave = grid("##########", "#........#", *["#........#"] * 6, "#........#", "###....###")
    swept = reference_swept(cave, box(0, 0, 3, 3))
    assert swept.unswept == (box(4, 4, 6, 6).vertices,)


# --- Laws ----------------------------------------------------------------------------------------


@patient
@given(cell_sets(), polyominoes(6) | ringed())
@pytest.mark.long
def test_every_half_integer_position_is_as_counted(d: Cells, g: Cells) -> None:
    answer = reference_no_fit(shape_of(d), shape_of(g))
    fine_d, fine_g = doubled(d), doubled(g)
    low, high = min(answer.exterior), max(answer.exterior)
    bottom, top = (f(y for _, y in answer.exterior) for f in (min, max))
    steps = product(
        range(int(2 * low.x) - 1, int(2 * high.x) + 2), range(int(2 * bottom) - 1, int(2 * top) + 2)
    )
    for x, y in steps:
        t = Point(Fraction(x, 2), Fraction(y, 2))
        assert verdict_of(answer, t) == verdict_by_counting(fine_d, move(fine_g, (x, y))), t


@patient
@given(shape_pairs(), st.randoms(use_true_random=False))
def test_positions_are_as_classified(pair: tuple[Holed, Holed], random: Random) -> None:
    d, g = pair
    answer = reference_no_fit(d, g)
    points = interesting(answer)
    picked = random.sample(points, min(6, len(points)))
    between = [Point((p.x + q.x) / 2, (p.y + q.y) / 2) for p in picked for q in picked]
    for t in between:
        assert classify(d, g, t).verdict == verdict_of(answer, t)


@patient
@given(shape_pairs())
def test_roles_exchanged_turn_the_answer_about(pair: tuple[Holed, Holed]) -> None:
    d, g = pair
    answer, other = reference_no_fit(d, g), reference_no_fit(g, d)
    assert Polygon(other.exterior).reflected().vertices == answer.exterior
    turned = sorted(Polygon(hole).reflected().vertices for hole in other.holes)
    assert tuple(turned) == answer.holes
    ends = {frozenset((-x, -y) for x, y in fit) for fit in other.exact_fits}
    assert ends == {frozenset(fit) for fit in answer.exact_fits}


# --- Containers ----------------------------------------------------------------------------------


def test_square_of_the_size_of_its_container_has_one_position() -> None:
    found = reference_inner_fit(box(0, 0, 9, 9), box(0, 0, 9, 9))
    assert found == ReferenceInnerFit((), ((ORIGIN, ORIGIN),))


def test_container_exactly_as_wide_as_the_part() -> None:
    found = reference_inner_fit(grid("####", "#..#"), UNIT)
    assert [written(fit) for fit in found.exact_fits] == [
        [("0", "0"), ("0", "1")],
        [("0", "1"), ("3", "1")],
        [("3", "0"), ("3", "1")],
    ]
    assert found.regions == ()


def test_part_larger_than_its_container_has_no_position() -> None:
    assert reference_inner_fit(UNIT, box(0, 0, 2, 1)) == ((), ())


def test_defect_makes_a_hole_of_the_region() -> None:
    container = Holed(box(0, 0, 9, 9), (box(4, 4, 5, 5),))
    (region,) = reference_inner_fit(container, UNIT).regions
    assert region == (box(0, 0, 8, 8).vertices, (box(3, 3, 5, 5).vertices,))


def test_pinch_is_written_as_two_rings_that_touch() -> None:
    container = Holed(box(0, 0, 10, 10), (Polygon([(1, 5), (3, 3), (5, 5), (3, 7)]),))
    found = reference_inner_fit(container, [(0, 0), (1, 1), (0, 2)])
    assert found.exact_fits == ()
    ((exterior, (hole,)),) = found.regions
    assert exterior == box(0, 0, 9, 8).vertices
    assert written(hole[:1]) == [("0", "4")]


def test_region_inside_a_hole_of_a_region_keeps_its_own_hole() -> None:
    """The part does not get through the gap of a C, but there is room inside, around a defect."""
    c = [(8, 8), (22, 8), (22, 14), (21, 14), (21, 9), (9, 9), (9, 21), (21, 21), (21, 15)]
    holes = Polygon([*c, (22, 15), (22, 22), (8, 22)]), box(14, 14, 15, 15)
    found = reference_inner_fit(Holed(box(0, 0, 30, 30), holes), box(0, 0, 2, 2))
    assert found.regions == (
        (box(0, 0, 28, 28).vertices, (box(6, 6, 22, 22).vertices,)),
        (box(9, 9, 19, 19).vertices, (box(12, 12, 15, 15).vertices,)),
    )


def test_ring_can_lie_around_a_defect() -> None:
    container = Holed(box(0, 0, 9, 9), (box(4, 4, 5, 5),))
    ring = grid("####", "#..#", "#..#", "####")
    (region,) = reference_inner_fit(container, ring).regions
    assert region == (box(2, 2, 3, 3).vertices, ())


def test_links_that_hold_each_other_by_a_point_have_one_position() -> None:
    """A defect touches a spike of the wall, and the part, around the defect, touches itself there.

    No edge of either can slide along the other, so no contact segment passes through the position.
    """
    wall = [(-20, -20), (20, -20), (20, -5), (0, 0), (20, 5), (20, 20), (-20, 20)]
    container = Holed(Polygon(wall), (Polygon([(0, 0), (-4, -1), (-4, 1)]),))
    arms = [(-10, -10), (1, -10), (0, 0), (1, 10), (-10, 10)]
    gap = Polygon([(0, 0), (-1, 5), (-8, 5), (-8, -5), (-1, -5)])
    found = reference_inner_fit(container, Holed(Polygon(arms), (gap,)))
    assert (ORIGIN, ORIGIN) in found.exact_fits


def positions_say(found: ReferenceInnerFit, t: Point) -> bool:
    for exterior, holes in found.regions:
        if point_in_polygon(t, exterior) >= 0 and all(point_in_polygon(t, h) <= 0 for h in holes):
            return True
    return any(on_segment(t, fit) for fit in found.exact_fits)


@patient
@given(cell_sets(), polyominoes(4))
def test_positions_inside_a_container_are_as_counted(container: Cells, part: Cells) -> None:
    found = reference_inner_fit(shape_of(container), shape_of(part))
    fine, fine_part = doubled(container), doubled(part)
    xs, ys = zip(*fine, strict=True)
    for x, y in product(range(min(xs) - 9, max(xs) + 9), range(min(ys) - 9, max(ys) + 9)):
        inside = move(fine_part, (x, y)) <= fine
        assert positions_say(found, Point(Fraction(x, 2), Fraction(y, 2))) == inside, (x, y)


# --- Areas swept ---------------------------------------------------------------------------------


@patient
@given(cell_sets(), polyominoes(4))
def test_points_swept_are_those_of_some_position(d: Cells, g: Cells) -> None:
    """A square of half a unit is swept if G covers it in passing, else not at all."""
    shape, part = shape_of(d), shape_of(g)
    answer = reference_no_fit(shape, part)
    swept = reference_swept(shape, part, answer.exterior)
    fine: set[tuple[int, int]] = set()
    for (ax, ay), (bx, by) in zip(
        answer.exterior, (*answer.exterior[1:], answer.exterior[0]), strict=True
    ):
        steps = int(2 * max(abs(bx - ax), abs(by - ay)))
        for k in range(steps):
            at = int(2 * ax + (bx - ax) * 2 * k / steps), int(2 * ay + (by - ay) * 2 * k / steps)
            fine |= move(doubled(g), at)
    holes = (swept.inner, *swept.unswept)
    xs, ys = zip(*fine, strict=True)
    for x, y in product(range(min(xs) - 1, max(xs) + 2), range(min(ys) - 1, max(ys) + 2)):
        middle = Fraction(2 * x + 1, 4), Fraction(2 * y + 1, 4)
        inside = point_in_polygon(middle, swept.outer) > 0
        covered = inside and all(point_in_polygon(middle, hole) < 0 for hole in holes)
        assert covered == ((x, y) in fine), (x, y)
    for x, y in d:
        assert point_in_polygon((x + Fraction(1, 2), y + Fraction(1, 2)), swept.inner) > 0


def test_contacts_along_one_line_far_apart_and_within_each_other() -> None:
    """A tooth on a long beam meets a pillar while the foot is on another plain of one height."""
    plains = [(0, -90), (300, -90), (300, 0), (200, 0), (200, -50), (100, -50), (100, 0)]
    d = [*plains, (66, 0), (66, 50), (64, 50), (64, 0), (0, 0)]
    g = [(30, 0), (40, 0), (40, 80), (-200, 80), (-200, 50), (-199, 50), (-199, 60), (30, 60)]
    answer, expected = reference_no_fit(d, g), no_fit_polygon(d, g)
    assert (answer.exterior, list(answer.holes)) == (
        expected.exterior.vertices,
        [hole.vertices for hole in expected.holes],
    )
    assert list(answer.exact_fits) == list(expected.exact_fits)


@pytest.mark.parametrize("way", [(1, 1), (-1, 1), (1, -1), (-1, -1)])
@pytest.mark.parametrize(("wide", "high"), [(2, 90), (90, 2)])
def test_containers_of_any_shape_and_place(way: tuple[int, int], wide: int, high: int) -> None:
    """Far from the origin, long one way and short the other."""
    for far_x, far_y in ((0, 0), (700, 0), (0, 700)):
        x, y = way[0] * far_x, way[1] * far_y
        found = reference_inner_fit(box(x, y, x + wide, y + high), box(5, 7, 6, 8))
        inside = box(x - 5, y - 7, x + wide - 6, y + high - 8)
        assert found == ReferenceInnerFit(((inside.vertices, ()),), ())


@pytest.mark.parametrize("by", [(700, -900), (-700, 900)])
def test_loops_swept_far_away_are_those_swept_here(by: tuple[int, int]) -> None:
    u, c = (Fraction(by[0]), Fraction(by[1])), grid(*C.split("/"))
    g, far = [(0, 0), (2, 0), (1, 2)], c.exterior.translated(u)
    here, there = reference_swept(c, g), reference_swept(far, g)
    loops = [[Point(p.x + u[0], p.y + u[1]) for p in loop] for loop in (here.outer, here.inner)]
    assert [[*there.outer], [*there.inner]] == loops
    assert len(there.unswept) == len(here.unswept)
