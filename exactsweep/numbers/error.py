"""The base class of all refusals, and context managers that name the refused thing."""

from collections.abc import Iterator
from contextlib import contextmanager


class ExactSweepError(ValueError):
    """A refusal by this package; the message says what is wrong, and where."""


class name_refusals:  # noqa: N801
    """Put a name in front of the message of a refusal inside a `with` block.

    Args:
        name: the name of the input, such as "generatrix" or "hole 2".
        refusal: the type of the error to raise, for any ValueError; None keeps the type of a
            refusal, and other errors as they are.

    Raises:
        ExactSweepError: the refusal, with the name before its message.

    Example:
        >>> with name_refusals("hole 2"):
        ...     raise ExactSweepError("zero area")
        Traceback (most recent call last):
        exactsweep.numbers.error.ExactSweepError: hole 2: zero area
    """

    def __init__(self, name: str, refusal: type[ExactSweepError] | None = None) -> None:
        self.name, self.refusal = name, refusal

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        if isinstance(error, ValueError if self.refusal else ExactSweepError):
            raise (self.refusal or type(error))(f"{self.name}: {error}") from None


@contextmanager
def require_imports(
    package: str, extra: str, what: str, refusal: type[ExactSweepError]
) -> Iterator[None]:
    """Refuse if an import inside the `with` block fails, and name the extra to install.

    Args:
        package: the library.
        extra: the extra of exactsweep that installs the library.
        what: the feature that needs the library.
        refusal: the type of the error to raise.

    Raises:
        ExactSweepError: the refusal, if the library is missing or cannot be loaded.

    Example:
        >>> with require_imports("naps", "bed", "rest", ExactSweepError):
        ...     import naps
        Traceback (most recent call last):
        exactsweep.numbers.error.ExactSweepError: rest needs naps: pip install 'exactsweep[bed]'
    """
    try:
        yield
    except ModuleNotFoundError:
        raise refusal(f"{what} needs {package}: pip install 'exactsweep[{extra}]'") from None
    except ImportError as error:  # of a library that it needs, or of memory
        said = " ".join(str(error).split())
        raise refusal(f"{what} needs {package}, which cannot be loaded: {said}") from None
