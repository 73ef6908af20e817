"""The generator: the same cases everywhere, and the families what they say."""

from collections.abc import Callable
from functools import cache
from itertools import islice

import pytest
from builders.shipping import unproved
from hypothesis import given
from hypothesis import strategies as st

from exactsweep.corpus import FAMILIES, Case, find_case, generate, notes
from exactsweep.corpus.generator.prng import Prng

each_family = pytest.mark.parametrize("family", FAMILIES)
EACH = 12


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


def test_all_numbers_are_drawn_about_equally_often() -> None:
    random = Prng("dice")
    thrown = [random.between(1, 6) for _ in range(6000)]
    assert all(900 < thrown.count(side) < 1100 for side in range(1, 7))
    happened = sum(random.chance(1, 4) for _ in range(4000))
    assert 900 < happened < 1100


def test_nothing_lies_between_bounds_that_are_exchanged() -> None:
    with pytest.raises(ValueError, match=r"^nothing is between 2 and 1$"):
        Prng("").between(2, 1)


@each_family
def test_cases_are_proved(family: str) -> None:
    for case in drawn(family)[:4]:
        assert list(unproved(case)) == []


@each_family
def test_cases_come_again_by_their_id(family: str) -> None:
    for number, case in enumerate(generate(family, 5, 3)):
        assert case.id == f"gen-{family}-5-{number}"
        assert find_case(case.id) == case
    assert list(generate(family, 5, 2)) == list(islice(generate(family, 5), 2))


@each_family
def test_flags_are_known(family: str) -> None:
    for case in drawn(family):
        assert "generated" in case.flags
        assert set(case.flags) <= set(notes())


def has(*flags: str) -> Callable[[Case], bool]:
    return lambda case: set(flags) <= set(case.flags)


def of_any_shape(case: Case) -> bool:
    return case.kind == "SS"


def holds(number_type: str) -> Callable[[Case], bool]:
    return lambda case: number_type in case.representable


@pytest.mark.parametrize(
    ("family", "aim", "least"),
    [
        ("convex", lambda case: case.kind == "CC", EACH),
        ("notched", lambda case: case.kind == "CM", EACH - 1),
        ("monotone", lambda case: case.kind == "MM", EACH - 1),
        ("grid", has("parallel-edges"), EACH - 1),
        ("rectilinear", has("exact-fit"), 2),
        ("fits", has("exact-fit"), EACH - 2),
        ("equal-slopes", has("parallel-edges"), EACH),
        ("turned", has("turned"), EACH // 2),
        ("respelled", has("collinear-vertex"), EACH - 1),
        ("respelled", has("repeated-vertex"), EACH - 1),
        ("respelled", has("clockwise"), EACH // 4),
        ("rounded-crossings", has("rounded-answer"), EACH - 1),
        ("far", holds("binary64"), EACH),
        ("fractions", has("fractional-input"), EACH),
        ("slivers", has("sliver"), EACH),
        ("near-parallel", has("near-parallel"), EACH - 1),
        ("near-parallel", holds("binary64"), EACH),
        ("near-fits", has("exact-fit"), 1),
        ("near-fits", lambda case: "exact-fit" not in case.flags, 1),
        ("near-fits", holds("binary64"), EACH),
        ("perturbed", has("near-parallel"), 1),
        ("perturbed", holds("binary64"), EACH),
        ("int32-edge", has("overflow-int32", "product-overflow-int32"), EACH - 1),
        ("int64-edge", has("overflow-int64", "product-overflow-int64"), EACH - 1),
        ("binary64-edge", holds("binary64"), EACH),
        ("binary64-edge", has("tiny"), 1),
        ("binary64-edge", has("huge"), 1),
        ("long", lambda case: case.size > 40, EACH),
        ("polyominoes", of_any_shape, 2),
        ("jigsaw", has("exact-fit"), 3),
        ("jigsaw", of_any_shape, 1),
        ("mould", has("hole", "single-position"), EACH - 1),
        ("cave", has("no-fit-hole"), 1),
        ("cave", has("exact-fit"), EACH // 2),
        ("spiral", of_any_shape, EACH // 2),
        ("rings", has("hole"), EACH),
        ("rings", has("single-position"), 2),
        ("stars", of_any_shape, 3),
        ("tangles", of_any_shape, 1),
        ("plate", has("hole", "exact-fit"), EACH // 2),
        ("plate", has("several-rooms"), 2),
        ("container", has("exact-fit-inside"), 4),
        ("container", has("does-not-fit"), 1),
        ("combs", has("exact-fit"), EACH - 2),
    ],
)
def test_families_aim_at_what_they_say(
    family: str, aim: Callable[[Case], bool], least: int
) -> None:
    assert sum(map(aim, drawn(family))) >= least


@pytest.mark.parametrize(
    ("seed", "count", "message"),
    [
        (-1, 1, r"^the seed is -1, which is not from 0 to 10\*\*18 - 1$"),
        (10**18, 1, "^the seed is 1000000000000000000, which is not"),
        (1, -2, "^the count is negative: -2$"),
    ],
)
def test_numbers_out_of_range_are_refused(seed: int, count: int, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        generate("grid", seed, count)
