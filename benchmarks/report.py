"""The report: Markdown with the tables, and plots, in one folder."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

from benchmarks import plots
from benchmarks.growth import Point, Series
from benchmarks.peers.measured import Comparison
from benchmarks.peers.tables import TIMES, sections
from benchmarks.scaling import summary

SCALING, PEERS = "scaling.json", "peers.json"


def save_scaling(folder: Path, measured: Sequence[Series]) -> None:
    """Keep the growth as JSON, so that the report can be written again."""
    folder.mkdir(parents=True, exist_ok=True)
    series = [asdict(one) for one in measured]
    (folder / SCALING).write_text(json.dumps(series, indent=1), encoding="utf-8")


def save_peers(folder: Path, found: Comparison) -> None:
    """Keep the comparison, likewise."""
    (folder / PEERS).write_text(json.dumps(found.to_json(), indent=1), encoding="utf-8")


def load(folder: Path) -> tuple[list[Series], Comparison]:
    """Read what was kept."""
    measured = [
        Series(**{**one, "points": [Point(**point) for point in one["points"]]})
        for one in json.loads((folder / SCALING).read_text(encoding="utf-8"))
    ]
    return measured, Comparison.from_json(json.loads((folder / PEERS).read_text(encoding="utf-8")))


def write(folder: Path, measured: Sequence[Series], found: Comparison) -> Path:
    """Write report.md and its plots, as SVG and PNG.

    Returns the path of report.md.
    """
    plots.growth(measured, lambda p: p.operations, "operations", folder / "operations")
    plots.growth(measured, lambda p: p.output, "vertices out", folder / "output")
    plots.growth(measured, lambda p: p.milliseconds, "ms", folder / "time")
    plots.programs(found, folder / "programs")
    lines = ["# Benchmarks", "", f"{found.machine}.", ""]
    lines += [f"Programs: {', '.join(found.versions.values())}.", ""]
    lines += [f"Skipped: {name}, {reason}.\n" for name, reason in found.skipped.items()]
    lines += ["## Growth", "", GROWTH, "", *markdown(*summary(measured)), ""]
    for name, caption in FIGURES.items():
        lines += [f"![{caption}]({name}.svg)", "", caption, ""]
    lines += ["## Other programs", "", TIMES, ""]
    for title, header, rows in sections(found):
        lines += [f"### {title[0].upper()}{title[1:]}", "", *markdown(header, rows), ""]
    lines += ["![Time of the trajectory](programs.svg)", "", PROGRAMS, ""]
    path = folder / "report.md"
    path.write_text("\n".join(lines), encoding="utf-8")
    return path


GROWTH = (
    "Exponents of the least squares line through the logarithms, over five doublings. `paper` is "
    "that of the claimed bound over the same sizes, logarithms included. Operations are "
    "multiplications and comparisons of coordinates and vertices out, the same on every run. The "
    "bound is confirmed where the operations stay or fall in proportion to it; the last column "
    "says by what factor that proportion grew over the last two doublings."
)
FIGURES = {
    "operations": "Counted operations; dashed, the claimed bound through the largest size.",
    "output": "Vertices that come out; dashed, the claimed bound through the largest size.",
    "time": "Time; dashed, the claimed bound through the largest size.",
}
PROGRAMS = "Median time of the trajectory, and the range from the least to the greatest."


def markdown(header: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """A table in Markdown.

    >>> markdown(["a", "b"], [["1", "2"]])
    ['| a | b |', '|---|---|', '| 1 | 2 |']
    """
    lines = [header, *rows]
    texts = [f"| {' | '.join(cell.replace('|', '/') for cell in line)} |" for line in lines]
    return [texts[0], f"|{'---|' * len(header)}", *texts[1:]]
