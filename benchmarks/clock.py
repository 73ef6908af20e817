"""Processor time of one process and thread, memory, and a description of the machine."""

from __future__ import annotations

import os
import platform
import sys
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path
from statistics import median
from time import process_time
from typing import NamedTuple

from exactsweep.processes import read_peak

REPEATS = 100
COARSEST = 100e-6  # the coarsest useful tick in seconds


class ClockError(RuntimeError):
    """A processor clock that is too coarse."""


class Times(NamedTuple):
    """Median, minimum and maximum, in milliseconds."""

    median: float
    least: float
    greatest: float

    @classmethod
    def of(cls, milliseconds: list[float]) -> Times:
        return cls(median(milliseconds), min(milliseconds), max(milliseconds))


def milliseconds(call: Callable[[], object], seconds: float = 0.3) -> list[float]:
    """Repeat a call 1 to 100 times for about this many seconds; return the time of each call."""
    times: list[float] = []
    while not times or (len(times) < REPEATS and sum(times) < 1000 * seconds):
        start = process_time()
        call()
        times.append(1000 * (process_time() - start))
    return times


def require_fine_clock() -> None:
    """Measure the resolution of the processor clock; raise ClockError if it is too coarse."""
    ticks: list[float] = []
    last = process_time()
    while len(ticks) < 20:
        now = process_time()
        if now != last:
            ticks.append(now - last)
            last = now
    if median(ticks) > COARSEST:
        raise ClockError(
            f"the processor clock is too coarse: it ticks every {1000 * median(ticks):.3g} ms"
        )


def machine() -> str:
    """Describe the processor, Python and the date, for the head of a table."""
    processor = platform.processor() or platform.machine()
    described = Path("/proc/cpuinfo")
    if described.exists():
        for line in described.read_text().splitlines():
            if line.startswith("model name"):
                processor = line.partition(":")[2].strip()
                break
    python = f"{platform.python_implementation()} {platform.python_version()}"
    return f"{processor}, {platform.system()}, {python}, {datetime.now(UTC):%Y-%m-%d}"


def peak() -> int:
    """Return the peak memory of this process in bytes."""
    # On Linux, getrusage includes the parent until this program starts.
    if held := read_peak(os.getpid()):
        return held
    import resource

    unit = 1 if sys.platform == "darwin" else 1024
    return unit * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
