from contextvars import copy_context
from decimal import Decimal, localcontext
from fractions import Fraction
from math import gcd
from typing import Any

import gmpy2
import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from refusals import list_refusals, require_refused

from exactsweep.numbers.digits import abridge, format_fraction, format_rounded
from exactsweep.numbers.error import NumberError, quote
from exactsweep.numbers.limits import Limits, get_limits, limits, set_limits
from exactsweep.numbers.number import ratio, to_fraction

NINES = "9" * 5000


class Unprintable:
    def __repr__(self) -> str:
        raise RuntimeError


@given(st.fractions())
def test_format_and_read_are_inverse(value: Fraction) -> None:
    assert to_fraction(format_fraction(value)) == value


@given(st.decimals(allow_nan=False, allow_infinity=False))
def test_decimals_are_exact_as_objects_and_as_text(value: Decimal) -> None:
    assert to_fraction(value) == to_fraction(str(value).replace("E", "e")) == Fraction(value)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_floats_keep_their_binary_value(value: float) -> None:
    expected = Fraction(*value.as_integer_ratio())
    assert to_fraction(value) == to_fraction(np.float64(value)) == expected
    assert to_fraction(sympy.Float(value)) == to_fraction(gmpy2.mpfr(value)) == expected


@given(st.fractions())
def test_rationals_of_other_libraries_are_exact(value: Fraction) -> None:
    n, d = value.numerator, value.denominator
    assert to_fraction(sympy.Rational(n, d)) == to_fraction(gmpy2.mpq(n, d)) == value


@pytest.mark.parametrize("three", [3, np.int8(3), np.uint64(3), gmpy2.mpz(3), sympy.Integer(3)])
def test_integers_of_any_library_are_exact(three: Any) -> None:
    found = to_fraction(three)
    assert found == 3
    assert type(found) is Fraction
    assert type(found.numerator) is int


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("3", Fraction(3)),
        ("-0", Fraction(0)),
        ("-7/2", Fraction(-7, 2)),
        ("6/4", Fraction(3, 2)),
        ("0.125", Fraction(1, 8)),
        ("-0.50", Fraction(-1, 2)),
        ("1e-3", Fraction(1, 1000)),
        ("1.5E+2", Fraction(150)),
        ("1e0002", Fraction(100)),
        ("1e000000000000002", Fraction(100)),  # 15 digits, as many as are read
        (np.str_("1/2"), Fraction(1, 2)),
    ],
)
def test_grammar_accepts(text: str, value: Fraction) -> None:
    assert to_fraction(text) == value


@pytest.mark.parametrize(("call", "said"), list_refusals(__file__))
def test_errors_name_the_value_that_is_not_a_number(call: str, said: str) -> None:
    require_refused(call, said)


def test_values_without_repr_are_named_by_their_type() -> None:
    with pytest.raises(NumberError, match=r"^<Unprintable> is not a rational number$"):
        to_fraction(Unprintable())


def test_limits_can_be_changed_within_a_block() -> None:
    with limits(max_digits=5000):
        assert to_fraction("1e4999") == to_fraction(Decimal("1e4999")) == 10**4999
        with limits(max_digits=2), pytest.raises(NumberError, match="more than 3 digits"):
            to_fraction("1e3")
        with pytest.raises(NumberError, match="more than 5000 digits"):
            to_fraction("1e5000")
    with pytest.raises(NumberError, match="more than 4300 digits"):
        to_fraction("1e4999")


def test_numbers_in_full_may_have_as_many_digits_as_answers() -> None:
    """In a former version, loops of long numbers could be written but not read."""
    with limits(max_digits=2):
        assert get_limits().answer_digits == 71
        longest = 10**71 - 1
        for value in (Fraction(longest), Fraction(-longest, longest - 1), Fraction(1, longest)):
            assert to_fraction(format_fraction(value)) == value
        long = f"1{'0' * 71}"
        for text in (f"5/{long}", f"{long}/5"):
            assert to_fraction(text) == Fraction(text)
        for text in (
            long,
            f"1/{long}",
            f"0.{'0' * 70}1",
            f"9.{'1' * 71}",
        ):
            with pytest.raises(NumberError, match="more than 71 digits"):
                to_fraction(text)
        assert to_fraction("1e2") == 100
        for text in ("1e3", "12e3", "1.5e9", "1e-9"):
            with pytest.raises(NumberError, match=f"more than {len(text)} digits"):
                to_fraction(text)


def test_limits_are_kept_in_another_process() -> None:
    held = Limits(7, 3)
    context = copy_context()
    context.run(set_limits, held)
    assert context.run(get_limits) == held
    assert get_limits() == Limits(4300, 16)


def test_limits_apply_to_strings_and_not_to_numbers() -> None:
    with limits(max_digits=2):
        assert to_fraction("0.12") == Fraction(3, 25)
        assert to_fraction(12345) == 12345
        assert to_fraction(Fraction(1, 10**5)) == Fraction(1, 10**5)


