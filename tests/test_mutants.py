"""The command that mutates the kernel: its operators, and its list of equivalent mutants."""

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import mutants
import pytest
from operators import Mutant, mutants_of
from reach import measure
from reader import Reader
from trial import run_afresh, written

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
    assert {key: every[key] for key in known} == {key: times for key, (_, times) in known.items()}
    assert all(reason.endswith(".") for reason, _ in known.values())


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
    ("a < b", "a < b + 0", "survived", "", ""),
    ("a < b", "a > b", "killed", LESS, "test_least.py:3: AssertionError"),
    ("-(-b)", "a", "killed", GREATER, "test_least.py:4: AssertionError"),
    ("return -(-b)", "while True: pass", "time", GREATER, "SIGXCPU"),
    ("LIMIT = 2", "LIMIT = 3", "killed", LIMIT, "test_least.py:5: AssertionError"),
    ("LIMIT = 2", "LIMIT = 1 / 0", "killed", "test_least.py", "least.py:1: ZeroDivisionError"),
]


@pytest.mark.parametrize(("old", "new", "verdict", "by", "why"), VERDICTS)
def test_changes_of_modules_are_noticed(
    tree: Path, old: str, new: str, verdict: str, by: str, why: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("trial.SPARE", 2)
    tests = [LESS, GREATER, LIMIT]
    with written(tree, mutant_of(old, new), TEXT):
        found = run_afresh(tree, tests, dict.fromkeys(tests, 0.0))
    assert found[:2] == (verdict, by)
    assert found.why.startswith(why)
    assert (tree / MODULE_PATH).read_bytes() == TEXT


def test_changes_of_functions_are_noticed_without_reading_the_tests_again(
    tree: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("trial.SPARE", 2)
    tests = [LESS, GREATER, LIMIT]
    reader = Reader(tree, ["test_least.py"], dict.fromkeys(tests, 0.0))
    for old, new, verdict, by, why in VERDICTS[::-1]:
        found = reader.run(mutant_of(old, new), TEXT, tests)
        if "LIMIT" in old:
            assert found is None
        else:
            assert found is not None
            assert found[:2] == (verdict, by)
            assert found.why.startswith(why)
        (tree / "test_least.py").write_text("no longer read")
    reader.close()


def test_a_mutant_that_is_written_at_once_is_not_read(tree: Path) -> None:
    """Once the first mutant of a run was in all that were tried after it: false kills."""
    reader = Reader(tree, ["test_least.py"], dict.fromkeys([LESS, GREATER], 0.0))
    with written(tree, mutant_of("a < b", "a > b"), TEXT):
        found = reader.run(mutant_of("a < b", "a < b + 0"), TEXT, [LESS, GREATER])
    reader.close()
    assert found is not None
    assert found.verdict == "survived"


DOUBTFUL = """import os
import time
from little.least import least

seen = []

def test_first(): seen.append(least(2, 1))
def test_after(): assert not seen

def test_flaky():
    new = not os.path.exists("seen")
    open("seen", "w").close()
    assert not new

def test_broken(): assert least(2, 1) == 3

def test_slow():
    while time.process_time() < 1.3: least(2, 1)
"""
FIRST, AFTER, FLAKY, BROKEN, SLOW = (
    f"test_doubtful.py::test_{name}" for name in ("first", "after", "flaky", "broken", "slow")
)


class Reached(NamedTuple):
    """As if some tests had been measured."""

    tests: list[str]

    @property
    def seconds(self) -> dict[str, float]:
        return dict.fromkeys(self.tests, 0.0)

    def tests_of(self, path: str, lines: Sequence[int]) -> list[str]:
        return self.tests

    def importing(self, path: str, lines: Sequence[int]) -> set[str]:
        return set()


def test_what_is_not_confirmed_does_not_count(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A test that fails after another one; one that fails now and then; one that fails without a
    mutant; one that takes longer than it was measured to take."""
    monkeypatch.setattr("trial.SPARE", 0)
    (tree / "test_doubtful.py").write_text(DOUBTFUL)
    reached: Any = Reached([FIRST, AFTER, FLAKY, BROKEN, GREATER, SLOW])
    bench = mutants.Bench(tree, ["test_doubtful.py", "test_least.py"], reached, 60)
    results = [
        bench.try_mutant((mutant_of("a < b", new), TEXT))
        for new in ("a < b + 0", "a > b", "a < b or list(iter(int, 1))")
    ]
    bench.close()
    assert [result[:3] for result in results] == [
        ("survived", "", ""),
        ("killed", GREATER, "test_least.py:4: AssertionError: assert 2 == 1"),
        ("time", FIRST, "SIGXCPU"),
    ]
    broken = "test_doubtful.py:15: AssertionError: assert 1 == 3"
    assert results[0].doubts == {
        AFTER: "test_doubtful.py:8: AssertionError: assert not [1]; passes by itself",
        FLAKY: "test_doubtful.py:13: AssertionError: assert not True; passes by itself",
        BROKEN: f"{broken}; fails without a mutant: {broken}",
        SLOW: "SIGXCPU; passes by itself",
    }


def test_quickest_tests_come_within_the_budget() -> None:
    seconds = {"a": 0.5, "b": 1.5, "c": 2.0, "d": 9.0}
    assert mutants.within([*seconds], seconds, 60) == ["a", "b", "c", "d"]
    assert mutants.within([*seconds], seconds, 5) == ["a", "b", "c"]
    assert mutants.within([], seconds, 60) == []
