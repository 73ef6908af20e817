"""--turns, --mirrored and --placed LAYOUT of ifp and nfp: one exact line per rotation."""

import json
from pathlib import Path
from typing import Any

from command import run

from exactsweep import Region, free_positions, no_fit_polygon

SHEET = [[0, 0], [20, 0], [20, 10], [0, 10]]
PART = [[0, 0], [9, 0], [9, 1], [0, 4]]
LAYOUT = {
    "container": {"exterior": SHEET},
    "parts": [{"id": "t", "exterior": [[0, 0], [6, 0], [6, 3], [0, 3]]}],
    "placements": [{"part": "t", "move": [0, 0]}, {"part": "t", "turn": 90, "move": [20, 0]}],
}
PLACED = [Region([(0, 0), (6, 0), (6, 3), (0, 3)]), Region([(17, 0), (20, 0), (20, 6), (17, 6)])]


def write(folder: Path, name: str, data: object) -> str:
    path = folder / name
    path.write_text(json.dumps(data))
    return str(path)


def test_each_turn_has_a_line(tmp_path: Path) -> None:
    files = write(tmp_path, "c.json", SHEET), write(tmp_path, "p.json", PART)
    nest = write(tmp_path, "nest.json", LAYOUT)
    options = "--turns", "0, 90", "--mirrored", "--placed", nest
    done = run("ifp", *files, *options, "--json")
    assert done.exit_code == 0
    assert "nest.json: 2 placed parts" in done.stderr
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    assert [(line["turn"], line["mirrored"]) for line in lines] == [
        ("0", False),
        ("90", False),
        ("0", True),
        ("90", True),
    ]
    shapes: list[Any] = [
        PART,
        [(-y, x) for x, y in PART],
        [(-x, y) for x, y in PART],
        [(-y, -x) for x, y in PART],
    ]
    for line, shape in zip(lines, shapes, strict=True):
        found = free_positions(SHEET, PLACED, shape)
        assert line["fits"] == bool(found)
        assert line["regions"] == [
            {"exterior": [[str(c) for c in p] for p in region.exterior.vertices], "holes": []}
            for region in found.regions
        ]
    report = run("ifp", *files, *options).stdout.splitlines()
    assert len(report) == 5
    assert report[1].split()[:2] == ["0", "yes"]


def test_a_rotation_that_does_not_fit_is_marked(tmp_path: Path) -> None:
    files = write(tmp_path, "c.json", SHEET), write(tmp_path, "p.json", [[0, 0], [15, 0], [0, 2]])
    report = run("ifp", *files, "--turns", "0,90").stdout.splitlines()
    assert [line.split()[1] for line in report[1:]] == ["yes", "no"]


def test_an_irrational_turn_is_noted(tmp_path: Path) -> None:
    files = write(tmp_path, "c.json", SHEET), write(tmp_path, "p.json", PART)
    done = run("ifp", *files, "--turns", "45")
    assert "45 degrees: rotated by a rational angle within 2^-64" in done.stderr


def test_no_fit_polygons_of_turns(tmp_path: Path) -> None:
    files = write(tmp_path, "c.json", SHEET), write(tmp_path, "p.json", PART)
    one = json.loads(run("nfp", *files, "--turns", "90", "--json").stdout)
    wanted = no_fit_polygon(SHEET, [(-y, x) for x, y in PART])
    assert one["exterior"] == [[str(c) for c in p] for p in wanted.exterior.vertices]
    report = run("nfp", *files, "--turns", "0,90,180,270", "--mirrored").stdout.splitlines()
    assert len(report) == 9


def test_several_turns_have_no_certificate(tmp_path: Path) -> None:
    files = write(tmp_path, "c.json", SHEET), write(tmp_path, "p.json", PART)
    assert "--wkt is for a single pose." in run("ifp", *files, "--turns", "0,90", "--wkt").stderr
    assert "'--turns'" in run("ifp", *files, "--turns", "x").stderr


def test_defects_may_cross_the_edge_and_each_other(tmp_path: Path) -> None:
    holes = [[[5, 0], [10, 0], [10, 4], [5, 4]], [[9, 3], [12, 3], [12, 6], [9, 6]]]
    container = write(tmp_path, "c.json", {"exterior": SHEET, "holes": holes})
    part = write(tmp_path, "p.json", [[0, 0], [2, 0], [2, 2], [0, 2]])
    found = json.loads(run("ifp", container, part, "--json").stdout)
    (wanted,) = free_positions(SHEET, holes, [(0, 0), (2, 0), (2, 2), (0, 2)]).regions
    assert found["regions"][0]["exterior"] == [
        [str(c) for c in p] for p in wanted.exterior.vertices
    ]


def test_the_sheet_of_a_placed_drawing_is_no_obstacle(tmp_path: Path) -> None:
    drawing, part = tmp_path / "nest.svg", tmp_path / "part.json"
    rects = '<rect id="sheet" width="9" height="4"/><rect id="a" width="4" height="4"/>'
    drawing.write_text(f'<svg xmlns="http://www.w3.org/2000/svg">{rects}</svg>')
    part.write_text("[[0, 0], [5, 0], [5, 4], [0, 4]]")
    done = run("ifp", f"{drawing}#sheet", str(part), "--placed", str(drawing), "--json")
    assert done.exit_code == 0
    assert "skipped the outline of the container" in done.stderr
    assert json.loads(done.stdout)["exact_fits"]
