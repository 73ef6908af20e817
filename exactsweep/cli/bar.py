"""The progress of a command, as rich shows it: a bar with rate and remaining time, or words."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Timer

from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    ProgressColumn,
    Task,
    TimeRemainingColumn,
)
from rich.text import Text

Clock = Callable[[], float]
Bar = tuple[Callable[[int], None], Callable[[], None]]


class _Rate(ProgressColumn):
    """The rate of work, as so many a second."""

    def render(self, task: Task) -> Text:
        speed = task.finished_speed or task.speed
        return Text("" if speed is None else f"{speed:.0f}/s")


def start_bar(total: int, done: int, console: Console | None, clock: Clock) -> Bar:
    """Start a progress bar, and return what sets its progress and what ends it."""
    console = console or Console(stderr=True)
    columns = BarColumn(), MofNCompleteColumn(), _Rate(), TimeRemainingColumn()
    progress = Progress(*columns, console=console, get_time=clock, disable=not console.is_terminal)
    task = progress.add_task("", total=total, completed=done)
    progress.start()
    return (lambda done: progress.update(task, completed=done)), progress.stop


@contextmanager
def words(
    patience: float,
    console: Console | None = None,
    timer: Callable[[float, Callable[[], None]], Timer] = Timer,
) -> Iterator[Callable[[str], None]]:
    """Show the current activity on standard error, if that is a terminal, after a while.

    Args:
        patience: the seconds before.
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
    waiting = timer(patience, status.start)
    waiting.daemon = True
    waiting.start()
    try:
        yield status.update
    finally:
        waiting.cancel()
        waiting.join()
        status.stop()
