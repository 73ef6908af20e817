"""Run a program with a limit on wall time.

A system limit on processor time would make Linux measure it in coarse ticks.
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
    """Run a program with limits on processor time and overhead; return its output."""
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
