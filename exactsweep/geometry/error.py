"""The base of all refusals, and how a refusal says what it is about."""

from collections.abc import Iterator
from contextlib import contextmanager


class ExactSweepError(ValueError):
    """Whatever this package refuses; the message says what, where and why."""


@contextmanager
def name_refusals(name: str) -> Iterator[None]:
    """Put a name in front of whatever is refused inside a `with` block.

    Args:
        name: of the thing that is read there, such as "generatrix" or "hole 2".

    Raises:
        ExactSweepError: the refusal, of the type that it has, its message after the name.

    Example:
        >>> with name_refusals("hole 2"):
        ...     raise ExactSweepError("zero area")
        Traceback (most recent call last):
        exactsweep.geometry.error.ExactSweepError: hole 2: zero area
    """
    try:
        yield
    except ExactSweepError as error:
        raise type(error)(f"{name}: {error}") from None
