"""The refusal of a text or file."""

from exactsweep.numbers.error import ExactSweepError


class FormatError(ExactSweepError):
    """Input that cannot be read or output that a format cannot hold; the message says where."""


class OrnamentError(FormatError):
    """An element that draws no outline and no part of one, so that nothing is lost without it."""
