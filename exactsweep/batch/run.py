"""Execution of a batch: chunks go to processes, records return in order."""

from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import CancelledError, Future
from typing import NamedTuple

from exactsweep.batch import workers as pools
from exactsweep.batch.job import Job
from exactsweep.batch.output import Output
from exactsweep.batch.work import BatchError, Chunk, NumberedPair, Work
from exactsweep.numbers.error import explain_type_errors, quote
from exactsweep.processes import count_cores

Processes = pools.LocalProcesses | pools.Cluster
MAX_WORKERS = 1024
_CHUNKS_AHEAD = 8  # in flight per process, to keep all busy while one is slow
_TRIES = 3  # processes that a single pair may kill


class Counts(NamedTuple):
    """Numbers of pairs, of error records, and of records from an earlier run."""

    pairs: int
    refused: int
    resumed: int


@explain_type_errors
def run(
    job: Job,
    output: str,
    *,
    workers: int | None = None,
    scheduler: str | None = None,
    restart: bool = False,
    progress: Callable[[int], None] | None = None,
) -> Counts:
    """Compute a batch, or resume an interrupted one.

    Args:
        job: from `take_all_pairs` or `take_listed_pairs`.
        output: a file for the records, one JSON line per pair, in order; with the suffix ".parquet"
            or ".csv", a table. Until complete, the records are in `output` + ".part".
        workers: the number of processes; by default one per processor.
        scheduler: the address of a Dask scheduler whose workers compute instead, or "local" for a
            new Dask cluster on this machine.
        restart: whether to discard the records of an earlier run.
        progress: called with the number of records whenever it grows.

    Raises:
        BatchError: the file cannot be written, has records of another batch, or another batch is
            writing to it; or no scheduler answers.

    Cost: the sweeps; memory for a few hundred pairs, and for the parts in each process.
    """
    with Output(output, job, restart=restart) as records:
        resumed = records.done
        if progress is not None:
            progress(resumed)
        if resumed < job.total:
            processes = _start_processes(job.work, workers, scheduler)
            try:
                for lines in _collect_in_order(job.chunks(resumed), processes, job.work):
                    records.write(lines)
                    if progress is not None:
                        progress(records.done)
            except CancelledError:
                raise BatchError(
                    f"lost the scheduler after {records.done} of {job.total} pairs; "
                    "run the same command to resume"
                ) from None
            except ImportError as error:
                raise BatchError(f"a worker runs a different installation: {error}") from None
            finally:
                processes.close()
        if records.done < job.total:
            raise BatchError(f"{job.path} was truncated while the batch ran")
        records.finish()
        return Counts(job.total, records.refused, resumed)


def _start_processes(work: Work, workers: int | None, scheduler: str | None) -> Processes:
    if workers is not None and not 1 <= workers <= MAX_WORKERS:
        raise BatchError(f"the number of workers must be 1 to {MAX_WORKERS}, not {quote(workers)}")
    if scheduler is None:
        return pools.LocalProcesses(work, workers)
    return pools.Cluster(work, scheduler, workers or count_cores())


def _collect_in_order(
    chunks: Iterator[Chunk], processes: Processes, work: Work
) -> Iterator[Sequence[bytes]]:
    pending: deque[tuple[Chunk, Future[Sequence[bytes]] | pools.RecordsOfCluster]] = deque()
    for chunk in chunks:
        pending.append((chunk, processes.submit(chunk)))
        if len(pending) >= _CHUNKS_AHEAD * processes.count:
            yield _wait_for_result(*pending.popleft(), processes, work)
    while pending:
        yield _wait_for_result(*pending.popleft(), processes, work)


def _wait_for_result(
    chunk: Chunk,
    answer: Future[Sequence[bytes]] | pools.RecordsOfCluster,
    processes: Processes,
    work: Work,
) -> Sequence[bytes]:
    try:
        return answer.result()
    except processes.lost:
        # Some pair kills its process: compute one pair at a time.
        return [_compute_alone(pair, processes, work) for pair in chunk]


def _compute_alone(pair: NumberedPair, processes: Processes, work: Work) -> bytes:
    for _ in range(_TRIES):
        try:
            (line,) = processes.submit([pair]).result()
        except processes.lost:
            continue
        return line
    return work.format_lost_pair(*pair)