def test_each_limit_can_be_changed_alone() -> None:
    with limits(max_mib=0.5), limits(max_digits=9):
        assert get_limits() == Limits(9, 0.5)
        assert get_limits().max_bytes == 2**19
        with limits(**get_limits()._asdict()):
            assert get_limits().answer_digits == 32 * 9 + 7
    assert get_limits() == Limits(4300, 16)
    assert get_limits().max_bytes == 2**24


@pytest.mark.parametrize("sign", ["", "-"])
def test_the_limit_applies_to_the_number_in_any_spelling(sign: str) -> None:
    """A former version read 1e4000, but not its 4,001 digits."""
    half = Fraction(1, 2**14_000)  # 14,000 digits as a decimal, 4,215 as a fraction
    tenth = Fraction(1, 10**4299)
    for value in (Fraction(10**4299), tenth, half, half + 1, Fraction(10**4300 - 1)):
        signed = value if sign == "" else -value
        with localcontext(prec=20_000):
            decimal = Decimal(signed.numerator) / Decimal(signed.denominator)
        for text in (format_fraction(signed), f"{decimal:f}", f"{decimal:e}", decimal):
            assert to_fraction(text) == signed
    for beyond in ("1e4300", "1e-4300", "10e4299", "0.01e-4298"):
        with pytest.raises(NumberError, match="more than 4300 digits"):
            to_fraction(sign + beyond)


def test_any_digit_count_is_written() -> None:
    assert format_fraction(Fraction(-(10**5000 - 1), 10**5000)) == f"-{NINES}/1{'0' * 5000}"


def test_broken_rational_types_are_rejected() -> None:
    class Broken(Fraction):
        @property
        def denominator(self) -> int:
            return 0

    with pytest.raises(NumberError, match=r"is not a rational number$"):
        to_fraction(Broken(1, 2))


def test_time_spans_are_rejected() -> None:
    with pytest.raises(NumberError, match=r"timedelta64\(3,'s'\) is not a rational number$"):
        to_fraction(np.timedelta64(3, "s"))


def test_quotes_have_one_line() -> None:
    class Foreign:
        def __repr__(self) -> str:
            return "two\nlines, \u00e9 and \x07"

    assert quote(Foreign()) == "two\\nlines, \u00e9 and \\x07"


def test_unreduced_numbers_may_have_five_times_as_many_digits() -> None:
    with limits(max_digits=1):
        assert get_limits().answer_digits == 39
        assert to_fraction(f"1.{'0' * 194}") == to_fraction(f"0.{'0' * 195}") + 1 == 1
        for text in (f"1.{'0' * 195}", f"0.{'0' * 196}"):
            with pytest.raises(NumberError, match="more than 39 digits"):
                to_fraction(text)


def test_powers_of_ten_have_their_digits() -> None:
    """Of all powers of ten up to there, 10**643 is the one nearest below a power of two."""
    with limits(max_digits=643):
        assert to_fraction("1e642") == 10**642
        for text in ("1e643", "1e-643"):
            with pytest.raises(NumberError, match="more than 643 digits"):
                to_fraction(text)


def test_numbers_of_the_maximum_displayed_length_are_exact() -> None:
    assert quote("7" * 38) == f"'{'7' * 38}'"
    assert quote("7" * 39) == f"'{'7' * 36}..."
    assert abridge(Fraction(10**23)) == f"1{'0' * 23}"
    assert abridge(Fraction(10**24)) == "1e+24"
    assert abridge(Fraction(10**21 + 1, 3)) == "1000000000000000000001/3"
    assert abridge(Fraction(10**25, 3)) == "3.33333333333e+24~"
    assert abridge(Fraction(2**5000 + 1, 3**3000)) == "6.11243369215e+73~"


@given(st.fractions(), st.integers(0, 20), st.sampled_from("feg"))
def test_float_formats_round_once(value: Fraction, places: int, kind: str) -> None:
    shown = Fraction(format_rounded(value, f".{places}{kind}"))
    if kind == "f":
        assert shown == round(value, places)
    elif value:
        assert abs(shown / value - 1) <= Fraction(1, 2 * 10 ** max(places - 1, 0))


NUMBERS = [-6, 0, 1, 3, 12, *(Fraction(n, d) for n in (-6, 0, 1, 3, 12) for d in (1, 2, 4))]


def is_reduced(value: int | Fraction) -> bool:
    """Decide whether it is an int, or a Fraction of ints in lowest terms."""
    if type(value) is int:
        return True
    n, d = value.numerator, value.denominator
    return type(n) is type(d) is int and d > 0 and gcd(n, d) == 1


@pytest.mark.parametrize("value", NUMBERS)
def test_whole_quotients_are_ints(value: int | Fraction) -> None:
    for divisor in (1, 3, 4, Fraction(1), Fraction(3), Fraction(3, 2), Fraction(1, 4)):
        found = ratio(value, divisor)
        assert found == Fraction(value) / divisor
        assert is_reduced(found)
        assert (type(found) is int) == (found.denominator == 1)
