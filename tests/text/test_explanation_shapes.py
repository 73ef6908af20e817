"""Sweeps of any shape, told and reported."""

import json
from pathlib import Path

from command import run
from hypothesis import given
from strategies import simple_polygons
from tiers import examples

from exactsweep import Polygon, Region, sweep
from exactsweep.text.explanation import tell
from exactsweep.text.report import report
from exactsweep.text.results import explanation_to_json

SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]
HOLLOW = Region([(0, 0), (8, 0), (8, 6), (0, 6)], [[(1, 1), (5, 1), (5, 4), (1, 4)]])
# A door exactly as wide as the square, in the top of a chamber.
CHAMBER = [(0, 0), (8, 0), (8, 8), (5, 8), (5, 6), (7, 6), (7, 1), (1, 1), (1, 6), (3, 6)]
CHAMBER += [(3, 8), (0, 8)]

REPORT = """\
class       SS, polygons of any shape
direction   none
reference   (0,0)
undercuts   0
exact fits  0

            vertices  area about  area exactly
generatrix         4              4
directrix          8              36
trajectory         4              80
inner loop         4              48
outer loop         4              120
swept area                        72

trajectory  (-2,-2) (8,-2) (8,6) (-2,6)
inner loop  (0,0) (8,0) (8,6) (0,6)
outer loop  (-2,-2) (10,-2) (10,8) (-2,8)
"""


def test_a_sweep_around_a_hollow_block_is_reported(tmp_path: Path) -> None:
    assert report(sweep(SQUARE, HOLLOW)) == REPORT
    hollow = tmp_path / "hollow.json"
    hollow.write_text(json.dumps({"exterior": [[0, 0], [8, 0], [8, 6], [0, 6]],
                                  "holes": [[[1, 1], [5, 1], [5, 4], [1, 4]]]}))  # fmt: skip
    assert run("sweep", "-", str(hollow), stdin=json.dumps(SQUARE)).stdout == REPORT


def test_unswept_holes_are_reported() -> None:
    cave = [(0, 0), (10, 0), (10, 10), (5, 10), (5, 8), (8, 8)]
    cave += [(8, 2), (2, 2), (2, 8), (3, 8), (3, 10), (0, 10)]
    lines = report(sweep([(0, 0), (1, 0), (1, 1), (0, 1)], cave)).splitlines()
    assert "unswept 0          4              16" in lines
    assert "unswept 0   (3,3) (7,3) (7,7) (3,7)" in lines


def test_a_sweep_around_a_hollow_block_is_explained() -> None:
    lines = list(tell(sweep(SQUARE, HOLLOW)))
    assert lines[0] == "Class SS, polygons of any shape, of 4 and 8 vertices."
    rest = "the no-fit polygon has 1 hole with room for G."
    assert f"Inside its path, which G cannot enter by sliding, {rest}" in lines
    start = lines.index("Step 0: right, along (1,0), from (-2,-2) to (8,-2)")
    assert lines[start + 1] == (
        "  EE: edge 2 of G, (2,2)-(0,2), slides along edge 0 of D, (0,0)-(8,0)"
    )
    back = lines.index("G is back at (-2,-2).")
    assert lines[back + 1 :] == [
        "",
        "-- Hole 0 of the no-fit polygon, of area 2: G is free inside --",
        "Right, from (1,1) to (3,1)",
        "  EE: edge 0 of G, (0,0)-(2,0), slides along edge 4 of D, (1,1)-(5,1)",
        "Up, from (3,1) to (3,2)",
        "  EE: edge 1 of G, (2,0)-(2,2), slides along edge 5 of D, (5,1)-(5,4)",
        "Left, from (3,2) to (1,2)",
        "  EE: edge 2 of G, (2,2)-(0,2), slides along edge 6 of D, (5,4)-(1,4)",
        "Down, from (1,2) to (1,1)",
        "  EE: edge 3 of G, (0,2)-(0,0), slides along edge 7 of D, (1,4)-(1,1)",
    ]


def test_an_exact_fit_in_a_door_begins_where_g_passes() -> None:
    s = sweep(SQUARE, CHAMBER)
    # Its inner end hangs on the hole, its outer end on the trajectory.
    told = [line for line in tell(s) if "exact fit 0 begins" in line]
    (line,) = told
    assert line.endswith("exact fit 0 begins: G could go down to (3,4), touching D on both sides")
    assert "at (3,8)" in line
    document = json.loads(explanation_to_json(s))
    assert document["direction"] is None
    assert document["features"]["directrix"]["vertices"] == list(range(12))


def test_fits_are_told_with_what_touches() -> None:
    # A hole into which the square just fits, and one in which it just slides.
    holes = [[(1, 1), (3, 1), (3, 3), (1, 3)], [(4, 1), (6, 1), (6, 5), (4, 5)]]
    s = sweep(SQUARE, Region([(0, 0), (8, 0), (8, 6), (0, 6)], holes))
    lines = list(tell(s))
    single = lines.index("-- Exact fit 0: G fits at (1,1) and cannot move --")
    assert lines[single + 1 : single + 5] == [
        f"  EE: edge {k} of G, {g}, is on edge {4 + k} of D, {d}"
        for k, (g, d) in enumerate(
            [
                ("(0,0)-(2,0)", "(1,1)-(3,1)"),
                ("(2,0)-(2,2)", "(3,1)-(3,3)"),
                ("(2,2)-(0,2)", "(3,3)-(1,3)"),
                ("(0,2)-(0,0)", "(1,3)-(1,1)"),
            ]
        )
    ]
    assert lines[single + 5 :] == [
        "",
        "-- Exact fit 1: G could go up, from (4,1) to (4,3) --",
        "  EE: edge 1 of G, (2,0)-(2,2), slides along edge 9 of D, (6,1)-(6,5)",
        "  EE: edge 3 of G, (0,2)-(0,0), slides along edge 11 of D, (4,5)-(4,1)",
    ]
    document = json.loads(explanation_to_json(s))
    assert document["exact_fit_contacts"][1] == [["EE", 1, 9], ["EE", 3, 11]]
    assert len(document["exact_fit_contacts"][0]) >= 4


@examples(15)
@given(simple_polygons(), simple_polygons())
def test_every_sweep_is_told(g: Polygon, d: Polygon) -> None:
    s = sweep(g, d)
    lines = list(tell(s))
    assert sum(line.startswith("Step ") for line in lines) == len(s.trajectory)
    assert "".join(lines).isascii()
    assert report(s).isascii()
    document = json.loads(explanation_to_json(s))
    assert len(document["steps"]) == len(s.trajectory)
    assert [len(hole["contacts"]) for hole in document["holes"]] == [*map(len, s.no_fit_holes)]
    assert len(document["exact_fit_contacts"]) == len(s.exact_fits)
    assert sum(line.startswith("-- Hole") for line in lines) == len(s.no_fit_holes)
    assert sum(line.startswith("-- Exact fit") for line in lines) == len(s.exact_fits)
