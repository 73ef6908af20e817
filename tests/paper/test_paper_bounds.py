"""Each check passes exactly at its bound and fails one step beyond it."""

import tracemalloc
from collections.abc import Callable, Iterable
from itertools import count
from math import log2
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

from exactsweep import Polygon
from exactsweep.corpus.generator.growing import edges_over_needles, undercuts_under_ceilings
from exactsweep.numbers.number import Vertex
from exactsweep.paper import functions
from exactsweep.paper.checks import (
    appendix,
    beyond,
    section1,
    section2,
    section3,
    section4,
    section5_time,
    slips,
    undercuts,
)
from exactsweep.paper.checks.beyond import find_contacts
from exactsweep.paper.claim import Counterexample, Effort, Evidence, Observation, find_first_failure
from exactsweep.paper.costs import COSTS, Cost, measure_costs
from exactsweep.paper.counting import CountedList, peak, seconds, watch_operations
from exactsweep.paper.functions import look_up_bottom
from exactsweep.paper.growth import Growth, Size
from exactsweep.paper.kernel import list_sub_trajectories
from exactsweep.paper.pairs import SweepPair, draw_pairs

TRIANGLE = [(0, 0), (1, 0), (0, 1)]
# G_t and G_b have two edges each, D_b has two teeth of two edges, which are its convex parts.
TEETH = SweepPair(
    [(0, 0), (2, -1), (4, 0), (2, 3)], [(0, 2), (1, 0), (2, 2), (3, 0), (4, 2), (2, 9)]
)


def bow(edges: int) -> list[Vertex]:
    """A convex chain of n edges."""
    return [(x, x * x) for x in range(edges + 1)]


