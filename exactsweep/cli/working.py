"""Progress of long commands on a terminal: a status line or a bar."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Timer
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.progress import Progress
    from rich.status import Status

PATIENCE = 1.0
"""Seconds before the first progress message."""


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
    """Show a progress bar on a terminal after one second; yield a function that updates it."""
    if not _has_terminal():
        yield lambda done, words: None
        return
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TextColumn,
        TimeRemainingColumn,
    )

    progress = Progress(
        BarColumn(bar_width=24),
        MofNCompleteColumn(),
        TextColumn("{task.fields[words]}", markup=False),
        TimeRemainingColumn(),
        console=Console(stderr=True),
        transient=True,
    )
    task = progress.add_task("", total=total, words="")

    def show(done: int, words: str) -> None:
        speed = progress.tasks[task].speed
        rate = "" if speed is None else f"{speed:.0f}/s"
        progress.update(task, completed=done, words=words or rate)

    with _show_later(progress):
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
