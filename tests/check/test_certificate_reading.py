"""Certificates from any source: what is malformed or too large is refused with a reason."""

import copy
import random
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

from exactsweep import Point, sweep
from exactsweep.check import size, verify
from exactsweep.check.certificate import CertificateError

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
        ("format", "x", "format is not 'exactsweep certificate'"),
        ("version", True, "version is not 1"),
        ("kind", "MC", "kind is not CC, CM or MM"),
        ("kind", "MM", "kind: it is CM, not MM"),
        ("direction", [2, 0], "direction: not primitive"),
        ("direction", [1, 0.0], "direction: not a pair of integers"),
        ("direction", [0, 1], "directrix: not monotone to the direction, it turns back again at"),
        ("generatrix", [["0", "0"]], "generatrix: fewer than three vertices"),
        ("directrix", "0", "directrix: a str, not a list"),
        ("inner", [["0", "0"], ["1", 0], ["0", "1"]], "inner[1][1]: a int, not a number"),
        ("outer", [["0", "0"], ["2/4", "0"], ["0", "1"]], "outer[1][0]: not a number in lowest"),
        ("trajectory", [["0", "0"], ["-1", "0"], ["0", "1"]], "trajectory: not canonical, its"),
        ("contacts", [], "contacts: 0 lists for a loop of"),
        ("area", "1e-3", "area: not a number in lowest terms"),
        ("area", "1", "area: it is not that of the outer loop minus those inside it"),
        ("exact_fits", [], "exact_fits: one is missing"),
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
            seen.add(verify(changed).reason.split("[")[0])
    assert {"contacts", "inner_drawn", "outer_drawn", "exact_fits"} <= seen


def test_loop_that_meets_itself_is_refused() -> None:
    certificate = sweep(UNIT, VALLEY).certificate()
    pinched = [["0", "0"], ["2", "1"], ["4", "0"], ["4", "3"], ["2", "1"], ["0", "3"]]
    result = verify({**certificate, "directrix": pinched})
    assert result.reason == "directrix: not simple and counter-clockwise"


def test_many_edges_are_refused_at_once() -> None:
    loop = [[str(k), str(k * k)] for k in range(10**4)] + [["0", str(10**8)]]
    loop.sort(key=lambda point: point != ["0", "0"])
    certificate = {**sweep(UNIT, VALLEY).certificate(), "generatrix": loop, "directrix": loop}
    assert verify(certificate).reason == (
        "too large: to check it would take more than 100000000 steps"
    )


def test_common_denominator_out_of_hand_is_refused_at_once() -> None:
    parabola = [[str(k), f"1/{10**1000 + k}"] for k in range(1, 10**3)]
    certificate = {**sweep(UNIT, VALLEY).certificate(), "directrix": [["0", "0"], *parabola]}
    assert verify(certificate).reason == (
        "too large: to check it would take more than 100000000 steps"
    )


def test_the_common_denominator_counts_in_steps() -> None:
    """A step on numbers of up to 64 bits is one, on up to 128 bits two: for each of the points."""
    fine = Point(Fraction(1, 2**62), Fraction(1, 3))
    assert size.find_common_scale([fine, fine], 4) == 3 * 2**62
    assert size.find_common_scale([fine._replace(y=Fraction(1))], 1) == 2**62
    for points, steps in (([fine, fine], 3), ([Point(fine.y, fine.x)], 1)):
        with pytest.raises(CertificateError, match=f"more than {steps} steps"):
            size.find_common_scale(points, steps)


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
    assert result.reason.startswith(f"{key}[0]: not a list of 2")
