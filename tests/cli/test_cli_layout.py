"""`exactsweep layout`, run as users run it."""

from __future__ import annotations

import json
from pathlib import Path
from xml.etree import ElementTree

import nests
import pytest
from command import run

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


def test_notes_are_reported(nest: Path) -> None:
    done = run("layout", str(nest / "drawn.json"))
    assert done.stdout.endswith(
        "note: without the instance, items are judged as the solution draws them, rounded\n"
    )


def test_notes_of_several_files_are_reported(nest: Path) -> None:
    files = [str(nest / name) for name in ("drawn.json", "svgnest.svg")]
    note = "without the instance, items are judged as the solution draws them, rounded"
    done = run("layout", *files, "--workers", "1")
    assert done.stdout.endswith(f"note: {files[0]}: {note}\n2 of 2 valid\n")
    found = json.loads(run("layout", *files, "--json").stdout)
    assert [row["notes"] for row in found] == [[note], []]


def test_several_sheets_are_read_from_standard_input(nest: Path) -> None:
    text = (nest / "deepnest.svg").read_text(encoding="utf-8")
    done = run("layout", "-", stdin=text)
    assert done.stdout.endswith("2 of 2 valid\n")
    for other in ("-", str(nest / "sparrow.json")):
        done = run("layout", "-", other, stdin=text)
        assert done.exit_code == 2
        assert "cannot be combined with other files" in done.stderr


def test_all_outputs_are_written(tmp_path: Path) -> None:
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
    assert run("verify", proof).stdout.startswith(f"{proof}: proved\n")


def test_an_svg_layout_is_shown_with_y_down(nest: Path) -> None:
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
    note = "note: with translations divided by 10, 0 of 5 faults remain\n"
    assert note in run("layout", str(file)).stdout


def test_exit_codes_state_whether_layouts_are_valid(tmp_path: Path) -> None:
    for case in [*layout_cases()][::5]:
        file = tmp_path / "case.json"
        file.write_text(json.dumps(case.data), encoding="utf-8")
        assert run("layout", str(file)).exit_code == (not case.expected["valid"])


def test_names_of_parts_are_written_on_one_line_without_control_characters(tmp_path: Path) -> None:
    data = find_layout_case("layouts-all-at-once").data
    text = json.dumps(data)
    for part in data["parts"]:
        text = text.replace(json.dumps(part["id"]), json.dumps(f"\ud800\x1b[31m\n{part['id']}"))
    file, page = tmp_path / "names.json", tmp_path / "page.html"
    file.write_text(text, encoding="utf-8")
    done = run("layout", str(file), "--html", str(page))
    assert (done.exit_code, done.stderr) == (1, "")
    assert "part \\ud800\\x1b[31m\\n" in done.stdout
    assert "\\ud800\\x1b[31m\\n" in page.read_text(encoding="utf-8")


def test_a_layout_without_proof_is_still_reported(tmp_path: Path) -> None:
    data = find_layout_case("layouts-all-at-once").data
    two = [{"id": "a", "exterior": [["0", "0"], ["1", "0"], ["2", "0"]]}]
    file, proof = tmp_path / "two.json", tmp_path / "proof.json"
    file.write_text(json.dumps({**data, "parts": two, "placements": []}), encoding="utf-8")
    done = run("layout", str(file), "--certificate", str(proof))
    assert done.exit_code == 1
    assert done.stdout.startswith("verdict     not valid: 1 shape\n")
    assert done.stderr.startswith(f"{file}: no fault of the layout can be proved")
    assert not proof.exists()


def test_errors_name_the_file(tmp_path: Path) -> None:
    file = tmp_path / "nest.json"
    data = find_layout_case("layouts-all-at-once").data
    file.write_text(json.dumps({**data, "spacing": "-1"}), encoding="utf-8")
    done = run("layout", str(file))
    assert done.stderr == f"Error: {file}: spacing is negative: -1\n"


@pytest.mark.parametrize(
    ("options", "reason"),
    [
        (["--html", "out", "--svg", "out"], "All outputs must be different files."),
        (["--repair", "out", "-o", "./out"], "All outputs must be different files."),
        (["--html", "-"], "Only one report can be written to standard output."),
    ],
)
def test_two_outputs_need_two_files(options: list[str], reason: str, tmp_path: Path) -> None:
    path = tmp_path / "nest.json"
    path.write_text("{}")
    done = run("layout", str(path), *options)
    assert done.exit_code == 2
    assert reason in done.stderr
