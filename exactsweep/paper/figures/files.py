"""Files of figures, for the report."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from exactsweep.draw import save
from exactsweep.paper import plots
from exactsweep.paper.claim import Row
from exactsweep.paper.figures import FIGURES

SUFFIXES = (".svg", ".pdf")


def write_figures(folder: Path, rows: Sequence[Row]) -> dict[str, bytes]:
    """Draw the figures that are among some rows into a folder, as figure-1.svg and figure-1.pdf.

    A figure whose evidence fails is not drawn, nor is any without matplotlib.

    Returns:
        The SVG of each figure that is drawn, by the name of its row.

    Raises:
        OSError: a file cannot be written.
    """
    if not plots.available():
        return {}
    holding = {row.claim.name for row in rows if not row.disagreement}
    drawn = {}
    for figure in FIGURES:
        if figure.name in holding:
            picture = figure.draw()
            for suffix in SUFFIXES:
                save(picture, str(folder / f"figure-{figure.number}{suffix}"))
            drawn[figure.name] = (folder / f"figure-{figure.number}.svg").read_bytes()
    return drawn
