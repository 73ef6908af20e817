"""The ledger's own computations: contacts, envelopes of segments, families."""

import re
from fractions import Fraction
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Point, sweep
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
from exactsweep.geometry.segment import make_segment
from exactsweep.numbers.number import Vertex
from exactsweep.paper.checks import appendix
from exactsweep.paper.checks.appendix import describe_meeting
from exactsweep.paper.checks.beyond import covers
from exactsweep.paper.checks.section1 import (
    draw_slots,
)
from exactsweep.paper.checks.section4 import (
    bottom_chains_have_two_forms,
    is_monotone,
    labels_name_the_extremes,
)
from exactsweep.paper.checks.section5 import shortcuts_change_nothing
from exactsweep.paper.checks.section5_sizes import (
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
)
from exactsweep.paper.kernel import sweep_mm, to_graph
from exactsweep.paper.laws import find_violation
from exactsweep.paper.pairs import SweepPair, draw_pair
from exactsweep.procedures.graph import merge

# Davenport-Schinzel sequences of order 3 of s symbols have at most this number of members.
LONGEST = {1: 1, 2: 4, 3: 8, 4: 12, 5: 17, 6: 22}


@pytest.mark.parametrize("segments", BEST)
def test_segments_come_close_to_the_maximum_number_of_pieces(
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


def test_windows_superimpose_segments() -> None:
    pair = build_windows(BEST[2])
    assert len(sweep(*pair).directrix) == 27
    assert sweep(*pair).kind == "MM"


def test_windows_of_windows_superimpose_segments_twice() -> None:
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
    # Between the outer needles, the trajectory is the same as without ceilings.
    start, end = -max(x for x, _ in pair[0]), max(x for x, y in pair[1] if y == 0)
    low, high = (
        clip(take_bottom(t.vertices), Fraction(start), Fraction(end))
        for t in (s.trajectory, sweep(*needles(m, n)).trajectory)
    )
    assert low == high


@examples(60)
@given(st.integers(0, 10**6), st.sampled_from(["CC", "CM", "MM"]))
def test_pruning_and_sweeping_only_undercuts_change_nothing(seed: int, kind: str) -> None:
    assert not any(shortcuts_change_nothing(draw_pair(Prng(str(seed)), kind)))


def test_an_undercut_may_end_where_an_edge_is_touched_in_passing() -> None:
    directrix = [(3, 12), (10, 52), (9, 49), (8, 48), (5, 43), (3, 48)]
    assert not any(labels_name_the_extremes(SweepPair([(0, 0), (6, 0), (7, 1)], directrix)))


def test_a_slide_along_an_undercut_may_be_stopped_by_another_contact() -> None:
    directrix = [(-1, 5), (2, 0), (10, 2), (11, 6), (7, 3), (5, 5), (0, 4)]
    assert not any(bottom_chains_have_two_forms(SweepPair([(5, 0), (17, 2), (9, 4)], directrix)))


def test_chains_are_evaluated_and_clipped() -> None:
    chain = [(0, 0), (2, 4), (2, 6), (4, 6)]
    assert evaluate(chain, Fraction(1, 2)) == 1
    assert clip(chain, Fraction(1), Fraction(3)) == [(1, 2), (2, 4), (2, 6), (3, 6)]
    assert list(sample_between([(0, 0), (8, 0)])) == [3]
    assert find_common_points([(0, 0), (2, 2), (4, 0)], [(1, 0), (2, 2), (6, 1)]) == [2]
    assert find_common_points([(0, 0), (2, 2)], [(3, 0), (4, 2)]) == []
    assert [reaches([(0, 0), (2, 2)], Fraction(x)) for x in range(3)] == [False, True, False]
    with pytest.raises(ValueError, match="5 is outside the range"):
        evaluate(chain, Fraction(5))


@pytest.mark.parametrize("swapped", [False, True])
def test_chains_of_different_lengths_are_merged_to_their_ends(swapped: bool) -> None:
    long: list[Vertex] = [(0, 0), (4, 0)]
    short: list[Vertex] = [(1, -1), (2, -1)]
    graphs = [to_graph(short), to_graph(long)]
    merged = list(merge(*(graphs if swapped else graphs[::-1])))
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
        ([(0, 1), (2, -1), (4, 1)], "the chains meet at 1 and 3, and separate in between", True),
    ],
)
def test_chains_meet_in_one_point_or_segment(other: list[Vertex], fault: str, met: bool) -> None:
    assert describe_meeting([(0, 0), (4, 0)], other) == (fault, met)


def test_chains_that_share_a_bend_meet_in_more_than_a_segment() -> None:
    bent: list[Vertex] = [(0, 0), (2, 2), (4, 0)]
    assert describe_meeting(bent, bent) == ("the chains share a bend between 0 and 4", True)


@pytest.mark.parametrize("name", ["trajectories", "outer_chains"])
def test_chains_at_a_wall_cross_once_without_meeting(name: str) -> None:
    meet, cross = (getattr(appendix, f"sub_{name}_{how}_once") for how in ("meet", "cross"))
    assert [*filter(None, meet(appendix.AT_A_WALL))]
    assert not [*filter(None, cross(appendix.AT_A_WALL))]


@pytest.mark.parametrize(("x", "is_reported"), [(1, True), (0, True), (2, False)])
def test_a_chain_that_stops_or_reverses_is_reported(x: int, is_reported: bool) -> None:
    reported = [*is_monotone("T", [(0, 0), (1, 1), (x, 5), (3, 3)])]
    assert reported == ["T is not strictly X-monotone at x = 1"] * is_reported


def test_a_counterexample_is_shrunk() -> None:
    def has_corner(pair: SweepPair) -> list[str]:
        return ["a corner"] if (0, 0) in pair.directrix else []

    large = [(0, 0), (4, 0), (6, 2), (6, 6), (4, 8), (0, 8)]
    reported = find_violation(has_corner, [SweepPair([(x, y) for x, y in large], large)])
    text, g, d = re.split("; G = |, D = ", reported)
    assert (text, g.count("("), d.count("(")) == ("a corner", 3, 3)


@pytest.mark.parametrize(("last", "is_reported"), [(0, False), (-1, True), (1, False)])
def test_a_chain_that_falls_from_above_to_below_is_reported(last: int, is_reported: bool) -> None:
    first: list[Vertex] = [(0, 0), (1, 1), (2, 0), (4, last)]
    assert any(appendix.crosses_once(first, [(0, 0), (4, 0)])) == is_reported
