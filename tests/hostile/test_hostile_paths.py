"""Paths and names that no program should be given: one line of an error from every command."""

import re
import resource
import subprocess
import sys
from pathlib import Path

import pytest
from command import HOUSE, NOTCH, run

PATHS = [
    *(
        "",
        "x" * 300,
        "x/" * 3000,
        "no such file",
        "a\nb",
        "a\nb/c",
        "\x1b[2J",
        "\x1b[2J/c",
        "\udcff/c",
    ),
    *(
        "/dev/null/x",
        "\u202e/txt",
        "a\rb/c",
        "http://localhost/",
        "~/no such folder/x",
        "\x00",
    ),
]
READING = {
    "sweep": ("sweep", "{}", NOTCH),
    "nfp": ("nfp", HOUSE, "{}"),
    "ifp": ("ifp", "{}", HOUSE),
    "explain": ("explain", "{}", NOTCH),
    "draw": ("draw", "{}", NOTCH, "-o", "out.svg"),
    "view": ("view", "{}", NOTCH, "-o", "out.html"),
    "verify": ("verify", "{}"),
    "convert": ("convert", "{}", "--to", "json"),
    "compare": ("compare", "{}", "{}"),
    "corpus show": ("corpus", "show", "{}"),
    "batch": ("batch", "{}", "-o", "out.jsonl"),
    "reproduce": ("reproduce", "{}"),
    "example": ("example", "{}"),
}
WRITING = {
    "sweep": ("sweep", HOUSE, NOTCH, "-o", "{}"),
    "nfp": ("nfp", HOUSE, NOTCH, "-o", "{}"),
    "ifp": ("ifp", HOUSE, NOTCH, "-o", "{}"),
    "explain": ("explain", HOUSE, NOTCH, "-o", "{}"),
    "draw": ("draw", HOUSE, NOTCH, "-o", "{}"),
    "view": ("view", HOUSE, NOTCH, "-o", "{}"),
    "convert": ("convert", HOUSE, "--to", "json", "-o", "{}"),
    "batch": ("batch", HOUSE, "-o", "{}"),
}
UNWRITABLE = ["/"] + [
    path for path in PATHS if path and ("/" in path or len(path) > 255 or path == "\x00")
]


def require_one_line(arguments: tuple[str, ...], path: str) -> None:
    result = run(*(argument.replace("{}", path) for argument in arguments))
    assert isinstance(result.exception, SystemExit), (arguments[0], path, result.exception)
    assert result.exit_code in (1, 2), (arguments, path, result.output)
    *usage, last = result.stderr.splitlines()
    assert last.startswith("Error: "), (arguments, path, result.stderr)
    assert last.isprintable(), last
    assert len(last) < len(path) + 700
    # Only how a command is used comes before it.
    assert not usage or usage[0].startswith("Usage: "), result.stderr


@pytest.mark.parametrize(
    ("command", "done", "arguments", "paths"),
    [
        *((command, "read", arguments, PATHS) for command, arguments in READING.items()),
        *((command, "written", arguments, UNWRITABLE) for command, arguments in WRITING.items()),
    ],
)
def test_paths_that_cannot_be_used(
    command: str,
    done: str,
    arguments: tuple[str, ...],
    paths: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    for path in paths:
        require_one_line(arguments, path)


@pytest.mark.long
def test_too_little_memory_is_one_line(tmp_path: Path) -> None:
    """A polygon of which every coordinate has 4,300 digits, in less memory than it takes."""
    path = tmp_path / "long.json"
    path.write_text(f"[{','.join(f'[{k},{k * k}e4000]' for k in range(40_000))}]")

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_AS, (140 << 20, 140 << 20))

    result = subprocess.run(
        [sys.executable, "-m", "exactsweep", "convert", str(path), "--to", "json"],
        capture_output=True,
        text=True,
        preexec_fn=limit,
        check=False,
    )
    assert result.returncode == 1
    assert result.stderr == "Error: out of memory\n"


FULL = [
    *(("--help",), ("--version",), ("sweep", "--help"), ("sweep", HOUSE, NOTCH)),
    *(("convert", HOUSE, "--to", "wkt"), ("corpus", "list"), ("reproduce", "--cite")),
]


@pytest.mark.long
def test_a_full_disk_is_one_line(tmp_path: Path) -> None:
    """Once help and version ended in Python's own words."""
    for arguments in FULL:
        with Path("/dev/full").open("w") as full:
            result = subprocess.run(
                [sys.executable, "-m", "exactsweep", *arguments],
                stdout=full,
                stderr=subprocess.PIPE,
                text=True,
                cwd=tmp_path,  # where it writes files, too
                check=False,
            )
        assert result.returncode == 1, arguments
        assert re.fullmatch(r"Error: .*No space left on device\n", result.stderr), arguments
