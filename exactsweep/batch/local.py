"""Processes of this machine."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Future
from concurrent.futures.process import BrokenProcessPool

from exactsweep.batch.work import Chunk, Work
from exactsweep.processes import Pool, count_cores


class LocalProcesses:
    """A pool of fresh processes, each of which is sent the work once.

    Attributes:
        count: how many processes there are.
        lost: the exception of a chunk whose process is killed.
    """

    lost: tuple[type[BaseException], ...] = (BrokenProcessPool,)

    def __init__(self, work: Work, count: int | None = None) -> None:
        self.count = count or count_cores()
        self._pool = Pool(self.count, _hold, work)

    def submit(self, chunk: Chunk) -> Future[Sequence[bytes]]:
        """Compute a chunk in some process."""
        try:
            return self._pool.submit(_compute, chunk)
        except BrokenProcessPool:
            self._pool.start()
            return self._pool.submit(_compute, chunk)

    def close(self) -> None:
        """End all processes, whatever they are doing."""
        self._pool.close()


_work: Work


def _hold(work: Work) -> None:
    global _work
    _work = work


def _compute(chunk: Chunk) -> Sequence[bytes]:
    return _work.lines(chunk)
