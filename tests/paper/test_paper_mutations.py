"""Every fault injected into the kernel fails the rows that depend on it."""

import pytest
from mutations import MUTATIONS, SABOTAGES, Mutation, mutated, red_rows

from exactsweep.paper.claim import ClaimVerdict, Effort
from exactsweep.paper.ledger import CLAIMS
from exactsweep.procedures import cc

COUNTED = [mutation for mutation in MUTATIONS if not mutation.timed]
ELSEWHERE = [m for m in COUNTED if m.fault.split(":")[0] in ("contacts", "undercuts", "exact fits")]


def test_faults_break_many_procedures() -> None:
    assert {mutation.wrong.__module__ for mutation in MUTATIONS} == {s.__name__ for s in SABOTAGES}
    assert len({mutation.procedure for mutation in MUTATIONS}) >= 25
    assert len({mutation.fault for mutation in MUTATIONS}) == len(MUTATIONS) >= 50


@pytest.mark.parametrize(
    "mutation",
    [m if k % 25 == 3 else pytest.param(m, marks=pytest.mark.long) for k, m in enumerate(COUNTED)],
    ids=lambda m: m.fault,
)
def test_a_fault_fails_its_rows(mutation: Mutation) -> None:
    # `python -m tests.mutations` tries all rows of all faults.
    names = mutation.rows[:1]
    assert red_rows(mutation, Effort(quick=True), names) == list(names)


def test_each_row_fails_for_some_fault() -> None:
    # The evidence for a misprint depends on no procedure.
    checked = {claim.name for claim in CLAIMS if claim.verdict is not ClaimVerdict.MISPRINT}
    assert checked <= {name for mutation in MUTATIONS for name in mutation.rows}


@pytest.mark.parametrize("mutation", ELSEWHERE, ids=lambda m: m.fault)
def test_a_fault_does_not_affect_other_rows(mutation: Mutation) -> None:
    assert red_rows(mutation, Effort(quick=True), ("Lemma 3.1", "Trajectory_CM")) == []


def test_the_kernel_is_restored_afterwards() -> None:
    right = cc.trajectory_cc
    with mutated(MUTATIONS[0]):
        assert cc.trajectory_cc is not right
    assert cc.trajectory_cc is right
