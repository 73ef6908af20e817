"""`python -m benchmarks`: scaling, spent, floors, growth, batches, peers, layouts, report."""

from __future__ import annotations

import sys
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
from benchmarks.peers.measured import Comparison
from benchmarks.peers.run import compare
from benchmarks.peers.tables import tables

WIDTH = 140
WIDE = 190

quick_option = click.option("--quick", is_flag=True, help="Small pairs only, no seconds.")
limit_option = click.option(
    "--limit", default=20.0, help="Seconds that one program may take on one pair."
)
cgal_option = click.option(
    "--cgal",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    help="CGAL's program, if it is compiled already; otherwise it is, in a temporary folder.",
)


def measure_peers(quick: bool, limit: float, cgal: Path | None) -> Comparison:
    """Run the comparison; what is under way goes to standard error."""
    with TemporaryDirectory() as folder:
        return compare(
            Path(folder),
            limit=limit,
            quick=quick,
            cgal_program=cgal,
            say=Console(stderr=True, style="dim").print,
        )


@click.group()
def main() -> None:
    """Measure exactsweep: its growth beside the claimed bounds, and its time beside others'."""


@main.command()
@quick_option
def scaling(quick: bool) -> None:
    """Operations, seconds and bytes of each procedure over doubling sizes.

    The exit code is 1 if one of them grows beyond the paper's bound.
    """
    console = Console(width=max(WIDTH, Console().width))
    console.print(machine())
    measured = []
    for series in scaling_runs.measure_all(quick=quick):
        measured.append(series)
        console.print(scaling_runs.series_table(series))
    console.print(scaling_runs.summary_table(measured))
    beyond = [series.failure for series in measured if not series.is_flat]
    console.print(*(beyond or ["All are within the bounds."]), sep="\n")
    sys.exit(bool(beyond))


@main.command()
def spent() -> None:
    """Count what small pairs are spent on: instructions, objects, comparisons."""
    Console(width=max(WIDTH, Console().width)).print(*spent_counts.tabulate(), sep="\n")


@main.command()
@quick_option
def floors(quick: bool) -> None:
    """Measure proofs, undercuts and the page beside the sweep."""
    console = Console(width=max(WIDTH, Console().width))
    console.print(machine())
    for table in floors_runs.tabulate(quick=quick):
        console.print(table)


@main.command()
@quick_option
@click.option(
    "-o", "plot", type=click.Path(path_type=Path), help="Also plot, as FILE.svg and FILE.png."
)
def growth(quick: bool, plot: Path | None) -> None:
    """Measure seconds and memory of hard shapes over doubling sizes."""
    console = Console(width=max(WIDTH, Console().width))
    console.print(machine())
    measured = list(growth_runs.measure_all(quick=quick))
    console.print(growth_runs.tabulate(measured))
    if plot is not None:
        # matplotlib is needed for nothing else.
        from benchmarks import plots

        plots.shapes(measured, plot)


@main.command()
@quick_option
@click.option("--workers", default=2, help="How many processes of a Dask cluster.")
def batches(workers: int, quick: bool) -> None:
    """Batches over two decades of pairs on a Dask cluster, and what 10^9 pairs would take."""
    console = Console(width=max(WIDTH, Console().width))
    console.print(machine())
    for table in batch_runs.tabulate(workers=workers, quick=quick):
        console.print(table)


@main.command()
@quick_option
@limit_option
@cgal_option
def peers(quick: bool, limit: float, cgal: Path | None) -> None:
    """The same sweeps by CGAL, SFCGAL, shapely, Clipper and KLayout, side by side."""
    found = measure_peers(quick, limit, cgal)
    Console(width=max(WIDTH, Console().width)).print(*tables(found), sep="\n")


@main.command()
@quick_option
@cgal_option
def layouts(quick: bool, cgal: Path | None) -> None:
    """Layouts judged beside CGAL and shapely, and how that grows with their size."""
    console = Console(width=max(WIDTH, Console().width))
    console.print(machine())
    for table in layout_runs.tabulate(cgal, quick=quick):
        console.print(table)


@main.command()
@limit_option
@cgal_option
def fair(limit: float, cgal: Path | None) -> None:
    """Loops by CGAL and by the kernel: kept, made anew, from text; memory, crashes."""
    with TemporaryDirectory() as folder:
        program = Cgal(cgal or compile_program(Path(folder)), limit, fair_runs.SECONDS)
        for table in fair_runs.tabulate(program):
            Console(width=max(WIDE, Console().width)).print(table)


@main.command()
@click.option("-o", "folder", required=True, type=click.Path(file_okay=False, path_type=Path))
@click.option("--redraw", is_flag=True, help="From what is in the folder, without measuring.")
@quick_option
@limit_option
@cgal_option
def report(folder: Path, redraw: bool, quick: bool, limit: float, cgal: Path | None) -> None:
    """Measure everything, and write Markdown and plots into a folder."""
    # matplotlib is needed for nothing else.
    from benchmarks.report import load, save_peers, save_scaling, write

    if not redraw:
        save_scaling(folder, list(scaling_runs.measure_all(quick=quick)))
        save_peers(folder, measure_peers(quick, limit, cgal))
    click.echo(write(folder, *load(folder)))


if __name__ == "__main__":
    main()
