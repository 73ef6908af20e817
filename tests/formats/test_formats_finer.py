"""Regions of filled paths at finer tolerances: the same regions, or none."""

from fractions import Fraction
from math import cos, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep.formats.layouts import parse_layouts
from exactsweep.formats.parsing import parse_candidates
from exactsweep.geometry.near import bound_points
from exactsweep.layout import Layout, judge_layout

SHEET = '<rect width="100" height="100" fill="none"/>'


def draw_circle(x: float, y: float, r: float) -> str:
    half = f"a{r} {r} 0 1 1 0"
    return f"M{x:.9f} {y - r:.9f}{half} {2 * r}{half} {-2 * r}z"


def draw_path(circles: list[tuple[float, float, float]], rule: str = "nonzero") -> str:
    data = "".join(draw_circle(*circle) for circle in circles)
    return f'<path fill-rule="{rule}" d="{data}"/>'


def touch(angle: float) -> list[tuple[float, float, float]]:
    """Return two circles that overlap by less than the tolerance, and another one."""
    x, y = 20 + 19.9998 * cos(angle), 50 + 19.9998 * sin(angle)
    return [(20, 50, 10), (x, y, 10), (80, 85, 5)]


@pytest.mark.parametrize("angle", [0.3, 0.77])
def test_regions_that_merge_at_a_finer_tolerance_stay_coarse(angle: float) -> None:
    found = parse_candidates(f"<svg>{draw_path(touch(angle))}</svg>")
    assert len(found) == 3
    assert all(one.finer is not None and one.finer(Fraction(1, 10**4)) is None for one in found)


circles = st.tuples(*[st.integers(0, 30).map(float)] * 2, st.integers(1, 9).map(float))


@examples(15)
@given(st.lists(circles, min_size=2, max_size=4), st.sampled_from(["nonzero", "evenodd"]))
def test_a_finer_region_is_close_to_the_coarse_one(
    drawn: list[tuple[float, float, float]], rule: str
) -> None:
    for one in parse_candidates(f"<svg>{draw_path(drawn, rule)}</svg>"):
        finer = one.finer and one.finer(Fraction(1, 1000))
        if finer:
            box, finer_box = bound_points(one.vertices()), bound_points(finer.vertices())
            moves = [abs(Fraction(a - b)) for a, b in zip(box, finer_box, strict=True)]
            assert max(moves) <= one.error + finer.error


@pytest.mark.parametrize("gap", ["1", "01"])
def test_a_filled_path_with_a_hole_is_flattened_again(gap: str) -> None:
    part = f'<rect x="40.000{gap}" y="40" width="5" height="20"/>'
    disc = draw_path([(30, 50, 10), (30, 50, 5)], "evenodd")
    (found,) = parse_layouts(f"<svg>{SHEET}{disc}{part}</svg>")
    (name, *_) = [one["id"] for one in found.data["parts"]]
    assert not judge_layout(Layout.from_json(found.data)).valid
    assert found.flatten is not None
    finer = found.flatten([name], Fraction(1, 10**6))
    assert len(finer[name]["holes"]) == 1
    parts = [{**one, **finer.get(one["id"], {})} for one in found.data["parts"]]
    assert judge_layout(Layout.from_json(found.data | {"parts": parts})).valid
