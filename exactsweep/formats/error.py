"""Errors of readers and writers."""

from exactsweep.numbers.error import ExactSweepError


class FormatError(ExactSweepError):
    """Unreadable input, or output that a format cannot represent; the message says where."""


class OrnamentError(FormatError):
    """An element that cannot be part of an outline, and so can be skipped."""
