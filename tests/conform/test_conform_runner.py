"""Runs: parallel, interrupted, resumed, and in this process."""

import json
import os
import signal
import subprocess
from collections import Counter
from contextlib import closing
from dataclasses import replace
from itertools import count
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from command import EXACTSWEEP, eventually, processes, run
from judged import CORRECT, HOSTILE, SQUARE, WATCHED, write_cases

from exactsweep import sweep
from exactsweep.conform import Verdict
from exactsweep.conform.run.outcome import Outcome, outcome_from_json
from exactsweep.conform.run.peer import CallablePeer
from exactsweep.conform.run.pool import JudgeError, Judges
from exactsweep.conform.run.process import Terms
from exactsweep.conform.run.protocol import (
    Hello,
    ProtocolError,
    UnsupportedError,
    adapt,
    read_hello,
)
from exactsweep.conform.run.run import SHOWN, Run, Tally
from exactsweep.conform.run.runner import conform, judge_cases
from exactsweep.corpus import Case, cases
from exactsweep.corpus.selection import SelectionError

LOOPS = ("trajectory", "inner", "outer")
THIRDS = Case.of("thirds", "", [("1/3", 0), (1, "1/3"), (0, 1)], SQUARE, ("1/2", 0))
FEW = [Case.of(f"case-{k}", "", [(0, 0), (k + 1, 0), (0, 1)], SQUARE) for k in range(20)]


def exact(directrix: Any, generatrix: Any, reference: Any) -> dict[str, Any]:
    s = sweep(generatrix, directrix, reference=reference)
    return {**{name: getattr(s, name).vertices for name in LOOPS}, "exact_fits": s.exact_fits}


# In this process.


@pytest.mark.parametrize("numbers", ["rational", "integer", "int64", "int32", "binary64"])
@pytest.mark.parametrize("reference", ["given", "origin", "first"])
def test_exact_arithmetic_is_exact_for_all_hellos(numbers: str, reference: str) -> None:
    chosen = [*cases(prefix="figures"), *cases(prefix="worked"), THIRDS]
    run = conform(exact, chosen, name="exact", loops=LOOPS, numbers=numbers, reference=reference)
    assert run.passed
    assert set(run.summary.verdicts()) <= {Verdict.EXACT, Verdict.UNSUPPORTED}
    assert run.summary.total(Verdict.EXACT) > 0
    if numbers in ("rational", "integer"):
        assert run.summary.total(Verdict.UNSUPPORTED) == 0


def test_a_case_keeps_its_shape_for_all_hellos() -> None:
    whole = adapt(THIRDS, Hello("mine", numbers="int32", reference="first"))
    assert all(c.denominator == 1 for point in whole.directrix_ring for c in point)
    assert whole.reference == whole.generatrix_ring[0]
    again = Case.of("", "", whole.directrix_ring, whole.generatrix_ring, whole.reference)
    for name in ("trajectory", "inner", "outer", "exact_fits", "area", "kind"):
        assert getattr(whole, name) == getattr(again, name)


def test_unrepresentable_cases_are_skipped() -> None:
    large = Case.of("large", "", [(0, 0), (2**70 + 1, 0), (0, 1)], SQUARE)
    for numbers in ("int32", "int64", "binary64"):
        with pytest.raises(UnsupportedError, match=f"{numbers} cannot represent the case"):
            adapt(large, Hello("mine", ("inner",), numbers))
    assert adapt(large, Hello("mine", numbers="integer")) is large


