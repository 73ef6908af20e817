"""`verify`: the verdict of the file, and a comparison with the polygons of the caller."""

from __future__ import annotations

import json
from decimal import Inexact, localcontext
from fractions import Fraction
from typing import Any

import pytest
import shapely
from certified import CAVE, HOUSE, NOTCHED, ROOM, SLOT, SQUARE, certificates, two_ls
from hypothesis import given
from hypothesis import strategies as st
from strategies import Kind, pairs
from tiers import examples

from exactsweep import Point, Polygon, PolygonError, Region, no_fit_polygon, sweep
from exactsweep.check import point_in_polygon, verify
from exactsweep.numbers.error import ExactSweepError


@pytest.mark.parametrize("kind", ["CC", "CM", "MM"])
@examples(15)
@given(data=st.data())
def test_the_certificate_of_a_sweep_is_proved(kind: Kind, data: st.DataObject) -> None:
    generatrix, directrix = data.draw(pairs(kind))
    certificate = sweep(generatrix, directrix, reference=(3, "-1/7")).certificate()
    assert verify(json.loads(json.dumps(certificate))) == (True, "proved", None)


@pytest.mark.parametrize("name", certificates())
def test_certificates_of_every_kind_are_proved(name: str) -> None:
    assert verify(certificates()[name]) == (True, "proved", None)
    assert verify(two_ls()).proved


def test_a_reason_has_a_witness() -> None:
    cave = certificates()["cave"]
    verdict = verify({**cave, "exact_fits": [[["1/2", "1/2"], ["3/4", "1/2"]]]})
    assert not verdict.proved
    assert verdict.witness == Point(Fraction(1, 2), Fraction(1, 2))
    assert verify({**cave, "version": 2}) == (False, "version: not 3", None)


GIVEN: list[tuple[str, dict[str, Any], bool]] = [
    ("cave", {"directrix": CAVE, "generatrix": SQUARE}, True),
    ("cave", {"directrix": CAVE[3:] + CAVE[:3], "generatrix": Polygon(SQUARE)}, True),
    ("cave", {"directrix": CAVE[::-1]}, True),
    ("cave", {"directrix": [(0, 0), (2, 0), *CAVE[1:]]}, True),
    ("cave", {"directrix": SQUARE}, False),
    ("cave", {"directrix": [(x + 1, y) for x, y in CAVE]}, False),
    ("cave", {"part": SQUARE}, False),
    ("CM", {"generatrix": SQUARE, "directrix": NOTCHED}, True),
    ("CM", {"generatrix": NOTCHED, "directrix": SQUARE}, False),
    ("room", {"directrix": ROOM, "generatrix": SQUARE}, True),
    ("room", {"directrix": Region(ROOM.exterior, ROOM.holes[::-1])}, True),
    ("room", {"directrix": Region(ROOM.exterior, ROOM.holes[1:])}, False),
    ("room", {"directrix": ROOM.exterior}, False),
    ("inside exactly", {"container": SLOT, "part": SQUARE}, True),
    ("inside exactly", {"container": SQUARE, "part": SLOT}, False),
    ("MM", {"directrix": HOUSE}, False),
]


@pytest.mark.parametrize(("name", "given", "is_same"), GIVEN)
def test_the_polygons_of_the_caller_are_compared(
    name: str, given: dict[str, Any], is_same: bool
) -> None:
    verdict = verify(certificates()[name], **given)
    assert verdict.proved == is_same
    if not is_same:
        assert any(name in verdict.reason for name in given)


def test_a_hole_may_have_either_orientation() -> None:
    holed = Region([(0, 0), (9, 0), (9, 9), (0, 9)], [[(1, 1), (3, 1), (3, 3), (1, 3)]])
    certificate = json.loads(json.dumps(no_fit_polygon(holed, SQUARE).certificate()))
    certificate["directrix"]["holes"][0].reverse()
    assert verify(certificate, directrix=holed).proved


def test_shapely_polygons_and_lines_are_compared() -> None:
    polygons = {"directrix": shapely.Polygon(CAVE), "generatrix": shapely.Polygon(SQUARE)}
    assert verify(certificates()["cave"], **polygons).proved
    room = shapely.Polygon(ROOM.exterior, ROOM.holes)
    assert verify(certificates()["room"], directrix=room).proved
    assert not verify(certificates()["room"], directrix=shapely.box(0, 0, 6, 6)).proved
    line = shapely.LineString([(0, 0), (1, 0)])
    assert verify(certificates()["slit"], path=line).proved
    with pytest.raises(PolygonError, match="directrix: a LineString is not a polygon"):
        verify(certificates()["cave"], directrix=line)


@pytest.mark.parametrize("given", [3, object()])
def test_other_shapes_are_errors(given: Any) -> None:
    with pytest.raises(ExactSweepError, match="is not a polygon"):
        verify({}, directrix=given)


@pytest.mark.parametrize("wrong", ["00", {0}, {0: 0, 1: 1}, (0, 0, 0), 5])
def test_strings_and_sets_are_not_points(wrong: Any) -> None:
    polygon: Any = [(0, 0), wrong, (2, 2), (0, 2)]
    for name in ("generatrix", "directrix", "part", "container", "shape", "path"):
        with pytest.raises(PolygonError, match=f"^{name}: vertex 1 is .*not a pair of numbers"):
            verify(certificates()["CC"], **{name: polygon})
    with pytest.raises(PolygonError, match=r"^point is .*not a pair of numbers"):
        point_in_polygon(wrong, SQUARE)


def test_a_witness_is_rounded_despite_decimal_traps() -> None:
    wrong = json.loads(json.dumps(certificates()["CC"]))
    wrong["exterior"][:2] = [["-1/3", "-100/3"]] * 2
    with localcontext() as context:
        context.traps[Inexact] = True
        verdict = verify(wrong)
    assert not verdict.proved
    assert verdict == verify(wrong)
    assert verdict.reason.endswith(", at (-0.333333333333, -33.3333333333)")


@pytest.mark.parametrize("steps", [0, -1, 1.5, True, "9"])
def test_the_step_limit_is_a_positive_int(steps: Any) -> None:
    with pytest.raises(ExactSweepError, match="max_steps must be an int"):
        verify({}, max_steps=steps)
