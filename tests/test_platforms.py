"""Messages on systems without a feature, and metadata of the package."""

import importlib
import os
import signal
import sys
import tomllib
from pathlib import Path

import pytest
from click import ClickException

from exactsweep import __version__
from exactsweep.conform.run.outcome import stop_after
from exactsweep.processes import ChildProcess

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]


def test_programs_need_process_groups(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.delattr(os, "killpg")
    with pytest.raises(OSError, match="cannot run programs on this system"):
        ChildProcess([sys.executable, "-c", "pass"])


def test_without_alarms_nothing_is_stopped(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(signal, "SIGPROF")
    with stop_after(1e-9):
        assert sum(range(10**5)) == 4999950000


def test_benchmarks_start_without_accounting_of_ended_processes(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, "resource", None)
    for name in ("benchmarks.batches", "benchmarks.clock"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    batches = importlib.import_module("benchmarks.batches")
    assert importlib.import_module("benchmarks.clock").peak
    with pytest.raises(ClickException, match=r"is only available on POSIX systems$"):
        next(batches.tabulate(workers=1, quick=True))


def test_the_metadata_is_consistent() -> None:
    assert PROJECT["version"] == __version__
    assert PROJECT["requires-python"] == ">=3.11"
    versions = [c.rsplit(" ", 1)[1] for c in PROJECT["classifiers"] if ":: Python :: 3." in c]
    assert versions == ["3.11", "3.12", "3.13"]
    cited = (ROOT / "exactsweep" / "paper" / "CITATION.cff").read_text("utf-8")
    assert f"\nversion: {__version__}\n" in cited
    assert f"\n### {__version__}\n" in (ROOT / "exactsweep" / "PROJECT.md").read_text("utf-8")
