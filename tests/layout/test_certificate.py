"""Certificates of layouts: written ones are proved, changed ones rejected."""

import copy
import json
from fractions import Fraction
from math import isqrt
from typing import Any

import pytest
from known_layouts import FAULTY, RING, SHEET, TILE, VALID
from layouts import box, lay, put

from exactsweep.check import standalone, verify
from exactsweep.layout import Layout, LayoutError, judge_layout
from exactsweep.layout.pieces import cut_outside

TINY = Fraction(1, 10**30)
# The left corner of the first part is at x = 3/2 exactly; singly rounded rotations miss this.
NEARLY = [
    lay(box(0, 0, 9, 9), {"t": TILE}, put("t", (2, 2), 30), put("t", (Fraction(1, 2) + by, "2.4")))
    for by in (-TINY, TINY)
]
ANGLED = {
    "10**-30 apart": NEARLY[0],
    "10**-30 more than the spacing": lay(
        box(-9, 0, 9, 9),
        {"t": TILE},
        put("t", (2, 2), 30),
        put("t", (Fraction(1, 4) - TINY, "2.4")),
        spacing="1/4",
    ),
    "turned by 30 degrees": lay(
        box(0, 0, 9, 9), {"t": TILE}, put("t", (2, 2), 30), put("t", (4, 2), 30), margin=1
    ),
    "turned by 30 degrees, with a spacing": lay(
        box(0, 0, 9, 9), {"t": TILE}, put("t", (2, 2), 30), put("t", (4, 2), "33.3"), spacing="1/3"
    ),
}
ANGLED_FAULTY = {
    "overlap, 10**-30 deep": NEARLY[1],
    "overlap": lay(SHEET, {"t": TILE}, put("t", (2, 2), 30), put("t", ("2.01", 2), "-30.001")),
    "overlap, left of the origin and below it": lay(
        box(-9, -9, 0, 0), {"t": TILE}, put("t", (-5, -5), 30), put("t", ("-4.8", "-4.9"), 30)
    ),
    "outside": lay(SHEET, {"t": TILE}, put("t", ("0.49999", 2), 30)),
    "too close": lay(
        SHEET, {"t": TILE}, put("t", (2, 2), 30), put("t", (4, 2), "33.3"), spacing="3/2"
    ),
    "margin": lay(SHEET, {"t": TILE}, put("t", ("0.5001", 2), 30), margin="1/1000"),
}


def prove(layout: Layout) -> dict[str, Any]:
    certificate: dict[str, Any] = json.loads(json.dumps(judge_layout(layout).certificate()))
    result = verify(certificate)
    assert result.proved, result.reason
    return certificate


@pytest.mark.parametrize("name", [*VALID, *ANGLED])
def test_valid_layouts_are_proved(name: str) -> None:
    certificate = prove((VALID | ANGLED)[name])
    assert certificate["valid"]
    assert "faults" not in certificate


@pytest.mark.parametrize("name", FAULTY)
def test_all_faults_are_proved(name: str) -> None:
    layout, expected = FAULTY[name]
    certificate = prove(layout)
    assert not certificate["valid"]
    # Each part has at most one fault of rotation or mirroring.
    kinds = {kind for kind, _ in expected}
    assert {fault["kind"] for fault in certificate["faults"]} == kinds
    pairs = [where for kind, where in expected if kind in ("overlap", "outside", "too close")]
    # -1 is the outside of the container.
    bodies = [(*where, -1)[:2] for where in pairs]
    listed = [tuple(f["placements"]) for f in certificate["faults"] if "placements" in f]
    assert listed == bodies


@pytest.mark.parametrize("kind", ANGLED_FAULTY)
def test_faults_of_parts_at_any_angle_are_proved(kind: str) -> None:
    (fault,) = prove(ANGLED_FAULTY[kind])["faults"]
    assert fault["kind"] == kind.partition(",")[0].replace("margin", "too close")


@pytest.mark.parametrize("digits", range(17, 23))
@pytest.mark.parametrize("kind", ["spacing", "margin"])
def test_gaps_at_the_limit_of_rational_rotations_are_proved(kind: str, digits: int) -> None:
    """Squares of diagonal sqrt(2); the first rational rotations are off by about 1e-19."""
    root = Fraction(isqrt(2 * 100**digits), 10**digits)
    for reach in (root, root + Fraction(1, 10**digits)):
        gap = str(2 * (3 - reach))
        if kind == "margin":
            walls, large = box(-20, -20, 6, 20), box(-2, -2, 2, 2)
            layout = lay(walls, {"s": large}, put("s", turn=45), margin=gap)
        else:
            places = (put("s", (x, 0), 45) for x in (-3, 3))
            layout = lay(box(-20, -20, 20, 20), {"s": box(-1, -1, 1, 1)}, *places, spacing=gap)
        judgement = judge_layout(layout)
        assert judgement.valid == (reach != root)
        assert verify(judgement.certificate()).proved


