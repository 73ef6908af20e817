"""A process that has read all tests, and runs them against one mutant after the other.

Functions get the code of the mutant in a copy of the process, so that a mutant costs no more than
its tests. What it finds is only a hint where to look: see `trial`.
"""

import ast
import gc
import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from pathlib import Path
from types import CodeType, FunctionType
from typing import NoReturn

import pytest
from operators import Mutant
from trial import FIRST, SPARE, Trial, Watch, enter, limit_memory


class Reader:
    """A process that has read all tests, and is copied for each mutant."""

    def __init__(self, tree: Path, tests: Sequence[str], seconds: Mapping[str, float]) -> None:
        self._end, theirs = Pipe()
        self._child = os.fork()
        if self._child == 0:
            try:
                self._end.close()
                enter(tree)
                watch = Watch(tree, seconds)
                pytest.main([*FIRST, *tests], plugins=[watch, _Copies(tree, watch, theirs)])
            finally:
                os._exit(1)
        theirs.close()
        # Until then nobody may change a file: what is read with a mutant fails for all that follow.
        self._end.recv()

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

    def __init__(self, tree: Path, watch: Watch, asked: Connection) -> None:
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
        self._asked.send(len(known))
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
            limit_memory()
            with suppress(session.Failed):
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
