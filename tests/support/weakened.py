"""The standalone checker with one condition dropped, and whether a test fails."""

from __future__ import annotations

import ast
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory

from exactsweep.check import standalone

TESTS = tuple(
    f"tests/check/test_{name}.py"
    for name in (
        "standalone_layouts",
        "rounded",
        "standalone",
        "regions",
        "certificate_reading",
        "sums_with_paths",
    )
)


def list_weakened(source: str) -> Iterator[tuple[int, str]]:
    """List the sources in which one condition of the checker always holds, with the line."""
    lines = source.splitlines()
    for node in ast.walk(ast.parse(source)):
        is_need = isinstance(node, ast.Call) and ast.unparse(node.func) == "need"
        if is_need or (isinstance(node, ast.Raise) and "Refused(" in ast.unparse(node)):
            assert isinstance(node, (ast.Call, ast.Raise))
            first, last = node.lineno - 1, (node.end_lineno or node.lineno) - 1
            indent = lines[first][: node.col_offset]
            yield node.lineno, "\n".join([*lines[:first], f"{indent}pass", *lines[last + 1 :], ""])


def weaken(every: int) -> tuple[int, list[str]]:
    """Drop each condition of the checker in turn; list those whose removal no test detects."""
    root = Path(standalone.__file__).parents[2]
    source = Path(standalone.__file__).read_text(encoding="utf-8")
    weakened, unnoticed = list(list_weakened(source))[::every], []
    with TemporaryDirectory() as folder:
        for name in ("exactsweep", "tests", "pyproject.toml", "README.md"):
            subprocess.run(["cp", "-r", str(root / name), folder], check=True)
        for line, weaker in weakened:
            target = Path(folder) / "exactsweep" / "check" / "standalone.py"
            target.write_text(weaker, encoding="utf-8")
            if _pass(folder):
                unnoticed.append(f"{line}: {source.splitlines()[line - 1].strip()}")
    return len(weakened), unnoticed


def _pass(folder: str) -> bool:
    """Decide whether the tests pass in a folder within ten minutes."""
    run = subprocess.Popen(
        [sys.executable, "-m", "pytest", "-n0", "-qx", "-p", "no:cacheprovider", *TESTS],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": folder},
        stdout=subprocess.DEVNULL,
        start_new_session=True,
    )
    try:
        return run.wait(600) == 0
    except subprocess.TimeoutExpired:
        return False
    finally:
        # A checker started by a test may not terminate either.
        with suppress(ProcessLookupError):
            os.killpg(run.pid, signal.SIGKILL)
        run.wait()
