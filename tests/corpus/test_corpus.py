"""The shipped corpus: files, flags, number types, and selection of cases."""

import json
from collections import Counter
from fractions import Fraction
from importlib.resources import files
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import Draft202012Validator
from shipped_cases import shipped_cases
from tiers import few_or_all

from exactsweep.corpus import Case, cases, notes, themes
from exactsweep.corpus.answered import find_types
from exactsweep.corpus.case import KINDS
from exactsweep.corpus.shipped import read_schema, read_theme

SCHEMA = json.loads(read_schema())
A_CASE = Draft202012Validator(SCHEMA)
A_THEME = A_CASE.evolve(schema=SCHEMA["$defs"]["theme"])


@pytest.fixture(scope="module")
def shipped() -> list[Case]:
    return list(shipped_cases())


def theme_file(name: str) -> Any:
    return json.loads(read_theme(files("exactsweep.corpus").joinpath("data"), name))


def test_there_are_enough_cases_of_each_class(shipped: list[Case]) -> None:
    kinds = Counter(case.kind for case in shipped)
    assert len(shipped) >= 300
    assert min(kinds[kind] for kind in KINDS) >= 100


def test_ids_are_unique_and_begin_with_their_theme(shipped: list[Case]) -> None:
    assert len({case.id for case in shipped}) == len(shipped)
    for theme in themes():
        ids = [data["id"] for data in theme_file(theme)["cases"]]
        assert ids == [case.id for case in shipped if case.id.startswith(f"{theme}-")]


@few_or_all
def test_schema_describes_every_file(step: int) -> None:
    Draft202012Validator.check_schema(SCHEMA)
    for theme, title in [*themes().items()][::step]:
        data = theme_file(theme)
        A_THEME.validate(data)
        assert (data["theme"], data["title"]) == (theme, title)


def test_every_flag_has_a_note_and_every_note_a_case(shipped: list[Case]) -> None:
    used = {flag for case in shipped for flag in case.flags} | {"generated"}
    assert used == set(notes())
    assert list(notes()) == sorted(notes())
    for note in notes().values():
        assert note.meaning.endswith(".")
        assert note.catches.endswith((".", "?"))


def input_of(case: Case) -> list[Fraction]:
    rings = *case.directrix_rings, *case.generatrix_rings, (case.reference,)
    return [c for ring in rings for point in ring for c in point]


def answer_of(case: Case) -> list[Fraction]:
    loops = (case.trajectory, case.inner, case.outer, *case.holes, *case.unswept)
    rings = [loop.vertices for loop in loops]
    rings += [region.vertices for region in case.inner_regions or ()]
    fits = *case.exact_fits, *case.inner_exact_fits
    return [c for points in (*rings, *fits) for point in points for c in point]


def fits_binary64(value: Fraction) -> bool:
    """By definition: 53 bits, the last one worth at least 2**-1074, below 2**1024."""
    n, d = abs(value.numerator), value.denominator
    if d & (d - 1):
        return False
    last = (n & -n).bit_length() - d.bit_length() if n else 0
    return (n // (n & -n or 1)).bit_length() <= 53 and last >= -1074 and n < d * 2**1024


def test_integer_scale_is_the_least_that_makes_the_input_integer(shipped: list[Case]) -> None:
    for case in shipped:
        scale = case.integer_scale
        assert all((c * scale).denominator == 1 for c in input_of(case))
        # A factor that makes them integers is a multiple of each denominator, so of their lcm.
        assert all(scale % c.denominator == 0 for c in input_of(case))
        for prime in (p for p in range(2, 50) if scale % p == 0):
            assert not all((c * scale / prime).denominator == 1 for c in input_of(case))


@pytest.mark.long
def test_representable_types_represent_every_coordinate(shipped: list[Case]) -> None:
    for case in shipped:
        scale = case.integer_scale
        for values, held in [
            (input_of(case), case.representable),
            (answer_of(case), case.answer_representable),
        ]:
            expected = set()
            for bits in 32, 64:
                whole = {Fraction(c * scale) for c in values}
                if all(c.denominator == 1 and -(2**bits) <= 2 * c < 2**bits for c in whole):
                    expected.add(f"int{bits}")
            if all(map(fits_binary64, values)):
                expected.add("binary64")
            assert held == expected, case.id


@pytest.mark.long
def test_answers_off_the_integer_grid_are_flagged(shipped: list[Case]) -> None:
    for case in shipped:
        scaled = [c * case.integer_scale for c in answer_of(case)]
        assert ("rounded-answer" in case.flags) == any(c.denominator > 1 for c in scaled)
        for bits in 32, 64:
            beyond = any(not -(2**bits) <= 2 * c < 2**bits for c in scaled)
            held = f"int{bits}" in case.representable
            assert (f"overflow-int{bits}" in case.flags) == (held and beyond)


@given(
    st.builds(
        lambda n, e: Fraction(n) * Fraction(2) ** e,
        st.integers(-(2**54), 2**54) | st.sampled_from([2**53 - 1, 2**53 + 1, 2**63, -(2**63)]),
        st.integers(-1080, 1024) | st.sampled_from([0, -1074, -1075, 971, 970]),
    )
    | st.fractions()
)
def test_binary64_is_decided_by_its_definition(value: Fraction) -> None:
    assert ("binary64" in find_types([value], 1)) == fits_binary64(value)


def test_filters_select(shipped: list[Case]) -> None:
    chosen = list(cases(flags=["exact-fit", "turned"], kind="CM", max_size=12))
    assert chosen == [
        case
        for case in shipped
        if {"exact-fit", "turned"} <= set(case.flags) and case.kind == "CM" and case.size <= 12
    ]
    assert chosen
    assert list(cases(prefix="fits-h")) == [c for c in shipped if c.id.startswith("fits-h")]
    assert list(cases(prefix="nothing-")) == []


def test_cases_are_read_one_by_one(monkeypatch: pytest.MonkeyPatch) -> None:
    found = cases()
    monkeypatch.setattr(Case, "representable", property(lambda case: 1 / 0))
    with pytest.raises(ZeroDivisionError):
        next(found)
