"""Drawing of figures by the instructions in `drawings.toml`, all panels at one scale.

An instruction is a method of `PanelDrawer` with its arguments. A shape is a literal point or chain,
or a name: "outer", "outer.3" for its vertex 3, "outer/3" for the midpoint of its edge 3. The shape
"a_name" overrides "name" in panel a. "=name" stands for computed words. A look is an entry of
`looks`, or a name of the style.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import chain, pairwise, repeat
from typing import TYPE_CHECKING, Any

from exactsweep.canvas import style
from exactsweep.canvas.style import Look
from exactsweep.draw import Picture
from exactsweep.numbers.number import Vertex
from exactsweep.paper import read_toml
from exactsweep.paper.figures.figure import PaperFigure, find_middle

if TYPE_CHECKING:
    from matplotlib.figure import Figure
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, NamedTuple, Self

from exactsweep.draw import Scale
from exactsweep.draw.figure import require_matplotlib

SMALL = 8.0
_LEADER = {"arrowstyle": "-", "linewidth": 0.6, "shrinkA": 1, "shrinkB": 0, "color": "black"}
_ARROW = {"mutation_scale": 7, "linewidth": 0.9, "shrinkA": 0, "shrinkB": 0}


@cache
def _load() -> dict[str, Any]:
    return read_toml("figures/drawings.toml")


def find_look(name: str) -> Look:
    if name not in _load()["looks"]:
        found: Look = getattr(style, name)
        return found
    changes = dict(_load()["looks"][name])
    like = find_look(changes.pop("like")) if "like" in changes else Look(style.BLACK)
    for part in changes.keys() & {"color", "fill"}:
        name, _, opacity = changes[part].partition(" ")
        changes[part] = getattr(style, name, name) + opacity
    if isinstance(changes.get("dash"), list):
        changes["dash"] = (0, tuple(changes["dash"]))
    return replace(like, **changes)


def draw_figure(name: str, figure: PaperFigure) -> Figure:
    plan = _load()[name]
    panels = [
        PanelDrawer(
            entry.get("letter", letter), figure, [*plan.get("each", ()), *entry.get("draw", ())]
        )
        for letter, entry in zip("abcd", plan["panel"], strict=False)
    ]
    boxes = map(PanelDrawer.frame, panels, plan["panel"])
    rows = [[next(boxes) for _ in range(count)] for count in plan["rows"]]
    with style.use_style():
        made, pictures = lay_out(rows, plan["inches"])
        for panel, entry, picture in zip(panels, plan["panel"], pictures, strict=True):
            panel.draw(picture)
            for artist in picture.axes.get_children():
                artist.set_clip_on(entry.get("cut", False))
    return made


class PanelDrawer:
    """A panel of a figure. Its public methods are the instructions."""

    picture: Picture

    def __init__(
        self, letter: str, figure: PaperFigure, instructions: Sequence[Sequence[Any]]
    ) -> None:
        self.letter = letter
        self.shapes = figure.list_shapes()
        self.words = figure.words
        self.instructions = instructions

    def frame(self, entry: Mapping[str, Any]) -> Extent:
        points = chain.from_iterable(map(self._points, entry["around"]))
        (title,) = self._words(entry.get("title", ""))
        return Extent.around(points, title, entry.get("margins", (4, 4, 4, 4)))

    def draw(self, picture: Picture) -> None:
        self.picture = picture
        for kind, *arguments in self.instructions:
            getattr(self, kind)(*arguments)

    def area(self, what: Any, look: str) -> None:
        for loop in self._chains(what):
            self.picture.area(loop, find_look(look))

    def ring(self, outer: Any, inner: Any, look: str) -> None:
        self.picture.ring(self._find(outer), self._find(inner), find_look(look))

    def line(self, what: Any, look: str) -> None:
        for points in self._chains(what):
            self.picture.line(points, find_look(look))

    def loop(self, what: Any, look: str) -> None:
        for points in self._chains(what):
            self.picture.line(points, find_look(look), closed=True)

    def dots(self, what: Any, look: str = "DOT") -> None:
        self.picture.lines([[point] for point in self._points(what)], find_look(look))

    def arrow(self, what: Any, look: str = "TRAJECTORY", head: str = "-|>") -> None:
        color, dash = find_look(look).color, find_look(look).dash
        for ends in self._chains(what):
            start, end = self.picture.scale.places(ends)
            self.picture.axes.annotate(
                "",
                end,
                start,
                arrowprops={**_ARROW, "arrowstyle": head, "color": color, "linestyle": dash},
                zorder=10,
                annotation_clip=False,
            )

    def label(
        self,
        at: Any,
        words: str,
        dx: float | str = 0,
        dy: float = 0,
        how: Mapping[str, Any] | None = None,
    ) -> None:
        """Write words next to points, offset by (dx, dy) or by the vectors of the shape `dx`.

        `how` sets the alignments "ha" and "va", "leader" for a line to the point, and "small".
        """
        from matplotlib.patheffects import withStroke

        how = how or {}
        texts = self._words(words) if words.startswith("=") else repeat(words)
        moves = self._points(dx) if isinstance(dx, str) else repeat((dx, dy))
        for place, text, (right, up) in zip(self._points(at), texts, moves, strict=False):
            written = self.picture.axes.annotate(
                text,
                self.picture.scale.place(place),
                (float(right), float(up)),
                textcoords="offset points",
                ha=how.get("ha", "center"),
                va=how.get("va", "center"),
                fontsize=SMALL if how.get("small") else FONT,
                zorder=12,
                arrowprops=_LEADER if how.get("leader") else None,
                annotation_clip=False,
            )
            written.set_path_effects([withStroke(linewidth=2.2, foreground="white")])

    def _words(self, words: str) -> Sequence[str]:
        return self._named(self.words, words[1:]) if words.startswith("=") else [words]

    def _find(self, what: Any) -> Any:
        if isinstance(what, list):
            is_chain = any(isinstance(one, list) or str(one)[0].isalpha() for one in what)
            return [self._find(one) for one in what] if is_chain else tuple(map(Fraction, what))
        path, _, edge = what.partition("/")
        name, *numbers = path.split(".")
        found = self._named(self.shapes, name)
        for number in numbers:
            found = found[int(number)]
        return find_middle(*list(pairwise(found))[int(edge)]) if edge else found

    def _named(self, values: Mapping[str, Sequence[Any]], name: str) -> Any:
        own = f"{self.letter}_{name}"
        return values[own if own in values else name]

    def _chains(self, what: Any) -> Sequence[Sequence[Vertex]]:
        found = self._find(what)
        if found and not isinstance(found[0], (tuple, list)):
            return [[found]]
        return [found] if found and not isinstance(found[0][0], (tuple, list)) else found

    def _points(self, what: Any) -> list[Vertex]:
        return list(chain.from_iterable(self._chains(what)))


# A column of the journal is 3.3 inches wide, a page 6.8 inches. Figures are 0.2 inches narrower,
# since saving adds a margin of 0.1 inches on each side.
FONT = 9.0
_GAP = 10.0
_POINTS = 72.0


class Extent(NamedTuple):
    """A panel's rectangle and title, and the margins left, below, right and above, in points."""

    low: Vertex
    high: Vertex
    title: str = ""
    margins: Sequence[float] = (4, 4, 4, 4)

    @classmethod
    def around(cls, points: Iterable[Vertex], title: str, margins: Sequence[float]) -> Self:
        xs, ys = zip(*points, strict=True)
        return cls((min(xs), min(ys)), (max(xs), max(ys)), title, margins)

    @property
    def title_height(self) -> int:
        return 12 if self.title else 0

    def measure(self, unit: float) -> tuple[float, float]:
        left, bottom, right, top = self.margins
        wide, high = (float(high - low) for low, high in zip(self.low, self.high, strict=True))
        return wide * unit + left + right, high * unit + bottom + top + self.title_height


def _find_unit(row: Sequence[Extent], across: float) -> float:
    used = sum(box.measure(0)[0] for box in row) + _GAP * (len(row) - 1)
    return (across - used) / sum(float(box.high[0] - box.low[0]) for box in row)


def lay_out(rows: Sequence[Sequence[Extent]], inches: float) -> tuple[Figure, list[Picture]]:
    """Make a figure and a Picture for each panel, at the largest common scale at which all fit."""
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
    widths = [box.measure(unit)[0] for box in row]
    gap = (across - sum(widths)) / (len(row) + 1)
    left = gap
    for wide in widths:
        yield left
        left += wide + gap
