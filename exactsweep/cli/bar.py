"""The progress of a command, for a terminal: a bar with rate and remaining time, or words."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Timer
from time import monotonic

from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    ProgressColumn,
    Task,
    TaskID,
    TimeRemainingColumn,
)
from rich.text import Text

_PATIENCE = 1.0


class _Rate(ProgressColumn):
    """The rate of work, as so many a second."""

    def render(self, task: Task) -> Text:
        speed = task.finished_speed or task.speed
        return Text("" if speed is None else f"{speed:.0f}/s")


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
    console, begun = console or Console(stderr=True), clock()
    if not console.is_terminal:
        yield lambda done: None
        return
    columns = BarColumn(), MofNCompleteColumn(), _Rate(), TimeRemainingColumn()
    with Progress(*columns, console=console, get_time=clock) as progress:
        task: TaskID | None = None

        def show(done: int) -> None:
            nonlocal task
            if task is None and clock() - begun < _PATIENCE:
                return
            if task is None:
                task = progress.add_task("", total=total, completed=done)
            progress.update(task, completed=done)

        yield show


@contextmanager
def words(
    console: Console | None = None, timer: Callable[[float, Callable[[], None]], Timer] = Timer
) -> Iterator[Callable[[str], None]]:
    """Show the current activity on standard error, if that is a terminal, after the first second.

    Args:
        console: the console of the words.
        timer: starts the display later.

    Yields:
        A function that sets the activity.
    """
    console = console or Console(stderr=True)
    if not console.is_terminal:
        yield lambda doing: None
        return
    status = console.status("")
    waiting = timer(_PATIENCE, status.start)
    waiting.daemon = True
    waiting.start()
    try:
        yield status.update
    finally:
        waiting.cancel()
        waiting.join()
        status.stop()