def least_holes(m: int, n: int) -> int:
    return int(((m // 6 - 1) * (n // 6 - 1) - 1) ** 2)


@pytest.mark.parametrize(
    ("module", "check", "bound", "wrong"),
    [
        (beyond, "count_contact_segments", lambda m, n: 2 * m * n, [1]),
        (beyond, "count_holes", least_holes, [-1]),
        (undercuts, "find_long_undercut", lambda m, n: edges_over_needles(m, n) + 1, [-1]),
        (undercuts, "count_undercuts", undercuts_under_ceilings, [-1, 1]),
    ],
)
def test_planted_counts_beyond_a_bound_are_failures(
    module: ModuleType,
    check: str,
    bound: Callable[[int, int], int],
    wrong: list[int],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def found(more: int) -> str:
        sizes = ((19, 20), (37, 38), (73, 74))
        points = tuple(Size(m, n, bound(m, n) + more, 2 * m * n) for m, n in sizes)
        planted = [Growth("counts", "planted", "2mn", points)]
        monkeypatch.setattr(module, "count_all", lambda row, effort: planted)
        parts: Iterable[Observation] = getattr(module, check)(Effort(quick=True))
        return find_first_failure(part for part in parts if isinstance(part, str))

    assert [bool(found(more)) for more in (-1, 0, 1)] == [more in wrong for more in (-1, 0, 1)]


@pytest.mark.parametrize(
    ("procedure", "most"), [("Trajectory_CM", 8), ("SweepO_CM", 12), ("SweepI_CM", 6)]
)
def test_chains_of_a_cm_sweep_may_attain_the_stated_sizes(
    procedure: str, most: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    def found(size: int) -> list[str]:
        runs = {name: lambda chains: bow(1) for name in ("Trajectory_CM", "SweepO_CM", "SweepI_CM")}
        runs[procedure] = lambda chains: bow(size)
        loops = {"trajectory": "Trajectory_CM", "outer": "SweepO_CM", "inner": "SweepI_CM"}
        monkeypatch.setattr(section4, "RUNS", runs)
        monkeypatch.setattr(section4, "look_up_bottom", lambda pair, loop: runs[loops[loop]](None))
        return list(section4.sizes_are_bounded(TEETH))

    assert found(most) == []
    assert found(most + 1) == [
        f"{procedure}: {most + 1} edges, {most + 1} by the definition, bound {most}"
    ]


@pytest.mark.parametrize(("which", "most"), [(0, 8), (1, 12)])
def test_parts_may_attain_the_stated_sizes(
    which: int, most: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    def found(edges: int) -> list[str]:
        parts = [[bow(1), bow(1)], [bow(1), bow(1)]]
        parts[which] = [bow(edges - 3), bow(3)]
        monkeypatch.setattr(section4, "list_sub_chains", lambda pair: parts)
        monkeypatch.setattr(section4, "sub_trajectories_suffice", lambda pair: ())
        return [text for text in section4.parts_are_bounded(TEETH) if text]

    assert found(most) == []
    assert len(found(most + 1)) == 1


def test_undercuts_may_attain_the_stated_number_and_length(monkeypatch: pytest.MonkeyPatch) -> None:
    def found(*edges: int) -> list[str]:
        planted = [SimpleNamespace(bottom=bow(size)) for size in edges]
        monkeypatch.setattr(section4, "lower_undercuts", lambda s: planted)
        return list(section4.few_undercuts(TEETH))

    assert found(2) == []
    assert found(3) == ["an undercut with 3 edges"]
    assert found(2, 2) == ["2 undercuts for 2 convex parts"]


@pytest.mark.parametrize(("loop", "most"), [("trajectory", 7), ("inner", 4), ("outer", 10)])
def test_loops_of_convex_polygons_may_attain_the_stated_sizes(
    loop: str, most: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]

    def found(size: int) -> list[str]:
        loops = dict.fromkeys(("trajectory", "inner", "outer"), Polygon(TRIANGLE))
        loops[loop] = Polygon(bow(size - 1))
        monkeypatch.setattr(section3, "sweep", lambda *pair: SimpleNamespace(**loops))
        monkeypatch.setattr(section3, "compare_loops", lambda s: [])
        return list(section3.loops_are_small(SweepPair(TRIANGLE, square)))

    assert found(most) == []
    assert f"more than {most} edges" in found(most + 1)[0]


def test_there_may_be_2mn_contact_segments(monkeypatch: pytest.MonkeyPatch) -> None:
    def found(number: int) -> list[str]:
        def plant(*shapes: Any) -> tuple[list[Any], Any]:
            known, rest = find_contacts(*shapes)
            return [*known * 9][:number], rest

        monkeypatch.setattr(beyond, "find_contacts", plant)
        return [text for text in beyond.boundary_is_contact(SweepPair(TRIANGLE, TRIANGLE)) if text]

    assert found(18) == []
    assert found(19) == ["19 contact segments, more than 2mn"]


def test_chains_may_cross_only_once() -> None:
    level: list[Vertex] = [(0, 0), (8, 0)]
    down: list[Vertex] = [(0, 0), (4, 0), (8, -4)]
    across: list[Vertex] = [(0, 2), (8, -2)]
    assert list(appendix.crosses_once(level, across)) == []
    assert "above the next one" in next(appendix.crosses_once(across, level))
    assert list(appendix.crosses_once(down, level)) == []
    assert list(appendix.crosses_once(level, down)) == []
    assert appendix.describe_meeting(across, level) == ("", True)
    assert appendix.describe_meeting(down, level) == ("", True)
    assert appendix.describe_meeting([(0, 1), (8, 1)], level) == ("", False)
    assert appendix.describe_meeting([(0, 0), (4, 2), (8, 0)], level)[0] == (
        "the chains meet at 0 and 8, and separate in between"
    )
    assert appendix.describe_meeting(down, down)[0] == "the chains share a bend between 0 and 8"


def test_a_partial_trajectory_is_that_of_all_parts_but_the_last() -> None:
    # The trajectory follows the tip at (1, 0) from -2 to 1, the next one to 3, the last one to 6.
    teeth = [(0, 2), (1, 0), (2, 2), (3, 0), (4, 2), (5, 0), (6, 2), (3, 9)]
    pair = SweepPair([(0, 0), (1, -1), (2, 0), (1, 1)], teeth)
    assert list(slips.partial_meets_whole(pair)) == [
        "T_(i-1) and T(G_t, D_b): the chains share a bend between -2 and 3"
    ]


def test_output_sizes_are_compared_with_mn(monkeypatch: pytest.MonkeyPatch) -> None:
    def plant(row: str, effort: Effort) -> list[Growth]:
        sizes = [(4, 6), (8, 12), (16, 24)]
        points = tuple(Size(m, n, 10 * m, m * n) for m, n in sizes)
        gaps, again, written = points, points[:2], points
        return [Growth("counts", "planted", "mn", each) for each in (gaps, again, written)]

    monkeypatch.setattr(section5_time, "count_all", plant)
    evidence, *_, found = section5_time.count_gaps(Effort(quick=True))
    assert isinstance(evidence, Evidence)
    assert "80 instead of 80 at m = n = 8." in evidence.tried
    assert isinstance(found, Counterexample)
    assert found.text == "the output has 160 vertices for m = 16 and n = 24; mn is 384"


def test_counts_are_compared_with_their_bounds() -> None:
    for pair in draw_pairs(Effort(), "CM", 5):
        assert slips.calls(pair)[1] == len(look_up_bottom(pair, "trajectory")) - 1
    # Each of the two parts of D_b is merged with all of G.
    domed = [(x, -x * x) for x in range(20, -21, -1)]
    assert slips.calls(SweepPair(domed, TEETH.directrix))[0] > 2 * 40
    for pair in draw_pairs(Effort(), "MM", 5):
        chains = list_sub_trajectories(pair.chains)
        size = sum(len(chain.pieces) for chain in chains)
        assert section5_time.merge_by_halves(pair)[1] == size * max(1, log2(len(chains)))
    # Both parts of the trajectory have four edges, of which the last of the first is cut off.
    handed_in, kept = 8, len(look_up_bottom(TEETH, "trajectory")) - 1
    assert appendix.envelope(TEETH)[1] == handed_in + handed_in - kept
    assert kept < handed_in


@pytest.mark.parametrize(("place", "kind"), [((0, 1), "tops"), ((0, 0), "bottoms"), ((0, 3), "")])
def test_like_chains_that_touch_are_reported_at_the_top_and_at_the_bottom(
    place: tuple[int, int], kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A bar of height 1 lies along the top, or the bottom, of one of height 2."""
    low, high = ([(0, 0), (4, 0), (5, y), (4, y), (0, y), (-1, y)] for y in (1, 2))
    planted = SimpleNamespace(trajectory=Polygon([place, (9, 9), (-9, 9)]))
    monkeypatch.setattr(functions, "look_up", lambda pair: planted)
    reported = [*section2.like_chains_stay_apart(SweepPair(low, high))]
    assert any(text.startswith(f"at {place} two top or") for text in reported) == bool(kind)


@pytest.mark.parametrize(("is_swept", "words"), [(False, "is between"), (True, "is not between")])
def test_points_between_the_loops_are_reported(
    is_swept: bool, words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(section1, "swept_by_contact", lambda s, p: is_swept)
    square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    reported = [*section1.area_is_covered(SweepPair(square, square))]
    assert reported
    assert all(f") {words} the loops" in text for text in reported)


@pytest.mark.parametrize(("each", "runs"), [(1, 3), (0.05, 4), (0.001, 50)])
def test_seconds_are_the_minimum_of_at_least_three_runs(
    each: float, runs: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    clock = count()
    monkeypatch.setattr("exactsweep.paper.counting.process_time", lambda: each * next(clock))
    asked: list[object] = []
    assert seconds(asked.append, None) == pytest.approx(each)  # type: ignore[arg-type]
    assert len(asked) == runs


@pytest.mark.parametrize(("slow", "outgrows"), [([4, 8, 16], False), ([4, 12, 36], True)])
def test_a_count_outgrows_another_by_half_with_each_doubling(
    slow: list[int], outgrows: bool
) -> None:
    counts = slow, [2, 4, 8]
    growths = [Growth("", "", "", tuple(Size(2, 2, c, 1) for c in each)) for each in counts]
    assert section5_time._outgrows(*growths) == outgrows


def test_a_quick_run_states_what_it_skips() -> None:
    for quick in (False, True):
        first = next(iter(measure_costs("Corollary 3.3", Effort(quick=quick))))
        assert isinstance(first, Evidence)
        assert ("skips seconds" in first.tried) == quick


def test_slots_of_a_list_are_counted() -> None:
    with watch_operations() as tally:
        counted = CountedList("abcde")
        assert (counted[0], counted[-1], counted[1:4]) == ("a", "e", ["b", "c", "d"])
    assert tally.slots == 5


@pytest.mark.parametrize("quick", [False, True])
def test_a_quick_run_skips_seconds(quick: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Cost, "grow", lambda self, unit, *_: unit)
    monkeypatch.setattr(Cost, "time", lambda self: "seconds")
    measured: list[Any] = [*COSTS[0].measure(Effort(quick=quick))]
    assert measured == ["operations", "bytes", *["seconds"] * (not quick)]


def test_peak_memory_is_that_of_the_run() -> None:
    chains = TEETH.chains
    kept = peak(lambda _: len([0] * 10**5), chains)
    assert 8 * 10**5 <= kept < 9 * 10**5
    assert not tracemalloc.is_tracing()
