"""Change the kernel or `check/` in one place; does a test notice? `python -m tests.mutants`.

A sample of all mutants of `operators` is drawn by a seed. Each one first goes through a few pairs
of `small_campaign`; if it comes through, the tests run in a copy of the checkout until one fails,
those that name its module first, then those of its room. Mutants that are the same program, or one
that differs in time alone, are known by their lines in `equivalent_mutants.toml`, with the reason.

A test that takes three times as long as without the mutant, and 6 seconds more, notices it, too.
Seconds are those of the processor, so that it does not matter what else the machine does.
"""

import importlib
import json
import os
import re
import resource
import shutil
import signal
import sys
import tempfile
import tomllib
import traceback
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path
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

sys.path.remove(SUPPORT)  # what is tried is all in the copy

ROOT = Path(__file__).parent.parent
ROOMS = ("geometry", "procedures", "evidence", "check")
FEW = "a few pairs"  # instead of tests
PAIRS = 60
STAGES = ("pairs", "named", "room", "wider")
WIDER = ("tests/geometry", "tests/procedures", "tests/check", "tests/evidence")
NEEDED = ("exactsweep", "tests", "benchmarks", "pyproject.toml", "README.md", "LICENSE")
OPTIONS = (
    *("-q", "-x", "-n0", "-p", "no:cacheprovider"),
    *("--hypothesis-seed=0", "--tb=no", "--assert=plain"),
)
# By all tests; what is loaded before the tests are begun need not be loaded again.
LOADED = ("hypothesis.strategies", "rich.table", "rich.progress", "click.testing", "sympy")
MEMORY = 4 << 30
SPARE = 6  # seconds that any run may take more


class Result(NamedTuple):
    """What became of a mutant: the first test that failed, or why there is none."""

    mutant: Mutant
    verdict: str  # killed, time, survived, equivalent
    by: str
    seconds: float


def every_mutant() -> list[tuple[Mutant, bytes]]:
    """All mutants of the kernel and of the checking side, each with the text of its module."""
    package = ROOT / "exactsweep"
    paths = [path for room in ROOMS for path in sorted((package / room).glob("*.py"))]
    found = []
    for path in (*paths, package / "sweep.py"):
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


def stages_of(path: str, tests: str) -> list[tuple[str, ...]]:
    """What a mutant of a module goes through, in this order."""
    room = path.split("/")[1]
    own = f"tests/{room if room in ROOMS else 'evidence'}"
    others = tuple(folder for folder in WIDER if folder != own)
    stages = [(FEW,), tests_naming(path), (own,), others][: 1 + STAGES.index(tests)]
    return [stage for stage in stages if stage]


@cache
def tests_naming(path: str) -> tuple[str, ...]:
    """The tests of the room that import a module, or say its name."""
    *_, room, name = Path(path).with_suffix("").parts
    module = re.compile(rf"\b{room}(\.| import (.*\W)?){name}\b")
    files = (ROOT / "tests" / room).rglob("test_*.py")
    return tuple(
        sorted(f.relative_to(ROOT).as_posix() for f in files if module.search(f.read_text()))
    )


def run_tests(tree: Path, paths: Sequence[str], limit: float) -> tuple[str, str, float]:
    """Run tests in a copy of the checkout until one fails.

    Returns:
        The verdict, the test that failed, and the seconds of the processor.
    """
    output = tree / "output.txt"
    child = os.fork()
    if child == 0:
        with output.open("w") as written:
            os.dup2(written.fileno(), 1)
            os.dup2(written.fileno(), 2)
        seconds = int(limit) + 1
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        os.chdir(tree)
        os.environ["PYTHONPATH"] = str(tree)
        sys.dont_write_bytecode = True
        sys.path.insert(0, str(tree))
        status = 3  # unless it comes to an end
        try:
            status = _find_failure(tree) if paths == (FEW,) else pytest.main([*OPTIONS, *paths])
        except BaseException:
            traceback.print_exc()
        finally:
            sys.stdout.flush()
            sys.stderr.flush()
            os._exit(status)
    _, status, usage = os.wait4(child, 0)
    seconds_used = usage.ru_utime + usage.ru_stime
    shutil.rmtree(tree / ".hypothesis", ignore_errors=True)
    if os.WIFSIGNALED(status):
        return "time", signal.Signals(os.WTERMSIG(status)).name, seconds_used
    if os.WEXITSTATUS(status) == 0:
        return "survived", "", seconds_used
    lines = output.read_text(errors="replace").splitlines()
    failed = [line.split(" - ")[0] for line in lines if line.startswith(("FAILED", "ERROR"))]
    return "killed", (failed or lines[-1:] or [""])[0], seconds_used


def _find_failure(tree: Path) -> int:
    sys.path[:0] = [str(tree / "tests"), str(tree / "tests/support")]
    campaign = importlib.import_module("small_campaign")
    failure = campaign.find_failure(1, PAIRS)
    print(failure)
    return bool(failure)


def try_mutants(
    sample: Sequence[tuple[Mutant, bytes]], tests: str, console: Console
) -> Iterator[Result]:
    """Try one mutant after the other in a copy of the checkout."""
    for name in LOADED:
        importlib.import_module(name)
    equivalent = read_equivalent()
    with tempfile.TemporaryDirectory() as folder:
        tree = Path(folder)
        for name in NEEDED:
            _copy(ROOT / name, tree / name)
        limits: dict[tuple[str, ...], float] = {}
        for mutant, text in track(sample, "mutants", console=console):
            before, after = mutant.shown(text)
            if why := equivalent.get((mutant.path, before, after)):
                yield Result(mutant, "equivalent", why, 0)
                continue
            total = 0.0
            for paths in stages_of(mutant.path, tests):
                if paths not in limits:
                    verdict, by, seconds = run_tests(tree, paths, 3600)
                    if verdict != "survived":
                        raise click.ClickException(f"without a mutant: {by}")
                    limits[paths] = 3 * seconds + SPARE
                (tree / mutant.path).write_bytes(mutant.applied(text))
                verdict, by, seconds = run_tests(tree, paths, limits[paths])
                (tree / mutant.path).write_bytes(text)
                total += seconds
                if verdict != "survived":
                    break
            yield Result(mutant, verdict, by, round(total, 1))


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
    "--tests",
    type=click.Choice(STAGES),
    default="room",
    show_default=True,
    help="How far to go with what survives: pairs, tests that name it, its room, all rooms.",
)
@click.option("--results", type=click.File("a"), help="A file to add results to, as JSON lines.")
def main(
    sample: int,
    seed: int,
    first: int,
    under: str,
    tests: str,
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
    for result in try_mutants(drawn, tests, console):
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
