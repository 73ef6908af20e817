"""Time and memory, and what they were measured on.

Times are the processor's for one process and one thread: the wall time of a machine that does
nothing else, whatever other jobs there are.
"""

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
FINEST = 100e-6
"""Seconds; a clock with coarser ticks cannot time the small pairs."""


class ClockError(RuntimeError):
    """A processor clock too coarse to measure with."""


class Times(NamedTuple):
    """Median, minimum and maximum, in milliseconds."""

    median: float
    least: float
    greatest: float

    @classmethod
    def of(cls, milliseconds: list[float]) -> Times:
        return cls(median(milliseconds), min(milliseconds), max(milliseconds))


def milliseconds(call: Callable[[], object], seconds: float = 0.3) -> list[float]:
    """Call for about that many seconds in all, at least once and at most 100 times.

    Returns the time of each call.
    """
    times: list[float] = []
    while not times or (len(times) < REPEATS and sum(times) < 1000 * seconds):
        start = process_time()
        call()
        times.append(1000 * (process_time() - start))
    return times


def require_fine_clock() -> None:
    """Make sure that the processor's clock runs smoothly.

    The resolution that a system states is not always what it delivers.

    Raises ClockError.
    """
    ticks: list[float] = []
    last = process_time()
    while len(ticks) < 20:
        now = process_time()
        if now != last:
            ticks.append(now - last)
            last = now
    if median(ticks) > FINEST:
        raise ClockError(f"the processor's clock ticks only every {1000 * median(ticks):.3g} ms")


def machine() -> str:
    """Processor, Python and date, for the head of a table."""
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
    """Return the most bytes that this process has held in memory."""
    # The result of getrusage on Linux includes the parent, up to the start of this program.
    if held := read_peak(os.getpid()):
        return held
    import resource

    unit = 1 if sys.platform == "darwin" else 1024
    return unit * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
