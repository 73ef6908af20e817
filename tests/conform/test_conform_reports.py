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

from exactsweep.check import classify
from exactsweep.conform import Verdict
from exactsweep.conform.report.html import write_html
from exactsweep.conform.report.junit import write_junit
from exactsweep.conform.report.text import close
from exactsweep.conform.run.outcome import Outcome
from exactsweep.conform.run.protocol import Hello
from exactsweep.conform.run.run import Run
from exactsweep.conform.run.tally import ACCEPTED


@pytest.fixture
def two(tmp_path: Path) -> str:
    return write_cases(tmp_path / "two.jsonl", TWO)


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
    (suite,) = ElementTree.fromstring(write_junit(run))
    counts = {"tests": "4", "failures": "1", "errors": "1", "skipped": "1", "time": "0.500"}
    assert suite.attrib == {"name": "mine & others", **counts}
    assert [(p.get("name"), p.get("value")) for p in suite[0]] == [("judged", "3")]
    tested = suite.findall("testcase")
    tags = [[child.tag for child in case] for case in tested]
    assert tags == [[], ["failure"], ["error", "system-err"], ["skipped"]]
    assert tested[1][0].attrib == {"type": "wrong", "message": "neither \ufffd nor <"}
    run.complaints, run.interrupted = ["exited with code 1"], True
    (suite,) = ElementTree.fromstring(write_junit(run))
    assert [case.get("name") for case in suite.findall("testcase")[4:]] == run.find_objections()
    assert [case[0].tag for case in suite.findall("testcase")[4:]] == ["failure", "failure"]
    assert (suite.get("tests"), suite.get("failures")) == ("6", "3")


@pytest.mark.parametrize("spoil", ["complaint", "interrupted", "too few", "nothing"])
def test_no_run_that_fails_is_green_in_junit(spoil: str) -> None:
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


@pytest.mark.long
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


def test_what_rounding_was_granted_is_said(tmp_path: Path) -> None:
    page = tmp_path / "run.html"
    filters = ("--filter", "flag=rounded-answer", "--filter", "size=10")
    options = ("--accept", "within", "--rounding", "1/7", "--html", str(page))
    done = run("conform", *filters, *options, "--", *FAULTY, "to-floats")
    (line,) = re.findall("^within: .*$", done.stdout, re.M)
    assert line.startswith("within: a rounding of up to 0.142857 was granted (")
    assert "A rounding of about 0.142857 at most was granted (" in page.read_text()


def test_the_mistake_is_said_in_all_reports(tmp_path: Path) -> None:
    page, xml = tmp_path / "run.html", tmp_path / "run.xml"
    reports = ("--html", str(page), "--junit", str(xml), "--shrink", "0")
    run("conform", "--filter", "id=figures-c", *reports, "--", *FAULTY, "sign-of-g")
    words = "answers that differ: exact for D + G, G not reflected"
    assert words in page.read_text()
    suite = ElementTree.fromstring(xml.read_text())[0]
    named = {p.get("name"): p.get("value") for p in suite[0]}
    assert named["diagnosis"] == f"all {suite.get('tests')} {words}"
    assert named["judged"] == suite.get("tests")
    (properties,) = suite.findall("testcase")[0].findall("properties")
    fault = {p.get("name"): p.get("value") for p in properties}["fault"]
    assert fault == "wrong: trajectory, exact for D + G, G not reflected, overlap, free"


def test_failures_come_first_and_are_linked(two: str, tmp_path: Path) -> None:
    path = tmp_path / "run.html"
    run("conform", "--cases", two, "--html", str(path), "--", *FAULTY, "vertex-inward")
    page = path.read_text()
    order = [page.index(f'id="{name}"') for name in ("failures", "f1", "verdicts", "far", "all")]
    assert order == sorted(order)
    links = set(re.findall(r'href="#(\w+)"', page))
    assert links <= set(re.findall(r'id="(\w+)"', page))
    assert {"failures", "verdicts", "far", "all", "f1"} <= links
    assert "prefers-color-scheme" in page


def test_the_page_shows_no_control_characters_and_names_all_questions() -> None:
    run = Run(Hello("mine", (), questions=("no_fit", "inner_fit")))
    run.add(
        Outcome("a", "CC", (), Verdict.CRASH, "exited", "crash: exited", stderr="\x1b[31m\x00x\ny")
    )
    page = write_html(run)
    for text in (page, write_junit(run)):
        assert not {"\x1b", "\x00"} & {*text}
    assert "\ufffd[31m\ufffdx\ny" in page
    assert "Answers no fit, inner fit; numbers" in page


def test_who_works_in_floats_is_told_what_passes() -> None:
    for accepted, told in ((ACCEPTED, True), (Verdict.WITHIN, False)):
        run = Run(Hello("mine", numbers="binary64"), accepted=accepted)
        run.add(Outcome("a", "CC", (), Verdict.WITHIN, "rounded", "within: rounded"))
        assert ("with --accept within, 1 rounded answer would pass" in close(run)) == told
