"""Filled regions, compared with winding numbers computed from the definition."""

from collections.abc import Callable, Sequence
from fractions import Fraction

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Point, PolygonError, Region
from exactsweep.formats.filling import Rule, fill

RULES: dict[Rule, Callable[[int], object]] = {
    "nonzero": bool,
    "evenodd": lambda number: number % 2,
    "positive": lambda number: number > 0,
}
points = st.builds(Point, *[st.integers(0, 6).map(Fraction)] * 2)
rings = st.lists(st.lists(points, min_size=3, max_size=6), min_size=1, max_size=4)
# Not on any line through lattice points.
places = [
    Point(Fraction(2 * i + 1, 2003) * 499, Fraction(2 * k + 1, 1999) * 497)
    for i in range(-1, 15)
    for k in range(-1, 15)
]


def find_winding_number(ring: Sequence[Point], place: Point) -> int:
    """Count the signed crossings of a ray to the right."""
    number = 0
    for a, b in zip(ring, [*ring[1:], ring[0]], strict=True):
        if (a.y <= place.y) != (b.y <= place.y):
            side = (b.x - a.x) * (place.y - a.y) - (b.y - a.y) * (place.x - a.x)
            if (b.y > a.y) == (side > 0):
                number += 1 if b.y > a.y else -1
    return number


def square(x: int, y: int, size: int) -> list[Point]:
    corners = [(x, y), (x + size, y), (x + size, y + size), (x, y + size)]
    return [Point(Fraction(u), Fraction(v)) for u, v in corners]


@examples(25)
@given(rings, st.sampled_from([*RULES]))
@example([square(0, 0, 6), square(1, 1, 1), square(1, 3, 1), square(3, 1, 2)], "evenodd")
@example([square(0, 0, 6), square(0, 0, 3), square(3, 3, 3), square(0, 3, 3)], "evenodd")
def test_points_are_filled_by_their_winding_numbers(drawn: list[list[Point]], rule: Rule) -> None:
    filled = fill(drawn, rule)
    for exterior, *holes in filled.regions:
        Region(exterior, holes)
    for place in places:
        number = sum(find_winding_number(ring, place) for ring in drawn)
        inside = sum(find_winding_number(ring, place) for one in filled.regions for ring in one)
        assert inside == bool(RULES[rule](number))


@pytest.mark.parametrize(
    ("drawn", "touching"),
    [
        ([square(0, 0, 6), square(1, 1, 1)], False),
        ([square(0, 0, 1), square(1, 1, 1)], False),
        ([square(0, 0, 2), square(1, 1, 2)], True),
        ([square(0, 0, 2), square(2, 1, 1)], True),
        ([square(0, 0, 1), square(1, 0, 1)], True),
    ],
)
def test_rings_that_cross_or_share_edges_are_reported(
    drawn: list[list[Point]], touching: bool
) -> None:
    assert fill(drawn, "nonzero").touching == touching
    assert fill(drawn[::-1], "nonzero").touching == touching


def test_regions_keep_the_order_of_drawing() -> None:
    drawn = [square(4, 4, 1), square(0, 0, 1), square(2, 2, 1)]
    assert [exterior[0] for (exterior,) in fill(drawn, "nonzero").regions] == [
        ring[0] for ring in drawn
    ]


@pytest.mark.parametrize(("most", "refused"), [(10_000, False), (1_000, True)])
def test_edges_that_cross_very_often_are_rejected(
    most: int, refused: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("exactsweep.formats.filling.MAX_PAIRS", most)
    bars = [
        [Point(Fraction(x), Fraction(y)) for x, y in [(0, 0), (12, k), (12, k + 1), (0, 12 - k)]]
        for k in range(1, 12)
    ]
    if refused:
        with pytest.raises(PolygonError, match="too many edges cross"):
            fill(bars, "nonzero")
    else:
        assert len(fill(bars, "nonzero").regions) == 1
