"""Processes of this machine."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing.connection import Connection

from exactsweep.batch.work import Chunk, Work


class LocalProcesses:
    """A pool of fresh processes, each of which is sent the work once.

    Attributes:
        count: how many processes there are.
        lost: the exception of a chunk whose process is killed.
    """

    lost: tuple[type[BaseException], ...] = (BrokenProcessPool,)

    def __init__(self, work: Work, count: int | None = None) -> None:
        self.work = work
        self.count = count or cores()
        # A fork would copy the threads' locks in whatever state they are in.
        self.context = multiprocessing.get_context("spawn")
        # Nothing is ever sent: it closes when this process ends, however it ends.
        self.lifeline, self.held = self.context.Pipe(duplex=False)
        self._start()

    def _start(self) -> None:
        self.pool = ProcessPoolExecutor(
            self.count, self.context, _begin, (self.work, self.lifeline)
        )

    def submit(self, chunk: Chunk) -> Future[Sequence[bytes]]:
        """Compute a chunk in some process."""
        # This may start processes.
        with _control_c_held_back():
            try:
                return self.pool.submit(_compute, chunk)
            except BrokenProcessPool:
                self._start()
                return self.pool.submit(_compute, chunk)

    def close(self) -> None:
        """End all processes, whatever they are at."""
        self.held.close()
        self.lifeline.close()
        self.pool.shutdown(wait=True, cancel_futures=True)


@contextmanager
def _control_c_held_back() -> Iterator[None]:
    """Let processes be started that Control-C does not reach, though it reaches their terminal.

    The one that starts them decides what to do, and gets what comes in the meantime afterwards.
    """
    if not hasattr(signal, "pthread_sigmask"):  # not Unix
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def cores() -> int:
    """Return how many processors this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # not Linux
        return os.cpu_count() or 1


_work: Work


def _begin(work: Work, lifeline: Connection) -> None:
    global _work
    _work = work
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with, args=(lifeline,), daemon=True).start()


def _end_with(lifeline: Connection) -> None:
    """End this process with the one that started it: nobody else would."""
    try:
        lifeline.recv_bytes()
    finally:
        os._exit(1)


def _compute(chunk: Chunk) -> Sequence[bytes]:
    return _work.lines(chunk)
