"""The ledger's own computations: contacts, envelopes of segments, families."""

import re
from fractions import Fraction
from itertools import count, pairwise
from types import SimpleNamespace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Point, Polygon, sweep
from exactsweep.corpus.generator.growing import (
    bumps,
    ceilings,
    edges_of_bumps,
    edges_over_needles,
    needles,
    printed_count,
    undercuts_under_ceilings,
)
from exactsweep.corpus.generator.prng import Prng
from exactsweep.evidence.contact import Contact
from exactsweep.evidence.steps import Touch
from exactsweep.geometry.segment import make_segment
from exactsweep.numbers.number import Vertex
from exactsweep.paper import literal
from exactsweep.paper.checks import appendix, beyond
from exactsweep.paper.checks.appendix import contact_moves_right, meetings, one_edge_at_a_time
from exactsweep.paper.checks.beyond import covers
from exactsweep.paper.checks.section1 import (
    draw_slots,
    fits_are_whole,
    path_is_not_the_directrix,
)
from exactsweep.paper.checks.section2 import (
    like_chains_have_no_contact,
    starts_and_stops_at_the_ends,
)
from exactsweep.paper.checks.section4 import (
    bottom_chains_have_two_forms,
    is_monotone,
    labels_name_the_extremes,
)
from exactsweep.paper.checks.section5 import kernel_is_literal
from exactsweep.paper.checks.segments import (
    BEST,
    build_windows,
    build_windows_of_windows,
    count_pieces,
    pieces_in,
)
from exactsweep.paper.figures.local_width import _measure
from exactsweep.paper.functions import (
    clip,
    evaluate,
    find_common_points,
    lower_undercuts,
    reaches,
    sample_between,
    take_bottom,
    tell_loops,
)
from exactsweep.paper.laws import break_law
from exactsweep.paper.pairs import SweepPair, draw_pair
from exactsweep.procedures.mm import sweep_mm

# Davenport-Schinzel sequences of order 3 of s symbols have at most so many members.
LONGEST = {1: 1, 2: 4, 3: 8, 4: 12, 5: 17, 6: 22}


@pytest.mark.parametrize("segments", BEST)
def test_segments_have_about_as_many_pieces_as_there_can_be(
    segments: tuple[tuple[int, int, int, int], ...],
) -> None:
    most = LONGEST[len(segments)]
    assert most - (len(segments) > 5) <= count_pieces(segments) <= most


def test_a_box_fits_exactly_into_the_slots_of_its_width() -> None:
    drawn = [draw_slots(Prng(str(seed))) for seed in range(6)]
    for box, plate in drawn:
        floors = [abs(q[0] - p[0]) for p, q in pairwise(plate) if p[1] == q[1] not in (0, 40)]
        wide = box[1][0]
        assert len(sweep(box, plate).exact_fits) == floors.count(wide)
        assert {*floors} <= {wide - 1, wide, wide + 1}
    assert sum(len(plate) > 4 for _, plate in drawn) > 3


def test_windows_lay_segments_over_one_another() -> None:
    pair = build_windows(BEST[2])
    assert len(sweep(*pair).directrix) == 27
    assert sweep(*pair).kind == "MM"


def test_windows_of_windows_lay_segments_over_one_another_twice() -> None:
    segments = BEST[2]
    s = sweep(*build_windows_of_windows(segments))
    assert s.kind == "MM"
    assert len(s.generatrix) <= 7 * len(segments)
    assert len(s.directrix) <= 5 * len(segments)
    corners = s.outer.vertices
    lower = corners[: corners.index(max(corners)) + 1]
    assert pieces_in(lower, segments) >= 7 * count_pieces(segments)


def test_the_family_of_figure_10_agrees_with_the_formula_for_one_tooth_or_one_peak() -> None:
    for size in (2, 4, 6):
        assert edges_of_bumps(2, size, 6) == printed_count(2, size, 6)
        assert edges_of_bumps(size, 2, 6) == printed_count(size, 2, 6)
    assert edges_of_bumps(4, 4, 6) != printed_count(4, 4, 6)
    assert len(bumps(2, 4, 6)[0]) == 10


def test_needles_have_as_many_inner_edges_as_proved() -> None:
    for m, n in ((10, 8), (13, 14), (7, 24)):
        pair = SweepPair(*needles(m, n))
        assert (len(pair.directrix), len(pair.generatrix)) == (m, n)
        found = len(sweep_mm(*pair.chains)[0]) - 1
        assert edges_over_needles(m, n) <= found <= edges_over_needles(m, n) + 12