@pytest.mark.parametrize(("x", "y"), [(3, 4), (-3, 4), (-4, 3)])
def test_corners_at_exactly_the_spacing_are_proved(x: int, y: int) -> None:
    """No edge is perpendicular to the separating direction."""
    at = 10 + x + (1 if x > 0 else -1), 10 + y + 1
    prove(lay(box(0, 0, 30, 30), {"t": TILE}, put("t", (10, 10)), put("t", at), spacing=5))


def test_undecided_faults_have_no_certificate() -> None:
    layout = lay(SHEET, {"t": TILE}, put("t", (5, 0), 45))
    (fault,) = judge_layout(layout).faults
    assert fault.kind == "undecided"
    with pytest.raises(LayoutError, match="no certificate"):
        judge_layout(layout).certificate()


def test_a_fault_is_proved_despite_an_undecided_one() -> None:
    layout = lay(SHEET, {"t": TILE}, put("t", (5, 0), 45), put("t", (20, 5)))
    assert [fault.kind for fault in judge_layout(layout).faults] == ["outside", "undecided"]
    assert len(prove(layout)["faults"]) == 1


UNSIMPLE = {
    "crossing": ([(0, 0), (1, 1), (1, 0), (0, 1)], []),
    "crossing, with a repeated vertex": ([(0, 0), (0, 0), (1, 1), (1, 0), (0, 1), (0, 1)], []),
    "around twice": ([*box(0, 0, 4, 4), *box(0, 0, 4, 4)], []),
    "around a part of it twice": ([(0, 0), (4, 0), (4, 4), (1, 1), (3, 1), (0, 4)], []),
    "a hole that crosses itself": (
        box(-1, -1, 5, 5),
        [[(0, 0), (1, 1), (1, 0), (0, 1)]],
    ),
    "a hole across the exterior": (box(0, 0, 4, 4), [box(1, 1, 3, 5)]),
    "a hole across the exterior, which it touches before": (
        [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)],
        [[(1, 3), (-1, 1), (2, 0), (3, 1)]],
    ),
    "a hole elsewhere": (TILE, [box(3, 3, 4, 4)]),
    "a hole in a hole": (box(0, 0, 9, 9), [box(1, 1, 8, 8), box(2, 2, 3, 3)]),
    "a hole twice": (box(0, 0, 9, 9), [box(1, 1, 8, 8), box(1, 1, 8, 8)]),
}
# Rings with winding numbers 0 or 1 everywhere that are not simple.
TOUCHING = {
    "vertex on an edge": [(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)],
    "vertices coincide": [(0, 0), (2, 2), (4, 0), (4, 4), (2, 2), (0, 4)],
    "spike": [(0, 0), (4, 0), (6, 0), (4, 0), (4, 4)],
    "flat": [(0, 0), (4, 0), (2, 0)],
    "two vertices": [(0, 0), (4, 0), (4, 0)],
}


@pytest.mark.parametrize("name", UNSIMPLE)
def test_nonsimple_parts_are_proved(name: str) -> None:
    exterior, holes = UNSIMPLE[name]
    layout = lay(SHEET, {"p": {"exterior": exterior, "holes": holes}}, put("p"))
    (fault,) = prove(layout)["faults"]
    assert (fault["kind"], fault["part"]) == ("shape", "p")


@pytest.mark.parametrize("name", TOUCHING)
def test_faults_of_touching_rings_have_no_certificate(name: str) -> None:
    layout = lay(SHEET, {"p": TOUCHING[name]}, put("p"))
    assert [fault.kind for fault in judge_layout(layout).faults] == ["shape"]
    with pytest.raises(LayoutError, match="no certificate"):
        judge_layout(layout).certificate()


def test_other_faults_are_proved_despite_touching_rings() -> None:
    parts = {"p": TOUCHING["spike"], "t": TILE}
    layout = lay(SHEET, parts, put("p"), put("t", (-1, 0)))
    assert [fault["kind"] for fault in prove(layout)["faults"]] == ["outside"]


def falsify(certificate: dict[str, Any], change: Any) -> dict[str, Any]:
    false = copy.deepcopy(certificate)
    change(false)
    return false


