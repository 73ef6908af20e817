"""Progress of long commands on a terminal."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Timer
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.progress import Progress
    from rich.status import Status

PATIENCE = 1.0  # seconds before progress is shown


@contextmanager
def working(doing: str) -> Iterator[Callable[[str], None]]:
    """Show a status line on a terminal after one second; yield a function that updates it."""
    if not _has_terminal():
        yield lambda doing: None
        return
    from rich.console import Console

    status = Console(stderr=True).status(doing)
    with _show_later(status):
        yield status.update


@contextmanager
def show_bar(total: int | None) -> Iterator[Callable[[int, str], None]]:
    """Show a bar instead of a status line."""
    if not _has_terminal():
        yield lambda done, words: None
        return
    from rich import progress
    from rich.console import Console

    bar = progress.Progress(
        progress.BarColumn(bar_width=24),
        progress.MofNCompleteColumn(),
        progress.TextColumn("{task.fields[words]}", markup=False),
        progress.TimeRemainingColumn(),
        console=Console(stderr=True),
        transient=True,
    )
    task = bar.add_task("", total=total, words="")

    def show(done: int, words: str) -> None:
        speed = bar.tasks[task].speed
        rate = "" if speed is None else f"{speed:.0f}/s"
        bar.update(task, completed=done, words=words or rate)

    with _show_later(bar):
        yield show


@contextmanager
def _show_later(display: Status | Progress) -> Iterator[None]:
    waiting = Timer(PATIENCE, display.start)
    waiting.daemon = True
    waiting.start()
    try:
        yield
    finally:
        waiting.cancel()
        waiting.join()
        display.stop()


def _has_terminal() -> bool:
    return sys.stderr is not None and sys.stderr.isatty()
