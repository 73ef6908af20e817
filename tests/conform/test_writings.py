"""A correct answer passes in any notation; `python -m tests.writings` tests all cases."""

from functools import cache

import pytest
from right_answers import WRITINGS, judge_writing
from shipped_cases import shipped_cases

from exactsweep.corpus import Case, find_case

# An exact entry, several holes, touching rings, a container with several regions and fits.
SPECIAL = ("fits-square", "holes-room", "sampled-plate-2", "components-unswept-slanted")


@cache
def find_cases() -> list[Case]:
    small = [case for case in shipped_cases() if case.size <= 16]
    return [*map(find_case, SPECIAL), *small[::60]]


@pytest.mark.parametrize("name", WRITINGS)
def test_a_correct_answer_passes_in_any_notation(name: str) -> None:
    judged = judge_writing(WRITINGS[name], find_cases())
    assert judged.number
    assert judged.convicted == []


@pytest.mark.long
@pytest.mark.parametrize("name", ["the nearest doubles", "the nearest integers"])
def test_a_rounded_answer_passes_in_all_cases(name: str) -> None:
    """Rounding may create self-contacts and spikes."""
    judged = judge_writing(WRITINGS[name], (case for case in shipped_cases() if case.size <= 60))
    assert judged.convicted == []


def test_there_are_more_than_forty_notations() -> None:
    assert len(WRITINGS) > 40
