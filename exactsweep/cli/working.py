"""A line on a terminal about a command that takes longer than a second.

The rest, which imports rich, is in `bar`.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console

    from exactsweep.cli.bar import Bar

_PATIENCE = 1.0


@contextmanager
def working(doing: str) -> Iterator[Callable[[str], None]]:
    """Say on a terminal, after a second, what is being done, and yield what changes the words."""
    if not _has_terminal():
        yield lambda doing: None
        return
    from exactsweep.cli import bar

    with bar.words(_PATIENCE) as tell:
        tell(doing)
        yield tell


@contextmanager
def show_bar(
    total: int, console: Console | None = None, clock: Callable[[], float] = monotonic
) -> Iterator[Callable[[int], None]]:
    """Show a progress bar on standard error, if that is a terminal, after the first second.

    Args:
        total: the number at its end.
        console: the console of the bar.
        clock: returns the time in seconds.

    Yields:
        A function that sets the progress. Its first value does not count for the rate.
    """
    if console is None and not _has_terminal():
        yield lambda done: None
        return
    begun = clock()
    bar: Bar | None = None

    def show(done: int) -> None:
        nonlocal bar
        if bar is not None:
            bar[0](done)
        elif clock() - begun >= _PATIENCE:
            from exactsweep.cli.bar import start_bar

            bar = start_bar(total, done, console, clock)

    try:
        yield show
    finally:
        if bar is not None:
            bar[1]()


def _has_terminal() -> bool:
    return sys.stderr is not None and sys.stderr.isatty()
