"""Certificates of polygons of any shape: true ones are proved, and every change is refused."""

import copy
import json
from bisect import bisect_left
from fractions import Fraction
from random import Random
from typing import Any

import pytest
from cells import Holed, grid, shape_of
from exactsweep.check.monotone import has_shared_direction
from hypothesis import example, given
from hypothesis import strategies as st
from shape_certificates import (
    falsified,
    inner_fit_certificate,
    no_fit_certificate,
    sweep_certificate,
)
from shapes import cell_sets, polyominoes, shape_pairs
from strategies import simple_polygons
from tiers import examples

from exactsweep import Point, Polygon, Region, inner_fit_polygon
from exactsweep.check import classify, reference_inner_fit, reference_no_fit, verify
from exactsweep.geometry.direction import DirectionError
from exactsweep.geometry.frame import choose_direction

patient = examples(40)
UNIT = grid("#")
C = grid("####", "#..#", "#...", "#..#", "####")
RING = grid("####", "#..#", "#..#", "####")
CAVE = grid("##########", "#........#", *["#........#"] * 6, "#........#", "###....###")
PAIRS = {
    "C": (C, UNIT),
    "closed C": (C, grid("##", "##")),
    "hole of its size": (grid("###", "#.#", "###"), UNIT),
    "rooms": (grid("########", "#..#...#", "#..#...#", "########"), UNIT),
    "ring around a ring": (grid("###", "#.#", "###"), RING),
    "moves around": (CAVE, grid("###", "###", "###")),
    "crossing slits": (grid("#####", "##.##", "#...#", "##.##", "#####"), UNIT),
}


def proved(certificate: dict[str, Any]) -> bool:
    result = verify(json.loads(json.dumps(certificate)))
    assert result.proved == (result.reason == "proved")
    return result.proved


@pytest.mark.parametrize("name", PAIRS)
def test_every_change_is_refused(name: str) -> None:
    d, g = PAIRS[name]
    certificates = [no_fit_certificate(d, g), sweep_certificate(d, g)]
    certificates.append(inner_fit_certificate(Holed(Polygon([(-1, -1), (99, -1), (9, 99)])), d))
    certificates.append(inner_fit_certificate(d, g))
    for certificate in certificates:
        if certificate["claim"] != "sweep" or d.holes or g.holes or name == "moves around":
            assert proved(certificate)
        for change, false in falsified(certificate, Random(name)):
            assert not proved(false), (certificate["claim"], change)


@patient
@given(shape_pairs(), st.integers(0, 99))
def test_certificate_from_the_definition_is_proved_and_no_change_of_it(
    pair: tuple[Holed, Holed], seed: int
) -> None:
    certificate = no_fit_certificate(*pair)
    assert proved(certificate)
    rng = Random(seed)
    changes = list(falsified(certificate, rng))
    for change, false in rng.sample(changes, min(8, len(changes))):
        assert not proved(false), change


@patient
@given(cell_sets(), polyominoes(4), st.integers(0, 99))
def test_inner_fit_is_proved_and_no_change_of_it(
    container: frozenset[tuple[int, int]], part: frozenset[tuple[int, int]], seed: int
) -> None:
    certificate = inner_fit_certificate(shape_of(container), shape_of(part))
    assert proved(certificate)
    rng = Random(seed)
    changes = list(falsified(certificate, rng))
    for change, false in rng.sample(changes, min(8, len(changes))):
        assert not proved(false), change


@patient
@given(shape_pairs(), st.integers(0, 99))
def test_sweep_is_proved_and_no_change_of_it(pair: tuple[Holed, Holed], seed: int) -> None:
    d, g = pair
    certificate = sweep_certificate(d, g)
    monotone = not d.holes and not g.holes and _has_direction(d.exterior, g.exterior)
    assert proved(certificate) != monotone
    rng = Random(seed)
    changes = list(falsified(certificate, rng))
    for change, false in rng.sample(changes, min(8, len(changes))):
        assert not proved(false), change


