"""The manual cases distinguish the judge from judges with one mistake each."""

import pytest
from known_layouts import FAULTY, VALID
from wrong_judges import WRONG, Answer, answers, right

from exactsweep.corpus import layout_cases
from exactsweep.layout import Layout

CASES: dict[str, tuple[Layout, Answer]] = {
    case.id: (case.layout, [(f["kind"], tuple(f["placements"])) for f in case.expected["faults"]])
    for case in layout_cases()
}
CASES |= {name: (layout, []) for name, layout in VALID.items()} | FAULTY


def test_the_judge_is_correct_in_all_cases() -> None:
    assert [
        name for name, (layout, known) in CASES.items() if sorted(right(layout)) != sorted(known)
    ] == []


@pytest.mark.parametrize("mistake", WRONG)
def test_every_mistake_fails_some_case(mistake: str) -> None:
    judge = WRONG[mistake]
    caught = [
        name for name, (layout, known) in CASES.items() if answers(judge, layout) != sorted(known)
    ]
    assert caught
    # The mistake must be plausible.
    assert len(caught) < len(CASES) / 2
