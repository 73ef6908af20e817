"""The protocol in the README, and the template programs."""

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from command import ROOT, refusal, run
from judged import EXAMPLES, write_cases
from shipped_cases import shipped_cases

from exactsweep.conform.run.outcome import judge_answer
from exactsweep.conform.run.peer import read_answer
from exactsweep.conform.run.protocol import read_hello, read_object, write_case_line
from exactsweep.corpus import Case


def test_the_readme_shows_the_protocol(tmp_path: Path) -> None:
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


def test_the_protocol_shows_the_questions_of_a_case() -> None:
    readme = (ROOT / "exactsweep/conform/PROTOCOL.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```json\n(.*?)^```$", readme, re.M | re.S)
    hello, line, (text, _) = (block.splitlines() for block in blocks[3:])
    said = replace(read_hello(hello[0]), numbers="rational")
    given = json.loads(line[0])
    case = Case.of(given["id"], "", given["directrix"], given["generatrix"], inner_fit=True)
    assert line == [write_case_line(case, said)]
    answer = read_answer(read_object(text))
    assert judge_answer(case, case, answer, said).verdict == "exact"


def test_examples_are_listed_shown_and_copied(tmp_path: Path) -> None:
    names = {path.name for path in EXAMPLES.iterdir() if path.is_file()} - {"__init__.py"}
    assert {line.split()[0] for line in run("example").stdout.splitlines()} == names
    for name in names:
        assert run("example", name).stdout == (EXAMPLES / name).read_text(encoding="utf-8")
    mine = tmp_path / "mine.py"
    assert run("example", "convex.py", "-o", str(mine)).exit_code == 0
    assert mine.read_bytes() == (EXAMPLES / "convex.py").read_bytes()
    assert "already exists" in refusal(run("example", "doubles.js", "-o", str(mine)))
    assert mine.read_bytes() == (EXAMPLES / "convex.py").read_bytes()
    assert refusal(run("example", "convex.p")) == "no example 'convex.p'; did you mean 'convex.py'?"


# In doubles, any shape.

PAIRS = [
    # A slot, cavities, a chamber, an exactly fitting hole, and coordinates that doubles round.
    *("worked-u-shape", "holes-room", "fits-square"),
    *("jigsaw-triangles-slanted", "touching-edge", "vertical-wall-up-and-down"),
    # Products of coordinates overflow or underflow.
    *("sizes-binary64-overflow", "sizes-binary64-least"),
    # Far from the origin, where doubles have no fractions.
    "sizes-far-2-52",
]
CRATES = Path("/usr/share/cargo/registry")
"""Where Debian puts crates."""


def build_cpp(folder: Path) -> list[str]:
    compiler = shutil.which("g++")
    if compiler is None or not header_is_there(compiler):
        pytest.skip("g++ or nlohmann-json3-dev is not installed")
    program = str(folder / "doubles")
    flags = ["-std=c++17", "-O1", "-Wall", "-Wextra", "-Werror"]
    subprocess.run([compiler, *flags, "-o", program, str(EXAMPLES / "doubles.cpp")], check=True)
    return [program]


def header_is_there(compiler: str) -> bool:
    given = "#include <nlohmann/json.hpp>"
    command = [compiler, "-fsyntax-only", "-x", "c++", "-"]
    return not subprocess.run(command, input=given, text=True, capture_output=True).returncode


def build_javascript(folder: Path) -> list[str]:
    node = shutil.which("node")
    if node is None:
        pytest.skip("node is not installed")
    return [node, str(EXAMPLES / "doubles.js")]


def build_python(folder: Path) -> list[str]:
    return [sys.executable, str(EXAMPLES / "doubles.py")]


def build_rust(folder: Path) -> list[str]:
    cargo = shutil.which("cargo")
    if cargo is None or not any(CRATES.glob("serde_json-*")):
        pytest.skip("cargo or librust-serde-json-dev is not installed")
    (folder / "src").mkdir()
    shutil.copy(EXAMPLES / "doubles.rs", folder / "src" / "main.rs")
    manifest = '[package]\nname = "doubles"\nversion = "0.1.0"\nedition = "2021"\n'
    (folder / "Cargo.toml").write_text(f'{manifest}[dependencies]\nserde_json = "1"\n')
    source = f'source.crates-io.replace-with="d"\nsource.d.directory="{CRATES}"\n'
    (folder / ".cargo").mkdir()
    (folder / ".cargo" / "config.toml").write_text(source)
    environment = {**os.environ, "RUSTFLAGS": "-D warnings"}
    command = [cargo, "build", "--offline", "--quiet"]
    subprocess.run(command, cwd=folder, env=environment, check=True)
    return [str(folder / "target" / "debug" / "doubles")]


BUILDS = [
    pytest.param(build_python, id="python", marks=pytest.mark.long),
    pytest.param(build_javascript, id="javascript", marks=pytest.mark.long),
    pytest.param(build_cpp, id="cpp", marks=pytest.mark.long),
    pytest.param(build_rust, id="rust", marks=pytest.mark.long),
]


@pytest.mark.parametrize("build", BUILDS)
def test_examples_are_correct_and_decline_large_cases(
    build: Callable[[Path], list[str]], tmp_path: Path
) -> None:
    program = build(tmp_path)
    small = [case for case in shipped_cases() if case.size <= 9]
    chosen = [case for case in small if "binary64" in case.representable][::12]
    chosen += [case for case in shipped_cases() if case.id in PAIRS]
    ring = [(k, k * k) for k in range(60)]
    path = write_cases(tmp_path / "cases.jsonl", [*chosen, Case.of("large", "", ring, ring)])
    done = run("conform", "--accept", "within", "--cases", path, "--", *program)
    assert done.exit_code == 0, done.stdout
    assert f"passed, {len(chosen)} of {len(chosen) + 1} cases judged" in done.stdout
