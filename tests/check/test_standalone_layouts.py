"""Certificates of layouts, written by hand, and the small checker that proves them."""

import copy
import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from exactsweep.check import verify
from exactsweep.check.standalone import Refused, load, prove, turn_error
from exactsweep.cli.verify import _describe
from exactsweep.numbers.number import Rational

CASES = json.loads((Path(__file__).parent / "layout_claims.json").read_text(encoding="utf-8"))
SQUARE = [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]]
L = [["0", "0"], ["2", "0"], ["2", "1"], ["1", "1"], ["1", "2"], ["0", "2"]]


def box(left: Rational, low: int, right: Rational, high: int) -> list[list[str]]:
    return [[str(x), str(y)] for x, y in ((left, low), (right, low), (right, high), (left, high))]


def certificate(**changes: Any) -> dict[str, Any]:
    """Two Ls that fill a box of 3 x 2 but for nothing."""
    found = {
        "format": "exactsweep certificate",
        "version": 2,
        "kind": "layout",
        "layout": {
            "container": {"exterior": box(0, 0, 3, 2)},
            "parts": [{"id": "L", "exterior": L, "demand": 2, "turns": ["0", "180"]}],
            "placements": [
                {"part": "L", "turn": "0", "move": ["0", "0"]},
                {"part": "L", "turn": "180", "move": ["3", "2"]},
            ],
        },
        "valid": True,
        "turns": [["1", "0"], ["-1", "0"]],
        "frame": ["-1", "-1", "4", "3"],
        "pieces": [[box(0, 0, 2, 1), box(0, 1, 1, 2)]],
        "outside": [box(-1, -1, 4, 0), box(3, 0, 4, 2), box(-1, 2, 4, 3), box(-1, 0, 0, 2)],
        "apart": [],
        "faults": [],
    }
    return {**found, **changes}


def changed(path: str, value: Any) -> dict[str, Any]:
    """The certificate with one entry changed, or without it."""
    found = copy.deepcopy(certificate())
    *way, last = [int(key) if key.lstrip("-").isdigit() else key for key in path.split(".")]
    at: Any = found
    for key in way:
        at = at[key]
    if value is None:
        del at[last]
    else:
        at[last] = value
    return found


def refusal(certificate: Any) -> str:
    with pytest.raises(Refused) as refused:
        prove(certificate)
    return str(refused.value)


def test_a_demand_may_have_any_size() -> None:
    asked = changed("layout.parts.0.demand", 10**30)
    assert "a part breaks rules: ['missing']" in refusal(asked)


def test_a_spacing_may_be_longer_than_python_prints() -> None:
    long = certificate()
    long["layout"] |= {"spacing": "8" * 5000, "margin": "9" * 5000}
    long["layout"]["placements"], long["turns"], long["apart"] = [], [], []
    for part in long["layout"]["parts"]:
        part.pop("demand", None)
    assert verify(long).proved
    assert prove(long).endswith(f"spacing {'8' * 5000}, margin {'9' * 5000}")


def test_a_layout_that_fills_its_container_is_proved() -> None:
    assert prove(certificate()) == "layout of 2 placements of 1 part, valid, spacing 0, margin 0"
    assert prove(load(json.dumps(certificate())))
    assert verify(certificate()).proved
    assert (
        verify(changed("layout.spacing", "1")).reason
        == "piece 0 of 0 and piece 0 of 1: no normal that parts them"
    )


@pytest.mark.parametrize(("path", "value", "reason"), CASES["changes"])
def test_a_single_change_is_refused(path: str, value: Any, reason: str) -> None:
    assert reason in refusal(changed(path, value))


def test_a_number_of_too_many_digits_is_refused() -> None:
    assert "too large" in refusal(changed("layout.placements.0.move.0", "9" * 1_000_001))


@pytest.mark.parametrize("value", [1, 2.0, "x", [], {}, True])
def test_values_of_other_types_are_refused_everywhere(value: Any) -> None:
    for key, true in certificate().items():
        if type(true) is not type(value) or true != value:
            refusal(certificate(**{key: value}))


def test_pieces_that_overlap_are_refused_though_edges_cancel() -> None:
    # Two turns around: the winding number of the ring is 2 inside.
    twice = L + L
    assert refusal(
        {
            **changed("layout.parts.0.exterior", twice),
            "pieces": [2 * certificate()["pieces"][0]],
        }
    )


