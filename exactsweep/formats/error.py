"""The refusal of a text or file."""


class FormatError(ValueError):
    """Input that cannot be read or output that a format cannot hold; the message says where."""
