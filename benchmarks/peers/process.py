"""Running a program for a limited time.

The limit is wall time, and no limit of the system's on processor time: where that is set, Linux
reads a process' own clock in ticks of some milliseconds, and times would be worth nothing.
"""

from __future__ import annotations

import subprocess
from collections.abc import Sequence
from pathlib import Path

ROOT = Path(__file__).parents[2]


class StoppedError(Exception):
    """A program gave no answer; the message says why."""


class TooSlowError(StoppedError):
    """A program exceeded its time limit."""


def run(command: Sequence[str | Path], given: str, seconds: float, *, overhead: float = 0.0) -> str:
    """Run a program and return what it writes.

    Args:
        command: the program and its arguments.
        given: its standard input.
        seconds: of processor time that it may take; on a busy machine, twice that by the clock
            on the wall.
        overhead: seconds that it may take besides, to start and to repeat.

    Raises:
        StoppedError: it took longer, crashed or failed.
    """
    try:
        done = subprocess.run(
            command,
            input=given,
            capture_output=True,
            text=True,
            cwd=ROOT,
            timeout=2 * (seconds + overhead),
        )
    except subprocess.TimeoutExpired:
        raise TooSlowError(f"> {seconds:g} s") from None
    if done.returncode < 0:
        raise StoppedError(f"crashes, signal {-done.returncode}")
    if done.returncode:
        raise StoppedError(f"fails: {(done.stderr.strip().splitlines() or ['no reason'])[-1]}")
    return done.stdout
