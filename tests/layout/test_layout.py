"""Layouts as values: read and written, and every refusal names the part or placement, and field."""

import json
from copy import deepcopy
from fractions import Fraction
from importlib.resources import files
from typing import Any

import jsonschema
import pytest

from exactsweep.geometry.turn import read_turn
from exactsweep.layout import Layout, LayoutError

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


def test_what_is_written_is_read_again() -> None:
    layout = Layout.from_json(example())
    assert Layout.from_json(layout.to_json()) == layout
    assert Layout.from_json(json.loads(json.dumps(layout.to_json()))) == layout
    for data in (example(), layout.to_json()):
        jsonschema.validate(data, schema())


def test_every_field_arrives() -> None:
    layout = Layout.from_json(example())
    tile, bow = layout.parts
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


def test_what_may_be_left_out() -> None:
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


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        ((), [], r"the layout is \[\], not an object"),
        (("parts",), GONE, 'the layout has no "parts"'),
        (("parts",), {}, r"parts is \{\}, not a list"),
        (("part",), [], "the layout has a field 'part'; it may have container, parts, place"),
        (("container",), SQUARE, "container is .*, not an object"),
        (("container", "exterior", 2), ["4", "0"], "container: exterior: fewer than three"),
        (("container", "exterior", 1), ["4"], r"container.exterior\[1\] is not a pair of numbers"),
        (
            ("container", "holes"),
            [SQUARE, SQUARE],
            "container: hole 1, edge 3, and hole 0, edge 3 run along",
        ),
        (("parts", 1), 7, r"parts\[1\] is 7, not an object"),
        (("parts", 1, "id"), 7, r"parts\[1\].id is 7, not a string"),
        (("parts", 1, "id"), "tile", r"parts\[1\].id: parts\[0\] is 'tile', too"),
        (("parts", 0, "exterior", 1, 0), "x", r"parts\[0\].exterior\[1\]: 'x' is not a number"),
        (("parts", 0, "holes", 0, 1), "12", r"parts\[0\].holes\[0\]\[1\] is str, not a pair"),
        (("parts", 0, "holes"), 3, r"parts\[0\].holes is 3, not a list"),
        (("parts", 0, "demand"), -1, r"parts\[0\].demand is -1, not an integer of 0 or more"),
        (("parts", 0, "demand"), True, r"parts\[0\].demand is True, not an integer"),
        (("parts", 0, "demand"), "2", r"parts\[0\].demand is '2', not an integer"),
        (("parts", 0, "turns"), "0", r"parts\[0\].turns is '0', not a list"),
        (("parts", 0, "turns", 1), "left", r"parts\[0\].turns\[1\]: 'left' is not a number"),
        (("parts", 0, "mirrored"), "no", r"parts\[0\].mirrored is 'no', not true or false"),
        (("placements", 0, "part"), "sleeve", r"placements\[0\].part: no part has the id 'sleeve'"),
        (("placements", 0, "turn"), GONE, r'placements\[0\] has no "turn"'),
        (("placements", 0, "turn"), ["3", "4"], r"placements\[0\].turn: \(3, 4\) is not a cosine"),
        (("placements", 0, "turn"), ["1"], r"placements\[0\].turn is not a pair of numbers"),
        (("placements", 0, "turn"), float("nan"), r"placements\[0\].turn: nan is not a finite"),
        (("placements", 0, "move"), "12", r"placements\[0\].move is str, not a pair of numbers"),
        (("placements", 0, "mirrored"), 1, r"placements\[0\].mirrored is 1, not true or false"),
        (("spacing",), "-1/2", "spacing is -1/2, less than 0"),
        (("margin",), True, "margin: True is a truth value, not a number"),
    ],
)
def test_wrong_data_are_refused_by_name(path: tuple[Any, ...], value: Any, message: str) -> None:
    data: Any = example()
    if not path:
        data = value
    else:
        *way, last = path
        place = data
        for step in way:
            place = place[step]
        if value is GONE:
            del place[last]
        else:
            place[last] = value
    with pytest.raises(LayoutError, match=message):
        Layout.from_json(data)


def test_layouts_are_immutable() -> None:
    layout = Layout.from_json(example())
    with pytest.raises(AttributeError):
        layout.spacing = Fraction(0)  # type: ignore[misc]
    with pytest.raises(AttributeError):
        layout.parts[0].id = "other"  # type: ignore[misc]
