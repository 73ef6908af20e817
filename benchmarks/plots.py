"""Log-log plots: comparisons of programs, and hard shapes by size."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import cycle
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure
from matplotlib.style import context
from matplotlib.ticker import NullLocator

from benchmarks.growth import Grown
from benchmarks.peers.run import Comparison
from exactsweep.paper.report import SETTINGS, STYLES

# Panels are smaller than the plots of the ledger.
SMALLER: dict[str, Any] = {
    **SETTINGS,
    "axes.titlesize": 8,
    "legend.fontsize": 6.5,
    "xtick.labelsize": 6.5,
    "ytick.labelsize": 6.5,
    "svg.hashsalt": "benchmarks",
}
COLUMNS = 3
DPI = 300


def programs(found: Comparison, path: Path) -> None:
    """Plot the time of every program on pairs with m = n, one panel per family."""
    measured = [(r, r.times) for r in found.results if r.m == r.n and r.times]
    families = list(dict.fromkeys(r.family for r, _ in measured))
    with context(SMALLER):
        figure, panels = _panels(len(families))
        for panel, family in zip(panels, families, strict=False):
            for name, (color, marker, dash) in zip(found.versions, cycle(STYLES), strict=False):
                chosen = [(r.m, t) for r, t in measured if (r.program, r.family) == (name, family)]
                panel.errorbar(
                    [m for m, _ in chosen],
                    [t.median for _, t in chosen],
                    [
                        [t.median - t.least for _, t in chosen],
                        [t.greatest - t.median for _, t in chosen],
                    ],
                    color=color,
                    marker=marker,
                    linestyle=dash,
                    elinewidth=0.6,
                    label=name,
                )
            panel.set_title(f"trajectory, {family}")
            _axes(panel, sorted({r.m for r, _ in measured if r.family == family}))
        figure.legend(
            *panels[0].get_legend_handles_labels(),
            loc="outside lower center",
            ncols=len(found.versions),
            frameon=False,
        )
        _finish(figure, panels, "m = n", "ms", path)


def shapes(measured: Sequence[Grown], path: Path) -> None:
    """Plot seconds and memory of hard shapes by size, in two panels."""
    with context(SMALLER):
        figure, panels = _panels(2, columns=2)
        figure.set_figheight(4)
        for k, (panel, title) in enumerate(zip(panels, ("seconds", "MB"), strict=True)):
            for grown, (color, marker, dash) in zip(measured, cycle(STYLES), strict=False):
                label = f"{grown.case.what}: {', '.join(f'{slope:.1f}' for slope in grown.slopes)}"
                values = (grown.seconds, grown.memory)[k]
                style = {"color": color, "marker": marker, "linestyle": dash}
                panel.plot(grown.sizes, values, label=label, **style)
            panel.set_title(title)
            _axes(panel, sorted({size for grown in measured for size in grown.sizes}))
        figure.legend(
            *panels[0].get_legend_handles_labels(),
            loc="outside lower center",
            ncols=2,
            frameon=False,
            title="slopes over the three largest sizes: seconds, MB",
        )
        _finish(figure, panels, "n", "", path)


def _axes(panel: Any, sizes: Sequence[int]) -> None:
    """Set both axes to log scale, with x ticks at up to six sizes."""
    panel.set_xscale("log")
    panel.set_yscale("log")
    shown = sizes[:: 1 + (len(sizes) - 1) // 6]
    panel.set_xticks(shown, [str(size) for size in shown])
    panel.xaxis.set_minor_locator(NullLocator())


def _panels(count: int, columns: int = COLUMNS) -> tuple[Any, list[Any]]:
    rows = -(-count // columns)
    figure = Figure(figsize=(7.2, 2.3 * rows), layout="constrained")
    grid = figure.subplots(rows, columns, squeeze=False)
    panels = list(grid.flat)
    for panel in panels[count:]:
        panel.remove()
    return figure, panels[:count]


def _finish(figure: Any, panels: Iterable[Any], x: str, y: str, path: Path) -> None:
    for panel in panels:
        panel.set_xlabel(x)
        panel.set_ylabel(y)
    figure.savefig(path.with_suffix(".svg"), metadata={"Date": None})
    figure.savefig(path.with_suffix(".png"), dpi=DPI)
