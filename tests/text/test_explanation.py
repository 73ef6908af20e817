"""Explanations of sweeps are complete and take linear time."""

import json
from fractions import Fraction

import pytest
from hypothesis import given
from linear import require_linear
from strategies import simple_polygons
from tiers import examples

from exactsweep import Polygon, no_fit_polygon, sweep
from exactsweep.text.explanation import describe_steps
from exactsweep.text.report import report
from exactsweep.text.results import explanation_to_json, no_fit_to_json


@examples(15)
@given(simple_polygons(), simple_polygons())
def test_every_sweep_is_explained(g: Polygon, d: Polygon) -> None:
    s = sweep(g, d)
    lines = list(describe_steps(s))
    assert sum(line.startswith("Step ") for line in lines) == len(s.trajectory)
    assert "".join(lines).isascii()
    assert report(s).isascii()
    document = json.loads(explanation_to_json(s))
    assert len(document["steps"]) == len(s.trajectory)
    assert [len(hole["contacts"]) for hole in document["holes"]] == [*map(len, s.no_fit_holes)]
    assert len(document["exact_fit_contacts"]) == len(s.exact_fits)
    assert sum(line.startswith("-- Hole") for line in lines) == len(s.no_fit_holes)
    assert sum(line.startswith("-- Exact fit") for line in lines) == len(s.exact_fits)


@pytest.mark.parametrize("height", [1, 3, 5])
def test_a_stop_at_a_wall_omits_the_ends_of_its_edges(height: int) -> None:
    g = [(0, 0), (3, 0), (3, 3), (0, 3)]
    d = [(0, -1), (10, -1), (10, 0), (4, 0), (4, height), (0, height)]
    (stop,) = (line for line in describe_steps(sweep(g, d)) if "Stop: " in line)
    line = f"edge 3 of G, (0,3)-(0,0), comes flush with edge 3 of D, (4,0)-(4,{height})"
    assert stop.split(";")[0] == f"  Stop: {line}"


@examples(20)
@given(simple_polygons(), simple_polygons())
def test_written_answers_equal_the_answers(d: Polygon, g: Polygon) -> None:
    n = no_fit_polygon(d, g)
    found = json.loads(no_fit_to_json(n))
    assert Polygon(found["exterior"]) == n.exterior
    assert tuple(map(Polygon, found["holes"])) == n.holes
    fits = [[(Fraction(x), Fraction(y)) for x, y in fit] for fit in found["exact_fits"]]
    assert fits == [list(fit) for fit in n.exact_fits]
    assert Fraction(found["area"]) == n.area


@pytest.mark.long
def test_many_steps_take_linear_time() -> None:
    # A parabola of 100 edges slides around deep teeth, completely around each of them.
    parabola = [(x, x * x) for x in range(100)]

    def explain_teeth(teeth: int) -> None:
        top = [(100 * k, 10**7 * (k % 2)) for k in range(teeth, -1, -1)]
        s = sweep(parabola, [(0, -1), (100 * teeth, -1), *top])
        assert (
            sum(line.startswith("Step") for line in describe_steps(s))
            == len(s.trajectory)
            > 50 * teeth
        )

    require_linear(explain_teeth, 12)
