"""Batches of folders of drawings: names, omissions, rotations, and tables of numbers."""

import csv
import io
import json
import subprocess
import sys
from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

import pyarrow.parquet
import pytest
from command import refusal, run
from drawings import every_drawing
from hypothesis import given
from strategies import simple_polygons
from tiers import examples

from exactsweep import Point, Polygon, Region, no_fit_polygon
from exactsweep.batch import Part, Rounding, take_all_pairs
from exactsweep.batch.parts import rotate_parts
from exactsweep.batch.record import round_values
from exactsweep.formats.folder import find_files, list_parts, make_unique
from exactsweep.formats.rounding import contains
from exactsweep.geometry.turn import read_turn

SVG = '<svg><rect id="plate" width="6" height="4"/><path d="M0 0L1 1"/></svg>'
TRIANGLE = Polygon([(0, 0), (2, 0), (0, 1)])


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    parts = tmp_path / "parts"
    (parts / "sub").mkdir(parents=True)
    (parts / "left.svg").write_text(SVG)
    (parts / "one.json").write_text("[[0,0],[1,0],[0,1]]")
    (parts / "sub" / "one.json").write_text('[[{"x":0,"y":0},{"x":1,"y":0},{"x":0,"y":"1/2"}]]')
    (parts / "two.csv").write_text("part;x;y\na;0;0\na;1;0\na;0;1\nb;0;0\nb;2;0\nb;0;1\n")
    (parts / "broken.wkt").write_text("POLYGON ((0 0")
    (parts / "notes.txt").write_text("not a drawing")
    return parts


def records(path: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in path.read_text().splitlines()]


def test_names_of_files_survive_in_records(folder: Path, tmp_path: Path) -> None:
    output = tmp_path / "out.jsonl"
    done = run("batch", "--all", str(folder), f"{folder}/*.svg#plate", "-o", str(output))
    assert done.exit_code == 0
    assert done.stderr.count("skipped: ") == 2
    assert "broken.wkt: line 1, column 14" in done.stderr
    assert "left.svg: line 1: path: open end at (0,0): no other end meets it exactly" in done.stderr
    names = [record["generatrix"] for record in records(output)]
    assert names == ["left.svg#plate", "one.json", "sub/one.json", "two.csv#a", "two.csv#b"]
    assert {record["directrix"] for record in records(output)} == {"plate"}


def test_parts_are_named_by_id_layer_file_or_index(folder: Path) -> None:
    assert [part.name for part in list_parts([str(folder / "left.svg")]).parts] == ["plate"]
    assert [part.name for part in list_parts([str(folder / "one.json")]).parts] == ["one.json"]
    both = list_parts([str(folder / "left.svg"), str(folder / "one.json")]).parts
    assert [part.name for part in both] == ["left.svg#plate", "one.json"]
    job = take_all_pairs([Part("a", TRIANGLE)] * 3, [Part("b", TRIANGLE)])
    assert [part.name for part in job.work.generatrices] == ["a", "a-2", "a-3"]
    assert make_unique(["a-2", "a", "a"]) == ["a-2", "a", "a-3"]


def test_folders_and_patterns_without_files_are_rejected(folder: Path, tmp_path: Path) -> None:
    empty = tmp_path / "empty"
    empty.mkdir()
    for path, reason in (
        (empty, "no file has one of the suffixes"),
        (f"{folder}/*.dxf", "no file matches"),
    ):
        message = refusal(run("batch", "--all", str(path), str(folder), "-o", str(tmp_path / "x")))
        assert reason in message
    strange = tmp_path / "a[1].json"
    strange.write_text("[[0,0],[1,0],[0,1]]")
    assert find_files(str(strange)) == [str(strange)]


def test_a_batch_of_rejected_pairs_fails(tmp_path: Path) -> None:
    pairs, output = tmp_path / "pairs.jsonl", tmp_path / "out.jsonl"
    pairs.write_text('{"generatrix": [[0,0]], "directrix": [[0,0],[1,0],[0,1]]}\n')
    done = run("batch", str(pairs), "-o", str(output), "--workers", "1")
    assert (done.exit_code, done.stdout) == (1, "1 pair, 1 refused\n")
    assert done.stderr == f"Error: all pairs were refused; {output} states why\n"
    assert len(records(output)) == 1


def test_rotations_are_exact(tmp_path: Path) -> None:
    turned = rotate_parts([Part("a", TRIANGLE), Part("bad", "no polygon")], [0, 90, 180, 270])
    assert [name for name, _ in turned[:5]] == ["a", "a@90", "a@180", "a@270", "bad"]
    assert turned[2].polygon == TRIANGLE.reflected()
    part = tmp_path / "part.json"
    part.write_text("[[0,0],[2,0],[0,1]]")
    output = tmp_path / "out.jsonl"
    options = ("--rotations", "0,90", "--compute", "nfp", "-o", str(output), "--workers", "1")
    assert run("batch", "--all", str(part), str(part), *options).stdout == "2 pairs, 0 refused\n"
    found = records(output)
    for record, by in zip(found, (0, 90), strict=True):
        assert record["generatrix"] == "part.json" + "@90" * (by > 0)
        expected = no_fit_polygon(TRIANGLE, TRIANGLE.rotated(by)).exterior
        assert Polygon(record["exterior"]) == expected
    for wrong in ("4 5", "x", ""):
        assert run("batch", "--all", "a", "b", "-o", "x", "--rotations", wrong).exit_code == 2


