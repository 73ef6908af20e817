"""`exactsweep judge`, at the end of a pipe."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from command import run, shell
from judged import CONVEX, SLOT, TWO, write_cases

from exactsweep.conform import Verdict
from exactsweep.conform.run.outcome import Outcome
from exactsweep.corpus import Case


@pytest.fixture
def two(tmp_path: Path) -> str:
    return write_cases(tmp_path / "two.jsonl", TWO)


def test_generated_cases_are_judged_in_a_pipe() -> None:
    done = shell(
        "exactsweep corpus generate --family convex --seed 7 --count 5"
        f" | {' '.join(CONVEX)} | exactsweep judge"
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert (
        "convex.py: passed, 5 of 5 cases judged, no failures (missing exact fits ignored)"
        in done.stdout
    )


def test_outcomes_before_an_interrupt_are_reported(
    two: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupt(*_: object) -> Iterator[Outcome]:
        yield Outcome("mine-square", "CC", (), Verdict.EXACT)
        raise KeyboardInterrupt

    monkeypatch.setattr("exactsweep.conform.run.stream.Stream.outcomes", interrupt)
    code, lines = judge(two, "")
    assert code == 1
    assert lines[0] == "interrupted"
    assert lines[-1].startswith("pipe: failed, 1 of 1 case judged")


HELLO = '{"hello": "pipe", "loops": ["trajectory"], "numbers": "integer", "reference": "origin"}\n'
ANSWER = '{"id": "mine-square", "trajectory": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}\n'


def judge(two: str, text: str) -> tuple[int, list[str]]:
    done = run("judge", "--cases", two, stdin=HELLO + text)
    return done.exit_code, done.stdout.partition("\n\n")[2].splitlines()


def test_a_contradictory_case_in_a_pipe_spoils_no_other(two: str) -> None:
    square, other = TWO[1], Case.of("other", "", SLOT, SLOT)
    wrong = replace(square, id="wrong", trajectory=other.trajectory)
    write_cases(Path(two), (wrong, square))
    code, lines = judge(two, ANSWER.replace("mine-square", "wrong") + ANSWER)
    assert code == 1
    assert lines[0].startswith("line 2: ")
    assert lines[-1].startswith("pipe: failed, 1 of 1 case judged, no failures")
