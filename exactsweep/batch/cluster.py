"""Processes of a Dask cluster, of one machine or many."""

from __future__ import annotations

import re
from collections.abc import Sequence
from concurrent.futures import CancelledError, Future, wait
from contextlib import suppress
from typing import Any

from exactsweep.batch.error import BatchError
from exactsweep.batch.work import Chunk, Work
from exactsweep.formats.error import FormatError
from exactsweep.numbers.error import quote, require_imports

LOCAL = "local"
"""Instead of an address: a cluster of this machine, for as long as the batch runs."""

_ADDRESS = re.compile(
    r"(?:[a-z]{2,8}://)?(?P<host>[\w.-]{1,253}|\[[0-9A-Fa-f:.%\w]{2,60}\])(?::(?P<port>[0-9]{1,5}))?"
)
# Seconds between two looks at whether the scheduler is still there.
_LOOK = 0.5


class Cluster:
    """The workers of a Dask scheduler, each of which is sent the work once.

    A worker that comes later, or in place of one that died, is sent it, too; Dask repeats what a
    lost worker was at.

    Args:
        work: the batch.
        address: of the scheduler, or LOCAL.
        count: how many processes a LOCAL cluster has.

    Raises:
        BatchError: no scheduler answers there.
    """

    def __init__(self, work: Work, address: str, count: int) -> None:
        _require_address(address)
        dask = _dask()
        self.lost: tuple[type[BaseException], ...] = (dask.KilledWorker,)
        self.closed: type[Exception] = dask.client.ClosedClientError
        self.own = None
        try:
            if address == LOCAL:
                # It serves its state by HTTP even so; on some port that is free, then.
                self.own = dask.LocalCluster(
                    n_workers=count,
                    threads_per_worker=1,
                    dashboard_address="127.0.0.1:0",
                    scheduler_kwargs={"dashboard": False},
                )
            self.client = dask.Client(self.own or address, timeout=5)
            self.count = max(1, sum(self.client.nthreads().values()))
            self.name = f"exactsweep-{id(self):x}"
            self.client.register_plugin(_holder(work, self.name))
        # Dask asserts some of what it takes for granted.
        except (OSError, ValueError, AssertionError) as error:
            reason = str(error).partition("\n")[0]
            raise BatchError(f"no Dask scheduler at {quote(address)}: {reason}") from None
        self.connection = self.client.scheduler_comm
        self.pool = self.client.get_executor(pure=False)

    def submit(self, chunk: Chunk) -> RecordsOfCluster:
        """Compute a chunk in some process.

        Raises:
            CancelledError: the scheduler is gone.
        """
        try:
            return RecordsOfCluster(self.pool.submit(_compute, chunk, self.name), self)
        except self.closed:
            raise CancelledError from None

    def is_gone(self) -> bool:
        """Return whether the scheduler is gone, or was and has forgotten the batch."""
        return self.client.status != "running" or self.client.scheduler_comm is not self.connection

    def close(self) -> None:
        """Leave the cluster, and end it if it is our own."""
        # If the scheduler is gone, there is nothing left to be tidied up.
        with suppress(OSError, self.closed):
            self.pool.shutdown(wait=False)
            if self.own is None and not self.is_gone():
                self.client.unregister_worker_plugin(self.name)
        self.client.close()
        if self.own is not None:
            self.own.close()


def _require_address(address: str) -> None:
    """Refuse what cannot be the address of a scheduler: a host, perhaps with a port."""
    match = _ADDRESS.fullmatch(address)
    if not match or match["host"].isdigit() or not 0 < int(match["port"] or 1) < 2**16:
        raise BatchError(f"no Dask scheduler at {quote(address)}: not as in tcp://host:8786")


class RecordsOfCluster:
    """A result of a chunk that is still to come."""

    def __init__(self, future: Future[Sequence[bytes]], cluster: Cluster) -> None:
        self.future, self.cluster = future, cluster

    def result(self) -> Sequence[bytes]:
        """Wait for the records; raises CancelledError if the scheduler is gone."""
        # Dask never settles the futures of results that it was fetching when the scheduler went.
        while not wait([self.future], _LOOK).done:
            if self.cluster.is_gone():
                raise CancelledError
        return self.future.result()


def _dask() -> Any:
    with require_imports("distributed", "a scheduler", FormatError):
        import distributed
    return distributed


def _holder(held: Work, plugin_name: str) -> object:
    # Of a local class, which is sent whole.
    class Holder(_dask().WorkerPlugin):  # type: ignore[misc]
        name = plugin_name
        work = held

    return Holder()


def _compute(chunk: Chunk, name: str) -> Sequence[bytes]:
    work: Work = _dask().get_worker().plugins[name].work
    return work.lines(chunk)
