"""The command that mutates the kernel: its operators, and its list of equivalent mutants."""

from pathlib import Path

import mutants
import pytest
from operators import mutants_of

MODULE = b'''"""A module."""

def least(a: int | None, b: int = 3) -> int:
    assert a is not None
    if not (a < b) and True:
        raise ValueError(f"{a + b}")
    b += -a
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
        "return max(a, b)",
    ]


def test_mutants_are_modules() -> None:
    for mutant in mutants_of("least.py", MODULE):
        compile(mutant.applied(MODULE), "least.py", "exec")
        assert mutant.applied(MODULE) != MODULE


def test_equivalent_mutants_are_mutants_and_have_reasons() -> None:
    known = mutants.read_equivalent()
    every = {(mutant.path, *mutant.shown(text)) for mutant, text in mutants.every_mutant()}
    assert known.keys() <= every
    assert all(reason.endswith(".") for reason in known.values())


def test_tests_that_name_a_module_come_first() -> None:
    stages = mutants.stages_of("exactsweep/check/size.py", "wider")
    assert stages[1] == ("tests/check/test_certificate_reading.py",)
    assert stages[2] == ("tests/check",)
    assert "tests/check" not in stages[3]


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        ("def test_it(): pass", "survived"),
        ("def test_it(): assert False", "killed"),
        ("import nothing_of_this_name", "killed"),
        ("def test_it():\n    while True: pass", "time"),
    ],
)
def test_verdicts(tmp_path: Path, text: str, verdict: str) -> None:
    (tmp_path / "test_it.py").write_text(text)
    (tmp_path / "pytest.ini").write_text("[pytest]\n")
    assert mutants.run_tests(tmp_path, ["test_it.py"], 2)[0] == verdict
