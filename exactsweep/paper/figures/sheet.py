"""Sheets of panels at the size of print, on which shapes are exact and labels keep clear of them.

A panel is a `Picture` without axes. Its shapes come from exact points; its labels are so many
points away from where they belong. All panels of a sheet are drawn at one scale.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import ExitStack
from dataclasses import replace
from fractions import Fraction
from itertools import chain
from typing import TYPE_CHECKING, Any, NamedTuple, Self

from exactsweep.canvas import style
from exactsweep.canvas.style import Look
from exactsweep.draw import Picture, Scale, place_generatrix
from exactsweep.draw.figure import require_matplotlib
from exactsweep.numbers.point import Point, Vertex

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from exactsweep.sweep import Sweep

# A column and a page of the journal are 84 and 174 mm wide, saving adds 0.1 inches on each side,
# and WIDE lies between.
COLUMN, WIDE, PAGE = 3.1, 4.6, 6.6
FONT, SMALL = 9.0, 8.0
_GAP = 10.0
_POINTS = 72.0

PLACED = replace(style.GENERATRIX, width=1.0)
TRAJECTORY = replace(style.TRAJECTORY, width=1.0)
INNER = replace(style.INNER, width=1.8)
OUTER = replace(style.OUTER, width=1.2)
"""As in other pictures, thinner: these are smaller."""

DOT = Look(style.BLACK, 0, dash="none", marker="o", order=9)
SMALL_DOT = Look(style.BLACK, 0, dash="none", marker=".", order=9)
HOLLOW = Look(style.BLACK, 0, dash="none", marker="o", hollow=True, order=9)
GHOST = Look(style.BLUE, 0.7, dash=(0, (3, 2)), fill="#56b4e920", order=3.5)
THIN = Look(style.GREY, 0.8, order=2)
BOLD = Look(style.BLACK, 2.8, order=6)


class Margins(NamedTuple):
    """Room for labels around the shapes of a panel, in points."""

    left: float = 4
    bottom: float = 4
    right: float = 4
    top: float = 4


class Extent(NamedTuple):
    """The frame of a panel: an exact rectangle, with room around it and a title below.

    Shapes that reach beyond it are drawn in full, unless `is_cut`.
    """

    low: Vertex
    high: Vertex
    title: str = ""
    margins: Margins = Margins()
    is_cut: bool = False

    @classmethod
    def around(
        cls, *shapes: Iterable[Vertex], title: str = "", margins: Margins | None = None
    ) -> Self:
        """The bounding box of some points."""
        xs, ys = zip(*chain.from_iterable(shapes), strict=True)
        return cls((min(xs), min(ys)), (max(xs), max(ys)), title, margins or Margins())

    @property
    def size(self) -> tuple[float, float]:
        """Width and height, in units of the plane."""
        return tuple(float(high - low) for low, high in zip(self.low, self.high, strict=True))  # type: ignore[return-value]


class BarePicture(Picture):
    """A picture without axes, with labels and arrows."""

    def label(
        self,
        at: Vertex,
        words: str,
        dx: float = 0,
        dy: float = 0,
        *,
        ha: str = "center",
        va: str = "center",
        leader: bool = False,
        size: float = FONT,
    ) -> None:
        """Write words some points away from a point, with a thin line to it if `leader`."""
        from matplotlib.patheffects import withStroke

        line = {"arrowstyle": "-", "linewidth": 0.6, "shrinkA": 1, "shrinkB": 0, "color": "black"}
        text = self.axes.annotate(
            words,
            self.scale.place(at),
            (dx, dy),
            textcoords="offset points",
            ha=ha,
            va=va,
            fontsize=size,
            zorder=12,
            arrowprops=line if leader else None,
            annotation_clip=False,
        )
        text.set_path_effects([withStroke(linewidth=2.2, foreground="white")])

    def arrow(
        self, start: Vertex, end: Vertex, look: Look = style.TRAJECTORY, *, both: bool = False
    ) -> None:
        """Draw an arrow, with two heads if `both`."""
        self.axes.annotate(
            "",
            self.scale.place(end),
            self.scale.place(start),
            arrowprops={
                "arrowstyle": "<|-|>" if both else "-|>",
                "mutation_scale": 7,
                "linewidth": 0.9,
                "shrinkA": 0,
                "shrinkB": 0,
                "color": look.color,
                "linestyle": look.dash,
            },
            zorder=10,
            annotation_clip=False,
        )

    def generatrix(self, s: Sweep, positions: Iterable[Point]) -> None:
        """Draw G with its reference point at each of some positions, and that point."""
        for position in positions:
            self.area(place_generatrix(s, position).vertices, PLACED)
            self.dots([position])

    def dots(self, points: Iterable[Vertex], look: Look = DOT) -> None:
        """Mark points."""
        self.lines([[point] for point in points], look)


class Sheet(ExitStack):
    """A figure of panels; everything is drawn inside its `with` block, which sets the style.

    Args:
        rows: the boxes of the panels, row by row.
        width: of the sheet, in inches.

    Attributes:
        figure: a Figure of matplotlib.
        panels: a BarePicture for each box, in order.
        unit: the length of the plane's unit, in points.
    """

    def __init__(self, rows: Sequence[Sequence[Extent]], width: float) -> None:
        super().__init__()
        self.rows = rows
        self.width = width
        self.panels: list[BarePicture] = []

    def __enter__(self) -> Self:
        require_matplotlib()
        from matplotlib.figure import Figure

        self.enter_context(style.use_style())
        across = self.width * _POINTS
        self.unit = min(map(self._unit_of, self.rows))
        heights = [max(self._outside(box)[1] for box in row) for row in self.rows]
        total = sum(heights) + _GAP * (len(self.rows) - 1)
        self.figure: Figure = Figure(figsize=(self.width, total / _POINTS))
        top = total
        for row, height in zip(self.rows, heights, strict=True):
            widths = [self._outside(box)[0] for box in row]
            gap = (across - sum(widths)) / (len(row) + 1)
            left = gap
            for box, wide in zip(row, widths, strict=True):
                self._add(box, left, top - height, across, total)
                left += wide + gap
            top -= height + _GAP
        return self

    def __exit__(self, *exception: Any) -> bool | None:
        boxes = chain.from_iterable(self.rows)
        for box, panel in zip(boxes, self.panels, strict=True):
            for artist in panel.axes.get_children():
                artist.set_clip_on(box.is_cut)
        return super().__exit__(*exception)

    def _unit_of(self, row: Sequence[Extent]) -> float:
        used = sum(box.margins.left + box.margins.right for box in row) + _GAP * (len(row) - 1)
        return (self.width * _POINTS - used) / sum(box.size[0] for box in row)

    def _outside(self, box: Extent) -> tuple[float, float]:
        """Width and height of a panel with its margins and title, in points."""
        (wide, high), (left, bottom, right, top) = box.size, box.margins
        lines = len(box.title.split("\n")) if box.title else 0
        return wide * self.unit + left + right, high * self.unit + bottom + top + 12 * lines

    def _add(self, box: Extent, left: float, low: float, across: float, total: float) -> None:
        (wide, high), lines = box.size, box.title.count("\n") + 1 if box.title else 0
        x, y = left + box.margins.left, low + box.margins.bottom + 12 * lines
        axes = self.figure.add_axes(
            (x / across, y / total, wide * self.unit / across, high * self.unit / total)
        )
        panel = BarePicture(axes, Scale.of([box.low, box.high]))
        axes.set_axis_off()
        (x0, y0), (x1, y1) = panel.scale.places([box.low, box.high])
        axes.set_xlim(x0, x1)
        axes.set_ylim(y0, y1)
        if box.title:
            middle = (left + self._outside(box)[0] / 2) / across
            self.figure.text(
                middle, low / total, box.title, ha="center", va="bottom", fontsize=FONT
            )
        self.panels.append(panel)


def find_middle(p: Vertex, q: Vertex, *, share: Fraction = Fraction(1, 2)) -> Vertex:
    """A point of the segment p q, the middle unless another share is named.

    >>> find_middle((0, 0), (2, 4)) == (1, 2)
    True
    """
    return p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])


def find_half_way(p: Point, q: Point) -> Point:
    """The middle of two positions.

    >>> find_half_way(Point(Fraction(0), Fraction(0)), Point(Fraction(2), Fraction(4))) == (1, 2)
    True
    """
    return Point((p.x + q.x) / 2, (p.y + q.y) / 2)


def shift(points: Iterable[Vertex], by: Vertex) -> list[Vertex]:
    """Points moved by a vector.

    >>> shift([(0, 0)], (1, 2))
    [(1, 2)]
    """
    return [(x + by[0], y + by[1]) for x, y in points]
