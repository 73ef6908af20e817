"""Change the kernel or `check/` in one place; does a test notice? `python -m tests.mutants`.

A sample of all mutants of `operators` is drawn by a seed. For each one, the tests that reach its
lines run in a copy of the checkout, the quickest first, until one fails; which these are is
measured once (`reach`). Mutants that are the same program, or one that differs in time alone, are
known by their lines in `equivalent_mutants.toml`, with the reason.

A test that takes three times as long as without the mutant, and 6 seconds more, notices it, too.
Seconds are those of the processor, so that it does not matter what else the machine does.
"""

import importlib
import json
import os
import resource
import shutil
import sys
import tempfile
import tomllib
from bisect import bisect_right
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from compileall import compile_dir
from itertools import accumulate
from math import ceil
from pathlib import Path
from py_compile import PycInvalidationMode
from random import Random
from typing import IO, NamedTuple

import click
import pytest
from rich.console import Console
from rich.progress import track

# The tests import one another by bare names, as pytest sets them up.
SUPPORT = str(Path(__file__).parent / "support")
sys.path.insert(0, SUPPORT)
from operators import Mutant, mutants_of  # noqa: E402
from reach import OPTIONS, measure  # noqa: E402

sys.path.remove(SUPPORT)  # what is tried is all in the copy

ROOT = Path(__file__).parent.parent
ROOMS = ("geometry", "procedures", "evidence", "check")
TESTS = (
    *(f"tests/{room}" for room in ROOMS),
    *(f"exactsweep/{room}" for room in ROOMS),
    "exactsweep/sweep.py",
)
NEEDED = ("exactsweep", "tests", "benchmarks", "pyproject.toml", "README.md", "LICENSE")
# By all tests; what is loaded before the tests are begun need not be loaded again.
LOADED = ("hypothesis.strategies", "rich.table", "rich.progress", "click.testing", "sympy", "numpy")
QUICK = 2  # seconds
MEMORY = 4 << 30
SPARE = 6  # seconds that any run may take more


class Result(NamedTuple):
    """What became of a mutant: the first test that failed, or why there is none."""

    mutant: Mutant
    verdict: str  # killed, time, survived, equivalent
    by: str
    seconds: float


def modules() -> list[Path]:
    """What is changed: the kernel and the checking side."""
    package = ROOT / "exactsweep"
    rooms = [path for room in ROOMS for path in sorted((package / room).glob("*.py"))]
    return [*rooms, package / "sweep.py"]


def every_mutant() -> list[tuple[Mutant, bytes]]:
    """All mutants of the kernel and of the checking side, each with the text of its module."""
    found = []
    for path in modules():
        text = path.read_bytes()
        found += [(m, text) for m in mutants_of(path.relative_to(ROOT).as_posix(), text)]
    return found


def read_equivalent() -> dict[tuple[str, str, str], str]:
    """Why mutants cannot be noticed, by module, line before and line after."""
    text = Path(__file__).with_name("equivalent_mutants.toml").read_text()
    return {
        (entry["path"], entry["before"], entry["after"]): entry["why"]
        for entry in tomllib.loads(text).get("mutant", [])
    }


def run_tests(
    tree: Path, tests: Sequence[str], seconds: Mapping[str, float]
) -> tuple[str, str, float]:
    """Run tests in a copy of the checkout, in their order, until one fails.

    Returns:
        The verdict, the test that failed, and the seconds of the processor.
    """
    begun = tree / "begun.txt"
    child = os.fork()
    if child == 0:
        status = 3  # unless it comes to an end
        try:
            output = os.open(os.devnull, os.O_WRONLY)
            os.dup2(output, 1)
            os.dup2(output, 2)
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            os.chdir(tree)
            os.environ["PYTHONPATH"] = str(tree)
            sys.dont_write_bytecode = True
            sys.path.insert(0, str(tree))
            files = dict.fromkeys(test.partition("::")[0] for test in tests)
            plugins = [_Chosen(tests, seconds, begun)]
            status = pytest.main([*OPTIONS, "-x", "--tb=no", *files], plugins=plugins)
        finally:
            os._exit(status)
    _, status, usage = os.wait4(child, 0)
    seconds_used = usage.ru_utime + usage.ru_stime
    shutil.rmtree(tree / ".hypothesis", ignore_errors=True)
    last = begun.read_text() if begun.exists() else "when modules are imported"
    begun.unlink(missing_ok=True)
    if os.WIFSIGNALED(status):
        return "time", last, seconds_used
    if os.WEXITSTATUS(status) == 0:
        return "survived", "", seconds_used
    return "killed", last, seconds_used


