"""`exactsweep conform`, run in a separate process."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest
from command import run
from judged import CONVEX, CORRECT, FAULTY, TWO, write_cases


@pytest.fixture
def two(tmp_path: Path) -> str:
    return write_cases(tmp_path / "two.jsonl", TWO)


@pytest.mark.parametrize(
    ("fault", "accepted", "code"),
    [
        ("fit-dropped", None, 0),
        ("vertex-outward", None, 1),
        pytest.param("fit-dropped", "equivalent", 1, marks=pytest.mark.long),
        pytest.param("reversed", "equivalent", 0, marks=pytest.mark.long),
        pytest.param("reversed", "exact", 1, marks=pytest.mark.long),
        pytest.param("another-start", "exact", 0, marks=pytest.mark.long),
        pytest.param("to-floats", None, 0, marks=pytest.mark.long),
        pytest.param("vertex-outward", "conservative", 0, marks=pytest.mark.long),
    ],
)
def test_conform_and_compare_accept_the_same_answers(
    two: str, tmp_path: Path, fault: str, accepted: str | None, code: int
) -> None:
    options = () if accepted is None else ("--accept", accepted)
    cases = ("--cases", two, "--filter", "id=mine-slot")
    assert run("conform", *options, *cases, "--", *FAULTY, fault).exit_code == code
    case, answer = tmp_path / "case.json", tmp_path / "answer.json"
    case.write_text(Path(two).read_text().splitlines()[0])
    said = subprocess.run([*FAULTY, fault], input=case.read_bytes(), stdout=-1, check=True).stdout
    answer.write_bytes(said.splitlines()[1])
    assert run("compare", *options, str(case), str(answer)).exit_code == code


@pytest.mark.long
def test_filters_choose_cases_of_the_corpus_and_of_files(two: str) -> None:
    done = run("conform", "--filter", "id=worked-", "--filter", "class=CC", "--", *CONVEX)
    assert re.match(r" +cases  exact\nall +\d+ +\d+\nCC ", done.stdout)
    for text, name in (
        ("class=CC", "mine-square"),
        ("size=8", "mine-square"),
        ("id=mine-sl", "mine-slot"),
    ):
        done = run("conform", "--cases", two, "--filter", text, "--json", "-", "--", *CORRECT)
        assert [outcome["id"] for outcome in json.loads(done.stdout)["outcomes"]] == [name]


def test_local_files_do_not_shadow_modules(
    two: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "json.py").write_text("raise SystemExit('not that json')")
    monkeypatch.chdir(tmp_path)
    assert run("conform", "--cases", two, "--", *CORRECT).exit_code == 0


def test_a_failure_at_the_end_is_a_failure(two: str) -> None:
    program = "import sys; exec(open(sys.argv[1]).read()); sys.exit('out of paper')"
    done = run("conform", "--cases", two, "--", sys.executable, "-c", program, CONVEX[1])
    assert done.exit_code == 1
    assert "after bye, exited with code 1; it says: out of paper" in done.stdout


def test_cases_come_from_standard_input(two: str) -> None:
    done = run("conform", "--cases", "-", "--", *CORRECT, stdin=Path(two).read_text())
    assert "\ncorrect: passed, 2 of 2 cases judged, no failures" in done.stdout
