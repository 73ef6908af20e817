"""Implementations with one known fault each get the right verdict."""

import subprocess
import sys
from collections.abc import Iterable, Iterator

import pytest
from judged import CORRECT, FAULTY, SLOT, SQUARE
from shipped_cases import shipped_cases
from tiers import few_or_all

from exactsweep.cli.pair import DIRECTRIX, GENERATRIX
from exactsweep.conform import Verdict
from exactsweep.conform.run.outcome import Outcome, judge_case
from exactsweep.conform.run.process import ProcessPeer, Terms
from exactsweep.corpus import Case

CASES = {
    # An undercut, non-integer crossings, and a reference point off the origin.
    "notch": Case.of("notch", "", DIRECTRIX, GENERATRIX, ("1/2", 1)),
    "slot": Case.of("slot", "", SLOT, SQUARE),
}

EXPECTED = {
    "sign-of-g": "wrong",
    "vertex-outward": "conservative",
    "vertex-inward": "unsound",
    "hull": "conservative",
    "undercut-open": "unsound",
    "to-floats": "within",
    "reversed": "equivalent",
    "another-start": "exact",
    "nan": "malformed",
    "wrong-id": "malformed",
    "no-id": "malformed",
    "error": "crash",
    "unsupported": "unsupported",
    "slow": "timeout",
    "silent": "timeout",
    "crash": "crash",
    "segfault": "crash",
    "half-an-answer": "crash",
    "garbage": "malformed",
    "debug-print": "malformed",
    "binary": "malformed",
    "list": "malformed",
    "huge": "malformed",
}
AT_THE_SLOT = {"fit-dropped": "equivalent except for exact fits"}
OF_MORE_THAN_ONE_CASE = {"twice"}
ALL = [(fault, "notch", EXPECTED[fault]) for fault in EXPECTED] + [
    (fault, "slot", AT_THE_SLOT[fault]) for fault in AT_THE_SLOT
]


@pytest.fixture
def peer(request: pytest.FixtureRequest) -> Iterator[ProcessPeer]:
    peer = ProcessPeer(
        Terms([*FAULTY, request.param], seconds=0.3 if request.param in SLOW else 600)
    )
    yield peer
    peer.kill()


SLOW = {"slow", "silent"}


@pytest.mark.parametrize(("peer", "name", "verdict"), ALL, indirect=["peer"])
def test_a_fault_gets_its_verdict(peer: ProcessPeer, name: str, verdict: str) -> None:
    outcome = judge_case(peer, CASES[name])
    assert outcome.verdict == verdict, outcome.reason
    assert bool(outcome.reason) == (verdict not in ("exact", "equivalent"))


def test_all_faults_are_tried() -> None:
    done = subprocess.run([*FAULTY, "--list"], capture_output=True, text=True, check=True)
    assert set(done.stdout.split()) == {fault for fault, _, _ in ALL} | OF_MORE_THAN_ONE_CASE


@pytest.mark.parametrize("peer", ["twice"], indirect=True)
def test_a_second_answer_spoils_only_the_next_case(peer: ProcessPeer) -> None:
    first, second, third = (judge_case(peer, CASES[name]) for name in ("notch", "slot", "notch"))
    assert [first.verdict, second.verdict, third.verdict] == ["exact", "malformed", "exact"]
    assert "answers 'notch', which was not sent" in second.reason


@pytest.mark.parametrize("peer", ["crash"], indirect=True)
def test_the_end_of_standard_error_is_kept(peer: ProcessPeer) -> None:
    outcome = judge_case(peer, CASES["notch"])
    assert (outcome.reason, outcome.stderr) == (
        "exited with code 3; it says: about to fail",
        "about to fail\n",
    )


@pytest.mark.parametrize("peer", ["unsupported"], indirect=True)
def test_an_unsupported_answer_is_quoted(peer: ProcessPeer) -> None:
    assert judge_case(peer, CASES["notch"]).reason == "says: too hard"


def outcomes_of(command: list[str], chosen: Iterable[Case]) -> list[Outcome]:
    peer = ProcessPeer(Terms(command))
    try:
        outcomes = [judge_case(peer, case) for case in chosen]
        assert peer.close() is None
    finally:
        peer.kill()
    return outcomes


@few_or_all
def test_the_correct_program_is_exact(step: int) -> None:
    """It uses the old protocol, so pairs without a shared direction are skipped."""
    chosen = [*CASES.values(), *shipped_cases()[::step]]
    outcomes = outcomes_of(CORRECT, chosen)
    for case, outcome in zip(chosen, outcomes, strict=True):
        expected = Verdict.UNSUPPORTED if case.kind == "SS" else Verdict.EXACT
        assert outcome.verdict is expected, outcome
        if case.kind == "SS":
            assert outcome.reason.startswith("skipped: the program accepts only monotone pairs")


@few_or_all
def test_the_correct_program_of_any_shape_is_exact(step: int) -> None:
    chosen = [*CASES.values(), *shipped_cases()[::step]]
    outcomes = outcomes_of([sys.executable, "-m", "exactsweep.conform.examples.shapes"], chosen)
    assert {outcome.verdict for outcome in outcomes} == {Verdict.EXACT}
