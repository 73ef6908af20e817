"""Run chosen tests against a mutant, in a copy of the checkout, until one fails.

Functions get the code of the mutant in a copy of a process that has read all tests, so that a
mutant costs no more than its tests. What runs when modules or tests are imported is imported anew.
"""

import ast
import gc
import os
import resource
import shutil
import sys
from collections.abc import Iterator, Mapping, Sequence
from math import ceil
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from pathlib import Path
from types import CodeType, FunctionType
from typing import NamedTuple, NoReturn

import pytest
from operators import Mutant
from reach import OPTIONS

MEMORY = 4 << 30
SPARE = 3  # seconds that any test may take more
FIRST = (*OPTIONS, "-x", "--tb=no")


class Trial(NamedTuple):
    """Whether tests noticed: killed, time or survived; the test that did, and the seconds."""

    verdict: str
    by: str
    seconds: float


class _Watch:
    """Writes down which test is begun, and limits its time."""

    def __init__(self, tree: Path, seconds: Mapping[str, float]) -> None:
        self._begun = tree / "begun.txt"
        self._seconds = seconds

    def limit(self, seconds: float) -> None:
        used = resource.getrusage(resource.RUSAGE_SELF)
        limit = ceil(used.ru_utime + used.ru_stime + seconds)
        resource.setrlimit(resource.RLIMIT_CPU, (limit, resource.RLIM_INFINITY))

    def pytest_runtest_logstart(self, nodeid: str) -> None:
        self._begun.write_text(nodeid)
        self.limit(3 * self._seconds[nodeid] + SPARE)

    def await_end(self, child: int) -> Trial:
        _, status, usage = os.wait4(child, 0)
        by = self._begun.read_text() if self._begun.exists() else "when modules are imported"
        self._begun.unlink(missing_ok=True)
        shutil.rmtree(self._begun.parent / ".hypothesis", ignore_errors=True)
        used = round(usage.ru_utime + usage.ru_stime, 1)
        if os.WIFSIGNALED(status):
            return Trial("time", by, used)
        return Trial("survived", "", used) if status == 0 else Trial("killed", by, used)


class _Choice:
    """Runs only chosen tests, in their order."""

    def __init__(self, tests: Sequence[str]) -> None:
        self._tests = tests

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        known = {item.nodeid: item for item in items}
        items[:] = [known[test] for test in self._tests if test in known]


def run_afresh(tree: Path, tests: Sequence[str], seconds: Mapping[str, float]) -> Trial:
    """Run tests in their order, all being imported from the copy of the checkout."""
    watch = _Watch(tree, seconds)
    child = os.fork()
    if child == 0:
        status = 3  # unless it comes to an end
        try:
            _enter(tree)
            watch.limit(SPARE)
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            files = dict.fromkeys(test.partition("::")[0] for test in tests)
            status = pytest.main([*FIRST, *files], plugins=[watch, _Choice(tests)])
        finally:
            os._exit(status)
    return watch.await_end(child)


def _enter(tree: Path) -> None:
    gc.freeze()  # else the end of a run of tests looks through all that this process has
    output = os.open(os.devnull, os.O_WRONLY)
    os.dup2(output, 1)
    os.dup2(output, 2)
    os.chdir(tree)
    os.environ["PYTHONPATH"] = str(tree)
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(tree))


class Reader:
    """A process that has read all tests, and is copied for each mutant."""

    def __init__(self, tree: Path, tests: Sequence[str], seconds: Mapping[str, float]) -> None:
        self._end, theirs = Pipe()
        self._child = os.fork()
        if self._child == 0:
            try:
                self._end.close()
                _enter(tree)
                watch = _Watch(tree, seconds)
                pytest.main([*FIRST, *tests], plugins=[watch, _Copies(tree, watch, theirs)])
            finally:
                os._exit(1)
        theirs.close()

    def close(self) -> None:
        """End the process."""
        self._end.close()
        os.waitpid(self._child, 0)

    def run(self, mutant: Mutant, text: bytes, tests: Sequence[str]) -> Trial | None:
        """Run tests in their order; None where a mutant is not in the code of a function."""
        self._end.send((mutant, text, tests))
        found: Trial | None = self._end.recv()
        return found


class _Copies:
    """Instead of running what was read: runs what is asked for, in copies of the process."""

    def __init__(self, tree: Path, watch: _Watch, asked: Connection) -> None:
        self._tree = tree
        self._watch = watch
        self._asked = asked
        self._is_copy = False

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool | None:
        if self._is_copy or session.testsfailed:
            return None
        known = {item.nodeid: item for item in session.items}
        functions = [found for found in gc.get_objects() if isinstance(found, FunctionType)]
        gc.freeze()
        while True:
            try:
                mutant, text, tests = self._asked.recv()
            except EOFError:
                return True
            code = function_code(mutant, text, str(self._tree / mutant.path))
            changed = [f for f in functions if code is not None and _is_same(f.__code__, code)]
            if code is None or not changed:
                self._asked.send(None)
                continue
            child = os.fork()
            if child == 0:
                for function in changed:
                    function.__code__ = code
                session.items[:] = [known[test] for test in tests]
                self._run_copy(session)
            self._asked.send(self._watch.await_end(child))

    def _run_copy(self, session: pytest.Session) -> NoReturn:
        self._is_copy = True
        status = 3
        try:
            self._watch.limit(SPARE)
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            session.config.hook.pytest_runtestloop(session=session)
            status = int(session.testsfailed > 0)
        finally:
            os._exit(status)


def function_code(mutant: Mutant, text: bytes, file: str) -> CodeType | None:
    """The code of the outermost function whose body has the change, if there is one."""
    for node in ast.walk(ast.parse(text)):
        if not isinstance(node, ast.FunctionDef):
            continue
        if node.body[0].lineno <= mutant.line <= (node.end_lineno or 0):
            first = min([node.lineno, *(line.lineno for line in node.decorator_list)])
            codes = _codes(compile(mutant.applied(text), file, "exec"))
            return next(
                code for code in codes if (code.co_firstlineno, code.co_name) == (first, node.name)
            )
    return None


def _codes(code: CodeType) -> Iterator[CodeType]:
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _codes(constant)


def _is_same(old: CodeType, new: CodeType) -> bool:
    """Whether one is to take the place of the other, which needs the same closure."""
    return (old.co_filename, old.co_firstlineno, old.co_qualname, old.co_freevars) == (
        new.co_filename,
        new.co_firstlineno,
        new.co_qualname,
        new.co_freevars,
    )
