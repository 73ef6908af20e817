"""The progress bar of a run, on a terminal."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from exactsweep.conform.outcome import Outcome
from exactsweep.conform.run import Run
from exactsweep.words import count


@contextmanager
def progress(run: Run, total: int | None) -> Iterator[Callable[[Outcome], None]]:
    """Show how far a run is and the counts so far, on standard error, if that is a terminal.

    Args:
        run: the run.
        total: how many cases there will be, or None.

    Yields:
        A function to be told each outcome.
    """
    console = Console(stderr=True)
    bar = Progress(
        BarColumn(bar_width=24),
        MofNCompleteColumn(),
        TextColumn("{task.fields[counts]}", markup=False),
        TimeRemainingColumn(),
        console=console,
        transient=True,
        disable=not console.is_terminal,
    )
    with bar:
        task = bar.add_task("", total=total, counts="")

        def tell(outcome: Outcome) -> None:
            bar.update(task, advance=1, counts=counts(run))

        yield tell


def counts(run: Run) -> str:
    """Say how many cases got which verdict so far."""
    summary = run.summary
    said = (f"{summary.total(verdict)} {verdict}" for verdict in summary.verdicts())
    return ", ".join(said) or count(0, "case")
