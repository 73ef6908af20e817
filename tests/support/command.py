"""Functions that run the command line."""

import os
import re
import subprocess
import sysconfig
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

import click
from click.testing import CliRunner, Result

from exactsweep import sweep
from exactsweep.cli import main
from exactsweep.cli.pair import DIRECTRIX, GENERATRIX

ROOT = Path(__file__).parents[2]
HOUSE = str(Path(__file__).parent / "polygons" / "house.json")
NOTCH = str(Path(__file__).parent / "polygons" / "notch.wkt")
EXAMPLE = sweep(GENERATRIX, DIRECTRIX)
# Seconds to wait for an event that must occur, far longer than any machine needs.
PATIENCE = 600
SCRIPTS = sysconfig.get_path("scripts")
EXACTSWEEP = str(Path(SCRIPTS) / "exactsweep")


def run(*arguments: str, stdin: str | bytes | None = None) -> Result:
    return CliRunner().invoke(main, arguments, input=stdin)


def list_commands(group: click.Group = main, name: str = "") -> Iterator[tuple[str, click.Command]]:
    """Yield all commands with their names."""
    for word, command in group.commands.items():
        path = f"{name} {word}".strip()
        if isinstance(command, click.Group):
            yield from list_commands(command, path)
        else:
            yield path, command


def refusal(result: Result, code: int = 1) -> str:
    """Return the single line of an error."""
    assert result.exit_code == code
    assert result.stdout == ""
    assert re.fullmatch(r"Error: [^\n]+\n", result.stderr)
    return result.stderr.removeprefix("Error: ").removesuffix("\n")


def eventually(condition: Callable[[], object]) -> None:
    """Wait until a condition holds."""
    deadline = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < deadline
        time.sleep(0.01)


def processes(word: str) -> list[str]:
    """List the command lines of running processes that contain a word."""
    found = []
    for path in Path("/proc").glob("[0-9]*/cmdline"):
        with suppress(OSError):
            line = path.read_bytes().decode(errors="replace")
            if word in line:
                found.append(line)
    return found


def shell(command: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PATH": f"{SCRIPTS}{os.pathsep}{os.environ['PATH']}"}
    environment.pop("COLUMNS", None)
    return subprocess.run(
        ["bash", "-c", command], env=environment, capture_output=True, text=True, timeout=PATIENCE
    )
