"""The report: Markdown with the tables, and plots, in one folder."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

from benchmarks import plots
from benchmarks.peers.measured import Comparison
from benchmarks.peers.tables import TIMES, sections
from exactsweep.paper.costs import UNITS, tabulate
from exactsweep.paper.growth import Growth, Size

SCALING, PEERS = "scaling.json", "peers.json"


def save_scaling(folder: Path, measured: Sequence[Growth]) -> None:
    """Keep the growth as JSON, so that the report can be written again."""
    folder.mkdir(parents=True, exist_ok=True)
    series = [asdict(one) for one in measured]
    (folder / SCALING).write_text(json.dumps(series, indent=1), encoding="utf-8")


def save_peers(folder: Path, found: Comparison) -> None:
    """Keep the comparison, likewise."""
    (folder / PEERS).write_text(json.dumps(found.to_json(), indent=1), encoding="utf-8")


def load(folder: Path) -> tuple[list[Growth], Comparison]:
    """Read what was kept."""
    measured = [
        Growth(**{**one, "points": tuple(Size(**point) for point in one["points"])})
        for one in json.loads((folder / SCALING).read_text(encoding="utf-8"))
    ]
    return measured, Comparison.from_json(json.loads((folder / PEERS).read_text(encoding="utf-8")))


def write(folder: Path, measured: Sequence[Growth], found: Comparison) -> Path:
    """Write report.md and its plots, as SVG and PNG.

    Returns the path of report.md.
    """
    for unit in UNITS:
        chosen = [series for series in measured if series.unit == unit]
        if chosen:
            plots.growth(chosen, unit, folder / unit)
    plots.programs(found, folder / "programs")
    lines = ["# Benchmarks", "", f"{found.machine}.", ""]
    lines += [f"Programs: {', '.join(found.versions.values())}.", ""]
    lines += [f"Skipped: {name}, {reason}.\n" for name, reason in found.skipped.items()]
    lines += ["## Growth", "", GROWTH, "", *markdown(*tabulate(measured)[1:]), ""]
    for unit in dict.fromkeys(series.unit for series in measured):
        lines += [f"![{unit}]({unit}.svg)", "", f"{unit.capitalize()}{FIGURES}", ""]
    lines += ["## Other programs", "", TIMES, ""]
    for title, header, rows in sections(found):
        lines += [f"### {title[0].upper()}{title[1:]}", "", *markdown(header, rows), ""]
    lines += ["![Time of the trajectory](programs.svg)", "", PROGRAMS, ""]
    path = folder / "report.md"
    path.write_text("\n".join(lines), encoding="utf-8")
    return path


GROWTH = (
    "Exponents of the least squares line through the logarithms; those of seconds over the three "
    "largest sizes. That of the bound is over the same sizes, logarithms included. Operations are "
    "multiplications and comparisons of coordinates and vertices out, the same on every run; bytes "
    "are the peak beside the input."
)
FIGURES = "; dashed, the claimed bound through the largest size."
PROGRAMS = "Median time of the trajectory, and the range from the least to the greatest."


def markdown(header: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """A table in Markdown.

    >>> markdown(["a", "b"], [["1", "2"]])
    ['| a | b |', '|---|---|', '| 1 | 2 |']
    """
    lines = [header, *rows]
    texts = [f"| {' | '.join(cell.replace('|', '/') for cell in line)} |" for line in lines]
    return [texts[0], f"|{'---|' * len(header)}", *texts[1:]]
