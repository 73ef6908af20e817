"""The table of a run, for people to read."""

from __future__ import annotations

from collections.abc import Iterable

from rich.table import Table

from exactsweep.conform.summary import Summary
from exactsweep.report import laid_out


def table(summary: Summary, terminal_width: int | None = None) -> str:
    """Write how many cases of each class and flag got which verdict.

    Args:
        summary: of a run.
        terminal_width: columns of the terminal to be filled; None for plain text.

    Returns:
        Lines of text; for a terminal also its control sequences.

    Example:
        >>> from exactsweep.conform.outcome import Outcome
        >>> from exactsweep.conform.verdict import Verdict
        >>> outcomes = [Outcome("a", "CC", ("undercut",), Verdict.EXACT),
        ...             Outcome("b", "CC", (), Verdict.WRONG)]
        >>> print(table(Summary(outcomes)), end="")
                  cases  exact  wrong
        all           2      1      1
        CC            2      1      1
        undercut      1      1
    """
    grid = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0))
    grid.add_column(style="bold")
    verdicts = summary.verdicts()
    for name in ("cases", *verdicts):
        grid.add_column(name, justify="right")
    for group in summary.groups():
        counts = (summary.total(verdict, group) for verdict in verdicts)
        grid.add_row(group, str(summary.total(group=group)), *_shown(counts))
    return laid_out([grid], terminal_width)


def _shown(counts: Iterable[int]) -> Iterable[str]:
    return (str(count) if count else "" for count in counts)
