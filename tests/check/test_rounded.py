"""Rounded pieces, rounded containers and layouts without a container, in certificates."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

import pytest
from certified import rect, with_faults
from checkers import check_agreement, is_proved, needs_node
from rounded_pieces import (
    Certificate,
    draw_pair,
    draw_rounded,
    find_nearest,
    is_true_rounded,
    of_pair,
    rounded_layout,
)
from tampering import put

from exactsweep.check.standalone import Refused, prove
from exactsweep.layout import Layout, judge_layout

DISC: Any = {"points": [["0", "0"]], "radius": "5"}


def disc(x: Any, y: Any, radius: Any) -> dict[str, Any]:
    return {"points": [[str(x), str(y)]], "radius": str(radius)}


@pytest.mark.parametrize("seed", range(3))
def test_pieces_are_disjoint_if_the_distance_of_hulls_is_the_sum_of_radii(seed: int) -> None:
    rng, verdicts = Random(seed), set()
    for _ in range(60):
        room = Fraction(rng.choice([0, 0, 1, 2]), rng.choice([1, 3]))
        certificate, is_true = of_pair(*draw_pair(rng, room), room)
        assert is_proved(certificate) is is_true
        verdicts.add(is_true)
    assert verdicts == {True, False}


@pytest.mark.parametrize("seed", range(2))
def test_a_point_closer_than_both_radii_is_an_overlap(seed: int) -> None:
    rng = Random(seed)
    for _ in range(60):
        one, other = draw_pair(rng, Fraction(0))
        certificate, is_valid = of_pair(one, other, Fraction(0))
        (a, b), (c, d) = find_nearest(one, other)
        share = one.radius / (one.radius + other.radius)
        point = [str(a + share * (c - a)), str(b + share * (d - b))]
        fault = {"kind": "overlap", "placements": [0, 1], "point": point}
        assert is_proved(with_faults(certificate, fault)) is not is_valid


@needs_node
def test_only_pieces_of_two_points_may_repeat_one(tmp_path: Path) -> None:
    piece = {"points": rect(0, 0, 4, 4)}
    part = {"id": "a", "pieces": [piece]}
    layout = {"parts": [part], "placements": [{"part": "a", "move": ["0", "0"]}]}
    plain = json.loads(json.dumps(judge_layout(Layout.from_json(layout)).certificate()))
    place = "layout", "parts", 0, "pieces", 0, "points"
    dot = put(plain, place, [["1", "1"]] * 2)
    repeated = put(plain, place, [*piece["points"], piece["points"][0]])
    assert check_agreement([plain, dot], tmp_path) == 2
    assert check_agreement([repeated], tmp_path) == 0


@pytest.mark.parametrize(("error", "is_close"), [("0", True), ("1/2", False), ("1/3", True)])
def test_errors_count_for_rounded_pieces(error: str, is_close: bool) -> None:
    certificate = rounded_layout([[disc(0, 0, 1)], [disc(3, 0, 1)]], spacing="2")
    for part in certificate["layout"]["parts"]:
        part["error"] = error
    fault = {"kind": "too close", "placements": [0, 1], "point": ["3/2", "0"]}
    assert is_proved(with_faults(certificate, fault)) is is_close
    assert not is_proved(certificate)
    assert is_proved(put(certificate, ("layout", "spacing"), str(1 - 2 * Fraction(error))))


@pytest.mark.parametrize("length", [4, 4 - Fraction(1, 10**12), 4 + Fraction(1, 10**12), 6])
def test_a_disc_is_inside_a_disc_if_its_center_is_close_enough(length: Any) -> None:
    x, y = length * Fraction(3, 5), length * Fraction(4, 5)
    certificate = rounded_layout([[disc(x, y, 1)]], container={"pieces": [DISC]})
    assert is_proved(certificate) is (length <= 4)
    point = [str(x * 5 / length * (1 + Fraction(1, 10**14))), str(y * 5 / length)]
    fault = {"kind": "outside", "placements": [0, -1], "point": point}
    assert is_proved(with_faults(certificate, fault)) is (length > 4)


def test_a_margin_and_errors_shrink_a_round_container() -> None:
    container = {"pieces": [DISC], "error": "1/4"}
    for radius, is_valid, is_close in (
        ("3", True, False),
        ("7/2", False, False),
        ("18/5", False, True),
    ):
        certificate = rounded_layout([[disc(1, 0, radius)]], container, margin="3/4")
        assert is_proved(certificate) is is_valid
        fault = {"kind": "too close", "placements": [0, -1], "point": ["24/5", "0"]}
        assert is_proved(with_faults(certificate, fault)) is is_close
    small = rounded_layout([[disc(0, 0, 6)]], container)
    assert not is_proved(small)


def test_a_rounded_rectangle_contains_pieces_of_larger_radius() -> None:
    container = {"pieces": [{"points": rect(0, 0, 20, 10), "radius": "1"}]}
    for x, is_valid in ((3, True), (Fraction(29, 10), False), (50, False)):
        certificate = rounded_layout([[disc(x, 5, 4)]], container)
        assert is_proved(certificate) is is_valid
    slot = {"points": [["0", "0"], ["20", "10"]], "radius": "4"}
    assert not is_proved(rounded_layout([[slot]], container))
    assert is_proved(rounded_layout([[{**slot, "radius": "1"}]], container))


def test_without_a_container_parts_are_only_compared_with_each_other() -> None:
    pieces = [[{"points": rect(0, 0, 2, 2)}], [{"points": rect(2, 0, 4, 2)}]]
    certificate = rounded_layout(pieces, margin="9")
    assert prove(certificate) == "layout of 2 placements, valid"
    defect = {"pieces": [disc(14, 1, 1)]}
    assert is_proved(rounded_layout(pieces, margin="9", defects=[defect]))
    assert not is_proved(rounded_layout(pieces, margin="91/10", defects=[defect]))
    fault = {"kind": "outside", "placements": [0, -1], "point": ["1", "1"]}
    assert not is_proved(with_faults(certificate, fault))


def test_rounded_pieces_move_with_their_part() -> None:
    slot = {"points": [["0", "0"], ["5", "0"]], "radius": "1"}
    certificate = rounded_layout([[slot], [slot]])
    certificate["layout"]["placements"][1] |= {"turn": ["3/5", "4/5"], "mirrored": True}
    certificate["turns"][1] = ["3/5", "4/5"]
    for place, is_valid in ((["-2", "0"], True), (["-19/10", "0"], False)):
        assert is_proved(put(certificate, ("layout", "placements", 1, "move"), place)) is is_valid


PART, OUTSIDE = ("layout", "parts", 0), ("layout", "container")
ALONE = "neither a shape nor rounded pieces alone"
CHANGES: dict[str, tuple[Any, str]] = {
    "no pieces": (((*PART, "pieces"), []), f"parts[0]: {ALONE}"),
    "no points": (((*PART, "pieces", 0, "points"), []), "not convex and counter-clockwise"),
    "a clockwise ring": (
        ((*PART, "pieces", 0, "points"), rect(0, 0, 1, 1)[::-1]),
        "not convex and counter-clockwise",
    ),
    "a radius below 0": (((*PART, "pieces", 0, "radius"), "-1"), "radius: below 0"),
    "also an exterior": (((*PART, "exterior"), rect(0, 0, 1, 1)), ALONE),
    "also holes": (((*PART, "holes"), [rect(0, 0, 1, 1)]), ALONE),
    "neither": (((*PART, "pieces"), None), ALONE),
    "a list of pieces": ((("proof", "pieces", 0), [rect(0, 0, 1, 1)]), ALONE),
    "a container of two": (
        ((*OUTSIDE, "pieces"), [DISC, DISC]),
        f"container: {ALONE}",
    ),
    "a frame": (
        (("proof", "frame"), ["-9", "-9", "9", "9"]),
        "frame: missing or superfluous",
    ),
    "outside pieces": ((("proof", "pieces", 1), [rect(0, 0, 1, 1)]), f"container: {ALONE}"),
    "a polygon without a frame": (
        (OUTSIDE, {"exterior": rect(-9, -9, 9, 9)}),
        "frame: missing or superfluous",
    ),
}


@pytest.mark.parametrize("name", CHANGES)
def test_each_condition_of_rounded_pieces_is_needed(name: str) -> None:
    (path, value), reason = CHANGES[name]
    certificate = rounded_layout([[disc(0, 0, 1)]], {"pieces": [DISC]})
    assert is_proved(certificate)
    with pytest.raises(Refused) as caught:
        prove(put(certificate, path, value))
    assert reason in str(caught.value)


def test_rounded_pieces_cannot_have_a_shape_fault() -> None:
    certificate = rounded_layout([[disc(0, 0, 1), disc(0, 0, 1)]])
    fault = {"kind": "shape", "part": "0", "point": ["0", "0"]}
    assert not is_proved(with_faults(certificate, fault))


@needs_node
def test_both_checkers_agree_on_rounded_pieces(tmp_path: Path) -> None:
    rng, certificates = Random(9), list[Certificate]()
    for _ in range(40):
        room = Fraction(rng.choice([0, 1]))
        one, other = draw_pair(rng, room)
        certificate, _ = of_pair(one, other, room)
        a, b = find_nearest(one, other)
        point = [str((p + q) / 2) for p, q in zip(a, b, strict=True)]
        kind = "too close" if room else "overlap"
        fault = {"kind": kind, "placements": [0, 1], "point": point}
        certificates += [certificate, with_faults(certificate, fault)]
    for (path, value), _ in CHANGES.values():
        certificate = rounded_layout([[disc(0, 0, 1)]], {"pieces": [DISC]})
        certificates += [put(certificate, path, value)]
    for length in (3, 4, 5):
        certificate = rounded_layout([[disc(length, 0, 1)]], {"pieces": [DISC]}, margin="0")
        fault = {"kind": "outside", "placements": [0, -1], "point": [f"{2 * length + 1}/2", "0"]}
        certificates += [certificate, with_faults(certificate, fault)]
        certificates += [put(certificate, ("layout", "margin"), "1")]
    assert check_agreement(certificates, tmp_path) > 20


def test_certificates_of_judged_layouts_are_proved_and_true() -> None:
    for rng in map(Random, range(6)):
        for drawn in draw_rounded(rng):
            judged = judge_layout(Layout.from_json(drawn["layout"]))
            certificate = json.loads(json.dumps(judged.certificate()))
            assert judged.valid is drawn["valid"]
            assert is_true_rounded(certificate, None)
            assert prove(certificate)