def triangles(*apart: Any) -> dict[str, Any]:
    """Two triangles along a diagonal of their box."""
    return certificate(
        layout={
            "container": {"exterior": box(0, 0, 1, 1)},
            "parts": [{"id": "t", "exterior": [["0", "0"], ["1", "0"], ["0", "1"]]}],
            "placements": [
                {"part": "t", "turn": "0", "move": ["0", "0"]},
                {"part": "t", "turn": ["-1", "0"], "move": ["1", "1"]},
            ],
        },
        frame=["-1", "-1", "2", "2"],
        pieces=[[[["0", "0"], ["1", "0"], ["0", "1"]]]],
        outside=[box(-1, -1, 2, 0), box(1, 0, 2, 1), box(-1, 1, 2, 2), box(-1, 0, 0, 1)],
        apart=[*apart],
    )


def test_pieces_whose_boxes_meet_need_a_normal() -> None:
    assert prove(triangles([0, 0, 1, 0, "1/3", "1/3"]))
    assert prove(triangles([0, -1, 1, -1, "2", "2"]))
    for x, y in (("-1", "-1"), ("0", "0"), ("1", "2"), ("1", "0")):
        assert "no normal" in refusal(triangles([0, 0, 1, 0, x, y]))
    assert "no normal" in refusal(triangles())
    assert "no normal" in refusal(triangles([1, 0, 0, 0, "1", "1"]))
    for entry in ([0, True, 1, 0, "1", "1"], [0, 0, 1, 0, 1, "1"], [0, 0, 1, 0, "1"]):
        refusal(triangles(entry))


def test_repeated_keys_are_refused() -> None:
    with pytest.raises(Refused, match="twice"):
        load('{"format": 1, "format": 1}')


def turned(degrees: str, cosine: str, sine: str, **changes: Any) -> dict[str, Any]:
    """A unit square turned about its corner (0, 0), in a box of 4 x 4."""
    return certificate(
        layout={
            "container": {"exterior": box(-2, -2, 2, 2)},
            "parts": [{"id": "", "exterior": SQUARE}],
            "placements": [{"part": "", "turn": degrees, "move": ["0", "0"]}],
        },
        turns=[[cosine, sine]],
        frame=["-3", "-3", "3", "3"],
        pieces=[[SQUARE]],
        outside=[box(-3, -3, 3, -2), box(2, -2, 3, 2), box(-3, 2, 3, 3), box(-3, -2, -2, 2)],
        **changes,
    )


def test_a_turn_by_any_angle_has_the_error_that_the_checker_finds() -> None:
    # arctan(3/4) is 36.86989764... degrees.
    assert prove(turned("36", "4/5", "3/5"))
    # Off by more than a right angle, the square could be anywhere.
    assert "beyond the frame" in refusal(turned("300", "4/5", "3/5"))
    assert "turns" in refusal(turned("90", "4/5", "3/5"))


def in_units(item: Any, unit: Fraction) -> Any:
    """The same certificate in other units of length; turns, names and counts stay."""
    if isinstance(item, dict):
        kept = "turn", "turns", "id", "part", "kind", "format"
        return {key: e if key in kept else in_units(e, unit) for key, e in item.items()}
    if isinstance(item, list):
        return [in_units(each, unit) for each in item]
    return str(Fraction(item) * unit) if isinstance(item, str) else item


@pytest.mark.parametrize("power", [-99, -31, -28, 0, 24, 28, 29, 30, 31, 99])
def test_units_of_length_do_not_matter(power: int) -> None:
    """Boxes are rounded to a grid of about 2**30 cells across, however wide the frame is."""
    unit = Fraction(2) ** power
    assert prove(in_units(certificate(), unit))
    for path, value in (("layout.spacing", "1/9"), ("layout.margin", "1/9")):
        assert "no normal" in refusal(in_units(changed(path, value), unit))
    for x in ("29/10", "31/10"):
        assert refusal(in_units(changed("layout.placements.1.move.0", x), unit))
    far = changed("layout.placements.1.move", ["3", "1"])
    assert refusal(in_units(far, unit))


def beside(first: Any, second: Any, gap: Fraction, wall: Fraction, *faults: Any) -> Any:
    """Squares with a gap between their nearest corners, and one between the second and a wall."""
    move, end = gap + Fraction(7, 5), gap + wall + Fraction(11, 5)
    both = turned("36", "4/5", "3/5", valid=not faults, faults=[*faults])
    both["turns"] *= 2
    both["layout"]["spacing"], both["layout"]["margin"] = "1/2", "1/4"
    both["layout"]["container"]["exterior"] = box(-2, -2, end, 2)
    both["layout"]["placements"] = [
        {"part": "", "turn": first, "move": ["0", "0"]},
        {"part": "", "turn": second, "move": [str(move), "-1/5"]},
    ]
    both["frame"][2] = str(end + 1)
    both["outside"][:3] = box(-3, -3, end + 1, -2), box(end, -2, end + 1, 2), box(-3, 2, end + 1, 3)
    return both


