"""Plots of counts divided by the claimed bounds, drawn with matplotlib."""

from collections.abc import Sequence
from importlib.util import find_spec
from io import BytesIO
from itertools import cycle

from exactsweep.canvas.style import PALETTE
from exactsweep.paper.growth import Growth
from exactsweep.paper.toml import read_toml

STYLES = tuple(
    (color, marker, dash)
    for dash in ("-", "--")
    for color, marker in zip(PALETTE, "os^Dv<>", strict=True)
)
SETTINGS = read_toml("plots.toml")


def available() -> bool:
    return find_spec("matplotlib") is not None


def ratios(growth: Sequence[Growth]) -> bytes:
    """Plot ratios of counts and bounds by size as SVG, with one line per series."""
    from matplotlib.figure import Figure
    from matplotlib.style import context
    from matplotlib.ticker import NullFormatter, NullLocator

    with context(SETTINGS):
        figure = Figure(figsize=(4.6, 2.2 + 0.16 * len(growth)), layout="constrained")
        axes = figure.subplots()
        for series, (color, marker, dash) in zip(growth, cycle(STYLES), strict=False):
            axes.plot(
                [max(point.m, point.n) for point in series.points],
                [point.ratio for point in series.points],
                color=color,
                marker=marker,
                linestyle=dash,
                label=f"{series.what}, {series.family}, {series.varied}, / ({series.bound})",
            )
        sizes = sorted({max(point.m, point.n) for series in growth for point in series.points})
        axes.set_xscale("log")
        axes.set_xticks(sizes, [str(size) for size in sizes])
        axes.xaxis.set_minor_locator(NullLocator())
        axes.xaxis.set_minor_formatter(NullFormatter())
        axes.set_ylim(0, 1.1 * max(p.ratio for series in growth for p in series.points))
        axes.set_xlabel("the greater of m and n")
        axes.set_ylabel("count / bound")
        figure.legend(loc="outside lower left", frameon=False)
        out = BytesIO()
        figure.savefig(out, format="svg", metadata={"Date": None})
    return out.getvalue()
