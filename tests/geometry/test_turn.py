"""Rotations: rational ones are exact, others within the requested error, by trigonometry."""

from fractions import Fraction
from typing import Any

import mpmath
import pytest
from hypothesis import given
from hypothesis import strategies as st

from exactsweep import Polygon
from exactsweep.geometry.turn import bound_half_tangent, read_turn
from exactsweep.numbers.error import ArgumentError, NumberError

ANGLES = st.fractions(min_value=-720, max_value=720, max_denominator=10**6)


@given(ANGLES, st.integers(1, 200))
def test_a_rational_rotation_is_on_the_circle_and_close_to_the_angle(
    angle: Fraction, bits: int
) -> None:
    cosine, sine, error = read_turn(angle).near(bits)
    assert cosine * cosine + sine * sine == 1
    assert error == (Fraction(1, 2**bits) if angle % 90 else 0)
    with mpmath.workprec(500):
        true = mpmath.pi * angle.numerator / (180 * angle.denominator)
        across = mpmath.cos(true) - mpmath.mpf(cosine.numerator) / cosine.denominator
        up = mpmath.sin(true) - mpmath.mpf(sine.numerator) / sine.denominator
        assert mpmath.hypot(across, up) <= mpmath.mpf(2) ** -min(bits, 450)


@given(ANGLES, st.integers(8, 100))
def test_a_rational_rotation_has_few_digits(angle: Fraction, bits: int) -> None:
    # The square of the denominator of the tangent of half the angle, and a few bits more.
    assert read_turn(angle).near(bits).cosine.denominator.bit_length() <= 2 * bits + 4


@pytest.mark.parametrize("quarters", range(-4, 9))
def test_quarter_turns_are_exact_and_equal_in_every_form(quarters: int) -> None:
    pair = [(1, 0), (0, 1), (-1, 0), (0, -1)][quarters % 4]
    turn = read_turn(90 * quarters)
    assert turn.near(1) == (*map(Fraction, pair), Fraction(0))
    assert turn == read_turn(pair) == read_turn(str(90 * quarters))
    assert hash(turn) == hash(read_turn(pair))


def test_other_rotations_compare_by_degrees_or_by_cosine_and_sine() -> None:
    assert read_turn("30") == read_turn(390) != read_turn("30.1")
    assert read_turn((3, 4)) == read_turn(("3/5", "4/5")) != read_turn((4, 3))
    assert read_turn((3, 4)).near(1) == (Fraction(3, 5), Fraction(4, 5), Fraction(0))
    assert str(read_turn("33.3")) == "333/10 degrees"
    assert str(read_turn((3, 4))) == "the turn with cosine 3/5 and sine 4/5"


@pytest.mark.parametrize("by", [(1, 1), (0, 0), "left", None, (1, 2, 3)])
def test_values_other_than_rotations_are_rejected(by: object) -> None:
    with pytest.raises(ValueError, match=r"number|rational length"):
        read_turn(by)


def test_the_tangent_of_45_degrees_is_bounded_on_both_sides() -> None:
    low, high = bound_half_tangent(Fraction(90), 100)
    assert low <= 1 <= high
    assert high - low <= Fraction(1, 2**100)


def test_a_rotated_polygon_is_congruent_and_close_to_the_true_one() -> None:
    polygon = Polygon([(0, 0), (5, 0), (3, 4)])
    turned = polygon.rotated(30, bits=100)
    assert turned.area == polygon.area
    # The image of (5, 0) is (5 cos 30, 5 / 2).
    (vertex,) = [v for v in turned.vertices if v.x > 4]
    assert abs(vertex.y - Fraction(5, 2)) < Fraction(5, 2**100)
    assert abs(vertex.x**2 - Fraction(75, 4)) < Fraction(50, 2**100)
    assert polygon.rotated(30) != turned
    with pytest.raises(NumberError):
        polygon.rotated((1, 1))


@pytest.mark.parametrize("bits", ["8", 2.5, None])
def test_wrong_bits_are_named(bits: Any) -> None:
    with pytest.raises(ArgumentError, match=r"^bits is .*, not int$"):
        Polygon([(0, 0), (1, 0), (0, 1)]).rotated(45, bits=bits)