@pytest.mark.parametrize(
    ("m", "n", "undercuts"), [(7, 16, 43), (7, 32, 211), (13, 16, 129), (25, 16, 301)]
)
def test_ceilings_have_order_mn2_undercuts(m: int, n: int, undercuts: int) -> None:
    pair = ceilings(m, n)
    s = sweep(*pair)
    assert (len(s.directrix), len(s.generatrix), s.kind) == (m, n, "MM")
    assert len(lower_undercuts(s)) == undercuts == undercuts_under_ceilings(m, n)
    # The trajectory between the outer needles is that of the needles without ceilings.
    start, end = -max(x for x, _ in pair[0]), max(x for x, y in pair[1] if y == 0)
    low, high = (
        clip(take_bottom(t.vertices), Fraction(start), Fraction(end))
        for t in (s.trajectory, sweep(*needles(m, n)).trajectory)
    )
    assert low == high


@examples(60)
@given(st.integers(0, 10**6), st.sampled_from(["CC", "CM", "MM"]))
def test_the_procedures_to_the_letter_give_what_the_kernel_gives(seed: int, kind: str) -> None:
    assert not any(kernel_is_literal(draw_pair(Prng(str(seed)), kind)))


def test_an_undercut_may_end_where_an_edge_is_touched_in_passing() -> None:
    directrix = [(3, 12), (10, 52), (9, 49), (8, 48), (5, 43), (3, 48)]
    assert not any(labels_name_the_extremes(SweepPair([(0, 0), (6, 0), (7, 1)], directrix)))


def test_a_slide_along_an_undercut_may_be_stopped_by_another_contact() -> None:
    directrix = [(-1, 5), (2, 0), (10, 2), (11, 6), (7, 3), (5, 5), (0, 4)]
    assert not any(bottom_chains_have_two_forms(SweepPair([(5, 0), (17, 2), (9, 4)], directrix)))


def test_chains_are_evaluated_and_cut() -> None:
    chain = [(0, 0), (2, 4), (2, 6), (4, 6)]
    assert evaluate(chain, Fraction(1, 2)) == 1
    assert clip(chain, Fraction(1), Fraction(3)) == [(1, 2), (2, 4), (2, 6), (3, 6)]
    assert list(sample_between([(0, 0), (8, 0)])) == [3]
    assert find_common_points([(0, 0), (2, 2), (4, 0)], [(1, 0), (2, 2), (6, 1)]) == [2]
    assert find_common_points([(0, 0), (2, 2)], [(3, 0), (4, 2)]) == []
    assert [reaches([(0, 0), (2, 2)], Fraction(x)) for x in range(3)] == [False, True, False]
    with pytest.raises(ValueError, match="does not reach 5"):
        evaluate(chain, Fraction(5))


@pytest.mark.parametrize("swapped", [False, True])
def test_chains_of_different_lengths_are_merged_to_their_ends(swapped: bool) -> None:
    long: list[Vertex] = [(0, 0), (4, 0)]
    short: list[Vertex] = [(1, -1), (2, -1)]
    merged = literal.merge(*((short, long) if swapped else (long, short)))
    assert [x for x, _ in merged] == [0, 1, 1, 2, 2, 4]
    assert [y for _, y in merged] == [0, 0, -1, -1, 0, 0]


def test_widths_are_measured_across_edges_of_rational_length() -> None:
    widths = [
        *_measure(sweep([(0, 0), (3, 0), (3, 3), (0, 3)], [(0, 0), (4, -3), (5, -2), (5, 3)]))
    ]
    assert widths
    assert all(x * x + y * y == 1 for _, _, (x, y), *_ in widths)


@pytest.mark.parametrize(
    ("spot", "is_covered"), [((2, 1), True), ((0, 0), True), ((6, 3), False), ((2, 2), False)]
)
def test_a_position_is_covered_by_the_segments_through_it(
    spot: tuple[int, int], is_covered: bool
) -> None:
    start, end, at = (Point(Fraction(x), Fraction(y)) for x, y in ((0, 0), (4, 2), spot))
    assert covers([make_segment((start, end))], (at, at)) == is_covered


@pytest.mark.parametrize(
    ("other", "fault", "met"),
    [
        ([(0, 1), (4, 2)], "", False),
        ([(0, 1), (4, -1)], "", True),
        ([(0, 1), (1, 0), (3, 0), (4, 1)], "", True),
        ([(0, 1), (2, -1), (4, 1)], "the chains meet over 1 and 3, and part in between", True),
    ],
)
def test_chains_meet_in_one_point_or_segment(other: list[Vertex], fault: str, met: bool) -> None:
    assert meetings([(0, 0), (4, 0)], other) == (fault, met)


