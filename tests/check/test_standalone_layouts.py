"""Layouts: valid ones with their proof, faults with their points, and every condition of both."""

from __future__ import annotations

import copy
from collections.abc import Callable
from fractions import Fraction
from random import Random
from typing import Any

import pytest
from certified import PIECES_OF_L, Certificate, L, layout, rect, two_ls, with_faults
from checkers import is_proved
from tampering import get, put

from exactsweep.check.standalone import Refused, prove, rotation, rotation_error

SQUARE = {"id": "a", "exterior": rect(0, 0, 2, 2)}


def refusal(certificate: Any) -> str:
    with pytest.raises(Refused) as caught:
        prove(certificate)
    return str(caught.value)


def at(x: Any, y: Any, part: str = "a", **more: Any) -> dict[str, Any]:
    return {"part": part, "move": [str(x), str(y)], **more}


def overlapping() -> Certificate:
    """Return two overlapping squares, a disjoint third one, and a defect under the first."""
    placed = [at(1, 1), at(2, 2), at(9, 9)]
    found = layout([SQUARE], placed, [[rect(0, 0, 2, 2)]], defects=[{"exterior": rect(0, 0, 2, 2)}])
    return with_faults(found, OVERLAP)


OVERLAP = {"kind": "overlap", "placements": [0, 1], "point": ["5/2", "5/2"]}


def without(path: tuple[Any, ...]) -> Callable[[Certificate], Certificate]:
    def made(certificate: Certificate) -> Certificate:
        changed = copy.deepcopy(certificate)
        del get(changed, path[:-1])[path[-1]]
        return changed

    return made


def having(*path: Any, to: Any) -> Callable[[Certificate], Certificate]:
    return lambda certificate: put(
        certificate, path, to(get(certificate, path)) if callable(to) else to
    )


def test_layouts_are_proved() -> None:
    assert prove(two_ls()) == "layout of 2 placements, valid"
    assert prove(overlapping()) == "layout of 3 placements, not valid: 1 faults"


PLACED = ("layout", "placements")
PART = ("layout", "parts", 0)
VALID = {
    "neither true nor false": (having("valid", to=1), "valid: not of type bool"),
    "another id": (having(*PLACED, 0, "part", to="x"), "placements[0]: unknown part"),
    "a duplicate part id": (
        lambda c: put(
            put(c, ("layout", "parts"), c["layout"]["parts"] * 2),
            ("proof", "pieces"),
            [PIECES_OF_L, *c["proof"]["pieces"]],
        ),
        "parts: ids are not unique",
    ),
    "mirrored is none": (having(*PLACED, 0, "mirrored", to=0), "mirrored: not of type bool"),
    "a part's is none": (having(*PART, "mirrored", to=0), "mirrored: not of type bool"),
    "an invalid demand": (having(*PART, "demand", to=10**9), "demand: not of type int"),
    "a demand below 0": (having(*PART, "demand", to=-1), "demand: below 0"),
    "another demand": (having(*PART, "demand", to=3), "rules are violated: [('missing', 'L')]"),
    "a smaller demand": (having(*PART, "demand", to=1), "rules are violated: [('surplus', 'L')]"),
    "a rotation that is not allowed": (having(*PART, "turns", to=["0"]), "[('turn', 'L')]"),
    "an invalid rotation": (
        having(*PART, "turns", to=[["1", "1"]]),
        "cosine and sine not on the unit",
    ),
    "another rotation": (having("turns", 0, to=["0", "1"]), "its entry in turns is a different"),
    "mirroring that is not allowed": (
        lambda c: put(put(c, (*PLACED, 0, "mirrored"), True), (*PART, "mirrored"), False),
        "[('mirror', 'L')]",
    ),
    "a spacing below 0": (having("layout", "spacing", to="-1"), "layout.spacing: below 0"),
    "too near": (having("layout", "spacing", to="1/9"), "not apart from layout.placements[1]"),
    "too close to a side": (having("layout", "margin", to="1/9"), "container, piece "),
    "in another place": (
        having(*PLACED, 1, "move", to=["3", "17/9"]),
        "not apart from layout.placements[1]",
    ),
    "an error": (having(*PART, "error", to="1/9"), "not apart from"),
    "an error of the container": (
        having("layout", "container", "error", to="1/9"),
        "container, piece ",
    ),
    "beyond the frame": (having(*PLACED, 1, "move", to=["33", "22"]), "not in the container"),
    "no parts": (
        lambda c: put(
            put(c, (*PART, "exterior"), [["0", "0"], ["1", "0"], ["2", "0"]]),
            ("proof", "pieces", 0),
            [],
        ),
        "parts[0]: no pieces",
    ),
    "pieces of no body": (
        having("proof", "pieces", to=lambda pieces: [*pieces, []]),
        "proof.pieces: not a list of 2 entries",
    ),
    "a rotation of no placement": (
        having("turns", to=lambda turns: [*turns, ["1", "0"]]),
        "turns: not one for each placement",
    ),
    "a normal without a piece": (
        having("proof", "apart", to=[[0, 1, 0, "1", "0"]]),
        "apart[0]: not a list of 6 entries",
    ),
    "faults in addition to a proof": (having("faults", to=[]), "valid: neither true with a proof"),
}


