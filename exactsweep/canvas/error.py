"""The refusal of a picture."""


class DrawError(ValueError):
    """A picture that cannot be drawn or written; the message says why."""
