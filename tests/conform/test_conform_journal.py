"""Journals of runs: written once, locked, resumed, and read from untrusted files."""

import resource
import sys
from pathlib import Path
from typing import Any

import pytest
from command import run
from judged import CORRECT, FAULTY, SQUARE, write_cases

from exactsweep import limits
from exactsweep.conform import Verdict
from exactsweep.conform.run.journal import Journal, JournalError
from exactsweep.conform.run.outcome import Outcome
from exactsweep.conform.run.process import Terms
from exactsweep.conform.run.protocol import Hello
from exactsweep.corpus import Case
from exactsweep.processes import lock

TWO = [Case.of(f"case-{k}", "", [(0, 0), (k + 1, 0), (0, 1)], SQUARE) for k in range(2)]


def journal_of(tmp_path: Path, *options: str, command: list[str] = CORRECT) -> Any:
    path = write_cases(tmp_path / "cases", TWO)
    journal = str(tmp_path / "journal")
    return run("conform", "--cases", path, "--journal", journal, *options, "--", *command)


def test_a_journal_is_not_overwritten(tmp_path: Path) -> None:
    assert journal_of(tmp_path).exit_code == 0
    before = (tmp_path / "journal").read_text()
    again = journal_of(tmp_path)
    assert (again.exit_code, again.stdout) == (1, "")
    assert "already exists; continue with --resume, or delete it" in again.stderr
    assert (tmp_path / "journal").read_text() == before
    assert journal_of(tmp_path, "--resume").exit_code == 0
    assert (tmp_path / "journal").read_text() == before


@pytest.mark.long
def test_a_journal_is_locked_by_one_run(tmp_path: Path) -> None:
    assert journal_of(tmp_path).exit_code == 0
    with (tmp_path / "journal").open("rb") as file:
        assert lock(file)
        second = journal_of(tmp_path, "--resume")
    assert (second.exit_code, second.stdout) == (1, "")
    assert second.stderr.endswith("journal: another run is writing to it\n")
    assert journal_of(tmp_path, "--resume").exit_code == 0


def test_a_full_disk_is_reported_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The rest of the buffer would fail again when the file is closed."""
    # An import under the limit would leave a truncated module.
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1024, hard))
    try:
        with pytest.raises(JournalError, match="journal: File too large") as done:
            write_journal(tmp_path / "journal")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert done.value.__cause__ is None


def write_journal(path: Path) -> None:
    with Journal(path, Terms([]), Hello("mine")) as journal:
        journal.add(Outcome("a", "CC", (), Verdict.WRONG, "why" * 1000))


def test_a_line_beyond_the_limit_is_not_read(tmp_path: Path) -> None:
    write_journal(tmp_path / "journal")
    with limits(max_mib=2000 / 2**20), pytest.raises(JournalError, match="line 2: not a"):
        Journal(tmp_path / "journal", Terms([]), Hello("mine"), resume=True)


@pytest.mark.long
def test_the_journal_of_another_run_is_rejected(tmp_path: Path) -> None:
    journal_of(tmp_path)
    other = journal_of(tmp_path, "--resume", command=[*FAULTY, "reversed"])
    assert "is the journal of a different command" in other.stderr
    assert "of a different timeout" in journal_of(tmp_path, "--resume", "--timeout", "3").stderr


@pytest.mark.parametrize(
    "text", ["[]\n", "{}\n", "x\n", '{"format": "exactsweep conform"}\n', "one line", "7" * 2**24]
)
def test_other_files_are_unchanged(tmp_path: Path, text: str) -> None:
    path = tmp_path / "journal"
    path.write_text(text)
    with pytest.raises(JournalError):
        Journal(path, Terms([]), Hello("mine"), resume=True)
    assert path.read_text() == text


@pytest.mark.long
def test_the_command_rejects_other_files(tmp_path: Path) -> None:
    (tmp_path / "journal").write_text("x\n")
    done = journal_of(tmp_path, "--resume")
    assert (done.exit_code, done.stdout) == (1, "")
    assert (tmp_path / "journal").read_text() == "x\n"


@pytest.mark.long
def test_a_changed_case_is_asked_again(tmp_path: Path) -> None:
    journal_of(tmp_path)
    changed = Case.of(TWO[0].id, "", [(0, 0), (9, 0), (0, 9)], SQUARE)
    path = write_cases(tmp_path / "cases", [changed, TWO[1]])
    journal = tmp_path / "journal"
    options = ("--cases", path, "--journal", str(journal), "--resume")
    assert run("conform", *options, "--", *CORRECT).exit_code == 0
    assert len(journal.read_text().splitlines()) == 4