@pytest.mark.parametrize("name", VALID)
def test_each_condition_of_a_valid_layout_is_needed(name: str) -> None:
    made, reason = VALID[name]
    assert reason in refusal(made(two_ls()))


FAULT = ("faults", 0)
FAULTS = {
    "of what": (without((*FAULT, "placements")), "faults[0].placements: missing"),
    "an unknown kind": (
        having(*FAULT, "kind", to=["overlap"]),
        "faults[0].kind: none of missing",
    ),
    "a misspelled kind": (having(*FAULT, "kind", to="near"), "faults[0].kind: none of missing"),
    "of an unknown part": (
        having(*FAULT, to={"kind": "missing", "part": "x"}),
        "faults[0]: unknown part",
    ),
    "an obeyed rule": (
        having(*FAULT, to={"kind": "missing", "part": "a"}),
        "the part has no such fault",
    ),
    "a simple shape": (
        having(*FAULT, to={"kind": "shape", "part": "a", "point": ["1", "1"]}),
        "the part has no such fault",
    ),
    "too many bodies": (having(*FAULT, "placements", to=[0, 1, 2]), "not a list of 2 entries"),
    "an unknown body": (having(*FAULT, "placements", to=[0, 3]), "not overlap of two bodies"),
    "outside of a placement": (having(*FAULT, "kind", to="outside"), "of two bodies"),
    "overlap with the outside": (
        having(*FAULT, "placements", 1, to=-1),
        "of two bodies",
    ),
    "one body": (having(*FAULT, "placements", to=[0, 0]), "of two bodies"),
    "obstacles alone": (
        having(*FAULT, to={"kind": "outside", "placements": [-1, -2], "point": ["1", "1"]}),
        "of two bodies",
    ),
    "no point": (without((*FAULT, "point")), "faults[0].point: missing"),
    "a point in one": (
        having(*FAULT, "point", to=["3/2", "3/2"]),
        "not inside layout.placements[1]",
    ),
    "a point in the other": (
        having(*FAULT, "point", to=["7/2", "7/2"]),
        "inside layout.placements[0]",
    ),
    "a point on an edge": (
        having(*FAULT, "point", to=["2", "5/2"]),
        "not inside layout.placements[1]",
    ),
    "errors that are deeper": (having(*PART, "error", to="1/2"), "not inside layout.placements[0]"),
    "too close, without a spacing": (
        having(*FAULT, "kind", to="too close"),
        "the errors leave no room",
    ),
    "none": (having("faults", to=[]), "nor false with faults"),
}


@pytest.mark.parametrize("valid", [True, False])
def test_a_layout_has_either_a_proof_or_faults(valid: bool) -> None:
    reason = "valid: neither true with a proof nor false with faults"
    proof = two_ls()["proof"]
    for more in ({}, {"proof": proof, "faults": [{"kind": "missing", "part": "L"}]}):
        without = {key: value for key, value in two_ls().items() if key != "proof"}
        assert reason in refusal({**without, "valid": valid, **more})


@pytest.mark.parametrize("name", FAULTS)
def test_each_condition_of_a_fault_is_needed(name: str) -> None:
    made, reason = FAULTS[name]
    assert prove(overlapping())
    assert reason in refusal(made(overlapping()))


