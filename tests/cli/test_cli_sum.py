"""`exactsweep sum` with paths of SVG; Minkowski differences."""

import json
from pathlib import Path
from typing import Any

import pytest
from command import refusal, run
from hypothesis import given
from polyominoes import polyominoes, region

from exactsweep import Polyline, Region, inner_fit_polygon, minkowski_difference, minkowski_sum
from exactsweep.check import verify

SVG = '<svg xmlns="http://www.w3.org/2000/svg">{}</svg>'
POINTS = [(0, 0), (5, 0), (5, 5)]
POLYGON = "POLYGON ((0 0, 5 0, 5 5, 0 0))"
OPEN = '<g transform="translate(1 0)"><polyline points="-1,0 4,0 4,5" {}/></g>'


def write(folder: Path, name: str, text: str) -> str:
    (folder / name).write_text(text)
    return str(folder / name)


@pytest.fixture
def shape(tmp_path: Path) -> str:
    return write(tmp_path, "a.json", "[[0, 0], [1, 0], [1, 2]]")


def test_an_open_unfilled_path_of_svg_is_a_path(shape: str, tmp_path: Path) -> None:
    file = write(tmp_path, "p.svg", SVG.format(OPEN.format('fill="none"')))
    done = run("sum", shape, file, "--wkt")
    flipped = Polyline([(x, -y) for x, y in POINTS])
    expected = minkowski_sum([(0, 0), (1, 0), (1, 2)], flipped)
    assert done.stdout == f"POLYGON (({', '.join(f'{x} {y}' for x, y in closed(expected))}))\n"
    assert done.stderr == f"{file}: Y axis flipped, because {shape} has Y up\n"


def closed(shape: Region) -> list[tuple[object, object]]:
    ring = [*shape.exterior, shape.exterior[0]]
    return [(x, y) for x, y in ring]


def test_y_points_down_if_it_does_in_both_files(tmp_path: Path) -> None:
    shape = write(tmp_path, "a.svg", SVG.format('<path d="M0 0H1V2z"/>'))
    file = write(tmp_path, "p.svg", SVG.format(OPEN.format('fill="none"')))
    done = run("sum", shape, file, "--wkt")
    expected = minkowski_sum([(0, 0), (1, 0), (1, 2)], Polyline(POINTS))
    assert ", ".join(f"{x} {y}" for x, y in closed(expected)) in done.stdout
    line = write(tmp_path, "l.wkt", "LINESTRING (0 0, 5 0, 5 5)")
    assert run("sum", shape, line).stderr == f"{shape}: Y axis flipped, because {line} has Y up\n"


def test_a_filled_path_is_a_polygon_unless_asked(shape: str, tmp_path: Path) -> None:
    file = write(tmp_path, "p.svg", SVG.format(OPEN.format("")))
    assert "b (path)" not in run("sum", shape, file).stdout
    assert "b (path)" in run("sum", shape, file, "--path").stdout


@pytest.mark.parametrize(
    ("drawn", "options", "message"),
    [
        ('<path d="M0 0C1 1 2 2 3 0" fill="none"/>', (), "a path with curves; draw it with"),
        ('<path d="M0 0H1" fill="none"/><path d="M0 0V1"/>', ("--path",), "is not a path; --path"),
    ],
)
def test_other_drawings_are_rejected(
    drawn: str, options: tuple[str, ...], message: str, shape: str, tmp_path: Path
) -> None:
    file = write(tmp_path, "p.svg", SVG.format(drawn))
    done = run("sum", shape, file, *options)
    assert done.exit_code in (1, 2)
    assert message in done.stderr


def test_a_chosen_polygon_is_not_a_path(shape: str) -> None:
    done = run("sum", shape, f"{shape}#0", "--path")
    assert (done.exit_code, "omit the #" in done.stderr) == (2, True)
    assert "No such file" in refusal(run("sum", shape, "none.svg"))


@given(polyominoes().map(region), polyominoes().map(region))
def test_the_difference_is_the_inner_fit(a: Region, b: Region) -> None:
    assert minkowski_difference(a, b) == inner_fit_polygon(container=a, part=b)


def test_a_certificate_proves_the_boundary_of_a_sum(shape: str, tmp_path: Path) -> None:
    frame: dict[str, Any] = {
        "exterior": [[0, 0], [9, 0], [9, 9], [0, 9]],
        "holes": [[[2, 2], [7, 2], [7, 7], [2, 7]]],
    }
    other = write(tmp_path, "b.json", json.dumps(frame))
    found = json.loads(run("sum", shape, other, "--certificate").stdout)
    assert verify(found).proved
    expected = minkowski_sum([(0, 0), (1, 0), (1, 2)], Region(frame["exterior"], frame["holes"]))
    assert Region(found["exterior"], found["holes"]) == expected


def test_a_certificate_proves_a_sum_with_a_path(shape: str, tmp_path: Path) -> None:
    line = write(tmp_path, "l.wkt", "LINESTRING (0 0, 5 0, 5 5)")
    file = write(tmp_path, "c.json", run("sum", shape, line, "--certificate").stdout)
    output = f"{file}: proved\nsum of 3 vertices and a path of 3 points: 6 vertices, no holes\n"
    assert run("verify", file).stdout == output
    assert run("verify", file, shape, line).exit_code == 0
    points = write(tmp_path, "p.json", json.dumps(POINTS))
    assert run("verify", file, shape, points).exit_code == 0
    other = write(tmp_path, "o.wkt", "LINESTRING (0 0, 5 0)")
    assert "not the given path" in run("verify", file, shape, other).stdout
    assert "not a path" in run("verify", file, shape, write(tmp_path, "x.wkt", POLYGON)).stderr
    alone = write(tmp_path, "1.wkt", "POINT (1 2)")
    assert "the path is a single point" in refusal(run("sum", shape, alone, "--certificate"))
