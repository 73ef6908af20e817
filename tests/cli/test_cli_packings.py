"""`exactsweep layout` on rounded pieces, disc containers, layouts without one, and tables."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from command import run

from exactsweep.check.standalone import load, prove

DISC = {"id": "disc", "pieces": [{"points": [["0", "0"]], "radius": "1"}]}
SLOT = {"id": "slot", "pieces": [{"points": [["0", "0"], ["3", "4"]], "radius": "1"}]}
BLOCK = {
    "id": "block",
    "pieces": [{"points": [["0", "0"], ["2", "0"], ["2", "1"], ["0", "1"]], "radius": "1/2"}],
}
PAIR = {"id": "pair", "pieces": [*DISC["pieces"], {"points": [["3", "0"]], "radius": "1"}]}
TRIANGLE = {"id": "triangle", "exterior": [["0", "0"], ["3", "0"], ["0", "3"]]}
SHEET = {"exterior": [["0", "0"], ["10", "0"], ["10", "10"], ["0", "10"]]}
ROUND = {"pieces": [{"points": [["0", "0"]], "radius": "5"}]}


def put(part: str, x: str, y: str, **more: Any) -> dict[str, Any]:
    return {"part": part, "move": [x, y], **more}


LAYOUTS: dict[str, tuple[Any, dict[str, Any], str]] = {
    "equal discs": ([DISC], {}, "1 overlap"),
    "two discs": ([DISC], {}, "1 overlap"),
    "disc and triangle": ([DISC, TRIANGLE], {"container": SHEET}, "1 overlap"),
    "contact": ([DISC, TRIANGLE], {"container": SHEET}, "valid"),
    "mirrored slot": ([DISC, SLOT], {"container": SHEET}, "2 outside"),
    "margin": ([SLOT, BLOCK], {"container": SHEET, "margin": "1"}, "2 too close"),
    "turned": ([SLOT, BLOCK], {"container": SHEET, "spacing": "1/10"}, "valid"),
    "round container": ([TRIANGLE, DISC], {"container": ROUND}, "1 outside"),
    "round defect": ([TRIANGLE, DISC], {"container": SHEET, "defects": [ROUND]}, "1 outside"),
    "several pieces": ([PAIR], {}, "1 overlap"),
}
PLACEMENTS: dict[str, list[Any]] = {
    "equal discs": [put("disc", "0", "0"), put("disc", "0", "0")],
    "two discs": [put("disc", "0", "0"), put("disc", "1", "1")],
    "disc and triangle": [put("disc", "1", "1"), put("triangle", "1", "199/100")],
    "contact": [put("disc", "1", "1"), put("triangle", "1", "2")],
    "mirrored slot": [put("disc", "1", "1/2"), put("slot", "4", "4", turn="30", mirrored=True)],
    "margin": [put("slot", "1", "1"), put("block", "9/2", "1")],
    "turned": [put("slot", "2", "2", turn="10"), put("block", "6", "2", turn="77.7")],
    "round container": [put("triangle", "0", "0"), put("disc", "-3", "-3")],
    "round defect": [put("triangle", "6", "6"), put("disc", "1", "1")],
    "several pieces": [put("pair", "0", "0"), put("pair", "3/2", "1")],
}


@pytest.mark.parametrize("name", LAYOUTS)
def test_every_report_of_a_packing_is_written(name: str, tmp_path: Path) -> None:
    parts, more, verdict = LAYOUTS[name]
    file = tmp_path / "nest.json"
    file.write_text(json.dumps({"parts": parts, "placements": PLACEMENTS[name], **more}))
    outputs = {kind: tmp_path / f"out.{kind}" for kind in ("svg", "html", "certificate", "repair")}
    given = [word for kind, path in outputs.items() for word in (f"--{kind}", str(path))]
    done = run("layout", str(file), *given)
    assert done.exit_code == (0 if verdict == "valid" else 1), done.output
    assert done.stdout.splitlines()[0].endswith(verdict)
    assert prove(load(outputs["certificate"].read_text()))
    assert "A" in outputs["svg"].read_text()
    assert "<html" in outputs["html"].read_text()
    if verdict == "valid":
        assert f"note: the layout is valid; {outputs['repair']} has it unchanged" in done.stdout
    if verdict == "valid" or "repaired in" in done.stdout:
        assert run("layout", str(outputs["repair"])).exit_code == 0
    data = json.loads(run("layout", str(file), "--json").stdout)
    assert data["valid"] is (verdict == "valid")
    assert data["container"] == ("none" if "container" not in more else "given")


def test_a_layout_without_container_has_its_square_and_length(tmp_path: Path) -> None:
    file = tmp_path / "nest.json"
    placed = [put("disc", "0", "0"), put("disc", "3", "0")]
    file.write_text(json.dumps({"parts": [DISC], "placements": placed}))
    done = run("layout", str(file))
    assert "box         5 x 2, in a square of 5; used length 5\n" in done.stdout
    data = json.loads(run("layout", str(file), "--json").stdout)
    assert (data["square"], data["length"], data["box"]) == ("5", "5", [["-1", "-1"], ["4", "1"]])


def test_tables_of_several_groups_have_a_row_each(tmp_path: Path) -> None:
    table, part = tmp_path / "tiles.csv", tmp_path / "tile.json"
    table.write_text("id,x,y,deg\n1_0,s0,s0,s0\n1_1,s1,s0,s90\n2_0,s0,s0,s0\n2_1,s0.9,s0,s0\n")
    part.write_text('{"exterior": [[0, 0], [1, 0], [1, 1], [0, 1]]}')
    done = run("layout", str(table), "--part", str(part))
    assert done.exit_code == 1
    assert "not valid: 1 overlap" in done.stdout
    assert done.stdout.endswith("0 of 2 valid\n")


def test_turns_in_radians_are_converted(tmp_path: Path) -> None:
    file = tmp_path / "nest.json"
    placed = [put("triangle", "0", "0"), put("triangle", "-0.001", "0", turn="3.14159265")]
    file.write_text(json.dumps({"parts": [TRIANGLE], "placements": placed}))
    assert run("layout", str(file)).exit_code == 1
    assert run("layout", str(file), "--turns-in", "radians").exit_code == 0


def test_a_shrunk_layout_is_written_and_valid(tmp_path: Path) -> None:
    file, smaller = tmp_path / "nest.json", tmp_path / "smaller.json"
    placed = [put("disc", "1", "1"), put("disc", "4", "1")]
    file.write_text(json.dumps({"container": SHEET, "parts": [DISC], "placements": placed}))
    done = run("layout", str(file), "--shrink", str(smaller))
    assert "proved slack: the container can shrink by 0.5 of its size" in done.stdout
    assert "or the parts can grow by 0.5\n" in done.stdout
    assert run("layout", str(smaller)).exit_code == 0