def test_faults_of_every_kind_are_proved() -> None:
    twice = [*rect(0, 0, 4, 4), *rect(0, 0, 4, 4)]
    parts = [
        {**SQUARE, "demand": 9, "turns": ["0"], "mirrored": False},
        {"id": "b", "exterior": twice},
    ]
    placed = [at(1, 1), at(4, 1), at(19, 7), at(6, 12), at(9, 14, turn="1", mirrored=True)]
    found = layout(
        parts, placed, [], defects=[{"exterior": rect(7, 13, 12, 17)}], spacing="3/2", margin="1/2"
    )
    faults = [
        {"kind": "missing", "part": "a"},
        {"kind": "turn", "part": "a"},
        {"kind": "mirror", "part": "a"},
        {"kind": "shape", "part": "b", "point": ["1", "1"]},
        {"kind": "too close", "placements": [0, 1], "point": ["7/2", "2"]},
        {"kind": "outside", "placements": [2, -1], "point": ["41/2", "8"]},
        {"kind": "outside", "placements": [3, -2], "point": ["15/2", "27/2"]},
    ]
    assert prove(with_faults(found, *faults))
    surplus = put(found, ("layout", "parts", 0, "demand"), 1)
    assert prove(with_faults(surplus, {"kind": "surplus", "part": "a"}))
    near = put(found, ("layout", "placements", 0, "move"), ["2/5", "1"])
    fault = {"kind": "too close", "placements": [0, -1], "point": ["1/5", "2"]}
    assert prove(with_faults(near, fault))
    assert "near enough" in refusal(with_faults(found, fault))


def test_a_placement_may_be_too_close_to_a_defect() -> None:
    for x, is_near in ((Fraction(45, 10), True), (5, False)):
        found = layout(
            [SQUARE], [at(x, 1)], [], defects=[{"exterior": rect(1, 1, 4, 4)}], margin="1"
        )
        middle = [str((x + 4) / Fraction(2)), "2"]
        fault = {"kind": "too close", "placements": [0, -2], "point": middle}
        if is_near:
            assert prove(with_faults(found, fault))
        else:
            assert "near enough" in refusal(with_faults(found, fault))


def test_defects_cross_the_edge_and_each_other() -> None:
    more: list[dict[str, Any]] = [{"exterior": rect(3, -1, 5, 5)}, {"exterior": rect(4, 4, 6, 6)}]
    cut = [[rect(0, 0, 2, 2)]]
    assert prove(layout([SQUARE], [at(1, 2)], cut, defects=more))
    reason = refusal(layout([SQUARE], [at("21/20", 2)], cut, defects=more))
    assert "defects[0], piece 0: not apart from layout.placements[0]" in reason
    more[0]["error"] = "1/1000"
    assert "defects[0]" in refusal(layout([SQUARE], [at(1, 2)], cut, defects=more))
    assert prove(layout([SQUARE], [at("999/1000", 2)], cut, defects=more))


@pytest.mark.parametrize(("gap", "is_valid"), [("0", False), ("19/100", False), ("1/5", True)])
def test_errors_of_both_bodies_add_up(gap: str, is_valid: bool) -> None:
    part = {**SQUARE, "error": "1/10"}
    found = layout([part], [at(5, 5), at(7 + Fraction(gap), 5)], [[rect(0, 0, 2, 2)]])
    if is_valid:
        assert prove(found)
    else:
        assert "not apart" in refusal(found)


def test_a_frame_may_be_the_container() -> None:
    found = layout([SQUARE], [at(1, 1)], [[rect(0, 0, 2, 2)]])
    found = put(found, ("proof", "frame"), ["0", "0", "20", "20"])
    assert prove(put(found, ("proof", "pieces", 1), []))
    assert "do not cancel" in refusal(found)


def test_shapes_of_winding_number_2_are_not_valid() -> None:
    twice = [*rect(0, 0, 4, 4), *rect(0, 0, 4, 4)]
    found = layout([{"id": "a", "exterior": twice}], [at(1, 1)], [[rect(0, 0, 4, 4)] * 2])
    assert "parts[0]: pieces 0 and 1 are not apart" in refusal(found)


def test_slanted_normals_are_exact() -> None:
    """Squares, rotated by (3, 4, 5), that touch along a side or are a spacing apart."""
    rng = Random(3)
    cut = [[rect(0, 0, 5, 5)]]
    for _ in range(60):
        spacing = Fraction(rng.choice([0, 0, 1, 2]), rng.choice([1, 7]))
        room = 5 + spacing + Fraction(rng.choice([-1, 0, 0, 1]), 10**9)
        placed = [
            at(12 + k * room * Fraction(3, 5), 9 + k * room * Fraction(4, 5), turn=["3/5", "4/5"])
            for k in range(2)
        ]
        part = {"id": "a", "exterior": rect(0, 0, 5, 5)}
        normals = [[0, -1, 1, -1, "3", "4"]]
        found = layout([part], placed, cut, 40, spacing=str(spacing), apart=normals)
        found = {**found, "turns": [["3/5", "4/5"]] * 2}
        assert (room >= 5 + spacing) == is_proved(found)


