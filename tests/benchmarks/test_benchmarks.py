"""Families, counted numbers and bounds of the benchmarks, tested by counts, which never vary."""

import sys
from dataclasses import replace
from fractions import Fraction

import pytest
from click.testing import CliRunner

from benchmarks import scaling
from benchmarks.__main__ import main
from benchmarks.batches import BatchCost, tabulate_model
from benchmarks.families import FAMILIES
from benchmarks.floors import comb
from benchmarks.growth import CASES
from benchmarks.layouts import judge_ours, make_shapely, place_all, tile, write_shapes
from benchmarks.outlines import list_outlines
from benchmarks.peers import ours
from benchmarks.spent import COUNTED, TOO_NEW, count
from exactsweep import Point, Polygon, sweep
from exactsweep.corpus.generator.growing import bumps
from exactsweep.layout import judge_layout
from exactsweep.paper.claim import Effort
from exactsweep.paper.costs import COSTS, DOUBLINGS, Cost, tabulate
from exactsweep.paper.counting import Counted, make_counted, watch_operations
from exactsweep.paper.growth import Growth, Size
from exactsweep.paper.kernel import sweep_mm, trajectory_mm
from exactsweep.paper.pairs import SweepPair


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize(("m", "n"), [(8, 8), (16, 64), (64, 16), (100, 20)])
def test_families_have_the_stated_sizes(family: str, m: int, n: int) -> None:
    generatrix, directrix = FAMILIES[family](m, n, 0)
    assert (len(Polygon(directrix)), len(Polygon(generatrix))) == (m, n)


@pytest.mark.parametrize("family", FAMILIES)
def test_families_are_reproducible_and_seeded(family: str) -> None:
    make = FAMILIES[family]
    assert make(32, 16, 1) == make(32, 16, 1)
    assert family == "figure10" or make(32, 16, 1) != make(32, 16, 2)


def test_a_family_is_the_same_on_every_machine() -> None:
    generatrix, directrix = FAMILIES["cm"](6, 4, 0)
    assert generatrix == [(0, 0), (90, -59), (128, 12), (38, 71)]
    assert directrix == [(0, 0), (25, -60), (50, -79), (75, 0), (50, 81), (25, 61)]


@pytest.mark.parametrize("sizes", [(2, 4, 6), (4, 4, 6), (4, 6, 8), (6, 8, 10)])
def test_figure_10_has_the_stated_number_of_outer_edges(sizes: tuple[int, int, int]) -> None:
    chains = SweepPair(*bumps(*sizes)).chains
    m_b, n_t, n_b = sizes
    lengths = len(chains.directrix) - 1, len(chains.top) - 1, len(chains.bottom) - 1
    assert lengths == sizes
    _, outer = sweep_mm(*chains)
    assert len(outer) - 1 == m_b * n_t * n_b // 4 + 4
    if sizes == (2, 4, 6):
        assert len(outer) - 1 == 16


def test_figure_10_of_ten_and_four_vertices_is_the_paper_s() -> None:
    assert FAMILIES["figure10"](4, 10, 0) == bumps(2, 4, 6)


@pytest.mark.long
def test_outlines_come_from_the_corpus() -> None:
    outlines = [Polygon(ring) for _, pair in list_outlines(["parts"]) for ring in pair]
    assert {*map(len, outlines)} >= {7, 38}
    assert {len(outline) for outline in outlines} <= {*range(7, 39)}


def test_each_state_of_polygons_gives_the_same_trajectory() -> None:
    pair = FAMILIES["mm"](8, 8, 0)
    right = [sweep(*pair).trajectory.vertices]
    for operation in (ours.trajectory, ours.first, ours.text, ours.no_fit):
        run = operation(*pair)
        assert run() == run() == right


