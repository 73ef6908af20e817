"""`exactsweep nfp` and `ifp`, and polygons of any shape on the command line."""

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from command import HOUSE, NOTCH, refusal, run
from hypothesis import given
from strategies import simple_polygons
from tiers import examples

from exactsweep import Polygon, Region, free_positions, inner_fit_polygon, no_fit_polygon, sweep
from exactsweep.check import verify
from exactsweep.formats import parse_polygon
from exactsweep.text.report import report_inner_fit, report_no_fit
from exactsweep.text.results import inner_fit_to_json, no_fit_to_json

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
BAR = [(0, 0), (10, 0), (10, 1), (0, 1)]
# A block of 9 x 5 with a hole of 3 x 2, in which the square has 2 x 1 to move, one of 1 x 3, which
# is exactly as wide as the square, and one of 1 x 1, which it just fills.
PLATE = Region(
    [(0, 0), (9, 0), (9, 5), (0, 5)],
    [
        [(1, 1), (4, 1), (4, 3), (1, 3)],
        [(5, 1), (6, 1), (6, 4), (5, 4)],
        [(7, 2), (8, 2), (8, 3), (7, 3)],
    ],
)
PLATE_WKT = (
    "POLYGON ((0 0, 9 0, 9 5, 0 5, 0 0), (1 1, 1 3, 4 3, 4 1, 1 1), "
    "(5 1, 6 1, 6 4, 5 4, 5 1), (7 2, 8 2, 8 3, 7 3, 7 2))"
)
PLATE_REPORT = """\
class        SS, polygons of any shape
reference    (0,0)
holes        1
exact fits   2

             vertices  area about  area exactly
stationary         16              35
orbiting            4              1
exterior            4              60
hole 0              4              2
no fit                             58

exterior     (-1,-1) (9,-1) (9,5) (-1,5)
hole 0       (1,1) (3,1) (3,2) (1,2)
exact fit 0  (5,1) (5,3)
exact fit 1  (7,2)
"""


@pytest.fixture
def files(tmp_path: Path) -> dict[str, str]:
    """Files by name: the plate in both formats, the square, and a part of 10 x 1."""
    texts = {
        "plate.wkt": PLATE_WKT,
        "plate.json": json.dumps(
            {"exterior": [[0, 0], [9, 0], [9, 5], [0, 5]], "holes": [
                [[1, 1], [4, 1], [4, 3], [1, 3]],
                [[5, 1], [6, 1], [6, 4], [5, 4]],
                [["7", "2"], ["8", 2], [8.0, 3], [7, 3]],
            ]}
        ),
        "square.json": json.dumps(SQUARE),
        "bar.json": "[[0, 0], [10, 0], [10, 1], [0, 1]]",
        "third.json": '[[0, 0], ["1/3", 0], [0, 1]]',
    }  # fmt: skip
    for name, text in texts.items():
        (tmp_path / name).write_text(text)
    return {name: str(tmp_path / name) for name in texts}


@pytest.mark.parametrize("name", ["plate.wkt", "plate.json"])
def test_the_no_fit_polygon_has_its_holes_and_fits(name: str, files: dict[str, str]) -> None:
    assert run("nfp", files[name], files["square.json"]).stdout == PLATE_REPORT
    expected = no_fit_polygon(PLATE, SQUARE)
    assert report_no_fit(expected) == PLATE_REPORT
    assert run("nfp", files[name], "-", "--json", stdin=json.dumps(SQUARE)).stdout == (
        no_fit_to_json(expected)
    )


def test_positions_in_a_container_are_found(files: dict[str, str]) -> None:
    result = run("ifp", files["plate.json"], files["square.json"])
    expected = inner_fit_polygon(PLATE, SQUARE)
    assert result.stdout == report_inner_fit(expected)
    assert result.stdout.startswith("the part     fits\n")
    shown = run("ifp", files["plate.json"], files["square.json"], "--json").stdout
    assert shown == inner_fit_to_json(expected)
    found = json.loads(shown)
    assert list(found) == ["container", "part", "reference", "regions", "exact_fits", "area"]
    regions = tuple(Region(region["exterior"], region["holes"]) for region in found["regions"])
    assert regions == expected.regions
    # Of [0, 8] x [0, 4], the defects take (0, 4) x (0, 3), (4, 6) x (0, 4) and (6, 8) x (1, 3).
    assert Fraction(found["area"]) == 4 * 1 + 2 * 1 + 2 * 1
    assert len(found["exact_fits"]) == 6
    assert [["4", "4"], ["6", "4"]] in found["exact_fits"]


def test_placed_shapes_are_kept_clear_of(files: dict[str, str]) -> None:
    both = ("--placed", files["bar.json"], "--placed", files["square.json"])
    expected = free_positions(PLATE, [BAR, SQUARE], SQUARE)
    result = run("ifp", files["plate.json"], files["square.json"], *both)
    assert result.stdout == report_inner_fit(expected)
    assert "\nplaced       2\n" in result.stdout
    shown = run("ifp", files["plate.json"], files["square.json"], *both, "--json").stdout
    assert shown == inner_fit_to_json(expected)
    assert [Polygon(shape) for shape in json.loads(shown)["placed"]] == [
        Polygon(BAR),
        Polygon(SQUARE),
    ]
    files_with_fault = (files["plate.json"], files["square.json"], "--placed", "-")
    refused = run("ifp", *files_with_fault, stdin="[[0, 0], [1, 1], [1, 0], [0, 1]]")
    assert "crosses itself" in refusal(refused)


