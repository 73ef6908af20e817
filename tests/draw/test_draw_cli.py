"""The files of `exactsweep draw`; transcripts/draw.txt has its errors."""

import json
from pathlib import Path

import pytest
from command import HOUSE, NOTCH, run, shell

PLATE = {"exterior": [[0, 0], [5, 0], [5, 5], [0, 5]], "holes": [[[1, 1], [3, 1], [3, 3], [1, 3]]]}
TINY = [["0", "0"], [f"1/{'3' * 500}", "0"], ["0", f"1/{'3' * 500}"]]


@pytest.mark.parametrize(
    ("name", "start", "generatrix", "directrix"),
    [
        ("out.svg", b"<?xml", HOUSE, NOTCH),
        ("out.pdf", b"%PDF", TINY, TINY),
        ("out.png", b"\x89PNG", [[0, 0], [1, 0], [1, 1]], PLATE),
    ],
)
def test_pictures_are_written(
    name: str, start: bytes, generatrix: object, directrix: object, tmp_path: Path
) -> None:
    files = []
    for given in (generatrix, directrix):
        files.append(str(given))
        if not isinstance(given, str):
            files[-1] = str(tmp_path / f"{len(files)}.json")
            Path(files[-1]).write_text(json.dumps(given))
    path = tmp_path / name
    result = run("draw", *files, "-o", str(path), "--position", "-2", "1/2")
    assert (result.exit_code, result.output) == (0, "")
    assert path.read_bytes().startswith(start)


@pytest.mark.long
def test_two_processes_write_the_same_bytes(tmp_path: Path) -> None:
    run("draw", "-o", f"{tmp_path}/a.svg")
    assert shell(f"PYTHONHASHSEED=1 exactsweep draw -o {tmp_path}/b.svg").stderr == ""
    assert (tmp_path / "a.svg").read_bytes() == (tmp_path / "b.svg").read_bytes()
