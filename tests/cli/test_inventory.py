"""Layouts compared with the parts to be placed, of a drawing, a file or a folder."""

import json
from pathlib import Path
from typing import Any

import pytest
from command import run
from drawn_nests import Plate, draw_plates, write_dxf, write_svg
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon, Region
from exactsweep.formats.layouts.congruence import find_congruence
from exactsweep.geometry.turn import read_turn
from exactsweep.numbers.number import Point

PART = Region([(0, 0), (7, 0), (7, 2), (2, 2), (2, 5), (0, 5)], [[(1, 1), (2, 1), (1, "1.5")]])


@examples(60)
@given(
    st.sampled_from([(1, 0), (0, 1), (3, 4), (-5, 12), (-1, 0)]),
    st.booleans(),
    st.tuples(st.integers(-9, 9), st.fractions(-9, 9, max_denominator=7)),
)
def test_moved_parts_are_congruent(
    direction: tuple[int, int], mirrored: bool, move: tuple[Any, Any]
) -> None:
    cosine, sine, _ = read_turn(direction).near()

    def place(p: Point) -> Point:
        x = -p.x if mirrored else p.x
        return Point(cosine * x - sine * p.y + move[0], sine * x + cosine * p.y + move[1])

    exterior, *holes = ([place(p) for p in ring] for ring in PART.rings)
    drawn = Region(exterior, holes)
    found = find_congruence(PART, drawn)
    assert found is not None
    assert (found.exact, found.mirrored) == (True, mirrored)
    assert (found.turn, found.move) == ((cosine, sine), move)


@pytest.mark.parametrize(
    "other",
    [
        Region(PART.exterior),
        Region(PART.exterior, [[(1, 1), (2, 1), (1, "1.6")]]),
        Region([(0, 0), (7, 0), (7, 2), (2, 2), (2, 6), (0, 6)], PART.holes),
        Region(Polygon([(0, 0), (1, 0), (0, 1)])),
    ],
)
def test_other_parts_are_not_congruent(other: Region) -> None:
    found = find_congruence(PART, other)
    assert found is None or not found.exact


def judge(folder: Path, nest: list[Plate], parts: list[Plate], form: str) -> Any:
    path, instance = folder / "nest.svg", folder / f"parts.{form}"
    path.write_text(write_svg(nest))
    write = write_dxf if form == "dxf" else write_svg
    instance.write_text(write(parts, sheet=False))
    done = run("layout", str(path), "--json", "--instance", str(instance))
    assert done.stdout, done.stderr
    return done.exit_code, json.loads(done.stdout)


@pytest.mark.parametrize("form", ["dxf", "svg"])
def test_a_complete_nest_is_valid(form: str, tmp_path: Path) -> None:
    code, found = judge(tmp_path, draw_plates(), draw_plates({3: ("900", "7")}), form)
    assert (code, found["valid"]) == (0, True)


def test_missing_surplus_and_changed_parts_are_faults(tmp_path: Path) -> None:
    plates = draw_plates()
    x, y = plates[6].holes[0][0]
    hole = [(x, y), (x + 5, y), (x, y + 5)]
    nest = [*plates[:6], plates[6]._replace(holes=[hole]), *plates[8:]]
    code, found = judge(tmp_path, nest, [*plates], "dxf")
    faults = {(fault["kind"], fault["part"], fault["number"]) for fault in found["faults"]}
    # The plates with equal holes are one part of the instance, to be placed 10 times each.
    assert code == 1
    assert faults == {
        ("missing", "plate00", 1),
        ("missing", "plate01", 1),
        ("surplus", "plate06", 1),
    }


def test_a_folder_is_an_instance(tmp_path: Path) -> None:
    folder = tmp_path / "parts"
    folder.mkdir()
    for plate in draw_plates():
        (folder / f"{plate.name}.svg").write_text(write_svg([plate], sheet=False))
    path = tmp_path / "nest.dxf"
    path.write_text(write_dxf(draw_plates()[1:]))
    done = run("layout", str(path), "--instance", str(folder))
    assert done.exit_code == 1
    assert "1 missing" in done.stdout


def test_an_unreadable_instance_is_rejected(tmp_path: Path) -> None:
    path = tmp_path / "nest.svg"
    path.write_text(write_svg(draw_plates()))
    instance = tmp_path / "wrong.txt"
    instance.write_text("nothing")
    assert "wrong.txt" in run("layout", str(path), "--instance", str(instance)).stderr