@patient
@given(simple_polygons(), simple_polygons())
@example(grid("#.#", "###").exterior, UNIT.exterior)
@example(grid("#.#", "###").exterior, grid("##", "#.", "##").exterior)
def test_shared_direction_is_found_as_by_the_kernel(d: Polygon, g: Polygon) -> None:
    assert has_shared_direction([d.vertices, g.vertices]) == _has_direction(d, g)


def _has_direction(d: Polygon, g: Polygon) -> bool:
    try:
        choose_direction(g, d)
    except DirectionError:
        return False
    return True


# --- Witnesses -----------------------------------------------------------------------------------


def test_witness_of_a_missed_fit_is_a_position_of_contact() -> None:
    d, g = PAIRS["hole of its size"]
    result = verify({**no_fit_certificate(d, g), "exact_fits": []})
    assert result == (
        False,
        "exact_fits: one is missing",
        Point(*map(Fraction, (1, 1))),
    )


def test_witness_of_a_missed_hole_is_on_its_boundary() -> None:
    d, g = PAIRS["rooms"]
    certificate = no_fit_certificate(d, g)
    result = verify({**certificate, "holes": []})
    assert result.reason == "holes: one is missing"
    assert result.witness is not None
    assert classify(d, g, result.witness).verdict == "CONTACT"


def test_witness_of_an_invented_fit_is_its_position() -> None:
    d, g = PAIRS["closed C"]
    for x, y in (("1/2", "1/2"), ("3/2", "5/2"), ("9", "9")):
        result = verify({**no_fit_certificate(d, g), "exact_fits": [[[x, y], [x, y]]]})
        assert result == (False, "exact_fits[0]: not in the answer", (Fraction(x), Fraction(y)))


def test_witness_of_a_moved_vertex_is_the_vertex() -> None:
    certificate = inner_fit_certificate(grid("####", "####"), UNIT)
    region = certificate["regions"][0]
    moved = [*region["exterior"][:-1], ["1/3", "7/5"]]
    result = verify({**certificate, "regions": [{**region, "exterior": moved}]})
    expected = (False, "regions[0]: not in the answer", (Fraction(1, 3), Fraction(7, 5)))
    assert result == expected


# --- Input ---------------------------------------------------------------------------------------

SQUARE = [["0", "0"], ["9", "0"], ["9", "9"], ["0", "9"]]


def hole(*points: tuple[int, int]) -> list[list[str]]:
    return [[str(x), str(y)] for x, y in points]


@pytest.mark.parametrize(
    ("holes", "reason"),
    [
        ([hole((10, 1), (11, 1), (11, 2))], "a hole is not in its exterior, or in another"),
        ([hole((8, 1), (11, 1), (11, 2))], "rings of a shape cross"),
        ([hole((0, 1), (1, 2), (0, 3))], "the interior of a shape falls apart"),
        ([hole((4, 2), (7, 2), (7, 4)), hole((1, 1), (2, 1), (2, 2))], "not canonical, or its"),
        ([hole((1, 1), (1, 2), (2, 2))], "not canonical, or its holes are not sorted"),
        ([hole((1, 1), (2, 2), (3, 3))], "a ring is not simple"),
    ],
)
def test_bad_holes_are_refused(holes: list[Any], reason: str) -> None:
    shape = {"exterior": SQUARE, "holes": holes}
    for name in ("directrix", "generatrix"):
        result = verify({**no_fit_certificate(C, UNIT), name: shape})
        assert not result.proved
        assert result.reason.startswith(f"{name}: {reason}")
    for name in ("container", "part"):
        result = verify({**inner_fit_certificate(C, UNIT), name: shape})
        assert not result.proved
        assert result.reason.startswith(f"{name}: {reason}")