def test_normals_point_from_one_body_to_the_other() -> None:
    part, turn = {"id": "a", "exterior": rect(0, 0, 5, 5)}, ["3/5", "4/5"]
    placed = [at(12 + 3 * k, 9 + 4 * k, turn=turn) for k in range(2)]
    found = {**layout([part], placed, [[rect(0, 0, 5, 5)]], 40), "turns": [turn] * 2}
    for normal in (["3", "4"], ["9", "12"], ["1/4", "1/3"]):
        assert prove(put(found, ("proof", "apart"), [[0, 0, 1, 0, *normal]]))
    for normal in (["0", "0"], ["-3", "-4"], ["4", "3"]):
        reason = refusal(put(found, ("proof", "apart"), [[0, 0, 1, 0, *normal]]))
        assert "placements[0] of 'a', piece 0: not apart from layout.placements[1]" in reason
    assert "not apart" in refusal(found)
    # A normal for these pieces has priority over one for all.
    both = [[0, 0, 1, 0, "3", "4"], [0, -1, 1, -1, "0", "1"]]
    assert prove(put(found, ("proof", "apart"), both))


def test_irrational_rotations_have_an_error() -> None:
    part = {"id": "L", "exterior": L}
    found = layout([part], [at(9, 9, "L", turn="45")], [PIECES_OF_L])
    near = {**found, "turns": [["20/29", "21/29"]]}
    assert prove(near)
    assert "container, piece " in refusal(put(near, (*PLACED, 0, "move"), ["3/2", "0"]))
    assert "is a different rotation" in refusal({**found, "turns": [["0", "0"]]})
    assert prove(put(near, (*PLACED, 0, "move"), ["8/5", "1/5"]))


@pytest.mark.parametrize("degrees", [0, 36, 90, 180, 270, 359])
def test_rotations_are_modulo_360_degrees(degrees: int) -> None:
    found = [rotation("turn", str(degrees + k)) for k in (0, 360, -720)]
    assert found == found[:1] * 3
    assert rotation("turn", "450") == (0, 1)
    assert rotation("turn", "719/2") == Fraction(719, 2)


@pytest.mark.parametrize("degrees", [1, 30, 45, 60, 89, 91, 135, 200, 271, 330, 359])
def test_the_bound_on_a_rotation_agrees_with_interval_arithmetic(degrees: int) -> None:
    from mpmath import iv

    before = iv.prec
    try:
        iv.prec = 400
        angle = iv.pi * degrees / 180
        to = [Fraction(round(float(f(angle).a) * 2**50), 2**50) for f in (iv.cos, iv.sin)]
        bound = Fraction(rotation_error(tuple(to), Fraction(degrees)))
        exact = sum(
            abs(iv.mpf(n.numerator) / n.denominator - f(angle))
            for n, f in zip(to, (iv.cos, iv.sin), strict=True)
        )
        written = iv.mpf(bound.numerator) / bound.denominator
        assert exact.b <= written.a
        assert (written - exact).b < iv.mpf(10) ** -87
    finally:
        iv.prec = before


@pytest.mark.parametrize(("spacing", "is_valid"), [("2", True), ("21/10", False), (None, False)])
def test_a_defect_may_have_its_own_spacing(spacing: Any, is_valid: bool) -> None:
    defect = {"exterior": rect(1, 1, 4, 4), "spacing": spacing}
    found = layout([SQUARE], [at(6, 3)], [[rect(0, 0, 2, 2)]], defects=[defect], margin="3")
    assert is_proved(found) is is_valid
    fault = {"kind": "too close", "placements": [0, -2], "point": ["5", "7/2"]}
    assert is_proved(with_faults(found, fault)) is not is_valid


@pytest.mark.parametrize(
    ("allowed", "is_valid"), [(None, False), (["0"], True), ([], False), (["90"], False)]
)
def test_mirrored_placements_may_have_their_own_rotations(allowed: Any, is_valid: bool) -> None:
    part = {**SQUARE, "turns": ["180"], "mirrored_turns": allowed}
    found = layout([part], [at(9, 9, mirrored=True)], [[rect(0, 0, 2, 2)]])
    assert is_proved(found) is is_valid
    turn = with_faults(found, {"kind": "turn", "part": "a"})
    assert is_proved(turn) is not is_valid
    assert not is_proved(put(found, (*PLACED, 0, "mirrored"), False))
