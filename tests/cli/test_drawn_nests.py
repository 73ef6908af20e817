"""Nests drawn as DXF and SVG: verdicts, names and depths match the drawing."""

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from command import run
from drawn_nests import Plate, draw_plates, write_dxf, write_svg

WRITERS = {"dxf": write_dxf, "svg": write_svg}
DEPTHS = ["1e-9", "0.000001", "0.001", "0.1", "0.5", "1", "2.5", "5"]


def judge(folder: Path, form: str, plates: list[Plate], *options: str, **drawn: Any) -> Any:
    """Judge a nest by the command, as JSON, with its exit code."""
    path = folder / f"nest.{form}"
    path.write_text(WRITERS[form](plates, **drawn))
    done = run("layout", str(path), "--json", *options)
    return done.exit_code, json.loads(done.stdout)


@pytest.mark.parametrize("form", WRITERS)
def test_a_correct_nest_is_valid(form: str, tmp_path: Path) -> None:
    code, found = judge(tmp_path, form, draw_plates())
    assert (code, found["valid"], found["unchecked"], found["unit"]) == (0, True, [], "mm")
    assert found["distance_squared"] == "4"
    # 10 plates have one hole of 27, 10 another one of 56.25.
    area = 20 * 600 - 20 * 27 - 10 * Fraction("56.25")
    assert Fraction(found["density"]) == area / (162 * 90)
    assert found["notes"][0].startswith("30 outlines inside others read as holes, not as parts")


@pytest.mark.parametrize("form", WRITERS)
def test_touching_plates_are_valid(form: str, tmp_path: Path) -> None:
    code, found = judge(tmp_path, form, draw_plates({7: ("2", "0"), 8: ("0", "2")}))
    assert (code, found["valid"]) == (0, True)
    assert found["contacts"] == [[7, 8], [8, 13]]


@pytest.mark.parametrize("depth", DEPTHS)
@pytest.mark.parametrize("form", WRITERS)
def test_overlapping_plates_are_named_with_their_depth(
    form: str, depth: str, tmp_path: Path
) -> None:
    moved = f"{2 + float(Fraction(depth)):.10f}"
    code, found = judge(tmp_path, form, draw_plates({11: (moved, "0")}))
    (fault,) = found["faults"]
    assert (code, fault["kind"], fault["placements"]) == (1, "overlap", [11, 12])
    assert fault["parts"] == ["plate11", "plate12"]
    assert Fraction(fault["depth_squared"]) == Fraction(depth) ** 2
    assert [Fraction(x) for x in fault["move"]] == [Fraction(depth), 0]
    assert all(place.startswith("line ") for place in fault["places"])
    accepted, _ = judge(tmp_path, form, draw_plates({11: (moved, "0")}), "--accept", "1e-6")
    assert accepted == (0 if Fraction(depth) <= Fraction("1e-6") else 1)


@pytest.mark.parametrize("depth", DEPTHS[::2])
@pytest.mark.parametrize("form", WRITERS)
def test_a_plate_that_sticks_out_is_named(form: str, depth: str, tmp_path: Path) -> None:
    moved = f"{-2 - float(Fraction(depth)):.10f}"
    code, found = judge(tmp_path, form, draw_plates({5: (moved, "0")}))
    (fault,) = found["faults"]
    assert (code, fault["kind"], fault["parts"]) == (1, "outside", ["plate05"])
    assert Fraction(fault["depth_squared"]) == Fraction(depth) ** 2
    assert [Fraction(x) for x in fault["move"]] == [Fraction(depth), 0]


@pytest.mark.parametrize("form", WRITERS)
def test_engraving_does_not_stop_a_verdict(form: str, tmp_path: Path) -> None:
    code, found = judge(tmp_path, form, draw_plates(), engraved=True)
    assert (code, found["valid"]) == (0, True)
    assert found["unchecked"] == ["1 shape on the layer 'engrave', none of them closed"]
    assert judge(tmp_path, form, draw_plates(), "--strict", engraved=True)[0] == 3
    code, found = judge(
        tmp_path, form, draw_plates(), "--strict", "--ignore-layer", "ENGRAVE", engraved=True
    )
    assert (code, found["unchecked"]) == (0, [])


