"""The generator: the same cases on all platforms, and families as described."""

from functools import cache
from itertools import islice

import pytest
from builders.shipping import unproved
from hypothesis import given
from hypothesis import strategies as st
from tiers import mostly_long

from exactsweep.corpus import FAMILIES, Case, find_case, generate, notes
from exactsweep.corpus.generator.prng import Prng

each_family = pytest.mark.parametrize("family", FAMILIES)
EACH = 4


@cache
def drawn(family: str) -> list[Case]:
    return list(generate(family, 11, EACH))


def test_random_numbers_are_those_of_splitmix64() -> None:
    random = Prng("")
    random._state = 1234567
    assert [random.bits64() for _ in range(5)] == [
        6457827717110365317,
        3203168211198807973,
        9817491932198370423,
        4593380528125082431,
        16408922859458223821,
    ]


@given(st.text("abc 7"), st.integers(-(2**70), 2**70), st.integers(0, 2**130))
def test_random_numbers_are_between_their_bounds(seed: str, low: int, span: int) -> None:
    random, again = Prng(seed), Prng(seed)
    drawn = random.between(low, low + span)
    assert low <= drawn <= low + span
    assert drawn == again.between(low, low + span)
    assert Prng(seed).between(low, low) == low


def test_a_range_beyond_64_bits_takes_two_draws() -> None:
    random = Prng("wide")
    assert [random.between(0, 2**64) for _ in "ab"] == [14703512553011986645, 16698534356282190863]


def test_draws_are_nearly_uniform() -> None:
    random = Prng("dice")
    thrown = [random.between(1, 6) for _ in range(6000)]
    assert all(900 < thrown.count(side) < 1100 for side in range(1, 7))
    happened = sum(random.chance(1, 4) for _ in range(4000))
    assert 900 < happened < 1100


def test_a_range_that_does_not_divide_the_draws_is_uniform() -> None:
    random, third = Prng("long dice"), 2**62
    low = sum(random.between(1, 3 * third) <= third for _ in range(600))
    assert 160 < low < 240


def test_exchanged_bounds_are_an_empty_range() -> None:
    with pytest.raises(ValueError, match=r"^empty range: 2 to 1$"):
        Prng("").between(2, 1)


@pytest.mark.parametrize("family", mostly_long(FAMILIES, [*FAMILIES][::3]))
def test_cases_are_proved(family: str) -> None:
    for case in drawn(family):
        assert list(unproved(case)) == []


@each_family
def test_cases_are_regenerated_by_id(family: str) -> None:
    for number, case in enumerate(generate(family, 5, 3)):
        assert case.id == f"gen-{family}-5-{number}"
        assert find_case(case.id) == case
    assert list(generate(family, 5, 0)) == []
    assert list(generate(family, 5, 2)) == list(islice(generate(family, 5), 2))


@each_family
def test_flags_are_known(family: str) -> None:
    for case in drawn(family):
        assert "generated" in case.flags
        assert set(case.flags) <= set(notes())


@pytest.mark.parametrize(
    ("seed", "count", "message"),
    [
        (-1, 1, r"^the seed -1 is outside the range 0 to 10\*\*18 - 1$"),
        (10**18, 1, "^the seed 1000000000000000000 is outside"),
        (1, -2, "^the count is negative: -2$"),
    ],
)
def test_numbers_out_of_range_are_rejected(seed: int, count: int, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        generate("grid", seed, count)
