"""The refusal of a text or file."""

from collections.abc import Iterator
from contextlib import contextmanager

from exactsweep.geometry.error import ExactSweepError


class FormatError(ExactSweepError):
    """Input that cannot be read or output that a format cannot hold; the message says where."""


@contextmanager
def require_imports(package: str, extra: str, what: str) -> Iterator[None]:
    """Refuse, if an import inside the `with` block fails, and say what to install.

    Args:
        package: the library.
        extra: the extra of exactsweep that has it.
        what: what it is needed for.

    Raises:
        FormatError: the library is not there, or cannot be loaded.

    Example:
        >>> with require_imports("dreams", "night", "sleep"):
        ...     import dreams
        Traceback (most recent call last):
        exactsweep.formats.error.FormatError: sleep needs dreams: pip install 'exactsweep[night]'
    """
    try:
        yield
    except ModuleNotFoundError:
        raise FormatError(f"{what} needs {package}: pip install 'exactsweep[{extra}]'") from None
    except ImportError as error:  # of a library that it needs, or for want of memory
        said = " ".join(str(error).split())
        raise FormatError(f"{what} needs {package}, which cannot be loaded: {said}") from None
