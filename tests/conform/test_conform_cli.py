"""`exactsweep conform` and `exactsweep judge`, as their users run them."""

import json
import os
import pty
import re
import shutil
import subprocess
import sys
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import pytest
from command import EXACTSWEEP, ROOT, refusal, run, shell

from exactsweep.check import classify
from exactsweep.conform import Verdict
from exactsweep.conform.report.junit import junit
from exactsweep.conform.run.outcome import Outcome, judge_answer
from exactsweep.conform.run.peer import read_answer
from exactsweep.conform.run.protocol import Hello, case_line, read_hello, read_object
from exactsweep.conform.run.run import Run
from exactsweep.corpus import Case, case_to_json

EXAMPLES = ROOT / "exactsweep" / "conform" / "examples"
IMPLEMENTATIONS = ROOT / "tests" / "support" / "implementations"
CONVEX = [sys.executable, str(EXAMPLES / "convex.py")]
CORRECT = [sys.executable, str(IMPLEMENTATIONS / "correct.py")]
FAULTY = [sys.executable, str(IMPLEMENTATIONS / "faulty.py")]
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
SLOT = [(0, 0), (3, 0), (3, 5), (2, 5), (2, 1), (1, 1), (1, 3), (0, 3)]
TWO = [Case.of("mine-slot", "", SLOT, SQUARE), Case.of("mine-square", "", SQUARE, SQUARE, (1, 0))]


@pytest.fixture
def two(tmp_path: Path) -> str:
    path = tmp_path / "two.jsonl"
    path.write_text("".join(f"{json.dumps(case_to_json(case))}\n" for case in TWO))
    return str(path)


def test_a_table_and_a_last_line_sum_up(two: str) -> None:
    done = run("conform", "--accept", "equivalent", "--cases", two, "--", *FAULTY, "fit-dropped")
    assert done.exit_code == 1
    table, _, rest = done.stdout.partition("\n\n")
    rows = [re.split(r"\s{2,}", line.strip()) for line in table.splitlines()]
    assert rows[0] == ["cases", "exact", "equivalent but for exact fits"]
    assert rows[1:4] == [["all", "2", "1", "1"], ["CC", "1", "1"], ["CM", "1", "1"]]
    failure, ending = rest.splitlines()
    assert failure.startswith("equivalent but for exact fits  mine-slot  ")
    assert ending == "faulty: fit-dropped: failed, 2 cases, 1 worse than equivalent"


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
    assert first.endswith(" trajectories that differ: exact for D + G, G not reflected")


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
    ("arguments", "message"),
    [
        ((), "Missing argument 'COMMAND...'"),
        (("--accept", "fine", "x"), "'fine' is not one of: exact, equivalent, "),
        (("--accept", "unsupported", "x"), "is not one of"),
        (("--timeout", "0", "x"), "Invalid value for '--timeout'"),
        (("--timeout", "nan", "x"), "Invalid value for '--timeout'"),
        (("--json", "-", "--html", "-", "x"), "Only one report can go to standard output."),
        (("--workers", "0", "x"), "Invalid value for '--workers'"),
        (("--resume", "x"), "--resume needs --journal."),
    ],
)
def test_wrong_usage_exits_with_2(arguments: tuple[str, ...], message: str) -> None:
    done = run("conform", *arguments)
    assert (done.exit_code, done.stdout) == (2, "")
    assert message in done.stderr


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--filter", "colour=red"), "'colour=red' is not id=..., flag=..., class=... or size=..."),
        (("--filter", "flag"), "'flag' is not id=..."),
        (("--filter", "size=many"), "'many' is not a number of vertices"),
        (("--filter", "id=a", "--filter", "id=b"), "more than one filter id=..."),
        (("--filter", "flag=exact-fits"), "did you mean 'exact-fit'?"),
        (("--filter", "class=XX"), "no class 'XX'"),
        (("--filter", "id=none"), "no case is like that"),
        (("--cases", "/none"), "/none: No such file or directory"),
        (("--journal", "/none/journal"), "/none/journal: No such file or directory"),
        (("--html", "/none/page"), "/none/page: its folder is not there"),
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
    assert message in refusal(run("conform", "--cases", str(path), "--", *CONVEX))


def test_two_cases_with_one_id_are_refused(two: str, tmp_path: Path) -> None:
    double = tmp_path / "double"
    double.write_text(Path(two).read_text() * 2)
    said = refusal(run("conform", "--cases", str(double), "--", *CONVEX))
    assert said == "two cases have the id 'mine-slot'"


