"""Layouts that are wrong as a whole: the diagnosis names the convention."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import pi
from typing import Any

import pytest
from layouts import box, lay, put

from exactsweep.layout import Layout, judge_layout
from exactsweep.layout import diagnose as diagnosing
from exactsweep.layout.diagnose import diagnose, find_radians
from exactsweep.numbers.number import Rational

L = [("0", "0"), ("3", "0"), ("3", "1"), ("1", "1"), ("1", "2"), ("0", "2")]
# Four L-shapes of 3 by 2 in a box of 8 by 4, with gaps: the rotation and the lower left corner of
# each, which give the position of the part's origin.
PLACED = [
    ("0", (0, 0)),
    ("90", (6, 0)),
    ("180", (3, 4)),
    ("270", (6, 4)),
]
FLIPPED = [(x, f"-{y}") for x, y in L]
BOX = [("0", "0"), ("9", "0"), ("9", "4"), ("0", "4")]


def layout(placements: list[dict[str, Any]], part: Any = L, **rest: Any) -> Layout:
    parts = [{"id": "L", "exterior": part}]
    return Layout.from_json(
        {"container": {"exterior": BOX}, "parts": parts, "placements": placements, **rest}
    )


def place(turn: object, x: object, y: object, *, mirrored: bool = False) -> dict[str, Any]:
    return {"part": "L", "turn": str(turn), "move": [str(x), str(y)], "mirrored": mirrored}


def test_the_layout_itself_is_valid() -> None:
    judgement = judge_layout(layout([place(turn, *at) for turn, at in PLACED]))
    assert judgement.valid
    assert diagnose(judgement) == []


def lower_left(turn: str, x: int, y: int) -> dict[str, Any]:
    u, v = {"0": (0, 0), "90": (-2, 0), "180": (-3, -2), "270": (0, -3)}[turn]
    return place(turn, x + u, y + v)


def turned_back(turn: str, x: int, y: int) -> dict[str, Any]:
    u, v = {"0": (x, y), "90": (y, -x), "180": (-x, -y), "270": (-y, x)}[turn]
    return place(turn, u, v)


@pytest.mark.parametrize(
    ("write", "said"),
    [
        (lambda turn, x, y: place(f"-{turn}", x, y), "clockwise rotations"),
        (lambda turn, x, y: place(turn, x, 4 - y), "Y pointing down in translations"),
        (
            lambda turn, x, y: place(f"-{turn}", x, 4 - y),
            "Y pointing down in translations, and clockwise rotations",
        ),
        (lower_left, "translations that place the lower left corner of the rotated box"),
        (turned_back, "translation before rotation"),
        (place, "Y pointing down in parts"),
        (lambda turn, x, y: place(turn, x, 4 - y), "Y pointing down in parts and translations"),
    ],
)
def test_the_convention_is_named(write: Callable[..., Any], said: str) -> None:
    part = FLIPPED if "parts" in said else L
    judgement = judge_layout(layout([write(turn, *at) for turn, at in PLACED], part))
    assert not judgement.valid
    notes = diagnose(judgement)
    assert any(note.startswith(f"with {said}, 0 of ") for note in notes), notes


@pytest.mark.parametrize("scale", ["10", "100", "1000", "127/5", "480/127", "360/127"])
def test_other_units_are_named(scale: str) -> None:
    """Powers of ten, millimeters for inches, and units of 1/96 and 1/72 inch for centimeters."""
    for factor, times in ((Fraction(scale), "divided by"), (1 / Fraction(scale), "multiplied by")):
        placed = [place(turn, x * factor, y * factor) for turn, (x, y) in PLACED]
        notes = diagnose(judge_layout(layout(placed)))
        assert any(
            note.startswith(f"with translations {times} {scale}, 0 of ") for note in notes
        ), notes


@pytest.mark.parametrize("digits", [7, 8, 17])
def test_radians_are_named(digits: int) -> None:
    # Some programs write -90 degrees for 270.
    angles = [int(turn) - (360 if turn == "270" else 0) for turn, _ in PLACED]
    turns = [f"{angle * pi / 180:.{digits}g}" for angle in angles]
    placed = [place(turn, *at) for turn, (_, at) in zip(turns, PLACED, strict=True)]
    judgement = judge_layout(layout(placed))
    assert not judgement.valid
    assert diagnose(judgement)[0].startswith("with rotations in radians, 0 of ")


COSINE_AND_SINE = {"0": (1, 0), "90": (0, 1), "180": (-1, 0), "270": (0, -1)}
CENTERS: dict[str, tuple[Rational, Rational]] = {
    "the centroid": (Fraction(5, 4), Fraction(3, 4)),
    "the center of the box": (Fraction(3, 2), 1),
    "the lower left corner of the box": (0, 0),
    "the first vertex": (1, 1),
}


@pytest.mark.parametrize("said", ["rotations about {}", "translations that place {}"])
@pytest.mark.parametrize("center", CENTERS)
def test_another_center_is_named(center: str, said: str) -> None:
    # The part is L moved by (-1, -4), from its fourth vertex on.
    part = [(int(x) - 1, int(y) - 4) for x, y in [*L[3:], *L[:3]]]
    u, v = CENTERS[center][0] - 1, CENTERS[center][1] - 4
    placed = []
    for turn, (x, y) in PLACED:
        c, s = COSINE_AND_SINE[turn]
        # L at (x, y) rotates about its origin, at offset R (u + 1, v + 4) from the center.
        at = x + c * (u + 1) - s * (v + 4), y + s * (u + 1) + c * (v + 4)
        back = (u, v) if said.startswith("rotations") else (0, 0)
        placed.append(place(turn, at[0] - back[0], at[1] - back[1]))
    judgement = judge_layout(layout(placed, part))
    assert not judgement.valid
    notes = diagnose(judgement)
    assert any(note.startswith(f"with {said.format(center)}, 0 of ") for note in notes), notes


def test_a_single_overlap_has_no_diagnosis() -> None:
    placed = [place(turn, *at) for turn, at in PLACED]
    tiles = [place(0, 0, 0), place(0, 0, 0), *placed[1:]]
    many = judge_layout(layout(tiles))
    assert not many.valid
    assert diagnose(many) == []


@pytest.mark.parametrize(
    ("write", "said"),
    [
        (lambda turn, x, y: place(turn, 9 - x, y, mirrored=True), "rotation before mirroring"),
        (
            lambda turn, x, y: place(-int(turn) - 180, 9 - x, y, mirrored=True),
            "mirroring in the X axis",
        ),
    ],
)
def test_other_mirrors_are_named(write: Callable[..., Any], said: str) -> None:
    # The whole layout mirrored in x is R(-a) M P + (9 - x, y).
    # Next to it is the original layout, to which no mirroring convention applies.
    unchanged = [place(turn, x + 9, y) for turn, (x, y) in PLACED]
    wide = {"container": {"exterior": [("0", "0"), ("18", "0"), ("18", "4"), ("0", "4")]}}
    mirrored = [place(-int(turn), 9 - x, y, mirrored=True) for turn, (x, y) in PLACED]
    assert judge_layout(layout([*mirrored, *unchanged], **wide)).valid
    judgement = judge_layout(
        layout([*(write(turn, *at) for turn, at in PLACED), *unchanged], **wide)
    )
    assert not judgement.valid
    notes = diagnose(judgement)
    assert any(note.startswith(f"with {said}, 0 of ") for note in notes), notes


def test_the_convention_that_leaves_the_fewest_faults_is_named_first(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    judgement = judge_layout(layout([place(0, 0, 0)] * 4))
    counts = {"a": 1, "b": 0, "c": 2}
    monkeypatch.setattr(diagnosing, "_list_conventions", lambda layout: counts.items())
    monkeypatch.setattr(diagnosing, "_apply", lambda layout, left: left)
    monkeypatch.setattr(diagnosing, "judge_layout", lambda left: left)
    monkeypatch.setattr(
        diagnosing, "_count_faults", lambda found: found if isinstance(found, int) else 20
    )
    said = [f"with {name}, {counts[name]} of 20 faults remain" for name in "bac"]
    assert diagnose(judgement) == said


@pytest.mark.parametrize(
    ("turn", "said"),
    [
        ("3.141592653589793", "180 degrees"),
        ("1.5708", "90 degrees"),
        ("-0.785398", "-45 degrees"),
        ("90", ""),
        ("2.5", ""),
        ("33.3", ""),
    ],
)
def test_rotations_in_radians_are_reported(turn: str, said: str) -> None:
    turned = lay(box(-9, -9, 9, 9), {"t": box(0, 0, 2, 1)}, put("t", (0, 0), turn))
    found = find_radians(turned)
    assert (said in found[0]) if said else not found


def test_rounding_errors_have_no_diagnosis() -> None:
    tiles = [put("t", (k * Fraction("0.9999999999"), 0)) for k in range(8)]
    judgement = judge_layout(lay(box(0, 0, 9, 9), {"t": box(0, 0, 1, 1)}, *tiles))
    assert len(judgement.faults) == 7
    assert diagnose(judgement) == []
