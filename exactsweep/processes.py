"""Child processes, and pools of them, that end reliably with all their descendants."""

from __future__ import annotations

import multiprocessing
import os
import re
import signal
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager, suppress
from multiprocessing.connection import Connection
from multiprocessing.synchronize import Barrier
from pathlib import Path
from threading import RLock, Thread
from typing import IO, TYPE_CHECKING, Any, NoReturn, TypeVar
from weakref import WeakSet

if TYPE_CHECKING:
    import subprocess

_MARK = "EXACTSWEEP_MARK"
# Spawned processes must not import modules from the working directory. The resource tracker would
# warn about killed processes.
_SPAWNED = {"PYTHONSAFEPATH": "1", "PYTHONWARNINGS": "ignore:resource_tracker:UserWarning"}
_PASSES = 20

_T = TypeVar("_T")

_starting = RLock()  # held while a process starts, so that `_end_all` finds it
_locked: WeakSet[IO[Any]] = WeakSet()  # locked files; a forked process would share their locks


class ChildProcess:
    """A child process in its own process group, with pipes, and a mark in its environment.

    `end` kills the group, the descendants and, on systems with /proc, all processes with the mark.
    It cannot find an orphan that changed its group and its environment: this is not a sandbox.
    Raises OSError if the program cannot be started, or without process groups, as on Windows.
    """

    def __init__(self, command: Sequence[str]) -> None:
        if not hasattr(os, "killpg"):
            raise OSError(
                "cannot run programs on this system (POSIX only); judge a Python function, or pipe "
                "answers to 'exactsweep judge'"
            )
        import subprocess

        self._mark = _make_mark()
        with _starting:
            self.process: subprocess.Popen[bytes] = subprocess.Popen(
                command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                start_new_session=True,
                env={**os.environ, _MARK: f"{os.environ.get(_MARK, '')} {self._mark}"},
            )

    def reset_peak(self) -> None:
        with suppress(OSError):
            Path(f"/proc/{self.process.pid}/clear_refs").write_text("5")

    def read_peak(self) -> int | None:
        """Return the total peak memory of the process and its running descendants, in bytes.

        The peaks may occur at different times. None if the system does not report them.
        """
        peaks = [peak for pid in _find_family(self.process.pid) if (peak := read_peak(pid))]
        return sum(peaks) or None

    def wait(self, seconds: float) -> int | None:
        """Return the exit code, or None after a timeout."""
        from subprocess import TimeoutExpired

        with suppress(TimeoutExpired):
            return self.process.wait(seconds)
        return None

    def end(self) -> None:
        """Kill the process and its descendants, and close the pipes."""
        descendants = _find_family(self.process.pid)[1:]
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(self.process.pid, signal.SIGKILL)
        # The process may have changed its group.
        self.process.kill()
        for pid in descendants:
            with suppress(ProcessLookupError, PermissionError):
                os.kill(pid, signal.SIGKILL)
        self.process.wait()
        for pipe in (self.process.stdin, self.process.stdout, self.process.stderr):
            if pipe is not None:
                with suppress(OSError):
                    pipe.close()
        _kill_marked(self._mark)


def _make_mark() -> str:
    return os.urandom(16).hex()


def _find_family(pid: int) -> list[int]:
    """List a process and its descendants."""
    family = [pid]
    # Not recursive: the tree may be deeper than Python's recursion limit.
    for parent in family:
        for path in Path(f"/proc/{parent}/task").glob("*/children"):
            with suppress(OSError):
                family += map(int, path.read_text().split())
    return family


def read_peak(pid: int) -> int | None:
    """Return the peak memory of a process in bytes; None if the system does not report it."""
    with suppress(OSError):
        found = re.search(r"^VmHWM:\s*(\d+) kB$", Path(f"/proc/{pid}/status").read_text(), re.M)
        return int(found[1]) * 1024 if found else None
    return None


def _kill_marked(mark: str) -> None:
    # A process that forks during a pass may escape it.
    for _ in range(_PASSES):
        marked = list(_find_marked(mark.encode()))
        for pid in marked:
            with suppress(ProcessLookupError, PermissionError):
                os.kill(pid, signal.SIGKILL)
        if not marked:
            break


def _find_marked(mark: bytes) -> Iterator[int]:
    for path in Path("/proc").glob("[0-9]*/environ"):
        with suppress(OSError):
            if mark in path.read_bytes():
                yield int(path.parent.name)


