"""`exactsweep conform`, as its users run it."""

import json
import os
import pty
import re
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import pytest
from command import EXACTSWEEP, refusal, run
from judged import CONVEX, CORRECT, FAULTY, TWO, write_cases

from exactsweep.conform.run.cases import read_cases
from exactsweep.formats import FormatError


@pytest.fixture
def two(tmp_path: Path) -> str:
    return write_cases(tmp_path / "two.jsonl", TWO)


def test_a_table_and_a_last_line_sum_up(two: str) -> None:
    done = run("conform", "--accept", "equivalent", "--cases", two, "--", *FAULTY, "fit-dropped")
    assert done.exit_code == 1
    table, _, rest = done.stdout.partition("\n\n")
    rows = [re.split(r"\s{2,}", line.strip()) for line in table.splitlines()]
    assert rows[0] == ["cases", "exact", "equivalent except for exact fits"]
    assert rows[1:4] == [["all", "2", "1", "1"], ["CC", "1", "1"], ["CM", "1", "1"]]
    failure, ending = rest.splitlines()
    assert failure.startswith("equivalent except for exact fits  mine-slot  ")
    assert ending == "faulty: fit-dropped: failed, 2 of 2 cases judged, 1 worse than equivalent"


@pytest.mark.parametrize(
    ("fault", "accepted", "code"),
    [
        ("fit-dropped", None, 0),
        ("fit-dropped", "equivalent", 1),
        ("reversed", "equivalent", 0),
        ("reversed", "exact", 1),
        ("another-start", "exact", 0),
        ("to-floats", None, 0),
        ("vertex-outward", None, 1),
        ("vertex-outward", "conservative", 0),
    ],
)
def test_conform_and_compare_pass_the_same(
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


def test_a_mistake_made_throughout_is_said_first() -> None:
    done = run("conform", "--filter", "id=figures", "--", *FAULTY, "sign-of-g")
    first = done.stdout.partition("\n\n")[2].splitlines()[0]
    assert first.endswith(" answers that differ: exact for D + G, G not reflected")


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


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--filter", "flag=exact-fits"), "did you mean 'exact-fit'?"),
        (("--filter", "class=XX"), "no class 'XX'"),
        (("--filter", "id=none"), "no case is like that"),
        (("--cases", "/none"), "/none: No such file or directory"),
        (("--journal", "/none/journal"), "/none/journal: No such file or directory"),
    ],
)
def test_what_cannot_be_run_is_refused(options: tuple[str, ...], message: str) -> None:
    assert message in refusal(run("conform", *options, "--", *CONVEX))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{}\n", "line 1: $ has no 'expected'"),
        ("\n[]\n", "line 2: '[]"),
        ("x" * 60, "is no JSON line"),
        ("\xff", "line 1: 'utf-8' codec"),
    ],
)
def test_cases_that_are_none_are_refused(tmp_path: Path, text: str, message: str) -> None:
    path = tmp_path / "cases"
    path.write_bytes(text.encode("latin-1"))
    with pytest.raises(FormatError, match=re.escape(message)):
        list(read_cases(str(path)))


def test_two_cases_with_one_id_are_refused(two: str, tmp_path: Path) -> None:
    double = tmp_path / "double"
    double.write_text(Path(two).read_text() * 2)
    said = refusal(run("conform", "--cases", str(double), "--", *CONVEX))
    assert said == "two cases have the id 'mine-slot'"


def test_files_of_the_working_directory_do_not_get_in_the_way(
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
    assert "\ncorrect: passed, 2 of 2 cases judged, 0 worse" in done.stdout


def test_a_terminal_shows_progress(two: str) -> None:
    main, side = pty.openpty()
    command = [EXACTSWEEP, "conform", "--cases", two, "--", *CORRECT]
    environment = {**os.environ, "TERM": "xterm"}
    shown = b""
    with subprocess.Popen(command, stdout=-1, stderr=side, env=environment) as process:
        os.close(side)
        # A terminal that is not read fills up; its end is an error.
        with suppress(OSError):
            while chunk := os.read(main, 4096):
                shown += chunk
        os.close(main)
        said, _ = process.communicate()
    assert process.returncode == 0
    assert b"2 exact" in shown
    assert b"\x1b" not in said
