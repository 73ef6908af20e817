"""The refusal of a batch as a whole."""


class BatchError(ValueError):
    """A batch that cannot be run or resumed; the message says why."""
