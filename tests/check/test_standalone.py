"""The standalone checker: sweeps, no-fit polygons and inner fits, proved and rejected."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
from certified import CAVE, HOUSE, SQUARE, certificates
from tampering import get, put

from exactsweep import Region, inner_fit_polygon, no_fit_polygon
from exactsweep.check.standalone import Refused, covers, is_convex, node, prove, winding
from exactsweep.check.standalone import edges as list_edges
from exactsweep.evidence.proof import add_proof

Path = tuple[Any, ...]


def refusal(certificate: Any) -> str:
    with pytest.raises(Refused) as caught:
        prove(certificate)
    return str(caught.value)


@pytest.mark.parametrize("name", certificates())
def test_certificates_of_every_kind_are_proved(name: str) -> None:
    assert prove(certificates()[name])


def test_the_size_of_shapes_does_not_matter() -> None:
    pairs = [[(x * k, y * k) for x, y in CAVE] for k in (1, 10**40)]
    found = [json.loads(json.dumps(no_fit_polygon(pair, HOUSE).certificate())) for pair in pairs]
    assert all(map(prove, found))


# --- Every condition ------------------------------------------------------------------------------


def drop(path: Path) -> Callable[[Any], Any]:
    def change(certificate: Any) -> Any:
        changed = copy.deepcopy(certificate)
        del get(changed, path[:-1])[path[-1]]
        return changed

    return change


def change(*path: Any, to: Any) -> Callable[[Any], Any]:
    def made(certificate: Any) -> Any:
        value = to(get(certificate, path)) if callable(to) else to
        return put(certificate, path, value)

    return made


CONDITIONS = {
    "a key is missing": ("cave", drop(("holes",)), "holes: missing"),
    "an additional key": ("cave", change("x", to=1), "certificate: not an object with keys"),
    "not an object": ("cave", change("proof", to=[]), "proof: not an object with keys"),
    "not a list": ("cave", change("holes", to={}), "holes: not a list"),
    "a list of another length": (
        "cave",
        change("exterior", 0, to=["1"]),
        "not a list of 2 entries",
    ),
    "an invalid index": (
        "cave",
        change("proof", "sums", 0, 0, to="0"),
        "proof.sums[0][0]: not of type int",
    ),
    "an index too large": (
        "cave",
        change("proof", "sums", 0, 0, to=99),
        "sums: there is no sum 99",
    ),
    "an index far too large": (
        "cave",
        change("proof", "sums", 0, 0, to=10**9),
        "proof.sums[0][0]: not of type int",
    ),
    "an entry without a number": (
        "cave",
        change("proof", "sums", 0, to=[]),
        "proof.sums[0]: not a list of 2",
    ),
    "not a chain": ("cave", change("proof", "sums", 0, 1, 0, to=0), "sums[0][1][0]: not a list"),
    "too few chains": ("cave", drop(("proof", "sums", 0, 1, 0)), "sums[0]: "),
    "not a number": ("cave", change("exterior", 0, 0, to=-1), "not a number in a string"),
    "not in lowest terms": ("cave", change("exterior", 0, 0, to="-2/2"), "not in lowest terms"),
    "a ring of two points": (
        "cave",
        change("directrix", "exterior", to=[["0", "0"], ["1", "0"], ["1", "0"]]),
        "directrix.exterior: a ring of fewer than three points",
    ),
    "no rectangle": ("inside", change("proof", "frame", 2, to="-99"), "frame: not left, bottom"),
    "no height": ("inside", change("proof", "frame", 3, to="-99"), "frame: not left, bottom"),
    "a frame without room": (
        "inside",
        change("part", "exterior", to=[["0", "0"], ["99", "0"], ["99", "1"], ["0", "1"]]),
        "part: edges of the pieces do not cancel",
    ),
    "pieces that do not cancel": (
        "cave",
        change("proof", "directrix", to=lambda pieces: pieces[1:]),
        "directrix: edges of the pieces do not cancel",
    ),
    "a piece that is not convex": (
        "cave",
        change("proof", "directrix", to=lambda _: [[[str(x), str(y)] for x, y in CAVE]]),
        "directrix, piece 0: not convex",
    ),
    "equal pieces": (
        "cave",
        lambda c: put(
            put(c, ("directrix", "exterior"), c["directrix"]["exterior"] * 2),
            ("proof", "directrix"),
            c["proof"]["directrix"] * 2,
        ),
        "are not apart",
    ),
    "a repeated point": (
        "cave",
        change("exterior", to=lambda ring: [*ring[:2], *ring[1:]]),
        "exterior: a repeated point",
    ),
    "a clockwise loop": (
        "cave",
        change("exterior", to=lambda ring: [ring[0], *ring[:0:-1]]),
        "or not counter-clockwise",
    ),
    "a repeated fit": (
        "room",
        change("exact_fits", to=lambda fits: [*fits, [["9", "9"], ["9", "9"]]] * 2),
        "meets exact_fits[",
    ),
    "an edge that is also a fit": (
        "cave",
        lambda c: put(c, ("exact_fits",), [*c["exact_fits"], c["exterior"][:2]]),
        "meets",
    ),
    "a fit of one point on an edge": (
        "cave",
        lambda c: put(c, ("exact_fits",), [*c["exact_fits"], [c["exterior"][0]] * 2]),
        "meets",
    ),
    "a fit in a sum": (
        "cave",
        change("exact_fits", to=lambda fits: [*fits, [["1/2", "1/2"], ["3/4", "1/2"]]]),
        "inside the sum of pieces",
    ),
    "a missing hole": ("cave", change("holes", to=[]), " is no sum or known edge"),
    "a missing sum": (
        "cave",
        change("proof", "sums", to=lambda sums: [[k, [[]] * len(chains)] for k, chains in sums]),
        "a side of it is not covered",
    ),
    "loops around nothing": (
        "cave",
        lambda c: (
            put(put(c, ("proof", "sums"), []), ("holes",), [])
            | {"exact_fits": [], "exterior": [["90", "0"], ["91", "0"], ["90", "1"]]}
        ),
        "exterior, edge 0: sums are not along its left",
    ),
    "a fit next to no sum": (
        "cave",
        change("exact_fits", to=lambda fits: [*fits, [["90", "0"], ["91", "0"]]]),
        "sums are not along its left",
    ),
    "no pieces": (
        "cave",
        lambda c: put(
            put(c, ("directrix", "exterior"), [["0", "0"], ["1", "0"], ["2", "0"]]),
            ("proof", "directrix"),
            [],
        ),
        "directrix: no pieces",
    ),
    "no pieces of the part": (
        "inside",
        lambda c: put(
            put(c, ("part", "exterior"), [["0", "0"], ["1", "0"], ["2", "0"]]),
            ("proof", "part"),
            [],
        ),
        "part: no pieces",
    ),
    "another area": ("SS", change("area", to=lambda a: str(Fraction(a) + 1)), "area: differs"),
    "inner loop and another loop exchanged": (
        "unswept",
        lambda c: json.loads(
            json.dumps(add_proof({**c, "inner": c["unswept"][0], "unswept": [c["inner"]]}))
        ),
        "inner, at the directrix: winding number 0, expected -1",
    ),
    "a hole next to its exterior": (
        "island",
        change("regions", 0, "holes", 0, to=[["90", "0"], ["91", "0"], ["90", "1"]]),
        "regions[0].holes[0]: winding number 1, expected 0",
    ),
    "a fit beyond the frame": (
        "inside",
        change("exact_fits", to=lambda fits: [*fits, [["99", "0"], ["99", "1"]]]),
        "the part leaves the frame",
    ),
    "another format": ("cave", change("format", to="exactsweep"), "format: not"),
    "another version": ("cave", change("version", to=2), "version: not 3"),
    "another claim": ("cave", change("claim", to="fits"), "claim: none of"),
}


@pytest.mark.parametrize("name", CONDITIONS)
def test_each_condition_is_needed(name: str) -> None:
    of, made, reason = CONDITIONS[name]
    certificate = json.loads(json.dumps(certificates()[of]))
    assert prove(certificate)
    assert reason in refusal(made(certificate))


def test_reasons_name_a_point() -> None:
    c = put(certificates()["cave"], ("exact_fits",), [[["1/2", "1/2"], ["3/4", "1/2"]]])
    with pytest.raises(Refused) as caught:
        prove(c)
    assert str(caught.value).endswith("at (0.5, 0.5)")
    assert caught.value.witness == (Fraction(1, 2), Fraction(1, 2))
    far = put(c, ("exact_fits", 0, 0, 0), "1" + "0" * 400)
    assert refusal(far).endswith(", at (1.00000000000e+400, 0.5)")


# --- Sums that are connected or not, winding numbers ----------------------------------------------


def star() -> tuple[list[Any], list[Any], list[Any]]:
    """Return a pentagram, its outline, and its pieces: five tips and the pentagon inside."""
    tips = [(Fraction(x), Fraction(y)) for x, y in ((0, 10), (-9, 3), (-6, -8), (6, -8), (9, 3))]
    inner = [meet(tips[k - 1], tips[(k + 1) % 5], tips[k], tips[(k + 2) % 5]) for k in range(5)]
    # inner[k] is between tip k and tip k + 1
    outline = [p for pair in zip(tips, inner, strict=True) for p in pair]
    pieces = [[tips[k], inner[k], inner[k - 1]] for k in range(5)] + [inner]
    around = [tips[k % 5] for k in range(0, 10, 2)]
    return around, outline, [list(map(text, p)) for p in pieces]


def meet(a: Any, b: Any, c: Any, d: Any) -> Any:
    """Return the intersection of two lines."""
    u, v = (b[0] - a[0], b[1] - a[1]), (d[0] - c[0], d[1] - c[1])
    share = ((c[0] - a[0]) * v[1] - (c[1] - a[1]) * v[0]) / (u[0] * v[1] - u[1] * v[0])
    return a[0] + share * u[0], a[1] + share * u[1]


def text(p: Any) -> list[str]:
    return [str(p[0]), str(p[1])]


def test_a_shape_with_winding_number_2_is_rejected() -> None:
    around, outline, pieces = star()
    certificate = json.loads(json.dumps(no_fit_polygon(outline, HOUSE).certificate()))
    assert prove(certificate)
    pentagram = put(certificate, ("directrix", "exterior"), [text(p) for p in around])
    # The inner pentagon is listed twice, so that pieces cancel to the pentagram.
    cut = certificate["proof"]["directrix"]
    middle = pieces[-1]
    assert "are not apart" in refusal(put(pentagram, ("proof", "directrix"), [*cut, middle]))
    assert "do not cancel" in refusal(put(certificate, ("proof", "directrix"), [*cut, middle]))


def test_groups_of_pieces_are_tested_one_by_one() -> None:
    """With two disjoint squares, the loop around one of the two sums proves nothing."""
    square, other = (
        [[f"{x}", f"{y}"] for x, y in ((a, 0), (a + 1, 0), (a + 1, 1), (a, 1))] for a in (0, 9)
    )
    both = [*square, square[0], *other, other[0]]
    one = json.loads(json.dumps(no_fit_polygon([*square], [*square]).certificate()))
    assert prove(one)
    two = put(put(one, ("directrix", "exterior"), both), ("proof", "directrix"), [square, other])
    assert "sums: winding number 0, expected 1" in refusal(two)


@pytest.mark.parametrize("order", [[0, 1, 2], [2, 1, 0], [1, 2, 0]])
def test_intervals_may_cover_in_any_order(order: list[int]) -> None:
    half = Fraction(1, 2)
    spans: list[Any] = [(-1, True, half), (half, False, half), (half, True, 2)]
    assert covers([spans[k] for k in order])
    assert not covers([spans[0], spans[2]])
    assert not covers([(0, True, 2)])
    assert not covers([(0, False, half), (half, True, 1)])
    assert covers([(0, False, half), (half, False, 1), None])
    assert not covers([])


def test_convex_rings_turn_left_and_go_once_around() -> None:
    square = [node(*p) for p in ((0, 0), (1, 0), (1, 1), (0, 1))]
    for k in range(4):
        assert is_convex(square[k:] + square[:k])
        assert not is_convex((square[k:] + square[:k])[::-1])
    assert not is_convex(square * 2)
    assert not is_convex([*square, node(0, Fraction(1, 2))])


def test_edges_include_their_lower_ends() -> None:
    square = list_edges([node(*p) for p in ((0, 0), (2, 0), (2, 2), (0, 2))])
    inside = [(0, 0), (1, 1), (1, 0), (0, 1)]
    outside = [(2, 0), (2, 2), (0, 2), (2, 1), (1, 2), (-1, 1), (3, 1)]
    assert {winding(square, node(*p)) for p in inside} == {1}
    assert {winding(square, node(*p)) for p in outside} == {0}


# --- Forms that the page allows -------------------------------------------------------------------

HOLED = Region(
    [(0, 0), (9, 0), (9, 9), (0, 9)],
    [[(1, 1), (3, 1), (3, 3), (1, 3)], [(5, 5), (8, 5), (8, 8), (5, 8)]],
)
FORMS: dict[str, Callable[[Any], Any]] = {
    "holes left out": drop(("generatrix", "holes")),
    "holes null": change("generatrix", "holes", to=None),
    "a vertex repeated": change("generatrix", "exterior", to=lambda r: [r[0], *r]),
    "holes in another order": change("directrix", "holes", to=lambda holes: holes[::-1]),
    "another first vertex": change("directrix", "exterior", to=lambda r: r[1:] + r[:1]),
    "clockwise": change("directrix", "exterior", to=lambda r: r[::-1]),
    "reversed chains": change(
        "proof",
        "sums",
        to=lambda sums: [[k, [chain[::-1] for chain in chains]] for k, chains in sums],
    ),
}


@pytest.mark.parametrize("name", FORMS)
def test_every_form_of_the_page_is_proved(name: str) -> None:
    certificate = json.loads(
        json.dumps(no_fit_polygon(HOLED, [(0, 0), (1, 0), (1, 1), (0, 1)]).certificate())
    )
    assert prove(FORMS[name](certificate))


def test_the_frame_of_an_inner_fit_may_be_its_container() -> None:
    ring = [[str(x), str(y)] for x, y in ((0, 0), (3, 0), (3, 3), (0, 3))]
    room = [[str(x), str(y)] for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]
    certificate = json.loads(json.dumps(inner_fit_polygon(ring, SQUARE).certificate()))
    # The reversed loop goes along the half-planes above, right, below and left.
    proof = certificate["proof"] | {"frame": ["0", "0", "3", "3"], "outside": [], "sums": []}
    proof["around"] = [[-3], [-2], [-1], [-4]]
    assert certificate["regions"] == [{"exterior": room, "holes": []}]
    assert prove({**certificate, "proof": proof})


def test_fits_may_have_any_order_and_direction() -> None:
    certificate = certificates()["inside exactly"]
    fits = [fit[::-1] for fit in certificate["exact_fits"]]
    assert fits
    assert prove({**certificate, "exact_fits": fits})


def renumbered(certificate: Any, exterior: Any, edges: Callable[[int], list[int]]) -> Any:
    """Return the certificate with other points for its exterior, and renumbered edges."""

    def change_chain(chain: list[int]) -> list[int]:
        return [m for n in chain for m in ([n] if n >= 0 else [-1 - k for k in edges(-1 - n)])]

    sums = [[k, [*map(change_chain, chains)]] for k, chains in certificate["proof"]["sums"]]
    return put({**certificate, "exterior": exterior}, ("proof", "sums"), sums)


def test_loops_may_start_anywhere_and_have_straight_angles() -> None:
    certificate = json.loads(json.dumps(no_fit_polygon(HOUSE, HOUSE).certificate()))
    ring, count = certificate["exterior"], len(certificate["exterior"])
    turned = renumbered(certificate, ring[1:] + ring[:1], lambda k: [(k - 1) % count])
    assert prove(turned)
    middle = [str((Fraction(a) + Fraction(b)) / 2) for a, b in zip(ring[-1], ring[0], strict=True)]
    longer = renumbered(
        certificate, [*ring, middle], lambda k: [k, count] if k == count - 1 else [k]
    )
    assert prove(longer)
    spike = [*ring, middle, ring[-1]]
    assert "a repeated point" in refusal({**certificate, "exterior": spike})