def test_rational_rotations_are_reported(tmp_path: Path) -> None:
    part, output = tmp_path / "part.json", tmp_path / "out.jsonl"
    part.write_text("[[0,0],[2,0],[0,1]]")
    options = ("--rotations", "0,33.3", "--compute", "nfp", "-o", str(output), "--workers", "1")
    done = run("batch", "--all", str(part), str(part), *options)
    turn = read_turn("33.3").near()
    approximation = (
        f"cosine {turn.cosine} and sine {turn.sine}, each within 2^-64 of the true value"
    )
    assert done.stderr == f"33.3 degrees: rotated with the rational {approximation}\n"
    _, turned = records(output)
    assert turned["generatrix"] == "part.json@33.3"
    expected = no_fit_polygon(TRIANGLE, TRIANGLE.rotated((turn.cosine, turn.sine))).exterior
    assert Polygon(turned["exterior"]) == expected


@examples(10)
@given(simple_polygons(), simple_polygons())
def test_rounded_records_permit_no_overlap(one: Polygon, other: Polygon) -> None:
    d, g = one.rotated((3, 4)), other.rotated((5, 12))
    work = take_all_pairs([Part("g", g)], [Part("d", d)], "nfp", Rounding(1, outward=True)).work
    record = json.loads(work.line(0, 0), parse_float=str, parse_int=str)
    exact = no_fit_polygon(d, g)
    found = Region(record["exterior"], record["holes"])
    assert contains(found, Region(exact.exterior, exact.holes))
    assert abs(Fraction(record["area"]) - exact.area) <= Fraction(1, 20)


def test_exact_fits_that_rounding_moves_are_dropped() -> None:
    fits: list[list[tuple[Any, Any]]] = [
        [("4/3", 1), ("4/3", 3)],
        [("1.5", "0.25"), ("1.5", "0.25")],
        [(1, "0.1"), (1, 2)],
    ]
    exact = [tuple(Point(Fraction(x), Fraction(y)) for x, y in fit) for fit in fits]
    closest = round_values({"exact_fits": exact}, Rounding(1, outward=False))["exact_fits"]
    assert [[[str(c) for c in p] for p in fit] for fit in closest] == [
        [["13/10", "1"], ["13/10", "3"]],
        [["3/2", "1/5"], ["3/2", "1/5"]],
        [["1", "1/10"], ["1", "2"]],
    ]
    kept = round_values({"exact_fits": exact}, Rounding(1, outward=True))["exact_fits"]
    assert kept == exact[2:]


@pytest.mark.parametrize("what", ["areas", pytest.param("nfp", marks=pytest.mark.long)])
def test_tables_have_numbers_on_request(what: str, folder: Path, tmp_path: Path) -> None:
    lists = ("--all", str(folder / "one.json"), str(folder / "sub" / "one.json"))
    tables = {}
    for ending in ("csv", "parquet", "jsonl"):
        path = tmp_path / f"{what}.{ending}"
        done = run("batch", *lists, "--compute", what, "--round", "3", "-o", str(path))
        assert done.exit_code == 0
        tables[ending] = path
    (row,) = csv.DictReader(io.StringIO(tables["csv"].read_text()))
    (record,) = records(tables["jsonl"])
    (typed,) = pyarrow.parquet.read_table(tables["parquet"]).to_pylist()
    require_numbers(row, record, typed)


def require_numbers(
    row: Mapping[str, str], record: Mapping[str, Any], typed: Mapping[str, Any]
) -> None:
    for name, value in record.items():
        if name.endswith("area"):
            assert isinstance(value, (int, float))
            assert float(row[name]) == value == typed[name]
        elif isinstance(value, list):
            assert json.loads(row[name]) == value == json.loads(typed[name])
        else:
            assert row[name] == str(value) == str(typed[name])


def test_a_folder_of_drawings_becomes_a_table(tmp_path: Path) -> None:
    drawings = tmp_path / "drawings"
    drawings.mkdir()
    for drawing in every_drawing()[::12]:
        (drawings / drawing.name).write_text(drawing.text, encoding="utf-8", newline="")
    table, square = tmp_path / "out.csv", tmp_path / "square.json"
    square.write_text("[[0,0],[1,0],[1,1],[0,1]]")
    options = ("--flatten", "0.1", "--join", "1e-6", "--compute", "areas", "--round", "2")
    done = run("batch", "--all", str(square), str(drawings), *options, "-o", str(table))
    assert done.exit_code == 0
    rows = list(csv.DictReader(io.StringIO(table.read_text())))
    assert len({row["directrix"].partition("#")[0] for row in rows}) >= 4
    assert all(row["error"] or float(row["area"]) > 0 for row in rows)
    assert sum(bool(row["error"]) for row in rows) == 0


def test_a_module_needs_no_main_guard(tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(
        "from exactsweep import Polygon\n"
        "from exactsweep.batch import Part, take_all_pairs, run\n"
        "part = Part('a', Polygon([(0, 0), (1, 0), (0, 1)]))\n"
        f"print(run(take_all_pairs([part] * 40, [part]), {str(tmp_path / 'out')!r}, workers=2))\n"
    )
    done = subprocess.run([sys.executable, script], capture_output=True, text=True, timeout=600)
    assert (done.returncode, done.stdout) == (0, "Counts(pairs=40, refused=0, resumed=0)\n")
    assert done.stderr == ""
