"""The exact scale of pictures."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from strategies import coordinates, simple_polygons

from exactsweep import Polygon
from exactsweep.draw import AxisScale, DrawError, Scale

BIG = 10**30


@given(simple_polygons())
def test_places_are_near_one_and_rounded_once(polygon: Polygon) -> None:
    scale = Scale.of(polygon.vertices)
    for vertex, place in zip(polygon.vertices, scale.places(polygon.vertices), strict=True):
        for c, shown, axis in zip(vertex, place, (scale.x, scale.y), strict=True):
            exact = (c - axis.origin) / axis.unit
            assert shown == float(exact)
            assert abs(shown) < 10**7


@given(simple_polygons(), st.sampled_from([3, 30, 300, -3, -30, -300]))
def test_enlarging_by_a_power_of_a_thousand_changes_units_only(
    polygon: Polygon, exponent: int
) -> None:
    # Far from the sizes without units.
    first = Fraction(10) ** (99 if exponent > 0 else -99)
    small = [(x * first, y * first) for x, y in polygon.vertices]
    factor = Fraction(10) ** exponent
    large = [(x * factor, y * factor) for x, y in small]
    before, after = Scale.of(small), Scale.of(large)
    assert before.places(small) == after.places(large)
    assert after.x.exponent - before.x.exponent == exponent


@given(coordinates(), coordinates())
def test_shapes_of_one_point_or_line_have_a_scale(x: Fraction, y: Fraction) -> None:
    for shape in ([(x, y)], [(x, y), (x, y + 1)], [(x, y), (x + 1, y)]):
        assert Scale.of(shape).is_true
        Scale.of(shape).places(shape)


def test_small_differences_of_long_numbers_are_visible() -> None:
    head, step = Fraction(7**600), Fraction(1, 3**900)
    line = [(head, head), (head + step, head + 2 * step), (head + 2 * step, head)]
    (ax, ay), (bx, by), (cx, cy) = Scale.of(line).places(line)
    assert ax < bx < cx
    assert ay == cy < by
    assert 0 <= ax < cx < 1000


def test_axes_have_different_units_only_for_flat_pictures() -> None:
    assert Scale.of([(0, 0), (12, 1)]).is_true
    stretched = Scale.of([(0, 0), (13 * BIG, BIG)])
    assert not stretched.is_true
    assert Scale.of([(0, 0), (10**9, 5)]) == (
        AxisScale(Fraction(0), 9),
        AxisScale(Fraction(0), 0),
        False,
    )


@pytest.mark.parametrize(
    ("origin", "exponent", "label"),
    [
        ("0", 0, "$x$"),
        ("0", -30, r"$x\,/\,10^{-30}$"),
        ("5000", 0, "$x - 5000$"),
        ("-5000", 0, "$x + 5000$"),
        ("1/2", 0, "$x - 1/2$"),
        ("-1/2", 0, "$x + 1/2$"),
        ("5e20", 3, r"$(x - 5 \cdot 10^{20})\,/\,10^{3}$"),
        ("1e20", 0, r"$x - 10^{20}$"),
        ("123456789012345", 0, r"$x - 1.23456\ldots \cdot 10^{14}$"),
        ("99999999999999", 0, r"$x - 9.99999\ldots \cdot 10^{13}$"),
    ],
)
def test_labels_state_true_sizes(origin: str, exponent: int, label: str) -> None:
    assert AxisScale(Fraction(origin), exponent).label("x") == label


def test_a_distant_origin_is_a_round_number() -> None:
    for low, high, origin in (
        (BIG - 2, BIG + 10, BIG),
        (-BIG - 2, -BIG + 10, -BIG),
        (123_456, 123_478, 123_460),
        (123_451, 123_459, 123_451),
        (123_456, 123_556, 123_500),
    ):
        scale = Scale.of([(low, low), (high, high)])
        assert scale.x.origin == scale.y.origin == origin


def test_empty_and_distant_points_are_rejected() -> None:
    with pytest.raises(DrawError, match="there is nothing to draw"):
        Scale.of([], [])
    with pytest.raises(DrawError, match="a point is too far outside the picture"):
        Scale.of([(0, 0), (1, 1)]).place((0, 10**400))
