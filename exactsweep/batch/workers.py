"""Local worker processes and Dask workers."""

from __future__ import annotations

import pickle
import re
import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import CancelledError, Future, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager, nullcontext, suppress
from typing import Any

from exactsweep.batch.work import BatchError, Chunk, Work
from exactsweep.formats.error import FormatError
from exactsweep.numbers.error import quote, require_imports
from exactsweep.processes import Pool, count_cores

LOCAL = "local"  # the address of a temporary cluster on this machine
_ADDRESS = re.compile(
    r"(?:[a-z]{2,8}://)?(?P<host>[\w.-]{1,253}|\[[0-9A-Fa-f:.%\w]{2,60}\])(?::(?P<port>[0-9]{1,5}))?"
)
_POLL_SECONDS = 0.5  # seconds between two checks of the scheduler


class LocalProcesses:
    """A pool of `count` processes; `lost` are the exceptions for chunks of killed processes."""

    lost: tuple[type[BaseException], ...] = (BrokenProcessPool,)

    def __init__(self, work: Work, count: int | None = None) -> None:
        self.count = count or count_cores()
        # Workers need the main module only if it defines classes used in the work.
        self._around = nullcontext if b"__main__" in pickle.dumps(work) else _hide_main
        with self._around():
            self._pool = Pool(self.count, _set_work, work, forks=True)

    def submit(self, chunk: Chunk) -> Future[Sequence[bytes]]:
        with self._around():
            try:
                return self._pool.submit(_compute_here, chunk)
            except BrokenProcessPool:
                self._pool.start()
                return self._pool.submit(_compute_here, chunk)

    def close(self) -> None:
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


def _compute_here(chunk: Chunk) -> Sequence[bytes]:
    return _work.lines(chunk)


class Cluster:
    """The workers of a Dask scheduler, or `count` local ones; Dask recomputes lost chunks."""

    def __init__(self, work: Work, address: str, count: int) -> None:
        _require_address(address)
        dask = _dask()
        self.lost: tuple[type[BaseException], ...] = (dask.KilledWorker,)
        self.closed: type[Exception] = dask.client.ClosedClientError
        self.own = None
        try:
            if address == LOCAL:
                # Even without a dashboard it serves HTTP, here on any free port.
                self.own = dask.LocalCluster(
                    n_workers=count,
                    threads_per_worker=1,
                    dashboard_address="127.0.0.1:0",
                    scheduler_kwargs={"dashboard": False},
                )
            self.client = dask.Client(self.own or address, timeout=5)
            self.count = max(1, sum(self.client.nthreads().values()))
            self.name = f"exactsweep-{id(self):x}"
            self.client.register_plugin(_make_plugin(work, self.name))
        # Dask raises AssertionError for some addresses.
        except (OSError, ValueError, AssertionError) as error:
            reason = str(error).partition("\n")[0]
            raise BatchError(f"no Dask scheduler at {quote(address)}: {reason}") from None
        self.connection = self.client.scheduler_comm
        self.pool = self.client.get_executor(pure=False)

    def submit(self, chunk: Chunk) -> RecordsOfCluster:
        try:
            return RecordsOfCluster(self.pool.submit(_compute, chunk, self.name), self)
        except self.closed:
            raise CancelledError from None

    def is_disconnected(self) -> bool:
        """Return whether the connection to the scheduler was lost."""
        return self.client.status != "running" or self.client.scheduler_comm is not self.connection

    def close(self) -> None:
        """Disconnect, and shut down a local cluster."""
        # A lost scheduler leaves nothing to clean up.
        with suppress(OSError, self.closed):
            self.pool.shutdown(wait=False)
            if self.own is None and not self.is_disconnected():
                self.client.unregister_worker_plugin(self.name)
        self.client.close()
        if self.own is not None:
            self.own.close()


def _require_address(address: str) -> None:
    match = _ADDRESS.fullmatch(address)
    if not match or match["host"].isdigit() or not 0 < int(match["port"] or 1) < 2**16:
        raise BatchError(
            f"{quote(address)} is not the address of a Dask scheduler, as in tcp://host:8786"
        )


class RecordsOfCluster:
    def __init__(self, future: Future[Sequence[bytes]], cluster: Cluster) -> None:
        self.future, self.cluster = future, cluster

    def result(self) -> Sequence[bytes]:
        """Wait for the records; raises CancelledError if the scheduler is lost."""
        # Dask never settles a future whose result was in transfer from a lost scheduler.
        while not wait([self.future], _POLL_SECONDS).done:
            if self.cluster.is_disconnected():
                raise CancelledError
        return self.future.result()


def _dask() -> Any:
    with require_imports("distributed", "a scheduler", FormatError):
        import distributed
    return distributed


def _make_plugin(held: Work, plugin_name: str) -> object:
    # Local classes are pickled by value.
    class WorkPlugin(_dask().WorkerPlugin):  # type: ignore[misc]
        name = plugin_name
        work = held

    return WorkPlugin()


def _compute(chunk: Chunk, name: str) -> Sequence[bytes]:
    work: Work = _dask().get_worker().plugins[name].work
    return work.lines(chunk)
