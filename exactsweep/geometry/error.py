"""The base of all refusals, and how a refusal says what it is about."""


class ExactSweepError(ValueError):
    """Whatever this package refuses; the message says what, where and why."""


class name_refusals:  # noqa: N801
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

    def __init__(self, name: str) -> None:
        self.name = name

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        if isinstance(error, ExactSweepError):
            raise type(error)(f"{self.name}: {error}") from None
