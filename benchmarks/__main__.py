"""`python -m benchmarks`: commands that measure growth, time and memory."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import Path
from tempfile import TemporaryDirectory

import click
from rich.console import Console

from benchmarks import batches as batch_runs
from benchmarks import fair as fair_runs
from benchmarks import floors as floors_runs
from benchmarks import growth as growth_runs
from benchmarks import layouts as layout_runs
from benchmarks import scaling as scaling_runs
from benchmarks import spent as spent_counts
from benchmarks.clock import machine
from benchmarks.peers.cgal import Cgal, compile_program
from benchmarks.peers.run import Comparison, compare, tabulate

WIDTH = 140
WIDE = 190

quick_option = click.option(
    "--quick", is_flag=True, help="Measure only small pairs, and skip timing."
)
limit_option = click.option(
    "--limit", default=20.0, help="Time limit per program and pair, in seconds."
)
cgal_option = click.option(
    "--cgal",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    help="Use this compiled CGAL program instead of compiling it in a temporary folder.",
)


def measure_peers(quick: bool, limit: float) -> Comparison:
    """Run the comparison with its progress on standard error."""
    return compare(limit=limit, quick=quick, say=Console(stderr=True, style="dim").print)


def show(tables: Iterable[object], width: int = WIDTH) -> None:
    """Print a description of the machine, then each table as soon as it is ready."""
    console = Console(width=max(width, Console().width))
    console.print(machine())
    for table in tables:
        console.print(table)


@click.group()
def main() -> None:
    """Compare growth with the claimed bounds, and times with other programs."""


@main.command()
@quick_option
def scaling(quick: bool) -> None:
    """Measure operations, seconds and bytes of each procedure over doubling sizes.

    The exit code is 1 if any cost exceeds the paper's bound.
    """
    console = Console(width=max(WIDTH, Console().width))
    console.print(machine())
    measured = []
    for series in scaling_runs.measure_all(quick=quick):
        measured.append(series)
        console.print(scaling_runs.series_table(series))
    console.print(scaling_runs.summary_table(measured))
    beyond = [series.failure for series in measured if not series.is_flat]
    console.print(*(beyond or ["All costs are within the bounds."]), sep="\n")
    sys.exit(bool(beyond))


@main.command()
def spent() -> None:
    """Count the instructions, objects and comparisons of small pairs."""
    if sys.version_info >= spent_counts.TOO_NEW:
        raise click.ClickException("CPython 3.12 and later cannot trace every instruction")
    show(spent_counts.tabulate())


@main.command()
@quick_option
def floors(quick: bool) -> None:
    """Measure proofs, undercuts and the page, compared with the sweep."""
    show(floors_runs.tabulate(quick=quick))


@main.command()
@quick_option
@click.option(
    "-o", "plot", type=click.Path(path_type=Path), help="Plot the results as FILE.svg and FILE.png."
)
def growth(quick: bool, plot: Path | None) -> None:
    """Measure seconds and memory of hard shapes over doubling sizes."""
    measured = list(growth_runs.measure_all(quick=quick))
    show([growth_runs.tabulate(measured)])
    if plot is not None:
        # Only plots need matplotlib.
        from benchmarks import plots

        plots.shapes(measured, plot)


@main.command()
@quick_option
@click.option("--workers", default=2, help="Number of processes in the Dask cluster.")
def batches(workers: int, quick: bool) -> None:
    """Measure batches of increasing size on a Dask cluster, and predict a batch of 10^9 pairs."""
    show(batch_runs.tabulate(workers=workers, quick=quick))


@main.command()
@quick_option
@limit_option
def peers(quick: bool, limit: float) -> None:
    """Compare sweeps with SFCGAL, shapely, Clipper and KLayout."""
    found = measure_peers(quick, limit)
    skipped = (f"skipped: {name}, {reason}" for name, reason in found.skipped.items())
    show([", ".join(found.versions.values()), *skipped, *tabulate(found)])


@main.command()
@quick_option
@cgal_option
def layouts(quick: bool, cgal: Path | None) -> None:
    """Compare the judge of layouts with CGAL and shapely, and measure its growth."""
    show(layout_runs.tabulate(cgal, quick=quick))


@main.command()
@limit_option
@cgal_option
def fair(limit: float, cgal: Path | None) -> None:
    """Compare CGAL and the kernel on cached, rebuilt and parsed polygons."""
    with TemporaryDirectory() as folder:
        program = Cgal(cgal or compile_program(Path(folder)), limit, fair_runs.SECONDS)
        show(fair_runs.tabulate(program), WIDE)


@main.command()
@click.option("-o", "folder", required=True, type=click.Path(file_okay=False, path_type=Path))
@click.option("--redraw", is_flag=True, help="Rewrite the report from saved measurements.")
@quick_option
@limit_option
def report(folder: Path, redraw: bool, quick: bool, limit: float) -> None:
    """Measure everything, and write Markdown and plots into a folder."""
    # Only plots need matplotlib.
    from benchmarks.report import save, write

    if not redraw:
        growth = list(scaling_runs.measure_all(quick=quick))
        save(folder, growth, measure_peers(quick, limit))
    click.echo(write(folder))


if __name__ == "__main__":
    main()