class _Chosen:
    """Runs only the chosen tests, and each of them for a limited time."""

    def __init__(self, tests: Sequence[str], seconds: Mapping[str, float], begun: Path) -> None:
        self._rank = {test: k for k, test in enumerate(tests)}
        self._seconds = seconds
        self._begun = begun
        self._limit(SPARE)

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        chosen = [item for item in items if item.nodeid in self._rank]
        items[:] = sorted(chosen, key=lambda item: self._rank[item.nodeid])

    def pytest_runtest_logstart(self, nodeid: str) -> None:
        self._begun.write_text(nodeid)
        self._limit(3 * self._seconds[nodeid] + SPARE)

    def _limit(self, seconds: float) -> None:
        used = resource.getrusage(resource.RUSAGE_SELF)
        limit = ceil(used.ru_utime + used.ru_stime + seconds)
        resource.setrlimit(resource.RLIMIT_CPU, (limit, resource.RLIM_INFINITY))


def try_mutants(
    sample: Sequence[tuple[Mutant, bytes]], budget: float, console: Console
) -> Iterator[Result]:
    """Try one mutant after the other in a copy of the checkout."""
    for name in LOADED:
        importlib.import_module(name)
    equivalent = read_equivalent()
    with tempfile.TemporaryDirectory() as folder:
        tree = Path(folder)
        for name in NEEDED:
            _copy(ROOT / name, tree / name)
        reach = measure(tree, TESTS, [path.relative_to(ROOT).as_posix() for path in modules()])
        compile_dir(tree, quiet=1, invalidation_mode=PycInvalidationMode.CHECKED_HASH)
        for mutant, text in track(sample, "mutants", console=console):
            before, after = mutant.shown(text)
            if why := equivalent.get((mutant.path, before, after)):
                yield Result(mutant, "equivalent", why, 0)
                continue
            (tree / mutant.path).write_bytes(mutant.applied(text))
            tests = reach.tests_of(mutant.path, mutant.lines(text))
            total = 0.0
            verdict, by = "survived", "" if tests else "no test reaches it"
            for wave in waves(tests, reach.seconds, budget):
                verdict, by, seconds = run_tests(tree, wave, reach.seconds)
                total += seconds
                if verdict != "survived":
                    break
            (tree / mutant.path).write_bytes(text)
            yield Result(mutant, verdict, by, round(total, 1))


def waves(tests: list[str], seconds: Mapping[str, float], budget: float) -> list[list[str]]:
    """The quickest tests, which need few files, and what else can be run within a budget."""
    until = list(accumulate(seconds[test] for test in tests))
    quick, last = (bisect_right(until, limit) for limit in (QUICK, budget))
    return [wave for wave in (tests[:quick], tests[quick:last]) if wave]


def _copy(source: Path, target: Path) -> None:
    if source.is_dir():
        shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__"))
    else:
        shutil.copy(source, target)


@click.command()
@click.option("--sample", default=500, show_default=True, help="How many mutants.")
@click.option("--seed", default=1, show_default=True)
@click.option("--first", default=0, show_default=True, help="Leave out so many of the sample.")
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
@click.option("--results", type=click.File("a"), help="A file to add results to, as JSON lines.")
def main(
    sample: int,
    seed: int,
    first: int,
    under: str,
    budget: float,
    results: IO[str] | None,
) -> None:
    """Try a sample of mutants; exit code 1 if one survives."""
    console = Console(stderr=True)
    path, _, line = under.partition(":")
    chosen = [
        (mutant, text)
        for mutant, text in every_mutant()
        if mutant.path.startswith(path) and line in ("", f"{mutant.line}")
    ]
    drawn = Random(seed).sample(chosen, min(sample, len(chosen)))[first:]
    texts = dict(drawn)
    counts: Counter[str] = Counter()
    for result in try_mutants(drawn, budget, console):
        counts[result.verdict] += 1
        before, after = result.mutant.shown(texts[result.mutant])
        place = f"{result.mutant.path}:{result.mutant.line}"
        if results is not None:
            fields = [place, before, after, *result[1:]]
            results.write(json.dumps(fields) + "\n")
            results.flush()
        if result.verdict == "survived":
            click.echo(f"{place}\n  - {before}\n  + {after}")
    matter = counts.total() - counts["equivalent"]
    noticed = counts["killed"] + counts["time"]
    click.echo(f"{len(drawn)} of {len(chosen)} mutants, seed {seed}: {dict(counts)}")
    click.echo(f"{noticed} of {matter} that matter are noticed")
    sys.exit(noticed < matter)


if __name__ == "__main__":
    main()
