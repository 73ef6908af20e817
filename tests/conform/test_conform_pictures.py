"""Pictures of failures show all polygons, however small, large or thin."""

import re
from fractions import Fraction
from typing import Any

import pytest

from exactsweep.conform import Verdict
from exactsweep.conform.report.html import SIDE, Panel, draw_panels
from exactsweep.conform.run.outcome import Outcome, judge_case
from exactsweep.conform.run.peer import CallablePeer
from exactsweep.conform.run.protocol import Hello
from exactsweep.conform.run.run import Run
from exactsweep.corpus import Case
from exactsweep.text.report import take_root

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


def outcome_of(case: Case, trajectory: Any) -> Outcome:
    return judge_case(CallablePeer(lambda d, g, r: {"trajectory": trajectory}, Hello("mine")), case)


def places(panel: Panel, name: str) -> list[tuple[float, float]]:
    path = panel.paths[name]
    return [(float(x), float(y)) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", path)]


def in_sight(panel: Panel, name: str) -> bool:
    return all(0 <= c <= SIDE for place in places(panel, name) for c in place)


@pytest.mark.parametrize("scale", [1, Fraction(1, 10**400), 10**400])
def test_a_picture_does_not_depend_on_the_scale(scale: Fraction) -> None:
    ring = [(x * scale, y * scale) for x, y in SQUARE]
    case = Case.of("a", "", ring, ring)
    theirs = [(x * scale, y * scale) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 2))]
    (panel,) = draw_panels(outcome_of(case, theirs))
    assert all(in_sight(panel, name) for name in ("directrix", "generatrix", "exact", "theirs"))
    xs, ys = zip(*places(panel, "exact"), strict=True)
    assert max(xs) - min(xs) == pytest.approx(max(ys) - min(ys), abs=0.05)
    assert panel.witness is not None


def test_a_small_error_is_enlarged() -> None:
    case = Case.of("a", "", SQUARE, SQUARE)
    low = -1 - Fraction(1, 10**20)
    whole, enlarged = draw_panels(outcome_of(case, [(-1, low), (1, -1), (1, 1), (-1, 1)]))
    assert in_sight(whole, "theirs")
    assert re.fullmatch(r"magnified 2\.9\d*e\+19 times at the witness", enlarged.caption)
    assert not in_sight(enlarged, "exact")
    assert enlarged.witness == (SIDE / 2, SIDE / 2)


@pytest.mark.parametrize("error", ["1/" + str(2**1074), "1e-400", "1e-2500"])
def test_an_error_beyond_floats_is_enlarged_too(error: str) -> None:
    case = Case.of("a", "", SQUARE, SQUARE)
    low = -1 - Fraction(error)
    _, enlarged = draw_panels(outcome_of(case, [(-1, low), (1, -1), (1, 1), (-1, 1)]))
    assert "times at the witness" in enlarged.caption


def test_a_thin_ring_is_not_a_line() -> None:
    needle = [(0, 0), (10**9, 0), (10**9, 1)]
    case = Case.of("a", "", needle, needle)
    (panel, *_) = draw_panels(outcome_of(case, [(0, 0), (1, 0), (0, 1)]))
    assert panel.caption == "trajectory; not to scale: the axes have different units"
    _, ys = zip(*places(panel, "exact"), strict=True)
    assert max(ys) - min(ys) > SIDE / 2


def test_a_distant_answer_does_not_hide_the_rest() -> None:
    case = Case.of("a", "", SQUARE, SQUARE)
    whole, near = draw_panels(outcome_of(case, [(-1, -1), (10**9, -1), (1, 1), (-1, 1)]))
    assert in_sight(near, "exact")
    assert near.caption.endswith("times at D")
    xs, _ = zip(*places(near, "exact"), strict=True)
    assert max(xs) - min(xs) > SIDE / 2
    assert whole.witness is not None
    assert 0 < whole.witness[0] < SIDE


@pytest.mark.parametrize(("far", "panels"), [(39, 1), ("39.001", 2)])
def test_points_twenty_times_as_far_are_visible(far: Any, panels: int) -> None:
    case = Case.of("a", "", SQUARE, SQUARE)
    assert len(draw_panels(outcome_of(case, [(-1, -1), (far, -1), (1, 1), (-1, 1)]))) == panels


@pytest.mark.parametrize(
    "theirs", ["text", [], [[]], [1, 2], [("x", 0), (0, float("nan"))], {}, None, [[None]], [[[]]]]
)
def test_unreadable_points_are_skipped(theirs: Any) -> None:
    outcome = outcome_of(Case.of("a", "", SQUARE, SQUARE), theirs)
    assert outcome.verdict is Verdict.MALFORMED
    (panel,) = draw_panels(outcome)
    assert {*panel.paths} == {"directrix", "generatrix", "exact"}


def test_a_lost_fit_is_shown_as_a_segment() -> None:
    slot = [(0, 0), (3, 0), (3, 5), (2, 5), (2, 1), (1, 1), (1, 3), (0, 3)]
    case = Case.of("a", "", slot, SQUARE)
    (panel,) = draw_panels(outcome_of(case, case.trajectory.vertices))
    assert panel.caption == "exact fits"
    assert len(places(panel, "exact")) == 2
    assert len(places(panel, "faint")) == len(case.trajectory)


@pytest.mark.parametrize("number", [0, 2, Fraction(1, 10**500), 10**500, Fraction(7, 3)])
def test_square_roots_are_approximated(number: Fraction) -> None:
    square = Fraction(number)
    assert abs(take_root(square) ** 2 - square) <= square / 2**50


def test_a_smaller_case_with_another_fault_is_dropped() -> None:
    run = Run(Hello("mine"))
    case: dict[str, Any] = {"directrix": [], "generatrix": []}
    run.add(Outcome("a", "CC", (), Verdict.CRASH, "why", "crash: why", case=case))
    run.add_shrunk("a", Outcome("a-shrunk", "CC", (), Verdict.CRASH, "what", "crash: what"))
    assert run.shrunk == {}
    run.add_shrunk("a", Outcome("a-shrunk", "CC", (), Verdict.CRASH, "why", "crash: why"))
    assert set(run.shrunk) == {"a"}
