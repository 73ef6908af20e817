"""Every fault that is put into the kernel turns the rows red that depend on it."""

import pytest
from mutations import MUTATIONS, Mutation, mutated, red_rows

from exactsweep.paper.claim import Effort
from exactsweep.procedures import cc


def test_ten_procedures_are_broken() -> None:
    assert len({mutation.procedure for mutation in MUTATIONS}) >= 10


COUNTED = [mutation for mutation in MUTATIONS if not mutation.timed]


@pytest.mark.parametrize("mutation", COUNTED, ids=lambda m: m.fault)
def test_a_fault_turns_its_rows_red(mutation: Mutation) -> None:
    names = mutation.rows[:2]
    assert red_rows(mutation, Effort(quick=True), names) == list(names)


@pytest.mark.parametrize("mutation", COUNTED[-3:], ids=lambda m: m.fault)
def test_a_fault_leaves_other_rows_alone(mutation: Mutation) -> None:
    assert red_rows(mutation, Effort(quick=True), ("Lemma 3.1", "Trajectory_CM")) == []


def test_the_kernel_is_whole_again_afterwards() -> None:
    right = cc.trajectory_cc
    with mutated(MUTATIONS[0]):
        assert cc.trajectory_cc is not right
    assert cc.trajectory_cc is right
