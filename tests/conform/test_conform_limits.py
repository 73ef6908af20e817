"""Distinct faults, and the limits of a run: shares, time and memory."""

import json
import sys
from fractions import Fraction
from pathlib import Path

import pytest
from command import refusal, run
from judged import CORRECT, HOSTILE, SQUARE, TWO, write_cases

from exactsweep import processes
from exactsweep.conform import Outcome, Run, Verdict
from exactsweep.conform.run.fault import name_fault
from exactsweep.conform.run.outcome import judge_case
from exactsweep.conform.run.process import ProcessPeer, Terms
from exactsweep.conform.run.protocol import Hello
from exactsweep.conform.run.run import MAX_FAULTS, SHOWN
from exactsweep.corpus import Case

MIB = 2**20
CASES = [Case.of(f"case-{k}", "", [(0, 0), (k + 1, 0), (0, 1)], SQUARE) for k in range(12)]
# Six crashes, in turn.
CRASHING = """
import json, os, signal, sys
hello = {"hello": "crashing", "loops": ["trajectory"], "numbers": "rational", "reference": "given"}
print(json.dumps(hello), flush=True)

def one(case):
    raise KeyError(case["id"])

def another(case):
    return [][len(case["id"])]

for line in sys.stdin:
    case = json.loads(line)
    if "bye" in case:
        break
    way = int(case["id"].split("-")[1]) % 6
    if way == 0:
        one(case)
    elif way == 1:
        another(case)
    elif way == 2:
        print("no memory for 12345 cells", file=sys.stderr)
        sys.exit(3)
    elif way == 3:
        print("no memory for 99 cells", file=sys.stderr)
        sys.exit(4)
    elif way == 4:
        os.kill(os.getpid(), signal.SIGABRT)
    print(json.dumps({"id": case["id"], "error": f"row {case['id']} is empty"}), flush=True)
"""
FAULTS = {
    "crash: exited with code 1; KeyError: #; crashing.py line 7",
    "crash: exited with code 1; IndexError: list index out of range; crashing.py line 10",
    "crash: exited with code 3; no memory for # cells",
    "crash: exited with code 4; no memory for # cells",
    "crash: was killed by signal 6, SIGABRT",
    "crash: says: row # is empty",
}


@pytest.mark.long
def test_six_crashes_are_distinguished_and_shrunk(tmp_path: Path) -> None:
    program, data = tmp_path / "crashing.py", tmp_path / "run.json"
    program.write_text(CRASHING)
    options = ("--cases", write_cases(tmp_path / "cases", CASES), "--json", str(data))
    said = run("conform", *options, "--", sys.executable, str(program))
    report = json.loads(data.read_text())
    assert {fault["fault"]: fault["count"] for fault in report["faults"]} == dict.fromkeys(
        FAULTS, 2
    )
    assert {small["fault"] for small in report["shrunk"].values()} == FAULTS
    assert (
        "crash  case-2  exited with code 3; it says: no memory for 12345 cells  (and 1 more "
        in (said.stdout)
    )


def test_the_number_of_faults_is_bounded() -> None:
    report = Run(Hello("mine"))
    for k in range(3 * MAX_FAULTS):
        words = "".join(chr(ord("a") + int(digit)) for digit in str(k))
        fault = name_fault(Verdict.CRASH, f"says: {words}")
        report.add(Outcome(str(k), "CC", (), Verdict.CRASH, words, fault))
    *_, others = sorted(report.list_faults(), key=lambda fault: fault.count)
    assert (others.name, others.count, len(others.kept)) == (
        "crash: others",
        2 * MAX_FAULTS,
        SHOWN,
    )


def test_undecided_cases_do_not_count() -> None:
    report = Run(Hello("mine"))
    report.add(Outcome("a", "CC", (), Verdict.EXACT))
    assert report.passed
    report.add(Outcome("b", "CC", (), Verdict.UNDECIDED, "takes more than 60 s", "undecided: "))
    assert report.passed
    assert report.summary.failures(Verdict.EXACT) == 0
    report.least_judged = Fraction(3, 4)
    assert report.find_objections() == ["only 1 of 2 cases judged, fewer than required"]


