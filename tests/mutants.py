"""Change the kernel or `check/` in one place; does a test notice? `python -m tests.mutants`.

A sample of all mutants of `operators` is drawn by a seed. For each one, the tests that reach its
lines run in a copy of the checkout, the quickest first, until one fails (`reader`); which these are
is measured once (`reach`). A failure counts if it is confirmed (`trial`); if it is not, the next
tests have their turn. Mutants that are the same program, or one that differs in time alone, are
known by their lines in `equivalent_mutants.toml`, with the reason.

A test that takes three times as long as without the mutant, and 3 seconds more, notices it, too.
Seconds are those of the processor, so that it does not matter what else the machine does.
"""

import importlib
import json
import os
import shutil
import sys
import tempfile
import tomllib
from bisect import bisect_right
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from compileall import compile_dir
from concurrent.futures import ProcessPoolExecutor
from itertools import accumulate
from multiprocessing import get_context
from pathlib import Path
from py_compile import PycInvalidationMode
from random import Random
from typing import NamedTuple

import click
from rich.console import Console
from rich.progress import track

# The tests import one another by bare names, as pytest sets them up.
SUPPORT = str(Path(__file__).parent / "support")
sys.path.insert(0, SUPPORT)
from operators import Mutant, mutants_of  # noqa: E402
from reach import Reach, measure  # noqa: E402
from reader import Reader  # noqa: E402
from trial import Jury, Trial, run_afresh, written  # noqa: E402

sys.path.remove(SUPPORT)  # what is tried is all in the copy

ROOT = Path(__file__).parent.parent
ROOMS = ("numbers", "geometry", "procedures", "evidence", "check")
TESTS = (
    *(f"tests/{room}" for room in ROOMS),
    *(f"exactsweep/{room}" for room in ROOMS),
    "exactsweep/sweep.py",
)
NEEDED = ("exactsweep", "tests", "benchmarks", "pyproject.toml", "README.md", "LICENSE")
# By all tests; what is loaded before the tests are begun need not be loaded again.
LOADED = ("hypothesis.strategies", "rich.table", "rich.progress", "click.testing", "sympy", "numpy")

Changed = tuple[Mutant, bytes]  # with the text of its module
_Run = Callable[[Changed, Sequence[str]], Trial]


class Result(NamedTuple):
    """What became of a mutant: the test that notices it, and how, or why none does."""

    verdict: str  # killed, time, survived, equivalent
    by: str
    why: str
    seconds: float
    doubts: dict[str, str]  # the tests whose failure was not confirmed, and why

    @property
    def is_noticed(self) -> bool:
        """Whether a test fails, or takes too long."""
        return self.verdict in ("killed", "time")


# What is changed: the kernel and the checking side.
MODULES = [
    *(
        path.relative_to(ROOT).as_posix()
        for room in ROOMS
        for path in sorted((ROOT / "exactsweep" / room).glob("*.py"))
    ),
    "exactsweep/sweep.py",
]


def every_mutant() -> list[Changed]:
    """All mutants of the kernel and of the checking side, each with the text of its module."""
    texts = {path: (ROOT / path).read_bytes() for path in MODULES}
    return [(m, text) for path, text in texts.items() for m in mutants_of(path, text)]


def read_equivalent() -> dict[tuple[str, str, str], tuple[str, int]]:
    """Why mutants cannot be noticed, by module, line before and line after; and how many it is of.

    A line that is there several times has several mutants that look alike.
    """
    text = Path(__file__).with_name("equivalent_mutants.toml").read_text()
    return {
        (entry["path"], entry["before"], entry["after"]): (entry["why"], entry.get("times", 1))
        for entry in tomllib.loads(text).get("mutant", [])
    }


class Bench:
    """A copy of the checkout, in which mutants are tried one after the other."""

    def __init__(self, tree: Path, tests: Sequence[str], reach: Reach, budget: float) -> None:
        self._tree = tree
        self._reach = reach
        self._budget = budget
        self._jury = Jury(tree)
        self._reader = Reader(tree, tests, reach.seconds)
        self._equivalent = read_equivalent()

    def try_mutant(self, changed: Changed) -> Result:
        """First the tests for which a function can be changed, then those that import it."""
        mutant, text = changed
        known = self._equivalent.get((mutant.path, *mutant.shown(text)))
        if known is not None:
            return Result("equivalent", "", known[0], 0, {})
        lines, reach = mutant.lines(text), self._reach
        tests = within(reach.tests_of(mutant.path, lines), reach.seconds, self._budget)
        importing = reach.importing(mutant.path, lines)
        doubts: dict[str, str] = {}
        for run, chosen in (
            (self._run_read, [test for test in tests if test not in importing]),
            (self._run_written, [test for test in tests if test in importing]),
        ):
            if found := self._find(changed, chosen, run, doubts):
                return Result(*found, doubts)
        return Result("survived", "", "" if tests else "no test reaches it", 0, doubts)

    def close(self) -> None:
        """End what runs."""
        self._reader.close()

    def _find(
        self, changed: Changed, tests: Sequence[str], run: _Run, doubts: dict[str, str]
    ) -> Trial | None:
        """What is confirmed first; what is not goes to the doubts."""
        mutant, text = changed
        while tests := [test for test in tests if test not in doubts]:
            with written(self._tree, mutant, text):
                hint = run(changed, tests)
            if hint.verdict == "survived":
                return None
            test = hint.find_test(tests)
            found = self._jury.confirm(mutant, text, test)
            if found.verdict != "survived":
                return found
            doubts[test] = f"{hint.why}; {found.why}"
            if hint.by == test:  # the ones before have passed
                tests = tests[tests.index(test) :]
        return None

    def _run_read(self, changed: Changed, tests: Sequence[str]) -> Trial:
        return self._reader.run(*changed, tests) or self._run_written(changed, tests)

    def _run_written(self, _: Changed, tests: Sequence[str]) -> Trial:
        return run_afresh(self._tree, tests, self._reach.seconds)


