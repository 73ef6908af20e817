"""Layouts as nesting programs write them: one layout, written by hand in each format."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import nests
import pytest

from exactsweep.formats import FormatError, format_polygons, parse_regions
from exactsweep.formats.layouts import FoundLayout, parse_layouts, read_layout, read_layouts
from exactsweep.numbers.error import ExactSweepError

SVG = '<svg xmlns="http://www.w3.org/2000/svg">{}</svg>'


def read(text: object, instance: object = None, **options: Any) -> list[FoundLayout]:
    given = None if instance is None else write(instance)
    return parse_layouts(write(text), instance=given, **options)


def write(document: object) -> str:
    return document if isinstance(document, str) else json.dumps(document)


def refusal(text: object, instance: object = None, **options: Any) -> str:
    with pytest.raises(FormatError) as raised:
        read(text, instance, **options)
    return str(raised.value)


def corners(layout: dict[str, Any]) -> list[set[tuple[Fraction, Fraction]]]:
    """The corners of each placement, for quarter turns only."""
    rings = {part["id"]: part["exterior"] for part in layout["parts"]}
    found = []
    for placement in layout["placements"]:
        quarters = Fraction(placement["turn"]) / 90 % 4
        assert quarters.denominator == 1
        points = set()
        for corner in rings[placement["part"]]:
            x, y = map(Fraction, map(str, corner))
            if placement.get("mirrored"):
                x = -x
            for _ in range(int(quarters)):
                x, y = -y, x
            move = [Fraction(str(c)) for c in placement["move"]]
            points.add((x + move[0], y + move[1]))
        found.append(points)
    return found


@pytest.mark.parametrize("name", nests.FILES)
def test_one_layout_is_read_from_each_format(name: str) -> None:
    found = read(*nests.FILES[name])
    one = {(Fraction(x), Fraction(y)) for x, y in nests.L}
    other = {(4 - x, 3 - y) for x, y in one}
    assert [shape for layout in found for shape in corners(layout.data)] == [one, other]
    for layout in found:
        box = {tuple(Fraction(str(c)) for c in p) for p in layout.data["container"]["exterior"]}
        assert box == {(Fraction(x), Fraction(y)) for x, y in nests.BOX}
    assert len(found) == (2 if name in ("bins.json", "deepnest.svg") else 1)


def test_what_is_allowed_comes_from_the_instance() -> None:
    for name in ("sparrow.json", "sparrow.svg", "packing.json"):
        (found,) = read(*nests.FILES[name])
        (part,) = found.data["parts"]
        assert part["demand"] == 2
        assert [Fraction(turn) for turn in part["turns"]] == [0, 180]
        assert part["mirrored"] is False
    (found,) = read(*nests.FILES["spyrrow.json"])
    assert "turns" not in found.data["parts"][0]
    (found,) = read(*nests.FILES["cgshop.json"])
    # Of three that may be placed there is one, and none has to be.
    assert [part["demand"] for part in found.data["parts"]] == [1, 1]
    (found,) = read(nests.SVGNEST_SVG)
    assert "demand" not in found.data["parts"][0]


def test_several_sheets_share_one_demand(tmp_path: Path) -> None:
    first, second = read(nests.BINS)
    assert (first.name, second.name) == ("sheet 0", "sheet 1")
    assert [layout.data["parts"][0]["demand"] for layout in (first, second)] == [1, 1]
    for demand, asked in ((1, [1, 0]), (3, [1, 2])):
        data = copy.deepcopy(nests.BINS)
        data["items"][0]["demand"] = demand
        found = read(data)
        assert [layout.data["parts"][0]["demand"] for layout in found] == asked
    data = copy.deepcopy(nests.PACKING_SOLUTION)
    data["bins"][0]["copies"] = 2
    # Two bins of two items each, of which only two are there.
    (found,) = [one.data["parts"][0] for one in read(data, nests.PACKING)]
    assert found["demand"] == 1
    (copies,) = read(data, json.dumps(nests.PACKING).replace('"copies": 2', '"copies": 4'))
    assert copies.data["parts"][0]["demand"] == 2


def test_what_is_passed_over_is_told() -> None:
    for layout in read(nests.BINS):
        assert layout.notes == (
            "item 0: its least quality is not looked at",
            "$.bins[0].zones[1]: a zone of quality 2 is not looked at",
        )
        assert layout.data["container"]["holes"] == [[["2", "2"], ["3", "2"], ["2", "1"]]]
    (found,) = read(*nests.FILES["packing.json"])
    assert found.notes == ("$.bin_types[0].defects[0]: its own spacing, 1, is not looked at",)
    (found,) = read(*nests.FILES["drawn.json"])
    assert found.notes == (
        "without the instance, items are judged as the solution draws them, rounded",
    )
    data = copy.deepcopy(nests.SPARROW)
    data["items"][0]["shape"]["data"] = [*nests.L[2:], *nests.L[:3]]
    assert read(nests.SPARROW_SVG, data)[0].notes == ()
    data["items"][0]["shape"]["data"] = [[0, 0], [3, 0], [0, 3]]
    (found,) = read(nests.SPARROW_SVG, data)
    assert found.notes == ("part 0 is drawn otherwise than in the instance, which counts",)
    assert found.data["parts"][0]["exterior"] == [["0", "0"], ["3", "0"], ["0", "3"]]


def test_numbers_stay_as_they_are_written() -> None:
    text = json.dumps(nests.SPARROW).replace("180.0}", "159.31944436399348}")
    text = json.dumps(nests.SPARROW).replace('"rotation": 180.0', '"rotation": 159.31944436399348')
    (found,) = read(text.replace("[4, 3]", "[4.00000000000000000001, 3e0]"))
    assert found.data["placements"][1] == {
        "part": "0",
        "turn": "159.31944436399348",
        "move": ["4.00000000000000000001", "3e0"],
    }
    turned = nests.SVGNEST_SVG.replace("rotate(180)", "rotate(22.5)")
    (found,) = read(turned)
    assert found.data["placements"][1]["turn"] == "45/2"


def test_packingsolver_mirrors_and_flattens() -> None:
    item: dict[str, Any] = {"type": "circle", "radius": 1, "allow_mirroring": True}
    instance = {**nests.PACKING, "item_types": [item], "objective": "Knapsack"}
    data = copy.deepcopy(nests.PACKING_SOLUTION)
    data["bins"][0]["items"][0]["mirror"] = True
    assert "--flatten" in refusal(data, instance)
    (found,) = read(data, instance, tolerance=Fraction(1, 10))
    (part,) = found.data["parts"]
    assert len(part["exterior"]) > 4
    assert "mirrored" not in part
    assert part["turns"] == ["0"]
    assert [placed.get("mirrored") for placed in found.data["placements"]] == [True, None]
    item["allowed_rotations"] = [{"start": 0, "end": 359.5}]
    (found,) = read(data, instance, tolerance=Fraction(1, 10))
    assert "turns" not in found.data["parts"][0]
    assert found.notes[0] == "$.item_types[0]: whether turns are in its ranges is not looked at"
    item["allowed_rotations"] = [{"start": 0, "end": 360}]
    (found,) = read(data, instance, tolerance=Fraction(1, 10))
    assert "turns" not in found.data["parts"][0]
    assert len(found.notes) == 1


def test_margins_and_spacing_of_packingsolver() -> None:
    text = json.dumps(nests.PACKING)
    text = text.replace('"item_bin_minimum_spacing": 0', '"item_bin_minimum_spacing": 1')
    text = text.replace('"item_item_minimum_spacing": 0', '"item_item_minimum_spacing": 0.5')
    (found,) = read(nests.PACKING_SOLUTION, text)
    assert (found.data["spacing"], found.data["margin"]) == ("0.5", "1")
    assert not found.notes


def test_a_part_with_holes_of_a_nest() -> None:
    # Deepnest puts the outlines of a part beside each other into its group.
    ring = '<rect width="3" height="3"/><rect x="1" y="1" width="1" height="1"/>'
    sheet = '<rect class="bin" width="9" height="9"/>'
    (found,) = read(SVG.format(f'{sheet}<g transform="translate(1)">{ring}</g>'))
    (part,) = found.data["parts"]
    assert part["holes"] == [[["1", "1"], ["2", "1"], ["2", "2"], ["1", "2"]]]
    two = '<rect width="3" height="3"/><rect x="5" y="1" width="1" height="1"/>'
    said = refusal(SVG.format(f'{sheet}<g transform="translate(1)">{two}</g>'))
    assert said == "line 1, 1: 2 outlines, which are not one part"


def test_the_container_of_a_drawing() -> None:
    (found,) = read(nests.DRAWING_SVG, container="sheet")
    assert [part["id"] for part in found.data["parts"]] == ["a", "b"]
    assert [part["id"] for part in read(nests.DRAWING_SVG)[0].data["parts"]] == ["a", "b"]
    (found,) = read(nests.DRAWING_SVG, container="a")
    assert [part["id"] for part in found.data["parts"]] == ["sheet", "b"]
    assert "no polygon has the name" in refusal(nests.DRAWING_SVG, container="c")
    none = nests.DRAWING_SVG.replace('id="sheet" width="4"', 'id="sheet" width="2"')
    said = "no outline is around all others; name the container (--container)"
    assert refusal(none) == said
    # A container that is named makes a drawing of any file.
    (found,) = read(nests.SVGNEST_SVG, container="0")
    assert len(found.data["parts"]) == 2


def test_zones_of_quality_are_read_from_the_instance() -> None:
    zone = '<g id="quality_zones"><path d="M2 1L3 2H2z"/></g>'
    drawn = nests.SPARROW_SVG.replace('<g id="quality_zones"/>', zone)
    assert refusal(drawn) == "line 7: zones of quality are read with --instance only"
    (found,) = read(drawn, nests.BINS)
    assert len(found.data["container"]["holes"]) == 1


def test_a_drawing_of_dxf() -> None:
    regions = parse_regions(nests.DRAWING_SVG)
    (found,) = read(format_polygons(regions, "dxf"))
    assert len(found.data["parts"]) == 2


def test_a_drawing_leaves_out_what_is_no_outline_and_keeps_crossings() -> None:
    crossed = '<path id="eight" d="M1 1L2 2H1L2 1z"/><circle r="1"/></svg>'
    (found,) = read(nests.DRAWING_SVG.replace("</svg>", crossed))
    assert [part["id"] for part in found.data["parts"]] == ["a", "b", "eight"]
    assert len(found.notes) == 1
    assert found.notes[0].startswith("left out: line 4: circle: a curve")


def test_nested_outlines_of_a_drawing_are_holes_but_for_the_container() -> None:
    text = json.dumps([[[0, 0], [k, 0], [k, k], [0, k]] for k in (9, 5, 2)])
    assert len(read(text)[0].data["parts"]) == 2
    (part,) = read(text, nested=True)[0].data["parts"]
    assert len(part["holes"]) == 1


@pytest.mark.parametrize(
    ("text", "instance", "said"),
    [
        (nests.SPYRROW_SOLUTION, None, "a solution without its items, which its instance"),
        (nests.CGSHOP_SOLUTION, None, "a solution without its polygons, which its instance"),
        (nests.CGSHOP_SOLUTION, nests.SPYRROW, "a solution without its polygons"),
        (nests.SPYRROW, None, "an instance without a solution: nothing is placed"),
        (nests.PACKING, None, "an instance without a solution: nothing is placed"),
        (nests.SPYRROW_SOLUTION, nests.LAYOUT, "not an instance of a nesting program"),
        (nests.DRAWING_SVG, nests.SPYRROW, "not a solution to an instance"),
        (
            {**nests.SPYRROW_SOLUTION, "placed_items": [{"id": "M"}]},
            nests.SPYRROW,
            "$.placed",
        ),
        ({**nests.SPYRROW_SOLUTION, "items": nests.SPYRROW["items"]}, None, "$ is a strip"),
        (
            {**nests.CGSHOP_SOLUTION, "item_indices": [0, 2]},
            nests.CGSHOP,
            "$.item_indices[1]:",
        ),
        ({**nests.CGSHOP_SOLUTION, "item_indices": [0]}, nests.CGSHOP, "$: item_indices, x_"),
        ({**nests.SPARROW, "items": [nests.ITEM, nests.ITEM]}, None, "$.items[1].id: the id"),
        (nests.SPARROW_SVG.replace("#item_0", "#item_7"), None, "line 5: use: no item"),
        (nests.SPARROW_SVG.replace("rotate(-180)", "scale(-1)"), None, "line 6: use: not a"),
        (nests.SPARROW_SVG, nests.SPYRROW, "its instance has no part '0'"),
        (nests.SVGNEST_SVG.replace("rotate(180)", "skewX(9)"), None, "line 5: g: not a move"),
        ("<svg><rect/>", None, "line 1"),
        ("", None, "empty"),
        ("<svg/>", None, "no outline is drawn"),
        ("<svg><circle r='1'/></svg>", None, "left out: line 1: circle: a curve"),
        ({"polygons": [[]]}, None, "$.polygons[0]: no vertices"),
    ],
)
def test_refusals(text: object, instance: object, said: str) -> None:
    assert refusal(text, instance).startswith(said)


def test_files_are_named_in_refusals(tmp_path: Path) -> None:
    file, instance = tmp_path / "file", tmp_path / "instance"
    file.write_text(nests.SVGNEST_SVG, encoding="utf-8")
    instance.write_text("[]", encoding="utf-8")
    assert read_layout(str(file)) == read(nests.SVGNEST_SVG)[0].data
    with pytest.raises(FormatError, match=f"{instance}: not an instance"):
        read_layouts(str(file), instance=str(instance))
    file.write_text(nests.DEEPNEST_SVG, encoding="utf-8")
    with pytest.raises(FormatError, match=f"{file}: 2 layouts, not one"):
        read_layout(str(file))
    assert read_layouts(f"{file}#1") == [read(nests.DEEPNEST_SVG)[1]]
    with pytest.raises(FormatError, match=f"{file}: no sheet has the number '2'; there are 2"):
        read_layouts(f"{file}#2")
    file.write_text("", encoding="utf-8")
    with pytest.raises(FormatError, match=f"{file}: empty"):
        read_layouts(str(file))


HOSTILE: list[Any] = [None, True, "x", "", -1, 1.5, [], {}, [[]], [None], "1e99999", {"x": 1}]


def spoilt(value: Any) -> Iterator[Any]:
    """The document with each part of it replaced by each hostile value, and left out."""
    yield from HOSTILE
    if isinstance(value, dict):
        for name, part in value.items():
            yield {key: one for key, one in value.items() if key != name}
            for other in spoilt(part):
                yield {**value, name: other}
    elif isinstance(value, list):
        # The first entry stands for the others.
        for other in spoilt(value[0]) if value else ():
            yield [other, *value[1:]]


@pytest.mark.parametrize("name", [name for name in nests.FILES if name.endswith(".json")])
def test_spoilt_files_are_read_or_refused(name: str) -> None:
    text, instance = nests.FILES[name]
    for other in spoilt(json.loads(text)):
        try_read(other, instance)
    if instance is not None:
        for other in spoilt(json.loads(instance)):
            try_read(json.loads(text), other)


def try_read(text: object, instance: object) -> None:
    try:
        read(text, instance)
    except ExactSweepError:
        pass
    except Exception as error:
        raise AssertionError(f"{json.dumps(text)}, {instance}") from error


@pytest.mark.parametrize("name", ["instance", "container"])
def test_an_option_that_is_no_string_is_named(name: str) -> None:
    wrong: Any = {name: 5}
    with pytest.raises(FormatError, match=rf"^{name} is 5, not a string$"):
        parse_layouts("<svg/>", **wrong)