def test_a_command_that_does_not_start_is_refused() -> None:
    assert "does not start" in refusal(run("conform", "--", "/no/such/program"))
    said = refusal(run("conform", "--", sys.executable, "-c", "raise SystemExit('no licence')"))
    assert said == "no hello: exited with code 1; it says: no licence"
    said = refusal(run("conform", "--", sys.executable, "-c", "print('Loading ...')"))
    assert said.startswith("the first line is no hello: 'Loading ...' is no JSON line: column 1")


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
    assert "\ncorrect: passed, 2 cases, 0 worse" in done.stdout


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


# The README.


def test_the_protocol_is_as_the_readme_says(tmp_path: Path) -> None:
    readme = (ROOT / "exactsweep/conform/README.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```json\n(.*?)^```$", readme, re.M | re.S)
    hello, line, answers = (block.splitlines() for block in blocks[:3])
    said = read_hello(hello[0])
    given = json.loads(line[0])
    names = ("directrix", "generatrix", "reference")
    case = Case.of(given["id"], "", *(given[name] for name in names))
    assert line == [case_line(case, said)]
    verdicts = ["exact", "unsupported", "crash"]
    for text, verdict in zip(answers, verdicts, strict=True):
        answer = read_answer(read_object(text))
        assert judge_answer(case, case, answer, said.loops).verdict == verdict


def test_the_python_example_is_exact_or_declines() -> None:
    done = run("conform", "--filter", "size=14", "--", *CONVEX)
    assert done.exit_code == 0
    assert re.match(r" +cases  exact  unsupported\n", done.stdout)


def test_the_cpp_example_is_exact_or_declines(tmp_path: Path) -> None:
    compiler = shutil.which("g++")
    if compiler is None:
        pytest.skip("g++ is not installed")
    program = str(tmp_path / "convex")
    flags = ["-std=c++17", "-O1", "-Wall", "-Wextra", "-Werror"]
    subprocess.run([compiler, *flags, "-o", program, str(EXAMPLES / "convex.cpp")], check=True)
    done = run("conform", "--filter", "class=CC", "--", program)
    assert done.exit_code == 0
    assert re.match(r" +cases  exact  unsupported\n", done.stdout)
    piped = shell(f"exactsweep corpus export worked | {program} | exactsweep judge")
    assert piped.returncode == 0
    assert re.match(r" +cases  exact  unsupported\n", piped.stdout)


# In a pipe.