def test_changed_certificates_are_rejected() -> None:
    # No single normal separates the ring and the block in it: there are pieces on all sides.
    layout = lay(
        box(0, 0, 4, 4),
        {"r": RING, "t": [(0, 1), (1, 0), (2, 1), (1, 2)]},
        put("r"),
        put("t", (1, 1)),
    )
    certificate = prove(layout)
    proof = certificate["proof"]
    for k in range(len(proof["apart"])):
        assert not verify(falsify(certificate, lambda c, k=k: c["proof"]["apart"].pop(k))).proved
    for n, pieces in enumerate(proof["pieces"]):
        for k in range(len(pieces)):
            less = falsify(certificate, lambda c, n=n, k=k: c["proof"]["pieces"][n].pop(k))
            assert not verify(less).proved
    for move in (["1", "999/1000"], ["1000000001/1000000000", "1"], ["7", "1"]):
        moved = falsify(certificate, lambda c, m=move: c["layout"]["placements"][1].update(move=m))
        assert not verify(moved).proved
    assert not verify(falsify(certificate, lambda c: c.update(valid=False))).proved
    assert not verify(falsify(certificate, lambda c: c["layout"].update(spacing="1/100"))).proved
    assert not verify(falsify(certificate, lambda c: c["layout"].update(margin="1/100"))).proved


@pytest.mark.parametrize(
    ("exterior", "pieces"),
    [
        (box(0, 0, 2, 2), 4),
        ([(0, 0), (2, 0), (1, 2)], 6),
        ([(1, 0), (2, 1), (1, 2), (0, 1)], 8),
        # A notch in one side, one in a corner.
        ([(0, 0), (4, 0), (4, 4), (3, 4), (2, 2), (1, 4), (0, 4)], 5),
        ([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)], 5),
    ],
)
def test_the_outside_is_cut_into_rectangles_and_pockets(exterior: Any, pieces: int) -> None:
    found = cut_outside(exterior, (-1, -1, 9, 9))
    assert len(found) == pieces
    assert all(len({*piece}) == len(piece) for piece in found)
    prove(lay(exterior, {"t": box(0, 0, "1/8", "1/8")}, put("t", ("15/16", "3/4"))))


def square(x: object, y: object, size: int) -> list[list[str]]:
    left, low = Fraction(str(x)), Fraction(str(y))
    ends = (left, low), (left + size, low), (left + size, low + size), (left, low + size)
    return [[str(a), str(b)] for a, b in ends]


@pytest.mark.parametrize(
    ("move", "margin", "bodies"),
    [
        ((3, 3), "0", None),
        ((0, 0), "0", [0, -2]),
        ((1, 6), "0", [0, -4]),
        ((6, 6), "0", [0, -1]),
        ((9, 3), "0", [0, -1]),
        ((3, 1), "1", None),
        (("2.5", 2), "1", [0, -3]),
    ],
)
def test_crossing_defects_are_separate_obstacles(
    move: tuple[object, object], margin: str, bodies: list[int] | None
) -> None:
    """Defect k is -2 - k; holes of the container belong to its outside, -1."""
    data = {
        "container": {"exterior": square(0, 0, 10), "holes": [square(7, 7, 1)]},
        "defects": [{"exterior": square(x, y, 2)} for x, y in ((-1, -1), (0, 4), (1, 5))],
        "parts": [{"id": "a", "exterior": square(0, 0, 2)}],
        "placements": [{"part": "a", "move": [str(c) for c in move]}],
        "margin": margin,
    }
    certificate = judge_layout(Layout.from_json(data)).certificate()
    assert standalone.prove(certificate)
    assert certificate["valid"] is (bodies is None)
    if bodies is not None:
        assert bodies in [fault["placements"] for fault in certificate["faults"]]


@pytest.mark.parametrize(
    ("change", "kinds"),
    [
        ({"defects": [{"exterior": square(0, 0, 1), "spacing": "2"}]}, []),
        ({"defects": [{"exterior": square(0, 0, 1), "spacing": "3"}]}, ["too close"]),
        (
            {"defects": [{"exterior": square(0, 0, 1), "spacing": "3"}], "margin": "1/2"},
            ["too close"],
        ),
        ({"parts": [{"id": "a", "exterior": square(0, 0, 2), "mirrored_turns": ["0"]}]}, []),
    ],
)
def test_rules_of_defects_and_mirrored_placements_are_proved(
    change: dict[str, Any], kinds: list[str]
) -> None:
    data = {
        "container": {"exterior": square(0, 0, 10)},
        "parts": [{"id": "a", "exterior": square(0, 0, 2)}],
        "placements": [{"part": "a", "move": ["3", "1/2"]}],
    }
    judgement = judge_layout(Layout.from_json(data | change))
    assert [fault.kind for fault in judgement.faults] == kinds
    assert standalone.prove(judgement.certificate())