@pytest.mark.parametrize(
    ("function", "verdict", "reason"),
    [
        (lambda d, g, r: 1 // 0, "crash", "ZeroDivisionError: integer division or modulo by zero"),
        (lambda d, g, r: None, "malformed", "$.trajectory is None, not a list of vertices"),
        (lambda d, g, r: {}, "malformed", "$.trajectory is missing"),
        (lambda d, g, r: {"trajectory": object()}, "malformed", "$.trajectory is "),
        (lambda d, g, r: {"error": "why"}, "crash", "says: why"),
        (lambda d, g, r: {"unsupported": ["why"]}, "unsupported", "says: a list"),
    ],
)
def test_a_function_that_fails_gets_a_verdict(function: Any, verdict: str, reason: str) -> None:
    (outcome,) = conform(function, [THIRDS], name="mine").outcomes
    assert outcome.verdict == verdict
    assert outcome.reason.startswith(reason)


def test_not_implemented_is_unsupported() -> None:
    def function(directrix: Any, generatrix: Any, reference: Any) -> dict[str, Any]:
        raise NotImplementedError("only convex")

    run = conform(function, FEW, name="mine")
    assert run.summary.verdicts() == [Verdict.UNSUPPORTED]
    assert not run.passed  # nothing was judged


@pytest.mark.parametrize("seconds", [0.5, 1])
def test_each_answer_is_timed_and_a_late_one_is_a_timeout(
    seconds: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each function takes a second."""
    monkeypatch.setattr(
        "exactsweep.conform.run.peer.time", SimpleNamespace(monotonic=count().__next__)
    )
    functions: list[Any] = [exact, lambda *_: 3, lambda *_: {}, lambda *_: 1 / 0]
    found = [CallablePeer(one, Hello("mine"), seconds).ask(THIRDS) for one in functions]
    late = ["timeout"] * 3 if seconds < 1 else [None, None, None]
    assert [(one.verdict, one.seconds) for one in found] == [(v, 1) for v in (*late, "crash")]


def test_duplicate_ids_are_rejected() -> None:
    with pytest.raises(SelectionError, match="duplicate case id 'case-0'"):
        conform(exact, [FEW[0], FEW[0]], name="mine")


@pytest.mark.parametrize(
    "changes", [{"loops": "inner"}, {"loops": []}, {"numbers": "real"}, {"reference": 1}]
)
def test_invalid_descriptions_of_a_function_are_rejected(changes: dict[str, Any]) -> None:
    with pytest.raises(ProtocolError):
        conform(exact, [], name="mine", **changes)


# The hello.


def test_a_hello_round_trips() -> None:
    hello = Hello("mine", ("trajectory", "outer"), "int64", "first")
    assert read_hello(json.dumps(hello.to_json())) == hello


# Parallel runs.


@pytest.mark.parametrize("workers", [1, 3])
@pytest.mark.long
def test_all_workers_agree(workers: int) -> None:
    with closing(Judges(Terms(CORRECT), workers)) as judges:
        outcomes = list(judges.judge(FEW))
        judges.finish()
    assert sorted(outcome.id for outcome in outcomes) == sorted(case.id for case in FEW)
    assert {outcome.verdict for outcome in outcomes} == {Verdict.EXACT}
    assert judges.complaints == []


def test_cases_are_generated_on_demand() -> None:
    taken = []

    def endless() -> Any:
        for k in range(10**9):
            taken.append(k)
            yield FEW[k % len(FEW)]

    with closing(Judges(Terms(CORRECT))) as judges:
        outcomes = judges.judge(endless())
        for _ in range(5):
            next(outcomes)
    assert len(taken) < 10


def test_a_contradictory_case_ends_the_run() -> None:
    wrong = replace(FEW[0], trajectory=FEW[1].trajectory, id="wrong")
    run = Run(Hello("mine"))
    with closing(Judges(Terms(CORRECT))) as judges:
        judge_cases(run, judges, [FEW[2], wrong, *FEW[3:]])
    assert run.interrupted
    assert run.complaints[0].startswith("case 'wrong': ")
    assert [outcome.id for outcome in run.outcomes] == [FEW[2].id]


def test_a_slow_comparison_is_stopped(monkeypatch: pytest.MonkeyPatch) -> None:
    from exactsweep.conform.run import outcome as judging

    def endless(*arguments: object, **options: object) -> None:
        while True:
            pass

    monkeypatch.setattr(judging, "COMPARE_SECONDS", 0.05)
    monkeypatch.setattr("exactsweep.conform.run.outcome.compare", endless)
    peer: Any = CallablePeer(exact, Hello("mine"))
    outcome = judging.judge_case(peer, THIRDS)
    assert outcome.verdict == "undecided"
    assert "comparing the answer takes more than 0.05 s" in outcome.reason


def test_a_worker_that_is_killed_ends_the_run() -> None:
    with closing(Judges(Terms(CORRECT))) as judges:
        outcomes = judges.judge(FEW)
        next(outcomes)
        os.kill(next(iter(judges._pool._executor._processes)), signal.SIGKILL)
        with pytest.raises(JudgeError, match=r"^case '.*': a judging process ended unexpectedly$"):
            list(outcomes)
        with pytest.raises(JudgeError):
            judges.finish()


# Interrupted and resumed runs.


@pytest.mark.usefixtures("heed_interrupts")
@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
@pytest.mark.long
def test_an_interrupted_run_resumes(tmp_path: Path, how: signal.Signals) -> None:
    journal, log, gate = tmp_path / "journal", tmp_path / "log", tmp_path / "gate"
    command = [
        *("conform", "--cases", write_cases(tmp_path / "cases", FEW), "--journal", str(journal)),
        *("--timeout", "600", "--", *WATCHED, str(log), str(gate)),
    ]
    with subprocess.Popen([EXACTSWEEP, *command], stdout=-1, stderr=-1, text=True) as process:
        eventually(lambda: journal.exists() and journal.read_bytes().count(b"\n") == 10)
        process.send_signal(how)
        said, complaint = process.communicate()
    assert complaint == ""
    if how != signal.SIGKILL:
        assert process.returncode == 1
        assert "interrupted\n" in said
    done = [json.loads(line)["id"] for line in journal.read_text().splitlines()[1:]]
    assert len(done) == 9
    gate.touch()
    with journal.open("ab") as file:
        file.write(b'{"id": "case-19", "verd')
    again = run("conform", "--resume", *command[1:])
    assert again.exit_code == 0
    assert (
        "watched: passed, 20 of 20 cases judged, no failures (missing exact fits ignored)"
        in again.stdout
    )
    kept = [json.loads(line)["id"] for line in journal.read_text().splitlines()[1:]]
    assert sorted(kept) == sorted(case.id for case in FEW)
    times = Counter(log.read_text().split())
    assert all(times[id] == 1 for id in done)


def test_a_killed_run_kills_its_processes(tmp_path: Path) -> None:
    path = write_cases(tmp_path / "cases", FEW)
    mark = f"--{os.urandom(8).hex()}"
    hostile = [*HOSTILE, "ignores-termination", mark]
    command = [EXACTSWEEP, "conform", "--cases", path, "--timeout", "600", "--", *hostile]

    with subprocess.Popen(command, stdout=-1, stderr=-1) as process:
        # The command and its descendants have the mark.
        eventually(lambda: process.poll() is not None or len(processes(mark)) > 1)
        process.kill()
    eventually(lambda: not processes(mark))


# The records of a run.


def test_an_outcome_round_trips() -> None:
    run = conform(lambda d, g, r: {"trajectory": [(0.5, 0), (1, 0), (0, 1)]}, FEW[:1], name="mine")
    (outcome,) = run.show()
    text = json.dumps(outcome.to_json())
    assert json.dumps(outcome_from_json(json.loads(text)).to_json()) == text
    assert outcome.result is not None
    assert outcome.result["trajectory"][0] == [0.5, 0]


def test_a_leading_cause_keeps_the_order_of_the_others() -> None:
    part = {"name": "no_fit", "diagnosis": ["a", "b", "c"], "reason": "so: a"}
    other = {"name": "inner", "diagnosis": ["d"], "reason": "so: d"}
    outcome = Outcome("x", "CC", (), Verdict.WRONG, "so: a", "wrong: a", ("a", "b", "c"))
    led = replace(outcome, parts=(part, other)).lead_with("b")
    assert led.diagnosis == ("b", "a", "c")
    assert (led.reason, led.fault) == ("so: b", "wrong: b")
    first = {"name": "no_fit", "diagnosis": ["b", "a", "c"], "reason": "so: b"}
    assert led.parts == (first, other)
    assert outcome.lead_with("a") is outcome.lead_with("d") is outcome


def test_a_cause_explains_all_of_several_differing_answers() -> None:
    tally = Tally()
    for words, cause in (("a", None), ("a", "a"), ("b", None)):
        part: dict[str, Any] = {"name": "no_fit", "verdict": "wrong", "diagnosis": [words]}
        part |= dict.fromkeys(("granted", "distance_squared", "area"))
        tally.add(Outcome("x", "CC", (), Verdict.WRONG, parts=(part,)))
        assert tally.find_cause() == cause


def test_faults_are_sorted_by_severity_and_count() -> None:
    run = Run(Hello("mine"))
    for k, fault in enumerate("abbbcc"):
        verdict = Verdict.CRASH if fault == "a" else Verdict.WRONG
        run.add(Outcome(f"case-{k}", "CC", (), verdict, fault, fault))
    assert [(fault.name, fault.count) for fault in run.list_faults()] == [
        ("a", 1),
        ("b", 3),
        ("c", 2),
    ]


def test_the_smallest_failures_are_kept_in_full() -> None:
    run = Run(Hello("mine"))
    for size in range(3 * SHOWN, 0, -1):
        case = {"directrix": [0] * size, "generatrix": []}
        run.add(Outcome(f"case-{size}", "CC", (), Verdict.WRONG, "why", "wrong: why", case=case))
    assert [outcome.id for outcome in run.show()] == [f"case-{k + 1}" for k in range(SHOWN)]
    assert not any(outcome.case for outcome in run.outcomes)
    assert sum("case" in outcome for outcome in run.to_json()["outcomes"]) == SHOWN
    assert run.summary.total(Verdict.WRONG) == len(run.outcomes) == 3 * SHOWN
