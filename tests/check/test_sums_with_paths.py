"""Certificates of sums with paths: both checkers, and handmade attacks."""

import copy
import json
from collections.abc import Iterator
from pathlib import Path
from random import Random
from typing import Any

import pytest
from certified import CAVE, SLOT, certificates, rect
from checkers import check_agreement, is_proved, needs_node
from falsify import change, draw_sums
from tampering import put

from exactsweep import Polyline, Region, minkowski_sum
from exactsweep.check import verify
from exactsweep.evidence.proof import add_proof
from exactsweep.theorem.extracted import ask, missing_tools

Certificate = dict[str, Any]
needs_tools = pytest.mark.skipif(bool(missing_tools()), reason=f"no {', '.join(missing_tools())}")
LOOP = [(0, 0), (9, 0), (9, 9), (0, 9), (0, 0)]


def plain(certificate: Any) -> Certificate:
    found: Certificate = json.loads(json.dumps(certificate))
    return found


def claims() -> Iterator[tuple[str, Certificate]]:
    """False claims: of a sum with a hole, and of one with a slit."""
    ring, filled = certificates()["path"], certificates()["slit"]
    yield "a hole is missing", {**ring, "holes": []}
    exchanged = {"exterior": ring["holes"][0], "holes": [ring["exterior"]]}
    yield "the hole and the exterior exchanged", {**ring, **exchanged}
    yield "the hole is filled in part", {**ring, "holes": [ring["holes"][0][:3]]}
    yield "an exterior of three vertices", {**ring, "exterior": ring["exterior"][:3]}
    yield "the path is open", {**ring, "path": ring["path"][:-1]}
    for k in range(1, 4):
        path = ring["path"][:k] + ring["path"][k + 1 :]
        yield f"the path goes past corner {k}", {**ring, "path": path}
    yield "the path is longer", {**ring, "path": [*ring["path"], ["5", "5"]]}
    yield "the path is reflected", {**ring, "path": [[y, f"-{x}"] for x, y in ring["path"]]}
    yield "another shape", {**ring, "shape": filled["shape"] | {"exterior": strings(CAVE)}}
    (start, end), *_ = filled["proof"]["slits"]
    thin = [start, [str(int(end[0]) + 1), end[1]], end]
    for hole in (thin, thin[::-1]):
        yield "a slit as a hole", {**filled, "holes": [hole]}


def strings(ring: Any) -> list[list[str]]:
    return [[str(x), str(y)] for x, y in ring]


@pytest.mark.parametrize(("name", "claim"), [*claims()])
def test_false_sums_are_rejected(name: str, claim: Certificate) -> None:
    assert not verify(claim).proved, name
    try:
        renewed = plain(add_proof(claim))
    except (ArithmeticError, LookupError, ValueError):  # the search for a proof may fail
        return
    assert not verify(renewed).proved, name


def test_slits_are_proved() -> None:
    """The prongs of the slot close its gap except for a segment between them."""
    filled = certificates()["slit"]
    count = len(filled["exterior"])
    sums = [
        [k, [[n for n in chain if n >= -count] for chain in chains]]
        for k, chains in filled["proof"]["sums"]
    ]
    left_out = put(put(filled, ("proof", "slits"), []), ("proof", "sums"), sums)
    assert "not covered" in verify(left_out).reason
    (start, end), *_ = filled["proof"]["slits"]
    longer = [[start, [end[0], "0"]], [[start[0], "-5"], end]]
    for slit in longer:
        assert not verify(put(filled, ("proof", "slits", 0), slit)).proved
    renewed = plain(add_proof({**filled, "proof": None}))
    assert verify(renewed).proved


def test_the_path_of_the_caller_is_compared() -> None:
    ring = certificates()["path"]
    closed = Polyline(LOOP[:-1], closed=True)
    for path in (LOOP, closed, [LOOP[0], *LOOP], [(str(x), y) for x, y in LOOP]):
        assert verify(ring, shape=SLOT, path=path).proved
    for path in (LOOP[:-1], LOOP[::-1], LOOP[1:], Polyline(LOOP[:1])):
        verdict = verify(ring, path=path)
        assert verdict == (False, "path of the certificate is not the given path", None)
    assert not verify(ring, shape=CAVE).proved
    assert verify(certificates()["CM"], path=LOOP).reason == "the certificate has no path"


