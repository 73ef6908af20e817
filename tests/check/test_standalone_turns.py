"""Turns that the checker that stands alone reads, and how far they can be off."""

from fractions import Fraction

import pytest

from exactsweep.check.standalone import read_turn, turn_error


@pytest.mark.parametrize("degrees", [0, 36, 90, 180, 270, 359])
def test_a_turn_is_the_same_after_whole_turns(degrees: int) -> None:
    assert read_turn(str(degrees)) == read_turn(str(degrees + 360)) == read_turn(str(degrees - 720))
    assert read_turn("450") == (0, 1)
    assert read_turn("719/2") == Fraction(719, 2)


@pytest.mark.parametrize("degrees", [1, 30, 45, 60, 89, 91, 135, 200, 271, 330, 359])
def test_the_bound_on_a_turn_is_that_of_interval_arithmetic(degrees: int) -> None:
    from mpmath import iv

    before = iv.prec
    try:
        iv.prec = 400
        angle = iv.pi * degrees / 180
        cosine, sine = (
            Fraction(round(float(end * 2**50)), 2**50) for end in (iv.cos(angle).a, iv.sin(angle).a)
        )
        bound = turn_error((cosine, sine), Fraction(degrees))
        exact = abs(iv.mpf(cosine.numerator) / cosine.denominator - iv.cos(angle)) + abs(
            iv.mpf(sine.numerator) / sine.denominator - iv.sin(angle)
        )
        written = iv.mpf(bound.numerator) / bound.denominator
        assert exact.b <= written.a
        assert (written - exact).b < iv.mpf(10) ** -94
    finally:
        iv.prec = before


def test_the_bound_on_no_turn_is_what_is_added_for_the_digits_of_pi() -> None:
    turn, quarter = ((Fraction(x), Fraction(1 - x)) for x in (1, 0))
    assert turn_error(turn, Fraction(0)) == Fraction(1, 10**95)
    assert Fraction(1, 10**95) < turn_error(quarter, Fraction(90)) < Fraction(2, 10**95)
    assert turn_error(quarter, Fraction(0)) == 2 + Fraction(1, 10**95)
