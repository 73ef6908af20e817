"""Results in every format, rounded so that they surely permit no overlap, and read again."""

import json
from pathlib import Path

import pytest
from command import refusal, run

from exactsweep import no_fit_polygon
from exactsweep.formats import FORMATS, parse_regions, read_region
from exactsweep.formats.rounding import contains

PART = '[["0", "0"], ["1/3", "0"], ["1/3", "2/7"]]'
SLOT = "[[0,0],[3,0],[3,3],[2,3],[2,1],[1,1],[1,3],[0,3]]"
SQUARE = "[[0,0],[1,0],[1,1],[0,1]]"
COMMANDS = ("sweep", "nfp", "ifp")


@pytest.fixture
def files(tmp_path: Path) -> dict[str, str]:
    plate = '{"exterior": [[0,0],[5,0],[5,5],[0,5]], "holes": [[[1,1],["13/6",1],[2,"7/3"]]]}'
    texts = {"part": PART, "plate": plate, "slot": SLOT, "square": SQUARE}
    for name, text in texts.items():
        (tmp_path / f"{name}.json").write_text(text)
    return {name: str(tmp_path / f"{name}.json") for name in texts}


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("command", COMMANDS)
def test_results_leave_rounded_and_are_read_again(
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


def test_exact_fits_leave_with_the_polygons_unless_they_move(files: dict[str, str]) -> None:
    pair = (files["slot"], files["square"])
    kept = run("nfp", *pair, "--to", "wkt", "--round", "1", "--round-outward")
    assert kept.stdout.endswith("LINESTRING (1 3, 1 1)\n")
    assert kept.stderr == ""
    moved = (*pair, "--reference", "1/3", "0", "--round", "1")
    done = run("nfp", *moved, "--to", "wkt", "--round-outward")
    assert "LINESTRING" not in done.stdout
    assert "1 exact fit left out, proved to permit no overlap" in done.stderr
    done = run("nfp", *moved, "--to", "wkt")
    assert "1 exact fit moved; it may permit an overlap" in done.stderr
    for form in FORMATS:
        done = run("nfp", *pair, "--to", form)
        again = run("convert", "-", "--to", "wkt", stdin=done.stdout)
        assert again.exit_code == 0
        assert again.stdout == "POLYGON ((-1 -1, 3 -1, 3 3, -1 3, -1 -1))\n"
        assert again.stderr.count("left out") == (form != "json")


def test_json_that_is_rounded_has_numbers(files: dict[str, str]) -> None:
    done = run("sweep", files["part"], files["slot"], "--json", "--round", "2")
    found = json.loads(done.stdout)["polygons"]
    assert [one["id"] for one in found] == ["trajectory", "inner", "outer"]
    assert all(isinstance(c, (int, float)) for v in found[0]["vertices"] for c in v)


def test_a_report_may_have_all_vertices(files: dict[str, str]) -> None:
    assert " ... 4 more\n" in run("sweep").stdout
    whole = run("sweep", "--all").stdout
    assert "more" not in whole
    assert whole.endswith(" (-2,6)\n")
    long = "[[0,0],[1,0],[1,1e3000]]"
    done = run("sweep", "-", files["square"], stdin=long)
    assert max(map(len, done.stdout.splitlines())) < 400


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--round", "2"), "--round goes with --to FORMAT"),
        (("--round-outward",), "--round-outward goes with --round PLACES"),
        (("--json", "--to", "svg"), "--json and --to exclude each other"),
        (("--certificate", "--round", "2"), "--round goes with --to FORMAT"),
    ],
)
def test_options_that_do_not_go_together(options: tuple[str, ...], message: str) -> None:
    done = run("sweep", *options)
    assert done.exit_code == 2
    assert message in done.stderr


def test_all_pairs_of_several_files_have_no_fit_polygons(files: dict[str, str]) -> None:
    folder = str(Path(files["part"]).parent)
    done = run("nfp", files["plate"], f"{folder}/s*.json")
    head, *rows = done.stdout.splitlines()
    assert head.split()[:2] == ["stationary", "orbiting"]
    assert [row.split()[:2] for row in rows] == [
        ["plate.json", "slot.json"],
        ["plate.json", "square.json"],
    ]
    lines = run("nfp", files["plate"], f"{folder}/s*.json", "--json").stdout.splitlines()
    assert [json.loads(line)["generatrix"] for line in lines] == ["slot.json", "square.json"]
    done = run("nfp", folder, folder, "--to", "json", "--round", "1", "--round-outward")
    found = parse_regions(done.stdout)
    assert len(found) == 16
    assert found[1].name == "plate.json around part.json"
    assert run("nfp", folder, folder, "--certificate").exit_code == 2
