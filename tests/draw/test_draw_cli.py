"""`exactsweep draw`."""

import json
from pathlib import Path

import pytest
from command import HOUSE, NOTCH, refusal, run, shell


def test_a_picture_is_written(tmp_path: Path) -> None:
    path = tmp_path / "out.svg"
    result = run("draw", HOUSE, NOTCH, "-o", str(path), "--position", "-2", "1/2")
    assert (result.exit_code, result.output) == (0, "")
    assert path.read_bytes().startswith(b"<?xml")


@pytest.mark.parametrize(
    ("name", "named"),
    [
        ("out.jpg", "the suffix '.jpg', but a picture is one of .svg, .pdf, .png"),
        ("out", "no suffix, but"),
        ("-", "no suffix, but"),
        ("a.svg.\u202egnp", r"the suffix '.\u202egnp', but"),
        ("a\nb.txt", r"'a\nb.txt': the suffix '.txt', but"),
    ],
)
def test_an_unknown_suffix_is_refused_by_name(name: str, named: str) -> None:
    result = run("draw", "-o", name)
    assert result.exit_code == 2
    assert named in result.stderr


def test_a_polygon_that_is_refused_leaves_no_file(tmp_path: Path) -> None:
    path = tmp_path / "out.svg"
    result = run("draw", "-", NOTCH, "-o", str(path), stdin="[[0, 0], [1, 0]]")
    assert "standard input: " in refusal(result)
    assert not path.exists()


def test_500_digit_fractions_are_drawn(tmp_path: Path) -> None:
    path, polygon = tmp_path / "out.pdf", tmp_path / "g.json"
    tiny = f"1/{'3' * 500}"
    polygon.write_text(json.dumps([["0", "0"], [tiny, "0"], ["0", tiny]]))
    assert run("draw", str(polygon), str(polygon), "-o", str(path)).exit_code == 0
    assert path.read_bytes().startswith(b"%PDF")


def test_two_processes_write_the_same_bytes(tmp_path: Path) -> None:
    run("draw", "-o", f"{tmp_path}/a.svg")
    assert shell(f"PYTHONHASHSEED=1 exactsweep draw -o {tmp_path}/b.svg").stderr == ""
    assert (tmp_path / "a.svg").read_bytes() == (tmp_path / "b.svg").read_bytes()


def test_a_sweep_of_any_shape_is_drawn(tmp_path: Path) -> None:
    parts = tmp_path / "plate.json"
    parts.write_text(json.dumps({"exterior": [[0, 0], [5, 0], [5, 5], [0, 5]],
                                 "holes": [[[1, 1], [3, 1], [3, 3], [1, 3]]]}))  # fmt: skip
    output = tmp_path / "out.png"
    result = run(
        "draw", "-", str(parts), "-o", str(output), stdin="[[0, 0], [1, 0], [1, 1], [0, 1]]"
    )
    assert (result.exit_code, result.output) == (0, "")
    assert output.read_bytes().startswith(b"\x89PNG")
