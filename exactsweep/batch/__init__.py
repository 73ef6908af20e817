"""Resumable batches of pairs, on all processors or a Dask cluster."""

from exactsweep.batch.job import Job, take_all_pairs, take_listed_pairs
from exactsweep.batch.parts import Part, read_parts
from exactsweep.batch.record import QUANTITIES
from exactsweep.batch.run import Counts, run
from exactsweep.batch.work import BatchError
from exactsweep.formats.rounding import Rounding

__all__ = [
    "QUANTITIES",
    "BatchError",
    "Counts",
    "Job",
    "Part",
    "Rounding",
    "read_parts",
    "run",
    "take_all_pairs",
    "take_listed_pairs",
]