def test_a_container_exactly_as_wide_leaves_a_line(files: dict[str, str]) -> None:
    channel = "POLYGON ((0 0, 1 0, 1 4, 0 4, 0 0))"
    shown = run("ifp", "-", files["square.json"], stdin=channel).stdout
    assert shown.startswith("the part     fits exactly\n")
    assert shown.endswith("\nexact fit 0  (0,0) (0,3)\n")
    assert run("ifp", "-", files["square.json"], "--wkt", stdin=channel).stdout == (
        "LINESTRING (0 0, 0 3)\n"
    )
    # Exactly as high, too: a single position.
    assert run("ifp", files["square.json"], files["square.json"], "--wkt").stdout == "POINT (0 0)\n"


def test_a_part_that_does_not_fit_has_an_empty_answer(files: dict[str, str]) -> None:
    pair = files["plate.json"], files["bar.json"]
    result = run("ifp", *pair)
    assert (result.exit_code, result.stderr) == (0, "")
    assert (
        result.stdout
        == """\
the part    does not fit
reference   (0,0)
regions     0
exact fits  0

            vertices  area about  area exactly
container         16              35
part               4              10
positions                         0
"""
    )
    assert run("ifp", *pair, "--wkt").stdout == "POLYGON EMPTY\n"
    found = json.loads(run("ifp", *pair, "--json").stdout)
    assert (found["regions"], found["exact_fits"], found["area"]) == ([], [], "0")


@pytest.mark.parametrize("command", ["nfp", "ifp"])
@pytest.mark.parametrize("moved", ["square.json", "bar.json", "third.json"])
def test_certificates_are_proved(
    command: str, moved: str, files: dict[str, str], tmp_path: Path
) -> None:
    proof = str(tmp_path / "proof.json")
    options = ("--certificate", "--reference", "1", "1/2", "-o", proof)
    assert run(command, files["plate.wkt"], files[moved], *options).output == ""
    assert run("verify", proof).stdout.startswith("proved\n")
    # An answer that hides a hole or a region is not.
    tampered: dict[str, Any] = json.loads(Path(proof).read_text())
    if moved == "square.json":
        tampered["holes" if command == "nfp" else "regions"] = []
        assert not verify(tampered).proved


@examples(20)
@given(simple_polygons(), simple_polygons())
def test_the_written_answer_is_the_answer(d: Polygon, g: Polygon) -> None:
    n = no_fit_polygon(d, g)
    found = json.loads(no_fit_to_json(n))
    assert Polygon(found["exterior"]) == n.exterior
    assert tuple(map(Polygon, found["holes"])) == n.holes
    fits = [[(Fraction(x), Fraction(y)) for x, y in fit] for fit in found["exact_fits"]]
    assert fits == [list(fit) for fit in n.exact_fits]
    assert Fraction(found["area"]) == n.area


def test_a_sweep_of_any_shape_is_written(files: dict[str, str]) -> None:
    s = sweep(SQUARE, PLATE)
    found = json.loads(run("sweep", files["square.json"], files["plate.wkt"], "--json").stdout)
    assert (found["kind"], found["direction"], found["unswept"]) == ("SS", None, [])
    assert Region(found["directrix"]["exterior"], found["directrix"]["holes"]) == PLATE
    assert Polygon(found["outer"]) == s.outer
    assert Fraction(found["area"]) == s.area
    shown = run("sweep", files["square.json"], files["plate.wkt"], "--wkt").stdout
    assert [parse_polygon(line) for line in shown.splitlines()] == [s.trajectory, s.inner, s.outer]


def test_what_is_not_swept_is_written(tmp_path: Path, files: dict[str, str]) -> None:
    # The square goes in by a door two wide, and round the cave of 6 x 6 along its walls; it passes
    # by the middle.
    cave = [(0, 0), (10, 0), (10, 10), (5, 10), (5, 8), (8, 8)]
    cave += [(8, 2), (2, 2), (2, 8), (3, 8), (3, 10), (0, 10)]
    path = tmp_path / "cave.json"
    path.write_text(json.dumps(cave))
    pair = files["square.json"], str(path)
    found = json.loads(run("sweep", *pair, "--json").stdout)
    assert found["unswept"] == [[["3", "3"], ["7", "3"], ["7", "7"], ["3", "7"]]]
    # All of the 12 x 12 around, without D, of 100 - 36 - 4, and the middle.
    assert found["area"] == str(144 - 60 - 16)
    lines = run("sweep", *pair, "--wkt").stdout.splitlines()
    assert lines[3:] == ["POLYGON ((3 3, 7 3, 7 7, 3 7, 3 3))"]


@pytest.mark.parametrize("command", ["nfp", "ifp"])
@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([HOUSE], "Missing argument '"),
        (["-", "-"], "Only one polygon can be read from standard input."),
        ([HOUSE, NOTCH, "--json", "--wkt"], "--json and --wkt exclude each other."),
        ([HOUSE, NOTCH, "--direction", "1", "0"], "No such option"),
        ([HOUSE, NOTCH, "--reference", "1", "nan"], "'nan' is not a number such as"),
    ],
)
def test_wrong_usage_exits_with_2(command: str, arguments: list[str], message: str) -> None:
    result = run(command, *arguments)
    assert (result.exit_code, result.stdout) == (2, "")
    assert message in result.stderr
