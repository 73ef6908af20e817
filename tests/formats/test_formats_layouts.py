"""One layout in each format of nesting programs."""

from __future__ import annotations

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


def read(text: object, instance: object = None, **options: Any) -> list[FoundLayout]:
    given = None if instance is None else write(instance)
    return parse_layouts(write(text), instance=given, **options)


def write(document: object) -> str:
    return document if isinstance(document, str) else json.dumps(document)


def corners(layout: dict[str, Any]) -> list[set[tuple[Fraction, Fraction]]]:
    """Return the corners of each placement, for quarter turns only."""
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
    one = nests.L
    other = {(4 - x, 3 - y) for x, y in one}
    assert [shape for layout in found for shape in corners(layout.data)] == [one, other]
    for layout in found:
        box = {
            (Fraction(str(x)), Fraction(str(y))) for x, y in layout.data["container"]["exterior"]
        }
        assert box == nests.BOX
    assert len(found) == (2 if name in ("bins.json", "deepnest.svg") else 1)


def test_a_drawing_of_dxf() -> None:
    regions = parse_regions(nests.FILES["drawing.svg"][0])
    (found,) = read(format_polygons(regions, "dxf"))
    assert len(found.data["parts"]) == 2


def test_errors_name_files(tmp_path: Path) -> None:
    file, instance = tmp_path / "file", tmp_path / "instance"
    file.write_text(nests.FILES["svgnest.svg"][0], encoding="utf-8")
    instance.write_text("[]", encoding="utf-8")
    assert read_layout(str(file)) == read(nests.FILES["svgnest.svg"][0])[0].data
    with pytest.raises(FormatError, match=f"{instance}: neither a nesting instance"):
        read_layouts(str(file), instance=str(instance))
    file.write_text(nests.FILES["deepnest.svg"][0], encoding="utf-8")
    with pytest.raises(FormatError, match=f"{file}: expected one layout, found 2"):
        read_layout(str(file))
    assert read_layouts(f"{file}#1") == [read(nests.FILES["deepnest.svg"][0])[1]]
    with pytest.raises(FormatError, match=f"{file}: no sheet has the index '2'; there are 2"):
        read_layouts(f"{file}#2")
    file.write_text("", encoding="utf-8")
    with pytest.raises(FormatError, match=f"{file}: empty"):
        read_layouts(str(file))


HOSTILE: list[Any] = [None, True, "x", "", -1, 1.5, [], {}, [[]], [None], "1e99999", {"x": 1}]


def spoilt(value: Any) -> Iterator[Any]:
    """Yield copies of a document with each value replaced by a hostile one, or omitted."""
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
def test_damaged_files_are_read_or_rejected(name: str) -> None:
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
def test_options_of_other_types_are_named(name: str) -> None:
    wrong: Any = {name: 5}
    with pytest.raises(FormatError, match=rf"^{name} is 5, not a string$"):
        parse_layouts("<svg/>", **wrong)


def test_outlines_read_as_holes_are_noted() -> None:
    """A part on another one is drawn like a hole."""
    sides = (9, 0), (4, 1), (1, 2)
    boxes = "".join(f'<rect width="{w}" height="{w}" x="{x}" y="{x}"/>' for w, x in sides)
    (flat,), (nested,) = (read(f"<svg>{boxes}</svg>", nested=choice) for choice in (False, None))
    assert (len(flat.data["parts"]), flat.notes) == (2, ())
    note = (
        "1 outline inside others read as a hole, not as a part: line 1: rect in line 1: rect "
        "(--flat reads each outline as a part)"
    )
    assert (len(nested.data["parts"]), nested.notes) == (1, (note,))