def test_generated_cases_are_judged_in_a_pipe() -> None:
    done = shell(
        "exactsweep corpus generate --family convex --seed 7 --count 5"
        f" | {' '.join(CONVEX)} | exactsweep judge"
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "convex.py: passed, 5 cases, 0 worse than equivalent but for exact fits" in done.stdout


def test_own_cases_are_judged_in_a_pipe(two: str) -> None:
    done = shell(f"cat {two} | {' '.join(CORRECT)} | exactsweep judge --cases {two}")
    assert "correct: passed, 2 cases" in done.stdout


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
    path = Path(two)
    square, other = TWO[1], Case.of("other", "", SLOT, SLOT)
    wrong = replace(square, id="wrong", trajectory=other.trajectory)
    path.write_text("".join(f"{json.dumps(case_to_json(case))}\n" for case in (wrong, square)))
    code, lines = judge(two, ANSWER.replace("mine-square", "wrong") + ANSWER)
    assert code == 1
    assert lines[0].startswith("line 2: ")
    assert lines[-1].startswith("pipe: failed, 1 case, 0 worse")


@pytest.mark.parametrize("text", ["", "x\n", ANSWER])
def test_in_a_pipe_the_hello_comes_first(text: str) -> None:
    assert "no hello" in refusal(run("judge", stdin=text))


def test_answers_and_cases_do_not_share_standard_input() -> None:
    assert run("judge", "--cases", "-", stdin=HELLO).exit_code == 2


# Reports.


def test_junit_tells_failures_from_errors_and_skips() -> None:
    outcomes = [
        Outcome("a", "CC", (), Verdict.EXACT, seconds=0.5),
        Outcome("b", "CM", (), Verdict.WRONG, "neither \x00 nor <"),
        Outcome("c", "MM", (), Verdict.CRASH, "exited", stderr="Abort\x1b[0m"),
        Outcome("d", "MM", (), Verdict.UNSUPPORTED, "too hard"),
    ]
    run = Run(Hello("mine & others"))
    for outcome in outcomes:
        run.add(outcome)
    (suite,) = ElementTree.fromstring(junit(run))
    counts = {"tests": "4", "failures": "1", "errors": "1", "skipped": "1", "time": "0.500"}
    assert suite.attrib == {"name": "mine & others", **counts}
    tags = [[child.tag for child in case] for case in suite]
    assert tags == [[], ["failure"], ["error", "system-err"], ["skipped"]]
    assert suite[1][0].attrib == {"type": "wrong", "message": "neither \ufffd nor <"}
    run.complaints, run.interrupted = ["exited with code 1"], True
    assert ElementTree.fromstring(junit(run))[0][-1].text == "exited with code 1\ninterrupted"


def test_every_report_has_the_witness_in_full(two: str, tmp_path: Path) -> None:
    page, xml = tmp_path / "run.html", tmp_path / "run.xml"
    options = ("--cases", two, "--shrink", "0", "--html", str(page), "--junit", str(xml))
    run("conform", *options, "--", *FAULTY, "vertex-inward")
    # The page has the smallest first.
    for text, judged in ((page.read_text(), TWO[::-1]), (xml.read_text(), TWO)):
        places = re.findall(r"translation \((.*?),(.*?)\): OVERLAP, point \((.*?),(.*?)\)", text)
        for case, (x, y, *point) in zip(judged, places, strict=True):
            found = classify(case.directrix, case.generatrix, (x, y))
            assert (found.verdict, [str(c) for c in found.witness or ()]) == ("OVERLAP", point)


def test_all_outcomes_are_in_the_json(two: str, tmp_path: Path) -> None:
    path = tmp_path / "run.json"
    run("conform", "--cases", two, "--json", str(path), "--", *FAULTY, "vertex-outward")
    data = json.loads(path.read_text())
    assert data["counts"]["all"] == {"conservative": 2}
    assert {outcome["id"] for outcome in data["outcomes"]} == {"mine-slot", "mine-square"}
    # A corner moved by a third in x and in y: two ninths from its old place, squared.
    assert data["worst"]["trajectory"]["distance_squared"][0] == "2/9"
    assert not data["passed"]


def test_failures_are_made_smaller_for_the_page_and_the_json(tmp_path: Path) -> None:
    options = ("--filter", "id=undercuts-", "--accept", "within")
    page, data = tmp_path / "run.html", tmp_path / "run.json"
    command = ("--html", str(page), "--json", str(data), "--", *FAULTY, "undercut-open")
    assert run("conform", *options, *command).exit_code == 1
    (shrunk,) = json.loads(data.read_text())["shrunk"].values()
    assert (shrunk["verdict"], shrunk["id"][-7:]) == ("unsound", "-shrunk")
    assert len(shrunk["case"]["directrix"]) <= 5
    assert len(shrunk["case"]["generatrix"]) == 3
    assert "Made smaller" in page.read_text()
    run("conform", *options, "--shrink", "0", *command)
    assert json.loads(data.read_text())["shrunk"] == {}


def test_the_page_is_whole_and_quotes_what_is_foreign(two: str, tmp_path: Path) -> None:
    evil = "<script>alert(1)</script>"
    program = tmp_path / "evil.py"
    program.write_text(
        "import json, sys\n"
        f"evil = {evil!r}\n"
        "hello = {'hello': evil, 'loops': ['trajectory'], 'numbers': 'rational',"
        " 'reference': 'given'}\n"
        "print(json.dumps(hello), flush=True)\n"
        "for line in sys.stdin:\n"
        "    case = json.loads(line)\n"
        "    if 'bye' in case: break\n"
        "    if case['id'] == 'mine-slot': answer = {'error': evil}\n"
        "    else: answer = {'trajectory': [[0, 0], [1, 0], [0, 1]], evil: evil}\n"
        "    print(json.dumps({'id': case['id'], **answer}), flush=True)\n"
    )
    path = tmp_path / "run.html"
    options = ("--cases", two, "--html", str(path), "--shrink", "0")
    run("conform", *options, "--", sys.executable, str(program))
    page = path.read_text()
    assert evil not in page
    assert "&lt;script&gt;" in page
    assert not re.search(r'(src|href)="|@import|url\(', page)
    ElementTree.fromstring(
        page.replace("<!DOCTYPE html>", "")
        .replace('<meta charset="utf-8">', "")
        .replace('<meta name="viewport" content="width=device-width, initial-scale=1">', "")
        .replace("<br>", "")
    )
    pictures = re.findall(r'<svg width="320".*?</svg>', page, flags=re.S)
    assert len(pictures) == 2
    assert all('class="exact"' in picture for picture in pictures)
    assert 'class="theirs"' in "".join(pictures)
    assert 'class="witness"' in "".join(pictures)
