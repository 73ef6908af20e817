"""Change the kernel or `check/` in one place; does a test notice? `python -m tests.mutants`.

A sample of all mutants of `operators` is drawn by a seed. For each one, the tests that reach its
lines run in a copy of the checkout, the quickest first, until one fails; which these are is
measured once (`reach`). Mutants that are the same program, or one that differs in time alone, are
known by their lines in `equivalent_mutants.toml`, with the reason.

A test that takes three times as long as without the mutant, and 3 seconds more, notices it, too.
Seconds are those of the processor, so that it does not matter what else the machine does.
"""

import importlib
import json
import shutil
import sys
import tempfile
import tomllib
from bisect import bisect_right
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from compileall import compile_dir
from itertools import accumulate
from pathlib import Path
from py_compile import PycInvalidationMode
from random import Random
from typing import IO, NamedTuple

import click
from rich.console import Console
from rich.progress import track

# The tests import one another by bare names, as pytest sets them up.
SUPPORT = str(Path(__file__).parent / "support")
sys.path.insert(0, SUPPORT)
from operators import Mutant, mutants_of  # noqa: E402
from reach import Reach, measure  # noqa: E402
from trial import Reader, Trial, run_afresh  # noqa: E402

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
        compile_dir(tree, quiet=1, invalidation_mode=PycInvalidationMode.CHECKED_HASH)
        reach = measure(tree, TESTS, [path.relative_to(ROOT).as_posix() for path in modules()])
        reader = Reader(tree, TESTS, reach.seconds)
        for mutant, text in track(sample, "mutants", console=console):
            before, after = mutant.shown(text)
            if why := equivalent.get((mutant.path, before, after)):
                yield Result(mutant, "equivalent", why, 0)
                continue
            (tree / mutant.path).write_bytes(mutant.applied(text))
            yield Result(mutant, *_try_mutant(mutant, text, tree, reach, reader, budget))
            (tree / mutant.path).write_bytes(text)
        reader.close()


def _try_mutant(
    mutant: Mutant, text: bytes, tree: Path, reach: Reach, reader: Reader, budget: float
) -> Trial:
    """First the tests for which a function can be changed, then those that import the change."""
    lines = mutant.lines(text)
    tests = within(reach.tests_of(mutant.path, lines), reach.seconds, budget)
    if not tests:
        return Trial("survived", "no test reaches it", 0)
    importing = reach.importing(mutant.path, lines)
    running = [test for test in tests if test not in importing]
    found = reader.run(mutant, text, running) if running else Trial("survived", "", 0)
    if found is None:
        return run_afresh(tree, tests, reach.seconds)
    if found.verdict == "survived" and len(running) < len(tests):
        rest = [test for test in tests if test in importing]
        return run_afresh(tree, rest, reach.seconds)
    return found


def within(tests: list[str], seconds: Mapping[str, float], budget: float) -> list[str]:
    """As many of the tests as take so many seconds."""
    until = list(accumulate(seconds[test] for test in tests))
    return tests[: bisect_right(until, budget)]


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
