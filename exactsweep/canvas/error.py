"""The refusal of a picture."""

from exactsweep.numbers.error import ExactSweepError


class DrawError(ExactSweepError):
    """A picture that cannot be drawn or written; the message gives the reason."""
