"""One layout in the format of each nesting program gets the same verdict."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any, NamedTuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from exactsweep.formats.layouts import parse_layouts
from exactsweep.layout import Judgement, Layout, judge_layout
from exactsweep.layout.report.picture import place_part

SHAPES = {
    "0": [(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (0, 2)],
    "1": [(0, 0), (2, 0), (2, 2), (0, 2)],
    "2": [(-1, 0), (1, -1), (2, 1)],
}
WIDTH, HEIGHT = 12, 8


class Placed(NamedTuple):
    """A part, its rotation in degrees, and its translation in tenths."""

    part: str
    turn: int
    x: int
    y: int

    @property
    def move(self) -> list[float]:
        return [self.x / 10, self.y / 10]

    @property
    def transform(self) -> str:
        return f"translate({self.x / 10} {self.y / 10})"


PLACED = st.lists(
    st.builds(
        Placed,
        st.sampled_from([*SHAPES]),
        st.sampled_from([0, 90, 180, 270, 30, 45]),
        st.integers(-5, 115),
        st.integers(-5, 75),
    ),
    min_size=1,
    max_size=8,
)


def path(part: str) -> str:
    return "M" + "L".join(f"{x} {y}" for x, y in SHAPES[part]) + "z"


def as_layout(placed: list[Placed]) -> tuple[Any, Any]:
    box = [[0, 0], [WIDTH, 0], [WIDTH, HEIGHT], [0, HEIGHT]]
    parts = [{"id": name, "exterior": ring} for name, ring in SHAPES.items()]
    placements = [{"part": p.part, "turn": p.turn, "move": p.move} for p in placed]
    return {"container": {"exterior": box}, "parts": parts, "placements": placements}, None


def as_sparrow(placed: list[Placed]) -> tuple[Any, Any]:
    items = [
        {
            "id": int(name),
            "demand": sum(p.part == name for p in placed),
            "shape": {"type": "simple_polygon", "data": ring},
        }
        for name, ring in SHAPES.items()
    ]
    found = [
        {
            "item_id": int(p.part),
            "transformation": {"rotation": float(p.turn), "translation": p.move},
        }
        for p in placed
    ]
    layout = {"container_id": 0, "placed_items": found}
    solution = {"strip_width": WIDTH, "layout": layout}
    return {"items": items, "strip_height": HEIGHT, "solution": solution}, None


def as_sparrow_svg(placed: list[Placed]) -> tuple[Any, Any]:
    defs = "".join(f'<g id="item_{name}"><path d="{path(name)}"/></g>' for name in SHAPES)
    uses = "".join(
        f'<use href="#item_{p.part}" transform="{p.transform}, rotate({p.turn})"/>' for p in placed
    )
    box = f'<g id="container_0"><path d="M0,0H{WIDTH}V{HEIGHT}H0z"/></g>'
    return f'<svg>{box}<g id="items"><defs>{defs}</defs>{uses}</g></svg>', None


def as_svgnest(placed: list[Placed]) -> tuple[Any, Any]:
    groups = "".join(
        f'<g transform="{p.transform} rotate({p.turn})"><path d="{path(p.part)}"/></g>'
        for p in placed
    )
    return f'<svg><rect class="bin" width="{WIDTH}" height="{HEIGHT}"/>{groups}</svg>', None


def as_packingsolver(placed: list[Placed]) -> tuple[Any, Any]:
    items = [
        {
            "type": "polygon",
            "vertices": [{"x": x, "y": y} for x, y in ring],
            "copies": 8,
            "allowed_rotations": [{"start": 0, "end": 360}],
        }
        for ring in SHAPES.values()
    ]
    bins = [{"type": "rectangle", "width": WIDTH, "height": HEIGHT}]
    found = [
        {"id": int(p.part), "x": p.x / 10, "y": p.y / 10, "angle": p.turn, "mirror": False}
        for p in placed
    ]
    instance = {"objective": "knapsack", "bin_types": bins, "item_types": items}
    return {"bins": [{"id": 0, "copies": 1, "items": found}]}, instance


def judge(written: tuple[Any, Any]) -> Judgement:
    document, instance = written
    text = document if isinstance(document, str) else json.dumps(document)
    (found,) = parse_layouts(text, instance=instance and json.dumps(instance))
    return judge_layout(Layout.from_json(found.data))


def sum_up(judgement: Judgement) -> Any:
    faults = [(fault.kind, fault.placements) for fault in judgement.faults]
    return faults, judgement.contacts, judgement.density


FORMATS = [as_sparrow, as_sparrow_svg, as_svgnest, as_packingsolver]


@pytest.mark.parametrize("write", FORMATS)
@settings(max_examples=12)
@given(PLACED)
def test_a_layout_has_the_same_verdict_in_every_format(write: Any, placed: list[Placed]) -> None:
    expected = judge(as_layout(placed))
    assert sum_up(judge(write(placed))) == sum_up(expected)


@settings(max_examples=12)
@given(PLACED.filter(lambda placed: all(p.turn % 90 == 0 for p in placed)))
def test_a_drawing_is_judged_in_place(placed: list[Placed]) -> None:
    layout, _ = as_layout(placed)
    expected = judge_layout(Layout.from_json(layout))
    box = [(0, 0), (WIDTH, 0), (WIDTH, HEIGHT), (0, HEIGHT)]
    rings: list[Any] = [box, *(place_part(expected.layout, k)[0] for k in range(len(placed)))]
    polygons = [[[str(Fraction(c)) for c in point] for point in ring] for ring in rings]
    (found,) = parse_layouts(json.dumps(polygons), container="0")
    judgement = judge_layout(Layout.from_json(found.data))
    assert sum_up(judgement) == sum_up(expected)