LEAST = Fraction(1, 10**9)


@pytest.mark.parametrize("first", ["36", ["4/5", "3/5"]])
@pytest.mark.parametrize("second", ["36", ["4/5", "3/5"]])
def test_errors_of_turns_add_to_distances_and_depths(first: Any, second: Any) -> None:
    error = 2 * turn_error((Fraction(4, 5), Fraction(3, 5)), Fraction(36))
    one, other = (error * (turn == "36") for turn in (first, second))
    apart, inside = Fraction(1, 2) + one + other, Fraction(1, 4) + other
    assert prove(beside(first, second, apart, inside))
    for gap, wall in ((apart - LEAST, inside), (apart, inside - LEAST)):
        assert "no normal" in refusal(beside(first, second, gap, wall))
    # Where the frame is the wall, there is nothing outside it.
    for wall in (inside, inside - LEAST):
        open_ended = beside(first, second, apart, wall)
        end = open_ended["layout"]["container"]["exterior"][1][0]
        open_ended["frame"][2] = end
        open_ended["outside"][:3] = box(-3, -3, end, -2), box(-3, 2, end, 3)
        assert prove(open_ended) if wall == inside else "frame" in refusal(open_ended)

    def fault(kind: str, gap: Fraction, *points: tuple[Fraction, Fraction]) -> Any:
        listed = [[str(x), str(y)] for x, y in points]
        witness = {"kind": kind, "placements": [0, 1], "pieces": [0, 0], "points": listed}
        return beside(first, second, gap, inside, witness)

    corner = Fraction(4, 5), Fraction(3, 5)
    for room in (one + other, one + other + LEAST):
        gap = Fraction(1, 2) - room
        close = fault("too close", gap, corner, (corner[0] + gap, corner[1]))
        assert prove(close) if room > one + other else "do not show" in refusal(close)
    # The second square is 1/5 below the first, and the point below the middle of its upper side.
    for depth in (other, other + LEAST):
        height = 1 - depth
        point = (2 - 3 * height) / 5, (Fraction(1, 2) + 4 * height) / 5
        overlap = fault("overlap", Fraction(-7, 5), point, point)
        assert prove(overlap) if depth > other else "do not show" in refusal(overlap)


def faulty(*faults: Any, **changes: Any) -> dict[str, Any]:
    """Two Ls that overlap, one of them outside by one, with faults."""
    found = changed("layout.placements.1.move", ["3", "1"])
    found["layout"]["spacing"] = found["layout"]["margin"] = "1/2"
    return {**found, "valid": False, "faults": [*faults], **changes}


OVERLAP, OUTSIDE, CLOSE = (CASES["witnesses"][kind] for kind in ("overlap", "outside", "too close"))


def test_faults_are_proved_by_their_witnesses() -> None:
    assert prove(faulty(OVERLAP, OUTSIDE, CLOSE)).endswith("not valid: 3 faults")
    near = {**CLOSE, "placements": [1, 0], "pieces": [0, 0]}
    near["points"] = [["3", "1/2"], ["2", "1/2"]]
    far = faulty(near)
    assert "too close" in refusal(far)
    far["layout"]["spacing"] = "2"
    assert prove(far)


@pytest.mark.parametrize(("kind", "change"), CASES["false witnesses"])
def test_a_false_witness_is_refused(kind: str, change: dict[str, Any]) -> None:
    assert refusal(faulty({**CASES["witnesses"][kind], **change}))


def test_no_fault_is_counted_twice() -> None:
    across = {**OVERLAP, "placements": [1, 0]}
    close = {**OVERLAP, "kind": "too close"}
    surplus = {"kind": "surplus", "part": "L"}
    for again in (OVERLAP, across, close):
        assert "there twice" in refusal(faulty(OVERLAP, OUTSIDE, again))
    for faults in ([surplus], [surplus, OVERLAP], [surplus, surplus]):
        found = faulty(*faults)
        found["layout"]["parts"][0]["demand"] = 1
        assert prove(found) if faults[-1:] != faults[:-1] else "there twice" in refusal(found)


