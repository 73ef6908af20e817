"""Tables of placements: columns by name, groups, prefixes, radians, discs."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from mpmath import mp, mpf

from exactsweep.formats import FormatError
from exactsweep.formats.curved.arc import to_degrees
from exactsweep.formats.layouts import read_layouts
from exactsweep.formats.layouts.model import FoundLayout
from exactsweep.formats.layouts.table import is_table
from exactsweep.layout import Layout, judge_layout

TILE = [["0", "0"], ["2", "0"], ["2", "1"], ["0", "1"]]
PART = json.dumps({"parts": [{"id": "tile", "exterior": TILE, "demand": 9}], "placements": []})

Read = Callable[..., list[FoundLayout]]


@pytest.fixture
def read(tmp_path: Path) -> Read:
    def read(table: str, part: str | None = PART, **options: Any) -> list[FoundLayout]:
        place = tmp_path / "table"
        place.write_text(table)
        if part is not None:
            outline = tmp_path / "part.json"
            outline.write_text(part)
            options["part"] = str(outline)
        return read_layouts(str(place), **options)

    return read


def placed(found: FoundLayout) -> list[tuple[str, str, list[str]]]:
    return [(one["part"], one["turn"], one["move"]) for one in found.data["placements"]]


@pytest.mark.parametrize(
    "table",
    [
        "x,y,deg\n1,2.5,90\n",
        "angle;pos_y;pos_x\n90;2,5;1\n",
        "angle;pos_y;pos_x\n90;2.5;1\n",
        "Y\tX\tRotation\n2.5\t1\t90\n",
        "part,x,y,theta\ntile,s1,s2.5,s90\n",
        'name,x,y,turn\n"tile","1"," 2.5",+90\n',
        '[{"part": "tile", "x": 1, "y": 2.5, "angle": 90}]',
        '{"rows": [{"y": "s2.5", "x": "s1", "deg": "s90"}], "title": "one"}',
    ],
)
def test_columns_are_recognized_in_any_order(read: Read, table: str) -> None:
    (found,) = read(table)
    assert placed(found) == [("tile", "90", ["1", "5/2"])]
    assert "demand" not in found.data["parts"][0]


def test_a_table_without_angles_is_read_with_a_part(read: Read) -> None:
    (found,) = read("id,x,y\n7,1,2\n8,5,2\n")
    assert placed(found) == [("tile", "0", ["1", "2"]), ("tile", "0", ["5", "2"])]
    assert found.places == ("line 2", "line 3")
    assert judge_layout(Layout.from_json(found.data)).valid


@pytest.mark.parametrize(
    ("table", "names"),
    [
        ("id,x,y,deg\n001_0,0,0,0\n002_0,0,0,0\n002_1,3,0,0\n", ["001", "002"]),
        ("n,x,y,deg\n4,0,0,0\n2,0,0,0\n4,3,0,0\n", ["4", "2"]),
        ("n,x,y,deg\n0,0,0,0\n1,0,0,0\n2,3,0,0\n", [""]),
        ("n,x,y,deg\n3,0,0,0\n3,0,0,0\n3,3,0,0\n", [""]),
        ("id,x,y,deg\na,0,0,0\nb_1,0,0,0\nb_2,0,0,0\n", [""]),
    ],
)
def test_groups_are_layouts(read: Read, table: str, names: list[str]) -> None:
    assert [found.name for found in read(table)] == names


def test_radians_are_converted(read: Read) -> None:
    (found,) = read("x,y,angle\n0,0,3.14159265358979\n", radians=True)
    assert abs(Fraction(found.data["placements"][0]["turn"]) - 180) < Fraction(1, 10**12)
    (same,) = read("x,y,rad\n0,0,3.14159265358979\n")
    assert same.data["placements"] == found.data["placements"]
    assert found.notes == same.notes == ("1 row of placements, angles in radians",)


def test_mirrored_placements_are_read(read: Read) -> None:
    (found,) = read("x,y,angle,flipped\n0,0,0,true\n0,0,0,0\n")
    assert [one.get("mirrored", False) for one in found.data["placements"]] == [True, False]


def test_a_table_of_radii_has_discs(read: Read) -> None:
    (found,) = read("x,y,r\n0,0,1\n2,0,1\n1,5,1.5\n", part=None)
    judgement = judge_layout(Layout.from_json(found.data))
    assert judgement.valid
    assert judgement.contacts == ((0, 1),)
    assert len(found.data["parts"]) == 2


def test_parts_are_chosen_by_name(read: Read) -> None:
    svg = '<svg><path id="a" d="M0 0h1v1z"/><circle id="b" r="2"/></svg>'
    (found,) = read("part,x,y\nb,0,0\na,9,9\n", part=svg)
    assert [one["id"] for one in found.data["parts"]] == ["b", "a"]
    assert found.data["parts"][0]["pieces"][0]["radius"] == "2"


@pytest.mark.parametrize(
    ("table", "part", "message"),
    [
        ("x,y,deg\n0,0,0\n", None, "--part FILE reads the outlines of its parts"),
        ("x,y,deg\n0,zero,0\n", PART, "line 2: y"),
        ('x,y,deg\n"0,5",0,0\n', PART, "line 2: x: '0,5' is not a decimal number"),
        ("x,y,deg\n0,0\n", PART, "line 2: 2 cells, expected 3"),
        ("x,deg\n0,0\n", PART, "has no column y"),
        ("x,y,cx\n0,0,0\n", PART, "two columns for x: 'x', 'cx'"),
        ("x,y,deg,rad\n0,0,0,0\n", PART, "two columns of angles, in degrees and in radians"),
        ("x,y,deg\n", PART, "the table has no rows"),
        ("part,x,y\nother,0,0\n", PART, "line 2: unknown part 'other'; choose from 'tile'"),
        ("x,y,flip\n0,0,maybe\n", PART, "line 2: mirrored: 'maybe' is neither true nor false"),
        ("x,y\n0,0\n", '{"parts": [], "placements": []}', "reads the outlines of its parts"),
    ],
)
def test_unreadable_tables_are_rejected_with_the_line(
    read: Read, table: str, part: str | None, message: str
) -> None:
    with pytest.raises(FormatError) as error:
        read(table, part)
    assert message in str(error.value)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("n,x,y,deg\n3,0.27,-0.24,109.7\n", True),
        ("x,y,r\n1,2,3\n", True),
        ("name,x,y\na,0,0\n", False),
        ("0 0\n1 0\n1 1\n", False),
        ("<svg/>", False),
        ('[{"x": 0, "y": 0}, {"x": 1, "y": 0}, {"x": 0, "y": 1}]', False),
        ("[[0, 0], [1, 0], [0, 1]]", False),
        ("", False),
    ],
)
def test_vertices_are_not_placements(text: str, expected: bool) -> None:
    assert is_table(text) is expected


def test_conversion_of_radians_is_within_the_slack_of_verdicts() -> None:
    with mp.workdps(300):
        for text in ("1", "-2.5", "1e-30", "3.14159265358979323846264338327950288", "999999.5"):
            true = mpf(text) * 180 / mp.pi
            found = to_degrees(Fraction(text))
            near = mpf(found.numerator) / found.denominator
            assert abs(near - true) <= mpf(10) ** -100


@pytest.mark.parametrize("digits", [50, 101, 150, 230])
@pytest.mark.parametrize("quarters", [1, 2, 7])
def test_rounded_radians_never_make_a_right_angle(digits: int, quarters: int) -> None:
    with mp.workdps(digits + 9):
        radians = Fraction(mp.nstr(mp.pi * quarters / 2, digits))
    degrees = to_degrees(radians)
    assert degrees % 90 != 0
    assert abs(degrees - 90 * quarters) < Fraction(1, 10 ** (digits - 4))
    assert to_degrees(Fraction(0)) == 0


def test_allowed_rotations_are_also_in_radians(read: Read) -> None:
    layout = {
        "parts": [{"id": "tile", "exterior": TILE, "turns": ["0", "1.5"], "mirrored_turns": ["1"]}],
        "placements": [
            {"part": "tile", "turn": "1.5", "move": ["0", "0"]},
            {"part": "tile", "turn": "1", "mirrored": True, "move": ["9", "0"]},
            {"part": "tile", "turn": ["3/5", "4/5"], "move": ["0", "9"]},
        ],
    }
    (found,) = read(json.dumps(layout), part=None, radians=True)
    judgement = judge_layout(Layout.from_json(found.data))
    assert [(fault.kind, fault.placements) for fault in judgement.faults] == [("turn", (2,))]


def test_a_group_is_one_rigid_part(tmp_path: Path) -> None:
    """The outlines of a group keep their distance, and overlap those of other placements."""
    drawing, table = tmp_path / "parts.svg", tmp_path / "table.csv"
    drawing.write_text(
        '<svg><g id="pair"><path fill-rule="evenodd" d="M0 0H4V4H0z M1 1H2V2H1z"/>'
        '<rect x="5" width="1" height="4"/></g></svg>'
    )

    def judge(second: str) -> bool | None:
        table.write_text(f"part,x,y,angle\npair,0,0,0\npair,{second}\n")
        (found,) = read_layouts(str(table), part=f"{drawing}#pair")
        (part,) = found.data["parts"]
        assert part["id"] == "pair"
        assert all(set(piece) == {"points"} for piece in part["pieces"])
        return judge_layout(Layout.from_json(found.data)).valid

    # An instance has no groups.
    table.write_text("part,x,y,angle\npair,0,0,0\n")
    (found,) = read_layouts(str(table), part=f"{drawing}#pair", instance=str(drawing))
    assert "part 'pair' is not in the instance" in found.notes
    assert judge("6,0,0") == judge("-6,0,0") is True
    assert judge("5,0,0") == judge("4,0,0") is False
