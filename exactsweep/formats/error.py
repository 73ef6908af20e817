"""Errors of readers and writers."""

from exactsweep.numbers.error import ExactSweepError


class FormatError(ExactSweepError):
    """Input that cannot be read or output that a format cannot hold; the message says where."""


class OrnamentError(FormatError):
    """An element that cannot be part of an outline, and can be omitted without loss."""