CLASH = {"kind": "shape", "part": "L", "edges": [[0, 0], [0, 3]]}


@pytest.mark.parametrize(("fault", "reason"), CASES["faults"])
def test_a_fault_that_the_layout_does_not_have_is_refused(
    fault: dict[str, Any], reason: str
) -> None:
    assert reason in refusal(faulty(fault))


def test_edges_of_two_rings_clash_only_where_they_cross() -> None:
    # A hole touches the exterior at a point, or crosses it.
    hole = [["1", "0"], ["3/2", "1/2"], ["1/2", "1/2"]]
    fault = {**CLASH, "edges": [[0, 0], [1, 0]]}
    touching = faulty(fault, pieces=[None])
    touching["layout"]["parts"][0]["holes"] = [hole]
    assert "do not clash" in refusal(touching)
    crossing = copy.deepcopy(touching)
    crossing["layout"]["parts"][0]["holes"] = [[["1", "-1"], *hole[1:]]]
    assert prove(crossing)
    # Moves are read although no pieces are there to be moved.
    for move in (None, [], ["1"], ["1", "one"]):
        crossing["layout"]["placements"][0]["move"] = move
        assert refusal(crossing)


def test_a_valid_layout_has_pieces_of_all_shapes() -> None:
    for changes in ({"pieces": [None]}, {"outside": None}):
        assert "pieces: some are missing" in refusal(certificate(**changes))


def test_a_frame_has_its_ends_in_order() -> None:
    assert prove(faulty(OVERLAP))
    for ends in ("4 3 -1 -1", "4 -1 4 3", "-1 3 4 3"):
        assert "frame: not the ends" in refusal(faulty(OVERLAP, frame=ends.split()))


def test_a_certificate_is_described_by_what_it_claims() -> None:
    assert _describe(certificate()) == "layout of 2 placements, valid"
    assert _describe(faulty(OVERLAP)) == "layout of 2 placements, 1 fault"


def alone(exterior: Any, holes: Any, *pieces: Any) -> dict[str, Any]:
    """One part in a box of 2 x 2."""
    return certificate(
        layout={
            "container": {"exterior": box(0, 0, 2, 2)},
            "parts": [{"id": "p", "exterior": exterior, "holes": holes}],
            "placements": [{"part": "p", "turn": "0", "move": ["0", "0"]}],
        },
        turns=[["1", "0"]],
        frame=["-1", "-1", "3", "3"],
        pieces=[[*pieces]],
        outside=[box(-1, -1, 3, 0), box(2, 0, 3, 2), box(-1, 2, 3, 3), box(-1, 0, 0, 2)],
    )


def test_a_part_is_in_one_piece() -> None:
    # A hole that touches the exterior once leaves one piece, twice or four times it does not.
    west, south, east, north = ["0", "1"], ["1", "0"], ["2", "1"], ["1", "2"]
    corners = [
        [west, ["0", "0"], south],
        [south, ["2", "0"], east],
        [east, ["2", "2"], north],
        [north, ["0", "2"], west],
    ]
    apart = alone(box(0, 0, 2, 2), [[south, east, north, west]], *corners)
    assert "falls apart" in refusal(apart)
    slot = alone(
        box(0, 0, 2, 2), [[south, east, west]], *corners[:2], [west, east, *box(0, 0, 2, 2)[2:]]
    )
    assert "falls apart" in refusal(slot)
    notch = [south, ["3/2", "1"], ["1/2", "1"]]
    left = [["0", "0"], south, ["1/2", "1"], ["0", "1"]]
    right = [south, ["2", "0"], east, ["3/2", "1"]]
    assert prove(alone(box(0, 0, 2, 2), [notch], left, right, box(0, 1, 2, 2)))


def test_a_ring_that_touches_itself_is_refused() -> None:
    eight = [*box(0, 0, 1, 1)[:2], ["1", "1"], *box(1, 1, 2, 2)[1:], ["1", "1"], ["0", "1"]]
    assert "not simple" in refusal(alone(eight, [], box(0, 0, 1, 1), box(1, 1, 2, 2)))


def test_ids_are_strings_and_each_of_one_part() -> None:
    for ids in (["L", "L"], ["L", 1], ["L", None]):
        found = certificate(pieces=certificate()["pieces"] * 2)
        part = found["layout"]["parts"][0]
        del part["demand"]
        found["layout"]["parts"] = [{**part, "id": name} for name in ids]
        assert "ids are strings" in refusal(found)
