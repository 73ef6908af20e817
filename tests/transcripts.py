"""Transcripts of commands, with what they write; `python -m tests.goldens` rewrites them.

A transcript is a text file in a folder `transcripts`. A line that begins with "$ " is a shell
command: exactsweep, cat, echo or python, optionally with `<<< TEXT`, `< FILE` or `> FILE`. The
indented lines below it are its output: "! " precedes standard error, and "= " the exit code unless
it is 0. All other lines are comments. Dots stand for the witness of an overlap.
"""

from __future__ import annotations

import re
import shlex
import sys
from collections.abc import Iterator
from pathlib import Path

from command import run
from judged import IMPLEMENTATIONS

TESTS = Path(__file__).parent
_INDENT = "    "
_SIGNS = ("<<<", "<", ">")
_WRONG_USAGE = 2
_COMMON_POINT = re.compile(r"(OVERLAP, point )\(.*?\)")
"""A point in both interiors, of which any is as good as another one."""


def list_transcripts() -> list[Path]:
    """List the transcripts of all folders of tests."""
    return sorted(TESTS.glob("*/transcripts/*.txt"))


def replay(transcript: str) -> str:
    """Run the commands of a transcript in the working directory; return the current transcript."""
    lines: list[str] = []
    for line in transcript.splitlines():
        if line.startswith("$ "):
            lines += [line, *(f"{_INDENT}{output}".rstrip() for output in _run_line(line[2:]))]
        elif line and not line.startswith(_INDENT):
            lines += [*([""] if lines and lines[-1][:2] != "# " else []), line]
    return "".join(f"{line}\n" for line in lines)


def _run_line(line: str) -> Iterator[str]:
    """Run a command; yield the lines that it writes."""
    words = shlex.split(line)
    redirected: dict[str, str] = {}
    while len(words) > 2 and words[-2] in _SIGNS:
        *words, sign, text = words
        redirected[sign] = text
    stdin = redirected.get("<<<")
    if "<" in redirected:
        stdin = Path(redirected["<"]).read_text()
    code, errors = 0, ""
    match words:
        case ["echo", *texts]:
            text = "".join(f"{one}\n" for one in texts)
        case ["cat", *files]:
            text = "".join(Path(file).read_text() for file in files)
        case [_, *arguments]:
            programs = {"python": sys.executable, "faulty.py": str(IMPLEMENTATIONS / "faulty.py")}
            done = run(*(programs.get(one, one) for one in arguments), stdin=stdin)
            code, text, errors = done.exit_code, done.stdout, done.stderr
    if ">" in redirected:
        Path(redirected[">"]).write_text(text)
        text = ""
    yield from _COMMON_POINT.sub(r"\1...", text).splitlines()
    if code == _WRONG_USAGE:
        # click writes the lines before.
        errors = errors[errors.index("Error: ") :]
    yield from (f"! {output}" for output in errors.splitlines())
    if code:
        yield f"= {code}"
