"""The command compare, as a user runs it."""

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


@pytest.mark.parametrize("case", ["case.json", "fits-square"])
def test_a_case_is_a_file_or_an_id(folder: Path, case: str) -> None:
    result = run("compare", case, "answer.json")
    assert result.exit_code == 0
    assert result.stdout.startswith("fits-square: equivalent except for exact fits\n")
    assert "exact fits: equivalent except for exact fits, 1 exact fit missing\n" in result.stdout


def test_what_is_a_failure_can_be_chosen(folder: Path) -> None:
    fits = "equivalent except for exact fits"
    assert run("compare", "fits-square", "answer.json", "--accept", fits).exit_code == 0
    assert run("compare", "fits-square", "answer.json", "--accept", "equivalent").exit_code == 1
    assert run("compare", "fits-square", "answer.json", "--accept", "good").exit_code == 2


def test_what_is_not_compared_in_time_is_undecided_and_does_not_pass(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def compare(*_: object, **options: object) -> NoReturn:
        raise OvertimeError

    monkeypatch.setattr("exactsweep.conform.run.outcome.compare", compare)
    done = run("compare", "fits-square", "answer.json")
    assert done.exit_code == 1
    assert done.stdout.startswith("fits-square: undecided, there is an answer, but")


def test_a_sweep_is_a_case_and_an_answer(folder: Path) -> None:
    assert run("sweep", "--json", "-o", "sweep.json").exit_code == 0
    result = run("compare", "sweep.json", "sweep.json")
    assert result.exit_code == 0
    assert result.stdout.startswith("sweep.json: exact\n")
    document = json.loads((folder / "sweep.json").read_text())
    document["inner"][0] = [-1, 0]
    result = run("compare", "sweep.json", "-", stdin=json.dumps(document))
    assert result.exit_code == 1
    assert result.stdout.startswith("sweep.json: conservative\n")


def test_everything_is_written_as_json(folder: Path) -> None:
    loop = [[-9, -9], *ANSWER["trajectory"][1:]]
    text = json.dumps({"trajectory": loop})
    result = run("compare", "fits-square", "-", "--json", "-o", "out.json", stdin=text)
    assert result.exit_code == 1
    assert result.stdout == ""
    document = json.loads((folder / "out.json").read_text())
    assert document["id"] == "fits-square"
    assert [part["name"] for part in document["parts"]] == ["trajectory", "exact_fits"]
    part = document["parts"][0]
    assert part["conservative"]["classified"] == "FREE"
    assert part["distance_squared"][0] == part["distance_squared"][1]


def test_decimals_in_an_answer_are_binary(folder: Path) -> None:
    pair = {"directrix": [[0, 0], [0.1, 0], [0, 1]], "generatrix": [[0, 0], [1, 0], [0, 1]]}
    (folder / "pair.json").write_text(json.dumps(pair))
    # Exact numbers as decimals are in the pair, and not in the answer.
    inner = [[0, 0], [0.1, 0], [0, 1]]
    result = run("compare", "pair.json", "-", stdin=json.dumps({"inner": inner}))
    assert result.exit_code == 1
    assert result.stdout.splitlines()[1] == "inner loop: within, rounded"
    strings = [[0, 0], ["0.1", 0], [0, 1]]
    result = run("compare", "pair.json", "-", stdin=json.dumps({"inner": strings}))
    assert result.exit_code == 0


def test_rounding_can_be_declared(folder: Path) -> None:
    loop = [[x, "0.01" if y == "0" else y] for x, y in ANSWER["inner"]]
    text = json.dumps({"inner": loop})
    assert run("compare", "fits-square", "-", stdin=text).exit_code == 1
    result = run("compare", "fits-square", "-", "--rounding", "1/50", stdin=text)
    assert result.stdout.splitlines()[0] == "fits-square: within"
    for wrong in ("x", "-1"):
        assert run("compare", "fits-square", "-", "--rounding", wrong, stdin=text).exit_code == 2


@pytest.mark.parametrize(
    ("case", "answer", "message"),
    [
        ("fits-squar", "answer.json", "no case 'fits-squar'; did you mean 'fits-square'?"),
        ("case.json", "none.json", "none.json: No such file or directory"),
        ("answer.json", "answer.json", 'answer.json: $ has neither "expected", as a case has'),
        ("list.json", "answer.json", "list.json: $ is a list, not an object"),
        ("case.json", "bad.json", "bad.json: line 1, column 2: not JSON"),
        ("lying.json", "answer.json", "case fits-square: its inner is refuted near"),
    ],
)
def test_what_cannot_be_compared_is_refused_in_one_line(
    folder: Path, case: str, answer: str, message: str
) -> None:
    (folder / "list.json").write_text("[]")
    (folder / "bad.json").write_text("{")
    lying = case_to_json(CASE)
    lying["expected"]["inner"] = ANSWER["outer"]
    lying["expected"]["counts"]["inner"] = len(ANSWER["outer"])
    lying["expected"]["area"] = "0"
    (folder / "lying.json").write_text(json.dumps(lying))
    assert message in refusal(run("compare", case, answer))


def test_an_answer_may_be_anything(folder: Path) -> None:
    for text in ("[]", "null", "3", '{"trajectory": [[NaN, 1]]}', '{"inner": [[[]]]}'):
        result = run("compare", "fits-square", "-", stdin=text)
        assert result.exit_code == 1
        assert result.stdout.startswith("fits-square: malformed")
    assert run("compare", "fits-square", "-", stdin="{}").stdout == (
        "fits-square: unsupported, the answer has no loops\n"
    )


def test_wrong_usage_has_exit_code_2() -> None:
    assert run("compare", "-", "-").exit_code == 2
    assert run("compare", "fits-square").exit_code == 2


def test_a_verdict_without_parts_is_described() -> None:
    assert describe(Comparison("a", Verdict.TIMEOUT, "10 s")) == "a: timeout, 10 s\n"
