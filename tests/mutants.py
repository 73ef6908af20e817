"""Try mutants of packages or modules: `python -m tests.mutants PACKAGE...`.

mutmut creates the mutants and runs the tests of the package in a copy of the project; --tests adds
tests. A line whose change no test needs to detect ends with `# pragma: no mutate` and a reason.
"""

import shutil
import subprocess
import sys
from collections import Counter
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory

import click

ROOT = Path(__file__).parent.parent
COPIED = ("exactsweep", "tests", "benchmarks", "README.md", "LICENSE", "pyproject.toml")
SETTINGS = """[mutmut]
source_paths=exactsweep
only_mutate=
    {only}
also_copy=
    benchmarks
    README.md
    LICENSE
pytest_add_cli_args_test_selection=
    {tests}
pytest_add_cli_args=
    -n0
    -q
    -x
use_git_change_detection=False
"""
ELSEWHERE = {"canvas": "tests/draw"}
"""The folder of tests of each package that has none of its own."""
NOTICED = ("killed", "timeout", "segfault", "suspicious")


def find_files(package: str) -> list[str]:
    """List the modules of a package, or a single named module."""
    path = ROOT / "exactsweep" / package
    found = sorted(path.rglob("*.py")) if path.is_dir() else [path.with_suffix(".py")]
    if not found or not found[0].exists():
        raise click.BadParameter(f"exactsweep has no package and no module {package!r}")
    return [str(file.relative_to(ROOT)) for file in found]


def find_tests(package: str) -> str:
    """Return the folder with the tests of a package."""
    name = package.split("/")[0].removesuffix(".py")
    folder = ELSEWHERE.get(name, f"tests/{name}")
    return folder if (ROOT / folder).is_dir() else "tests"


def write_settings(packages: tuple[str, ...], tests: tuple[str, ...]) -> str:
    """Write the settings of mutmut for packages or modules."""
    only = [file for package in packages for file in find_files(package)]
    selected = tests or tuple(dict.fromkeys(map(find_tests, packages)))
    return SETTINGS.format(only="\n    ".join(only), tests="\n    ".join(selected))


def read_results(text: str) -> dict[str, str]:
    """Read the status of each mutant from the output of `mutmut results`."""
    lines = (line.strip().rpartition(": ") for line in text.splitlines())
    return {name: status for name, _, status in lines if name}


def run_mutmut(folder: Path, *arguments: str) -> str:
    done = subprocess.run(
        [sys.executable, "-m", "mutmut", *arguments],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    return done.stdout


@click.command()
@click.argument("packages", nargs=-1, required=True)
@click.option("--tests", multiple=True, help="Tests to run, in place of the package's own.")
@click.option("--sample", type=int, help="How many mutants; else all.")
@click.option("--seed", default=1, show_default=True, help="Of the sample.")
@click.option("--workers", default=1, show_default=True, help="How many processes.")
def main(
    packages: tuple[str, ...], tests: tuple[str, ...], sample: int | None, seed: int, workers: int
) -> None:
    """Print the surviving mutants of PACKAGES."""
    settings = write_settings(packages, tests)
    with TemporaryDirectory() as name:
        folder = Path(name)
        for part in COPIED:
            copy = shutil.copytree if (ROOT / part).is_dir() else shutil.copy
            copy(ROOT / part, folder / part)
        (folder / "setup.cfg").write_text(settings)
        # No mutant has this name: mutants are created, but not tried.
        output = run_mutmut(folder, "run", "none")
        every = sorted(read_results(run_mutmut(folder, "results", "--all", "true")))
        if not every:
            raise click.ClickException(output)
        chosen = every if sample is None else Random(seed).sample(every, min(sample, len(every)))
        output = run_mutmut(folder, "run", "--max-children", str(workers), *chosen)
        results = read_results(run_mutmut(folder, "results", "--all", "true"))
        statuses = Counter(results[mutant] for mutant in chosen)
        if not statuses.keys() - {"not checked"}:
            raise click.ClickException(output)
        for mutant in chosen:
            if results[mutant] not in NOTICED:
                click.echo(f"{results[mutant]}: {mutant}")
                click.echo(run_mutmut(folder, "show", mutant))
    noticed = sum(statuses[status] for status in NOTICED)
    click.echo(
        f"{' '.join(packages)}, seed {seed}: {noticed} of {len(chosen)} noticed, {dict(statuses)}"
    )


if __name__ == "__main__":
    main()
