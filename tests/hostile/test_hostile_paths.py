"""Hostile paths and names: every command reports an error in one line."""

import re
import resource
import subprocess
import sys
from pathlib import Path

import pytest
from command import HOUSE, NOTCH, run

PATHS = ["", "x" * 300, "x/" * 3000, "no such file", "a\nb", "a\nb/c", "\x1b[2J", "\x1b[2J/c"]
PATHS += ["\udcff/c", "/dev/null/x", "\u202e/txt", "a\rb/c", "http://localhost/", "\x00"]
PATHS += ["~/no such folder/x"]
# {} is the path. Output paths come last.
READING = """sweep {} NOTCH | nfp HOUSE {} | ifp {} HOUSE | explain {} NOTCH
| draw {} NOTCH -o out.svg | view {} NOTCH -o out.html | verify {}
| convert {} --to json | compare {} {} | corpus show {} | batch {} -o out.jsonl
| reproduce {} | example {}"""
WRITING = "sweep HOUSE NOTCH | nfp HOUSE NOTCH | ifp HOUSE NOTCH | explain HOUSE NOTCH"
WRITING += " | draw HOUSE NOTCH | view HOUSE NOTCH | convert HOUSE | batch HOUSE"
UNWRITABLE = ["/"] + [
    path for path in PATHS if path and ("/" in path or len(path) > 255 or path == "\x00")
]


@pytest.mark.parametrize(
    ("command", "paths"),
    [
        *((command.strip(), PATHS) for command in READING.split("|")),
        *((f"{command.strip()} -o {{}}", UNWRITABLE) for command in WRITING.split("|")),
    ],
)
def test_unusable_paths_are_rejected(
    command: str, paths: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for path in paths:
        words = {"HOUSE": HOUSE, "NOTCH": NOTCH, "{}": path}
        result = run(*(words.get(word, word) for word in command.split()))
        assert isinstance(result.exception, SystemExit), (path, result.exception)
        assert result.exit_code in (1, 2), (path, result.output)
        *usage, last = result.stderr.splitlines()
        assert last.startswith("Error: "), (path, result.stderr)
        assert last.isprintable(), last
        assert len(last) < len(path) + 700
        # Only the usage line precedes it.
        assert not usage or usage[0].startswith("Usage: "), result.stderr


@pytest.mark.long
def test_too_little_memory_is_one_line(tmp_path: Path) -> None:
    """A polygon whose coordinates have 4,300 digits each needs more memory than is available."""
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
    """Formerly, help and version ended with an internal Python error."""
    for arguments in FULL:
        with Path("/dev/full").open("w") as full:
            result = subprocess.run(
                [sys.executable, "-m", "exactsweep", *arguments],
                stdout=full,
                stderr=subprocess.PIPE,
                text=True,
                cwd=tmp_path,  # if it writes files, too
                check=False,
            )
        assert result.returncode == 1, arguments
        assert re.fullmatch(r"Error: .*No space left on device\n", result.stderr), arguments
