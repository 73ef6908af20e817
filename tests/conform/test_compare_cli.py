"""The command `compare`, run in a separate process."""

import json
from pathlib import Path
from typing import NoReturn

import pytest
from command import refusal, run

from exactsweep.conform.judge.verdict import Comparison, Verdict
from exactsweep.conform.report.text import describe
from exactsweep.conform.run.outcome import OvertimeError
from exactsweep.corpus import case_to_json, find_case

CASE = find_case("fits-square")
ANSWER = {
    name: [[str(x), str(y)] for x, y in getattr(CASE, name).vertices]
    for name in ("trajectory", "inner", "outer")
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "case.json").write_text(json.dumps(case_to_json(CASE)))
    (tmp_path / "answer.json").write_text(json.dumps(ANSWER))
    return tmp_path


def test_a_comparison_out_of_time_is_undecided_and_does_not_pass(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def compare(*_: object, **options: object) -> NoReturn:
        raise OvertimeError

    monkeypatch.setattr("exactsweep.conform.run.outcome.compare", compare)
    done = run("compare", "fits-square", "answer.json")
    assert done.exit_code == 1
    assert done.stdout.startswith("fits-square: undecided, comparing the answer takes more than")


def test_a_wrong_case_is_rejected(folder: Path) -> None:
    lying = case_to_json(CASE)
    lying["expected"]["inner"] = ANSWER["outer"]
    lying["expected"]["counts"]["inner"] = len(ANSWER["outer"])
    lying["expected"]["area"] = "0"
    (folder / "lying.json").write_text(json.dumps(lying))
    said = refusal(run("compare", "lying.json", "answer.json"))
    assert "case fits-square: the definition contradicts its inner near" in said


def test_a_verdict_without_parts_is_described() -> None:
    assert describe(Comparison("a", Verdict.TIMEOUT, "10 s")) == "a: timeout, 10 s\n"
