"""Sweeps of polygons of any shape: contacts, undercuts, steps and certificates."""

import json
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from polyominoes import Cells, frame, polyominoes, region
from tiers import examples

from exactsweep import Point, Polygon, Region, inner_fit_polygon, no_fit_polygon, sweep
from exactsweep.check import classify, verify
from exactsweep.evidence.contact import number_as_given
from exactsweep.evidence.steps import explain
from exactsweep.evidence.sweep import Sweep
from exactsweep.geometry.outline import Outline
from exactsweep.numbers.point import ORIGIN
from exactsweep.procedures.mouths import find_mouths

Ring = list[tuple[int, int]]
SHEARS = [(1, 0, 0, 1), (1, 1, 0, 1), (2, 1, 1, 1), (0, -1, 1, 0)]
UNIT = [(0, 0), (1, 0), (1, 1), (0, 1)]
# A cave of 2 x 2 with an opening in its right wall that is just high enough for a unit square.
DOOR = [(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (3, 3), (3, 2), (4, 2), (4, 4), (0, 4)]
PLATE = [(0, 0), (9, 0), (9, 9), (6, 9), (6, 3), (5, 3), (5, 9), (0, 9)]


def shape_sweep(g: Region, d: Region) -> Sweep:
    return Sweep(g, d, None, ORIGIN)


def on_segment(p: Point, a: Point, b: Point) -> bool:
    turn = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)
    return turn == 0 and min(a, b) <= p <= max(a, b)


def respell(shape: Region, turns: bool, by: int) -> list[list[Point]]:
    """The rings from another vertex on, perhaps the other way round."""
    rings = [[*ring[by % len(ring) :], *ring[: by % len(ring)]] for ring in shape.rings]
    return [ring[::-1] for ring in rings] if turns else rings


def feature(rings: list[list[Point]], k: int, event: str) -> tuple[Point, ...]:
    for ring in rings:
        if k < len(ring):
            return (ring[k], ring[(k + 1) % len(ring)]) if event == "E" else (ring[k],)
        k -= len(ring)
    raise IndexError(k)


@given(
    polyominoes(12, 5),
    polyominoes(7, 4),
    st.sampled_from(SHEARS),
    st.booleans(),
    st.integers(0, 5),
)
@examples(60)
def test_contacts_touch_where_they_are_said_to(
    d: Cells, g: Cells, matrix: tuple[int, int, int, int], turns: bool, by: int
) -> None:
    directrix, generatrix = (respell(region(cells, matrix), turns, by) for cells in (d, g))
    s = shape_sweep(*(Region(rings[0], rings[1:]) for rings in (generatrix, directrix)))
    for k, t in enumerate(s.trajectory.vertices):
        after = s.trajectory.vertices[(k + 1) % len(s.trajectory)]
        middle = Point((t.x + after.x) / 2, (t.y + after.y) / 2)
        at_middle = s.contacts_at(middle)
        assert at_middle
        lasting = {c for c in at_middle if c.event != "VV"}
        assert s.contacts[k]
        assert {c for c in lasting if c.event == "EE"} <= set(s.contacts[k])
        for event, i, j in at_middle:
            moved = [
                Point(p.x + middle.x, p.y + middle.y) for p in feature(generatrix, i, event[0])
            ]
            other = feature(directrix, j, event[1])
            if event == "VV":
                assert moved == [*other]
            elif event == "VE":
                assert on_segment(moved[0], *other)
            elif event == "EV":
                assert on_segment(other[0], *moved)
            else:
                assert any(on_segment(p, *moved) for p in other) or any(
                    on_segment(p, *other) for p in moved
                )


@given(polyominoes(12, 5), polyominoes(7, 4), st.sampled_from(SHEARS))
@examples(40)
def test_certificates_are_proved(d: Cells, g: Cells, matrix: tuple[int, int, int, int]) -> None:
    s = sweep(region(g, matrix), region(d, matrix))
    assert verify(json.loads(json.dumps(s.certificate()))).reason == "proved"


@given(polyominoes(12, 5), polyominoes(7, 4))
@examples(40)
def test_undercuts_holes_and_the_directrix_fill_the_inner_loop(d: Cells, g: Cells) -> None:
    s = shape_sweep(region(g), region(d))
    undercuts = sum((u.polygon.area for u in s.undercuts), Fraction(0))
    assert s.directrix.exterior.area + undercuts == s.inner.area
    for undercut in s.undercuts:
        assert undercut.positions
        for position in undercut.positions:
            assert classify(s.directrix, s.generatrix, position).verdict == "CONTACT"


def test_an_undercut_behind_a_door() -> None:
    big = shape_sweep(Region([(0, 0), (2, 0), (2, 2), (0, 2)]), Region(DOOR))
    (undercut,) = big.undercuts
    # The cave and its door; the mouth is the door's opening.
    assert undercut.polygon.area == 2 * 2 + 1
    assert set(undercut.extremes) == {Point(Fraction(4), Fraction(y)) for y in (1, 2)}
    assert undercut.intersection == "segment"


