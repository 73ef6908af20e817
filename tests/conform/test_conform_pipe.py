"""`exactsweep judge`, at the end of a pipe."""

from dataclasses import replace
from pathlib import Path

import pytest
from command import refusal, run, shell
from judged import CONVEX, CORRECT, SLOT, TWO, write_cases

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
        "convex.py: passed, 5 of 5 cases judged, 0 worse than equivalent except for exact fits"
        in done.stdout
    )


def test_own_cases_are_judged_in_a_pipe(two: str) -> None:
    done = shell(f"cat {two} | {' '.join(CORRECT)} | exactsweep judge --cases {two}")
    assert "correct: passed, 2 of 2 cases judged" in done.stdout


HELLO = '{"hello": "pipe", "loops": ["trajectory"], "numbers": "integer", "reference": "origin"}\n'
ANSWER = '{"id": "mine-square", "trajectory": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}\n'


def judge(two: str, text: str) -> tuple[int, list[str]]:
    done = run("judge", "--cases", two, stdin=HELLO + text)
    return done.exit_code, done.stdout.partition("\n\n")[2].splitlines()


def test_in_a_pipe_missing_answers_are_crashes(two: str) -> None:
    code, lines = judge(two, ANSWER)
    assert (code, lines[0]) == (1, "crash  mine-slot  no answer")


@pytest.mark.parametrize(
    ("line", "complaint"),
    [
        (ANSWER, "line 3: answers 'mine-square' a second time"),
        ('{"id": "other"}\n', "line 3: no case 'other'"),
        ('{"id": 7}\n', 'line 3: "id" is 7, not the id of a case'),
        ("done.\n", "line 3: 'done."),
        ("7" * 5_000_000 + "\n", "line 3: '7777"),
    ],
)
def test_in_a_pipe_what_is_no_answer_is_told(two: str, line: str, complaint: str) -> None:
    code, lines = judge(two, ANSWER + line)
    assert code == 1
    assert any(said.startswith(complaint) for said in lines)


def test_in_a_pipe_a_case_that_contradicts_itself_spoils_no_other(two: str) -> None:
    square, other = TWO[1], Case.of("other", "", SLOT, SLOT)
    wrong = replace(square, id="wrong", trajectory=other.trajectory)
    write_cases(Path(two), (wrong, square))
    code, lines = judge(two, ANSWER.replace("mine-square", "wrong") + ANSWER)
    assert code == 1
    assert lines[0].startswith("line 2: ")
    assert lines[-1].startswith("pipe: failed, 1 of 1 case judged, 0 worse")


@pytest.mark.parametrize("text", ["", "x\n", ANSWER])
def test_in_a_pipe_the_hello_comes_first(text: str) -> None:
    assert "no hello" in refusal(run("judge", stdin=text))


def test_answers_and_cases_do_not_share_standard_input() -> None:
    assert run("judge", "--cases", "-", stdin=HELLO).exit_code == 2
