"""The measurement of other programs judges each one once, and writes a page."""

import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from benchmarks.peers.adapters import measure as measure_module
from benchmarks.peers.adapters.measure import main as measure
from benchmarks.peers.adapters.page import write_page
from exactsweep.conform.run.journal import Journal
from exactsweep.conform.run.outcome import judge_case
from exactsweep.conform.run.peer import CallablePeer
from exactsweep.conform.run.process import Terms
from exactsweep.conform.run.protocol import Hello
from exactsweep.conform.run.run import Run
from exactsweep.corpus import Case


def test_the_exactness_of_programs_is_written_as_a_page(tmp_path: Path) -> None:
    square = [(0, 0), (8, 0), (8, 8), (0, 8)]
    case = Case.of("squares", "", square, [(0, 0), (1, 0), (1, 1), (0, 1)])
    loop = case.trajectory.vertices
    hello = Hello("a program", ("trajectory",), "rational", "origin")
    answers: Iterator[dict[str, Any]] = iter(
        [{"trajectory": loop}, {"trajectory": loop[:3]}, {"unsupported": "no"}]
    )
    peer = CallablePeer(lambda *_: next(answers), hello)
    path = tmp_path / "a.sweep"
    with Journal(path, Terms([]), hello) as journal:
        for _ in range(3):
            journal.add(judge_case(peer, case))
    asked = Hello("another", (), questions=("no_fit",), shapes="any")
    other = CallablePeer(lambda *_: {"no_fit": loop}, asked)
    with Journal(tmp_path / "b.no_fit", Terms([]), asked) as journal:
        journal.add(judge_case(other, case))
    both = write_page([tmp_path / "b.no_fit", path], "four cases").split("## All verdicts")
    assert "| another | no-fit polygon | 1 | 1 |  |  |" in both[1]
    by_kind, verdicts = write_page([path], "three cases").split("## All verdicts")
    *_, head, _, row = by_kind.strip().splitlines()
    assert head.startswith("| program | convex | monotone |")
    assert row.startswith("| a program | 1 of 2 |  |")
    *_, head, _, row = verdicts.strip().splitlines()
    assert head.endswith("| cases | exact | unsound | smallest failure |")
    assert row == "| a program | outer path | 2 | 1 | 1 | squares |"


def test_a_page_lists_the_questions(tmp_path: Path) -> None:
    page, folder = tmp_path / "page", tmp_path / "journals"
    asked = [str(folder), "--no-judging", "--most", "6", "--each", "3"]
    shown = CliRunner().invoke(measure, asked)
    assert shown.exit_code == 0
    assert folder.is_dir()
    assert "of at most 6 vertices, and 3 of each family of the generator, seed 1" in shown.output
    # Again, with an existing folder.
    written = CliRunner().invoke(measure, [*asked, "--page", str(page)])
    assert (written.exit_code, written.output) == (0, "")
    assert f"{page.read_text(encoding='utf-8')}\n" == shown.output


def test_a_missing_program_is_reported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "shapely", None)
    shown = CliRunner().invoke(
        measure, [str(tmp_path), "--only", "shapely", "--most", "6", "--each", "0"]
    )
    assert shown.stderr.startswith("shapely: shapely is not installed")


@pytest.mark.parametrize(
    ("complaints", "interrupted", "said"),
    [(["one", "two"], False, "one; two"), ([], True, "interrupted")],
)
def test_a_failed_run_is_reported(
    complaints: list[str],
    interrupted: bool,
    said: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    pytest.importorskip("shapely")

    def fail(run: Run, *_: object, **named: object) -> None:
        run.complaints, run.interrupted = complaints, interrupted

    monkeypatch.setattr(measure_module, "judge_cases", fail)
    shown = CliRunner().invoke(
        measure, [str(tmp_path), "--only", "shapely", "--most", "6", "--each", "0"]
    )
    assert (shown.exit_code, shown.stderr) == (1, f"Error: shapely: {said}\n")


@pytest.mark.long
def test_a_program_is_judged_once(tmp_path: Path) -> None:
    pytest.importorskip("shapely")
    asked = [str(tmp_path), "--only", "shapely", "--most", "6", "--each", "0"]
    done = CliRunner().invoke(measure, asked)
    assert done.exit_code == 0, done.output
    questions = ("minkowski_sum", "inner_fit")
    assert done.stderr.splitlines() == [f"shapely, {question}: done" for question in questions]
    assert re.search(r"\| Minkowski sum \| (\d\d) \| \1 \|  \|  \|", done.stdout)
    journals = [tmp_path / f"shapely.{question}" for question in questions]
    judged = [journal.read_bytes() for journal in journals]
    assert CliRunner().invoke(measure, asked).stdout == done.stdout
    assert [journal.read_bytes() for journal in journals] == judged
