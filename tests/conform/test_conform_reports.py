"""Reports of runs: JUnit, JSON and the page."""

import json
import re
import sys
from fractions import Fraction
from pathlib import Path
from xml.etree import ElementTree

import pytest
from command import run
from judged import FAULTY, TWO, write_cases

from exactsweep.conform import Verdict
from exactsweep.conform.report.ci import write_junit
from exactsweep.conform.report.html import write_html
from exactsweep.conform.report.text import close
from exactsweep.conform.run.outcome import Outcome
from exactsweep.conform.run.protocol import Hello
from exactsweep.conform.run.run import Run


@pytest.fixture
def two(tmp_path: Path) -> str:
    return write_cases(tmp_path / "two.jsonl", TWO)


@pytest.mark.parametrize("spoil", ["complaint", "interrupted", "too few", "nothing"])
def test_failed_runs_are_red_in_junit(spoil: str) -> None:
    run = Run(Hello("mine"), least_judged=Fraction(1, 2) if spoil == "too few" else Fraction(0))
    if spoil != "nothing":
        run.add(Outcome("a", "CC", (), Verdict.EXACT))
        assert run.passed
    if spoil == "too few":
        for k in range(3):
            run.add(Outcome(f"u{k}", "CC", (), Verdict.UNSUPPORTED))
    run.complaints = ["exited with code 1 after bye"] if spoil == "complaint" else []
    run.interrupted = spoil == "interrupted"
    assert not run.passed
    (suite,) = ElementTree.fromstring(write_junit(run))
    assert len(suite.findall("testcase/failure")) == int(suite.get("failures", "")) == 1


def test_twenty_kinds_of_failures_are_listed_and_others_counted() -> None:
    run = Run(Hello("mine"))
    for k in range(23):
        run.add(Outcome(f"a{k}", "CC", (), Verdict.CRASH, fault=f"kind {k}"))
    assert "\n... and 3 other failures of 3 kinds\n" in close(run)


@pytest.mark.long
def test_failures_are_shrunk_for_the_page_and_the_json(tmp_path: Path) -> None:
    options = ("--filter", "id=undercuts-", "--accept", "within")
    page, data = tmp_path / "run.html", tmp_path / "run.json"
    command = ("--html", str(page), "--json", str(data), "--", *FAULTY, "undercut-open")
    assert run("conform", *options, *command).exit_code == 1
    (shrunk,) = json.loads(data.read_text())["shrunk"].values()
    assert (shrunk["verdict"], shrunk["id"][-7:]) == ("unsound", "-shrunk")
    assert len(shrunk["case"]["directrix"]) <= 5
    assert len(shrunk["case"]["generatrix"]) == 3
    assert "Smaller case" in page.read_text()
    run("conform", *options, "--shrink", "0", *command)
    assert json.loads(data.read_text())["shrunk"] == {}


def test_the_page_is_complete_and_escapes_untrusted_text(two: str, tmp_path: Path) -> None:
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
    assert not re.search(r'src="|href="(?!#)|@import|url\(', page)
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


@pytest.mark.long
def test_reports_state_the_granted_rounding(tmp_path: Path) -> None:
    page = tmp_path / "run.html"
    filters = ("--filter", "flag=rounded-answer", "--filter", "size=10")
    options = ("--accept", "within", "--rounding", "1/7", "--html", str(page))
    done = run("conform", *filters, *options, "--", *FAULTY, "to-floats")
    (line,) = re.findall("^within: .*$", done.stdout, re.M)
    assert line.startswith("within: a rounding of up to 0.142857 was granted (")
    assert "The greatest rounding granted was about 0.142857 (" in page.read_text()


def test_the_page_shows_no_control_characters_and_names_all_questions() -> None:
    run = Run(Hello("mine", (), questions=("no_fit", "inner_fit")))
    run.add(
        Outcome("a", "CC", (), Verdict.CRASH, "exited", "crash: exited", stderr="\x1b[31m\x00x\ny")
    )
    page = write_html(run)
    for text in (page, write_junit(run)):
        assert not {"\x1b", "\x00"} & {*text}
    assert "\ufffd[31m\ufffdx\ny" in page
    assert "Answers no-fit polygon, inner fit; numbers" in page
