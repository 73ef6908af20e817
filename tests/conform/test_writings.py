"""A right answer passes however it is written; `python -m tests.writings` tries all cases."""

from functools import cache

import pytest
from right_answers import WRITINGS, judge_writing

from exactsweep.corpus import Case, cases, find_case

# A door that fits, several holes, rings that touch, a container of several regions and fits.
SPECIAL = ("fits-square", "holes-room", "sampled-plate-2", "components-unswept-slanted")


@cache
def find_cases() -> list[Case]:
    small = list(cases(max_size=16))
    return [*map(find_case, SPECIAL), *small[::60]]


@pytest.mark.parametrize("name", WRITINGS)
def test_a_right_answer_passes_in_any_way(name: str) -> None:
    judged = judge_writing(WRITINGS[name], find_cases())
    assert judged.number
    assert judged.convicted == []


def test_there_are_more_than_forty_ways() -> None:
    assert len(WRITINGS) > 40