def test_results_of_counted_numbers_are_counted() -> None:
    with watch_operations() as tally:
        a, b = Counted(7), Counted(3)
        results = [a + 1, 1 - a, a * 2, 2 * a, a // 2, 9 // b, -a, abs(a), a % b]
        ratio = Fraction(a, b)
        halves = [ratio * 2, 1 - ratio, ratio / 5]
    assert all(type(result) is Counted for result in results)
    assert all(type(half.numerator) is Counted for half in halves)
    assert results == [8, -6, 14, 14, 3, 3, -7, 7, 1]
    assert ratio == Fraction(7, 3)
    assert tally.multiplications > 5


def test_comparisons_are_counted_once() -> None:
    (x, y), (u, v) = make_counted([(1, 2), (1, 3)])
    with watch_operations() as tally:
        assert x < y
        assert x == u
        assert not v <= y
    assert (tally.multiplications, tally.comparisons) == (0, 3)


@pytest.mark.parametrize("family", FAMILIES)
def test_counting_changes_no_result(family: str) -> None:
    generatrix, directrix = FAMILIES[family](20, 20, 0)
    plain, chains = (
        SweepPair(g, d).chains
        for g, d in ((generatrix, directrix), (make_counted(generatrix), make_counted(directrix)))
    )
    trajectories = [trajectory_mm(c.top, c.directrix) for c in (plain, chains)]
    assert list(trajectories[0]) == list(trajectories[1])


def test_counts_are_the_same_on_every_run() -> None:
    for cost in COSTS[9:13]:
        first, second = (next(cost.measure(Effort(quick=True))) for _ in range(2))
        assert first.points == second.points


def test_every_bound_is_tested_for_joint_and_single_growth() -> None:
    for row in (
        "Corollary 3.4",
        "Corollary 4.5",
        "Corollary 4.6",
        "Corollary 5.7",
        "Corollary 5.8",
    ):
        assert {cost.varied for cost in COSTS if cost.row == row} == {"mn", "m", "n"}
    assert DOUBLINGS >= 5


@pytest.mark.long
@pytest.mark.parametrize(
    "cost", COSTS, ids=lambda c: f"{c.procedure} {c.family.__name__} {c.varied}"
)
def test_operations_and_bytes_stay_within_the_claimed_bound(cost: Cost) -> None:
    assert [growth.failure for growth in cost.measure(Effort(quick=True))] == ["", ""]


def test_the_summary_states_a_verdict() -> None:
    points = tuple(Size(m, m, float(m * m), float(m)) for m in (8, 16, 32))
    good = Growth("operations of f", "ints", "m²", tuple(replace(p, bound=p.count) for p in points))
    beyond = Growth("bytes of f", "ints", "m", points)
    assert tabulate([good]).rows[0][-4:] == ["2.00", "-", "-", "within"]
    assert tabulate([good, beyond]).rows[0][-4:] == ["2.00", "-", "2.00", "beyond"]


@pytest.mark.long
def test_the_exit_code_of_scaling_reports_exceeded_bounds(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    cost = COSTS[0]
    monkeypatch.setattr(scaling, "COSTS", (cost,))
    result = CliRunner().invoke(main, ["scaling", "--quick"])
    assert result.exit_code == 0
    assert "All costs are within the bounds." in result.output
    slow = replace(cost, bound=("1", lambda m, n: 1.0))
    monkeypatch.setattr(scaling, "COSTS", (slow,))
    result = CliRunner().invoke(main, ["scaling", "--quick"])
    assert result.exit_code == 1
    assert "operations of Trajectory_CC on cc" in result.output


traced = pytest.mark.skipif(sys.version_info >= TOO_NEW, reason="needs CPython 3.11")


@traced
def test_instruction_counts_are_deterministic() -> None:
    pair = [Polygon(ring) for ring in FAMILIES["stair"](8, 8, 0)]
    size = len(sweep(*pair).trajectory)
    first, second = (count(lambda: sweep(*pair).trajectory.vertices) for _ in "ab")
    assert first == second
    assert all(first[name] for name in COUNTED)
    assert 2 * size <= first["Fractions"] <= 3 * size


@traced
def test_instructions_are_counted_by_their_work() -> None:
    x = 3
    found = count(lambda: ([x * x, x // 2], x < 6))
    assert [found[name] for name in COUNTED[1:]] == [1, 2, 0, 2, 1]


def test_a_comb_has_four_vertices_per_tooth_and_two_more() -> None:
    assert len(Polygon(comb(3))) == 14
    assert len(Polygon(comb(250))) == 1002


@pytest.mark.parametrize("case", CASES)
def test_hard_shapes_of_any_size_have_answers(case: str) -> None:
    for size in (8, 12):
        CASES[case].ask(size)()


def test_the_model_predicts_a_large_batch() -> None:
    """By hand: 100 additional chunks cost the client a second, so one costs 10 ms."""
    costs = [
        BatchCost(1, 1, 0.2, 2.0, 100),
        BatchCost(1001, 101, 1.2, 4.0, 300_300),
        BatchCost(9001, 901, 7.0, 22.0, 2_800_000),
    ]
    columns = tabulate_model(costs, alone=0.0015).columns
    first, last = ([[*column.cells][row] for column in columns] for row in (0, 1))
    assert first == ["9,001", "10", "9.2 s", "20.0 s", "2,700,300"]
    assert last == ["1,000,000,000", "512", "5.4 h", "556 h", "300,000,000,000"]


@pytest.mark.parametrize("gap", [True, False])
@pytest.mark.parametrize(("number", "vertices"), [(6, 8), (9, 20)])
def test_tilings_are_valid_layouts(number: int, vertices: int, gap: bool) -> None:
    layout = tile(number, vertices, gap=gap)
    judgement = judge_layout(layout)
    assert judgement.valid
    assert bool(judgement.contacts) is not gap
    assert {len(part.exterior) for part in layout.parts} == {vertices}
    assert len(layout.placements) == number
    assert tile(number, vertices, gap=gap) == layout


def test_all_programs_judge_the_same_layouts() -> None:
    layout = tile(4, 8, gap=True)
    first, second, *others = layout.placements
    moved = replace(second, move=Point(first.move.x + 10**8, first.move.y))
    away = replace(others[1], move=Point(others[1].move.x + 10**9, others[1].move.y))
    wrong = replace(layout, placements=(first, moved, others[0], away))
    shapes = place_all(wrong)
    assert (0, 1) in judge_ours(wrong)
    assert (3, 4) in judge_ours(wrong)
    assert judge_ours(wrong) == make_shapely(shapes)()
    lines = write_shapes(shapes).splitlines()
    assert lines[0] == "5"
    # The number of shapes; per shape, its number of rings; per ring, its number of vertices, then
    # the vertices.
    assert len(lines) == 1 + 4 * (2 + 8) + 1 + 2 * (1 + 4)
