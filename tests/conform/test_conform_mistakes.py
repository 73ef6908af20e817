"""No faulty program is acquitted, and each hears what its mistake is."""

from collections.abc import Callable
from functools import cache
from itertools import islice
from typing import Any

import pytest
from convictions import is_right, judge_wrong_answers, list_cases, list_sayings
from mistakes import MISTAKES
from spoiling import LOOPS
from tiers import mostly_long

from exactsweep import sweep
from exactsweep.conform import Verdict, conform
from exactsweep.corpus import Case

WITHIN = Verdict.WITHIN
ENOUGH = 3
"""Wrong answers that are judged, of each program."""


@cache
def find_cases() -> list[Case]:
    return list_cases()


@pytest.mark.parametrize("name", mostly_long(MISTAKES, [*MISTAKES][::8]))
def test_a_mistake_is_convicted_and_named(name: str) -> None:
    mistake = MISTAKES[name]
    judged = [*islice(judge_wrong_answers(mistake, find_cases()), ENOUGH)]
    assert judged
    for case, outcome in judged:
        assert is_right(mistake, outcome), (case.id, outcome.verdict, list_sayings(outcome))


@pytest.mark.long
@pytest.mark.parametrize(
    ("numbers", "to", "verdict"),
    [
        ("rational", lambda c: c, "exact"),
        ("binary64", float, "within"),
        ("integer", round, "within"),
    ],
)
def test_who_makes_none_passes(numbers: str, to: Callable[[Any], Any], verdict: str) -> None:
    """The correct program, and the best that doubles and integers can do."""
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


def test_at_least_sixty_are_tried() -> None:
    assert len(MISTAKES) >= 60
    assert len({id(mistake.change) for mistake in MISTAKES.values()}) == len(MISTAKES)
