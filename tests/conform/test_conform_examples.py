"""The protocol as the README tells it, and the programs to begin with."""

import json
import re
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest
from command import ROOT, refusal, run, shell
from judged import EXAMPLES

from exactsweep.conform.run.outcome import judge_answer
from exactsweep.conform.run.peer import read_answer
from exactsweep.conform.run.protocol import read_hello, read_object, write_case_line
from exactsweep.corpus import Case


def test_the_protocol_is_as_the_readme_says(tmp_path: Path) -> None:
    readme = (ROOT / "exactsweep/conform/PROTOCOL.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```json\n(.*?)^```$", readme, re.M | re.S)
    hello, line, answers = (block.splitlines() for block in blocks[:3])
    said = read_hello(hello[0])
    given = json.loads(line[0])
    names = ("directrix", "generatrix", "reference")
    case = Case.of(given["id"], "", *(given[name] for name in names))
    assert line == [write_case_line(case, said)]
    verdicts = ["exact", "unsupported", "crash"]
    for text, verdict in zip(answers, verdicts, strict=True):
        answer = read_answer(read_object(text))
        assert judge_answer(case, case, answer, said).verdict == verdict


def test_the_protocol_shows_what_a_case_asks() -> None:
    readme = (ROOT / "exactsweep/conform/PROTOCOL.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```json\n(.*?)^```$", readme, re.M | re.S)
    hello, line, (text, _) = (block.splitlines() for block in blocks[3:])
    said = replace(read_hello(hello[0]), numbers="rational")
    given = json.loads(line[0])
    case = Case.of(given["id"], "", given["directrix"], given["generatrix"], inner_fit=True)
    assert line == [write_case_line(case, said)]
    answer = read_answer(read_object(text))
    assert judge_answer(case, case, answer, said).verdict == "exact"


@pytest.mark.long
def test_the_javascript_example_is_exact_or_declines() -> None:
    node = shutil.which("node")
    if node is None:
        pytest.skip("node is not installed")
    program = [node, str(EXAMPLES / "convex.js")]
    done = run("conform", "--filter", "class=CC", "--", *program)
    assert done.exit_code == 0
    assert re.match(r" +cases  exact\n", done.stdout)
    piped = shell(f"exactsweep corpus export worked | {' '.join(program)} | exactsweep judge")
    assert piped.returncode == 0
    assert re.match(r" +cases  exact  unsupported\n", piped.stdout)


def test_an_example_is_shown_and_copied(tmp_path: Path) -> None:
    paths = [Path(line) for line in run("example").stdout.splitlines()]
    assert [path.name for path in paths] == ["convex.cpp", "convex.js", "convex.py"]
    for path in paths:
        assert run("example", path.name).stdout == path.read_text(encoding="utf-8")
    mine = tmp_path / "mine.py"
    assert run("example", "convex.py", "-o", str(mine)).exit_code == 0
    assert mine.read_bytes() == paths[2].read_bytes()
    assert "is there already" in refusal(run("example", "convex.js", "-o", str(mine)))
    assert mine.read_bytes() == paths[2].read_bytes()
    assert refusal(run("example", "convex.p")) == "no example 'convex.p'; did you mean 'convex.py'?"


@pytest.mark.long
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
