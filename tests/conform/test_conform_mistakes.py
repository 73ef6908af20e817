"""No faulty program passes, and each mistake is diagnosed."""

from collections.abc import Callable
from functools import cache
from itertools import islice
from typing import Any

import pytest
from convictions import judge_wrong_answers, list_cases
from mistakes import MISTAKES
from spoiling import LOOPS
from tiers import mostly_long

from exactsweep import sweep
from exactsweep.conform import Verdict, conform
from exactsweep.corpus import Case

WITHIN = Verdict.WITHIN
ENOUGH = 2
"""Wrong answers that are judged, of each program."""


@cache
def find_cases() -> list[Case]:
    return list_cases()


@cache
def find_holed() -> list[Case]:
    """Small cases with holes or containers, those of several rings first."""
    small = [c for c in find_cases() if c.holes or c.inner_regions is not None][:120]
    return sorted(small, key=lambda case: -len(case.holes) - len(case.inner_regions or ()))


@pytest.mark.parametrize(
    "name", mostly_long(MISTAKES, [n for n in [*MISTAKES][2::3] if "256" not in n])
)
def test_a_mistake_is_detected_and_diagnosed(name: str) -> None:
    chosen = find_cases() if MISTAKES[name].part == "trajectory" else find_holed()
    judged = [*islice(judge_wrong_answers(name, chosen), ENOUGH)]
    assert judged
    for one in judged:
        assert one.is_right(MISTAKES[name]), (one.case.id, one.found.verdict, one.list_sayings())


@pytest.mark.long
@pytest.mark.parametrize(
    ("numbers", "to", "verdict"),
    [
        ("rational", lambda c: c, "exact"),
        ("binary64", float, "within"),
        ("integer", round, "within"),
    ],
)
def test_correct_programs_pass(numbers: str, to: Callable[[Any], Any], verdict: str) -> None:
    """The correct program, and the best possible answers in doubles and integers."""
    few = find_cases()[::12]

    def answer(directrix: Any, generatrix: Any, reference: Any) -> dict[str, Any]:
        s = sweep(generatrix, directrix, reference=reference)
        loops = {name: getattr(s, name).vertices for name in LOOPS}
        rounded = {name: [(to(x), to(y)) for x, y in loop] for name, loop in loops.items()}
        return {**rounded, "exact_fits": [[(to(x), to(y)) for x, y in f] for f in s.exact_fits]}

    run = conform(answer, few, name=numbers, loops=LOOPS, numbers=numbers, accepted=WITHIN)
    assert run.passed
    assert run.summary.judged > len(few) // 2
    allowed = {Verdict.EXACT, Verdict.EQUIVALENT, Verdict(verdict), Verdict.UNSUPPORTED}
    assert set(run.summary.verdicts()) <= allowed


def test_there_are_enough_faulty_programs() -> None:
    assert len(MISTAKES) >= 160
