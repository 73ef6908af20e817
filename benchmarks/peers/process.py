"""Run a program with a limit on wall time.

With a system limit on processor time, Linux measures it in coarse ticks.
"""

from __future__ import annotations

import subprocess
from collections.abc import Sequence
from pathlib import Path

ROOT = Path(__file__).parents[2]


class StoppedError(Exception):
    """A program without an answer; the message gives the reason."""


class TooSlowError(StoppedError):
    """A program that exceeds its time limit."""


def run(command: Sequence[str | Path], given: str, seconds: float, *, overhead: float = 0.0) -> str:
    """Run a program with a limit of processor time and an overhead; return its output.

    Raises:
        StoppedError: the program takes longer, crashes or fails.
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
