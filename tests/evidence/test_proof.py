"""Proofs in certificates: complete for every answer, and accepted by the standalone checker."""

import json
from fractions import Fraction
from random import Random
from typing import Any

import pytest
import strategies as own
from hypothesis import given
from hypothesis import strategies as st
from small_pairs import SmallPair, draw, draw_around, draw_shapeless, draw_touching
from tiers import examples

from exactsweep import Polygon, Region, inner_fit_polygon, no_fit_polygon, sweep
from exactsweep.check.standalone import Refused, prove
from exactsweep.evidence.homogeneous import (
    clip,
    find_between,
    intersect,
    is_on_border,
    list_sides,
    make_side,
    place,
)
from exactsweep.evidence.proof import add_proof
from exactsweep.evidence.slits import unite
from exactsweep.geometry.frame import to_homogeneous
from exactsweep.numbers.number import to_fraction

seldom = examples(12)
often = examples(100)

UNIT = [(0, 0), (1, 0), (1, 1), (0, 1)]
SLOT = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
CROSS = [(1, 0), (2, 0), (2, 1), (3, 1), (3, 2), (2, 2), (2, 3), (1, 3), (1, 2), (0, 2), (0, 1)]


def prove_all(g: Any, d: Any) -> None:
    """Prove the three answers about a pair, read from JSON."""
    for answer in (sweep(g, d), no_fit_polygon(d, g), inner_fit_polygon(d, g)):
        assert prove(json.loads(json.dumps(answer.certificate())))


@seldom
@given(own.pairs("CC") | own.pairs("CM") | own.pairs("MM"))
def test_answers_about_monotone_pairs_are_proved(pair: tuple[Polygon, Polygon]) -> None:
    prove_all(*pair)


@seldom
@given(own.simple_polygons(), own.simple_polygons())
def test_answers_about_simple_polygons_are_proved(g: Polygon, d: Polygon) -> None:
    prove_all(g, d)


@pytest.mark.parametrize("draw_pair", [draw, draw_shapeless, draw_touching, draw_around])
def test_answers_about_shapes_with_holes_that_fit_and_touch_are_proved(draw_pair: Any) -> None:
    rng = Random("proofs")
    for _ in range(5):
        pair: SmallPair = draw_pair(rng)
        prove_all(*(Region(shape[0], shape[1:]) for shape in pair))


@pytest.mark.parametrize("place_at", ["0", "1/7", "100000000000000000000/3", "1e400"])
@pytest.mark.parametrize("scale", ["1", "1/3", "1e-300", "1e300"])
def test_answers_at_any_scale_and_position_are_proved(place_at: str, scale: str) -> None:
    by, times = to_fraction(place_at), to_fraction(scale)
    g, d = ([(times * x + by, times * y - by) for x, y in ring] for ring in (UNIT, SLOT))
    prove_all(g, d)


@pytest.mark.parametrize("scale", [1, 3, 10])
def test_cuts_parallel_to_the_trajectory_leave_slits(scale: int) -> None:
    """The four cuts of a cross are horizontal or vertical, like all edges of its trajectory."""
    found = sweep(CROSS, [(scale * x, scale * y) for x, y in SLOT]).certificate()
    assert found["proof"]["slits"]
    assert prove(found)


def test_single_points_that_no_sum_covers_are_slits() -> None:
    corner = to_homogeneous(0, 0)
    assert [slit.start for slit in unite([(corner, corner), (corner, corner)], [])] == [corner]
    assert (
        unite([(corner, corner)], [make_side(to_homogeneous(-1, -1), to_homogeneous(1, 1))]) == []
    )


@examples(50)
@given(st.sampled_from(["exterior", "holes", "exact_fits", "inner", "outer"]), st.data())
def test_proving_a_wrong_answer_terminates_and_fails(name: str, data: st.DataObject) -> None:
    found = sweep([(0, 0), (1, 0), (0, 1)], SLOT).certificate()
    points = found[name]
    if points and type(points[0][0]) is str:
        k = data.draw(st.integers(0, len(points) - 1))
        points[k] = [data.draw(st.sampled_from(["0", "1", "1/2", "-7/3"])) for _ in "xy"]
    else:
        points.append([["1", "1"], ["2", "2"], ["1", "2"]][: 2 if name == "exact_fits" else 3])
    if found[name] != sweep([(0, 0), (1, 0), (0, 1)], SLOT).certificate()[name]:
        with pytest.raises(Refused):
            prove(add_proof(found))


def test_a_proof_is_found_again_from_the_certificate() -> None:
    for answer in (sweep(UNIT, SLOT), no_fit_polygon(SLOT, UNIT), inner_fit_polygon(SLOT, UNIT)):
        found = answer.certificate()
        assert add_proof(found) == found == json.loads(json.dumps(found))


fractions = st.fractions(-3, 3, max_denominator=4)
nodes = st.builds(to_homogeneous, fractions, fractions)


@often
@given(st.lists(nodes, min_size=4, max_size=4, unique=True))
def test_segments_meet_at_common_points(points: Any) -> None:
    side, other = make_side(*points[:2]), make_side(*points[2:])
    span = intersect(side, other)
    back = intersect(other, side)
    assert (span is None) == (back is None)
    if span and back:
        low, high = max(span[0], Fraction(0)), min(span[1], Fraction(1))
        common = {place(find_between(side.start, side.end, at)) for at in (low, high)}
        low, high = max(back[0], Fraction(0)), min(back[1], Fraction(1))
        assert common == {place(find_between(other.start, other.end, at)) for at in (low, high)}


@often
@given(nodes, nodes, fractions)
def test_a_segment_is_inside_a_polygon_between_the_ends_of_its_interval(
    a: Any, b: Any, at: Fraction
) -> None:
    square = list_sides([to_homogeneous(*p) for p in [(-1, -1), (1, -1), (1, 1), (-1, 1)]])
    span = clip(square, a, b)
    point = find_between(a, b, at % 1)
    x, y = place(point)
    is_inside = bool(span and span[0] < at % 1 < span[1])
    assert is_inside == (max(abs(x), abs(y)) < 1)
    assert is_on_border(square, point) == (max(abs(x), abs(y)) == 1)
