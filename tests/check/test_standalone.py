"""The checker that stands alone: sweeps, no-fit polygons and inner fits, proved and falsified."""

import json
import sys
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from tampering import get, put

from exactsweep import Region, inner_fit_polygon, no_fit_polygon, sweep
from exactsweep.check import standalone, verify
from exactsweep.check.standalone import Refused, prove
from exactsweep.evidence.proof import add_proof

Certificate = dict[str, Any]

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
HOUSE = [(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)]
NOTCHED = [(0, 0), (8, 0), (8, 5), (7, 5), (3, 1), (2, 5), (0, 5)]
SLOT = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 2), (0, 2)]
CAVE = [
    (0, 0),
    (4, 0),
    (4, 2),
    (3, 2),
    (3, 1),
    (1, 1),
    (1, 4),
    (3, 4),
    (3, 3),
    (4, 3),
    (4, 5),
    (0, 5),
]
ROOM = Region(
    [(0, 0), (6, 0), (6, 6), (0, 6)],
    [[(1, 1), (2, 1), (2, 2), (1, 2)], [(3, 2), (5, 4), (3, 4)], [(2, 2), (3, 4), (2, 4)]],
)
# The square goes into the bay, and sweeps around a hole of it.
BAY = [(0, 0), (1, 0), (1, 4), (5, 4), (5, 1), (3, 1), (3, 0), (6, 0), (6, 5), (0, 5)]
HOOK = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (3, 3), (3, 4), (0, 4)]


def certificates() -> dict[str, Certificate]:
    """A certificate of each kind, with exact fits, slits, holes, reference points."""
    made: dict[str, Any] = {
        "CC": sweep(HOUSE, SQUARE),
        "CM": sweep(SQUARE, NOTCHED, reference=("1/3", -2)),
        "MM": sweep(NOTCHED, SLOT),
        "fit": sweep(SQUARE, SLOT, reference=(5, 7)),
        "SS": sweep(HOOK, CAVE),
        "unswept": sweep(SQUARE, BAY),
        "cave": no_fit_polygon(CAVE, SQUARE),
        "room": no_fit_polygon(ROOM, SQUARE),
        "inside": inner_fit_polygon(ROOM, SQUARE),
        "inside exactly": inner_fit_polygon(SLOT, SQUARE),
        "nowhere": inner_fit_polygon(SQUARE, HOUSE),
    }
    return {name: add_proof(json.loads(json.dumps(a.certificate()))) for name, a in made.items()}


CERTIFICATES = certificates()


@pytest.mark.parametrize("name", CERTIFICATES)
def test_certificates_of_every_kind_are_proved(name: str) -> None:
    certificate = CERTIFICATES[name]
    assert prove(certificate)
    assert verify(certificate).proved


def test_certificates_of_large_shapes_are_proved() -> None:
    large = [[(x * 999, y * 999) for x, y in s] for s in (CAVE, HOUSE)]
    one, other = (add_proof(no_fit_polygon(*pair).certificate()) for pair in ((CAVE, HOUSE), large))
    assert prove(other)
    assert one["proof"]["sums"] == other["proof"]["sums"]


def test_a_certificate_has_no_proof_unless_it_is_asked_for() -> None:
    for answer in (
        sweep(HOOK, CAVE),
        no_fit_polygon(CAVE, SQUARE),
        inner_fit_polygon(ROOM, SQUARE),
    ):
        assert "proof" not in answer.certificate()
        assert answer.certificate(proof=True) == add_proof(answer.certificate())


@pytest.mark.parametrize("ask", [sweep, no_fit_polygon, inner_fit_polygon])
def test_certificates_of_minute_shapes_are_proved(ask: Callable[..., Any]) -> None:
    minute = [[(x / Fraction(999), y / Fraction(999)) for x, y in s] for s in (CAVE, HOUSE)]
    one, other = (add_proof(ask(*pair).certificate()) for pair in ((CAVE, HOUSE), minute))
    assert prove(other)
    assert ask is not no_fit_polygon or one["proof"]["sums"] == other["proof"]["sums"]


def test_it_says_what_is_proved() -> None:
    assert prove(CERTIFICATES["CC"]) == (
        "CC sweep of 5 around 4 vertices, trajectory 6, inner 4, outer 8, area 22"
    )
    assert prove(CERTIFICATES["cave"]) == (
        "no-fit polygon of 4 around 12 vertices, 8 in 2 loops, 1 exact fit"
    )
    assert prove(CERTIFICATES["nowhere"]) == (
        "inner fit of 5 in 4 vertices, 0 in 0 loops, 0 exact fits"
    )


