"""Running a program with a limit on its processor time, so that a busy machine stops nothing."""

from __future__ import annotations

import resource
import subprocess
from collections.abc import Sequence
from math import ceil
from pathlib import Path
from signal import SIGKILL, SIGXCPU

ROOT = Path(__file__).parents[2]


class StoppedError(Exception):
    """A program gave no answer; the message says why."""


def run(command: Sequence[str | Path], given: str, seconds: float) -> str:
    """Run a program and return what it writes.

    Args:
        command: the program and its arguments.
        given: its standard input.
        seconds: of processor time, rounded up.

    Raises:
        StoppedError: it took longer, crashed or failed.
    """
    most = ceil(seconds)

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_CPU, (most, most))

    done = subprocess.run(
        command, input=given, capture_output=True, text=True, cwd=ROOT, preexec_fn=limit
    )
    if done.returncode in (-SIGXCPU, -SIGKILL):
        raise StoppedError(f"> {seconds:g} s")
    if done.returncode < 0:
        raise StoppedError(f"crashes, signal {-done.returncode}")
    if done.returncode:
        raise StoppedError(f"fails: {(done.stderr.strip().splitlines() or ['no reason'])[-1]}")
    return done.stdout
