"""Rounded pieces in layouts: discs, slots and rounded rectangles, judged without flattening."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Any

import campaign
import pytest

from exactsweep import Point
from exactsweep.check.standalone import prove
from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.layout import Judgement, Layout, LayoutError, judge_layout
from exactsweep.layout.clearance import Clearance
from exactsweep.layout.report import draw_layout, rank_faults, report_layout
from exactsweep.layout.report.outline import list_vertices
from exactsweep.layout.rounded import (
    HullDistance,
    RoundedPiece,
    bound_pi,
    bound_root,
    measure_hulls,
)
from exactsweep.numbers.number import ORIGIN

UNIT = [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]]
LATER = range(1000, 1400, 25)


def piece(points: Any, radius: Any) -> dict[str, Any]:
    return {"points": [[str(x), str(y)] for x, y in points], "radius": str(radius)}


def judge(parts: list[Any], moves: list[Any], **more: Any) -> Judgement:
    """Judge a layout in which every part is placed once."""
    named = [{"id": str(k), "pieces": pieces} for k, pieces in enumerate(parts)]
    placed = [{"part": str(k), "move": [*map(str, move)]} for k, move in enumerate(moves)]
    return judge_layout(Layout.from_json({"parts": named, "placements": placed, **more}))


def discs(*radii: Any) -> list[Any]:
    return [[piece([(0, 0)], radius)] for radius in radii]


@pytest.mark.parametrize(
    "numbers", [range(12), *(pytest.param(range(k, k + 25), marks=pytest.mark.long) for k in LATER)]
)
def test_random_packings_are_judged_as_by_closed_formulas(numbers: range) -> None:
    assert campaign.find_failures("packings", 7, numbers) == []


@pytest.mark.parametrize(
    ("move", "verdict"), [(("3", "4"), "contact"), (("3", "3.999999999999"), "overlap")]
)
def test_discs_touch_at_the_sum_of_their_radii(move: Any, verdict: str) -> None:
    judgement = judge(discs(2, 3), [(0, 0), move])
    assert judgement.valid is (verdict == "contact")
    assert judgement.contacts == (((0, 1),) if verdict == "contact" else ())
    assert prove(judgement.certificate())


def test_the_depth_of_an_overlap_of_discs_is_exact_if_it_is_rational() -> None:
    (fault,) = judge(discs(3, 3), [(0, 0), (3, 4)]).faults
    assert fault.depth_squared == 1
    assert fault.move is not None
    assert tuple(fault.move) == (Fraction(3, 5), Fraction(4, 5))
    assert fault.is_within(Fraction(1))
    assert not fault.is_within(Fraction(999, 1000))


def test_the_depth_of_hulls_that_overlap_adds_to_the_radii() -> None:
    square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    (fault,) = judge([[piece(square, 1)], [piece([(0, 0)], 1)]], [(0, 0), (3, 2)]).faults
    assert fault.depth_squared == 9


def test_an_irrational_depth_is_rounded_up() -> None:
    (fault,) = judge(discs(1, 1), [(0, 0), (1, 1)]).faults
    depth = bound_root(fault.depth_squared or Fraction(0), 200)[1]
    assert 0 < (2 - depth) ** 2 <= 2
    assert 2 - (2 - depth) ** 2 < Fraction(1, 2**50)
    assert fault.to_json()["hull_distance_squared"] == "2"
    assert fault.to_json()["radii"] == "2"


def test_too_close_discs_have_a_witness_and_a_shortfall() -> None:
    judgement = judge(discs(1, 1), [(0, 0), (3, 0)], spacing="3/2")
    (fault,) = judgement.faults
    assert fault.kind == "too close"
    assert fault.distance_squared == 1
    assert fault.points == (Point(Fraction(1), Fraction(0)), Point(Fraction(2), Fraction(0)))
    assert fault.is_within(Fraction(1, 2))
    assert not fault.is_within(Fraction(49, 100))
    assert prove(judgement.certificate())


@pytest.mark.parametrize(
    ("radius", "margin", "kinds"),
    [("5", "0", []), ("4.999", "0", ["outside"]), ("5", "1/8", ["too close"]), ("9", "1/8", [])],
)
def test_a_disc_is_in_a_disc_up_to_the_difference_of_radii(
    radius: str, margin: str, kinds: list[str]
) -> None:
    container = {"pieces": [piece([(0, 0)], radius)]}
    judgement = judge(discs(0.5), [("27/10", "36/10")], container=container, margin=margin)
    assert [fault.kind for fault in judgement.faults] == kinds
    assert prove(judgement.certificate())
    for fault in judgement.faults:
        assert fault.move is not None


def test_a_slot_leaves_a_rounded_container_at_its_farther_end() -> None:
    container = {"pieces": [piece([(0, 0), (6, 0), (6, 2), (0, 2)], 1)]}
    slot = [piece([(0, 0), (3, 0)], 1)]
    for x, is_valid in (("3", True), ("0", True), ("3.0001", False), ("-1/1000", False)):
        judgement = judge([slot], [(x, 2)], container=container)
        assert judgement.valid is is_valid
        assert prove(judgement.certificate())


def test_a_piece_wider_than_a_rounded_container_is_judged_by_its_hull() -> None:
    """A disc of radius 2 fits in a rectangle of 4 x 6 with radius 1 at its middle segment alone."""
    container = {"pieces": [piece([(0, 0), (2, 0), (2, 4), (0, 4)], 1)]}
    for move, is_valid in (((1, 1), True), ((1, 3), True), ((1, "0.999"), False), ((2, 2), False)):
        judgement = judge(discs(2), [move], container=container)
        assert judgement.valid is is_valid
        assert prove(judgement.certificate())


def test_a_part_of_several_pieces_is_their_union() -> None:
    corner = [piece([(0, 0), (9, 0)], 1), piece([(0, 0), (0, 9)], 1)]
    assert judge([corner, *discs(1)], [(0, 0), (2, 2)]).contacts == ((0, 1),)
    judgement = judge([corner, *discs(1)], [(0, 0), ("1.9", 5)])
    (fault,) = judgement.faults
    assert fault.depth_squared is not None
    assert fault.depth_squared == Fraction(1, 100)
    assert prove(judgement.certificate())
    assert judgement.density is None


def test_polygons_and_discs_are_judged_together() -> None:
    data = {
        "container": {"exterior": [["0", "0"], ["4", "0"], ["4", "2"], ["0", "2"]]},
        "parts": [{"id": "a", "exterior": UNIT}, {"id": "b", "pieces": [piece([(0, 0)], 1)]}],
        "placements": [{"part": "a", "move": ["0", "1"]}, {"part": "b", "move": ["2", "1"]}],
    }
    judgement = judge_layout(Layout.from_json(data))
    assert judgement.valid
    assert judgement.contacts == ((0, 1),)
    assert prove(judgement.certificate())
    data["defects"] = [{"pieces": [piece([("3.5", "1")], "0.50001")]}]
    judgement = judge_layout(Layout.from_json(data))
    assert [(fault.kind, fault.placements) for fault in judgement.faults] == [("outside", (1,))]
    assert prove(judgement.certificate())


def test_a_disc_about_its_origin_has_no_error_at_any_angle() -> None:
    parts = [{"id": "a", "pieces": [piece([(0, 0)], 1)]}]
    placed = [{"part": "a", "turn": turn, "move": ["0", y]} for turn, y in (("1", "0"), ("7", "2"))]
    judgement = judge_layout(Layout.from_json({"parts": parts, "placements": placed}))
    assert judgement.contacts == ((0, 1),)


def test_errors_leave_rounded_pieces_undecided() -> None:
    parts = [{"id": "a", "pieces": [piece([(0, 0)], 1)], "error": "1/100"}]
    for y, kinds in (("2.03", []), ("2.01", ["undecided"]), ("1.97", ["overlap"])):
        placed = [{"part": "a", "move": ["0", at]} for at in ("0", y)]
        judgement = judge_layout(Layout.from_json({"parts": parts, "placements": placed}))
        assert [fault.kind for fault in judgement.faults] == kinds
        if kinds != ["undecided"]:
            assert prove(judgement.certificate())


@pytest.mark.parametrize(
    ("pieces", "message"),
    [
        ([], "parts[0].pieces is empty"),
        ([{"points": []}], "parts[0].pieces[0].points is empty"),
        ([{"points": [["0", "0"], ["1", "1"]]}], "parts[0].pieces[0] has no interior"),
        ([{"points": UNIT, "radius": "-1"}], "parts[0].pieces[0].radius"),
        ([{"points": UNIT, "width": "1"}], "parts[0].pieces[0] has an unknown field 'width'"),
    ],
)
def test_pieces_without_an_interior_are_rejected(pieces: Any, message: str) -> None:
    data = {"parts": [{"id": "a", "pieces": pieces}], "placements": []}
    with pytest.raises(LayoutError) as error:
        Layout.from_json(data)
    assert str(error.value).startswith(message)


def test_a_container_has_one_piece() -> None:
    two = {"pieces": [piece([(0, 0)], 1), piece([(0, 0)], 2)]}
    with pytest.raises(LayoutError, match="pieces, not 1"):
        Layout.from_json({"container": two, "parts": [], "placements": []})


def test_pieces_are_written_as_they_are_read() -> None:
    layout = judge(discs("1/3"), [(0, 0)], container={"pieces": [piece([(0, 0)], 1)]}).layout
    assert Layout.from_json(layout.to_json()) == layout


def test_density_and_nearest_pair_have_bounds() -> None:
    judgement = judge(discs(1, 1), [(0, 0), (5, 0)], container={"pieces": [piece([(2, 0)], 10)]})
    assert judgement.density is not None
    assert abs(judgement.density - Fraction(1, 50)) <= judgement.density_error < Fraction(1, 2**60)
    assert judgement.distance is not None
    assert judgement.distance.square == 9


def test_pictures_have_arcs() -> None:
    judgement = judge(discs(2, 3), [(0, 0), (3, "3.99")])
    ranked = rank_faults(judgement)
    picture = draw_layout(judgement, ranked, "discs")
    assert picture.count("A") >= 4
    assert "0.00799639 deep" in report_layout(judgement, ranked)


def test_comparisons_of_clearances_are_exact() -> None:
    hulls = HullDistance(1, 1, None, (1, 0))

    def make(square: Any, radius: Any) -> Clearance:
        return Clearance(Fraction(square), Fraction(radius), hulls, (0, 0))

    values = [make(s, r) for s in (-8, -4, -2, 0, 2, 4, 8, 9) for r in (-2, 0, 1, 3)]
    for one in values:
        for other in values:
            known = [
                (1 if c.square >= 0 else -1) * abs(float(c.square)) ** 0.5 - float(c.radius)
                for c in (one, other)
            ]
            if abs(known[0] - known[1]) > 1e-9:
                assert one.is_less(other) is (known[0] < known[1])
            else:
                assert not one.is_less(other)


def test_degenerate_hulls_are_measured() -> None:
    square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    cases: list[tuple[Any, Any, Fraction]] = [
        ([(0, 0)], [(0, 0)], Fraction(0)),
        ([(0, 0)], [(3, 4)], Fraction(25)),
        ([(0, 0), (4, 0)], [(2, 3)], Fraction(9)),
        ([(0, 0), (4, 0)], [(6, 0), (9, 0)], Fraction(4)),
        ([(0, 0), (4, 0)], [(3, 0), (9, 0)], Fraction(0)),
        ([(0, 0), (4, 4)], [(0, 4), (4, 0)], Fraction(-8)),
        (square, [(2, 1)], Fraction(-1)),
        (square, [(2, 1), (2, 3)], Fraction(-4)),
        (square, [(4, 2)], Fraction(0)),
        (square, [(1, 1), (3, 1), (3, 3), (1, 3)], Fraction(-9)),
        (square, [(5, 5), (7, 5), (5, 7)], Fraction(2)),
    ]
    for one, other, square_distance in cases:
        for a, b in ((one, other), (other, one)):
            found = measure_hulls(a, b)
            assert Fraction(found.n) / found.d == square_distance


def test_bounds_of_pi_enclose_it() -> None:
    low, high = bound_pi(100)
    digits = Fraction("3.14159265358979323846264338327950288")
    assert low < digits + Fraction(1, 10**35)
    assert high > digits
    assert high - low < Fraction(1, 2**99)


@pytest.mark.parametrize("near", [Fraction(2), Fraction(1, 10**6), Fraction(1, 10**30)])
def test_outlines_are_fine_near_enlargements(near: Fraction) -> None:
    center = Point(Fraction(3, 5), Fraction(4, 5))
    ring = list_vertices(RoundedPiece((ORIGIN,), Fraction(1)), center, near)
    assert all(x * x + y * y == 1 for x, y in ring)
    assert find_doubled_area(ring) > Fraction(622, 100)
    inside = [p for p in ring if abs(p[0] - center.x) < near and abs(p[1] - center.y) < near]
    assert len(inside) >= 8
    slot = RoundedPiece((ORIGIN, Point(Fraction(3), Fraction(0))), Fraction(1))
    ring = list_vertices(slot, Point(Fraction(1), Fraction(1)), near)
    assert all(-1 <= y <= 1 for _, y in ring)
    assert (3, 1) in ring


def test_rounded_parts_are_polygons_in_geojson() -> None:
    layout = judge(discs(1), [(5, 0)]).layout
    (polygon,) = layout.__geo_interface__["geometries"]
    xs = [x for x, _ in polygon["coordinates"][0]]
    assert min(xs) == 4
    assert max(xs) == 6


def test_a_depth_of_parts_that_are_not_convex_has_two_bounds() -> None:
    corner = [piece([(0, 0), (9, 0)], 1), piece([(0, 0), (0, 9)], 1)]
    judgement = judge([corner, *discs(1)], [(0, 0), ("1.5", "1.5")])
    (fault,) = judgement.faults
    assert fault.least_depth_squared == Fraction(1, 4)
    assert fault.depth_squared is not None
    assert Fraction(1, 2) <= fault.depth_squared < Fraction(52, 100)
    assert re.search(r"0\.5 to 0\.7\d* deep", report_layout(judgement))
    assert fault.to_json()["least_depth_squared"] == "1/4"
