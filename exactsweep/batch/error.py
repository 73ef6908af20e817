"""Errors of batches."""

from exactsweep.numbers.error import ExactSweepError


class BatchError(ExactSweepError):
    """A batch that cannot run or resume; the message says why."""
