"""Results in every format, rounded so that they permit no overlap, then read back."""

import json
from pathlib import Path

import pytest
from command import refusal, run

from exactsweep import Region, no_fit_polygon
from exactsweep.cli.parts import report_skipped
from exactsweep.cli.result import _is_safe
from exactsweep.formats import FORMATS, parse_regions, read_region
from exactsweep.formats.candidate import NamedRegion
from exactsweep.formats.rounding import Side, contains

PART = '[["0", "0"], ["1/3", "0"], ["1/3", "2/7"]]'
COMMANDS = ("sweep", "nfp", "ifp")


@pytest.fixture
def files(tmp_path: Path) -> dict[str, str]:
    plate = '{"exterior": [[0,0],[5,0],[5,5],[0,5]], "holes": [[[1,1],["13/6",1],[2,"7/3"]]]}'
    texts = {"part": PART, "plate": plate}
    for name, text in texts.items():
        (tmp_path / f"{name}.json").write_text(text)
    return {name: str(tmp_path / f"{name}.json") for name in texts}


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("command", COMMANDS)
def test_rounded_results_are_read_back(
    command: str, form: str, files: dict[str, str], tmp_path: Path
) -> None:
    pair = (
        (files["part"], files["plate"]) if command == "sweep" else (files["plate"], files["part"])
    )
    if form != "json":
        assert "is not a finite decimal" in refusal(run(command, *pair, "--to", form))
    output = tmp_path / f"result.{form}"
    done = run(command, *pair, "--to", form, "--round", "3", "--round-outward", "-o", str(output))
    assert (done.exit_code, done.stdout) == (0, "")
    assert "rounded: " in done.stderr
    assert done.stderr.endswith(", proved to permit no overlap\n")
    again = run("convert", str(output), "--to", "json")
    assert again.exit_code == 0
    assert "left out" not in again.stderr
    assert parse_regions(again.stdout)


def test_a_rounded_no_fit_polygon_permits_no_overlap(files: dict[str, str]) -> None:
    plate, part = (read_region(files[name]) for name in ("plate", "part"))
    exact = no_fit_polygon(plate, part)
    for places in ("0", "1", "4"):
        options = ("--to", "wkt", "--round", places, "--round-outward")
        done = run("nfp", files["plate"], files["part"], *options)
        (found,) = parse_regions(done.stdout)
        assert contains(found.region, type(plate)(exact.exterior, exact.holes))
    done = run("nfp", files["plate"], files["part"], "--to", "wkt", "--round", "1")
    assert done.stderr.endswith("; it may permit an overlap (--round-outward does not)\n")


@pytest.mark.parametrize(
    ("number", "last"), [(1, "0"), (100, "99"), (101, "1 more"), (103, "3 more")]
)
def test_at_most_a_hundred_omissions_are_listed(
    number: int, last: str, capsys: pytest.CaptureFixture[str]
) -> None:
    report_skipped([*map(str, range(number))])
    lines = capsys.readouterr().err.splitlines()
    assert lines[:100] == [f"skipped: {k}" for k in range(min(number, 100))]
    assert lines[-1] == f"skipped: {last}"


def test_large_outputs_name_the_limit_for_reading_them(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("exactsweep.cli.output.find_needed_mib", lambda size: size)
    sizes = []
    for options in (("--json",), ("--wkt",), ("--to", "csv"), ("--certificate",)):
        note = run("sweep", *options).stderr
        start = "standard output: large file; reading it requires --max-mib "
        assert note.startswith(start)
        sizes.append(int(note.removeprefix(start)))
    assert len(set(sizes)) == 4
    assert run("sweep").stderr == ""


@pytest.mark.parametrize(
    ("side", "safe"), [("closest", "narrower wider"), ("outward", "wider"), ("inward", "narrower")]
)
def test_supersets_are_safe_outward(side: Side, safe: str) -> None:
    exact = [NamedRegion(Region([(0, 0), (4, 0), (4, 4), (0, 4)]))]
    for name, reach in (("narrower", 3), ("wider", 5)):
        rounded = [NamedRegion(Region([(0, 0), (reach, 0), (reach, 4), (0, 4)]))]
        assert _is_safe(exact, rounded, lambda _: side) == (name in safe)


@pytest.mark.parametrize("command", COMMANDS)
def test_the_suffix_of_the_output_selects_the_format(
    command: str, files: dict[str, str], tmp_path: Path
) -> None:
    pair = [str(tmp_path / f"{size}.wkt") for size in (3, 1)]
    for path, size in zip(pair, (3, 1), strict=True):
        Path(path).write_text(f"POLYGON ((0 0, {size} 0, {size} {size}, 0 0))")
    for form in ("svg", "dxf", "wkt", "geojson", "csv"):
        output = tmp_path / f"a.{form.upper()}"
        assert run(command, *pair, "-o", str(output)).exit_code == 0
        assert output.read_text() == run(command, *pair, "--to", form).stdout
        assert parse_regions(output.read_text())
    text = tmp_path / "a.txt"
    assert run(command, *pair, "-o", str(text)).exit_code == 0
    assert text.read_text() == run(command, *pair).stdout


@pytest.mark.parametrize("command", COMMANDS)
def test_all_options_for_json_write_the_same(
    command: str, files: dict[str, str], tmp_path: Path
) -> None:
    pair = files["plate"], files["part"]
    output = tmp_path / "a.json"
    written = run(command, *pair, "--json").stdout
    assert run(command, *pair, "--to", "json").stdout == written
    assert run(command, *pair, "-o", str(output)).exit_code == 0
    assert output.read_text() == written


@pytest.mark.parametrize(
    ("container", "rounding", "reason"),
    [
        ([[0, 0], [2, 0], [2, 1], [0, 1]], [], "Error: the part does not fit"),
        (
            [[0, 0], ["5/2", 0], ["5/2", "9/4"], [0, "9/4"]],
            ["--round", "0", "--round-outward"],
            "Error: rounding to 0 decimal places leaves nothing",
        ),
    ],
)
def test_an_empty_answer_states_its_cause(
    container: list[object], rounding: list[str], reason: str, tmp_path: Path
) -> None:
    files = {"container": container, "part": [[0, 0], [2, 0], [2, 2], [0, 2]]}
    for name, vertices in files.items():
        (tmp_path / name).write_text(json.dumps(vertices))
    paths = [str(tmp_path / name) for name in files]
    assert reason in run("ifp", *paths, "--to", "geojson", *rounding).stderr
