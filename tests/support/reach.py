"""Which tests reach which lines of the package: measured by `coverage`, a context for each test.

What is measured is kept with the temporary files of the machine, under a name that is made from the
text of all modules and tests, so that it is measured once for each state of them.
"""

import gc
import hashlib
import importlib
import json
import os
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from functools import _lru_cache_wrapper, cached_property
from pathlib import Path
from typing import Any

import pytest

OPTIONS = ("-q", "-n0", "-p", "no:cacheprovider", "--hypothesis-seed=0", "--assert=plain")
IMPORTED = ""  # the context of what runs when modules are imported


class Reach:
    """The tests that reach a line, by what was measured; paths are relative to the checkout."""

    def __init__(self, file: Path) -> None:
        from coverage import CoverageData

        self.seconds: dict[str, float] = json.loads(file.with_suffix(".json").read_text())
        self._data = CoverageData(basename=str(file))
        self._data.read()
        self._contexts: dict[str, dict[int, list[str]]] = {}

    @cached_property
    def _by_file(self) -> dict[str, list[str]]:
        found: dict[str, list[str]] = {}
        for test in self.seconds:
            found.setdefault(test.partition("::")[0], []).append(test)
        return found

    def tests_of(self, path: str, lines: Sequence[int]) -> list[str]:
        """The tests that reach any of the lines of a module, the quickest first.

        Those of a file of tests that reaches a line while it is read are among them. What runs when
        the package is imported may matter to any test: first to those that reach the module.
        """
        contexts = self._contexts_of(path, lines)
        is_global = IMPORTED in contexts
        if is_global:
            contexts = set().union(*self._contexts[path].values())
        near = self._tests_in(contexts)
        tests = self.seconds if is_global else near & self.seconds.keys()
        return sorted(tests, key=lambda test: (test not in near, self.seconds[test], test))

    def importing(self, path: str, lines: Sequence[int]) -> set[str]:
        """Those of them whose files run the lines when they are read."""
        contexts = self._contexts_of(path, lines)
        if IMPORTED in contexts:
            return {*self.seconds}
        return self._tests_in({context for context in contexts if "::" not in context})

    def _contexts_of(self, path: str, lines: Sequence[int]) -> set[str]:
        if path not in self._contexts:
            self._contexts[path] = self._data.contexts_by_lineno(path)
        return {context for line in lines for context in self._contexts[path].get(line, ())}

    def _tests_in(self, contexts: set[str]) -> set[str]:
        return {test for c in contexts for test in self._by_file.get(c, [c])}


def measure(tree: Path, tests: Sequence[str], modules: Sequence[str]) -> Reach:
    """Run tests in a copy of the checkout, unless that was done, and see what lines they reach."""
    digest = hashlib.sha256(repr((sys.version, tests, modules)).encode())
    for path in sorted(tree.rglob("*.py")):
        name = path.relative_to(tree).as_posix()
        if name.startswith(tuple(tests)) or not path.name.startswith("test_"):
            digest.update(repr((name, path.read_bytes())).encode())
    file = Path(tempfile.gettempdir()) / f"exactsweep-reach-{digest.hexdigest()[:16]}"
    if not file.with_suffix(".json").exists():
        child = os.fork()
        if child == 0:
            status = 3  # unless it comes to an end
            try:
                status = _measure_here(tree, tests, modules, file)
            finally:
                sys.stdout.flush()
                os._exit(status)
        _, status = os.waitpid(child, 0)
        if status:
            raise RuntimeError("tests fail without a mutant")
    return Reach(file)


def _measure_here(tree: Path, tests: Sequence[str], modules: Sequence[str], file: Path) -> int:
    from coverage import Coverage

    os.chdir(tree)
    sys.path.insert(0, str(tree))
    file.unlink(missing_ok=True)
    measured = Coverage(data_file=str(file), config_file=False, include=[*modules])
    measured.set_option("run:relative_files", True)
    measured.start()
    names = [path.removesuffix(".py").replace("/", ".") for path in modules]
    for name in names:
        importlib.import_module(name)
    recorder = _Recorder(measured, names)
    status = pytest.main([*OPTIONS, *tests], plugins=[recorder])
    measured.stop()
    measured.save()
    if status == 0:
        file.with_suffix(".json").write_text(json.dumps(recorder.seconds))
    return int(status)


class _Recorder:
    """Says which test runs, or which file of tests is read, and takes the seconds."""

    def __init__(self, measured: Any, names: Sequence[str]) -> None:
        self._measured = measured
        self._names = names
        self._caches: list[_lru_cache_wrapper[Any]] = []
        self.seconds: dict[str, float] = {}

    @pytest.hookimpl(wrapper=True)
    def pytest_make_collect_report(self, collector: pytest.Collector) -> Iterator[None]:
        reads = isinstance(collector, pytest.Module)
        self._measured.switch_context(collector.nodeid if reads else IMPORTED)
        return (yield)

    def pytest_collection_finish(self) -> None:
        self._measured.switch_context(IMPORTED)
        self._caches = [
            found
            for found in gc.get_objects()
            if isinstance(found, _lru_cache_wrapper) and found.__module__ in self._names
        ]

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        for found in self._caches:  # what an earlier test left there is reached by this one, too
            found.cache_clear()
        self._measured.switch_context(item.nodeid)
        start = time.process_time()
        result = yield
        self.seconds[item.nodeid] = time.process_time() - start
        self._measured.switch_context(IMPORTED)
        return result
