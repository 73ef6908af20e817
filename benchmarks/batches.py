"""The cost of a batch on a Dask cluster, and a linear model of it.

The cost is the processor time of the client with its scheduler, and of the workers, on one machine.
In the model, each pair costs the workers the same time, and each chunk the client. The model is
fitted to all batches except the largest, and compared with the largest.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory
from time import process_time
from typing import NamedTuple

from click import ClickException
from rich.table import Table

from benchmarks.families import FAMILIES
from exactsweep import Polygon
from exactsweep.batch import run, take_all_pairs
from exactsweep.batch.job import Job
from exactsweep.batch.parts import Part

SIDES = (1, 10, 32, 100)  # parts in both lists; a single pair measures startup and shutdown
LARGE, LARGE_CHUNK = 10**9, 512
_SAMPLE = 1000


class BatchCost(NamedTuple):
    """The cost of a batch: seconds of processor time, and bytes of its records."""

    pairs: int
    chunks: int
    client: float
    workers: float
    bytes: int


def draw_parts(count: int) -> list[Part]:
    """Make parts with 16 to 24 vertices from all classes."""
    names = ("cc", "cm", "mm", "stair")
    return [
        Part(f"{name} {k}", Polygon(FAMILIES[name](16 + k % 9 // 2 * 2, 16, k)[1]))
        for k in range(count)
        for name in [names[k % 4]]
    ]


def measure(job: Job, folder: Path, workers: int) -> BatchCost:
    """Run a batch on a new Dask cluster."""
    output = folder / "records.jsonl"
    before = _read_seconds()
    run(job, str(output), workers=workers, scheduler="local", restart=True)
    client, children = (now - start for now, start in zip(_read_seconds(), before, strict=True))
    chunks = sum(1 for _ in job.chunks(0))
    return BatchCost(job.total, chunks, client, children, output.stat().st_size)


def measure_pair(job: Job) -> float:
    """Measure the seconds per pair of a batch in this process."""
    pairs = [pair for chunk in job.chunks(0) for pair in chunk]
    pairs = Random(0).sample(pairs, min(_SAMPLE, len(pairs)))
    start = process_time()
    job.work.lines(pairs)
    return (process_time() - start) / len(pairs)


def tabulate(*, workers: int, quick: bool) -> Iterator[Table]:
    """Tabulate measured batches, and a cost model for these and for a large batch."""
    with TemporaryDirectory() as folder:
        jobs = []
        for side in SIDES[:3] if quick else SIDES:
            parts = draw_parts(side)
            jobs.append(take_all_pairs(parts, parts, "areas"))
        # The first one includes imports.
        costs = [measure(job, Path(folder), workers) for job in (jobs[0], *jobs)][1:]
        alone = measure_pair(jobs[-1])
    yield tabulate_costs(costs, workers)
    yield tabulate_model(costs, alone)


def tabulate_costs(costs: Sequence[BatchCost], workers: int) -> Table:
    """Tabulate the measurements, with the cost of an additional pair in each batch."""
    table = Table(
        *("pairs", "chunks", "client and scheduler", "workers", "records"),
        *("workers, ms per additional pair", "client, ms per additional chunk"),
        title=f"processor time, {workers} workers",
    )
    for k, cost in enumerate(costs):
        slopes = ["", ""]
        if k:
            before = costs[k - 1]
            slopes = [
                f"{1000 * (cost.workers - before.workers) / (cost.pairs - before.pairs):.2f}",
                f"{1000 * (cost.client - before.client) / (cost.chunks - before.chunks):.1f}",
            ]
        table.add_row(
            *(f"{cost.pairs:,}", f"{cost.chunks:,}", f"{cost.client:.1f} s"),
            *(f"{cost.workers:.1f} s", f"{cost.bytes:,}", *slopes),
        )
    return table


def tabulate_model(costs: Sequence[BatchCost], alone: float) -> Table:
    """Tabulate the model's predictions for the last batch and a large one."""
    start, middle, largest = costs[0], costs[-2], costs[-1]
    pair = (middle.workers - start.workers) / (middle.pairs - start.pairs)
    chunk = (middle.client - start.client) / (middle.chunks - start.chunks)
    record = middle.bytes / middle.pairs
    table = Table(
        *("pairs", "pairs per chunk", "client and scheduler", "workers", "records"),
        title=f"by the model: {1000 * pair:.2f} ms per pair ({1000 * alone:.2f} in one process)"
        f", {1000 * chunk:.1f} ms per chunk, {record:.0f} bytes per record",
    )
    client = start.client + chunk * (largest.chunks - start.chunks)
    workers = start.workers + pair * (largest.pairs - start.pairs)
    table.add_row(
        *(f"{largest.pairs:,}", f"{largest.pairs / largest.chunks:.0f}", f"{client:.1f} s"),
        *(f"{workers:.1f} s", f"{record * largest.pairs:,.0f}"),
    )
    client = chunk * LARGE / LARGE_CHUNK
    table.add_row(
        *(f"{LARGE:,}", f"{LARGE_CHUNK}", f"{client / 3600:.1f} h"),
        *(f"{pair * LARGE / 3600:,.0f} h", f"{record * LARGE:,.0f}"),
    )
    table.caption = f"{pair * LARGE / client:.0f} workers saturate the scheduler"
    return table


def _read_seconds() -> list[float]:
    """Return the processor time of this process and its finished children."""
    try:
        from resource import RUSAGE_CHILDREN, RUSAGE_SELF, getrusage
    except ImportError:
        raise ClickException(
            "the processor time of finished processes is only available on POSIX systems"
        ) from None
    used = [getrusage(who) for who in (RUSAGE_SELF, RUSAGE_CHILDREN)]
    return [usage.ru_utime + usage.ru_stime for usage in used]