def test_chains_that_share_a_bend_meet_in_more_than_a_segment() -> None:
    bent: list[Vertex] = [(0, 0), (2, 2), (4, 0)]
    assert meetings(bent, bent) == ("the chains share a bend between 0 and 4", True)


def test_a_loop_that_is_not_that_of_the_definition_is_told() -> None:
    s = sweep([(0, 0), (1, 0), (0, 1)], [(0, 0), (3, 0), (3, 3), (0, 3)])
    names = "generatrix", "directrix", "reference", "trajectory", "inner", "outer"
    wrong: Any = SimpleNamespace(**{name: getattr(s, name) for name in names} | {"inner": s.outer})
    assert [*tell_loops(s)] == [*tell_loops(wrong, "trajectory", "outer")] == []
    for asked in ((), ("inner",), ("outer", "inner")):
        assert [*tell_loops(wrong, *asked)] == ["the inner loop is not that of the definition"]


def test_a_fit_that_is_cut_short_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    slot = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
    pair = SweepPair([(0, 0), (1, 0), (1, 1), (0, 1)], slot)
    s = sweep(*pair)
    ((start, end),) = s.exact_fits
    middle = Point((start.x + end.x) / 2, (start.y + end.y) / 2)
    found = []
    for fit in ((start, end), (start, middle), (middle, end)):
        wrong: Any = SimpleNamespace(
            directrix=s.directrix,
            generatrix=s.generatrix,
            trajectory=s.trajectory,
            exact_fits=(fit,),
        )
        monkeypatch.setattr("exactsweep.paper.checks.section1.sweep", lambda *_, s=wrong: s)
        found.append([*fits_are_whole(pair)])
    x, y = middle
    assert found[0] == []
    assert [re.sub(r"at \(1, .*\)", "there", text) for text in found[1]] == [
        "there, along an exact fit, CONTACT"
    ]
    assert found[2] == [f"the exact fit from ({x}, {y}) hangs on nothing"]


def test_a_slide_that_is_cut_short_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    directrix = [(-1, 5), (2, 0), (10, 2), (11, 6), (7, 3), (5, 5), (0, 4)]
    pair = SweepPair([(5, 0), (17, 2), (9, 4)], directrix)
    s = sweep(*pair)
    names = "generatrix", "directrix", "reference", "inner"
    wrong: Any = SimpleNamespace(**{name: getattr(s, name) for name in names})
    monkeypatch.setattr("exactsweep.paper.checks.section4.sweep", lambda *_: wrong)
    slide, other = s.undercuts
    p, q = slide.positions
    middle = Point((p.x + q.x) / 2, (p.y + q.y) / 2)
    for ends, is_whole in (((p, q), True), ((p, middle), False), ((middle, q), False)):
        wrong.undercuts = slide._replace(positions=ends), other
        told = [text.partition(":")[0] for text in bottom_chains_have_two_forms(pair)]
        assert told == ([] if is_whole else ["not there"])
    # As if it were along another line, or along two edges.
    first, last = slide.bottom
    for bottom in ((first, slide.polygon.vertices[1]), (first, last, other.bottom[1])):
        wrong.undercuts = slide._replace(bottom=bottom), other
        told = [text.partition(":")[0] for text in bottom_chains_have_two_forms(pair)]
        assert told[:1] == ["not one edge"]


