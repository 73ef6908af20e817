"""Hostile certificates of layouts: edges that cancel, malformed keys, and slow ones."""

from pathlib import Path
from typing import Any

import pytest
from certified import rect, with_faults
from checkers import check_agreement, needs_node

from exactsweep.check.standalone import Refused, prove

Certificate = dict[str, Any]
SPUR = [["0", "0"], ["4", "0"], ["10", "0"], ["7", "0"], ["4", "0"], ["4", "4"], ["0", "4"]]
BRIDGE = [*rect(10, 0, 14, 4)[1:], ["10", "0"], ["4", "0"], ["4", "4"], ["0", "4"], ["0", "0"]]
SLIT = [*rect(0, 0, 20, 10)[:3], ["10", "10"], ["10", "2"], ["10", "10"], ["0", "10"]]
OUTSIDE = [rect(-9, -9, 29, 0), rect(-9, 0, 0, 10), rect(20, 0, 29, 10), rect(-9, 10, 29, 19)]
LONG = 16000


def valid_layout(parts: list[Any], pieces: list[Any], moves: list[Any], **more: Any) -> Certificate:
    """Certify a layout of parts "0", "1", ...; `moves` lists parts and translations."""
    proof = {"pieces": pieces + more.pop("outside", [None]), "apart": more.pop("apart", [])}
    if "frame" in more:
        proof["frame"] = more.pop("frame")
    return {
        "format": "exactsweep certificate",
        "version": 3,
        "claim": "layout",
        "layout": {
            "parts": [{"id": str(k), **part} for k, part in enumerate(parts)],
            "placements": [{"part": str(k), "move": move} for k, move in moves],
            **more,
        },
        "turns": [["1", "0"]] * len(moves),
        "valid": True,
        "proof": proof,
    }


def two(ring: Any, other: Any, pieces: list[Any]) -> Certificate:
    parts = [{"exterior": ring}, {"exterior": other}]
    moves = [(0, ["0", "0"]), (1, ["0", "0"])]
    return valid_layout(parts, [pieces, [other]], moves, spacing="2")


def in_slit_container() -> Certificate:
    part, frame = rect(8, 3, 12, 6), ["-9", "-9", "29", "19"]
    more: Any = {"container": {"exterior": SLIT}, "outside": [OUTSIDE], "frame": frame}
    return valid_layout([{"exterior": part}], [[part]], [(0, ["0", "0"])], margin="1", **more)


SQUARE = rect(0, 0, 4, 4)
CANCELLING: dict[str, tuple[Certificate, list[int], list[str]]] = {
    "spur": (two(SPUR, rect(7, 1, 9, 3), [SQUARE]), [0, 1], ["8", "1/2"]),
    "bridge": (two(BRIDGE, rect(6, 1, 8, 3), [SQUARE, rect(10, 0, 14, 4)]), [0, 1], ["7", "1/2"]),
    "slit": (in_slit_container(), [0, -1], ["10", "4"]),
}


@pytest.mark.parametrize("name", CANCELLING)
def test_canceled_edges_have_no_distance(name: str) -> None:
    certificate, bodies, point = CANCELLING[name]
    assert prove(certificate).endswith("valid")
    fault = {"kind": "too close", "placements": bodies, "point": point}
    with pytest.raises(Refused, match="not near enough"):
        prove(with_faults(certificate, fault))


def disc(**more: Any) -> Certificate:
    part = {"pieces": [{"points": [["0", "0"]], "radius": "1"}], "demand": 2, **more}
    return valid_layout([part], [None], [(0, ["0", "0"])])


MISSING = {"kind": "missing", "part": "0"}
HOLES: Any = ("", 0, False, {})
MALFORMED = {
    **{f"holes {holes!r}": disc(holes=holes, demand=1) for holes in HOLES},
    **{
        f"null {key}": with_faults(disc(), {**MISSING, key: None})
        for key in ("point", "placements")
    },
}


@pytest.mark.parametrize("name", MALFORMED)
def test_keys_of_the_wrong_type_are_rejected(name: str) -> None:
    assert prove(disc(holes=[], demand=1))
    assert prove(with_faults(disc(), MISSING))
    with pytest.raises(Refused):
        prove(MALFORMED[name])


def discs(count: int, radius: str) -> dict[str, Any]:
    return {"pieces": [{"points": [["0", "0"]], "radius": radius}] * count}


DEFECT = {"pieces": [{"points": [["0", "9000000"]]}], "spacing": "1000000"}
FAR: Any = {"defects": [DEFECT], "outside": [None, None]}


def in_a_row(error: str, spacing: str) -> Certificate:
    """Place points in boxes that overlap when grown by the spacing of a defect."""
    moves = [(0, [str(3 * k), "0"]) for k in range(300)]
    return valid_layout([{**discs(1, "0"), "error": error}], [None], moves, spacing=spacing, **FAR)


THIRDS, SEVENTHS = "1/" + "3" * LONG, "1/" + "7" * (LONG + 1)
SLOW: dict[str, Certificate] = {
    "overlapping pieces": valid_layout([discs(900, "1")], [None], [(0, ["1" + "0" * 30000, "0"])]),
    "a long move": valid_layout([discs(900, "0")], [None], [(0, [THIRDS, SEVENTHS])]),
    "a long error": in_a_row(THIRDS, SEVENTHS),
    "a long normal": valid_layout(
        [{"pieces": [{"points": [[str(9 * k), str(9 * k)]], "radius": "1"} for k in range(200)]}]
        * 2,
        [None, None],
        [(0, ["0", "0"]), (1, ["2", "-2"])],
        **FAR,
        apart=[[0, -1, 1, -1, "1" + "0" * 30000, "-1" + "0" * 30000]],
    ),
}


@pytest.mark.parametrize("name", SLOW)
def test_long_numbers_are_charged_wherever_they_are_used(name: str) -> None:
    with pytest.raises(Refused, match="too large"):
        prove(SLOW[name])


@needs_node
def test_both_checkers_agree_on_hostile_layouts(tmp_path: Path) -> None:
    faulty = [
        with_faults(certificate, {"kind": "too close", "placements": bodies, "point": point})
        for certificate, bodies, point in CANCELLING.values()
    ]
    true = [certificate for certificate, *_ in CANCELLING.values()]
    assert check_agreement([*true, *faulty, *MALFORMED.values()], tmp_path) == len(true)
