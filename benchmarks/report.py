"""The report: Markdown with tables and plots in a folder."""

from __future__ import annotations

import pickle
from collections.abc import Sequence
from pathlib import Path

from rich.table import Table

from benchmarks import plots, scaling
from benchmarks.clock import machine
from benchmarks.peers.run import TIMES, Comparison, tabulate
from exactsweep.paper.growth import Growth
from exactsweep.paper.report import plot_ratios

MEASURED = "measured.pickle"
Measured = tuple[str, Sequence[Growth], Comparison]  # machine, growth and comparison


def save(folder: Path, measured: Sequence[Growth], found: Comparison) -> None:
    """Save the measurements, so that the report can be written again."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / MEASURED).write_bytes(pickle.dumps((machine(), measured, found)))


def load(folder: Path) -> Measured:
    kept: Measured = pickle.loads((folder / MEASURED).read_bytes())
    return kept


def write(folder: Path) -> Path:
    """Write report.md and its plots from the saved measurements; return the path of report.md."""
    described, measured, found = load(folder)
    plots.programs(found, folder / "programs")
    lines = ["# Benchmarks", "", f"{described}.", ""]
    lines += [f"Programs: {', '.join(found.versions.values())}.", ""]
    lines += [f"Skipped: {name}, {reason}.\n" for name, reason in found.skipped.items()]
    lines += ["## Growth", "", GROWTH, "", *markdown(scaling.summary_table(measured)), ""]
    for what in dict.fromkeys(series.what for series in measured):
        name = what.replace(" ", "_")
        chosen = [series for series in measured if series.what == what]
        (folder / f"{name}.svg").write_bytes(plot_ratios(chosen))
        lines += [f"![{what}]({name}.svg)", ""]
    lines += ["## Other programs", "", TIMES, ""]
    for table in tabulate(found):
        title = str(table.title)
        lines += [f"### {title[0].upper()}{title[1:]}", "", *markdown(table), ""]
    lines += ["![Time of the trajectory](programs.svg)", "", PROGRAMS, ""]
    path = folder / "report.md"
    path.write_text("\n".join(lines), encoding="utf-8")
    return path


GROWTH = (
    "Exponents are fitted by least squares on a log-log scale; exponents of seconds use the three "
    "largest sizes. The exponent of the bound is fitted over the same sizes, including logarithms. "
    "Operations are multiplications, comparisons of coordinates, and output vertices; they are the "
    "same in every run. Bytes are the peak without the input. The figures show all costs divided "
    "by the bounds."
)
PROGRAMS = "Median time for the trajectory, with minimum and maximum."


def markdown(table: Table) -> list[str]:
    """Return a table in Markdown.

    >>> table = Table("a", "b")
    >>> table.add_row("1", "2")
    >>> markdown(table)
    ['| a | b |', '|---|---|', '| 1 | 2 |']
    """
    rows = zip(*([column.header, *column.cells] for column in table.columns), strict=True)
    texts = [f"| {' | '.join(str(cell).replace('|', '/') for cell in row)} |" for row in rows]
    return [texts[0], f"|{'---|' * len(table.columns)}", *texts[1:]]