def count_cores() -> int:
    """Return the number of CPUs that this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # not Linux
        return os.cpu_count() or 1


def lock(file: IO[Any]) -> bool:
    """Lock an open file until this process ends; return False if another process has the lock."""
    try:
        import fcntl
    except ImportError:  # not Unix
        return True
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    _locked.add(file)
    return True


class Pool:
    """A pool of `count` processes that end, with all descendants, when this process ends.

    Each process first calls `prepare(*arguments)`. With `forks`, processes are forked, which is
    faster, if this process has a single thread. After a process was killed, `submit` and its
    futures raise BrokenProcessPool; `start` restarts the pool.
    """

    def __init__(
        self,
        count: int,
        prepare: Callable[..., object] | None = None,
        *arguments: object,
        forks: bool = False,
    ) -> None:
        self.count = count
        self._prepare = prepare, arguments
        self._forks = forks
        # The pipe carries no data; it closes when this process ends.
        self._lifeline, self._held = multiprocessing.Pipe(duplex=False)
        self.start()

    def start(self) -> None:
        own = {name: os.environ.get(name) for name in _SPAWNED}
        # A fork would copy locks held by other threads.
        method = "fork" if self._forks and _has_one_thread() else "spawn"
        context = multiprocessing.get_context(method)
        with _allow_spawn():
            pipe = self._lifeline, self._held
            given = (*pipe, context.Barrier(self.count), own, *self._prepare)
            self._executor = ProcessPoolExecutor(self.count, context, _begin, given)

    def submit(self, function: Callable[..., _T], *arguments: object) -> Future[_T]:
        with _allow_spawn():
            return self._executor.submit(function, *arguments)

    def call_in_each(self, function: Callable[..., _T], *arguments: object) -> list[_T]:
        """Call a function once in each process, and return the results."""
        futures = [self.submit(_call_together, function, *arguments) for _ in range(self.count)]
        return [future.result() for future in futures]

    def close(self) -> None:
        """Kill all processes."""
        self._held.close()
        self._lifeline.close()
        self._executor.shutdown(wait=True, cancel_futures=True)


def _has_one_thread() -> bool:
    """Return whether this process has a single thread; always False except on Linux."""
    with suppress(OSError):
        return len(os.listdir("/proc/self/task")) == 1
    return False


@contextmanager
def _allow_spawn() -> Iterator[None]:
    """Defer Control-C, and hide modules in the working directory from processes started inside."""
    held_back = hasattr(signal, "pthread_sigmask")  # not on Windows
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT}) if held_back else ()
    own = {name: os.environ.get(name) for name in _SPAWNED}
    _set_environment(_SPAWNED)
    try:
        yield
    finally:
        _set_environment(own)
        if held_back:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _set_environment(values: Mapping[str, str | None]) -> None:
    for name, value in values.items():
        if value is None:
            os.environ.pop(name, None)
        else:
            os.environ[name] = value


_together: Barrier


def _begin(
    lifeline: Connection,
    held: Connection,
    barrier: Barrier,
    environment: Mapping[str, str | None],
    prepare: Callable[..., object] | None,
    arguments: Sequence[object],
) -> None:
    global _together
    _together = barrier
    # The pipe must close with the parent, so close this copy.
    held.close()
    for file in _locked:
        if not file.closed:
            os.close(file.fileno())
    mark = _make_mark()
    _set_environment({**environment, _MARK: f"{os.environ.get(_MARK, '')} {mark}"})
    # Children inherit masks, but not handlers.
    signal.signal(signal.SIGINT, lambda number, frame: None)
    signal.signal(signal.SIGTERM, lambda number, frame: _end_all(mark))
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
    Thread(target=_end_with, args=(lifeline, mark), daemon=True).start()
    if prepare is not None:
        prepare(*arguments)


def _end_with(lifeline: Connection, mark: str) -> None:
    """End this process when its parent ends."""
    with suppress(EOFError, OSError):
        lifeline.recv_bytes()
    _end_all(mark)


def _end_all(mark: str) -> NoReturn:
    with _starting:
        _kill_marked(mark)
        os._exit(1)


def _call_together(function: Callable[..., _T], *arguments: object) -> _T:
    """Call a function as soon as all processes are ready."""
    _together.wait()
    return function(*arguments)
