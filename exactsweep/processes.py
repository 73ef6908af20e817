"""Processes that are ended for certain, with all that they started."""

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
# For what is spawned: no modules of the working directory before those of Python, and no word of
# the helper that removes the semaphores of a process that was killed.
_SPAWNED = {"PYTHONSAFEPATH": "1", "PYTHONWARNINGS": "ignore:resource_tracker:UserWarning"}
_PASSES = 20

_T = TypeVar("_T")

# Held while a process is started, so that none is started behind the back of what ends them all.
_starting = RLock()

# Files whose lock a copy of this process would hold, too.
_locked: WeakSet[IO[Any]] = WeakSet()


class Started:
    """A process in a group of its own, with pipes to it, and a mark that its descendants inherit.

    The mark is a word in the environment. Ending kills the group, its descendants and, where the
    system shows the environment of processes under /proc, all that bear the mark. A process in
    another group and environment whose parents have ended is not found: this is no sandbox.

    Args:
        command: the program and its arguments.

    Raises:
        OSError: it cannot be started; or the system has no groups of processes, as Windows.
    """

    def __init__(self, command: Sequence[str]) -> None:
        if not hasattr(os, "killpg"):
            raise OSError(
                "programs are started and ended on POSIX systems only; a Python function can be "
                "judged here, and what 'exactsweep judge' reads from a pipe"
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

    def forget_peak(self) -> None:
        """Let `read_peak` begin anew, of the process itself, where the system can do that."""
        with suppress(OSError):
            Path(f"/proc/{self.process.pid}/clear_refs").write_text("5")

    def read_peak(self) -> int | None:
        """Return the bytes of memory that it held at most, with all that it started and that runs.

        They are the sum of what each of these processes held at most, which they may not have held
        at one time; None where the system does not tell.
        """
        peaks = [peak for pid in _find_family(self.process.pid) if (peak := read_peak(pid))]
        return sum(peaks) or None

    def wait(self, seconds: float) -> int | None:
        """Return the exit code, as of `subprocess.Popen`, or None if it does not end in time."""
        from subprocess import TimeoutExpired

        with suppress(TimeoutExpired):
            return self.process.wait(seconds)
        return None

    def end(self) -> None:
        """Kill it and all that it started, and close the pipes."""
        descendants = _find_family(self.process.pid)[1:]
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(self.process.pid, signal.SIGKILL)
        # It may have moved to the group of one that it started.
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
    """The processes that one started, and those that these started; itself first."""
    family = [pid]
    # They may be nested deeper than Python calls itself.
    for parent in family:
        for path in Path(f"/proc/{parent}/task").glob("*/children"):
            with suppress(OSError):
                family += map(int, path.read_text().split())
    return family


def read_peak(pid: int) -> int | None:
    """Return the bytes of memory that a process held at most; None if the system is silent."""
    with suppress(OSError):
        found = re.search(r"^VmHWM:\s*(\d+) kB$", Path(f"/proc/{pid}/status").read_text(), re.M)
        return int(found[1]) * 1024 if found else None
    return None


def _kill_marked(mark: str) -> None:
    # One that is just starting another may be a step ahead.
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
    """Return how many processors this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # not Linux
        return os.cpu_count() or 1


def lock(file: IO[Any]) -> bool:
    """Keep other processes away from an open file; tell whether none had it already.

    The system unlocks it when this process ends, however it ends.
    """
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
    """Fresh processes that end with this one, however it ends, with all that they started.

    Args:
        count: how many there are.
        prepare: what each of them calls before anything else.
        arguments: of that.
        forks: whether they may be copies of this process, which start sooner, while it has one
            thread only.

    Raises:
        BrokenProcessPool: by `submit` and by what it returns, when one of them is killed; `start`
            begins again.
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
        # Nothing is ever sent: it closes when this process ends.
        self._lifeline, self._held = multiprocessing.Pipe(duplex=False)
        self.start()

    def start(self) -> None:
        """Take fresh processes, the old ones having been killed."""
        own = {name: os.environ.get(name) for name in _SPAWNED}
        # A fork would copy the threads' locks in whatever state they are in.
        way = "fork" if self._forks and _has_one_thread() else "spawn"
        context = multiprocessing.get_context(way)
        with _allow_spawn():
            pipe = self._lifeline, self._held
            given = (*pipe, context.Barrier(self.count), own, *self._prepare)
            self._executor = ProcessPoolExecutor(self.count, context, _begin, given)

    def submit(self, function: Callable[..., _T], *arguments: object) -> Future[_T]:
        """Call a function in whichever process is idle."""
        # This may start processes.
        with _allow_spawn():
            return self._executor.submit(function, *arguments)

    def call_in_each(self, function: Callable[..., _T], *arguments: object) -> list[_T]:
        """Call a function once in each process, and return what it returns in each."""
        futures = [self.submit(_call_together, function, *arguments) for _ in range(self.count)]
        return [future.result() for future in futures]

    def close(self) -> None:
        """End all processes, whatever they are doing."""
        self._held.close()
        self._lifeline.close()
        self._executor.shutdown(wait=True, cancel_futures=True)


def _has_one_thread() -> bool:
    """Tell whether this process has a single thread, of any library; only Linux knows."""
    with suppress(OSError):
        return len(os.listdir("/proc/self/task")) == 1
    return False


@contextmanager
def _allow_spawn() -> Iterator[None]:
    """Let processes be started that neither Control-C nor files of the working directory reach.

    Control-C is for the process that starts them, and comes through afterwards.
    """
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
    # Both end with the process that started this one.
    held.close()
    for file in _locked:
        if not file.closed:
            os.close(file.fileno())
    mark = _make_mark()
    _set_environment({**environment, _MARK: f"{os.environ.get(_MARK, '')} {mark}"})
    # A handler, and no mask, is not inherited by what is started from here.
    signal.signal(signal.SIGINT, lambda number, frame: None)
    signal.signal(signal.SIGTERM, lambda number, frame: _end_all(mark))
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
    Thread(target=_end_with, args=(lifeline, mark), daemon=True).start()
    if prepare is not None:
        prepare(*arguments)


def _end_with(lifeline: Connection, mark: str) -> None:
    """End this process with the one that started it: nobody else would."""
    with suppress(EOFError, OSError):
        lifeline.recv_bytes()
    _end_all(mark)


def _end_all(mark: str) -> NoReturn:
    """End this process, and all that it started."""
    with _starting:
        _kill_marked(mark)
        os._exit(1)


def _call_together(function: Callable[..., _T], *arguments: object) -> _T:
    """Call a function once every process is about to."""
    _together.wait()
    return function(*arguments)
