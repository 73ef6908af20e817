"""The growth of the procedures: operations, seconds and bytes over doubling sizes.

`exactsweep.paper.costs` defines the pairs, and the permitted excess of exponents over the paper's
bounds, also for the ledger's rows on costs.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from rich.table import Table

from benchmarks.shapes import measure_shapes
from exactsweep.paper.claim import Effort
from exactsweep.paper.costs import COSTS, tabulate
from exactsweep.paper.growth import Growth


def measure_all(*, quick: bool = False) -> Iterator[Growth]:
    """Measure all series; if `quick`, use fewer sizes and skip timing."""
    for cost in COSTS:
        yield from cost.measure(Effort(quick=quick))
    yield from measure_shapes(quick=quick)


def series_table(series: Growth) -> Table:
    """Tabulate all sizes of one series."""
    title = f"{series.what} on {series.family}: O({series.bound}), {series.varied} doubled"
    table = Table(title=title, title_justify="left")
    for name in ("m", "n", series.unit, f"{series.unit} / ({series.bound})"):
        table.add_column(name, justify="right")
    for point in series.points:
        table.add_row(str(point.m), str(point.n), f"{point.count:,.6g}", f"{point.ratio:.3g}")
    return table


def summary_table(measured: Iterable[Growth]) -> Table:
    """Tabulate fitted exponents and those of the paper's bounds."""
    found = tabulate(measured)
    table = Table(title=found.caption, title_justify="left")
    for k, name in enumerate(found.header):
        table.add_column(name, justify="left" if k < 4 else "right")
    for row in found.rows:
        table.add_row(*row)
    return table
