"""How the procedures grow: counted operations and time over doubling sizes.

Operations are multiplications and comparisons of coordinates (see `counting`) and vertices that
come out, the same on every run.
The bounds are the paper's; the size of LowerEnvelope's input is counted, not estimated.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from rich.table import Table

from benchmarks import procedures as p
from benchmarks.clock import milliseconds
from benchmarks.families import FAMILIES
from benchmarks.growth import Point, Series
from benchmarks.procedures import Procedure
from exactsweep.paper.counting import counting, make_counted
from exactsweep.paper.pairs import Pair

DOUBLINGS, QUICK_DOUBLINGS = 5, 3


class Run(NamedTuple):
    """A procedure on a family, from a first size on; the size that is not varied is fixed."""

    procedure: Procedure
    family: str
    varied: str
    first: int
    fixed: int = 0

    def sizes(self, *, quick: bool = False) -> list[tuple[int, int]]:
        """The (m, n), from the least on."""
        first, doublings = self.first, DOUBLINGS
        if quick:
            first, doublings = min(first, 16), QUICK_DOUBLINGS
        doubled = [first * 2**k for k in range(doublings + 1)]
        if self.varied == "m":
            return [(size, self.fixed) for size in doubled]
        if self.varied == "n":
            return [(self.fixed, size) for size in doubled]
        return [(size, size) for size in doubled]


BOTH = "m = n"

# The bound is attained on the family that comes first for each procedure.
RUNS = (
    Run(p.TRAJECTORY_CC, "cc", BOTH, 512),
    Run(p.SWEEP_INNER_CC, "cc", BOTH, 512),
    Run(p.SWEEP_OUTER_CC, "cc", BOTH, 512),
    Run(p.TRAJECTORY_CM, "cm_hard", BOTH, 16),
    Run(p.TRAJECTORY_CM, "cm_hard", "m", 32, 64),
    Run(p.TRAJECTORY_CM, "cm_hard", "n", 32, 64),
    Run(p.TRAJECTORY_CM, "cm", BOTH, 16),
    Run(p.SWEEP_INNER_CM, "cm_undercut", BOTH, 16),
    Run(p.SWEEP_INNER_CM, "cm", BOTH, 16),
    Run(p.SWEEP_OUTER_CM, "cm_hard", BOTH, 16),
    Run(p.SWEEP_OUTER_CM, "cm", BOTH, 16),
    Run(p.LOWER_ENVELOPE_CM, "cm_undercut", BOTH, 16),
    Run(p.LOWER_ENVELOPE_CM, "cm", BOTH, 16),
    Run(p.LOWER_ENVELOPE_MM, "figure10", BOTH, 16),
    Run(p.LOWER_ENVELOPE_MM, "mm", BOTH, 16),
    Run(p.TRAJECTORY_MM, "figure10", BOTH, 16),
    Run(p.TRAJECTORY_MM, "mm", BOTH, 16),
    Run(p.TRAJECTORY_MM, "stair", BOTH, 16),
    Run(p.SWEEP_INNER_MM, "mm", BOTH, 8),
    Run(p.SWEEP_INNER_MM, "stair", BOTH, 8),
    Run(p.SWEEP_OUTER_MM, "figure10", BOTH, 8),
    Run(p.SWEEP_OUTER_MM, "figure10", "m", 8, 16),
    Run(p.SWEEP_OUTER_MM, "figure10", "n", 8, 8),
    Run(p.SWEEP_OUTER_MM, "mm", BOTH, 8),
)


def measure(run: Run, *, quick: bool = False) -> Series:
    """Run a procedure over all its sizes; when it has to be quick, over small ones, not timed."""
    procedure, family = run.procedure, FAMILIES[run.family]
    series = Series(procedure.name, run.family, run.varied, procedure.claim)
    for m, n in run.sizes(quick=quick):
        generatrix, directrix = family(m, n, 0)
        task = procedure.task(Pair(make_counted(generatrix), make_counted(directrix)).chains)
        with counting() as tally:
            outcome = task()
        bound = outcome.bound or procedure.bound(m, n)
        time = None
        if not quick:
            task = procedure.task(Pair(generatrix, directrix).chains)
            time = min(milliseconds(task, 0.2))
        series.points.append(Point(m, n, tally.total + outcome.output, outcome.output, bound, time))
    return series


def measure_all(*, quick: bool = False) -> Iterator[Series]:
    """All rows."""
    for run in RUNS:
        yield measure(run, quick=quick)


def series_table(series: Series) -> Table:
    """All sizes of one series."""
    table = Table(
        title=f"{series.procedure} on {series.family}: O({series.bound}), {series.varied} doubled",
        title_justify="left",
    )
    for name in ("m", "n", "output", "operations", f"operations / ({series.bound})", "ms"):
        table.add_column(name, justify="right")
    for point in series.points:
        table.add_row(
            str(point.m),
            str(point.n),
            f"{point.output:,}",
            f"{point.operations:,}",
            f"{point.ratio:.3f}",
            "" if point.milliseconds is None else f"{point.milliseconds:.3g}",
        )
    return table


def summary(measured: Iterable[Series]) -> tuple[list[str], list[list[str]]]:
    """Fitted exponents beside the paper's, as (header, rows)."""
    header = ["procedure", "family", "doubled", "bound", "paper", "operations", "output", "time"]
    rows = []
    for series in measured:
        exponents = (series.claimed, series.counted, series.grown, series.timed)
        first, last = series.points[0].ratio, series.points[-1].ratio
        rows.append(
            [
                series.procedure,
                series.family,
                series.varied,
                series.bound,
                *map(_exponent, exponents),
                f"{first:.2f} → {last:.2f}",
                f"{series.last_growth:.2f}",
            ]
        )
    return [*header, "operations / bound", "last growth"], rows


def summary_table(measured: Iterable[Series]) -> Table:
    """The summary for the terminal."""
    table = Table(title="Fitted exponents in the size that is doubled", title_justify="left")
    header, rows = summary(measured)
    for k, name in enumerate(header):
        table.add_column(name, justify="left" if k < 4 else "right")
    for row in rows:
        table.add_row(*row)
    return table


def _exponent(value: float | None) -> str:
    return "-" if value is None else f"{value:.2f}"
