"""Numbers in reports have six digits, rounded once, in linear time."""

from decimal import ROUND_CEILING, Context, Decimal
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from linear import require_linear

from exactsweep.text.report import approximate, lay_out, list_facts, make_table, take_root

SIX = Context(prec=6, Emax=10**9, Emin=-(10**9))


def expected(value: Fraction) -> Decimal:
    return SIX.divide(Decimal(value.numerator), Decimal(value.denominator))


@given(st.fractions(), st.integers(-2000, 2000), st.integers(1, 10**300))
def test_six_digits_are_rounded_correctly(value: Fraction, power: int, denominator: int) -> None:
    for number in (value, value * Fraction(10) ** power, value / denominator):
        assert Decimal(approximate(number)) == expected(number)


@given(st.fractions(), st.integers(-2000, 2000))
def test_bounds_are_rounded_up(value: Fraction, power: int) -> None:
    number = value * Fraction(10) ** power
    exactly = SIX.copy()
    exactly.rounding = ROUND_CEILING
    n, d = map(Decimal, number.as_integer_ratio())
    assert Decimal(approximate(number, up=True)) == exactly.divide(n, d)


@given(st.integers(100_000, 999_999), st.integers(0, 900), st.sampled_from([-1, 0, 1]))
def test_ties_are_rounded_exactly(digits: int, places: int, offset: int) -> None:
    """The difference is below the precision of the first bits."""
    middle = Fraction(2 * digits + 1, 2) + Fraction(offset, 10**places * 3)
    for number in (middle, -middle, middle / 10**800, middle * 10**800):
        assert Decimal(approximate(number)) == expected(number)


def test_long_numbers_are_rounded_by_their_first_bits() -> None:
    """Whole numbers took half a second for 137,607 digits."""
    numbers = {n: Fraction(7**n, 2 ** (2 * n)) for n in (10_000, 80_000)}
    require_linear(lambda n: approximate(numbers[n]))


@given(st.fractions(min_value=0), st.integers(0, 900), st.sampled_from([1, -1]))
def test_roots_of_any_size_have_60_bits(value: Fraction, power: int, sense: int) -> None:
    square = value * Fraction(10) ** (sense * power)
    root = take_root(square)
    assert square <= root**2 <= square * (1 + Fraction(1, 2**56))


@pytest.mark.parametrize("width", [None, 80])
def test_names_in_brackets_are_shown_verbatim(width: int | None) -> None:
    table = make_table(["part"])
    table.add_row("[bold]left[/bold]")
    assert "[bold]left[/bold]" in lay_out([table], width)


def test_a_long_text_is_shown_in_full() -> None:
    shown = lay_out([list_facts({"area": "7" * 300}, 6)], 80)
    assert shown.count("7") == 300


@pytest.mark.parametrize("width", [30, 40, 60])
def test_cells_are_folded_on_narrow_terminals(width: int) -> None:
    table = make_table(("", "vertices", "approx. area", "exact area"), {"vertices"}, 12)
    table.add_row("generatrix", "4", "7" * 9, "8" * 60)
    shown = lay_out([table], width)
    assert (shown.count("7"), shown.count("8")) == (9, 60)
