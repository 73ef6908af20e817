"""The refusal of a text or file."""

from exactsweep.numbers.error import ExactSweepError


class FormatError(ExactSweepError):
    """Input that cannot be read or output that a format cannot hold; the message says where."""


class OrnamentError(FormatError):
    """A thing that draws no outline, nor part of one, so that nothing is lost without it."""
