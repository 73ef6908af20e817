"""The exception for pictures."""

from exactsweep.numbers.error import ExactSweepError


class DrawError(ExactSweepError):
    """Raised if a picture cannot be drawn or saved."""