def within(tests: list[str], seconds: Mapping[str, float], budget: float) -> list[str]:
    """As many of the tests as take so many seconds."""
    until = list(accumulate(seconds[test] for test in tests))
    return tests[: bisect_right(until, budget)]


def copy_checkout(tree: Path) -> None:
    """Copy what tests need, compiled."""
    for name in NEEDED:
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, tree / name, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            tree.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, tree / name)
    compile_dir(tree, quiet=1, invalidation_mode=PycInvalidationMode.CHECKED_HASH)


_benches: list[Bench] = []  # in a process of its own: one


def _set_up(folder: str, budget: float) -> None:
    tree = Path(folder) / f"{os.getpid()}"
    copy_checkout(tree)
    _benches.append(Bench(tree, TESTS, measure(tree, TESTS, MODULES), budget))


def _try_mutant(changed: Changed) -> Result:
    return _benches[0].try_mutant(changed)


def try_mutants(sample: Sequence[Changed], budget: float, workers: int) -> Iterator[Result]:
    """Try mutants, each in one of some copies of the checkout."""
    for name in LOADED:
        importlib.import_module(name)
    with tempfile.TemporaryDirectory() as folder:
        copy_checkout(Path(folder) / "measured")
        measure(Path(folder) / "measured", TESTS, MODULES)
        with ProcessPoolExecutor(
            workers, get_context("fork"), _set_up, (folder, budget)
        ) as executor:
            yield from executor.map(_try_mutant, sample)


@click.command()
@click.option("--sample", default=500, show_default=True, help="How many mutants.")
@click.option("--seed", default=1, show_default=True)
@click.option(
    "--under",
    default="exactsweep",
    show_default=True,
    help="Only there: a folder, a module, or MODULE:LINE.",
)
@click.option(
    "--budget",
    default=60.0,
    show_default=True,
    help="Seconds of tests that a mutant goes through, the quickest first.",
)
@click.option("--workers", default=os.cpu_count(), show_default=True)
@click.option(
    "--results",
    type=click.Path(dir_okay=False, path_type=Path),
    help="A file of results, as JSON lines; what is noticed there is not tried again.",
)
def main(
    sample: int, seed: int, under: str, budget: float, workers: int, results: Path | None
) -> None:
    """Try a sample of mutants; exit code 1 if one survives."""
    path, _, line = under.partition(":")
    chosen = [
        (mutant, text)
        for mutant, text in every_mutant()
        if mutant.path.startswith(path) and line in ("", f"{mutant.line}")
    ]
    drawn = {
        (f"{mutant.path}:{mutant.line}", *mutant.shown(text)): (mutant, text)
        for mutant, text in Random(seed).sample(chosen, min(sample, len(chosen)))
    }
    known: dict[tuple[str, ...], Result] = {}
    if results is not None and results.exists():
        for row in map(json.loads, results.read_text().splitlines()):
            known[tuple(row[:3])] = Result(*row[3:])
    found = {key: known[key] for key in drawn if key in known and known[key].is_noticed}
    left = [key for key in drawn if key not in found]
    tried = try_mutants([drawn[key] for key in left], budget, workers)
    shown = track(tried, "mutants", len(left), console=Console(stderr=True))
    for key, result in zip(left, shown, strict=True):
        found[key] = result
        if results is not None:
            with results.open("a") as file:
                file.write(json.dumps([*key, *result]) + "\n")
    sys.exit(report(found))


def report(found: Mapping[tuple[str, str, str], Result]) -> bool:
    """Say what survives, what was not confirmed, and the score; whether anything survives."""
    counts = Counter(result.verdict for result in found.values())
    for (place, before, after), result in found.items():
        if result.verdict == "survived":
            click.echo(f"{place}\n  - {before}\n  + {after}")
    doubts = Counter(f"{test}: {why}" for r in found.values() for test, why in r.doubts.items())
    for doubt, times in doubts.most_common():
        click.echo(f"not counted, {times} times: {doubt}")
    matter = counts.total() - counts["equivalent"]
    noticed = sum(result.is_noticed for result in found.values())
    click.echo(f"{len(found)} mutants: {dict(counts)}")
    click.echo(f"{noticed} of {matter} that matter are noticed")
    return noticed < matter


if __name__ == "__main__":
    if os.environ.get("PYTHONHASHSEED") != "0":  # what a set yields first is no reason to fail
        os.execve(sys.executable, sys.orig_argv, {**os.environ, "PYTHONHASHSEED": "0"})
    main()
