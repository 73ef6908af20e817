"""Local worker processes."""

from __future__ import annotations

import pickle
import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import Future
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager, nullcontext

from exactsweep.batch.work import Chunk, Work
from exactsweep.processes import Pool, count_cores


class LocalProcesses:
    """A pool of processes.

    Attributes:
        count: the number of processes.
        lost: the exceptions for chunks of killed processes.
    """

    lost: tuple[type[BaseException], ...] = (BrokenProcessPool,)

    def __init__(self, work: Work, count: int | None = None) -> None:
        self.count = count or count_cores()
        # Workers need the main module only if it defines classes used in the work.
        self._around = nullcontext if b"__main__" in pickle.dumps(work) else _hide_main
        with self._around():
            self._pool = Pool(self.count, _set_work, work, forks=True)

    def submit(self, chunk: Chunk) -> Future[Sequence[bytes]]:
        """Compute a chunk in a worker process."""
        with self._around():
            try:
                return self._pool.submit(_compute, chunk)
            except BrokenProcessPool:
                self._pool.start()
                return self._pool.submit(_compute, chunk)

    def close(self) -> None:
        """Terminate all processes, even busy ones."""
        self._pool.close()


@contextmanager
def _hide_main() -> Iterator[None]:
    """Keep new processes from importing the main module, which may lack a main guard."""
    main = vars(sys.modules["__main__"])
    hidden: dict[str, object] = {
        name: main.pop(name) for name in ("__spec__", "__file__") if name in main
    }
    main["__spec__"] = None
    try:
        yield
    finally:
        main.update({"__spec__": None, **hidden})


_work: Work


def _set_work(work: Work) -> None:
    global _work
    _work = work


def _compute(chunk: Chunk) -> Sequence[bytes]:
    return _work.lines(chunk)