@needs_node
def test_both_checkers_agree_on_every_rule_of_the_page(tmp_path: Path) -> None:
    ring, filled = certificates()["path"], certificates()["slit"]
    first, *rest = ring["path"]
    true = [
        ring,
        filled,
        {**ring, "path": [first, first, *rest, first, first]},
        put(ring, ("shape", "holes"), None),
    ]
    false = [
        {**ring, "path": []},
        {**ring, "path": [first]},
        {**ring, "path": [first, first]},
        {**ring, "path": None},
        {**ring, "path": [*ring["path"], ["0"]]},
        {**ring, "holes": None},
        {**ring, "exact_fits": []},
        put(ring, ("proof", "slits"), None),
        put(ring, ("proof", "shape"), []),
        put(ring, ("proof", "sums"), []),
        {**ring, "claim": "sweep"},
        {**certificates()["cave"], "claim": "sum"},
        *(claim for _, claim in claims()),
    ]
    assert check_agreement(true, tmp_path) == len(true)
    assert check_agreement(false, tmp_path) == 0


@needs_node
@pytest.mark.parametrize("seed", [1, *(pytest.param(n, marks=pytest.mark.long) for n in "234")])
def test_both_checkers_agree_on_random_and_changed_sums(seed: int, tmp_path: Path) -> None:
    rng = Random(seed)
    true = [found for _ in range(8) for found in draw_sums(rng)]
    assert check_agreement(true, tmp_path) == len(true)
    false = [change(copy.deepcopy(c), rng)[1] for c in true for _ in range(5)]
    assert check_agreement(false, tmp_path) < len(false) / 2


def test_a_repeated_point_is_not_a_segment() -> None:
    """The numbers of sums count the segments that remain."""
    shape = Region([(0, 0), (2, 0), (2, 2), (0, 2)])
    once = plain(minkowski_sum(shape, Polyline([(0, 0), (3, 1), (5, 0)])).certificate())
    a, b, c = once["path"]
    assert is_proved({**once, "path": [a, a, b, b, b, c]})
    assert not is_proved({**once, "path": [a, b, a, c]})


@needs_node
def test_all_parts_of_the_shape_are_covered(tmp_path: Path) -> None:
    """A hole divides the shape; the sum of one part alone covers all sides."""
    left, right = rect(0, 0, 4, 1), rect(6, 0, 9, 1)
    path = [["0", "0"], ["1", "0"]]
    proof = {"shape": [left], "sums": [[0, [[-1], [-2], [-3], [-4]]]], "slits": []}
    whole: Certificate = {
        "format": "exactsweep certificate",
        "version": 3,
        "claim": "sum",
        "shape": {"exterior": left},
        "path": path,
        "exterior": rect(0, 0, 5, 1),
        "holes": [],
        "proof": proof,
    }
    both = {
        **whole,
        "shape": {"exterior": rect(0, 0, 9, 1), "holes": [rect(4, 0, 6, 1)]},
        "proof": {**proof, "shape": [left, right]},
    }
    # Along a segment, pieces with a common vertex have sums without a common point.
    one, other = rect(0, 0, 4, 1), rect(4, 1, 5, 2)
    corner = [*one[:3], *other[1:], other[0], one[3]]
    touching = {
        **whole,
        "shape": {"exterior": corner},
        "proof": {**proof, "shape": [one, other]},
    }
    assert check_agreement([whole, both, touching], tmp_path) == 1
    assert verify(whole).proved
    for false in (both, touching):
        assert verify(false).reason.startswith("sums: winding number 0, expected 1")


@needs_tools
@pytest.mark.long
def test_the_extracted_checker_rejects_false_sums() -> None:
    ring, filled = certificates()["path"], certificates()["slit"]
    first, *rest = ring["path"]
    assert ask(ring) == ask(filled) == "accepted"
    assert ask({**ring, "path": [first, first, *rest, first, first]}) == "accepted"
    assert {ask(claim) for _, claim in claims()} == {"rejected", "malformed"}