# Memory.

HOLDER = """
import json, sys
hello = {"hello": "holder", "loops": ["trajectory"], "numbers": "rational", "reference": "given"}
print(json.dumps(hello), flush=True)
for line in sys.stdin:
    case = json.loads(line)
    if "bye" in case:
        break
    what, _, size = case["id"].partition("-")
    held = b"x" * (int(size) * 2**20)
    if what == "keep":
        sys.stdin.read()
    held = str(len(held))
    print(json.dumps({"id": case["id"], "unsupported": held}), flush=True)
"""


def hold(tmp_path: Path, most: int | None) -> ProcessPeer:
    program = tmp_path / "holder.py"
    program.write_text(HOLDER)
    return ProcessPeer(Terms([sys.executable, str(program)], seconds=600, most=most))


needs_proc = pytest.mark.skipif(
    not Path("/proc/self/clear_refs").exists(), reason="the system does not tell the memory held"
)


@needs_proc
def test_memory_is_measured_per_case(tmp_path: Path) -> None:
    peer = hold(tmp_path, None)
    few, many, few_again = (
        judge_case(peer, Case.of(f"hold-{size}", "", SQUARE, SQUARE)).memory or 0
        for size in (0, 200, 0)
    )
    peer.kill()
    assert 0 < few < few_again + 20 * MIB < few + 40 * MIB
    assert many > few + 190 * MIB


@needs_proc
def test_too_much_memory_is_a_verdict(tmp_path: Path) -> None:
    peer = hold(tmp_path, 150 * MIB)
    verdicts = [
        judge_case(peer, Case.of(f"hold-{size}", "", SQUARE, SQUARE)) for size in (300, 1, 300)
    ]
    peer.kill()
    assert [outcome.verdict for outcome in verdicts] == ["memory", "unsupported", "memory"]
    assert verdicts[0].reason == "uses more than 150.0 MiB"


@needs_proc
def test_too_much_memory_ends_the_wait_for_an_answer(tmp_path: Path) -> None:
    judged = judge_case(hold(tmp_path, 150 * MIB), Case.of("keep-300", "", SQUARE, SQUARE))
    assert judged.reason == "uses more than 150.0 MiB"


@pytest.mark.long
@needs_proc
def test_memory_is_limited_and_reported(tmp_path: Path) -> None:
    data = tmp_path / "run.json"
    options = ("--cases", write_cases(tmp_path / "cases", TWO), "--json", str(data))
    assert run("conform", *options, "--memory", "2000", "--", *CORRECT).exit_code == 0
    report = json.loads(data.read_text())
    assert min(outcome["memory"] for outcome in report["outcomes"]) > MIB
    said = refusal(run("conform", *options, "--memory", "1", "--", *CORRECT))
    assert said == "no hello: uses more than 1.0 MiB"


# Messages about missing options.


def test_an_unflushed_hello_gets_a_hint() -> None:
    with pytest.raises(ValueError, match=r"no hello within 0\.2 s; does the program"):
        ProcessPeer(Terms([*HOSTILE, "no-hello", "--"]), to_start=0.2)


def test_shares_are_exact() -> None:
    report = Run(Hello("mine"), least_judged=Fraction(1, 3))
    for k, verdict in enumerate((Verdict.EXACT, Verdict.UNSUPPORTED, Verdict.UNSUPPORTED)):
        report.add(Outcome(str(k), "CC", (), verdict))
    assert report.passed


def test_process_trees_may_exceed_the_recursion_limit(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    class Children:
        """The child of each process, in files like those of /proc."""

        def __init__(self, name: str) -> None:
            self.pid = int(name.split("/")[2])

        def glob(self, pattern: str) -> list["Children"]:
            return [self]

        def read_text(self) -> str:
            return str(self.pid + 1) if self.pid < 5000 else ""

    monkeypatch.setattr("exactsweep.processes.Path", Children)
    assert processes._find_family(1) == list(range(1, 5001))
