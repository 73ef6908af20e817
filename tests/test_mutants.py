"""The command that mutates the kernel: its operators, and its list of equivalent mutants."""

from collections import Counter
from pathlib import Path

import mutants
import pytest
from operators import Mutant, mutants_of
from reach import measure
from trial import Reader, run_afresh

MODULE = b'''"""A module."""

def least(a: int | None, b: int = 3) -> int:
    assert a is not None
    if not (a < b) and True:
        raise ValueError(f"{a + b}")
    b += -a
    zip((), (), strict=True)
    return min(a, b)
'''


def test_each_operator_makes_its_mutants() -> None:
    found = [mutant.shown(MODULE)[1] for mutant in mutants_of("least.py", MODULE)]
    assert found == [
        "def least(a: int | None, b: int = 2) -> int:",
        "def least(a: int | None, b: int = 4) -> int:",
        "if (a < b) and True:",
        "if (not (not (a < b) and True)):",
        "if not (a <= b) and True:",
        "if not (a > b) and True:",
        "if not (a < b) or True:",
        "if not (a < b) and False:",
        "pass",
        "b -= -a",
        "b += +a",
        "pass",
        "return max(a, b)",
    ]


def test_mutants_are_modules() -> None:
    for mutant in mutants_of("least.py", MODULE):
        compile(mutant.applied(MODULE), "least.py", "exec")
        assert mutant.applied(MODULE) != MODULE


def test_equivalent_mutants_are_mutants_and_have_reasons() -> None:
    known = mutants.read_equivalent()
    every = Counter((mutant.path, *mutant.shown(text)) for mutant, text in mutants.every_mutant())
    assert {every[key] for key in known} <= {1}
    assert all(reason.endswith(".") for reason in known.values())


TREE = {
    "little/least.py": """LIMIT = 2

def least(a, b):
    if a < b:
        return -(-a)
    return -(-b)

def alone(
    a=3,
):
    return a + 1
""",
    "test_least.py": """from little.least import LIMIT, least

def test_less(): assert least(1, 2) == 1
def test_greater(): assert least(2, 1) == 1
def test_limit(): assert LIMIT == 2
""",
    "test_when_read.py": """from little.least import least

ONE = least(2, 1)
def test_one(): assert ONE == 1
""",
    "pytest.ini": "[pytest]\n",
}
LESS, GREATER, LIMIT = (f"test_least.py::test_{name}" for name in ("less", "greater", "limit"))
READ = "test_when_read.py::test_one"
MODULE_PATH = "little/least.py"
TEXT = TREE[MODULE_PATH].encode()


def mutant_of(old: str, new: str) -> Mutant:
    """A change of the small module."""
    start = TEXT.index(old.encode())
    line = TEXT.count(b"\n", 0, start) + 1
    return Mutant(MODULE_PATH, line, start, start + len(old), new)


@pytest.fixture
def tree(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    for name, text in TREE.items():
        (tmp_path / "tree" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "tree" / name).write_text(text)
    return tmp_path / "tree"


def test_tests_are_known_by_the_lines_that_they_reach(tree: Path) -> None:
    pytest.importorskip("coverage")
    for _ in range(2):  # the second time, from what was kept
        reach = measure(tree, ["test_least.py", "test_when_read.py"], [MODULE_PATH])
        assert reach.seconds.keys() == {LESS, GREATER, LIMIT, READ}
        found = {
            mutant.shown(TEXT)[1]: reach.tests_of(mutant.path, mutant.lines(TEXT))
            for mutant in mutants_of(MODULE_PATH, TEXT)
        }
        assert set(found["if a > b:"]) == {LESS, GREATER, READ}
        assert found["return -(+a)"] == [LESS]
        assert set(found["return -(+b)"]) == {GREATER, READ}
        assert found["return a + 2"] == []
        for after in ("LIMIT = 1", "a=2,"):
            assert set(found[after]) == {LESS, GREATER, READ, LIMIT}
            assert found[after][-1] == LIMIT


VERDICTS = [
    ("a < b", "a < b + 0", "survived", ""),
    ("a < b", "a > b", "killed", LESS),
    ("-(-b)", "a", "killed", GREATER),
    ("return -(-b)", "while True: pass", "time", GREATER),
    ("LIMIT = 2", "LIMIT = 3", "killed", LIMIT),
    ("LIMIT = 2", "LIMIT = 1 / 0", "killed", "when modules are imported"),
]


@pytest.mark.parametrize(("old", "new", "verdict", "by"), VERDICTS)
def test_changes_of_modules_are_noticed(
    tree: Path, old: str, new: str, verdict: str, by: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("trial.SPARE", 2)
    (tree / MODULE_PATH).write_bytes(mutant_of(old, new).applied(TEXT))
    tests = [LESS, GREATER, LIMIT]
    assert run_afresh(tree, tests, dict.fromkeys(tests, 0.0))[:2] == (verdict, by)


def test_changes_of_functions_are_noticed_without_reading_the_tests_again(
    tree: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("trial.SPARE", 2)
    tests = [LESS, GREATER, LIMIT]
    reader = Reader(tree, ["test_least.py"], dict.fromkeys(tests, 0.0))
    for old, new, verdict, by in VERDICTS[::-1]:
        found = reader.run(mutant_of(old, new), TEXT, tests)
        if "LIMIT" in old:
            assert found is None
        else:
            assert found is not None
            assert found[:2] == (verdict, by)
        (tree / "test_least.py").write_text("no longer read")
    reader.close()


def test_quickest_tests_come_within_the_budget() -> None:
    seconds = {"a": 0.5, "b": 1.5, "c": 2.0, "d": 9.0}
    assert mutants.within([*seconds], seconds, 60) == ["a", "b", "c", "d"]
    assert mutants.within([*seconds], seconds, 5) == ["a", "b", "c"]
    assert mutants.within([], seconds, 60) == []
