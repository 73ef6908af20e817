"""The campaign of small pairs: it finds nothing, and would find faults if there were any."""

import json
from pathlib import Path
from random import Random
from types import SimpleNamespace
from typing import Any

import pytest
import small_campaign
from click.testing import CliRunner
from decisions import load_noted_kernel
from small_campaign import Known, answer, find_failure, run_shard
from small_pairs import SmallPair, draw_shapeless, shares_direction, shrink

from exactsweep import Polygon, Region, inner_fit_polygon, no_fit_polygon, sweep

SQUARE = [[(0, 0), (1, 0), (1, 1), (0, 1)]]
SLOT = [[(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]]
CAVE = [[(0, 0), (4, 0), (4, 4), (2, 4), (2, 3), (3, 3), (3, 1), (1, 1), (1, 4), (0, 4)]]


@pytest.mark.parametrize("seed", range(8))
def test_pairs_of_all_classes_agree_with_the_definition(seed: int) -> None:
    assert find_failure(seed, 20) == ""


def test_pairs_without_shared_direction_are_of_class_ss() -> None:
    rng = Random(3)
    for _ in range(20):
        pair = draw_shapeless(rng)
        assert not shares_direction(pair)
        assert answer(pair).kind == "SS"


class Wrong(SimpleNamespace):
    """A sweep in which some attributes are replaced."""

    right: Any

    def __getattr__(self, name: str) -> Any:
        return getattr(self.right, name)


@pytest.mark.parametrize(
    ("directrix", "changed", "failure"),
    [
        (SLOT, {}, ""),
        (SLOT, {"exact_fits": ()}, "exact fits, swept in direction (1, 0)"),
        (SLOT, {"outer": Polygon(SLOT[0])}, "outer, swept in direction (1, 0)"),
        (SLOT, {"undercuts": ()}, "areas of the undercuts"),
        (SLOT, {"contacts": ((),)}, "an edge of the trajectory without contact"),
        (SLOT, {"kind": "SS"}, "kind SS"),
        (CAVE, {}, ""),
        (CAVE, {"unswept": (Polygon(SLOT[0]),)}, "swept area"),
        (CAVE, {"exterior": Polygon(SLOT[0])}, "no-fit polygon"),
        (CAVE, {"regions": (Region(SLOT[0]),)}, "inner fit"),
    ],
)
def test_wrong_answers_are_noticed(directrix: Any, changed: Any, failure: str) -> None:
    def falsely(right: Any) -> Any:
        return lambda *shapes: Wrong(right=right(*shapes), **changed)

    kernel = SimpleNamespace(
        Polygon=Polygon,
        Region=Region,
        sweep=falsely(sweep),
        no_fit_polygon=falsely(no_fit_polygon),
        inner_fit_polygon=falsely(inner_fit_polygon),
    )
    assert answer(SmallPair(SQUARE, directrix), kernel, deep=True).failure == failure


def test_a_failing_pair_is_shrunk() -> None:
    """What fails while D has a concave corner ends as a least polygon that has one."""
    least = shrink(SmallPair(SLOT, CAVE), lambda pair: not Polygon(pair.directrix[0]).is_convex)
    assert [len(ring) for shape in least for ring in shape] == [3, 4]


def test_notes_tell_ties_apart() -> None:
    """Two parallel edges are a tie in the merge by slope; a triangle around a square has none."""
    kernel, notes = load_noted_kernel()
    place = next(
        k
        for k, decision in enumerate(notes.decisions)
        if decision.module == "procedures.cc"
        and decision.ways == ("<", "=", ">")
        and "cross" not in decision.source
        and "turn" in decision.source
    )
    ways = []
    for triangle in ([(0, 0), (2, 0), (1, 3)], [(0, 0), (2, 1), (1, 3)]):
        notes.take_up()
        kernel.sweep(SQUARE[0], triangle).trajectory  # noqa: B018
        ways.append({way for decision, way in notes.take_up() if decision == place})
    assert 1 in ways[0]
    assert 1 not in ways[1]


def test_a_campaign_goes_on_where_it_was_stopped(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(small_campaign, "SHARD", 16)
    journals: list[str] = []
    for name, cut in (("whole", None), ("cut", 300)):
        path = tmp_path / name
        arguments = ["--pairs", "80", "--journal", str(path)]
        if cut is not None:
            done = journals[0].splitlines(keepends=True)
            path.write_text("".join(done[:3]) + done[3][:cut])
        result = CliRunner().invoke(small_campaign.main, arguments)
        assert result.exit_code == 0, result.output
        assert "80 pairs" in result.output
        journals.append(path.read_text())
    whole, again = ([json.loads(line) for line in text.splitlines()] for text in journals)
    for shard in (*whole[1:], *again[1:]):
        del shard["seconds"]
    assert whole[1:] == again[1:]
    other = CliRunner().invoke(small_campaign.main, [*arguments, "--seed", "2"])
    assert "another seed" in other.output


def test_bred_pairs_come_from_rare_outcomes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(small_campaign, "SHARD", 80)
    known = Known()
    first = run_shard(1, known, 0)
    known.learn(
        first._replace(noted=500, seen={"7:1": 1, "8:0": 250}, kept=[("7:1", (SQUARE, CAVE))])
    )
    assert known.pick(Random(1), 2) == [SmallPair(SQUARE, CAVE)] * 2
    assert known.is_rare("7:1")
    assert not known.is_rare("8:0")