def places(item: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """All places of a certificate, of long lists the first and the last entry alone."""
    entries: list[tuple[Any, Any]] = []
    if type(item) is dict:
        entries = list(item.items())
    elif type(item) is list:
        entries = [(k, item[k]) for k in sorted({0, len(item) - 1}) if item]
    return [path, *(found for key, value in entries for found in places(value, (*path, key)))]


@pytest.mark.long
@pytest.mark.parametrize("name", CERTIFICATES)
def test_values_of_another_type_are_refused_at_every_place(name: str) -> None:
    certificate = CERTIFICATES[name]
    for path in places(certificate):
        if not path:
            continue
        true = get(certificate, path)
        others: tuple[Any, ...] = (None, True, 1.0, float("nan"), "nan", "1e3", {}, [[]], 10**30)
        for false in others:
            # The holes of a shape may be left out.
            if type(false) is not type(true) and (len(path), path[-1], false) != (2, "holes", None):
                assert not proves(put(certificate, path, false)), (path, false)


@pytest.mark.parametrize("name", CERTIFICATES)
def test_each_number_matters(name: str) -> None:
    certificate = CERTIFICATES[name]
    for path in places(certificate):
        if path and path[0] != "proof" and type(get(certificate, path)) is str:
            moved = "1/97" if path[-1] in (0, 1) else "x"
            assert not proves(put(certificate, path, moved)), path


def proves(certificate: Any) -> bool:
    try:
        prove(certificate)
    except Refused:
        return False
    return True


@pytest.mark.parametrize("name", CERTIFICATES)
def test_entries_that_are_left_out_or_there_twice_are_missed(name: str) -> None:
    certificate = CERTIFICATES[name]
    for path in places(certificate):
        item = get(certificate, path)
        if type(item) is not list or not item or path[-1] == "direction":
            continue
        for k in sorted({0, len(item) - 1}):
            assert not proves(put(certificate, path, item[:k] + item[k + 1 :])), path
            twice = item[: k + 1] + item[k:]
            # A point that is repeated counts once; a sum may be listed twice.
            if type(item[k]) is list and path[-1:] not in (("sums",), ("swept",)):
                is_point = item[k] and type(item[k][0]) is str
                assert is_point or not proves(put(certificate, path, twice)), path


def test_a_hole_does_not_pass_as_a_ring_of_fits_or_a_fit_as_a_hole() -> None:
    cave = CERTIFICATES["cave"]
    (hole,) = cave["holes"]
    ring = [[p, hole[k - 1]] for k, p in enumerate(hole)]
    assert not proves({**cave, "holes": [], "exact_fits": cave["exact_fits"] + ring})
    assert not proves({**cave, "holes": []})
    assert not proves({**cave, "holes": [hole, hole]})
    assert not proves({**cave, "exact_fits": []})


def claim(certificate: Certificate, **changes: Any) -> Certificate:
    """A certificate with other claims, and the proof that the finder has for them."""
    kept = {key: item for key, item in certificate.items() if key != "proof"}
    return add_proof({**kept, **changes})


FALSE = json.loads((Path(__file__).parent / "false_claims.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("case", FALSE, ids=[case["name"] for case in FALSE])
def test_false_claims_are_refused_with_a_proof_that_fits_them(case: dict[str, Any]) -> None:
    still, moving = (Region(first, holes) for first, *holes in (case["still"], case["moving"]))
    ask: dict[str, Callable[[Region, Region], Any]] = {
        "no_fit": no_fit_polygon,
        "inner_fit": inner_fit_polygon,
        "sweep": lambda still, moving: sweep(moving, still),
    }
    true = json.loads(json.dumps(ask[case["question"]](still, moving).certificate()))
    assert prove(add_proof(true))
    with pytest.raises(Refused, match=case["reason"]):
        prove(claim(true, **case["changes"]))


def test_entries_of_sums_are_a_number_and_a_chain_for_each_side() -> None:
    inside = CERTIFICATES["inside"]
    first, *rest = inside["proof"]["sums"]
    entries: tuple[Any, ...] = ([], [first[0]], [10**9, *first[1:]], [*first, first[1]], None)
    for entry in entries:
        assert not proves(put(inside, ("proof", "sums"), [entry, *rest])), entry


def test_entries_of_chains_have_points_of_the_side() -> None:
    fork = [(0, 0), (5, 0), (5, 4), (4, 4), (4, 1), (1, 1), (1, 4), (0, 4)]
    true = add_proof(json.loads(json.dumps(no_fit_polygon(fork, SQUARE).certificate())))
    sums = true["proof"]["sums"]
    left, right = -7, -3  # the upper edges of both tips, on one line
    k = next(k for k, entry in enumerate(sums) if left in entry)
    places = ("proof", "sums", k, sums[k].index(left))
    assert proves(put(true, places, [left, left]))
    for chain in ([right, left], [left, right]):
        assert not proves(put(true, places, chain)), chain


def test_a_fit_of_one_point_is_listed_once() -> None:
    """Copies of a point have one box without width, on the grid, which cannot be halved."""
    slanted = [(0, 2), (2, 0), (5, 3), (3, 5)]
    exactly = inner_fit_polygon(slanted, slanted).certificate()
    ((p, q),) = exactly["exact_fits"]
    assert p == q
    assert proves(add_proof(exactly))
    for count in (2, 3):
        twice = {**add_proof(exactly), "exact_fits": [[p, q]] * count}
        with pytest.raises(Refused, match="a fit of one point is on a loop or another fit"):
            prove(twice)


def test_a_frame_leaves_pieces_outside() -> None:
    wide = [(0, 0), (3, 0), (3, 3), (0, 3)]
    true = add_proof(json.loads(json.dumps(inner_fit_polygon(wide, SQUARE).certificate())))
    tight = {**true["proof"], "frame": ["0", "0", "3", "3"], "outside": []}
    with pytest.raises(Refused, match="there are no pieces"):
        prove({**true, "proof": tight})


@pytest.mark.parametrize("name", ["SS", "cave", "room", "inside"])
@pytest.mark.parametrize("shift", range(1, 4))
def test_pieces_begin_anywhere(name: str, shift: int) -> None:
    certificate = CERTIFICATES[name]
    proof = dict(certificate["proof"])
    for key in {"directrix", "generatrix", "outside", "part"} & {*proof}:
        proof[key] = [piece[shift:] + piece[:shift] for piece in proof[key]]
    assert proves({**certificate, "proof": proof})


@pytest.mark.parametrize("shift", range(5))
def test_no_piece_of_the_outside_is_inside_a_region(shift: int) -> None:
    case = next(case for case in FALSE if "the outside is not outside" in case["reason"])
    exterior, defect = case["still"]
    true = inner_fit_polygon(Region(exterior, [defect]), SQUARE).certificate()
    for certificate, holds in ((true, True), ({**true, **case["changes"]}, False)):
        proof = claim(certificate)["proof"]
        pieces, sums = proof["outside"], proof["sums"]
        assert (len(proof["part"]), len(pieces)) == (1, 5)
        proof["outside"] = pieces[shift:] + pieces[:shift]  # each of them once the first
        proof["sums"] = [[(k - shift) % 5, *sides] for k, *sides in sums]
        assert proves({**certificate, "proof": proof}) == holds


def test_a_frame_is_a_rectangle() -> None:
    inside = CERTIFICATES["inside"]
    left, low, right, high = inside["proof"]["frame"]
    for frame in ([right, low, left, high], [left, high, right, low], [left, low, left, high]):
        with pytest.raises(Refused, match="frame: not the ends of a rectangle"):
            prove(put(inside, ("proof", "frame"), frame))


def test_a_certificate_is_an_object_and_steps_are_an_int() -> None:
    others: tuple[Any, ...] = ([], None, "{}")
    for item in others:
        with pytest.raises(Refused, match="a certificate is an object"):
            prove(item)
    steps: Any = 1e9
    with pytest.raises(Refused, match="max_steps"):
        prove(CERTIFICATES["CC"], steps)


def test_loops_are_not_exchanged() -> None:
    cc = CERTIFICATES["CC"]
    assert not proves({**cc, "inner": cc["outer"], "outer": cc["inner"]})
    assert not proves({**cc, "kind": "CM"})
    assert not proves({**cc, "direction": [0, 0]})
    assert not proves({**cc, "direction": [2, 0]})
    assert not proves({**cc, "outer": cc["outer"][:1] + cc["outer"]})
    assert not proves({**CERTIFICATES["CM"], "direction": [0, 1]})
    assert not proves({**cc, "direction": ["1", "0"]})
    # A sweep of polygons with a shared direction has no other proof.
    assert not proves({**cc, "proof": CERTIFICATES["SS"]["proof"]})


def test_a_direction_is_one_of_the_two_that_are_opposite() -> None:
    # Convex polygons are monotone to every direction.
    for x, y in ((1, 0), (0, 1), (1, 1), (1, -1)):
        assert proves({**CERTIFICATES["CC"], "direction": [x, y]})
        assert not proves({**CERTIFICATES["CC"], "direction": [-x, -y]})


def test_interlocked_rings_are_proved() -> None:
    pair = Region(
        [(0, 0), (9, 0), (9, 9), (0, 9)],
        [[(1, 4), (4, 1), (4, 4)], [(4, 4), (7, 7), (4, 7)]],
    )
    certificate = add_proof(json.loads(json.dumps(no_fit_polygon(pair, pair).certificate())))
    assert prove(certificate)


def test_a_certificate_is_held_against_the_polygons_of_the_caller() -> None:
    cc = CERTIFICATES["CC"]
    assert verify(cc, generatrix=HOUSE, directrix=SQUARE).proved
    # Another start, another orientation, a straight angle, other spellings.
    respelled = [("2", 1), (2.0, 0), (1, 0), (0, 0), (0, 1), ("2/2", 2)]
    assert verify(cc, generatrix=respelled).proved
    moved = [(0, 0), (2, 0), (2, 1), ("1000000001/1000000000", 2), (0, 1)]
    assert verify(cc, generatrix=moved).reason == "generatrix: not the polygon that is given"
    assert not verify(cc, directrix=HOUSE).proved
    # A point that is repeated is a corner, and a spike is not a straight angle.
    assert verify(cc, generatrix=[*HOUSE, HOUSE[0]]).proved
    assert not verify(cc, generatrix=[*HOUSE, (-1, 2), (-1, 2)]).proved
    assert not verify(cc, generatrix=[(0, 0), (3, 0), *HOUSE[1:]]).proved
    assert not verify(cc, part=HOUSE).proved
    inside = CERTIFICATES["inside"]
    assert verify(inside, part=SQUARE, container=ROOM).proved
    assert not verify(inside, container=ROOM.exterior).proved


def test_values_that_cannot_be_compared_are_refused() -> None:
    class Hostile:
        def __eq__(self, other: object) -> bool:
            raise ValueError

        __hash__ = object.__hash__

    cc = CERTIFICATES["CC"]
    for key in ("format", "version", "kind", "contacts", "proof"):
        assert verify({**cc, key: Hostile()}).reason == "a Hostile is not JSON"
    assert not verify({**cc, Hostile(): 1}).proved


@pytest.mark.parametrize("steps", [float("nan"), float("inf"), True, 0, -1, 1.5, "9"])
def test_steps_are_a_positive_int(steps: Any) -> None:
    with pytest.raises(ValueError, match="max_steps"):
        verify(CERTIFICATES["CC"], max_steps=steps)


def test_no_more_steps_are_taken_than_allowed() -> None:
    with pytest.raises(Refused, match="too large"):
        prove(CERTIFICATES["SS"], 200)


@pytest.mark.parametrize("name", ["CM", "fit", "unswept", "nowhere"])
def test_steps_are_no_fewer_than_calls_by_far(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each list 50 times as long: what is done for its entries is counted in steps."""
    certificate, budgets, calls = CERTIFICATES[name], list[standalone.Work](), 0
    begin = standalone.Work.__init__

    def watch(frame: Any, event: str, _of: Any) -> None:
        nonlocal calls
        # The checker has no private functions; tools that wrap its functions may have some.
        code = frame.f_code
        its_own = code.co_filename == standalone.__file__ and code.co_name[0] != "_"
        calls += its_own and event in ("call", "c_call")

    def remember(work: standalone.Work, steps: float) -> None:
        begin(work, steps)
        budgets.append(work)

    monkeypatch.setattr(standalone.Work, "__init__", remember)
    for path in places(certificate):
        if type(item := get(certificate, path)) is list:
            longer, calls = put(certificate, path, 50 * item), 0
            sys.setprofile(watch)
            try:
                proves(longer)
            finally:
                sys.setprofile(None)
            assert calls < 120 * (standalone.MAX_STEPS - budgets[-1].left), path
