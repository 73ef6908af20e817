"""Texts of all formats with their results, in `golden.json`.

The result is the error message, or the polygons, omissions and notes.
"""

import json
from collections.abc import Callable
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any

import pytest

from exactsweep.formats import (
    FORMATS,
    NamedRegion,
    format_polygons,
    parse_polygon,
    parse_regions,
    round_regions,
)
from exactsweep.formats.layouts import FoundLayout, parse_layouts
from exactsweep.formats.rounding import Side
from exactsweep.geometry.region import AnyPolygon, Region

FILE = Path(__file__).parent / "golden.json"
WRITTEN = (*FORMATS, "json decimals")
SIDES: tuple[Side, ...] = ("closest", "outward", "inward")
CASES: list[dict[str, Any]] = json.loads(FILE.read_text(encoding="utf-8"))


def find_outcome(case: dict[str, Any]) -> object:
    """Read the text of a case in its format."""
    text, options = case["text"], case.get("options", {})
    if case.get("as") == "layout":
        return attempt(lambda: [show_layout(one) for one in parse_layouts(text, **options)])
    if case.get("as") == "written":
        return {form: attempt(partial(write, text, form, options)) for form in WRITTEN}
    if case.get("as") == "rounded":
        cases = product((0, 1), SIDES)
        return [attempt(partial(round_all, text, *way)) for way in cases]
    one = attempt(lambda: show(parse_polygon(text, case.get("choice"), **options)))
    every = one if "choice" in case else attempt(lambda: list_contents(text, options))
    return one if one == every else [one, every]


def attempt(read: Callable[[], object]) -> object:
    try:
        return read()
    except ValueError as error:
        return f"{type(error).__name__}: {error}"


def show_layout(found: FoundLayout) -> list[object]:
    outcome = found.name, found.data, found.notes, found.unchecked, found.unit
    return list(json.loads(json.dumps(outcome)))


def show(polygon: AnyPolygon) -> str:
    return " | ".join(" ".join(f"{x},{y}" for x, y in ring) for ring in polygon.rings)


def list_contents(text: str, options: dict[str, Any]) -> dict[str, object]:
    found = parse_regions(text, **options)
    parts = [[name, layer, show(region)] for region, name, layer, _ in found]
    unit = None if found.coordinates.unit is None else str(found.coordinates.unit)
    outcome = {"left_out": found.left_out, "notes": found.notes, "unit": unit}
    return {"parts": parts, **{name: value for name, value in outcome.items() if value}}


def round_all(text: str, places: int, side: Side) -> list[str]:
    found, changes = round_regions(parse_regions(text), places, lambda region: side)
    return [*(show(part.region) for part in found), *map(str, changes)]


def write(text: str, form: str, options: dict[str, Any]) -> str:
    """Write the polygons of a text in another format, with two exact fits."""
    found = parse_regions(text, **options)
    first, second, *_ = found[0].region.vertices
    form, _, decimals = form.partition(" ")
    return format_polygons(
        found,
        form,
        [(first, second), (first, first)],
        decimals=bool(decimals),
        coordinates=found.coordinates,
    )


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["name"])
def test_results_match_the_golden_file(case: dict[str, Any]) -> None:
    assert find_outcome(case) == case["outcome"]


def count_parts(text: str) -> int:
    try:
        return len(parse_regions(text))
    except ValueError:
        return 0


@pytest.mark.parametrize("form", FORMATS)
def test_truncated_files_are_read_or_rejected(form: str) -> None:
    region = Region([(0, 0), (40, 0), (40, 30), (0, 30)], [[(1, 1), (20, 1), (1, "20.5")]])
    text = format_polygons([NamedRegion(region, "a"), region], form)
    parts = [count_parts(text[:k]) for k in range(0, len(text), 3)]
    assert min(parts) == 0
    assert max(parts) <= 4
