"""Certificates from any source: what is malformed or too large is refused with a reason."""

import copy
import random
import re
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import pytest
from cells import grid
from producer import (
    SLOT,
    UNIT,
    VALLEY,
)
from shape_certificates import (
    inner_fit_certificate,
    no_fit_certificate,
    sweep_certificate,
    written_again,
)
from tampering import changes

from exactsweep import sweep
from exactsweep.check import standalone, verify
from exactsweep.check.standalone import Refused, number

NESTED: list[Any] = []
for _ in range(10**5):
    NESTED = [NESTED]

JUNK = [
    *(None, True, False, 0, 1, -1, 10**5000, 0.5, float("nan"), float("inf"), b"1", (1, 0), {1, 2}),
    *("", "0", "1e9999999999", "1/0", "2/4", "-0", "nan", "0.5", " 1", "\ud800", "9" * 10**5),
    *([], {}, [[]], [[], []], [None] * 3, ["0", "0"], [["0", "0"]] * 3, [["0"] * 2] * 2),
    *([[0, 0], [1, 0], [0, 1]], [[["EV", 0, 0]]], [True, False], [10**5000, 1], object()),
    *(NESTED, {"a": NESTED}, [NESTED, NESTED]),
]


def _places(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Every place in nested lists and dicts, the first and last two entries of each list."""
    yield path
    if isinstance(value, dict):
        for key in value:
            yield from _places(value[key], (*path, key))
    if isinstance(value, list):
        for k in sorted({0, 1, len(value) - 1} & set(range(len(value)))):
            yield from _places(value[k], (*path, k))


def _with(value: Any, path: tuple[Any, ...], junk: Any) -> Any:
    if not path:
        return junk
    changed = value.copy()
    changed[path[0]] = _with(value[path[0]], path[1:], junk)
    return changed


FULL = grid("###", "#.#", "###")
CERTIFICATES = {
    "monotone": sweep(UNIT, SLOT).certificate(),
    "no_fit": no_fit_certificate(FULL, grid("#")),
    "inner_fit": inner_fit_certificate(FULL, grid("#")),
    "sweep": sweep_certificate(FULL, grid("#")),
}


@pytest.mark.parametrize(
    "text",
    [
        "1/-2",
        "-1/-2",
        "1/0",
        "0/1",
        "2/4",
        "1/1",
        "-0",
        "+1",
        "01",
        "1_0",
        "1/+2",
        "1/02",
        "1/2/3",
        "1/",
        "/2",
        "1e3",
        "0.5",
        "٣",
        "-",
        "/",
        "--1",
        "",
        " 1",
        "1 ",
        "1 /2",
        "1/ 2",
        "2/" + "4" * 700,
        "0" + "9" * 700,
    ],
)
def test_a_number_is_written_in_one_way(text: str) -> None:
    with pytest.raises(Refused, match="number"):
        number(text)


@pytest.mark.parametrize("text", ["0", "-7", "1/2", "-7/2", "9" * 700, "-" + "9" * 700 + "/7"])
def test_a_number_in_lowest_terms_is_read(text: str) -> None:
    above, _, below = text.partition("/")
    assert number(text) == Fraction(int(above), int(below or 1))


def test_a_number_has_as_many_digits_as_are_allowed(monkeypatch: pytest.MonkeyPatch) -> None:
    """All characters count, also those of a fraction."""
    assert standalone.MAX_DIGITS == 10**6
    monkeypatch.setattr(standalone, "MAX_DIGITS", 7)
    for text, longer in (("1" * 7, "1" * 8), ("-123/40", "-123/100"), ("1/99999", "1/999999")):
        assert number(text) == Fraction(text)
        with pytest.raises(Refused, match="not a number in a string"):
            number(longer)


def test_a_ring_has_three_points_that_are_not_repeated() -> None:
    p, q, r = ["0", "0"], ["1", "0"], ["0", "1"]
    assert len(standalone.ring([p, p, q, r, r, p])) == 3
    for points in ([], [p], [p, q], [p, p, q, q], [p, q, q, p]):
        with pytest.raises(Refused, match="a ring of fewer than three points"):
            standalone.ring(points)


@pytest.mark.parametrize("length", [1, 999, 1000, 1001, 1999, 2000, 2001, 2002, 4001, 4002, 9000])
def test_long_numbers_are_read_by_halves(length: int) -> None:
    seven = (10**length - 1) // 9 * 7
    assert standalone.whole("7" * length) == seven
    assert standalone.whole("-" + "7" * length) == -seven
    assert standalone.whole("1" + "0" * length) == 10**length


@pytest.mark.long
@pytest.mark.parametrize("claim", CERTIFICATES)
def test_junk_is_refused_with_a_reason(claim: str) -> None:
    certificate = CERTIFICATES[claim]
    for path in _places(certificate):
        for junk in JUNK:
            changed = _with(certificate, path, junk)
            result = verify(changed)
            if result.proved:
                assert type(junk) in (str, int, list)
                # Another shape may have the same answer.
                assert changed == certificate or changed == written_again(changed), path
            else:
                assert 0 < len(result.reason) < 200


@pytest.mark.parametrize(
    ("key", "value", "reason"),
    [
        ("format", "x", "format: not 'exactsweep certificate'"),
        ("version", True, "version: not 2"),
        ("kind", "MC", "kind: it is CM"),
        ("kind", "MM", "kind: it is CM"),
        ("direction", [2, 0], "direction: not primitive"),
        ("direction", [1, 0.0], "direction: not a number"),
        ("direction", [0, 1], "directrix: not monotone to the direction, it turns back at"),
        ("direction", [0, -1], "direction: not primitive"),
        ("direction", [-1, 0], "direction: not primitive"),
        ("generatrix", [["0", "0"]], "generatrix: fewer than three points"),
        ("generatrix", [["0", "0"], ["1", "0"]], "generatrix: fewer than three points"),
        ("generatrix", [["0"], ["0"], ["1"]] * 2, "generatrix: not a list of the right length"),
        ("generatrix", [["0", "0", "1"]] * 2, "generatrix: not a list of the right length"),
        ("contacts", [[["EV", 3, 8]]], "contacts: not a list of the right length"),
        ("exact_fits", [[["0", "a"], ["0", "0"]]], "exact_fits: not a number"),
        ("exact_fits", [[["0", "0"], ["a", "0"]]], "exact_fits: not a number"),
        ("directrix", "0", "directrix: not a list"),
        ("inner", [["0", "0"], ["1", 0], ["0", "1"]], "inner: not a number in a string"),
        ("outer", [["0", "0"], ["2/4", "0"], ["0", "1"]], "outer: a number not in lowest terms"),
        ("trajectory", [["0", "0"], ["-1", "0"], ["0", "1"]], "trajectory: not canonical, the"),
        ("contacts", [], "contacts: not a list of the right length"),
        ("area", "1e-3", "area: not a number in a string"),
        ("area", "9" * (10**6 + 1), "area: not a number in a string"),
        ("area", "1", "area: not that between the loops"),
        ("exact_fits", [], "exact_fits: not the exact fits, from end to end"),
    ],
)
def test_reason_names_the_place(key: str, value: Any, reason: str) -> None:
    certificate = {**sweep(UNIT, SLOT).certificate(), key: value}
    result = verify(certificate)
    assert not result.proved
    assert result.reason.startswith(reason)


def test_reasons_for_evidence_name_the_edge() -> None:
    certificate = sweep(UNIT, VALLEY).certificate()
    seen = set()
    for seed in range(5):
        for _, changed in changes(certificate, random.Random(seed)):
            seen.add(re.split(r"[\[:]", verify(changed).reason)[0])
    assert {"contacts", "inner_drawn", "outer_drawn", "exact_fits"} <= seen


def test_loop_that_meets_itself_is_refused() -> None:
    certificate = sweep(UNIT, VALLEY).certificate()
    pinched = [["0", "0"], ["2", "1"], ["4", "0"], ["4", "3"], ["2", "1"], ["0", "3"]]
    result = verify({**certificate, "directrix": pinched})
    assert result.reason == "directrix: not simple and counter-clockwise"


def test_many_corners_are_refused_at_once() -> None:
    """Convex corners that are all alone, so that the checker has to compare each with each."""
    prover = standalone.Monotone(sweep(UNIT, VALLEY).certificate(), standalone.Work(10**8))
    saw = prover.read("", [*((k, k % 2, 1) for k in range(2 * 10**4)), (0, 9, 1)])
    with pytest.raises(Refused, match="too large"):
        prover.prove_held(saw, saw.chains, saw.chains, "")


def test_certificates_of_many_convex_edges_are_proved() -> None:
    """Once 10,000 around 10,000 were too many, which take a second."""
    parabola = [(k, k * k) for k in range(200)]
    assert verify(sweep(parabola, parabola).certificate(), max_steps=15_000).proved


def test_places_for_exact_fits_count_in_steps() -> None:
    """Walls that all go with each other: as many places as pairs, each looked at all along."""
    n = 10

    def castle(step: int, width: int) -> list[tuple[int, int]]:
        walls = [(step * k, 0, step * k + width) for k in range(n)]
        low = [(x, y) for a, y, b in walls for x, y in ((a, 1), (a, y), (b, y), (b, 1))]
        return [*low[1:-1], (low[-1][0], 9), (0, 9)]

    turned = [(-x, -y) for x, y in castle(4, 2)]
    s = sweep(turned, castle(4 * n, 2 * n - 2))
    loops = [s.generatrix, s.directrix, s.trajectory, s.inner, s.outer]
    least = sum(map(len, loops))
    certificate = s.certificate()
    assert verify(certificate).proved
    steps = next(k for k in range(least, 10**6, 100) if verify(certificate, max_steps=k).proved)
    assert steps > n * n * len(s.generatrix)


def test_long_denominators_count_in_steps() -> None:
    parabola = [[str(k), f"1/{10**1000 + k}"] for k in range(1, 10**3)]
    certificate = {**sweep(UNIT, VALLEY).certificate(), "directrix": [["0", "0"], *parabola]}
    assert verify(certificate, max_steps=10**5).reason.startswith("too large")


def test_more_steps_may_be_allowed() -> None:
    certificate = sweep(UNIT, VALLEY).certificate()
    assert verify(certificate, max_steps=10).reason == (
        "too large: to check it would take more than 10 steps"
    )
    assert verify(certificate, max_steps=10**4).proved


def test_verify_leaves_the_certificate_alone() -> None:
    certificate = sweep(UNIT, SLOT).certificate()
    before = copy.deepcopy(certificate)
    assert verify(certificate).proved
    assert certificate == before


@pytest.mark.parametrize("key", ["generatrix", "outer"])
def test_points_are_lists_of_two_and_no_strings_of_two(key: str) -> None:
    certificate = sweep(UNIT, VALLEY).certificate()
    written = [x[-1] + y[-1] for x, y in certificate[key]]
    result = verify({**certificate, key: written})
    assert result.reason == f"{key}: not a list of the right length"


@pytest.mark.parametrize("name", ["contacts", "inner_drawn", "outer_drawn"])
def test_evidence_is_listed_once(name: str) -> None:
    certificate = sweep(UNIT, VALLEY).certificate()
    listed = next(found for found in certificate[name] if found)
    listed.append(listed[0])
    assert verify(certificate).reason.startswith(name)
