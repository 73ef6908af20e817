"""Sweeps, no-fit polygons and inner fits as values; errors that name the polygon."""

import copy
import importlib
import pickle
import pkgutil
from collections.abc import Callable
from inspect import signature
from pathlib import Path
from typing import Any

import pytest
import shapely
import strategies
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

import exactsweep
from exactsweep import (
    ExactSweepError,
    NoFitPolygon,
    Polygon,
    Region,
    Sweep,
    inner_fit_polygon,
    no_fit_polygon,
    sweep,
)
from exactsweep.draw import plot_positions, plot_sweep
from exactsweep.view import InlinePage

SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]
HOLLOW = Region(
    [(0, 0), (9, 0), (9, 9), (0, 9)], [[(5, 5), (8, 5), (5, 8)], [(1, 1), (3, 1), (1, 3)]]
)
NOTCH = [(0, 0), (8, 0), (8, 5), (7, 5), (3, 1), (2, 5), (0, 5)]
COPIES: list[Callable[[Any], Any]] = [
    copy.copy,
    copy.deepcopy,
    lambda answer: pickle.loads(pickle.dumps(answer)),
]


def list_values(answer: Any) -> list[Any]:
    values = [answer.certificate(), str(answer), repr(answer)]
    names = ("contacts", "vertex_contacts", "undercuts", "area", "kind", "unswept")
    return values + [getattr(answer, name, None) for name in names]


@pytest.mark.parametrize("directrix", [SQUARE, NOTCH, HOLLOW])
@pytest.mark.parametrize("ask", [sweep, no_fit_polygon, inner_fit_polygon])
@pytest.mark.parametrize("duplicate", COPIES, ids=["copy", "deepcopy", "pickle"])
def test_copies_report_the_same(
    ask: Callable[..., Any], directrix: Any, duplicate: Callable[[Any], Any]
) -> None:
    answer = ask(SQUARE, directrix, reference=(1, 0))
    fresh = duplicate(answer)
    values = list_values(answer)
    for twin in (fresh, duplicate(answer)):
        assert type(twin) is type(answer)
        assert twin == answer
        assert hash(twin) == hash(answer)
        assert list_values(twin) == values


@examples(20)
@given(strategies.simple_polygons(), strategies.simple_polygons(), st.data())
def test_answers_to_equal_questions_are_equal(g: Polygon, d: Polygon, data: st.DataObject) -> None:
    spelled = data.draw(strategies.spellings(g))
    for ask in (sweep, no_fit_polygon, inner_fit_polygon):
        answer: Any = ask(g, d)
        assert answer == ask(spelled, d)
        assert answer != ask(g.translated((1, 0)), d)
        assert answer != ask(g, d, reference=(1, 0))
        assert (answer == ask(d, g)) == (g == d)
        assert answer != object()
    assert sweep(g, d) != no_fit_polygon(d, g)
    assert len({sweep(g, d), sweep(spelled, d)}) == 1


def test_shapes_of_other_libraries_are_swept_with_their_holes() -> None:
    hollow = shapely.geometry.shape(HOLLOW)
    unit = shapely.box(0, 0, 0.5, 0.5)
    assert sweep(generatrix=unit, directrix=hollow) == sweep([*unit.exterior.coords], HOLLOW)
    n = no_fit_polygon(stationary=hollow, orbiting=unit)
    assert len(n.holes) == 2
    assert inner_fit_polygon(container=hollow, part=unit).regions[0].holes


def package_errors() -> list[type[Exception]]:
    found: list[type[Exception]] = []
    for module in pkgutil.walk_packages(exactsweep.__path__, "exactsweep."):
        if module.name.rsplit(".")[-1] in ("__main__", "convex", "reference"):
            continue
        found += [
            value
            for value in vars(importlib.import_module(module.name)).values()
            if isinstance(value, type)
            and issubclass(value, Exception)
            and value.__module__.startswith("exactsweep")
        ]
    return found


def test_all_errors_share_one_base() -> None:
    values = {error for error in package_errors() if issubclass(error, ValueError)}
    assert len(values) > 15
    assert {error for error in values if not issubclass(error, ExactSweepError)} == set()


def test_no_module_raises_a_bare_value_error() -> None:
    for path in Path(exactsweep.__path__[0]).rglob("*.py"):
        assert "raise ValueError(" not in path.read_text(encoding="utf-8"), path


def test_plot_and_view_have_the_defaults_of_the_functions_they_call() -> None:
    drawn: list[tuple[Callable[..., Any], Callable[..., Any]]] = [
        (Sweep.plot, plot_sweep),
        (NoFitPolygon.plot, plot_positions),
        (Sweep.view, InlinePage),
    ]
    for method, function in drawn:
        said, done = (signature(called).parameters for called in (method, function))
        for name in ("y_down", "height"):
            if name in said:
                assert said[name].default == done[name].default, name
