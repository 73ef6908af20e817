"""The first trials of campaigns have no mismatch, and wrong answers are noticed."""

import importlib.util
from random import Random
from types import SimpleNamespace
from typing import Any

import campaign
import pytest
from click.testing import CliRunner
from definition import find_failure
from shape_families import SHAPES
from small_pairs import SmallPair, shrink

from exactsweep import Polygon, Region, inner_fit_polygon, no_fit_polygon, sweep

SQUARE = [[(0, 0), (1, 0), (1, 1), (0, 1)]]
SLOT = [[(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]]
CAVE = [[(0, 0), (4, 0), (4, 4), (2, 4), (2, 3), (3, 3), (3, 1), (1, 1), (1, 4), (0, 4)]]


# Tests of layouts and of free positions run the first trials of the other campaigns.
PAIRS = [name for name in campaign.STRATEGIES if name not in ("layouts", "scenes")]


@pytest.mark.parametrize("name", PAIRS)
def test_campaigns_begin_without_mismatch(name: str) -> None:
    assert campaign.find_failures(name, 2, range(6)) == []


@pytest.mark.long
@pytest.mark.parametrize("name", PAIRS)
def test_campaigns_continue_without_mismatch(name: str) -> None:
    assert campaign.find_failures(name, 3, range(120)) == []


@pytest.mark.long
@pytest.mark.parametrize("family", SHAPES)
def test_every_family_of_shapes_agrees_with_the_definition(family: str) -> None:
    for number in range(6):
        pair = campaign.draw_shapes(Random(f"2:{number}"), (family,))
        assert find_failure(pair, deep=number == 0) == "", number


@pytest.mark.skipif(
    importlib.util.find_spec("pysfcgal") is None, reason="pysfcgal is not installed"
)
def test_sfcgal_agrees() -> None:
    failures = [failure for _, failure in campaign.by_sfcgal("small", 2, range(10))]
    assert failures.count("") > 5
    assert all(failure.startswith("crashes") for failure in failures if failure)


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
        (CAVE, {"holes": (Polygon(SLOT[0]),)}, "no-fit polygon"),
        (CAVE, {"regions": (Region(SLOT[0]),)}, "inner fit"),
    ],
)
def test_wrong_answers_are_noticed(directrix: Any, changed: Any, failure: str) -> None:
    def falsely(right: Any) -> Any:
        return lambda *shapes, **options: Wrong(right=right(*shapes, **options), **changed)

    kernel = SimpleNamespace(
        Polygon=Polygon,
        Region=Region,
        sweep=falsely(sweep),
        no_fit_polygon=falsely(no_fit_polygon),
        inner_fit_polygon=falsely(inner_fit_polygon),
    )
    assert find_failure(SmallPair(SQUARE, directrix), deep=True, kernel=kernel) == failure


def test_an_error_is_a_mismatch() -> None:
    kernel = SimpleNamespace(Polygon=Polygon)
    assert find_failure(SmallPair(SQUARE, SLOT), kernel=kernel).startswith("AttributeError")


def test_a_failing_pair_is_shrunk() -> None:
    """A failure that requires a reflex vertex of D is reduced to a smallest polygon with one."""
    least = shrink(SmallPair(SLOT, CAVE), lambda pair: not Polygon(pair.directrix[0]).is_convex)
    assert [len(ring) for shape in least for ring in shape] == [3, 4]


def test_a_mismatch_is_reported_with_its_pair_and_exit_code_1(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def by_size(name: str, seed: int, numbers: range) -> list[campaign.Compared]:
        return [campaign.Compared("any", "" if number % 3 else "wrong") for number in numbers]

    monkeypatch.setitem(campaign.REFERENCES, "definition", by_size)
    monkeypatch.setattr(campaign, "ProcessPoolExecutor", InThisProcess)
    result = CliRunner().invoke(campaign.main, ["small", "--count", "2", "--seed", "4"])
    assert result.exit_code == 1
    assert "small 4:0: wrong" in result.output
    assert "small, definition, seed 4: 1 any; 1 mismatches" in result.output


class InThisProcess:
    def __init__(self, workers: int) -> None:
        self.map = map

    def __enter__(self) -> "InThisProcess":
        return self

    def __exit__(self, *error: object) -> None:
        return None