def test_holes_may_touch_in_points() -> None:
    points = Polygon([(1, 4), (4, 2), (4, 6)]), Polygon([(4, 4), (6, 2), (7, 4), (6, 6)])
    d = Holed(Polygon([(0, 0), (9, 0), (9, 9), (0, 9)]), points)
    assert proved(no_fit_certificate(d, UNIT))
    assert proved(sweep_certificate(d, UNIT))
    assert proved(inner_fit_certificate(d, UNIT))


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"claim": "fit"}, "claim is not no_fit, inner_fit, sweep"),
        ({"claim": []}, "claim is not no_fit, inner_fit, sweep"),
        ({"claim": "sweep"}, "keys are missing: "),
        ({"extra": 1}, "there are unknown keys"),
        ({"version": 1}, "version: not 2"),
        ({"directrix": []}, "directrix: not an object with exterior holes"),
        ({"generatrix": {"exterior": SQUARE}}, "generatrix: keys are missing: holes"),
        ({"exterior": [["0", "0"]]}, "exterior[0]: not in the answer"),
        ({"holes": None}, "holes: not a list"),
        ({"exact_fits": [[["0", "0"]]]}, "exact_fits[0]: not in the answer"),
    ],
)
def test_reason_names_the_place_in_a_claim(change: dict[str, Any], reason: str) -> None:
    result = verify({**no_fit_certificate(C, UNIT), **change})
    assert not result.proved
    assert result.reason.startswith(reason)


@pytest.mark.parametrize("name", ["holes", "exact_fits"])
def test_null_after_the_last_entry_of_a_list_is_refused(name: str) -> None:
    certificate = no_fit_certificate(C, UNIT)
    result = verify({**certificate, name: [*certificate[name], None]})
    assert result.reason == f"{name}[{len(certificate[name])}]: not in the answer"


def test_many_edges_are_refused_at_once_for_any_shape() -> None:
    teeth = [(k, 2 * (k % 2)) for k in range(5001)]
    comb = Holed(Polygon([*teeth, (5000, 9), (0, 9)]))
    certificate = no_fit_certificate(UNIT, UNIT)
    edges = [[str(c) for c in p] for p in comb.exterior.vertices]
    shape = {"exterior": edges, "holes": []}
    result = verify({**certificate, "directrix": shape, "generatrix": shape})
    assert result.reason == "too large: to check it would take more than 100000000 steps"


def test_the_work_on_a_sweep_is_told_besides_that_on_its_trajectory() -> None:
    """The trajectory has more vertices than D."""
    hook, g = grid("####", "#..#", "#.##", "#..."), Holed(Polygon([(0, 0), (2, -1), (1, 2)]))
    trajectory, whole = no_fit_certificate(hook, g), sweep_certificate(hook, g)
    enough = bisect_left(
        range(10**4), True, key=lambda steps: verify(trajectory, max_steps=steps).proved
    )
    assert verify(whole, max_steps=enough).reason.startswith("too large")
    assert verify(whole, max_steps=10 * enough).proved


def test_the_least_hole_on_the_lattice_is_one() -> None:
    """A triangle in a triangular hole that is larger by one: positions of half a unit of area."""
    square, sides = [(0, 0), (9, 0), (9, 9), (0, 9)], [(2, 2), (6, 2), (2, 6)]
    found = reference_no_fit(Region(square, [sides[::-1]]), [(0, 0), (3, 0), (0, 3)])
    assert [Polygon(hole) for hole in found.holes] == [Polygon([(2, 2), (3, 2), (2, 3)])]


def test_inner_fit_around_two_defects() -> None:
    """A unit square in a 12 by 6 sheet with two defects: one region, whose holes are sorted."""
    sheet = [(0, 0), (12, 0), (12, 6), (0, 6)]
    defects = [[(8, 2), (8, 4), (9, 4), (9, 2)], [(3, 2), (3, 4), (4, 4), (4, 2)]]
    found = reference_inner_fit(Region(sheet, defects), [(0, 0), (1, 0), (1, 1), (0, 1)])
    ((exterior, holes),) = found.regions
    assert Polygon(exterior) == Polygon([(0, 0), (11, 0), (11, 5), (0, 5)])
    assert [hole[0].x for hole in holes] == [2, 7]
    inner_fit = inner_fit_polygon(Region(sheet, defects), [(0, 0), (1, 0), (1, 1), (0, 1)])
    certificate = inner_fit.certificate()
    assert verify(certificate).proved
    for hole in certificate["regions"][0]["holes"]:
        changed = copy.deepcopy(certificate)
        changed["regions"][0]["holes"].remove(hole)
        assert not verify(changed).proved
