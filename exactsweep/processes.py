"""Starting a process so that it, and all that it starts, can be ended for certain."""

from __future__ import annotations

import os
import signal
import subprocess
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from uuid import uuid4

_NAME = "EXACTSWEEP_MARK"
_PASSES = 20


class Started:
    """A process in a group of its own, with pipes to it, and a mark that its descendants inherit.

    The mark is a word in the environment. Ending kills the group and then, where the system shows
    the environment of processes under /proc, whatever has left the group but bears the mark.

    Args:
        command: the program and its arguments.
        stderr: where its standard error goes, as for `subprocess.Popen`.

    Raises:
        OSError: it cannot be started.
    """

    def __init__(self, command: Sequence[str], stderr: int | None = subprocess.PIPE) -> None:
        self._mark = uuid4().hex
        inherited = os.environ.get(_NAME, "")
        self.process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=stderr,
            start_new_session=True,
            env={**os.environ, _NAME: f"{inherited} {self._mark}"},
        )

    def wait(self, seconds: float) -> int | None:
        """Return the exit code, as of `subprocess.Popen`, or None if it does not end in time."""
        with suppress(subprocess.TimeoutExpired):
            return self.process.wait(seconds)
        return None

    def end(self) -> None:
        """Kill it and all that it started, and close the pipes."""
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(self.process.pid, signal.SIGKILL)
        # It may have moved to the group of one that it started.
        self.process.kill()
        self.process.wait()
        for pipe in (self.process.stdin, self.process.stdout, self.process.stderr):
            if pipe is not None:
                with suppress(OSError):
                    pipe.close()
        # One that is just starting another may be a step ahead.
        for _ in range(_PASSES):
            marked = list(_bearing(self._mark.encode()))
            for pid in marked:
                with suppress(ProcessLookupError, PermissionError):
                    os.kill(pid, signal.SIGKILL)
            if not marked:
                break


def _bearing(mark: bytes) -> Iterator[int]:
    for path in Path("/proc").glob("[0-9]*/environ"):
        with suppress(OSError):
            if mark in path.read_bytes():
                yield int(path.parent.name)