def test_a_hole_is_inside_the_inner_loop_and_no_undercut() -> None:
    plate = Region([(0, 0), (9, 0), (9, 9), (0, 9)], [[(2, 2), (5, 2), (5, 5), (2, 5)]])
    s = sweep(UNIT, plate)
    assert s.kind == "SS"
    assert s.unswept == s.undercuts == ()
    assert s.inner == plate.exterior
    assert s.outer == Polygon([(-1, -1), (10, -1), (10, 10), (-1, 10)])
    assert s.area == 121 - 81


def test_what_is_passed_by_in_a_wide_cave_is_not_swept() -> None:
    # G goes in along one wall and out along the other: the middle of the cave stays free.
    corners = [(0, 0), (20, 0), (20, 14), (10, 14), (10, 12), (18, 12), (18, 2), (2, 2), (2, 12)]
    cave = [*corners, (8, 12), (8, 14), (0, 14)]
    s = sweep(UNIT, cave)
    assert s.kind == "SS"
    assert s.unswept == (Polygon([(3, 3), (17, 3), (17, 11), (3, 11)]),)
    assert s.inner == Polygon(cave)


def test_an_inner_loop_that_has_all_corners_and_middles_of_the_directrix_on_it() -> None:
    """Found by the campaign: the undercut lies in a quarter of an edge of D."""
    d = [(12, 7), (20, 13), (24, 15), (23, 17), (16, 13)]
    g = [(-3, 10), (3, 13), (4, 13), (9, 16), (14, 21), (21, 26), (7, 19), (10, 19), (3, 15)]
    s = shape_sweep(Region([*g, (2, 16), (1, 15)]), Region(d))
    closed = [(12, 7), (18, "23/2"), ("203/11", "129/11"), ("208/11", "134/11")]
    assert s.inner == Polygon([*closed, *d[1:]])


def test_the_numbers_of_features_are_those_of_the_input() -> None:
    hole = [(4, 4), (4, 6), (6, 6), (6, 4)]
    plate = Region([(9, 0), (9, 9), (0, 9), (0, 0)], [hole])
    ring = Region(
        [(20, -5), (20, 15), (-5, 15), (-5, -5)], [[(-2, -2), (14, -2), (14, 14), (-2, 14)]]
    )
    s = sweep(ring, plate)
    # Inside the ring the plate touches the hole of the ring.
    contact = {c.event: c for c in s.contacts_at((2, 0))}["EE"]
    # Edge 3 of the hole of G, at x = -2 + 2, runs from its vertex 3 to 0; edge 2 of D is at x = 0.
    assert (contact.generatrix, contact.directrix) == (4 + 3, 2)


@given(polyominoes(10, 4), polyominoes(5, 3))
@examples(30)
def test_steps_go_round_the_trajectory(d: Cells, g: Cells) -> None:
    s = shape_sweep(region(g), region(d))
    steps = explain(s)
    assert [step.start for step in steps] == list(s.trajectory.vertices)
    for step in steps:
        assert step.ending in {"corner", "stop", "exact fit"}
        assert step.touches


@given(polyominoes(6, 3))
@examples(20)
def test_a_mould_around_its_part(g: Cells) -> None:
    mould = frame(g, 2)
    assume(len(region(g).holes) == 0)
    s = sweep(region(g), region(mould))
    assert s.kind == "SS"
    assert (ORIGIN, ORIGIN) in s.exact_fits
    assert verify(s.certificate()).proved


def test_a_bottom_chain_with_a_corner_is_one_mouth() -> None:
    roof = [(0, 0), (6, 0), (6, 6), (4, 6), (3, 2), (2, 6), (0, 6)]
    (mouth,) = find_mouths([p if p != (3, 2) else (3, 5) for p in roof], roof)
    assert mouth.bottom == [(4, 6), (3, 5), (2, 6)]
    assert mouth.top == [(2, 6), (3, 2), (4, 6)]


def test_features_of_several_holes_are_numbered_as_given() -> None:
    rings = [
        [(9, 0), (9, 9), (0, 9), (0, 0)],
        [(2, 1), (1, 1), (1, 2)],
        [(5, 3), (5, 5), (3, 5), (3, 3)],
        [(7, 7), (6, 7), (7, 6)],
    ]
    shape, given = Region(rings[0], rings[1:]), [p for ring in rings for p in ring]
    following = [p for ring in rings for p in ring[1:] + ring[:1]]
    outline = Outline(shape.lattice()[1])
    for k, vertex in enumerate(outline.vertices):
        assert given[number_as_given(shape, outline, k, of_edge=False)] == vertex
        i = number_as_given(shape, outline, k, of_edge=True)
        assert {given[i], following[i]} == set(outline.edge(k))
    swept = sweep(UNIT, shape).directrix
    for k, vertex in enumerate(swept.vertices):
        x, y = given[swept.vertex_index(k)]
        assert vertex == Point(Fraction(x), Fraction(y))


@pytest.mark.parametrize("reference", [(0, 0), ("1/3", -2)])
def test_answers_with_exact_fits_are_proved_for_any_reference_point(reference: Any) -> None:
    frame = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (3, 2), (3, 3), (0, 3)]
    n = no_fit_polygon(frame, UNIT, reference=reference)
    f = inner_fit_polygon([(0, 0), (3, 0), (3, 1), (0, 1)], UNIT, reference=reference)
    for answer in (n, f):
        assert len(answer.exact_fits) == 1
        assert verify(answer.certificate()).proved