@pytest.mark.parametrize(("i", "k", "chain"), [(1, 2, "bottom"), (2, 1, "bottom"), (4, 5, "top")])
def test_a_contact_of_two_like_chains_is_told(
    i: int, k: int, chain: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    ring = [(0, 0), (2, -1), (4, -1), (6, 0), (4, 1), (2, 1)]
    pair = SweepPair(ring, ring)
    assert not [*like_chains_have_no_contact(pair)]
    s = sweep(*pair)
    for event in ("VV", "VE", "EV"):
        wrong = SimpleNamespace(
            generatrix=s.generatrix,
            directrix=s.directrix,
            contacts=[[(event, i, k)]],
            vertex_contacts=[],
        )
        monkeypatch.setattr("exactsweep.paper.checks.section2.sweep", lambda *_, s=wrong: s)
        monkeypatch.setattr("exactsweep.paper.checks.section2.contacts_are_right", lambda _: ())
        assert [*like_chains_have_no_contact(pair)] == [
            f"{event} of two {chain} chains: {i} of G, {k} of D"
        ]


def _plant(monkeypatch: pytest.MonkeyPatch, section: str, s: Any) -> None:
    monkeypatch.setattr(f"exactsweep.paper.checks.{section}.sweep", lambda *_: s)


SQUARES = SweepPair([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (3, 0), (3, 3), (0, 3)])


def test_a_path_that_is_the_directrix_moved_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    assert not [*path_is_not_the_directrix(SQUARES)]
    d = sweep(*SQUARES).directrix
    _plant(monkeypatch, "section1", SimpleNamespace(directrix=d, trajectory=d.translated((2, 7))))
    assert [*path_is_not_the_directrix(SQUARES)] == ["the trajectory is D moved"]


def test_a_sweep_that_starts_and_stops_elsewhere_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    assert not [*starts_and_stops_at_the_ends(SQUARES)]
    moved = SimpleNamespace(trajectory=sweep(*SQUARES).trajectory.translated((2, 7)))
    _plant(monkeypatch, "section2", moved)
    assert [*starts_and_stops_at_the_ends(SQUARES)] == [
        "it starts at (1, 6), with (1, 1) not on D's end",
        "it stops at (5, 6), with (0, 1) not on D's end",
    ]


def test_contacts_of_two_edges_at_a_time_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    assert not [*one_edge_at_a_time(SQUARES)]
    step = appendix.list_lower_steps(sweep(*SQUARES))[0]
    middle = Point((step.start.x + step.end.x) / 2, (step.start.y + step.end.y) / 2)
    contacts = Contact("EV", 0, 1), Contact("EV", 1, 2)
    monkeypatch.setattr(appendix, "touches_are_right", lambda *_: ())
    for ends, is_told in ((step.end, step.start), True), ((middle, middle), False):
        spans = (step.start, ends[0]), (ends[1], step.end)
        touches = tuple(Touch(c, *span) for c, span in zip(contacts, spans, strict=True))
        planted = step._replace(touches=touches)
        monkeypatch.setattr(appendix, "list_lower_steps", lambda _, step=planted: [step])
        told = {text.partition(": ")[2] for text in one_edge_at_a_time(SQUARES)}
        assert told == ({"EV of 0 and 1, EV of 1 and 2"} if is_told else set())


@pytest.mark.parametrize("name", ["trajectories", "outer_chains"])
def test_chains_at_a_wall_cross_once_without_meeting(name: str) -> None:
    meet, cross = (getattr(appendix, f"sub_{name}_{how}_once") for how in ("meet", "cross"))
    assert [*filter(None, meet(appendix.AT_A_WALL))]
    assert not [*filter(None, cross(appendix.AT_A_WALL))]


@pytest.mark.parametrize(("x", "is_told"), [(1, True), (0, True), (2, False)])
def test_a_chain_that_stands_still_or_turns_back_is_told(x: int, is_told: bool) -> None:
    told = [*is_monotone("T", [(0, 0), (1, 1), (x, 5), (3, 3)])]
    assert told == ["T is not strictly X-monotone at x = 1"] * is_told


def test_a_contact_that_moves_left_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    assert not [*contact_moves_right(SQUARES)]
    places = count(9, -1)
    monkeypatch.setattr(
        appendix, "places_of_contact", lambda *_: [x := next(places), x + Fraction(1, 2)]
    )
    first, *_ = contact_moves_right(SQUARES)
    assert re.sub(r"at \(.*?\)", "there", first) == (
        "there the contact is from x = 8 to 17/2, after 9 to 19/2"
    )


def test_a_counterexample_is_made_smaller() -> None:
    def has_corner(pair: SweepPair) -> list[str]:
        return ["a corner"] if (0, 0) in pair.directrix else []

    large = [(0, 0), (4, 0), (6, 2), (6, 6), (4, 8), (0, 8)]
    told = break_law(has_corner, [SweepPair([(x, y) for x, y in large], large)])
    text, g, d = re.split("; G = |, D = ", told)
    assert (text, g.count("("), d.count("(")) == ("a corner", 3, 3)


@pytest.mark.parametrize(("last", "is_told"), [(0, False), (-1, True), (1, False)])
def test_a_chain_that_falls_from_above_to_below_is_told(last: int, is_told: bool) -> None:
    first: list[Vertex] = [(0, 0), (1, 1), (2, 0), (4, last)]
    assert any(appendix.crosses_once(first, [(0, 0), (4, 0)])) == is_told


@pytest.mark.parametrize(("shift", "is_told"), [(0, True), (1, True), (2, False)])
def test_holes_that_overlap_are_told(
    shift: int, is_told: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    outer, hole = (Polygon([(0, 0), (s, 0), (s, s), (0, s)]) for s in (9, 2))
    found = SimpleNamespace(exterior=outer, holes=(hole, hole.translated((shift, 0))))
    monkeypatch.setattr(beyond, "no_fit_polygon", lambda *_: found)
    monkeypatch.setattr(beyond, "no_fit_is_the_definition", lambda _: ())
    assert [*beyond.loops_are_simple(SQUARES)] == ["two holes overlap"] * is_told
