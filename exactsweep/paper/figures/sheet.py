"""Sheets of panels at print size, all drawn at one scale."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple, Self

from exactsweep.draw import Picture, Scale
from exactsweep.draw.figure import require_matplotlib
from exactsweep.numbers.number import Vertex

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# A column of the journal is 3.3 inches wide, a page 6.8 inches. Figures are 0.2 inches narrower,
# since saving adds a margin of 0.1 inches on each side.
FONT = 9.0
_GAP = 10.0
_POINTS = 72.0


class Extent(NamedTuple):
    """The frame of a panel: an exact rectangle from `low` to `high`, a title, and margins.

    The margins, in points, leave room for labels on the left, below, on the right and above.
    """

    low: Vertex
    high: Vertex
    title: str = ""
    margins: Sequence[float] = (4, 4, 4, 4)

    @classmethod
    def around(cls, points: Iterable[Vertex], title: str, margins: Sequence[float]) -> Self:
        """Return the bounding box of points as an extent."""
        xs, ys = zip(*points, strict=True)
        return cls((min(xs), min(ys)), (max(xs), max(ys)), title, margins)

    @property
    def title_height(self) -> int:
        return 12 if self.title else 0

    def measure(self, unit: float) -> tuple[float, float]:
        """Return width and height in points at a given scale, including margins and title."""
        left, bottom, right, top = self.margins
        wide, high = (float(high - low) for low, high in zip(self.low, self.high, strict=True))
        return wide * unit + left + right, high * unit + bottom + top + self.title_height


def _find_unit(row: Sequence[Extent], across: float) -> float:
    used = sum(box.measure(0)[0] for box in row) + _GAP * (len(row) - 1)
    return (across - used) / sum(float(box.high[0] - box.low[0]) for box in row)


def lay_out(rows: Sequence[Sequence[Extent]], inches: float) -> tuple[Figure, list[Picture]]:
    """Make a figure of panels without axes, at the largest scale at which all rows fit.

    Returns the matplotlib figure and a Picture for each frame; raises DrawError if matplotlib is
    missing.
    """
    require_matplotlib()
    from matplotlib.figure import Figure

    across = inches * _POINTS
    unit = min(_find_unit(row, across) for row in rows)
    heights = [max(box.measure(unit)[1] for box in row) for row in rows]
    total = sum(heights) + _GAP * (len(rows) - 1)
    figure = Figure(figsize=(inches, total / _POINTS))
    low, pictures = total + _GAP, []
    for row, height in zip(rows, heights, strict=True):
        low -= height + _GAP
        for box, left in zip(row, _spread(row, unit, across), strict=True):
            wide, high = box.measure(unit)
            room = box.margins[0], box.margins[1] + box.title_height
            size = wide - box.margins[0] - box.margins[2], high - room[1] - box.margins[3]
            place = (left + room[0]) / across, (low + room[1]) / total
            axes = figure.add_axes((*place, size[0] / across, size[1] / total))
            pictures.append(Picture(axes, Scale.of([box.low, box.high])))
            axes.set_axis_off()
            xs, ys = zip(*pictures[-1].scale.places([box.low, box.high]), strict=True)
            axes.set(xlim=xs, ylim=ys)
            middle = (left + wide / 2) / across
            figure.text(middle, low / total, box.title, ha="center", va="bottom", fontsize=FONT)
    return figure, pictures


def _spread(row: Sequence[Extent], unit: float, across: float) -> Iterator[float]:
    """Yield the left ends of the panels in a row, with equal gaps."""
    widths = [box.measure(unit)[0] for box in row]
    gap = (across - sum(widths)) / (len(row) + 1)
    left = gap
    for wide in widths:
        yield left
        left += wide + gap
