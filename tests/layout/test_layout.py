"""Layouts as values are read and written; errors name the part or placement, and the field."""

import json
from copy import deepcopy
from fractions import Fraction
from importlib.resources import files
from typing import Any

import jsonschema
import pytest
from refusals import list_refusals, require_refused

from exactsweep import Region
from exactsweep.geometry.turn import read_turn
from exactsweep.layout import Layout

SQUARE = [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]]


def example() -> dict[str, Any]:
    return deepcopy(
        {
            "container": {"exterior": [["0", "0"], ["4", "0"], ["0", "1e1"]], "holes": []},
            "parts": [
                {
                    "id": "tile",
                    "exterior": SQUARE,
                    "holes": [[["1/4", "1/4"], ["1/2", "1/4"], ["1/4", "0.5"]]],
                    "demand": 1,
                    "turns": ["0", "33.3", ["3/5", "4/5"]],
                    "mirrored": False,
                },
                {"id": "bow", "exterior": [["0", "0"], ["1", "1"], ["1", "0"], ["0", "1"]]},
            ],
            "placements": [
                {"part": "tile", "turn": ["3/5", "4/5"], "move": ["1/3", "-0.5"]},
                {"part": "bow", "turn": "-90", "mirrored": True, "move": [0, 0.5]},
            ],
            "spacing": "1/1000",
            "margin": 2,
        }
    )


def schema() -> Any:
    text = files("exactsweep.layout").joinpath("layout.schema.json").read_text(encoding="utf-8")
    return json.loads(text)


def test_layouts_round_trip() -> None:
    layout = Layout.from_json(example())
    assert Layout.from_json(layout.to_json()) == layout
    assert Layout.from_json(json.loads(json.dumps(layout.to_json()))) == layout
    for data in (example(), layout.to_json()):
        jsonschema.validate(data, schema())


def test_every_field_is_read() -> None:
    layout = Layout.from_json(example())
    tile, bow = layout.parts
    assert isinstance(layout.container, Region)
    assert layout.container.area == 20
    assert tile.demand == 1
    assert tile.mirrored is False
    assert tile.turns == (read_turn(0), read_turn("33.3"), read_turn((3, 4)))
    assert tile.region is not None
    assert len(tile.region.holes) == 1
    assert (bow.demand, bow.turns, bow.mirrored) == (None, None, None)
    assert bow.region is None
    assert bow.refusal == "the boundary crosses itself: edges 0 and 2 cross"
    assert layout.placements[0].move == (Fraction(1, 3), Fraction(-1, 2))
    assert layout.placements[1].turn == read_turn(270)
    assert layout.placements[1].mirrored
    assert (layout.spacing, layout.margin) == (Fraction(1, 1000), Fraction(2))


def test_optional_fields_have_defaults() -> None:
    data = example()
    for part in data["parts"]:
        for name in ("holes", "demand", "turns", "mirrored"):
            part.pop(name, None)
    del data["container"]["holes"], data["spacing"], data["margin"]
    del data["placements"][1]["mirrored"]
    layout = Layout.from_json(data)
    assert max(layout.spacing, layout.margin) == 0
    assert not layout.placements[1].mirrored
    jsonschema.validate(data, schema())


GONE = object()


def changed(*path: Any, to: Any = GONE) -> Any:
    """Change or remove one value of the example."""
    if not path:
        return to
    data: Any = example()
    *way, last = path
    place = data
    for step in way:
        place = place[step]
    if to is GONE:
        del place[last]
    else:
        place[last] = to
    return data


@pytest.mark.parametrize(("call", "said"), list_refusals(__file__))
def test_invalid_data_is_rejected_by_field(call: str, said: str) -> None:
    require_refused(call, said, Layout=Layout, SQUARE=SQUARE, changed=changed)


def test_layouts_are_immutable() -> None:
    layout = Layout.from_json(example())
    with pytest.raises(AttributeError):
        layout.spacing = Fraction(0)  # type: ignore[misc]
    with pytest.raises(AttributeError):
        layout.parts[0].id = "other"  # type: ignore[misc]
