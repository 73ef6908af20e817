"""`exactsweep layout` as a user meets it."""

from __future__ import annotations

import json
import re
from pathlib import Path
from xml.etree import ElementTree

import nests
import pytest
from command import refusal, run

from exactsweep.corpus import find_layout_case, layout_cases


@pytest.fixture
def nest(tmp_path: Path) -> Path:
    for name, (text, instance) in nests.FILES.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
        if instance is not None:
            (tmp_path / f"{name}.instance").write_text(instance, encoding="utf-8")
    return tmp_path


def case_file(folder: Path, slug: str) -> str:
    path = folder / f"{slug}.json"
    path.write_text(json.dumps(find_layout_case(f"layouts-{slug}").data), encoding="utf-8")
    return str(path)


@pytest.mark.parametrize("name", nests.FILES)
def test_each_format_is_judged(nest: Path, name: str) -> None:
    file = str(nest / name)
    given = ["--instance", f"{file}.instance"] if nests.FILES[name][1] else []
    done = run("layout", file, *given)
    assert done.exit_code == 0, done.output
    two = name in ("bins.json", "deepnest.svg")
    assert (
        done.stdout.endswith("2 of 2 valid\n")
        if two
        else done.stdout.startswith("verdict     valid\n")
    )


def test_notes_are_told(nest: Path) -> None:
    done = run("layout", str(nest / "drawn.json"))
    assert done.stdout.endswith(
        "note: without the instance, items are judged as the solution draws them, rounded\n"
    )


def test_spacing_and_margin_are_what_is_asked_for(nest: Path) -> None:
    file = str(nest / "layout.json")
    done = run("layout", file, "--spacing", "0.001")
    assert done.exit_code == 1
    assert "1 too close" in done.stdout
    assert run("layout", file, "--margin", "1e-9").exit_code == 1
    assert "is negative" in run("layout", file, "--spacing", "-1").stderr
    assert run("layout", file, "--spacing", "x").exit_code == 2


def test_the_container_is_chosen(nest: Path) -> None:
    file = str(nest / "drawing.svg")
    assert run("layout", file, "--container", "sheet").exit_code == 0
    done = run("layout", file, "--container", "a")
    assert "2 outside" in done.stdout
    assert "no polygon has the name" in refusal(run("layout", file, "--container", "x"))


def test_everything_is_written(tmp_path: Path) -> None:
    file = case_file(tmp_path, "all-at-once")
    names = "p.html", "p.svg", "proof.json", "out.json"
    page, picture, proof, out = (str(tmp_path / name) for name in names)
    options = "--html", page, "--svg", picture, "--certificate", proof, "--json", "-o", out
    done = run("layout", file, *options)
    assert (done.exit_code, done.stdout) == (1, "")
    assert len(json.loads(Path(out).read_text(encoding="utf-8"))["faults"]) == 5
    text = Path(page).read_text(encoding="utf-8")
    assert text.startswith("<!DOCTYPE html>")
    assert f"<h1>{file}</h1>" in text
    assert ElementTree.parse(picture).getroot().tag.endswith("svg")
    assert run("verify", proof).stdout.startswith("proved\n")


def test_a_drawing_by_svg_is_shown_as_its_viewers_show_it(nest: Path) -> None:
    pictures = []
    for options in ([], ["--y-down"], ["--y-up"]):
        path = nest / "picture"
        run("layout", str(nest / "drawing.svg"), "--svg", str(path), *options)
        pictures.append(path.read_text(encoding="utf-8"))
    assert pictures[0] == pictures[1] != pictures[2]


def test_a_wrong_convention_is_named(tmp_path: Path) -> None:
    data = dict(find_layout_case("layouts-tiles").data)
    data["placements"] = [
        {**one, "move": [int(c) * 10 for c in one["move"]]} for one in data["placements"]
    ]
    file = tmp_path / "ten.json"
    file.write_text(json.dumps(data), encoding="utf-8")
    said = "note: with moves divided by 10, 0 of 5 faults would be left\n"
    assert said in run("layout", str(file)).stdout


def test_folders_are_judged_in_a_table(tmp_path: Path) -> None:
    slugs = ["tiles", "overlap-1e-30", "gap-1e-30"]
    for slug in slugs:
        case_file(tmp_path, slug)
    (tmp_path / "broken.json").write_text("{", encoding="utf-8")
    done = run("layout", str(tmp_path), "--workers", "2")
    assert done.exit_code == 1
    rows = [re.split(r"  +", line) for line in done.stdout.splitlines()]
    assert rows[0] == ["layout", "placements", "verdict", "worst or nearest"]
    assert [Path(row[0]).stem for row in rows[1:5]] == ["broken", *sorted(slugs)]
    assert rows[1][1].startswith(f"{tmp_path}/broken.json: line 1")
    assert rows[2][1:] == ["2", "valid", "1e-30 apart"]
    assert rows[3][1:] == ["2", "not valid: 1 overlap", "1e-30 deep"]
    assert rows[5] == ["2 of 4 valid"]
    data = json.loads(run("layout", str(tmp_path), "--json", "--workers", "1").stdout)
    assert [row["valid"] for row in data] == [None, True, False, True]


def test_pictures_are_of_one_layout(tmp_path: Path) -> None:
    for slug in ("tiles", "plug"):
        case_file(tmp_path, slug)
    done = run("layout", str(tmp_path), "--html", str(tmp_path / "p.html"))
    assert done.exit_code == 2
    assert "for a single layout" in done.stderr


def test_what_is_no_layout_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "file.json"
    file.write_text("[]", encoding="utf-8")
    assert refusal(run("layout", str(file))).startswith(f"{file}: ")
    file.write_text('{"container": {}, "parts": [], "placements": []}', encoding="utf-8")
    assert "container" in refusal(run("layout", str(file)))
    assert "No such file" in refusal(run("layout", str(tmp_path / "none.json")))
    assert run("layout").exit_code == 2


def test_exit_codes_say_whether_layouts_are_valid(tmp_path: Path) -> None:
    for case in [*layout_cases()][::5]:
        file = tmp_path / "case.json"
        file.write_text(json.dumps(case.data), encoding="utf-8")
        assert run("layout", str(file)).exit_code == (not case.expected["valid"])