def test_engraving_on_parts_of_its_own_layer_does_not_stop_a_verdict(tmp_path: Path) -> None:
    layer = 'inkscape:groupmode="layer" inkscape:label'
    drawn = write_svg(draw_plates(), engraved=True).replace(layer, "id")
    path = tmp_path / "nest.svg"

    def run_on(text: str, *options: str) -> tuple[int, str, str]:
        path.write_text(text)
        done = run("layout", str(path), *options)
        return done.exit_code, done.stdout.partition("\n")[0], done.stderr

    code, verdict, _ = run_on(drawn)
    assert code == 0
    assert verdict == "verdict     valid, but not judged: 1 open shape on parts (line 56)"
    code, verdict, _ = run_on(drawn, "--strict", "--ignore-layer", "engrave")
    assert (code, verdict) == (0, "verdict     valid")
    # Between the parts, an open line may be a part.
    code, _, error = run_on(drawn.replace("4,12 8,18", "1,12 8,18"))
    assert code == 1
    assert "open end at (1,12)" in error
    assert "(--ignore-layer engrave skips its layer)" in error


@pytest.mark.parametrize("form", WRITERS)
def test_a_layer_alone_is_judged(form: str, tmp_path: Path) -> None:
    layers = ["sheet", "plate03", "Plate04"] if form == "dxf" else ["CUT"]
    options = [word for layer in layers for word in ("--layer", layer)]
    code, found = judge(tmp_path, form, draw_plates(), *options, engraved=True)
    assert (code, found["valid"], found["unchecked"]) == (0, True, [])


@pytest.mark.long
@pytest.mark.parametrize("form", WRITERS)
def test_flat_outlines_are_parts(form: str, tmp_path: Path) -> None:
    code, found = judge(tmp_path, form, draw_plates(), "--flat")
    assert (code, len(found["faults"])) == (1, 30)


@pytest.mark.parametrize("form", WRITERS)
def test_a_part_inside_a_hole_is_a_part(form: str, tmp_path: Path) -> None:
    plates = draw_plates()
    x, y = plates[0].holes[0][0]
    small = Plate("small", [(x + 1, y + 1), (x + 3, y + 1), (x + 3, y + 3), (x + 1, y + 3)], [])
    code, found = judge(tmp_path, form, [*plates, small])
    assert (code, found["valid"], found["distance_squared"]) == (0, True, "1")
    # Inside the material, it looks like a hole but has the size of a part.
    x += 10
    other = Plate("other", [(x, y), (x + 2, y), (x + 2, y + 2), (x, y + 2)], [])
    code, found = judge(tmp_path, form, [*plates, small, other])
    assert code == 0
    (unchecked,) = found["unchecked"]
    assert "or a part on it: it has the size of the part" in unchecked


@pytest.mark.parametrize("form", WRITERS)
def test_two_plates_at_one_place_overlap(form: str, tmp_path: Path) -> None:
    plates = draw_plates()
    code, found = judge(tmp_path, form, [*plates, plates[4]._replace(name="copy")])
    (fault,) = found["faults"]
    assert (code, fault["kind"], fault["parts"]) == (1, "overlap", ["plate04", "copy"])


@pytest.mark.parametrize("form", WRITERS)
def test_without_a_container_the_parts_are_judged(form: str, tmp_path: Path) -> None:
    moved = {5: ("-3", "0"), 11: ("3", "0")}
    code, found = judge(tmp_path, form, draw_plates(moved), "--no-container", sheet=False)
    (fault,) = found["faults"]
    assert (code, fault["placements"]) == (1, [11, 12])
    assert found["box"] == [["-1", "2"], ["160", "88"]]


@pytest.mark.parametrize("form", WRITERS)
def test_a_missing_container_is_an_error(form: str, tmp_path: Path) -> None:
    path = tmp_path / f"nest.{form}"
    path.write_text(WRITERS[form](draw_plates(), sheet=False))
    done = run("layout", str(path))
    assert done.exit_code == 1
    assert "no outline contains all others; name the container (--container)" in done.stderr
    assert "30 x 20" in done.stderr
