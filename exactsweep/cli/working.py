"""A line on a terminal about a command that takes longer than a second."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager


@contextmanager
def working(doing: str) -> Iterator[Callable[[str], None]]:
    """Say on a terminal, after a second, what is being done, and yield what changes the words."""
    if not _has_terminal():
        yield lambda doing: None
        return
    from exactsweep.cli import bar

    with bar.words() as tell:
        tell(doing)
        yield tell


def _has_terminal() -> bool:
    return sys.stderr is not None and sys.stderr.isatty()
