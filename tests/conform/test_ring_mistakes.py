"""No program that errs in holes, in regions or in exact fits is acquitted, and each is told why."""

import re
from functools import cache
from itertools import islice

import pytest
from mistakes import MISTAKES
from ring_mistakes import RING_MISTAKES, judge_wrong_rings
from shipped_cases import shipped_cases

from exactsweep.corpus import Case

ENOUGH = 2


@cache
def find_cases() -> list[Case]:
    """Small cases with holes or containers, those of several rings first."""
    chosen = [c for c in shipped_cases() if c.holes or c.inner_regions is not None]
    small = sorted(chosen, key=lambda case: (case.size, case.id))[:120]
    rings = {case.id: len(case.holes) + len(case.inner_regions or ()) for case in small}
    return sorted(small, key=lambda case: -rings[case.id])


@pytest.mark.parametrize("name", RING_MISTAKES)
def test_a_mistake_in_rings_is_convicted_and_named(name: str) -> None:
    mistake = RING_MISTAKES[name]
    judged = [*islice(judge_wrong_rings(mistake, find_cases()), ENOUGH)]
    assert judged
    for case, found in judged:
        said = [words for p in found.parts for words in (p.reason, p.kind, *p.diagnosis)]
        assert found.verdict in mistake.verdicts, (case.id, found.verdict, said)
        assert any(re.search(mistake.says, words) for words in said), (case.id, said)


def test_there_are_enough_faulty_programs() -> None:
    assert len(MISTAKES) + len(RING_MISTAKES) >= 160
