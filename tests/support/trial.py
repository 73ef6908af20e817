"""Run chosen tests against a mutant, in a copy of the checkout, until one fails; and confirm it.

What fails counts if it fails by itself, in a process that has not imported the package before, on
the module as it is written with the mutant; and passes there, in the same seconds, without it.
"""

import gc
import json
import os
import resource
import shutil
import signal
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from math import ceil
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from operators import Mutant
from reach import OPTIONS

MEMORY = 4 << 30
SPARE = 3  # seconds that any test may take more
ALONE = 60  # seconds for a test that is not known yet
FIRST = (*OPTIONS, "-x", "--tb=no")


class Trial(NamedTuple):
    """Whether tests noticed: killed, time or survived; the test that did, how, and the seconds."""

    verdict: str
    by: str
    why: str
    seconds: float

    def find_test(self, tests: Sequence[str]) -> str:
        """The one of the tests that noticed, or the first of those whose file cannot be read."""
        return self.by if self.by in tests else next(t for t in tests if t.startswith(self.by))


class Watch:
    """Notes which test is begun, and how it fails; limits its time."""

    def __init__(self, tree: Path, seconds: Mapping[str, float]) -> None:
        self._noted = tree / "noted.json"
        self._seconds = seconds

    def limit(self, seconds: float) -> None:
        """Let this process have so many more seconds of the processor."""
        used = resource.getrusage(resource.RUSAGE_SELF)
        limit = ceil(used.ru_utime + used.ru_stime + seconds)
        resource.setrlimit(resource.RLIMIT_CPU, (limit, resource.RLIM_INFINITY))

    def note(self, test: str, why: str) -> None:
        """Write down what the process is about."""
        self._noted.write_text(json.dumps([test, why]))

    def pytest_runtest_logstart(self, nodeid: str) -> None:
        self.note(nodeid, "")
        self.limit(3 * self._seconds.get(nodeid, ALONE) + SPARE)

    def pytest_exception_interact(
        self, node: pytest.Item | pytest.Collector, call: pytest.CallInfo[Any]
    ) -> None:
        if call.excinfo is not None:
            entry, (line, *_) = call.excinfo.traceback[-1], call.excinfo.exconly().splitlines()
            self.note(node.nodeid, f"{Path(entry.path).name}:{entry.lineno + 1}: {line}")

    def await_end(self, child: int) -> Trial:
        """What became of a process that runs tests."""
        _, status, usage = os.wait4(child, 0)
        by, why = json.loads(self._noted.read_text()) if self._noted.exists() else ("", "")
        self._noted.unlink(missing_ok=True)
        shutil.rmtree(self._noted.parent / ".hypothesis", ignore_errors=True)
        used = round(usage.ru_utime + usage.ru_stime, 1)
        if os.WIFSIGNALED(status):
            name = signal.Signals(os.WTERMSIG(status)).name
            return Trial("time" if name == "SIGXCPU" else "killed", by, name, used)
        if status == 0:
            return Trial("survived", "", "", used)
        return Trial("killed", by, why or f"exit code {os.WEXITSTATUS(status)}", used)


class _Choice:
    """Runs only chosen tests, in their order."""

    def __init__(self, tests: Sequence[str]) -> None:
        self._tests = tests

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        known = {item.nodeid: item for item in items}
        items[:] = [known[test] for test in self._tests]


def run_afresh(tree: Path, tests: Sequence[str], seconds: Mapping[str, float]) -> Trial:
    """Run tests in their order, all being imported from the copy of the checkout."""
    watch = Watch(tree, seconds)
    child = os.fork()
    if child == 0:
        status = 3  # unless it comes to an end
        try:
            enter(tree)
            watch.limit(ALONE)  # for reading them
            limit_memory()
            files = dict.fromkeys(test.partition("::")[0] for test in tests)
            status = pytest.main([*FIRST, *files], plugins=[watch, _Choice(tests)])
        finally:
            os._exit(status)
    return watch.await_end(child)


def enter(tree: Path) -> None:
    """Make a copy of this process one that runs tests of a copy of the checkout."""
    gc.freeze()  # else the end of a run of tests looks through all that this process has
    output = os.open(os.devnull, os.O_WRONLY)
    os.dup2(output, 1)
    os.dup2(output, 2)
    os.chdir(tree)
    os.environ["PYTHONPATH"] = str(tree)
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(tree))
    _draw_alike()


def limit_memory() -> None:
    """End with a MemoryError what takes more."""
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def _draw_alike() -> None:
    """Have hypothesis draw the same examples, whatever else is loaded and has been changed.

    It takes numbers from the text of all modules that are loaded, mutants as well.
    """
    from hypothesis.internal.conjecture import providers
    from hypothesis.internal.constants_ast import Constants

    nothing = Constants()
    providers._get_local_constants = lambda: nothing


@contextmanager
def written(tree: Path, mutant: Mutant, text: bytes) -> Iterator[None]:
    """Have the mutant in the file of its module, for a while."""
    module = tree / mutant.path
    module.write_bytes(mutant.applied(text))
    try:
        yield
    finally:
        module.write_bytes(text)


class Jury:
    """Confirms that tests notice a mutant, each by itself, as they do not without it."""

    def __init__(self, tree: Path) -> None:
        self._tree = tree
        self._alone: dict[str, Trial] = {}

    def confirm(self, mutant: Mutant, text: bytes, test: str) -> Trial:
        """What a test finds by itself; "survived" where the mutant is not the reason."""
        if test not in self._alone:
            self._alone[test] = run_afresh(self._tree, [test], {})
        alone = self._alone[test]
        if alone.verdict != "survived":
            return Trial("survived", test, f"fails without a mutant: {alone.why}", 0)
        with written(self._tree, mutant, text):
            found = run_afresh(self._tree, [test], {test: alone.seconds})
        if found.verdict == "survived":
            return Trial("survived", test, "passes by itself", found.seconds)
        return found._replace(by=test)
