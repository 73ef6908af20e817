"""The refusal of a batch as a whole."""

from exactsweep.numbers.error import ExactSweepError


class BatchError(ExactSweepError):
    """A batch that cannot be run or resumed; the message says why."""
