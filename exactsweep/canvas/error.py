"""The error of pictures."""

from exactsweep.numbers.error import ExactSweepError


class DrawError(ExactSweepError):
    """A picture that cannot be drawn or saved."""
